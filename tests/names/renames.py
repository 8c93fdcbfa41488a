#!/usr/bin/env python3
"""Rename names in real robots: no robot changes but for the name.

    tests/names/renames.py --server target/release/xacro-lsp --bin target/release/xacro-lint --root FOLDER
                           [--renames 300] [--seed 1] [--most-refused 0.1] [-v]

Draws names of all kinds, has the server rename them, and makes the edits in a copy. All robots that may read a file which changed are
expanded before and after: with their defaults, with each switch turned over, and with each condition of the changed
files taken and not taken, one at a time, those around it taken. They must be the same robots but for the name, and what was
refused must be refused for the same reasons.
"""
import argparse
import collections
import os
import pathlib
import random
import re
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / 'soak')]
import client  # noqa: E402
import expansions  # noqa: E402
import same  # noqa: E402
import texts  # noqa: E402
from definitions import CAPABILITIES, path_of  # noqa: E402

KINDS = ('property', 'parameter', 'block', 'argument', 'macro', 'link', 'joint', 'material', 'file')
ROBOT_KINDS = {'link': {('link', 'name'), ('parent', 'link'), ('child', 'link')}, 'joint': {('joint', 'name'), ('mimic', 'joint')},
               'material': {('material', 'name')}}
TURNED = {'true': 'false', 'false': 'true', 'True': 'False', 'False': 'True', '0': '1', '1': '0'}
MOST_ROBOTS = 10
MOST_SWITCHES = 3
MOST_CONDITIONS = 30
MOST_FORCED_ROBOTS = 4


class Folder:
    """The texts below a folder, which robots read them, and the names to draw from."""

    def __init__(self, folder):
        self.folder, self.robots, self.texts = folder, {}, {}
        for path in sorted(pathlib.Path(folder).rglob('*')):
            if path.suffix in ('.xacro', '.urdf') and path.is_file():
                try:
                    self.texts[str(path)] = texts.Text(str(path))
                except UnicodeDecodeError:
                    pass
        included = set()
        for path in self.texts:
            self.robots[path] = robot = texts.Robot(folder, path)
            included |= {found for text, _, found in robot.includes if text.path == path and found != path}
        self.included = sorted(included & self.texts.keys())
        self.roots = [path for path in self.texts if path not in included and '<robot' in self.texts[path].clean]

    def reading(self, paths):
        """The robots that may read one of some files."""
        found = [root for root in self.roots if any(path in self.robots[root].texts for path in paths)]
        return found or [path for path in paths if path in self.texts]

    def places(self):
        """The places of each kind: (path, offset, what is said of it)."""
        found = {kind: [] for kind in KINDS}
        for path, text in self.texts.items():
            for given in texts.definitions(text):
                kind = given.kind if given.kind != 'value' else 'parameter' if given.element.name == 'xacro:macro' else 'property'
                found[kind].append((path, given.start, given.name))
            for use in texts.uses(text):
                kind = {'value': 'property'}.get(use.kind, use.kind)
                if kind != 'property' or any(e.name == 'xacro:property' and text.value(e, 'name') == use.name for e in text.elements):
                    found[kind].append((path, use.start, use.name))
            for element in text.elements:
                # SRDF names the things of another file
                for attribute, span in element.attributes.items() if '.srdf' not in path else ():
                    for kind in (k for k, slots in ROBOT_KINDS.items() if (element.name, attribute) in slots):
                        if element.name == 'material' and any(e.name == 'gazebo' for e in element.around()):
                            continue
                        if element.name == 'joint' and any(e.name in ('transmission', 'ros2_control') for e in element.around()):
                            continue
                        literal = re.search(r'[A-Za-z]\w*', re.sub(r'\$\{[^}]*\}|\$\([^)]*\)', lambda m: '$' * len(m[0]), text.text[slice(*span)]))
                        if literal:
                            found[kind].append((path, span[0] + literal.start(), literal[0]))
        found['file'] = [(path, 0, os.path.basename(path)) for path in self.included]
        return found


class Client(client.Client):
    """One that keeps what is shown to the user."""

    shown = ()

    def take(self, message):
        if message.get('method') == 'window/showMessage':
            self.shown = (*self.shown, message['params']['message'])
        super().take(message)


class Server:
    def __init__(self, server, folder):
        self.client = Client(os.path.abspath(server), folder, CAPABILITIES)

    def warning(self):
        """What the user was told since the last time: of a file that is renamed, what still has its old name."""
        shown, self.client.shown = self.client.shown, ()
        return ' '.join(shown)

    def ask(self, method, params):
        while True:
            reply = self.client.reply(self.client.post(method, params), 300)
            error = reply.get('error')
            if not error:
                return reply.get('result'), None
            if error['code'] not in (-32800, -32801, -32802):
                return None, error['message']

    def rename(self, text, offset, lengthen):
        """The edits of a rename: path to (start, end, new); the old and the new name; or why it is refused."""
        self.client.open(text.path, text.text)
        at = {'textDocument': {'uri': client.uri(text.path)}, 'position': text.position(offset)}
        try:
            found, error = self.ask('textDocument/prepareRename', at)
            if not found:
                return None, None, None, error or 'nothing to rename here'
            old = found['placeholder']
            new = lengthen(old)
            edit, error = self.ask('textDocument/rename', {**at, 'newName': new})
        finally:
            self.client.notify('textDocument/didClose', {'textDocument': {'uri': client.uri(text.path)}})
        return edits_of(edit), old, new, error

    def rename_file(self, old, new):
        files = {'files': [{'oldUri': client.uri(old), 'newUri': client.uri(new)}]}
        edit, error = self.ask('workspace/willRenameFiles', files)
        return edits_of(edit), error


def edits_of(edit):
    """Path to edits as the protocol has them."""
    found = {}
    for change in (edit or {}).get('documentChanges') or ():
        found.setdefault(path_of(change['textDocument']['uri']), []).extend(change['edits'])
    for uri, edits in ((edit or {}).get('changes') or {}).items():
        found.setdefault(path_of(uri), []).extend(edits)
    return found


class Trial:
    """Expansions before and after a rename."""

    def __init__(self, folder, copy, rng):
        self.folder, self.copy, self.rng, self.known = folder, copy, rng, {}

    def before(self, root, args, path=None, number=0, taken=True):
        key = root, tuple(args), path, number, taken
        if key not in self.known:
            files = {path: decided(self.folder.texts[path], number, taken)} if path else {}
            self.known[key] = self.copy.run_with(root, args, files)
        return self.known[key]

    def difference(self, after, moved, old, new, is_robots):
        """How some robot changes when the files have these texts; and names that were left."""
        paths = [path for path in after if path in self.folder.texts] + list(moved)
        roots = self.folder.reading(paths)
        self.rng.shuffle(roots)
        gone = {**after, **{path: None for path in moved}, **{to: after.get(path, self.folder.texts[path].text) for path, to in moved.items()}}
        left, tried = set(), 0
        for number, root in enumerate(roots[:MOST_ROBOTS]):
            text = self.folder.texts[root]
            argument = (lambda arg: re.sub('^%s:=' % re.escape(old), new + ':=', arg)) if self.is_argument else (lambda arg: arg)
            for args in self.settings(root):
                one = self.before(root, args)
                other = self.copy.run_with(moved.get(root, root), [argument(arg) for arg in args], gone)
                tried += 1
                found = same.difference(one, other, old, new, is_robots)
                if found:
                    return '%s %s %s' % (os.path.basename(text.path), ' '.join(args), found), left, tried
                if is_robots and not one.code:
                    left |= set(same.left(one, other))
            if number < MOST_FORCED_ROBOTS:
                found, more = self.forced(root, after, moved, gone, old, new, is_robots)
                tried += more
                if found:
                    return found, left, tried
        return None, left, tried

    def forced(self, root, after, moved, gone, old, new, is_robots):
        plain, tried = self.before(root, []), 0
        conditions = [(path, number) for path in after if path in self.folder.robots[root].texts
                      for number in range(len(self.folder.robots[root].texts[path].conditions))]
        for path, number in self.rng.sample(conditions, min(MOST_CONDITIONS, len(conditions))):
            text = texts.Text(path, after[path])
            for taken in (True, False):
                one = self.before(root, [], path, number, taken)
                if (one.out, one.err) == (plain.out, plain.err):
                    continue
                tried += 1
                files = {**gone, moved.get(path, path): decided(text, number, taken)}
                found = same.difference(one, self.copy.run_with(moved.get(root, root), [], files), old, new, is_robots)
                if found:
                    line = self.folder.texts[path].line(self.folder.texts[path].conditions[number].start)
                    return '%s with the condition at %s:%d %s: %s' % (
                        os.path.basename(root), os.path.basename(path), line, 'taken' if taken else 'not taken', found), tried
        return None, tried

    def settings(self, root):
        text = self.folder.texts[root]
        switches = []
        for element in text.elements:
            name, default = text.value(element, 'name'), text.value(element, 'default')
            if element.name == 'xacro:arg' and default in TURNED:
                switches.append(['%s:=%s' % (name, TURNED[default])])
        return [[], *switches[:MOST_SWITCHES]]


def decided(text, number, taken):
    """A text with one condition decided, those around it taken."""
    condition = text.conditions[number]
    edits = [texts.forced(condition, taken)]
    edits += [texts.forced(e, True) for e in condition.around() if e in text.conditions]
    return texts.replaced(text.text, edits)


def changed_texts(folder, edits):
    after = {}
    for path, changes in edits.items():
        text = folder.texts.get(path) or texts.Text(path)
        after[path] = texts.replaced(text.text, [
            (text.offset(c['range']['start']), text.offset(c['range']['end']), c['newText']) for c in changes])
    return after


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--server', required=True)
    parser.add_argument('--bin', required=True)
    parser.add_argument('--root', required=True)
    parser.add_argument('--renames', type=int, default=300)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--kind', action='append', choices=KINDS, default=[])
    parser.add_argument('--most-refused', type=float, default=0.1)
    parser.add_argument('-v', action='store_true')
    options = parser.parse_args()
    rng = random.Random(options.seed)
    folder = Folder(os.path.abspath(options.root))
    places = folder.places()
    kinds = [kind for kind in options.kind or KINDS if places[kind]]
    drawn = []
    for number, kind in enumerate(kinds):
        count = options.renames * (number + 1) // len(kinds) - options.renames * number // len(kinds)
        drawn += [(kind, *place) for place in rng.sample(places[kind], min(count, len(places[kind])))]
    server = Server(options.server, folder.folder)
    counts, refused, changed, left_over, expansions_made = collections.Counter(), collections.defaultdict(list), [], [], 0
    with tempfile.TemporaryDirectory() as scratch:
        trial = Trial(folder, expansions.Copy(options.bin, folder.folder, os.path.join(scratch, 'copy')), rng)
        for kind, path, offset, name in drawn:
            text = folder.texts[path]
            where = '%s `%s` at %s:%d' % (kind, name, os.path.relpath(path, folder.folder), text.line(offset))
            moved, old, new = {}, '', ''
            if kind == 'file':
                moved = {path: os.path.join(os.path.dirname(path), 'zq_' + name)}
                edits, error = server.rename_file(path, moved[path])
                error = error or server.warning()
                old, new = name, 'zq_' + name
            else:
                edits, old, new, error = server.rename(text, offset, lambda old: old + 'zq')
            if error:
                reason = re.sub(r'`[^`]*`|[\w.\-/]+:\d+|line \d+', '…', error)
                refused[reason].append('%s: %s' % (where, error))
                counts[kind, 'refused'] += 1
                continue
            trial.is_argument = kind == 'argument'
            found, left, tried = trial.difference(changed_texts(folder, edits), moved, old, new, kind in ROBOT_KINDS)
            expansions_made += tried
            counts[kind, 'changed' if found else 'same'] += 1
            if found:
                changed.append('%s: %s' % (where, found))
            if left:
                left_over.append('%s: %s' % (where, ', '.join(sorted(left)[:4])))
            if options.v and (found or left):
                print('   ', (changed if found else left_over)[-1], flush=True)
    server.client.stop()
    for kind in kinds:
        print('%-10s %3d same, %2d changed, %2d refused' % (kind, *(counts[kind, verdict] for verdict in ('same', 'changed', 'refused'))))
    for reason, where in sorted(refused.items(), key=lambda item: -len(item[1])):
        print('refused %d times: %s' % (len(where), reason))
        print('\n'.join('    ' + place for place in where[: None if options.v else 3]))
    print('\n'.join('changed: ' + each for each in changed))
    print('\n'.join('left: ' + each for each in left_over))
    total = sum(counts.values())
    share = sum(len(where) for where in refused.values()) / max(1, total)
    print('%d renames, %d pairs of expansions: %d robots changed, %.1f %% refused, %d with names left in other texts'
          % (total, expansions_made, len(changed), 100 * share, len(left_over)))
    return bool(changed) or share > options.most_refused or not total


if __name__ == '__main__':
    sys.exit(main())
