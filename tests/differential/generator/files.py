"""Statements about other files: includes, YAML, packages."""
import fnmatch
import posixpath
from dataclasses import replace

from . import literals
from .scope import Scope
from .xmltext import layout, tag

URIS = ['http://www.ros.org/wiki/xacro', 'http://www.ros.org/wiki/xacro', 'http://ros.org/wiki/xacro', 'http://wiki.ros.org/xacro', 'urn:x']
FOLDERS = ['', 'sub', 'sub/deep', 'lib', 'prefix/share/kit/urdf']


class Files:
    """Mixin of the generator."""

    # --- YAML

    def yaml_source(self, ctx, schema):
        """An expression that loads a document of `schema`."""
        name = self.yaml_names[id(schema)]
        self.use('load_yaml')
        path = self.rng.choice(["'%s'", '"%s"', "'./%s'"]) % name
        roll = self.rng.random()
        if roll < 0.15:
            path = "'$(find kit)/urdf/%s'" % name
        elif roll < 0.25:
            path = "'$(cwd)/%s'" % name
        elif roll < 0.3:
            path = "xacro.abs_filename('$(cwd)/%s')" % name
        elif roll < 0.35:
            path = "'%s' + '%s'" % (name[:2], name[2:])
        function = 'xacro.load_yaml' if self.rng.random() < 0.95 else 'load_yaml'
        return '%s(%s)' % (function, path)

    def show_yaml(self, ctx):
        """An element that prints a document or parts of it."""
        schema = self.rng.choice(self.schemas)
        names = [name for name in ctx.scope.visible_names() if self.kinds[name] is schema]
        if not names:
            return self.yaml_property(ctx)
        self.use('YAML printed')
        name = self.rng.choice(names)
        forms = ['${%s}' % name, '${list(%s.keys())}' % name, '${len(%s)}' % name, "${'%s' in %s}" % (schema.entries[0][0], name),
                 '${list(%s.items())[0]}' % name, "${%s.get('nope', 1)}" % name, '${[k for k in %s]}' % name, '${python.sorted(%s)}' % name]
        forms += ['${%s}' % source for kind in ('int', 'flt', 'word', 'any', 'any', 'ilist', 'wlist') for source in self.yaml_paths(name, schema, kind)]
        shown = [('y%d' % i, self.rng.choice(forms)) for i in range(self.rng.randrange(1, 5))]
        return [tag(self.rng, 'yaml', shown)]

    # --- includes

    def include(self, ctx):
        rng = self.rng
        if ctx.folder is None or ctx.nesting >= 3:
            return self.include_beside(ctx)
        choices = [(4, self.include_new), (3, self.include_space), (1, self.include_glob), (1, self.include_missing), (1, self.include_beside), (1, self.include_again),
                   (1, self.include_itself), (1, self.include_no_match)]
        return rng.choices([c for _, c in choices], [w for w, _ in choices])[0](ctx)

    def include_tag(self, attributes, children=None):
        if children is None and self.rng.random() < 0.02:
            self.use('children of an include')
            children = '<child a="${nothing}"/>'
        if self.rng.random() < 0.02:
            self.use('unknown attribute')
            attributes = attributes + [('note', 'x')]
        return tag(self.rng, 'xacro:include', attributes, children)

    def path_to(self, ctx, target):
        """A way to write the path of `target` in a file of `ctx.folder`."""
        rng = self.rng
        relative = posixpath.relpath('/' + target, '/' + ctx.folder)
        roll = rng.random()
        if roll < 0.55:
            return relative
        if roll < 0.63:
            return './' + relative
        if roll < 0.7:
            return '$(cwd)/' + target
        if roll < 0.76:
            return '${xacro.abs_filename("%s")}' % ('$(cwd)/' + target)
        if roll < 0.82:
            return '$(find kit)/../../../' + target
        if roll < 0.9:
            return "${'%s'}%s" % (relative[:3], relative[3:])
        return relative if '/' not in relative else relative.replace('/', '//', 1)

    def new_file(self, ctx, folder=None, name=None):
        """Path of a file that does not exist yet."""
        if folder is None:
            folder = self.rng.choice(FOLDERS)
        self.file_count += 1
        name = name or 'f%d_%s.xacro' % (self.file_count, self.rng.choice(literals.WORDS))
        return posixpath.join(folder, name)

    def write_file(self, path, ctx, count, root='robot', only=None):
        """Generate an included file and keep its text; `ctx` is the scope that it runs in."""
        rng = self.rng
        self.files[path] = ''  # its place is taken while it is written
        folder = posixpath.dirname(path)
        uri = rng.choice(URIS)
        attributes = [('xmlns:xacro', uri)]
        prefixes = ()
        if rng.random() < 0.15:
            self.use('xmlns on included root')
            prefix = rng.choice(['gz', 'sensor', 'mm'])
            prefixes = (prefix,)
            attributes.append(('xmlns:' + prefix, 'urn:%s%s' % (prefix, rng.choice(['', '', '2']))))
        if rng.random() < 0.15:
            attributes.append(('name', self.shown(ctx)))
        inner = replace(ctx, folder=folder, depth=1, prefixes=prefixes, nesting=ctx.nesting + 1)
        body = self.content(inner, count, only)
        text = self.prolog(path) + tag(rng, root, attributes, body) + rng.choice(['\n', '', '\n<!-- end -->\n', '\n<?end?>\n'])
        self.files[path] = text
        return path

    def prolog(self, path):
        """What may stand before the root element."""
        rng = self.rng
        text = rng.choice(['<?xml version="1.0"?>\n', '<?xml version="1.0" encoding="UTF-8"?>\n', "<?xml version='1.0' encoding='utf-8' standalone='yes' ?>", '', '', '<?xml version="1.0" ?>'])
        if 'encodings' not in self.disabled and rng.random() < 0.01:
            self.use('encoding that is not used')  # the reference reads UTF-8, whatever it says
            text = '<?xml version="1.0" encoding="%s"?>' % rng.choice(['ISO-8859-1', 'ascii', 'UTF-16', 'windows-1252'])
        if rng.random() < 0.15:
            text += rng.choice(['<!-- head -->\n', '<?pi ${1}?>\n', '<!--one--><!--two-->', '\n\n'])
        return text

    def include_new(self, ctx):
        """A plain include of a file of its own: runs in the current scope."""
        self.use('include')
        path = self.new_file(ctx)
        self.write_file(path, ctx, self.rng.randrange(1, 6), self.rng.choice(['robot', 'robot', 'library', 'x']))
        attributes = [('filename', self.path_to(ctx, path))]
        if self.rng.random() < 0.1:
            attributes.append(('optional', self.rng.choice(['true', 'false', '1', 'False'])))
        if self.rng.random() < 0.03:
            attributes.append(('ns', ''))
        return [self.include_tag(attributes)]

    def include_space(self, ctx):
        """An include with `ns`, then something from inside."""
        self.use('include with ns')
        rng = self.rng
        space = Scope(ctx.scope, namespace=True)
        prefix = 'ns%d' % self.space_count
        self.space_count += 1
        if ctx.nesting:
            self.use('namespace in an included file')
        path = self.new_file(ctx)
        inner = replace(ctx, scope=space, body=None)
        self.write_file(path, inner, rng.randrange(2, 6), only=self.library_statement)
        ctx.scope.spaces[prefix] = space
        text = rng.choice([prefix, prefix, prefix, "${'%s'}" % prefix, "n${'%s'}" % prefix[1:]])
        nodes = [self.include_tag([('filename', self.path_to(ctx, path)), ('ns', text)])]
        if space.names and rng.random() < 0.7:
            names = [name for name in space.names if isinstance(self.kinds[name], str) and self.kinds[name] not in ('fn', 'fmt')]
            if names:
                self.use('name from a namespace')
                nodes.append(tag(rng, 'from', [('n%d' % i, '${%s.%s}' % (prefix, name)) for i, name in enumerate(names[:3])]))
        inside = [entry for entry in ctx.scope.visible_macros() if entry[0].startswith(prefix + '.') and entry[1].cost < self.call_budget(ctx)]
        if inside and rng.random() < 0.7:
            nodes += self.call_of(ctx, *rng.choice(inside))
        if rng.random() < 0.1:
            self.use('global symbol through a namespace')
            nodes.append(tag(rng, 'from', [('pi', '${%s.pi}' % prefix)]))
        return nodes

    def include_glob(self, ctx):
        """Several files through one pattern, in code-point order."""
        self.use('include with glob')
        rng = self.rng
        folder = posixpath.join(rng.choice(FOLDERS[:4]), 'glob%d' % self.file_count)
        self.file_count += 1
        names = rng.sample(['a.xacro', 'b.xacro', 'B.xacro', 'a10.xacro', 'a9.xacro', '_x.xacro', 'é.xacro', '.hidden.xacro', 'b.txt', 'c d.xacro', 'a-b.xacro'], rng.randrange(1, 5))
        pattern = rng.choice(['*.xacro', '*.xacro', '*', 'a*.xacro', '[ab].xacro', '?.xacro', '[!a]*.xacro', '*[0-9].xacro', 'a*o', '[a-c]*'])
        matched = sorted(n for n in names if fnmatch.fnmatchcase(n, pattern) and not (n.startswith('.') and not pattern.startswith('.')))
        for name in names:
            path = posixpath.join(folder, name)
            if name not in matched:
                self.files[path] = '<robot xmlns:xacro="urn:x"><not_included a="${nothing}"/></robot>'
        for name in matched:
            self.write_file(posixpath.join(folder, name), ctx, rng.randrange(1, 3), only=self.simple_statement)
        relative = posixpath.relpath('/' + folder, '/' + ctx.folder)
        return [self.include_tag([('filename', relative + '/' + pattern)])]

    def include_no_match(self, ctx):
        self.use('glob without a match')
        return [self.include_tag([('filename', self.rng.choice(['none/*.xacro', 'no_such_?.xacro', 'x[0-9]y.xacro', '$(cwd)/nowhere/*']))])]

    def include_missing(self, ctx):
        """Optional includes of nothing, and of a file with a missing one inside."""
        rng = self.rng
        optional = rng.choice(['true', '1', 'True', ' 1'])
        if ctx.nesting == 0 and ctx.folder == '' and ctx.body is None and rng.random() < 0.4:
            self.use('missing file inside an optional include')
            path = self.new_file(ctx, '')
            name = self.new_name('int')
            self.files[path] = ('<robot xmlns:xacro="urn:x"><lost/><xacro:property name="%s" value="5"/>\n<xacro:include filename="gone.xacro"/><never a="${nothing}"/></robot>' % name)
            if ctx.certain:
                ctx.scope.define(name)
            return [self.include_tag([('filename', path), ('optional', optional)])]
        self.use('optional include of nothing')
        return [self.include_tag([('filename', rng.choice(['gone.xacro', 'no/such/file.xacro', '../nowhere.xacro', '$(cwd)/gone'])), ('optional', optional)])]

    def include_beside(self, ctx):
        """A file that exists in every folder: the current one decides."""
        self.use('include of a file beside the current one')
        ctx.scope.define('found')
        return [self.include_tag([('filename', self.rng.choice(['part.xacro', './part.xacro', "${'part'}.xacro"]))])]

    def include_again(self, ctx):
        """The same file twice."""
        self.use('include twice')
        path = self.new_file(ctx)
        mark = Scope(ctx.scope)
        self.write_file(path, replace(ctx, scope=mark, certain=False), self.rng.randrange(1, 3), only=self.simple_statement)
        return [self.include_tag([('filename', self.path_to(ctx, path))]) for _ in range(2)]

    def include_itself(self, ctx):
        """A file that includes itself a few times."""
        self.use('file that includes itself')
        path = self.new_file(ctx)
        name = self.new_name('int')
        self.reserved.add(name)
        self.files[path] = ('<robot xmlns:xacro="urn:x">\n<xacro:property name="%(n)s" value="${%(n)s - 1}" lazy_eval="false"/>\n<round n="${%(n)s}"/>\n'
                            '<xacro:if value="${%(n)s > 0}"><xacro:include filename="%(f)s"/></xacro:if>\n</robot>') % {'n': name, 'f': posixpath.basename(path)}
        return [self.property_tag([('name', name), ('value', str(self.rng.randrange(1, 4)))]), self.include_tag([('filename', self.path_to(ctx, path))])]

    # --- what every folder has

    def shared_files(self):
        """The files that every folder holds, with other values in each."""
        folders = sorted({posixpath.dirname(path) for path in self.files} | {'', 'prefix/share/kit/urdf'})
        for folder in folders:
            label = folder.replace('/', '_') or 'top'
            self.files[posixpath.join(folder, 'part.xacro')] = (
                '<robot xmlns:xacro="urn:x"><part in="%s"/>\n<xacro:property name="found" value="in_%s"/></robot>' % (folder, label))
            for schema in self.schemas:
                self.files[posixpath.join(folder, self.yaml_names[id(schema)])] = self.yaml_writer.document(schema)
        for package in ('kit', 'other_pkg'):
            self.files['prefix/share/ament_index/resource_index/packages/' + package] = ''
            self.files['prefix/share/%s/package.xml' % package] = '<package format="3"><name>%s</name></package>\n' % package

    def joined(self, nodes, depth):
        return layout(self.rng, nodes, depth, self.use)
