"""Statements about macros: definitions, calls, recursion."""
from dataclasses import replace

from . import literals
from .scope import Context, Macro, Param, Scope
from .values import KINDS
from .xmltext import RAW_LINE_END, RAW_TAB, layout, tag


class Macros:
    """Mixin of the generator."""

    def macro_name(self):
        self.macro_count += 1
        name = '%s_m%d' % (self.rng.choice(literals.WORDS), self.macro_count)
        if self.rng.random() < 0.08:
            self.use('macro name with dash')
            name = name.replace('_', '-')
        return name

    def macro_tag(self, macro, params, body):
        """The definition; `params` is the finished text."""
        attributes = [('name', macro.name)]
        if params or self.rng.random() < 0.2:
            attributes.append(('params', params))
        if self.rng.random() < 0.03:
            self.use('xmlns on macro')
            attributes.append(('xmlns:mm', 'urn:m%d' % self.rng.randrange(2)))
        return tag(self.rng, 'xacro:macro', attributes, body)

    def macro(self, ctx):
        """Define a macro; its body may use whatever lasts."""
        self.use('macro')
        rng = self.rng
        macro = Macro(self.macro_name())
        scope = Scope(ctx.scope, boundary=True)
        body_ctx = Context(scope, None, ctx.depth + 1, True, macro, ctx.prefixes, ctx.nesting)
        for _ in range(rng.choice([0, 1, 1, 2, 2, 3, 4])):
            param = self.param(ctx)
            if param.name not in [p.name for p in macro.params]:
                macro.params.append(param)
                scope.define(param.name)
        for _ in range(rng.choice([0, 0, 0, 0, 1, 1, 2])):
            self.use('block parameter')
            macro.blocks.append(('%s_%d' % (rng.choice(literals.WORDS), len(macro.blocks)), rng.random() < 0.45))
        if rng.random() < 0.12:
            self.use('dynamic scoping')
            needed = self.new_name(rng.choice(['int', 'word', 'num', 'ilist']))
            macro.requires.append(needed)
            scope.define(needed)
        body = self.macro_body(body_ctx, macro)
        ctx.scope.macros[macro.name] = macro
        return [self.macro_tag(macro, self.params_text(macro), body)]

    def param(self, ctx):
        """A parameter with or without default."""
        rng = self.rng
        kind = rng.choice(KINDS) if rng.random() < 0.95 else rng.choice(self.schemas)
        name = self.name_for(ctx, kind)
        roll = rng.random()
        if roll < 0.4 or not isinstance(kind, str):
            return Param(name, kind)
        if roll < 0.52:
            self.use('param:=^')
            return Param(name, kind, '^')
        default = self.default_text(kind, ctx)
        if default is None:
            return Param(name, kind)
        if roll < 0.66:
            self.use('param:=^|default')
            return Param(name, kind, '^|' + default, True)
        self.use('param:=default')
        return Param(name, kind, default, True)

    def default_text(self, kind, ctx):
        """Default as written in `params`: the quotes and blanks matter there."""
        rng = self.rng
        roll = rng.random()
        if roll < 0.35 and kind in ('int', 'idx', 'flt', 'num', 'bool', 'word', 'any'):
            simple = {'int': ['0', '-7', '12', '0x' if False else '08'], 'idx': ['0', '3'], 'flt': ['0.5', '1.50', '2e1'], 'num': ['-1.5', '3', '1e3'],
                      'bool': ['true', 'False'], 'word': ['plain', "'quoted'", 'a_b', "'with_w'", 'x-y'],
                      'any': ["''", "'1 2 3'", '"dq"', "'it is'", '1,2', "a'b c'd", "'5'", '$', 'a"b"c', '1e400', 'nan', "'x'y", '"a b" ' .strip(), 'x=y', ':', 'a:=b']}
            return rng.choice(simple[kind])
        words = [name for name, own in self.args.items() if own == kind and kind in ('int', 'word', 'flt', 'idx')]
        if words and roll < 0.45:
            self.use('param:=$(arg)')
            return '$(arg %s)' % rng.choice(words)
        if kind == 'word' and roll < 0.5:
            source = self.expressions(ctx, lasting=True).make('idx', 1)
            return "w_${%s}" % source.replace(' ', '') if not set(source) & set('\'"\n') and ' if ' not in source and ' or ' not in source and 'lambda' not in source else None
        if kind == 'text' and roll < 0.5:
            return "'%s'" % rng.choice(['some words', 'a  b', 'x: y', '(z)', 'é f'])
        source = self.expressions(ctx, lasting=True).make(kind, 2)
        return '${%s}' % source

    def params_text(self, macro):
        """The `params` attribute in its many spellings."""
        rng = self.rng
        items = []
        for param in macro.params:
            sign = ':=' if rng.random() < 0.8 else '='
            if rng.random() < 0.05:
                self.use('blanks around :=')
                sign = rng.choice([' ' + sign, sign + ' ', ' %s ' % sign])
            items.append(param.name if param.default is None else param.name + sign + param.default)
        blocks = [('**' if multi else '*') + name for name, multi in macro.blocks]
        for block in blocks:  # their order counts, their place among the others does not
            items.append(block)
        if blocks and rng.random() < 0.3 and len(blocks) == 1:
            items.insert(rng.randrange(len(items)), items.pop())
        text = items[0] if items else ''
        for item in items[1:]:
            text += rng.choice([' ', ' ', ' ', ' ', '  ', RAW_LINE_END, RAW_TAB, ' ' + RAW_LINE_END + '  ']) + item
        return text + rng.choice(['', '', '', ' ']) if items and rng.random() < 0.9 else text

    def macro_body(self, ctx, macro):
        """Statements of a body; they use the blocks and most of the parameters."""
        rng = self.rng
        if not macro.blocks and rng.random() < 0.12:
            self.use('macro with one element')
            macro.single = True
            return layout(rng, [self.element(ctx, children=False)], ctx.depth, self.use) if rng.random() < 0.5 else self.element(ctx, children=False)
        nodes = [self.show_names(ctx, [p.name for p in macro.params if isinstance(p.kind, str)] + macro.requires)]
        for _ in range(rng.randrange(1, 5)):
            nodes += self.statement(ctx)
        for name, multi in macro.blocks:
            for _ in range(rng.choice([0, 1, 1, 1, 2])):
                where = tag(rng, 'xacro:insert_block', [('name', name)])
                node = where if rng.random() < 0.6 else tag(rng, 'holder', [], layout(rng, [where], ctx.depth + 1, self.use))
                nodes.insert(rng.randrange(len(nodes) + 1), node)
        macro.cost += 1 + sum(len(node) for node in nodes) // 120
        if rng.random() < 0.03:
            return rng.choice(['only text ${1 + 1}', ' ', ''])
        return layout(rng, nodes, ctx.depth, self.use)

    def show_names(self, ctx, names):
        """An element that prints names, also in lists, where their type shows."""
        shown = []
        for i, name in enumerate(names[:5]):
            if self.kinds[name] in ('fn', 'fmt'):
                continue
            shown.append(('p%d' % i, self.rng.choice(['${%s}', '${%s}', '${[%s]}', 'x${%s}y']) % name))
        return tag(self.rng, 'show', shown)

    # --- calls

    def call(self, ctx):
        """Call a macro by one of the ways to do so."""
        usable = [entry for entry in ctx.scope.visible_macros() if entry[1].cost < self.call_budget(ctx) and entry[1] is not ctx.body]
        if not usable:
            return self.macro(ctx) if self.budget > 6 else [self.element(ctx)]
        name, macro, target = self.rng.choice(usable)
        return self.call_of(ctx, name, macro, target)

    def call_budget(self, ctx):
        return 40 if ctx.body is None else 14

    def call_of(self, ctx, name, macro, target):
        rng = self.rng
        self.use('macro call' if '.' not in name else 'call into a namespace')
        if ctx.body:
            ctx.body.cost += macro.cost
        nodes = self.provide(ctx, macro)
        attributes = self.arguments(ctx, macro)
        children = self.call_content(ctx, macro)
        roll = rng.random()
        if roll < 0.1:
            self.use('xacro:call')
            cut = rng.randrange(len(name) + 1)
            text = rng.choice([name, "${'%s'}" % name, "%s${'%s'}" % (name[:cut], name[cut:])])
            nodes.append(tag(rng, 'xacro:call', attributes + [('macro', text)], children))
        elif roll < 0.14:
            self.use('xacro:element as a call')
            nodes.append(tag(rng, 'xacro:element', attributes + [('xacro:name', rng.choice(['xacro:%s', "xacro:${'%s'}"]) % name)], children))
        else:
            nodes.append(tag(rng, 'xacro:' + name, attributes, children))
        if ctx.certain:
            for left in macro.leaves:
                (target or ctx.scope).define(left)
            for left in macro.leaves_global:
                (ctx.scope.top() if ctx.body is None else ctx.scope).define(left)
                if ctx.body:
                    ctx.body.leaves_global.append(left)
        return nodes

    def provide(self, ctx, macro):
        """Properties for what the macro reads from its caller."""
        nodes = []
        visible = ctx.scope.visible_names()
        wanted = macro.requires + [p.name for p in macro.params if p.default == '^' and self.rng.random() < 0.4]
        for name in wanted:
            if name not in visible:
                nodes.append(self.property_tag([('name', name), ('value', self.stored(self.kinds[name], ctx, self.ranks[name]))]))
                ctx.scope.define(name)
        return nodes

    def arguments(self, ctx, macro):
        visible = ctx.scope.visible_names()
        attributes = []
        for param in macro.params:
            if param.default is None or (param.default == '^' and param.name not in visible) or self.rng.random() < 0.35:
                attributes.append((param.name, self.stored(param.kind, ctx, eager=True)))
            elif param.default.startswith('^'):
                self.use('forwarded')
        return attributes

    def call_content(self, ctx, macro):
        """The blocks, and things among them that do not count."""
        rng = self.rng
        if not macro.blocks:
            if rng.random() < 0.06:
                self.use('call with ignored content')
                return rng.choice(['', ' ', '<!-- nothing -->', 'words', '<xacro:if value="0"><x/></xacro:if>', '\n', '${1 + 1}'])
            return None
        inner = ctx.deeper()
        nodes = []
        for _, multi in macro.blocks:
            nodes += self.block_argument(inner, multi)
            if rng.random() < 0.06:
                nodes.append(rng.choice(['<xacro:if value="false"><x a="${nothing}"/></xacro:if>', '<!-- between -->', 'text']))
        return layout(rng, nodes, inner.depth, self.use)

    def block_argument(self, ctx, multi):
        """Nodes that leave exactly one element."""
        rng = self.rng
        roll = rng.random()
        singles = [entry for entry in ctx.scope.visible_macros() if entry[1].single]
        if roll < 0.12:
            self.use('condition around a block')
            kept, lost = [self.block_element(ctx, multi)], [self.element(ctx, children=False)]
            return ['<xacro:if value="1">%s</xacro:if>' % kept[0]] if rng.random() < 0.5 else \
                ['<xacro:unless value="${True}">%s</xacro:unless>' % lost[0], '<xacro:unless value="0">%s</xacro:unless>' % kept[0]]
        if singles and roll < 0.25:
            self.use('call as a block')
            return self.call_of(ctx, *rng.choice(singles))
        if roll < 0.3:
            self.use('property among blocks')
            return self.plain_property(ctx) + [self.block_element(ctx, multi)]
        if ctx.scope.visible_blocks() and roll < 0.36 and multi:
            self.use('insert_block in a block')
            return [tag(rng, 'wrap', [], ''.join(self.insert_block(ctx)))]
        return [self.block_element(ctx, multi)]

    def block_element(self, ctx, multi):
        if not multi:
            return self.element(ctx)
        nodes = [self.element(ctx, children=False) for _ in range(self.rng.randrange(4))]
        return tag(self.rng, self.rng.choice(['wrap', 'origin', 'b']), [('lost', '${1 + 1}')][:self.rng.randrange(2)],
                   layout(self.rng, nodes, ctx.depth + 1, self.use) if nodes else self.rng.choice([None, '', 'words ${2}', '<!-- c -->']))

    # --- macros that call themselves

    def recursion(self, ctx):
        rng = self.rng
        if rng.random() < 0.1:
            self.use('line feed in params')  # by a character reference: it ends the list after a default
            name = self.macro_name()
            return [tag(rng, 'xacro:macro', [('name', name), ('params', 'first:=%d second:=2\nlost' % rng.randrange(9))], '<y v="${first}"/>'), '<xacro:%s/>' % name]
        self.use('recursion')
        macro = Macro(self.macro_name(), redefinable=False)
        return rng.choice([self.countdown, self.over_list, self.tree])(ctx, macro)

    def countdown(self, ctx, macro):
        rng = self.rng
        name = self.new_name('idx')
        text = '<step n="${%s}" %s/>' % (name, rng.choice(['', 'sq="${%s * %s}"' % (name, name), 'left="${[%s] * %s}"' % (name, name)]))
        again = '<xacro:%s %s="${%s - 1}"/>' % (macro.name, name, name)
        body = [text, again] if rng.random() < 0.5 else [again, text]
        test = rng.choice(['<xacro:if value="${%s > 0}">%s</xacro:if>', '<xacro:unless value="${%s == 0}">%s</xacro:unless>', '<xacro:if value="${%s}">%s</xacro:if>'])
        definition = self.macro_tag(macro, name, (test % (name, '\n'.join(body))).replace('> 0', '&gt; 0'))
        return [definition, tag(rng, 'xacro:' + macro.name, [(name, self.stored('idx', ctx, eager=True))])]

    def over_list(self, ctx, macro):
        rng = self.rng
        name = self.new_name('mix')
        self.reserved.add(name)
        rest = rng.choice(['${%s[1:]}', '${list(%s)[1:]}']) % name
        inner = '<item v="${%s[0]}" rest="${len(%s)}"/>\n<xacro:%s %s="%s"/>' % (name, name, macro.name, name, rest)
        if rng.random() < 0.4:
            inner = '<nest v="${%s[0]}">\n<xacro:%s %s="%s"/></nest>' % (name, macro.name, name, rest)
        definition = self.macro_tag(macro, name, '\n<xacro:if value="${%s}">\n%s\n</xacro:if>' % (rng.choice([name, 'len(%s)' % name, 'len(%s) > 0' % name, '%s != [] and %s != ()' % (name, name)]).replace('>', '&gt;'), inner))
        kind = rng.choice(['ilist', 'wlist'])
        return [definition, tag(rng, 'xacro:' + macro.name, [(name, '${%s}' % self.expressions(ctx).make(kind, 2))])]

    def tree(self, ctx, macro):
        rng = self.rng
        level, label = self.new_name('idx'), self.new_name('word')
        body = ('<node name="${%(label)s}" level="${%(level)s}">\n<xacro:if value="${%(level)s}">'
                '<xacro:%(macro)s %(level)s="${%(level)s - 1}" %(label)s="${%(label)s}_l"/>\n<xacro:%(macro)s %(level)s="${%(level)s-1}" %(label)s="${%(label)s + \'_r\'}"/>'
                '</xacro:if></node>') % {'label': label, 'level': level, 'macro': macro.name}
        params = '%s %s:=root' % (level, label) if rng.random() < 0.5 else '%s:=root %s' % (label, level)
        return [self.macro_tag(macro, params, body), tag(rng, 'xacro:' + macro.name, [(level, str(rng.randrange(1, 4)))])]

    def redefine_macro(self, ctx):
        """A new body for a macro of this scope, with the same interface."""
        own = [macro for macro in ctx.scope.macros.values() if macro.redefinable and not macro.leaves and not macro.leaves_global]
        if not own:
            return self.macro(ctx)
        self.use('macro redefined')
        macro = self.rng.choice(own)
        scope = Scope(ctx.scope, boundary=True)
        for param in macro.params:
            scope.define(param.name)
        inner = replace(Context(scope, None, ctx.depth + 1, False, macro, ctx.prefixes, ctx.nesting))
        body = self.element(inner, children=False)
        return [self.macro_tag(macro, self.params_text(macro), body)]
