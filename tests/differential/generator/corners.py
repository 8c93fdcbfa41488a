"""Small programs about the corners: document types, names beyond ASCII, namespaces as dicts, `$(eval)`."""
import functools
import glob
import os
import re
import unicodedata

from .xmltext import escape

TYPES = ['CDATA', 'NMTOKEN', 'NMTOKENS', 'ID', 'IDREF', 'IDREFS', 'ENTITY', 'ENTITIES', '(a|b)', 'NOTATION (n)']
SPACES = ['', ' ', '  ', '   ', '&#32;', '&#x20; ', '\t', '\n', '&#9;', '&#10;', ' \n ']
# Replacement texts: of entities that are used, and of those that only stand in branches that are not taken.
TEXTS = ['', 'x', ' x  y ', '1 &#38;#38; 2', '${1 + 1}', 'é', '&#38;#60;', '&#38;amp;', 'a&#10;b', ']]', '%d' % 5]
MARKUP = ['&#60;', '<a>', '<a/>', '<a></a>', '</a>', '<a></b>', '<a b="1"/>', '<a b="1" b="2"/>', '<a b/>', '<!--x', '<!--x-->', '<![CDATA[x]]>', '<![CDATA[x',
          '<?x y?>', '<?x', '<a>&s;</a>', "<a b='&s;'/>", '<a>&none;</a>', '&none;', 'a]]>b', '&#38;', '&#38;x', '<a', '<!-- &none; -->', '<a>${1 +}</a>', '</r><r>', '&#38;#0;', '<1/>', '<a>&m;</a>']
NAMES = ['größe', 'd\u00e9j\u00e0', 'ﬁn', 'ｘｙ', 'ｐｉ', '\u212b', 'ſ', 'K', '\u2160', 'µ', 'μ', '가', 'ṩ', 'ộ', 'ª', 'x٣', 'ｉｆ', 'a\u00b7', 'x\u00b2', 'plain', 'ﬃx', '\u1e9b\u0323', 'ﷺ', '℘', 'pi', 'Å', 'ª_1']
SEPARATORS = ['', ' ', ',', ',;', 'a-c', 'z-a', '^', '^ ', '\\d', '\\w', '\\s', '\\D,', ']', '^]', '-', ',-', '-,', '\\\\', '\\', '\\]', '\\x2c', '\\x2', '\\054', '\\q', '\\b', '.', '$', '|', '[', '\\n', 'a-\\d', '+-.', '\\u002c', '\\-', '^^']
MODULES = ['math', 'python', 'xacro']
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../../docs/examples')


@functools.lru_cache
def examples():
    """The texts of the example robots that need no other file."""
    texts = []
    for path in sorted(glob.glob(EXAMPLES + '/**/*.xacro', recursive=True) + glob.glob(EXAMPLES + '/**/*.urdf', recursive=True)):
        with open(path, encoding='utf-8') as f:
            text = f.read()
        if 'xacro:include' not in text and '$(find' not in text:
            texts.append(text)
    return texts


class Corners:
    """Mixin of the generator."""

    def corner(self):
        """The files of one such program."""
        rng = self.rng
        self.kind = 'corner'
        self.names = rng.sample(NAMES, 3)
        self.entity_names, self.dead_names = [], []
        if rng.random() < 0.2:
            self.files['part.xacro'] = '<r/>'
            self.files['input.xacro'] = self.corner_example()
            return
        head = self.corner_doctype() if rng.random() < 0.6 else ''
        if rng.random() < 0.15:
            self.use('document type behind the first portion')
            head = '<!--%s-->' % ('x' * rng.choice([16300, 16384 - len(head) - rng.randrange(60), 17000])) + head
        parts = [self.corner_attributes, self.corner_entities, self.corner_dead, self.corner_names, self.corner_names, self.corner_spaces, self.corner_modules,
                 self.corner_eval, self.corner_added, self.corner_renamed, self.corner_xmlns, self.corner_tokens]
        body = '\n'.join(rng.choice(parts)() for _ in range(rng.randrange(1, 4)))
        root = '' if rng.random() < 0.9 else ' v="%s"' % self.spaced()
        marks = '\ufeff' * rng.choices([0, 1, 2], [30, 2, 1])[0]
        # what stands in the last lines is there for all
        last = '<last v="${1 + 1}"/>'
        text = marks + head + '<r xmlns:xacro="u"%s>\n%s\n%s</r>' % (root, body, last)
        self.files['part.xacro'] = (self.corner_doctype() if rng.random() < 0.1 else '') + '<r xmlns:xacro="u">%s</r>' % ''.join(self.corner_part() for _ in range(rng.randrange(4)))
        self.files['input.xacro'] = text

    def corner_example(self):
        """An example robot, changed in the ways of this module."""
        self.use('a changed example')
        rng = self.rng
        text = re.sub(r'^\s*<\?xml[^>]*>', '', rng.choice(examples()))
        head = self.corner_doctype().replace('ATTLIST b', 'ATTLIST origin').replace(' v ', ' xyz ') if rng.random() < 0.6 else ''
        # an address of a namespace is checked before its entities are known: see docs/compatibility.md
        values = list(re.finditer(r'(?<!xmlns)(?<!xmlns:xacro)="([^"<&]*)"', text))
        for found in sorted(rng.sample(values, min(len(values), rng.randrange(8))), key=lambda found: -found.start()):
            value = rng.choice([found.group(1).replace(' ', rng.choice(SPACES[1:])), rng.choice(SPACES) + found.group(1) + rng.choice(SPACES), *('&%s;' % name for name in self.entity_names)])
            text = text[:found.start(1)] + value + text[found.end(1):]
        declared = re.findall(r'xacro:property name="(\w+)"', text)
        if declared and rng.random() < 0.5:
            name = rng.choice(self.names)
            text = re.sub(r'\b%s\b' % rng.choice(declared), lambda _: self.form(name) if rng.random() < 0.3 else unicodedata.normalize('NFKC', name), text)
        parts = [self.corner_attributes, self.corner_entities, self.corner_dead, self.corner_names, self.corner_modules, self.corner_tokens]
        if 'xmlns:xacro' in text and rng.random() < 0.5:
            end = text.rindex('</')
            text = text[:end] + rng.choice(parts)() + text[end:]
        return head + text

    def corner_doctype(self):
        rng = self.rng
        self.use('DOCTYPE with corners')
        gap = rng.choice([' ', ' ', '  ', '\n'])
        identifier = rng.choice(['', '', '', 'SYSTEM "x.dtd"', "SYSTEM 'a\"b'", 'SYSTEM ""', 'PUBLIC "p  q" "s"', 'PUBLIC "" "s"', "PUBLIC ' p ' ''"])
        lines = []
        for name in rng.sample(['s', 't', 'u', 'w'], rng.randrange(4)):
            self.entity_names.append(name)
            lines.append('<!ENTITY %s "%s">' % (name, rng.choice(TEXTS)))
        for name in ['m', 'k'][:rng.randrange(3)]:
            self.dead_names.append(name)
            text = rng.choice(MARKUP)
            lines.append('<!ENTITY %s %s>' % (name, "'%s'" % text if '"' in text else '"%s"' % text))
        for _ in range(rng.randrange(3)):
            lines.append('<!ATTLIST %s v %s %s>' % (rng.choice(['r', 'a', 'b', 'xacro:property']), rng.choice(TYPES), rng.choice(['#IMPLIED', '#REQUIRED', '#IMPLIED w CDATA #IMPLIED'])))
        lines += rng.sample(['<!-- c -->', '<?p i?>', '<!ELEMENT r ANY>', '<!NOTATION n SYSTEM "x">', '<!ENTITY x SYSTEM "gone">', '<!ENTITY % p "z">'], rng.choice([0, 0, 1, 2]))
        if rng.random() < 0.25:
            lines.insert(rng.randrange(len(lines) + 1), '<!ENTITY % pe SYSTEM "pe.ent"> %pe;')
            self.entity_names.append('skipped')
        rng.shuffle(lines)
        subset = '[%s]' % rng.choice([' ', '\n', '']).join(lines) if lines or rng.random() < 0.3 else ''
        end = rng.choice(['', '', ' ', '\n'])
        return '<!DOCTYPE%s%s%s%s %s%s>' % (gap, rng.choice(['r', 'robot', 'q:r']), gap, identifier, subset, end) + rng.choice(['', '\n'])

    def spaced(self):
        """An attribute value with white space in odd places."""
        rng = self.rng
        words = [rng.choice(['a', 'b', '${1}', "${'  '}", 'é', '&lt;'] + ['&%s;' % name for name in self.entity_names]) for _ in range(rng.randrange(4))]
        return rng.choice(SPACES) + ''.join(word + rng.choice(SPACES) for word in words)

    def corner_attributes(self):
        self.use('white space in attributes')
        rng = self.rng
        value = self.spaced()
        if rng.random() < 0.2:
            return '<xacro:property name="tok" v="1" value="%s"/><c w="${tok}"/>' % value
        return '<%s v="%s" w="%s"/>' % (rng.choice('ab'), value, self.spaced())

    def corner_entities(self):
        self.use('entities as text')
        rng = self.rng
        pieces = ['&%s;' % name for name in self.entity_names] + ['', ' ', 'x', '<!--c-->', '<![CDATA[]]>', '<![CDATA[y]]>', '<i/>', "${''}", '${2}', '\n']
        return '<e>%s</e>' % ''.join(rng.choice(pieces) for _ in range(rng.randrange(1, 4)))

    def corner_dead(self):
        self.use('entities in a branch that is not taken')
        rng = self.rng
        name = rng.choice(self.dead_names or ['amp'])
        inner = rng.choice(['&%s;', 'a&%s;b', '<x>&%s;</x>', '<x a="&%s;"/>', '<!-- &%s; -->', '<![CDATA[&%s;]]>']) % name
        return rng.choice(['<xacro:if value="0">%s</xacro:if>', '<xacro:macro name="dead">%s</xacro:macro>', '<xacro:property name="dead"><y>%s</y></xacro:property>']) % inner

    def form(self, name):
        """A name in one of its Unicode forms."""
        return unicodedata.normalize(self.rng.choice(['NFC', 'NFD', 'NFKC', 'NFKC', 'NFKD']), name) if self.rng.random() < 0.7 else name

    def corner_names(self):
        self.use('names beyond ASCII')
        rng = self.rng
        name = rng.choice(self.names)
        given, used = (self.form(name) if rng.random() < 0.4 else unicodedata.normalize('NFKC', name)), self.form(name)
        return rng.choice([
            '<xacro:property name="{g}" value="1"/><a n="${{{u}}}"/>', '<xacro:property name="{g}" value="1"/><a n="${{{u} + 1}}"/>', '<a n="${{[{u} for {g} in [1]]}}"/>',
            '<a n="${{(lambda {g}: {u})(2)}}"/>', '<a n="${{(lambda {g}: 1)({u}=2)}}"/>', '<a n="${{({g} := 3) + {u}}}"/>', "<a n=\"${{f'{{{u}=}}'}}\"/>",
            '<xacro:macro name="mm" params="{g}"><k n="${{{u}}}"/></xacro:macro><xacro:mm {g}="4"/>', '<xacro:macro name="mm" params="{g}:=5"><k n="${{{u}}}"/></xacro:macro><xacro:mm/>',
            '<xacro:arg name="{g}" default="6"/><a n="$(arg {g})" m="$(eval {u})"/>', '<a n="${{dict({g}=1)}}"/>', '<xacro:include filename="part.xacro" ns="{g}"/><a n="${{{u}.p}}"/>',
            '<xacro:property name="{g}"><b/></xacro:property><xacro:insert_block name="{u}"/>', '<a n="${{math.{u}}}"/>', '<a n="${{\'\'.{u}}}"/>',
            '<xacro:property name="{g}" value="1"/><xacro:property name="{u}" remove="true"/>']).format(g=given, u=used)

    def corner_part(self):
        rng = self.rng
        return rng.choice(['<xacro:property name="p" value="1"/>', '<xacro:property name="q" value="${p}"/>', '<xacro:property name="w" value="some text"/>', '<seen p="${1}"/>',
                           '<xacro:property name="z" value="${2 * 3}"/>', '<xacro:property name="p" value="2"/>', '<xacro:property name="blk"><b/></xacro:property>', "<xacro:property name=\"s\" value=\"'5'\"/>"])

    def of_namespace(self, space, key):
        """An expression that takes a namespace for the dict that it is."""
        return self.rng.choice(["len({s})", "'{k}' in {s}", "'{k}' not in {s}", "list({s})", "[k for k in {s}]", "{s}.keys()", "len({s}.keys())", "sorted({s})", "python.sorted({s})[0:3]", "max({s})",
                                "'-'.join({s})", "tuple({s})", "len(dict({s}))", "'{k}' in {s}.keys()", "{s}['{k}']", "isinstance({s}, dict)", "{s} is {s}", "1 in {s}", "[] in {s}", "len(set({s}))",
                                "len(list({s}.items()))", "len({s}.values())", "list(map(len, {s}))", "python.enumerate({s}) is None", "python.any({s})", "len({s}.copy())", "len(python.tuple({s}))",
                                "python.all({s})", "{s} == dict({s})", "{s} == math", "list(python.reversed({s}))[0:1]", "{s}.depth", "{s}.get('nope')", "{s}.get('nope', 3)", "len([*{s}])", "python.repr(list({s})[0:1])"]).format(s=space, k=key)

    def corner_spaces(self):
        self.use('a namespace as a dict')
        rng = self.rng
        code = [self.of_namespace('sp', rng.choice(['p', 'q', 'w', 'z', 'nope', 'pi', 'blk', '**blk', 'len'])) for _ in range(rng.randrange(1, 4))]
        if rng.random() < 0.4:
            code.insert(rng.randrange(len(code) + 1), rng.choice(["sp.get('z')", "sp.get('w')", "dict(sp).get('z')", "sp.w", "sp.z", "sp.p"]))
        return '<xacro:include filename="part.xacro" ns="sp"/>' + ''.join('<a n="%s"/>' % escape(rng, '${%s}' % text, '<&"') for text in code)

    def corner_modules(self):
        self.use('a module as a dict')
        rng = self.rng
        module = rng.choice(MODULES)
        return '<a n="%s"/>' % escape(rng, '${%s}' % self.of_namespace(module, rng.choice(['pi', 'len', 'arg', 'nope', 'sin', 'True'])), '<&"')

    def corner_eval(self):
        self.use('functions in $(eval)')
        rng = self.rng
        call = rng.choice(["arg('g')", "arg('s')", "arg('b')", "arg('nope')", "env('SITE')", "env('NOPE')", "optenv('NOPE')", "optenv('NOPE', 'd')", "optenv('SITE', 'd')", "find('kit')[-3:]", "find('nope')",
                           "dirname()", "arg('g') + 1", "len(arg('s'))", "[g for i in 'ab']", "[i for i in s]", "[pi for i in 'a']", "max(g, 3)", "g + 1", "s", "(lambda: g)()", "(lambda x: x)(g)",
                           "arg(name='g')", "env", "math.pi", "xacro", "len(s)", "str(g)", "[len(i) for i in [s]]", "{i: 1 for i in s}", "true", "[true for i in s]", "abs(-g)", "arg()", "optenv()", "sin(g) < 2"])
        text = '$(eval ${"%s"})' % call.replace('"', "'").replace(')', '\\x29').replace('{', '\\x7b').replace('}', '\\x7d')
        return '<xacro:arg name="g" default="7"/><xacro:arg name="s" default="two"/><xacro:arg name="b" default="True"/><a n="%s"/>' % escape(rng, text, '<&"')

    def corner_added(self):
        self.use('xacro:attribute with odd names')
        rng = self.rng
        name = rng.choice(['${1}', '${0}', '${1.5}', '${True}', '${None}', '${[]}', "${['a']}", "${'a'}", 'n${1}', 'xmlns:q', 'xacro:n', "${''}", '${dict()}', '${(1,)}', 'q:n', 'p:n', 'n', 'n'])
        node = '<xacro:attribute name="%s" value="x"/>' % name
        if rng.random() < 0.3:
            node += '<xacro:attribute name="%s" value="y"/>' % rng.choice(['n', 'q:n', 'p:n', 'o'])
        return rng.choice(['<a>%s</a>', '%s', '<a n="1">%s</a>', '<a n="1" xmlns:q="u" q:n="2">%s</a>', '<a><xacro:if value="1">%s</xacro:if></a>', '<xacro:macro name="ma">%s</xacro:macro><xacro:ma/>']) % node

    def corner_renamed(self):
        self.use('xacro:element as another tag')
        rng = self.rng
        name = rng.choice(['xacro:call', 'xacro:call', 'xacro:mc', 'xacro:element', 'xacro:if', 'xacro:attribute', 'xacro:property', 'xacro:insert_block', 'xacro:nope', 'xacro:', 'b', 'xacro:arg'])
        attributes = rng.sample(['macro="mc"', 'p="1"', 'value="1"', 'name="n"', 'macro="${\'mc\'}"', 'xacro:other="2"', 'default="1"', 'p="${2}"'], rng.randrange(4))
        attributes = [a for i, a in enumerate(attributes) if a.split('=')[0] not in [b.split('=')[0] for b in attributes[:i]]]
        return '<xacro:macro name="mc" params="p:=3"><k p="${p}"/></xacro:macro><xacro:element xacro:name="%s" %s/>' % (name, ' '.join(attributes))

    def corner_xmlns(self):
        self.use('xmlns:xacro with an expression')
        rng = self.rng
        value = rng.choice(['${nothing}', '${1}', 'u', '$(arg nope)', '$${x}', '${', 'a${1}'])
        return rng.choice(['<a xmlns:xacro="%s"/>', '<xacro:if value="1" xmlns:xacro="%s"/>', '<xacro:if value="0" xmlns:xacro="%s"/>', '<xacro:property name="xp" value="1" xmlns:xacro="%s"/>',
                           '<xacro:macro name="mx" xmlns:xacro="%s"><k/></xacro:macro><xacro:mx/>', '<xacro:macro name="mx" xmlns:xacro="%s"><k/></xacro:macro>', '<xacro:unless value="0" other="%s"/>',
                           '<xacro:property name="bx" xmlns:xacro="%s"><b/></xacro:property><xacro:insert_block name="bx"/>', '<xacro:element xacro:name="a" xmlns:xacro="%s"/>']) % value

    def corner_tokens(self):
        self.use('separators of tokenize')
        rng = self.rng
        separators = rng.choice(SEPARATORS) + rng.choice(['', '', '', ',', ' ', '-'])
        code = "xacro.tokenize('a b,c;d-e]f^g5.x', %r%s)" % (separators, rng.choice(['', '', ', False', ', skip_empty=False']))
        return '<a n="%s"/>' % escape(rng, '${%s}' % code, '<&"') if '}' not in code else '<a/>'
