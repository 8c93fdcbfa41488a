"""The generator: elements, conditions, the main file, and the program as a whole."""
import random
from dataclasses import dataclass, field

from . import literals
from .corners import Corners
from .errors import Errors
from .files import URIS, Files
from .macros import Macros
from .properties import Properties
from .scope import Context, Scope
from .values import Values
from .xmltext import layout, tag
from .yamls import Writer, random_schema

TAGS = 'link joint origin visual geometry box mesh limit axis a b c gazebo plugin param robot model sensor property include if macro arg'.split()
ATTRIBUTES = 'name xyz rpy size value type link filename a b c Z id mass scale _x lower'.split()
NAMES = ('alpha beta_2 gain kp kd ki mass length width height radius offset count total speed ratio angle limit deep gap n r g h k w t a b c d s '
         'joint_type tool_name label side_1 half_w _hidden x0 y0 z0 X1 Größe длина 名 camelCase CONST lo hi step_size level unit color marker found_at').split()
GLOBAL_NAMES = ['e', 'tau', 'gamma', 'dist', 'fsum', 'copysign', 'erf']


@dataclass
class Program:
    """Files by path, arguments and environment of one run."""
    files: dict
    args: list
    env: dict
    kind: str = 'plain'  # 'plain', 'error', 'mutated' or 'corner'
    uses: list = field(default_factory=list)


class Generator(Values, Properties, Macros, Files, Errors, Corners):
    """Writes one program; everything random comes from the seed."""

    def __init__(self, seed, disabled=()):
        self.rng = random.Random(seed)
        self.disabled = disabled
        self.uses = []
        self.kinds, self.ranks, self.formats, self.args = {}, {}, {}, {}
        self.reserved, self.block_names = set(), []
        self.files, self.file_count, self.space_count, self.macro_count = {}, 0, 0, 0
        self.pool = list(NAMES) + [a + '_' + b for a, b in zip(literals.WORDS, reversed(literals.WORDS))]
        self.rng.shuffle(self.pool)
        self.avoid = ()
        if self.rng.random() < 0.08:
            self.use('global symbol redefined')
            self.avoid = tuple(self.rng.sample(GLOBAL_NAMES, 2))
            self.pool[-3:-3] = self.avoid
        self.kinds['found'], self.ranks['found'] = 'word', -1
        self.schemas = [random_schema(self.rng) for _ in range(self.rng.choice([1, 1, 2]))]
        self.yaml_names = {id(schema): 'data%d.%s' % (i, self.rng.choice(['yaml', 'yml'])) for i, schema in enumerate(self.schemas)}
        self.yaml_writer = Writer(self.rng)
        self.entities = {}
        self.budget = self.rng.choice([12, 20, 30, 45, 60])

    def use(self, construct):
        """Note that the program has a construct."""
        self.uses.append(construct)

    # --- elements and other statements

    def element(self, ctx, children=True):
        """An ordinary element that shows something."""
        rng = self.rng
        name = rng.choice(TAGS)
        attributes = [(n, self.shown(ctx)) for n in rng.sample(ATTRIBUTES, rng.choice([0, 1, 1, 2, 2, 3]))]
        if rng.random() < 0.02:
            self.use('xacro:* attribute')
            attributes.append(('xacro:note', '${nothing} $$x'))
        if ctx.prefixes and rng.random() < 0.3:
            self.use('prefixed names')
            name = rng.choice([name, '%s:%s' % (ctx.prefixes[0], name)])
            attributes.append(('%s:flag' % ctx.prefixes[0], self.shown(ctx)))
        if rng.random() < 0.02:
            self.use('xmlns on element')
            attributes.append(rng.choice([('xmlns:q', 'urn:q'), ('xmlns', 'urn:default'), ('xmlns:xacro', 'urn:other'), ('xml:lang', 'en')]))
        inner = None
        if children and self.budget > 0 and rng.random() < 0.35:
            inner = self.content(ctx.deeper(), rng.randrange(0, 4))
        elif rng.random() < 0.2:
            inner = self.text_only(ctx)
        text = tag(rng, name, attributes, inner)
        if self.entities and ctx.nesting == 0 and rng.random() < 0.3:
            self.use('entity')
            text = text.replace('<' + name, '<%s ent="a&%s;b"' % (name, rng.choice([k for k, v in self.entities.items() if '<' not in v] or ['lt'])), 1)
        return text

    def text_only(self, ctx):
        """Text content of an element."""
        rng = self.rng
        from .xmltext import content
        text = rng.choice([self.shown(ctx), self.shown(ctx), ' ', '\n', '  \n ', "${''}", literals.free_text(rng), '\n    ' + self.shown(ctx) + '\n  '])
        return content(rng, text)

    def statement(self, ctx):
        """Nodes of one random statement."""
        self.budget -= 1
        choices = [(24, lambda c: [self.element(c)]), (14, self.any_property), (9, self.call), (5, self.macro), (6, self.conditional), (5, self.include),
                   (3, self.argument), (2, self.block_property), (3, self.insert_block), (2, self.show_yaml), (2, self.dynamic_element),
                   (2, self.added_attribute), (1, self.recursion), (1, self.redefine_macro), (2, self.show_all)]
        if self.budget <= 0:
            choices = choices[:1]
        return self.rng.choices([c for _, c in choices], [w for w, _ in choices])[0](ctx)

    def simple_statement(self, ctx):
        """A statement that leaves nothing behind but local properties."""
        self.budget -= 1
        choices = [lambda c: [self.element(c, children=False)], lambda c: [self.element(c, children=False)], self.conditional_simple, self.dynamic_element]
        return self.rng.choice(choices)(ctx)

    def library_statement(self, ctx):
        """What files for namespaces are made of."""
        self.budget -= 1
        choices = [(5, self.any_property), (4, self.macro), (2, lambda c: [self.element(c)]), (1, self.include), (1, self.call), (1, self.conditional), (1, self.argument)]
        return self.rng.choices([c for _, c in choices], [w for w, _ in choices])[0](ctx)

    def content(self, ctx, count, statement=None):
        """Finished content of an element: `count` statements."""
        nodes = []
        for _ in range(count):
            nodes += (statement or self.statement)(ctx)
        return layout(self.rng, nodes, ctx.depth, self.use)

    def conditional(self, ctx):
        """`xacro:if` or `xacro:unless`; a branch that is known not to be taken may hold anything."""
        rng = self.rng
        text, truth = self.condition(ctx)
        name = rng.choice(['xacro:if', 'xacro:if', 'xacro:unless'])
        self.use(name + ('' if truth is None else ' of a constant'))
        taken = None if truth is None else truth == (name == 'xacro:if')
        inner = ctx.deeper() if taken else ctx.unsure().deeper()
        if taken is False and rng.random() < 0.5:
            self.use('broken content in an untaken branch')
            body = rng.choice(self.BROKEN)
        else:
            body = self.content(inner, rng.randrange(0, 4))
        attributes = [('value', text)]
        if rng.random() < 0.01:
            self.use('unknown attribute')
            attributes.append(('note', 'x'))
        nodes = [tag(rng, name, attributes, body)]
        if rng.random() < 0.2:  # the other branch
            other = 'xacro:unless' if name == 'xacro:if' else 'xacro:if'
            inner = ctx.deeper() if taken is False else ctx.unsure().deeper()
            nodes.append(tag(rng, other, [('value', text)], self.content(inner, rng.randrange(0, 2))))
        return nodes

    def conditional_simple(self, ctx):
        text, _ = self.condition(ctx)
        return [tag(self.rng, self.rng.choice(['xacro:if', 'xacro:unless']), [('value', text)], self.element(ctx, children=False))]

    def argument(self, ctx):
        """Declare an argument; from here on it can be read if this runs for sure."""
        rng = self.rng
        self.use('xacro:arg')
        kind = rng.choice(['int', 'int', 'idx', 'flt', 'bool', 'word', 'word', 'text'])
        name = rng.choice(list(self.args)) if self.args and rng.random() < 0.2 else 'arg%d' % (len(self.args) + self.file_count)
        kind = self.args.get(name, kind)
        if kind in ('int', 'idx', 'flt', 'word') and rng.random() < 0.25:
            make = self.expressions(ctx)
            default = '${%s}' % make.make(kind, 1) if kind != 'word' else self.word_text(make)
            default = default if kind != 'word' or "'" not in default else 'plain'
        else:
            default = self.argument_text(kind)
        if ctx.body is None and ctx.certain and name not in self.args:
            self.args[name] = kind
            if rng.random() < 0.3:
                self.given.append(name + ':=' + self.argument_text(kind))
        return [tag(rng, 'xacro:arg', [('name', name), ('default', default)], None if rng.random() < 0.98 else '<ignored a="${nothing}"/>')]

    def argument_text(self, kind):
        rng = self.rng
        return {'int': lambda: rng.choice(['5', '42', '0', '-3', '100']), 'idx': lambda: rng.choice('0123'), 'flt': lambda: rng.choice(['0.5', '2.25', '1.0']),
                'bool': lambda: rng.choice(['true', 'false', 'True', 'False', '1', '0']), 'word': lambda: literals.word(rng),
                'text': lambda: rng.choice(['two words', 'a/b.c', 'é', "it's", 'x=1'])}[kind]()

    def dynamic_element(self, ctx):
        self.use('xacro:element')
        rng = self.rng
        name = rng.choice(TAGS[:14])
        text = rng.choice(["${'%s'}" % name, "%s${''}" % name, "${'%s' + '%s'}" % (name[:1], name[1:]), name])
        attributes = [('xacro:name', text)] + [(n, self.shown(ctx)) for n in rng.sample(ATTRIBUTES, rng.randrange(3))]
        inner = self.content(ctx.deeper(), rng.randrange(1, 3)) if self.budget > 0 and rng.random() < 0.2 else None
        if rng.random() < 0.08 and ctx.certain:
            self.use('xacro:element as another tag')
            prop = self.new_name('int')
            ctx.scope.define(prop)
            return [tag(rng, 'xacro:element', [('xacro:name', "xacro:${'property'}"), ('name', prop), ('value', '5')]),
                    tag(rng, 'xacro:element', [('xacro:name', 'xacro:if'), ('value', rng.choice(['1', '0']))], '<inside/>')]
        return [tag(rng, 'xacro:element', attributes, inner)]

    def added_attribute(self, ctx):
        """An element with `xacro:attribute` among its children."""
        self.use('xacro:attribute')
        rng = self.rng
        name = rng.choice(['added', 'name', "${'na' + 'me'}", 'id', "x${'y'}", 'Z'])
        value = rng.choice(['text', 'a ${1 + 1}', "${'t'}", '${%s}' % self.expressions(ctx).make('word', 1), 'n: ${%s}' % self.expressions(ctx).make('num', 1), ''])
        node = tag(rng, 'xacro:attribute', [('name', name), ('value', value)], None if rng.random() < 0.95 else '<ignored/>')
        where = rng.random()
        if where < 0.1:
            self.use('xacro:attribute in a condition')
            node = '<xacro:if value="1">%s</xacro:if>' % node
        nodes = [node] if rng.random() < 0.4 else rng.sample([node, '<inner/>', '<inner b="${2}"/>'], 3)
        return [tag(rng, rng.choice(TAGS[:10]), [('name', 'x')][:rng.randrange(2)], layout(rng, nodes, ctx.depth + 1, self.use))]

    def show_all(self, ctx):
        """An element with the values of several names."""
        names = [name for name in ctx.scope.visible_names() if self.kinds[name] not in ('fn', 'fmt')]
        if not names:
            return [self.element(ctx)]
        self.use('values of names')
        return [self.show_names(ctx, self.rng.sample(names, min(len(names), 5)))]

    # --- the program

    def main_file(self):
        """Text of input.xacro."""
        rng = self.rng
        prefixes, attributes = (), [('xmlns:xacro', rng.choice(URIS))]
        if rng.random() < 0.9:
            attributes.append(('name', rng.choice(['robot', 'r_${1 + 1}', "${'made'}", '$(optenv SITE x)', 'a b'])))
        if rng.random() < 0.15:
            prefixes = ('gz',)
            attributes.append(('xmlns:gz', 'urn:gz'))
        if rng.random() < 0.02:
            self.use('targetNamespace')
            attributes.append(('xacro:targetNamespace', rng.choice(['urn:target', ''])))
        head = self.prolog('input.xacro')
        if rng.random() < 0.08:
            head += self.doctype()
        top = Context(Scope(), '', 1, prefixes=prefixes)
        self.top = top.scope
        count = self.budget // 2 + 3
        nodes = []
        for _ in range(count):
            nodes.append('\n  '.join(self.statement(top)))
            if self.budget < -10:
                break
        nodes.append(self.show_all(top)[0])
        for _ in range(rng.randrange(3)):
            nodes += self.call(top) if self.budget > 0 else [self.element(top)]
        if self.kind == 'error':
            self.inject(nodes, top)
        return head + tag(rng, rng.choice(['robot', 'robot', 'sdf', 'world', 'r']), attributes, layout(rng, nodes, 1, self.use)) + rng.choice(['\n', '', '\n<!-- after -->', '\n<?post x?>\n\n'])

    def doctype(self):
        """A document type with entities."""
        self.use('DOCTYPE')
        self.entities = {'unit': 'mm', 'half': '${1 / 2}', 'two_words': 'x &#38;#38; y'}
        if 'entity-markup' not in self.disabled and self.rng.random() < 0.1:
            self.entities['made'] = '<made/>'
        body = ''.join('\n  <!ENTITY %s %s>' % (k, ("'%s'" if '"' in v else '"%s"') % v) for k, v in self.entities.items())
        if self.rng.random() < 0.2:
            body += self.rng.choice(['\n  <!-- c -->', '\n  <!ELEMENT a ANY>', '\n  <!ATTLIST a q CDATA "dflt">'])
        return '<!DOCTYPE %s [%s\n]>\n' % (self.rng.choice(['robot', 'x']), body)

    def program(self, corner=False):
        """The whole program; `corner`: a small one about the corners."""
        rng = self.rng
        if corner:
            return self.corner_program()
        roll = rng.random()
        self.kind = 'error' if roll < 0.07 else 'mutated' if roll < 0.13 else 'plain'
        self.given = [rng.choice(['unused:=1', '_private:=x', 'spaced := 5', 'empty:='])] if rng.random() < 0.1 else []
        self.files['input.xacro'] = ''
        self.files['input.xacro'] = self.main_file()
        return self.finished()

    def corner_program(self):
        """A program about the corners; some are damaged at random."""
        self.given = []
        self.corner()
        if self.rng.random() < 0.1:
            self.kind = 'mutated'
        return self.finished()

    def finished(self):
        """The program with what every one has."""
        rng = self.rng
        self.shared_files()
        files = {path: self.encode(path, text) for path, text in self.files.items()}
        program = Program(files, self.given, {'SITE': rng.choice(['hall 3', 'x', '42']), 'AMENT_PREFIX_PATH': '@DIR@/prefix'}, self.kind, self.uses)
        if self.kind == 'mutated':
            self.mutate(program)
        return program

    def encode(self, path, text):
        """Bytes of a file: line ends, byte order marks, encodings."""
        rng = self.rng
        if not path.endswith('.xacro'):
            return text.encode()
        if rng.random() < 0.05:
            self.use('CRLF')
            text = text.replace('\n', '\r\n')
        elif rng.random() < 0.005:
            self.use('CR')
            text = text.replace('\n', '\r')
        if rng.random() < 0.02:
            self.use('byte order mark')
            return b'\xef\xbb\xbf' + text.encode()
        return text.encode()


def generate(seed, disabled=(), corner=False):
    """The program of a seed."""
    return Generator(seed, disabled).program(corner)
