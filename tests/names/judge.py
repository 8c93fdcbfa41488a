"""Which definition a name means, told by expansions alone.

Every definition that has the name gets a value of its own, the use prints what it sees, and conditions on the way to the
use are decided by rewriting them. What is printed says which definition was meant, whatever any model of scopes says.
"""
import texts

SAID = 77001
FIRST_MARK = 9000001
MOST_WAYS = 6
MOST_DEEP = 12


class Truth:
    """What expansions say of a use: the definitions that it meant, whether it was evaluated without any force."""

    def __init__(self):
        self.meant, self.values, self.by_default, self.observed, self.doubtful = set(), [], False, False, False


class Judge:
    def __init__(self, robot, copy, args=()):
        self.robot, self.copy, self.args = robot, copy, list(args)
        self.given, self.calls, self.truths = {}, {}, {}
        for text in robot.texts.values():
            for definition in texts.definitions(text):
                self.given.setdefault((definition.kind, definition.name), []).append(definition)
            for name in texts.uses(text):
                if name.kind == 'macro':
                    self.calls.setdefault(name.name, []).append(name)

    # ---- ways to an element

    def ways(self, text, element, depth=0, seen=()):
        """Edits that have an element evaluated, as lists of (path, edit), the most likely first."""
        around = element.around()
        own = [(text.path, texts.forced(e, True)) for e in around if e.name in texts.CONDITIONS and 'value' in e.attributes]
        macro = next((e for e in [element, *around] if e.name == 'xacro:macro'), None)
        found = []
        if depth > MOST_DEEP:
            return []
        if macro is not None:
            name = (text.value(macro, 'name') or '').removeprefix('xacro:')
            sites = [c for c in self.calls.get(name, ()) if macro not in c.element.around() and c.element not in seen]
            sites.sort(key=lambda c: (sum(e.name in texts.CONDITIONS for e in c.element.around()), c.start))
            for site in sites[:4]:
                found += [own + way for way in self.ways(site.text, site.element, depth + 1, (*seen, site.element))]
            if not sites:
                call = self.call(text, macro, name)
                found += [own + way + [call] for way in self.file_ways(text, depth, seen)]
        else:
            found += [own + way for way in self.file_ways(text, depth, seen)]
        return sorted(found, key=len)[:MOST_WAYS]

    def file_ways(self, text, depth, seen):
        if text.path == self.robot.main:
            return [[]]
        found = []
        for from_, element, path in self.robot.includes:
            if path == text.path and element not in seen:
                brought = self.brought_in(from_, element, path)
                found += [brought + way for way in self.ways(from_, element, depth + 1, (*seen, element))]
        return sorted(found, key=len)[:3]

    def brought_in(self, from_, element, path):
        """The edit that has an include with a computed name, which may name several files, name this one."""
        is_computed = '$' in from_.value(element, 'filename').replace('$(find', '')
        return [(from_.path, (*element.attributes['filename'], self.copy.moved(path)))] if is_computed else []

    def reading(self, text):
        """Edits that have a file read, one for each include that may name it; a macro's way leads to its calls, which need not read it."""
        found = [self.brought_in(*include) for include in self.robot.includes if include[2] == text.path]
        return [edits for edits in found if edits] or [[]]

    def call(self, text, macro, name):
        """A call for a macro that nobody calls, at the end of the root."""
        root = self.robot.texts[self.robot.main]
        at = root.clean.rfind('</robot')
        parameters = text.parameters(macro)
        values = ' '.join('%s="1"' % given for stars, given, _, _, has in parameters if not stars and not has)
        blocks = ''.join('<origin xyz="0 0 0"/>' if stars == '*' else '<block><origin xyz="0 0 0"/></block>' for stars, *_ in parameters if stars)
        return self.robot.main, (at, at, '<xacro:%s %s>%s</xacro:%s>' % (name, values, blocks, name))

    # ---- observing

    def run(self, way, *more, without=''):
        edits = {}
        for path, edit in [*way, *[edit for edits_ in more for edit in edits_]]:
            if edit not in edits.setdefault(path, []):
                edits[path].append(edit)
        # where two edits decide one condition, the first one holds
        for path, changes in edits.items():
            kept = {}
            for change in changes:
                if change[0] < change[1]:
                    kept.setdefault(change[:2], change)
            edits[path] = [c for c in changes if c[0] == c[1] or kept[c[:2]] is c]
        # an argument that is given hides its default
        args = [arg for arg in self.args if not without or not arg.startswith(without + ':=')]
        return self.copy.run(self.robot.main, args, edits)

    def said(self, use):
        """The edit that has a use print what it sees."""
        path = use.text.path
        if use.kind == 'value':
            return path, (use.start, use.end, '[xacro.message(%d,%s),%s][1]' % (SAID, use.name, use.name))
        return path, (use.outer, use.outer, '${[xacro.message(%d,xacro.arg(&apos;%s&apos;)),&apos;&apos;][1]}' % (SAID, use.name))

    def marks(self, use, kind):
        """Edits that give each definition with the name a value of its own, and these values."""
        found, names = [], {}
        for number, definition in enumerate(self.given.get((use.kind, use.name), ())):
            mark = str(FIRST_MARK + number) if kind == 'number' else 'zzm%d' % number
            names[mark] = definition
            element, path = definition.element, definition.text.path
            if element.name == 'xacro:macro':
                if not element.own_end:
                    found.append((path, (element.inner, element.inner, '<xacro:property name="%s" value="%s"/>' % (use.name, mark))))
            else:
                for attribute in {'value', 'default'} & set(element.attributes):
                    found.append((path, (*element.attributes[attribute], mark)))
        return found, names

    def counted(self, use):
        """Edits that have each macro or block with the name print a mark, and these marks."""
        found, names = [], {}
        for number, definition in enumerate(self.given.get((use.kind, use.name), ())):
            mark = str(FIRST_MARK + number)
            names[mark] = definition
            said = '<zz_mark said="${[xacro.message(%d,%s),0][1]}"/>' % (SAID, mark)
            element = definition.element
            if use.kind == 'block' and element.name == 'xacro:macro':
                said = '<xacro:property name="%s">%s</xacro:property>' % (use.name, said)
            if not element.own_end:
                found.append((definition.text.path, (element.inner, element.inner, said)))
        return found, names

    def removed(self, use):
        """Edits that make an element of a use one that xacro does not know."""
        element, path = use.element, use.text.path
        found = [(path, (element.start + 1, element.start + 1 + len(element.name), 'zz_gone'))]
        if not element.own_end:
            end = use.text.text.rfind('</', element.inner_end, element.end)
            end = element.inner_end if end < 0 else end
            found.append((path, (end + 2, end + 2 + len(element.name), 'zz_gone')))
        return found

    def seen(self, use, way):
        """The definitions that a use means on a way; none when it is not evaluated there. And what it prints unmarked."""
        if use.kind in ('macro', 'block'):
            marks, names = self.counted(use)
            with_, without = (self.run(way, marks, more).marks(str(SAID)) for more in ([], self.removed(use)))
            return {names[mark] for mark in names if with_.count(mark) > without.count(mark)} or None, []
        if use.kind == 'parameter':
            call = next(c for c in self.calls[use.element.name[6:].rsplit('.', 1)[-1]] if c.element is use.element)
            macros, _ = self.seen(call, way)
            elements = [macro.element for macro in macros or ()]
            return {d for d in self.given.get(('value', use.name), ()) if d.element in elements} or None, []
        said, argument = [self.said(use)], use.name if use.kind == 'argument' else ''
        values = self.run(way, said).marks(str(SAID))
        if not values:
            return None, []
        kinds = ['number', 'text'] if all(number(value) for value in values) else ['text', 'number']
        for kind in kinds:
            marks, names = self.marks(use, kind)
            printed = self.run(way, said, marks, without=argument).marks(str(SAID))
            if printed:
                return {names[value] for value in printed if value in names}, values
        return None, values

    def truth(self, use):
        key = use.text.path, use.start
        if key not in self.truths:
            truth = self.truths[key] = Truth()
            ways = [[], *self.ways(use.text, use.element)]
            found = 0
            for way in ways:
                meant, values = self.seen(use, way)
                if meant is None:
                    truth.values = truth.values or values if not way else truth.values
                    continue
                if not way:
                    truth.by_default, truth.values = True, values
                truth.observed = True
                truth.meant |= meant
                found += 1
                if found == 3:
                    break
        return self.truths[key]

    def may_mean(self, use, definition):
        """Whether a use means a definition in some expansion, with the conditions around both taken, the others not."""
        others = [d for d in self.given.get((definition.kind, definition.name), ()) if d is not definition]
        ways = self.ways(use.text, use.element)[:3]
        there = self.ways(definition.text, definition.element)[:3] or [[]]
        there = [[*edits, *way] for edits in self.reading(definition.text)[:2] for way in there]
        without = [(d.text.path, texts.forced(e, False)) for d in others for e in d.element.around()
                   if e.name in texts.CONDITIONS and 'value' in e.attributes]
        for own in ways:
            for given in there:
                for away in ([], without):
                    meant, _ = self.seen(use, [*own, *given, *away])
                    if meant and definition in meant:
                        return True
        return False


def number(text):
    try:
        return text not in ('True', 'False') and float(text) == float(text)
    except ValueError:
        return False
