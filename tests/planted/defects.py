"""Where a single defect can be planted in the text of a robot, and what it looks like.

`plan(robot, files, each)` gives defects of a workspace: each changes one place of one file. A kind is a function of a file's text
that yields (start, end, new text); of each kind a few places are taken from a robot.
"""
import collections
import re
import zlib

Defect = collections.namedtuple('Defect', 'kind place file line column start end text')

CORE = {'if', 'unless', 'property', 'macro', 'include', 'insert_block', 'arg', 'call', 'element', 'attribute'}
CALL = re.compile(r'<xacro:([\w.]+)(\s[^<>]*?)?(/?)>')
LIMIT = re.compile(r'lower="([^"]*)"(\s+)upper="([^"]*)"')


def typo(word):
    """A word with two neighbors swapped, or the last letter doubled."""
    for i in range(len(word) // 2, len(word) - 1):
        if word[i] != word[i + 1] and word[i].isalpha() and word[i + 1].isalpha():
            return word[:i] + word[i + 1] + word[i] + word[i + 2:]
    return word + word[-1]


def replaced(pattern, new, group=1):
    """A kind that replaces a group of every match; `new` is a text or a function of the old one (None: leave it)."""
    compiled = re.compile(pattern, re.S)

    def places(text, _known):
        for match in compiled.finditer(text):
            value = new(match.group(group)) if callable(new) else new
            if value is not None and value != match.group(group):
                yield match.start(group), match.end(group), value
    return places


def tail(value):
    """A name with a typo in its literal part; None when the text is an expression alone."""
    found = re.search(r'[A-Za-z_]\w+$', re.sub(r'^.*\}', lambda m: '#' * len(m.group()), value))
    return value[:found.start()] + typo(found.group()) if found else None


def number(change):
    """A function that changes a literal number; None for everything else."""
    def new(value):
        try:
            return change(float(value))
        except ValueError:
            return None
    return new


def properties(text, known):
    """A letter wrong in a name that an expression reads."""
    for expression in re.finditer(r'\$\{([^{}]*)\}', text):
        plain = re.sub(r"'[^']*'", lambda m: ' ' * len(m.group()), expression.group(1))
        for word in re.finditer(r'(?<![\w.])[A-Za-z_]\w+(?![\w(=])', plain):
            if word.group() in known['properties']:
                start = expression.start(1) + word.start()
                yield start, start + len(word.group()), typo(word.group())


def calls(text):
    """Calls of macros."""
    return (m for m in CALL.finditer(text) if m.group(1) not in CORE)


def call_names(text, _known):
    for call in calls(text):
        yield call.start(1), call.end(1), typo(call.group(1))


def unprefixed_calls(text, _known):
    for call in calls(text):
        yield call.start(), call.start(1), '<'


def parameters(change):
    def places(text, _known):
        for call in calls(text):
            for given in re.finditer(r'\s(\w+)="[^"]*"', call.group(2) or ''):
                start, end = call.start(2) + given.start(), call.start(2) + given.end()
                yield start, end, change(given)
    return places


def blocks(text, _known):
    """A call without its block."""
    for call in calls(text):
        if not call.group(3):
            inner = re.match(r'\s*<origin [^<>]*/>', text[call.end():])
            if inner:
                yield call.end(), call.end() + inner.end(), ''


def removed(pattern):
    return replaced('(' + pattern + ')', '')


def swapped_limits(text, _known):
    for limit in LIMIT.finditer(text):
        yield limit.start(), limit.end(), 'lower="%s"%supper="%s"' % (limit.group(3), limit.group(2), limit.group(1))


def degrees(text, _known):
    for limit in LIMIT.finditer(text):
        values = limit.group(1), limit.group(3)
        if all(number(lambda v: v)(value) is not None for value in values) and abs(float(values[1])) > 0.5:
            lower, upper = (round(float(value) * 57.2958) for value in values)
            yield limit.start(), limit.end(), 'lower="%s"%supper="%s"' % (lower, limit.group(2), upper)
        elif 'radians(' in values[1]:
            yield limit.start(), limit.end(), limit.group().replace('radians(', '(')


def same_name(tag):
    """The second name of a file made equal to the first."""
    pattern = re.compile(r'<%s name="([^"]+)"(?: type="\w+")?/?>' % tag)

    def places(text, _known):
        names = [m for m in pattern.finditer(text) if '<hardware>' not in text[max(0, m.start() - 400):m.start()]]
        for first, second in zip(names, names[1:]):
            if first.group(1) != second.group(1) and ('$' in first.group(1)) == ('$' in second.group(1)):
                yield second.start(1), second.end(1), first.group(1)
    return places


def two_parents(text, _known):
    children = list(re.finditer(r'<child link="([^"]+)"/>', text))
    for first, second in zip(children, children[1:]):
        if first.group(1) != second.group(1):
            yield second.start(1), second.end(1), first.group(1)


def cycles(text, _known):
    for joint in re.finditer(r'<parent link="([^"]+)"/>\s*<child link="([^"]+)"/>', text):
        yield joint.start(1), joint.end(1), joint.group(2)


def far_cycles(text, _known):
    joints = list(re.finditer(r'<parent link="([^"]+)"/>\s*<child link="([^"]+)"/>', text))
    for first, last in zip(joints, joints[2:]):
        if ('$' in first.group(1)) == ('$' in last.group(2)) and first.group(1) != last.group(2):
            yield first.start(1), first.end(1), last.group(2)


def first(places, count=1):
    """Only the first `count` places of a file."""
    def some(text, known):
        for i, place in enumerate(places(text, known)):
            if i < count:
                yield place
    return some


def components(change):
    """A kind that changes a list of numbers."""
    return lambda value: ' '.join(change(value.split())) if '${' not in value and len(value.split()) > 1 else None


NAME = r'"([^"]+)"'
KINDS = {
    # names
    'property-name': properties, 'arg-name': replaced(r'\$\(arg (\w+)\)', typo), 'macro-name': call_names,
    'macro-definition': replaced(r'<xacro:macro name="(\w+)"', typo), 'property-definition': replaced(r'<xacro:property name="(\w+)"', typo),
    'arg-definition': replaced(r'<xacro:arg name="(\w+)"', typo), 'block-name': replaced(r'<xacro:insert_block name="(\w+)"', typo),
    'namespace-name': replaced(r'<xacro:(\w+)\.\w+', typo), 'declared-param': replaced(r'params="(\w\w+)[ "]', typo),
    'declared-block': replaced(r'params="[^"]*[ "]\*+(\w+)', typo),
    'parent-link': replaced(r'<parent link=' + NAME, tail), 'child-link': replaced(r'<child link=' + NAME, tail),
    'link-name': replaced(r'<link name=' + NAME, tail), 'joint-duplicate': same_name('joint'), 'link-duplicate': same_name('link'),
    'two-parents': two_parents, 'self-loop': cycles, 'cycle': far_cycles,
    'material-reference': replaced(r'<material name="(\w+)"/>', typo), 'mimic-joint': replaced(r'<mimic joint=' + NAME, tail),
    'gazebo-reference': replaced(r'<gazebo reference=' + NAME, tail), 'hardware-joint': replaced(
        r'(?:</type>|</hardware>|</joint>)\s*<joint name="((?:[^"]+)_joint)">', tail),
    'interface-name': replaced(r'<(?:command|state)_interface name="(\w+)"', typo),
    'robot-name-missing': replaced(r'<robot( name="\w+")', ''),
    # calls
    'param-misspelled': parameters(lambda m: ' %s=%s' % (typo(m.group(1)), m.group().split('=', 1)[1])),
    'param-missing': parameters(lambda m: ''), 'param-extra': first(parameters(lambda m: m.group() + ' surplus="1"'), 3),
    'call-unprefixed': unprefixed_calls, 'block-missing': blocks, 'macro-unprefixed': replaced(r'(<xacro:)(?:property|arg|include|insert_block) ', '<'),
    'condition-unprefixed': replaced(r'(<xacro:)(?:if|unless) ', '<'), 'condition': replaced(r'<xacro:(?:if|unless) value="([^"]+)"', "${'perhaps'}"),
    # files
    'include-path': replaced(r'<xacro:include filename="[^"]*?(\w+)\.(?:\w+\.)?xacro"', typo), 'include-missing': removed(r'<xacro:include [^<>]*/>'),
    'find-package': replaced(r'\$\(find (\w+)\)', typo), 'uri-package': replaced(r'package://(\w+)/', typo),
    'mesh-file': replaced(r'/meshes/(\w+)\.stl', typo), 'mesh-extension': replaced(r'\.(stl)"', 'stll'),
    'yaml-file': replaced(r'/config/(\w+)\.yaml', typo), 'yaml-key': replaced(r"\['(\w+)'\]", typo),
    # text
    'quote-missing': first(replaced(r'\w=(")', ''), 12), 'bracket-missing': first(replaced(r'"/?(>)', ''), 12),
    'end-tag': replaced(r'</(\w+)>\s*<', typo), 'expression-open': replaced(r'\$\{[^{}]+(\})', ''),
    'parenthesis': replaced(r'\$\{([^{}"]+)\}', lambda v: v + ')'), 'operator': replaced(r'\$\{([^{}"]+)\}', lambda v: v + ' *'),
    'xmlns-missing': replaced(r'( xmlns:xacro="[^"]+")', ''), 'tag-name': replaced(
        r'<((?:visual|collision|inertial|geometry|origin|parent|child|limit|axis|mass|inertia|plugin|hardware))[ />]', typo),
    'attribute-name': replaced(r'<(?:origin|limit|inertia|mass|box|cylinder|axis|sphere)[^<>]*? (xyz|lower|effort|ixx|iyy|value|size|radius|length)="', typo),
    'stray-text': first(replaced(r'<(?:visual|joint [^<>]*|inertial)>(\s*)<', lambda v: v + 'todo '), 4),
    # numbers
    'limit-swapped': swapped_limits, 'limit-degrees': degrees, 'limit-effort-missing': removed(r' effort="[^"]*"'),
    'limit-velocity-missing': removed(r' velocity="[^"]*"'), 'limit-missing': removed(r'<limit [^<>]*/>'),
    'effort-negative': replaced(r' effort="([^"]*)"', number(lambda v: '-%g' % v)),
    'mass-negative': replaced(r'(?:<mass value|mass)="([^"]*)"', number(lambda v: '-%g' % v)),
    'mass-not-a-number': replaced(r'<mass value="([^"]*)"', lambda v: v + 'kg'),
    'inertia-missing': removed(r'\s(?:ixx|iyy|izz)="[^"]*"'), 'inertia-negative': replaced(r' i(?:xx|yy|zz)="([^"]*)"', lambda v: '-' + v if v[0] != '$' else v.replace('${', '${-1 * ')),
    'inertia-scale': replaced(r' ixx="([^"]*)"', lambda v: '%g' % (float(v) * 50) if v[0] != '$' else v.replace('${', '${50 * ')),
    'axis-zero': replaced(r'<axis xyz="([^"$]+)"', '0 0 0'), 'axis-short': replaced(r'<axis xyz="([^"$]+)"', components(lambda v: v[:2])),
    'vector-short': replaced(r'(?:xyz|rpy|rgba|box size)="([^"]+)"', components(lambda v: v[:-1])),
    'vector-letter': replaced(r'(?:xyz|rpy)="([^"]+)"', components(lambda v: [v[0] + 'm'] + v[1:])),
    'vector-comma': replaced(r'(?:xyz|rgba)="([^"]+)"', lambda v: ', '.join(v.split()) if '${' not in v and ' ' in v else None),
    'rpy-degrees': replaced(r' rpy="(0 0 0)"', '0 90 0'), 'origin-millimeters': replaced(r'<origin xyz="([^"]+)"', components(
        lambda v: ['%g' % (float(x) * 1000) if number(lambda y: y)(x) is not None else x for x in v])),
    'color-range': replaced(r' rgba="([^"]+)"', '255 128 0 1'), 'size-negative': replaced(
        r' (?:radius|length)="([^"]*)"', number(lambda v: '-%g' % v)),
    'box-negative': replaced(r'<box size="([^"]+)"', components(lambda v: ['-' + v[0]] + v[1:])),
    # elements
    'joint-type': replaced(r'<joint name="[^"]+" type="(\w+)"', typo), 'joint-type-missing': replaced(r'<joint name="[^"]+"( type="\w+")', ''),
    'parent-missing': removed(r'<parent link="[^"]+"/>'), 'child-missing': removed(r'<child link="[^"]+"/>'),
    'shape-missing': removed(r'<(?:box|cylinder|sphere|mesh) [^<>]*/>'), 'shape-name': replaced(r'<(box|cylinder|sphere|mesh) [^<>]*/>', typo),
    'shape-attribute-missing': replaced(r'<(?:cylinder|sphere|box)[^<>]*?( (?:radius|size)="[^"]*")', ''),
    'plugin-file-missing': replaced(r'<plugin( filename="[^"]*")', ''), 'hardware-plugin-missing': removed(r'<plugin>[^<>]*</plugin>'),
    'mimic-itself': replaced(r'<mimic joint=' + NAME, lambda v: v.replace('left', 'right') if 'left' in v else None),
}


def known_names(files):
    """Names that expressions may read: properties and parameters."""
    names = set()
    for text in files.values():
        names.update(re.findall(r'<xacro:property name="(\w+)"', text))
        for declared in re.findall(r'params="([^"]*)"', text):
            names.update(re.findall(r'(?:^|\s)(\w+)', declared))
    return {'properties': names}


def uncalled(files):
    """Spans (file, start, end) of macros that no call reaches."""
    macros = {}
    for file, text in files.items():
        for macro in re.finditer(r'<xacro:macro name="([\w.]+)".*?</xacro:macro>', text, re.S):
            macros.setdefault(macro.group(1), []).append((file, macro.start(), macro.end()))
    seen, todo = set(), []
    for file, text in files.items():
        spans = [s for spans in macros.values() for s in spans if s[0] == file]
        todo += [c.group(1).split('.')[-1] for c in calls(text) if not any(a < c.start() < b for _, a, b in spans)]
    while todo:
        name = todo.pop()
        if name in macros and name not in seen:
            seen.add(name)
            todo += [c.group(1).split('.')[-1] for file, a, b in macros[name] for c in calls(files[file][a:b])]
    return [span for name, spans in macros.items() if name not in seen for span in spans]


def spread(places, count, seed):
    """`count` of the places, evenly, in another order for each robot and kind."""
    start = zlib.crc32(seed.encode()) % max(1, len(places))
    places = places[start:] + places[:start]
    step = max(1, len(places) / count)
    return [places[int(i * step)] for i in range(min(count, len(places)))]


def place_of(files, file, start):
    """Where a defect is: in a macro, in a file that another one includes, or in a root."""
    text = files[file]
    if text.rfind('<xacro:macro ', 0, start) > text.rfind('</xacro:macro>', 0, start):
        return 'macro'
    base = file.rsplit('/', 1)[-1]
    return 'included' if any(re.search(r'<xacro:include filename="[^"]*\b%s"' % re.escape(base), other)
                             for path, other in files.items() if path != file) else 'root'


def plan(robot, files, each):
    """The defects of a robot: `files` maps a path to its text; at most `each` places of a kind."""
    known, dead = known_names(files), uncalled(files)
    result = []
    for kind, places in KINDS.items():
        found = []
        for file in sorted(files):
            for start, end, new in places(files[file], known):
                if kind != 'macro-definition' and any(file == f and a < start < b for f, a, b in dead):
                    continue
                if '<!--' in files[file][files[file].rfind('\n', 0, start) + 1:start]:
                    continue
                found.append((file, start, end, new))
        for file, start, end, new in spread(found, each, robot + kind):
            text = files[file]
            line = text.count('\n', 0, start) + 1
            result.append(Defect(kind, place_of(files, file, start), file, line, start - text.rfind('\n', 0, start), start, end, new))
    return result
