"""What the texts of a robot say, read apart from the linter: elements, names in them, and which files belong together."""
import os
import pathlib
import re

DIRECTIVES = {'if', 'unless', 'property', 'include', 'macro', 'arg', 'insert_block', 'call', 'element', 'attribute'}
CONDITIONS = ('xacro:if', 'xacro:unless')
WORDS = {'and', 'or', 'not', 'if', 'else', 'for', 'in', 'is', 'lambda', 'True', 'False', 'None', 'xacro', 'true', 'false'}
TAG = re.compile(r'<(/?)([A-Za-z_][\w:.\-]*)((?:"[^"]*"|\'[^\']*\'|[^<>"\'])*?)(/?)>')
ATTRIBUTE = re.compile(r'([\w:.\-]+)\s*=\s*(?:"([^"]*)"|\'([^\']*)\')')
SUBSTITUTION = re.compile(r'\$\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}|\$\((\w+)([^()]*)\)')
IDENTIFIER = re.compile(r'"[^"]*"|\'[^\']*\'|&\w+;|(?<![\w.])([A-Za-z_]\w*)(?!\w)')
PARAMETER = re.compile(r'(\*{0,2})([\w.\-]+)(\s*:?=\s*(?:\^\|?)?(?:\'[^\']*\'|"[^"]*"|\$\{[^}]*\}|\$\([^)]*\)|[^\s\'"])*)?')


class Element:
    """An element: its tag, its attributes as (start, end) of their values, and its text from `start` to `end`."""

    def __init__(self, name, start, inner, attributes, parent):
        self.name, self.start, self.inner, self.attributes, self.parent = name, start, inner, attributes, parent
        self.end = self.inner_end = inner

    def around(self):
        """The elements around this one, innermost first."""
        found, element = [], self.parent
        while element:
            found.append(element)
            element = element.parent
        return found


class Text:
    def __init__(self, path, text=None):
        self.path = path
        self.text = pathlib.Path(path).read_bytes().decode('utf-8') if text is None else text
        blank = re.compile(r'<!--.*?-->|<!\[CDATA\[.*?\]\]>|<\?.*?\?>', re.S)
        self.clean = blank.sub(lambda m: ' ' * len(m[0]), self.text)
        self.elements = list(self.read())
        self.conditions = [e for e in self.elements if e.name in CONDITIONS and 'value' in e.attributes]

    def read(self):
        open_ = []
        for tag in TAG.finditer(self.clean):
            if tag[1]:
                for depth in range(len(open_) - 1, -1, -1):
                    if open_[depth].name == tag[2]:
                        for element in open_[depth:]:
                            element.inner_end, element.end = tag.start(), tag.end()
                        del open_[depth:]
                        break
                continue
            attributes = {}
            for m in ATTRIBUTE.finditer(tag[3]):
                group = 2 if m[2] is not None else 3
                attributes[m[1]] = (tag.start(3) + m.start(group), tag.start(3) + m.end(group))
            element = Element(tag[2], tag.start(), tag.end(), attributes, open_[-1] if open_ else None)
            element.names = {m[1]: (tag.start(3) + m.start(1), tag.start(3) + m.end(1)) for m in ATTRIBUTE.finditer(tag[3])}
            element.own_end = bool(tag[4])
            if not tag[4]:
                open_.append(element)
            yield element

    def value(self, element, attribute):
        span = element.attributes.get(attribute)
        return None if span is None else self.text[span[0]:span[1]]

    def parameters(self, element):
        """The parameters of a macro: (stars, name, start, end of the name, whether it has a default)."""
        span = element.attributes.get('params')
        if not span:
            return []
        found = PARAMETER.finditer(self.text, *span)
        return [(m[1], m[2], m.start(2), m.end(2), bool(m[3])) for m in found]

    def position(self, offset):
        before = self.text[:offset]
        line_start = before.rfind('\n') + 1
        return {'line': before.count('\n'), 'character': len(self.text[line_start:offset].encode('utf-16-le')) // 2}

    def offset(self, position):
        start = 0
        for _ in range(position['line']):
            start = self.text.index('\n', start) + 1
        units, at = position['character'], start
        while units > 0 and at < len(self.text):
            units -= len(self.text[at].encode('utf-16-le')) // 2
            at += 1
        return at

    def line(self, offset):
        return self.text.count('\n', 0, offset) + 1


class Name:
    """A place that uses a name."""

    def __init__(self, kind, name, text, start, element):
        self.kind, self.name, self.text, self.start, self.element = kind, name, text, start, element
        self.end = start + len(name)
        # of an argument: where its substitution, or the expression around it, begins
        self.outer = start

    def __repr__(self):
        return '%s `%s` at %s:%d' % (self.kind, self.name, os.path.basename(self.text.path), self.text.line(self.start))


def arguments(text, start, end, outer, element):
    """The arguments that `$(arg name)` reads between two offsets."""
    for found in re.finditer(r'\$\(arg\s+([\w.\-/]+)\s*\)', text.text[start:end]):
        name = Name('argument', found[1], text, start + found.start(1), element)
        name.outer = outer
        yield name


def values_used(text, element):
    """The names in expressions and the arguments in an element's attributes and text."""
    spans = [span for attribute, span in element.attributes.items()
             if not (element.name == 'xacro:macro' and attribute == 'name')]
    if not element.own_end and '<' not in text.clean[element.inner:element.inner_end]:
        spans.append((element.inner, element.inner_end))
    for start, end in spans:
        for found in SUBSTITUTION.finditer(text.clean, start, end):
            if text.clean[found.start() - 1:found.start()] == '$':
                continue
            if found[2] == 'arg':
                yield from arguments(text, found.start(), found.end(), found.start(), element)
            if found[1] is None:
                continue
            yield from arguments(text, *found.span(1), found.start(), element)
            code, base = found[1], found.start(1)
            loops = ' '.join(re.findall(r'\bfor\s+([\w, ]+?)\s+in\b', code))
            bound = set(re.findall(r'\w+', loops))
            for m in IDENTIFIER.finditer(code):
                if not m[1] or m[1] in WORDS or m[1] in bound or '$(' in code[max(0, m.start() - 12):m.start()]:
                    continue
                behind = code[m.end():].lstrip()
                if behind.startswith('(') or re.match(r'=[^=]', behind):
                    continue
                yield Name('value', m[1], text, base + m.start(1), element)


def uses(text):
    """All places of a text that use a name of xacro, as far as the text says."""
    for element in text.elements:
        yield from values_used(text, element)
        if element.name == 'xacro:insert_block' and 'name' in element.attributes:
            start, end = element.attributes['name']
            if '$' not in text.text[start:end]:
                yield Name('block', text.text[start:end], text, start, element)
        called = element.name[6:] if element.name.startswith('xacro:') else 'if'
        if called not in DIRECTIVES:
            last = called.rsplit('.', 1)[-1]
            yield Name('macro', last, text, element.start + 1 + len(element.name) - len(last), element)
            for attribute, (start, _) in element.names.items():
                if ':' not in attribute:
                    yield Name('parameter', attribute, text, start, element)


class Definition:
    """A place that gives a name, and how to mark what it gives."""

    def __init__(self, kind, name, text, start, element):
        self.kind, self.name, self.text, self.start, self.element = kind, name, text, start, element
        self.end = start + len(name)

    def __repr__(self):
        return '%s `%s` given at %s:%d' % (self.kind, self.name, os.path.basename(self.text.path), self.text.line(self.start))


def definitions(text):
    """All definitions of names in a text: kind is that of the uses which may mean it."""
    for element in text.elements:
        name = text.value(element, 'name')
        if name is not None and '$' not in name and name:
            start = element.attributes['name'][0]
            if element.name == 'xacro:property' and 'remove' not in element.attributes:
                valued = {'value', 'default'} & set(element.attributes)
                yield Definition('value' if valued else 'block', name, text, start, element)
            elif element.name == 'xacro:arg':
                yield Definition('argument', name, text, start, element)
            elif element.name == 'xacro:macro':
                bare = name.removeprefix('xacro:')
                yield Definition('macro', bare, text, start + len(name) - len(bare), element)
        if element.name == 'xacro:macro':
            for stars, given, start, _, _ in text.parameters(element):
                yield Definition('block' if stars else 'value', given, text, start, element)


class Robot:
    """A root file with all files that its includes, taken or not, may read."""

    def __init__(self, folder, main, args=()):
        self.folder, self.main, self.args = str(folder), str(main), list(args)
        self.packages = packages(self.folder)
        self.texts, self.includes = {}, []
        self.read(self.main, 0)

    def read(self, path, depth):
        path = os.path.normpath(path)
        if path in self.texts or depth > 20:
            return
        try:
            text = self.texts[path] = Text(path)
        except (OSError, UnicodeDecodeError):
            self.texts.pop(path, None)
            return
        for element in text.elements:
            filename = element.name == 'xacro:include' and text.value(element, 'filename')
            for found in self.named(filename, path) if filename else ():
                self.includes.append((text, element, found))
                self.read(found, depth + 1)

    def named(self, filename, path):
        """The files that an include may mean; what is computed may be anything."""
        filename = re.sub(r'\$\(find\s+([\w\-]+)\s*\)', lambda m: self.packages.get(m[1], '/none'), filename)
        starts_computed = filename.startswith('$')
        filename = filename if filename.startswith('/') else os.path.join(os.path.dirname(path), filename)
        if '$' not in filename:
            found = os.path.normpath(filename)
            return [found] if os.path.isfile(found) else []
        pattern = ''.join('.*' if part.startswith('$') else re.escape(part) for part in re.split(r'(\$\{[^}]*\}|\$\([^)]*\))', filename))
        known = filename[:filename.index('$')]
        base = known if known.endswith('/') else os.path.dirname(known)
        if base.rstrip('/') == self.folder.rstrip('/') or not base.startswith(self.folder):
            return []
        if starts_computed:
            tail = re.split(r'\$\{[^}]*\}|\$\([^)]*\)', filename)[-1]
            found = [f for f in descriptions(self.folder) if '/' in tail and f.endswith(tail)]
            package = path[len(self.folder):].strip('/').split('/')[0]
            return sorted(found, key=lambda f: (not f.startswith(os.path.join(self.folder, package) + '/'), f))[:8]
        return sorted(f for f in descriptions(self.folder) if f.startswith(base) and re.fullmatch(pattern, f))[:8]


KNOWN_DESCRIPTIONS = {}


def descriptions(folder):
    """The files below a folder that includes may name."""
    if folder not in KNOWN_DESCRIPTIONS:
        files = (os.path.join(d, f) for d, _, names in os.walk(folder) for f in names)
        KNOWN_DESCRIPTIONS[folder] = sorted(f for f in files if f.endswith(('.xacro', '.urdf', '.xml')))
    return KNOWN_DESCRIPTIONS[folder]


KNOWN_PACKAGES = {}


def packages(folder):
    """The packages below a folder, by name."""
    if folder not in KNOWN_PACKAGES:
        found = {}
        for manifest in sorted(pathlib.Path(folder).rglob('package.xml')):
            name = re.search(r'<name>\s*([^<\s]+)', manifest.read_text('utf-8', 'replace'))
            if name:
                found.setdefault(name[1], str(manifest.parent))
        KNOWN_PACKAGES[folder] = found
    return KNOWN_PACKAGES[folder]


def replaced(text, edits):
    """A text with (start, end, new) replaced; what was put in at one place stays in order."""
    parts, at = [], 0
    for start, end, new in sorted(edits, key=lambda edit: edit[:2]):
        if start < at:
            continue
        parts += [text[at:start], new]
        at = end
    return ''.join(parts + [text[at:]])


def forced(condition, taken):
    """The edit that decides a condition."""
    value = taken if condition.name == 'xacro:if' else not taken
    return (*condition.attributes['value'], '1' if value else '0')
