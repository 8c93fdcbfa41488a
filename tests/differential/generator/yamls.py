"""Random YAML documents and typed paths into them."""
from . import literals

INTS = ['0', '7', '-12', '+5', '1_000', '0x1F', '0b101', '017', '1:30', '-1:30', '190:20:30', '12345678901234567890', '!!int "7"', '!!int 42']
FLOATS = ['0.5', '1.25', '12.5', '3.', '.75', '1.0e+2', '2.5e-1', '6.02e+1', '1_0.5', '1:30.5', '!!float 3', '!!float "2.5"',
          '!radians 1.5', '!degrees 90', '!meters 2', '!millimeters 250', '!foot 3', '!inches 12.5', '!degrees 45.0 * 2',
          '!radians pi / 4', '!meters sqrt(2)', '!millimeters 10 + 5', '!degrees "30"', '!degrees 1e2', '!inches (1 + 2) * 3', '85.']
WORDS = ['plain', '"quoted"', "'single'", 'two words', 'a_b', 'with-dash', 'x#y', 'a:b', "'it''s'", '"esc \\"q\\""', 'yes_no', 'Ünï', 'on_off',
         'nullx', '"\\u00e9\\x41"', 'no.1', '!!str word', '!!str "word"', '&{} anchored', 'word  # comment', '<tag>', "a'b", 'a"b', 'a b  c', '~x']
SCALARS = ['yes', 'No', 'ON', 'off', 'true', 'False', 'TRUE', 'y', 'n', 'Y', '~', 'null', 'Null', 'NULL', '', '1e3', '12e03', '1.0e3', '1e-3',
           '1.5e+3', '1.5E-3', '.inf', '-.inf', '+.INF', '.nan', '.NaN', '0o17', '08', '09.5', '0x', '1_', '_1', '1__0', '1.', '.5', '.', '--', '-.5', '+.5',
           '1,5', '0b', '0b12', '1:2:3', '1:99', '99:59', '1:30.25', '2001-01-01', '2001-12-14t21:59:43.10-05:00', '2001-1-1', '12:30', '"5"', "'5'",
           '"true"', "'~'", '!!str 5', '!!str true', '!!bool yes', '!!null ""', '!!float 1', '!!float .inf', '"a\\nb"', '"\\t"', "''", '""',
           '"multi\n{0}line"', 'plain multi\n{0}line', "'one\n\n{0}two'", '!!binary aGVsbG8=', '!!int "0x10"', '1e', 'e1', '0.1e1', '-0', '-0.0',
           '+1', '1 000', '0777', '-017', '00', '0_7', '=x', '!!str', '123456789012345678901234567890', '1.7976931348623157e+309', '?x', '-x', ':x',
           '!radians 1', '!degrees -45', '!meters .5', '!foot -1', '!inches 1e2']
BLOCKS = ['|\n{0}one\n{0} two\n{0}three', '>\n{0}one\n{0}two\n\n{0}three', '|-\n{0}keep\n{0}this', '>-\n{0}fold\n{0}this\n{0}  not this\n{0}again',
          '|+\n{0}trail\n\n', '>+\n{0}a\n\n{0}b\n\n', '|2\n{0}two\n', '>\n\n{0}lead\n']
METHODS = ['items', 'keys', 'values', 'get', 'copy', 'update', 'pop', 'clear']


class Schema:
    """The shape of a document: 'map' (keys), 'list' (entries) or a kind of scalar."""

    def __init__(self, kind, entries=()):
        self.kind, self.entries = kind, entries

    def paths(self, prefix=''):
        """All (path, kind) below; `.` and `[` notation are chosen by `Yaml.access`."""
        if self.kind == 'map':
            for key, entry in self.entries:
                yield from entry.paths(prefix + '/' + key)
        elif self.kind == 'list':
            for index, entry in enumerate(self.entries):
                yield from entry.paths(prefix + '/' + str(index))
        yield prefix, self.kind


def random_schema(rng, depth=3):
    """A mapping at the top; leaves of a promised kind, or any scalar."""
    entries, keys = [], []
    for _ in range(rng.randrange(2, 6)):
        key = rng.choice(METHODS) if rng.random() < 0.05 else rng.choice(literals.WORDS)
        if key not in keys:
            keys.append(key)
            entries.append((key, random_entry(rng, depth - 1)))
    return Schema('map', entries)


def random_entry(rng, depth):
    roll = rng.random()
    if depth > 0 and roll < 0.28:
        return random_schema(rng, depth)
    if depth > 0 and roll < 0.42:
        return Schema('list', [random_entry(rng, depth - 1) for _ in range(rng.randrange(1, 4))])
    if roll < 0.52:
        return Schema(rng.choice(['ilist', 'wlist']))
    return Schema(rng.choice(['int', 'int', 'flt', 'flt', 'word', 'word', 'any', 'any']))


def access(rng, path):
    """Python source that follows a path: dots where they work, subscripts elsewhere."""
    source = ''
    for step in path.split('/')[1:]:
        if step.isdigit():
            source += '[%s]' % step
        elif step in METHODS or rng.random() < 0.3:
            source += '[%s]' % rng.choice(["'%s'", '"%s"']) % step
        else:
            source += '.' + step
    return source


class Writer:
    """Writes documents of one schema; each call gives other scalars in other notation."""

    def __init__(self, rng):
        self.rng, self.anchors, self.used = rng, [], 0

    def document(self, schema):
        self.anchors, self.used = [], 0
        rng = self.rng
        head = rng.choice(['', '', '', '---\n', '# a comment\n', '%YAML 1.1\n---\n', '\n', '--- # start\n'])
        tail = rng.choice(['', '', '', '...\n', '# end', '\n\n'])
        return head + self.mapping(schema, '') + tail

    def mapping(self, schema, indent):
        """Block mapping, one entry a line; sometimes through a merge key."""
        lines, entries = [], list(schema.entries)
        merge = len(entries) > 2 and self.rng.random() < 0.15
        if merge:  # the first two entries come from elsewhere
            name = self.anchor_name()
            flow = ', '.join('%s: %s' % (k, self.flow(e)) for k, e in entries[:2])
            lines.append('%sbase_%s: &%s {%s}' % (indent, name, name, flow))
            lines.append('%s<<: %s' % (indent, self.rng.choice(['*' + name, '[*%s]' % name])))
            entries = entries[self.rng.randrange(1, 3):]
        for key, entry in entries:
            if self.rng.random() < 0.08:
                lines.append(indent + '# ' + self.rng.choice(literals.WORDS))
            if self.rng.random() < 0.04:
                lines.append('')
            key_text = key if self.rng.random() < 0.9 else self.rng.choice(['"%s"', "'%s'"]) % key
            gap = self.rng.choice([': ', ': ', ': ', ':   ', ' : '])
            lines.append(indent + key_text + gap.rstrip() + self.value(entry, indent, ' ' if gap.rstrip() == ':' else ' '))
        return '\n'.join(lines) + '\n'

    def value(self, entry, indent, gap):
        """What follows `key:`; a nested block begins on the next line."""
        inner = indent + self.rng.choice(['  ', '  ', '    ', ' '])
        if entry.kind == 'map' and entry.entries and self.rng.random() < 0.7:
            return '\n' + self.mapping(entry, inner).rstrip('\n')
        if entry.kind == 'list' and entry.entries and self.rng.random() < 0.6:
            dash = indent if self.rng.random() < 0.3 else inner
            return ''.join('\n' + self.item(e, dash) for e in entry.entries)
        if entry.kind in ('ilist', 'wlist') and self.rng.random() < 0.4:
            kind = entry.kind[0]
            return ''.join('\n%s- %s' % (inner, self.simple(kind)) for _ in range(self.rng.randrange(2, 4)))
        if entry.kind == 'any' and self.rng.random() < 0.12:
            return gap + self.rng.choice(BLOCKS).format(inner + ' ') if len(inner) > 1 else gap + 'x'
        anchor = ''
        if entry.kind in ('int', 'flt') and self.rng.random() < 0.05:
            anchor = '&%s ' % self.anchor_name()
        return gap + anchor + (self.scalar(entry.kind).replace('{0}', inner + '  ') if entry.kind not in ('map', 'list', 'ilist', 'wlist') else self.flow(entry))

    def item(self, entry, indent):
        """`- entry` of a block sequence."""
        if entry.kind == 'map' and entry.entries and self.rng.random() < 0.6:
            lines = ['%s: %s' % (key, self.flow(e)) for key, e in entry.entries]
            return indent + '- ' + ('\n' + indent + '  ').join(lines)
        return indent + '- ' + self.flow(entry)

    def flow(self, entry):
        """Flow style, safe inside brackets."""
        if entry.kind == 'map':
            return '{' + ', '.join('%s: %s' % (k, self.flow(e)) for k, e in entry.entries) + '}'
        if entry.kind == 'list':
            return '[' + ', '.join(self.flow(e) for e in entry.entries) + self.rng.choice([']', ']', ' ]', ', ]'] if entry.entries else [']'])
        if entry.kind in ('ilist', 'wlist'):
            return '[' + ', '.join(self.simple(entry.kind[0]) for _ in range(self.rng.randrange(2, 5))) + ']'
        if entry.kind == 'any':
            return self.rng.choice(['yes', '~', '1e3', '.inf', '"x, y"', "'q'", '08', '1:30', 'null', '-0.0', '"5"', 'plain text', '2001-01-01', '!!str 5'])
        return self.simple(entry.kind[0])

    def simple(self, initial):
        """A scalar that stays one inside brackets."""
        return {'i': lambda: str(self.rng.randrange(-9, 99)), 'f': lambda: '%.3f' % self.rng.uniform(0.1, 40),
                'w': lambda: self.rng.choice([literals.word(self.rng), '"%s"' % literals.word(self.rng)])}[initial]()

    def scalar(self, kind):
        rng = self.rng
        if kind == 'int':
            return rng.choice(INTS) if rng.random() < 0.5 else str(rng.randrange(-20, 500))
        if kind == 'flt':
            return rng.choice(FLOATS) if rng.random() < 0.6 else '%.4f' % rng.uniform(0.1, 90)
        if kind == 'word':
            text = rng.choice(WORDS) if rng.random() < 0.4 else literals.word(rng)
            return text.format(self.anchor_name()) if '{}' in text else text
        if self.anchors and rng.random() < 0.15:
            return '*' + rng.choice(self.anchors)
        text = rng.choice(SCALARS)
        if rng.random() < 0.1 and text:
            name = self.anchor_name()
            return '&%s %s' % (name, text)
        return text

    def anchor_name(self):
        self.used += 1
        self.anchors.append('a%d' % self.used)
        return self.anchors[-1]
