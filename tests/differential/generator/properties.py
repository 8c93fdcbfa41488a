"""Statements about properties and blocks."""
from dataclasses import replace

from . import literals
from .scope import Scope
from .values import FORMATS, KINDS
from .xmltext import tag

FALSE_TEXTS = ['false', 'False', '0', '${False}', '${1 == 2}', '${0}']


class Properties:
    """Mixin of the generator."""

    def new_name(self, kind):
        """An unused name, its kind fixed for the whole program."""
        name = self.pool.pop() if self.pool else 'extra_%d' % len(self.kinds)
        self.kinds[name], self.ranks[name] = kind, len(self.ranks)
        return name

    def name_for(self, ctx, kind):
        """A new name, or now and then one that is known elsewhere and gets shadowed here."""
        known = [name for name, own in self.kinds.items() if own is kind or own == kind]
        known = [name for name in known if name not in self.reserved]
        if known and self.rng.random() < 0.3:
            name = self.rng.choice(known)
            self.use('name used again')
            return name
        return self.new_name(kind)

    def property_tag(self, attributes, children=None):
        """The tag, rarely with something that is ignored."""
        if children is None and self.rng.random() < 0.015:
            self.use('unknown attribute')
            attributes = attributes + [('note', 'x')]
        if children is None and self.rng.random() < 0.01:
            self.use('ignored children')
            children = '<ignored a="${nothing}"/>'
        return tag(self.rng, 'xacro:property', attributes, children)

    def any_property(self, ctx):
        """One of the ways to define a property."""
        rng = self.rng
        choices = [(8, self.plain_property), (3, self.eager_property), (2, self.default_property), (3, self.redefinition), (2, self.forward_property),
                   (1, self.victim), (1, self.computed_name), (1, self.format_property), (2, self.far_property), (2, self.yaml_property), (1, self.same_value)]
        return rng.choices([c for _, c in choices], [w for w, _ in choices])[0](ctx)

    def plain_property(self, ctx):
        self.use('property')
        kind = self.rng.choice(KINDS)
        name = self.name_for(ctx, kind)
        value = self.stored(kind, ctx, self.ranks[name])
        attributes = [('name', name), ('value', value)]
        if self.rng.random() < 0.05:
            attributes.append(('scope', self.rng.choice(['local', 'here', ''])))
        if self.rng.random() < 0.05:
            attributes.append(('lazy_eval', self.rng.choice(['true', 'True', '1', '${True}'])))
        if self.rng.random() < 0.03:
            attributes.append(('remove', self.rng.choice(FALSE_TEXTS)))
        ctx.scope.define(name)
        return [self.property_tag(attributes)]

    def eager_property(self, ctx):
        """`lazy_eval="false"`, also with itself in its value."""
        self.use('lazy_eval="false"')
        own = [name for name in ctx.scope.names if self.kinds[name] in ('int', 'num', 'word', 'ilist', 'text')]
        if own and self.rng.random() < 0.5:
            name = self.rng.choice(own)
            grown = {'int': '${%s + 1}', 'num': '${%s * 2}', 'word': '${%s}_x', 'ilist': '${%s + [1]}', 'text': '${%s} + ${%s}'}[self.kinds[name]]
            value = grown.replace('%s', name)
        else:
            kind = self.rng.choice(KINDS)
            name = self.name_for(ctx, kind)
            value = self.stored(kind, ctx, eager=True)
        ctx.scope.define(name)
        return [self.property_tag([('name', name), ('value', value), ('lazy_eval', self.rng.choice(FALSE_TEXTS))])]

    def default_property(self, ctx):
        self.use('default=')
        visible = [name for name in ctx.scope.visible_names() if isinstance(self.kinds[name], str) and self.kinds[name] != 'fmt']
        name = self.rng.choice(visible) if visible and self.rng.random() < 0.5 else self.name_for(ctx, self.rng.choice(KINDS))
        value = self.stored(self.kinds[name], ctx, self.ranks[name])
        if name not in ctx.scope.visible_names():
            ctx.scope.define(name)
        return [self.property_tag([('name', name), ('default', value)])]

    def redefinition(self, ctx):
        own = [name for name, stays in ctx.scope.names.items() if isinstance(self.kinds[name], str) and self.kinds[name] not in ('fmt',) and stays]
        if not own:
            return self.plain_property(ctx)
        self.use('redefinition')
        name = self.rng.choice(own)
        return [self.property_tag([('name', name), ('value', self.stored(self.kinds[name], ctx, self.ranks[name]))])]

    def forward_property(self, ctx):
        """A lazy property whose value names one that is defined later."""
        self.use('forward reference')
        kind = self.rng.choice(['int', 'num', 'word'])
        later, sooner = self.new_name(kind), self.new_name(kind)
        value = {'int': '${%s + %d}', 'num': '${%s * 2 - %d}', 'word': "${%s + 'w%d'}"}[kind] % (later, self.rng.randrange(9))
        nodes = [self.property_tag([('name', sooner), ('value', value)])]
        for _ in range(self.rng.randrange(3)):
            nodes += self.statement(ctx)
        nodes.append(self.property_tag([('name', later), ('value', self.stored(kind, ctx, self.ranks[later]))]))
        ctx.scope.define(later)
        ctx.scope.define(sooner)
        return nodes

    def victim(self, ctx):
        """Define, show, remove, define again with default=."""
        self.use('remove=')
        kind = self.rng.choice(['int', 'word', 'ilist'])
        name = self.new_name(kind)
        self.reserved.add(name)
        nodes = [self.property_tag([('name', name), ('value', self.stored(kind, ctx, self.ranks[name]))])]
        if self.rng.random() < 0.6:
            nodes.append(tag(self.rng, 'seen', [('v', '${%s}' % name)]))
        if self.rng.random() < 0.3:
            nodes += self.statement(ctx)
        nodes.append(self.property_tag([('name', name), ('remove', self.rng.choice(['true', 'True', '1', '${True}', '${1 == 1}']))]))
        if self.rng.random() < 0.6:
            nodes.append(self.property_tag([('name', name), ('default', self.stored(kind, ctx, self.ranks[name]))]))
            nodes.append(tag(self.rng, 'seen', [('again', '${%s}' % name)]))
        return nodes

    def computed_name(self, ctx):
        self.use('computed property name')
        kind = self.rng.choice(['int', 'flt', 'word'])
        name = self.new_name(kind)
        cut = self.rng.randrange(len(name) + 1)
        text = self.rng.choice(["${'%s' + '%s'}" % (name[:cut], name[cut:]), "%s${'%s'}" % (name[:cut], name[cut:]), "${'%s'}" % name])
        value = self.stored(kind, ctx, self.ranks[name])
        ctx.scope.define(name)
        return [self.property_tag([('name', text), ('value', value)])]

    def format_property(self, ctx):
        """Text with braces, for str.format."""
        text, kinds = self.rng.choice(FORMATS)
        name = self.new_name('fmt')
        self.formats[name] = kinds
        ctx.scope.define(name)
        return [self.property_tag([('name', name), ('value', text)])]

    def same_value(self, ctx):
        """Another name for a value: lists and dictionaries are shared."""
        names = [name for name in ctx.scope.visible_names(lasting_only=True) if self.kinds[name] in ('ilist', 'dict', 'fn', 'any', 'wlist')]
        if not names:
            return self.plain_property(ctx)
        old = self.rng.choice(names)
        name = self.new_name(self.kinds[old])
        ctx.scope.define(name)
        return [self.property_tag([('name', name), ('value', '${%s}' % old)])]

    def far_property(self, ctx):
        """scope="global", and scope="parent" inside macros."""
        kind = self.rng.choice(KINDS)
        if ctx.body is None and ctx.scope.namespace and self.rng.random() < 0.5:
            self.use('scope="parent" in a namespace')
            name = self.new_name(kind)
            value = self.stored(kind, ctx, eager=True)
            ctx.scope.parent.define(name)
            return [self.property_tag([('name', name), ('value', value), ('scope', 'parent')])]
        if ctx.body is None or self.rng.random() < 0.4:
            self.use('scope="global"')
            name = self.name_for(ctx, kind)
            value = self.stored(kind, ctx, eager=True)
            if ctx.certain:
                (ctx.scope.top().define if ctx.body is None else ctx.scope.define)(name)
                if ctx.body:
                    ctx.body.leaves_global.append(name)
            return [self.property_tag([('name', name), ('value', value), ('scope', 'global')])]
        self.use('scope="parent"')
        name = self.new_name(kind)
        value = self.stored(kind, ctx, eager=True)
        if ctx.certain:
            ctx.scope.define(name)
            ctx.body.leaves.append(name)
        return [self.property_tag([('name', name), ('value', value), ('scope', 'parent')])]

    def yaml_property(self, ctx):
        """A property that loads a YAML file, when it is first used."""
        schema = self.rng.choice(self.schemas)
        name = self.name_for(ctx, schema)
        self.use('property from YAML')
        eager = [('lazy_eval', 'false')] if self.rng.random() < 0.15 else []
        ctx.scope.define(name)
        return [self.property_tag([('name', name), ('value', '${%s}' % self.yaml_source(ctx, schema))] + eager)]

    # --- blocks

    def block_property(self, ctx):
        """A property with content, evaluated wherever it is inserted."""
        self.use('block property')
        name = self.new_block_name()
        inner = self.content(self.inserted_later(ctx), self.rng.randrange(1, 4), self.simple_statement)
        attributes = [('name', name)]
        if ctx.body and self.rng.random() < 0.2:
            self.use('block with scope=')
            attributes.append(('scope', self.rng.choice(['parent', 'global'])))
            return [tag(self.rng, 'xacro:property', attributes, inner)]
        ctx.scope.blocks[name] = True
        return [tag(self.rng, 'xacro:property', attributes, inner)]

    def inserted_later(self, ctx):
        """The context of content that is evaluated later, in scopes inside this one."""
        return replace(ctx, scope=Scope(ctx.scope, boundary=True), certain=False, depth=ctx.depth + 1, folder=None)

    def new_block_name(self):
        self.block_names.append('%s_block%d' % (self.rng.choice(literals.WORDS), len(self.block_names)))
        return self.block_names[-1]

    def insert_block(self, ctx):
        names = ctx.scope.visible_blocks()
        if not names:
            return self.block_property(ctx)
        self.use('insert_block')
        children = '<ignored/>' if self.rng.random() < 0.02 else None
        return [tag(self.rng, 'xacro:insert_block', [('name', self.rng.choice(names))], children)]
