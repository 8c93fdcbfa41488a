"""Texts of attributes: values to store, values to show, conditions."""
from . import literals
from .expressions import Expressions
from .trial import TRIAL
from .yamls import Schema, access

# Which kinds of names serve where a kind is asked for.
SERVES = {
    'idx': ('idx',), 'bit': (), 'int': ('int', 'idx'), 'flt': ('flt',), 'num': ('num', 'flt', 'int', 'idx'), 'bool': ('bool',),
    'word': ('word',), 'text': ('text', 'word'), 'ilist': ('ilist',), 'wlist': ('wlist',), 'dict': ('dict',),
    'mix': ('mix', 'ilist', 'wlist', 'dict'), 'fn': ('fn',),
    'any': ('any', 'idx', 'int', 'flt', 'num', 'bool', 'word', 'text', 'ilist', 'wlist', 'dict', 'mix'),
}
KINDS = ['int', 'int', 'idx', 'flt', 'flt', 'num', 'bool', 'word', 'word', 'text', 'ilist', 'wlist', 'dict', 'mix', 'any', 'any', 'fn']
TRUE = ['1', 'true', 'True', '${True}', '${1}', '-1', ' 2 ', '007', '${[0]}', '${0.5}', '${1.0}', "${'1'}", "${'true'}", '${nan}', '+1', '1_0',
        '\u0661', "${' 1 '}", '${(0,)}', '$(optenv NOT_SET 1)', '${not 0}', '1\n']
FALSE = ['0', 'false', 'False', '${False}', '${0}', '${[]}', '${None}', '${0.0}', "${'0'}", '-0', '00', ' 0', '${dict()}', '${()}',
         "${'false'}", '${1 == 2}', '$(optenv NOT_SET false)', '${0 or 0.0}', '${-0.0}']
# Formats for str.format: braces cannot stand inside `${}`, but in the text of a property.
FORMATS = [('{:.3f} {}', ('flt', 'any')), ('{0:>6}|{1:<4}|{0}', ('word', 'int')), ('{:05d}', ('int',)), ('{:+.2e}', ('num',)), ('{:,}', ('int',)),
           ('{:%}', ('flt',)), ('{0[0]} {0[1]}', ('ilist',)), ('{:x} {:#b} {:o}', ('idx', 'idx', 'idx')), ('{{}} {}', ('int',)), ('{:^9}|', ('word',)),
           ('{:*<8}{:=+5}', ('word', 'int')), ('{!r} {!s:>4}', ('word', 'int')), ('{:g} {:.3}', ('num', 'num')), ('{:8.3f}|{:<8}|', ('num', 'num')), ('{0.real}', ('int',))]


class Values:
    """Mixin of the generator: everything that ends up in an attribute."""

    def serves(self, name, kind):
        """Whether the values of a name can stand for `kind`."""
        own = self.kinds[name]
        return isinstance(own, str) and own in SERVES.get(kind, ())

    def sources(self, ctx, kind, rank=None, lasting=False, inside=False):
        """Expressions for names that can be used as `kind`: own names, namespaces, YAML paths, arguments."""
        out = []
        for name in ctx.scope.visible_names(lasting):
            if rank is not None and self.ranks[name] >= rank:
                continue
            if isinstance(self.kinds[name], Schema):
                out += self.yaml_paths(name, self.kinds[name], kind)
            elif self.serves(name, kind):
                out += [name, name]
        for prefix, space in ctx.scope.visible_spaces():
            for name, stays in space.names.items():
                if (stays or not lasting) and (rank is None or self.ranks[name] < rank) and self.serves(name, kind):
                    out.append(prefix + '.' + name)
        for name, own in self.args.items():
            if own == kind and kind in ('int', 'flt', 'idx'):
                out.append('$(arg %s)' % name)
            elif own == kind == 'word':
                out.append("'$(arg %s)'" % name)
        return out

    def yaml_paths(self, name, schema, kind):
        """A few paths below a YAML name that give `kind`."""
        if isinstance(schema, Schema):
            wanted = SERVES.get(kind, ())
            found = [path for path, k in schema.paths() if k in wanted or (kind == 'any' and k in ('map', 'list'))]
            return [name + access(self.rng, self.rng.choice(found)) for _ in range(min(len(found), 2))]
        return []

    def expressions(self, ctx, rank=None, lasting=False):
        """Expressions over what is visible in `ctx`."""
        cache = {}

        def names(kind):
            if kind not in cache:
                cache[kind] = self.sources(ctx, kind, rank, lasting)
            return cache[kind]
        return Expressions(self.rng, names, self.avoid)

    def stored(self, kind, ctx, rank=None, eager=False):
        """Text of an attribute that is stored as a value of `kind`."""
        rng = self.rng
        make = self.expressions(ctx, rank, lasting=not eager)
        roll = rng.random()
        if isinstance(kind, Schema):
            return '${%s}' % self.yaml_source(ctx, kind)
        if kind == 'any':
            return self.odd_text(make)
        if kind in ('int', 'idx') and roll < 0.3:
            return str(rng.randrange(4)) if kind == 'idx' else rng.choice(['42', '007', ' 12 ', '-3', '+8', '1000', str(rng.randrange(500))])
        if kind in ('flt', 'num') and roll < 0.3:
            return rng.choice(['0.5', '1.50', '.25', '2.', '1e1', '3.0', '12.34', '%.3f' % rng.uniform(0.1, 50)])
        if kind == 'bool' and roll < 0.3:
            return rng.choice(['true', 'false', 'True', 'False'])
        if kind == 'word' and roll < 0.5:
            return self.word_text(make)
        if kind == 'text' and roll < 0.5:
            return self.text_text(make)
        return '${%s}' % self.padded(make.make(kind, rng.choice([1, 2, 2, 3])))

    def padded(self, source):
        """The expression, sometimes with white space around."""
        return source if self.rng.random() < 0.9 else self.rng.choice([' %s', '%s ', '  %s  ', '\t%s']) % source

    def odd_text(self, make):
        """Anything: the edges of the literal rule, closed expressions."""
        rng = self.rng
        roll = rng.random()
        if roll < 0.4:
            self.use('literal rule')
            return rng.choice(literals.ODD_LITERALS)
        if roll < 0.75:
            return '${%s}' % make.closed(2)
        return '${%s}' % make.make(rng.choice(['num', 'text', 'mix', 'bool', 'word']))

    def word_text(self, make):
        """A word from text and expressions."""
        rng = self.rng
        words = [name for name, kind in self.args.items() if kind == 'word']
        roll = rng.random()
        if words and roll < 0.2:
            self.use('$(arg) in text')
            return rng.choice(['$(arg %s)', 'p_$(arg %s)', '$(arg  %s )']) % rng.choice(words)
        if roll < 0.4:
            return '%s_${%s}' % (rng.choice(literals.WORDS), make.make('int', 1))
        if roll < 0.5:
            return '${%s}${%s}' % (make.make('word', 1), make.make('word', 1))
        if roll < 0.6:
            return "'%s'" % rng.choice(literals.WORDS)
        return literals.word(rng)

    def text_text(self, make):
        rng = self.rng
        parts = [rng.choice(literals.WORDS)]
        for _ in range(rng.randrange(1, 3)):
            parts.append(rng.choice([' ', ', ', '', ' = ']))
            parts.append('${%s}' % make.make('any', 2) if rng.random() < 0.6 else rng.choice([literals.free_text(rng), 'US$5', '$ x', '\u00a0', '{}', '(x)']))
        return ''.join(parts)

    def shown(self, ctx):
        """Text of an attribute that is only printed."""
        rng = self.rng
        make = self.expressions(ctx)
        roll = rng.random()
        if roll < 0.42:
            return '${%s}' % self.padded(make.make(rng.choice(['any', 'any', 'any', 'num', 'num', 'int', 'word', 'text', 'mix', 'bool', 'flt', 'dict']), rng.choice([1, 2, 3])))
        if roll < 0.56:
            return '${%s}' % make.closed(2)
        if roll < 0.68:
            return ' '.join('${%s}' % make.make('num', 1) if rng.random() < 0.6 else rng.choice(['0', '1.50', '-2']) for _ in range(3))
        if roll < 0.78:
            return self.text_text(make)
        if roll < 0.82:
            return self.odd_text(make)
        if roll < 0.92:
            return self.special(ctx, make)
        names = [name for name in ctx.scope.visible_names() if isinstance(self.kinds[name], str) and self.kinds[name] not in ('fn', 'fmt')]
        return '${%s}' % rng.choice(names) if names else literals.free_text(rng)

    def special(self, ctx, make):
        """Substitutions, escapes and functions of the xacro namespace."""
        rng = self.rng
        choices = [self.escaped, self.substitution, self.evaluated, self.message, self.call_function, self.formatted, self.path_text, self.alias]
        return rng.choice(choices)(ctx, make)

    def escaped(self, ctx, make):
        self.use('$$ escape')
        return self.rng.choice(['$${1 + 1}', '$$$${2}', '$$${3 * 4}', "$$(optenv NOT_SET x)", 'a$${1}b${2}c', 'US$5 and $', '$ {x}', '$x $y', '$-', '$$$(cwd)' if False else '$$${1}'])

    def substitution(self, ctx, make):
        rng = self.rng
        names = list(self.args)
        roll = rng.random()
        if names and roll < 0.5:
            name = rng.choice(names)
            self.use('$(arg)')
            return rng.choice(['$(arg %s)', '[$(arg %s)]', '$(arg  %s)', '$(arg %s )', '$(arg ${"%s"})', '${len(xacro.arg("%s"))}', '$(arg %s)$(arg %s)', '${xacro.arg("%s")}']).replace('%s', name)
        if roll < 0.7:
            self.use('$(optenv)')
            return rng.choice(['$(optenv NOT_SET)', '$(optenv NOT_SET some words)', '$(optenv SITE other)', '[$(optenv SITE)]', '$(optenv NOT_SET  a   b )', '$(optenv ${"SITE"})'])
        if roll < 0.8:
            self.use('$(env)')
            return rng.choice(['$(env SITE)', 'in $(env SITE)', '$(env  SITE)', '$(env ${"SI" + "TE"})'])
        if roll < 0.9:
            return rng.choice(['$(cwd)', '$(cwd)/x', '$()', 'x$()y', '$(cwd)$(cwd)'])
        self.use('$(find)')
        return rng.choice(['$(find kit)', '$(find kit)/meshes', '$(find  other_pkg )', '$(find ${"k" + "it"})'])

    def evaluated(self, ctx, make):
        """`$(eval ...)`: no right bracket, arguments as names."""
        self.use('$(eval)')
        rng = self.rng
        names = [name for name, kind in self.args.items() if kind in ('int', 'idx')] or ['3']
        name = rng.choice(names)
        return rng.choice(['$(eval %s + 1)', '$(eval %s * 2.5)', '$(eval 7 // 2)', "$(eval 'x' if %s else 'y')", '$(eval [%s, 2][0])', '$(eval pi)', '$(eval %s == 3)',
                           '$(eval true and %s > -100)', "$(eval 'a' + 'b')", '$(eval ${1 + 1} * %s)', '$(eval -%s ** 2)', '$(eval 1 / 3)', '$(eval 1.5e-7)', '$(eval not %s)']).replace('%s', name)

    def message(self, ctx, make):
        self.use('xacro.message and the like')
        return '${xacro.%s}' % self.rng.choice(["message('a', 1)", "warning('careful')", "error('not fatal')", 'print_location()', "message('x', print_location=True)",
                                                 "warning('y', print_location=False)", "message()" if False else "message('')"])

    def call_function(self, ctx, make):
        names = [name for name in ctx.scope.visible_names() if self.kinds[name] == 'fn']
        if not names:
            return '${(%s)(%s)}' % (make.make('fn', 1), make.make('int', 1))
        self.use('function property')
        return '${%s(%s)}' % (self.rng.choice(names), make.make('int', 1))

    def formatted(self, ctx, make):
        names = [name for name in ctx.scope.visible_names() if self.kinds[name] == 'fmt']
        if not names:
            return '${%s}' % make.make('text', 2)
        self.use('str.format')
        name = self.rng.choice(names)
        return '${%s.format(%s)}' % (name, ', '.join(make.make(kind, 1) for kind in self.formats[name]))

    def path_text(self, ctx, make):
        self.use('xacro.abs_filename')
        return "${xacro.abs_filename('%s')}" % self.rng.choice(['part.xacro', '../x.stl', '/abs/x', 'meshes/${"a"}'[:7] + '.stl', './y'])

    def alias(self, ctx, make):
        """Walrus, mutation of a shared list, deprecated functions."""
        rng = self.rng
        lists = [name for name in ctx.scope.names if self.kinds[name] == 'ilist']
        if lists and rng.random() < 0.5:
            self.use('list mutation')
            return '${%s.%s}' % (rng.choice(lists), rng.choice(['append(7)', 'insert(0, 1)', 'extend([4, 5])', 'sort()', 'reverse()', 'append(2) or [1].pop()', 'index(9) if False else None']))
        dicts = [name for name in ctx.scope.names if self.kinds[name] == 'dict']
        if dicts and rng.random() < 0.5:
            self.use('dict mutation')
            return '${%s.%s}' % (rng.choice(dicts), rng.choice(['update(a=1)', "setdefault('n', 4)", "update(dict(z=0))", "pop('nope', 3)"]))
        if 'walrus' not in self.disabled and rng.random() < 0.3:
            self.use('walrus')
            return '${(i := %s) + i}' % make.make('int', 1)
        return '${%s}' % rng.choice(['range(3)', 'sorted([3, 1])', 'list(range(2, 5))', 'dotify(dict(a=1)).a', "abs_filename('f')"])

    def condition(self, ctx):
        """Text of a condition and its truth, None if that depends on names."""
        rng = self.rng
        roll = rng.random()
        if roll < 0.25:
            return rng.choice(TRUE), True
        if roll < 0.45:
            return rng.choice(FALSE), False
        if roll < 0.6:
            source = Expressions(rng, lambda kind: [], self.avoid).make('bool', 2)
            try:
                return '${%s}' % source, bool(eval(source, TRIAL))
            except Exception:
                return '${False}', False
        flags = [name for name, kind in self.args.items() if kind == 'bool']
        if flags and roll < 0.7:
            return '$(arg %s)' % rng.choice(flags), None
        kind = rng.choice(['bool', 'bool', 'bool', 'int', 'ilist', 'num', 'mix'])
        return '${%s}' % self.expressions(ctx).make(kind, 2), None
