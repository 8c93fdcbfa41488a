#!/usr/bin/env python3
"""Definition, references and hover of names in real robots, judged by expansions.

    tests/names/definitions.py --server target/release/xacro-lsp --bin target/release/xacro-lint --root FOLDER
                               [--robot 'FILE name:=value ...' ...] [--places 300] [--seed 1] [-v]

Draws places that use a name of xacro in the files of some robots, most of them in conditions and in macros that nobody calls, and
asks the server where each leads. Whether that is right is told by expansions of a copy (judge.py): every definition of the
name gets a value of its own, the asked place prints what it sees, conditions on the way there are decided by force.

    right       all that the place may mean was named, nothing else
    incomplete  something that the place means was not named
    wrong       something was named that the place means in no expansion
"""
import argparse
import collections
import os
import pathlib
import random
import sys
import tempfile
import urllib.parse

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / 'soak')]
import client  # noqa: E402
import expansions  # noqa: E402
import judge  # noqa: E402
import texts  # noqa: E402

CAPABILITIES = {
    'general': {'positionEncodings': ['utf-16']},
    'workspace': {'configuration': True, 'workspaceEdit': {'documentChanges': True}},
    'textDocument': {'definition': {'linkSupport': True}, 'hover': {'contentFormat': ['markdown']}},
}
FEATURES = ('definition', 'references', 'hover')
# further places of one name that references are judged by
OTHERS = 6


def path_of(uri):
    return os.path.normpath(urllib.parse.unquote(uri.removeprefix('file://')))


class Asker:
    """The server, with the files open that are asked about."""

    def __init__(self, server, folder):
        self.client = client.Client(os.path.abspath(server), folder, CAPABILITIES)
        self.open = {}

    def shown(self, text, main):
        """Have a file shown under a robot; the root that the server takes for it, with its arguments."""
        for path in (text.path, main):
            if path not in self.open:
                self.open[path] = 1
                self.client.open(path, pathlib.Path(path).read_text('utf-8'))
        found = self.client.request('xacro/expand', {'textDocument': {'uri': client.uri(text.path)}}) or {}
        root = path_of((found.get('root') or {}).get('uri', ''))
        return root, ['%s:=%s' % pair for pair in (found.get('args') or {}).items()]

    def forget(self):
        for path in list(self.open):
            self.client.notify('textDocument/didClose', {'textDocument': {'uri': client.uri(path)}})
        self.open = {}

    def at(self, use):
        middle = use.start + min(1, len(use.name) - 1)
        return {'textDocument': {'uri': client.uri(use.text.path)}, 'position': use.text.position(middle)}

    def definition(self, use):
        found = self.client.request('textDocument/definition', self.at(use)) or []
        return [(path_of(link['targetUri']), link['targetSelectionRange']['start']) for link in found]

    def references(self, use):
        found = self.client.request('textDocument/references', {**self.at(use), 'context': {'includeDeclaration': True}}) or []
        return [(path_of(place['uri']), place['range']['start']) for place in found]

    def hover(self, use):
        found = self.client.request('textDocument/hover', self.at(use))
        return found['contents']['value'] if found else ''


class Verdicts:
    def __init__(self, verbose):
        self.verbose, self.counts, self.told = verbose, collections.Counter(), []

    def add(self, feature, verdict, use, why=''):
        self.counts[feature, verdict] += 1
        if verdict != 'right':
            self.told.append('%s %s: %s %s' % (feature, verdict, use, why))
            if self.verbose:
                print('   ', self.told[-1], flush=True)

    def share(self, feature):
        all_ = sum(n for (of, _), n in self.counts.items() if of == feature)
        return self.counts[feature, 'right'] / max(1, all_), self.counts[feature, 'wrong'], all_


def candidates(rng, robot):
    """The places of a robot: of what stands in conditions or in macros that nobody calls, and of the others."""
    called = {name.name for text in robot.texts.values() for name in texts.uses(text) if name.kind == 'macro'}
    doubtful, plain = [], []
    for text in robot.texts.values():
        for use in texts.uses(text):
            macros = [e for e in use.element.around() if e.name == 'xacro:macro']
            in_doubt = any(e.name in texts.CONDITIONS for e in use.element.around())
            in_doubt |= any((text.value(e, 'name') or '') not in called for e in macros)
            (doubtful if in_doubt else plain).append(use)
    rng.shuffle(doubtful)
    rng.shuffle(plain)
    return doubtful, plain


def judged(asker, judging, use, verdicts, rng):
    """Ask all there is to ask about a place; whether expansions could say what is right."""
    truth = judging.truth(use)
    answers = asker.definition(use)
    given = {(d.text.path, d.start): d for of_name in judging.given.values() for d in of_name if d.name == use.name}
    named, strange = [], []
    for path, position in answers:
        text = judging.robot.texts.get(path)
        definition = text and given.get((path, text.offset(position)))
        (named if definition else strange).append(definition or (path, position))
    if not truth.observed and not named:
        return False
    extra = [d for d in named if d not in truth.meant and not judging.may_mean(use, d)]
    if not truth.observed:
        if extra:
            # no expansion comes by: nothing can be said
            return False
        truth.observed, truth.meant = True, set(named)
    missing = truth.meant - set(named)
    if extra or strange:
        verdicts.add('definition', 'wrong', use, 'names %s, means %s' % (named + strange, sorted(map(repr, truth.meant))))
    elif missing:
        verdicts.add('definition', 'incomplete', use, 'names %s, means %s' % (named, sorted(map(repr, truth.meant))))
    else:
        verdicts.add('definition', 'right', use)
    may_be = truth.meant | (set(named) - set(extra))
    hover_of(asker, use, truth, may_be, verdicts)
    references_of(asker, judging, use, may_be, verdicts, rng)
    return True


def hover_of(asker, use, truth, may_be, verdicts):
    shown = asker.hover(use)
    places = ['%s:%d' % (os.path.basename(d.text.path), d.text.line(d.start)) for d in may_be]
    if not may_be:
        verdicts.add('hover', 'right' if 'defined in' not in shown else 'wrong', use, shown)
    elif use.name not in shown:
        verdicts.add('hover', 'incomplete', use, repr(shown))
    elif not any(place in shown for place in places):
        verdicts.add('hover', 'wrong' if 'defined in' in shown else 'incomplete', use, '%r, given at %s' % (shown, places))
    else:
        values = {value for value in truth.values if judge.number(value)} if truth.by_default else set()
        title = shown.split('\n')[0].split(' = ')
        said = (title[1] if len(title) > 1 else '').strip('` ').split('`')[0]
        differs = len(values) == 1 and judge.number(said) and abs(float(said) - float(next(iter(values)))) > 1e-3 * abs(float(said)) + 1e-9
        verdicts.add('hover', 'wrong' if differs else 'right', use, 'says %s, is %s' % (said, values))


def references_of(asker, judging, use, may_be, verdicts, rng):
    """Whether a name's references are the places that mean the same definitions: some of those named, some of the others."""
    if not may_be:
        return
    found = set()
    for path, position in asker.references(use):
        text = judging.robot.texts.get(path)
        if text:
            found.add((path, text.offset(position)))
    if (use.text.path, use.start) not in found:
        verdicts.add('references', 'incomplete', use, 'not the place itself')
        return
    given = {(d.text.path, d.start) for d in may_be}
    if not given <= found:
        verdicts.add('references', 'incomplete', use, 'not the definition')
        return
    all_given = {(d.text.path, d.start) for of_name in judging.given.values() for d in of_name}
    kinds = {'value': ('value', 'parameter'), 'parameter': ('value', 'parameter')}.get(use.kind, (use.kind,))
    others = [other for text in judging.robot.texts.values() for other in texts.uses(text)
              if other.name == use.name and other.kind in kinds and (other.text.path, other.start) != (use.text.path, use.start)]
    inside = [other for other in others if (other.text.path, other.start) in found]
    outside = [other for other in others if (other.text.path, other.start) not in found]
    verdict, why = 'right', ''
    for other in rng.sample(inside, min(OTHERS, len(inside))):
        truth = judging.truth(other)
        if truth.observed and not truth.meant & may_be and not any(judging.may_mean(other, d) for d in may_be):
            verdict, why = 'wrong', 'names %s' % other
    for other in rng.sample(outside, min(OTHERS, len(outside))):
        truth = judging.truth(other)
        if verdict == 'right' and truth.observed and truth.meant & may_be and (other.text.path, other.start) not in all_given:
            verdict, why = 'incomplete', 'leaves out %s' % other
    verdicts.add('references', verdict, use, why)


def robots_of(rng, folder, wanted):
    """Robots of several files with conditions, drawn from a folder, each of another package."""
    files = sorted(str(p) for p in pathlib.Path(folder).rglob('*.xacro'))
    rng.shuffle(files)
    found, packages = [], set()
    for file in files:
        package = file[len(folder):].strip('/').split('/')[0]
        if len(found) == wanted or package in packages:
            continue
        if '<xacro:include' not in pathlib.Path(file).read_text('utf-8', 'replace'):
            continue
        robot = texts.Robot(folder, file)
        conditions = sum(len(text.conditions) for text in robot.texts.values())
        if len(robot.texts) >= 3 and conditions >= 3:
            found.append(file)
            packages.add(package)
    return found


def configured(folder, robots):
    """The robots that were named, with a configuration for those that have arguments."""
    mains, config = [], ''
    for robot in robots:
        file, *args = robot.split()
        mains.append(os.path.join(folder, file))
        if args:
            given = ', '.join('%s = "%s"' % tuple(arg.split(':=', 1)) for arg in args)
            config += '[[roots]]\nfile = "%s"\nargs = { %s }\n' % (file, given)
    if config:
        pathlib.Path(folder, 'xacro-lint.toml').write_text(config)
    return mains


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--server', required=True)
    parser.add_argument('--bin', required=True)
    parser.add_argument('--root', required=True)
    parser.add_argument('--robot', action='append', default=[])
    parser.add_argument('--robots', type=int, default=5)
    parser.add_argument('--places', type=int, default=300)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--least', type=float, default=0.98)
    parser.add_argument('-v', action='store_true')
    options = parser.parse_args()
    rng = random.Random(options.seed)
    folder = os.path.abspath(options.root)
    verdicts = Verdicts(options.v)
    done = undecided = forced = runs = 0
    with tempfile.TemporaryDirectory() as scratch:
        # the server has a copy of its own, with the arguments that were given
        folder = expansions.Copy(options.bin, folder, os.path.join(scratch, 'asked')).at
        mains = configured(folder, options.robot) or robots_of(rng, folder, options.robots)
        asker = Asker(options.server, folder)
        copy = expansions.Copy(options.bin, folder, os.path.join(scratch, 'copy'))
        for number, main_file in enumerate(mains):
            wanted = (options.places * (number + 1)) // len(mains) - done
            robot = texts.Robot(folder, main_file)
            judging = {}
            doubtful, plain = candidates(rng, robot)
            asker.forget()
            tried = 0
            while wanted > 0 and (doubtful or plain) and tried < 4 * options.places:
                from_doubtful = doubtful and (not plain or rng.random() < 0.67)
                use = (doubtful if from_doubtful else plain).pop()
                tried += 1
                root, args = asker.shown(use.text, main_file)
                key = root, tuple(args)
                if not os.path.isfile(root):
                    undecided += 1
                    continue
                if key not in judging:
                    judging[key] = judge.Judge(robot if root == main_file else texts.Robot(folder, root), copy, args)
                own = judging[key].robot.texts.get(use.text.path)
                if own is None:
                    undecided += 1
                    continue
                use = next(u for u in texts.uses(own) if u.start == use.start)
                if judged(asker, judging[key], use, verdicts, rng):
                    done, wanted = done + 1, wanted - 1
                    forced += not judging[key].truth(use).by_default
                else:
                    undecided += 1
            print('%s: %d files' % (os.path.relpath(main_file, folder), len(robot.texts)), flush=True)
        runs = copy.runs
        asker.client.stop()
    failed = False
    for feature in FEATURES:
        share, wrong, all_ = verdicts.share(feature)
        failed |= bool(wrong) or share < options.least
        print('%-11s %6.2f %% right of %d, %d wrong' % (feature, 100 * share, all_, wrong))
    if not options.v:
        print('\n'.join(verdicts.told[:40]))
    print('%d places in %d robots, %d of them evaluated by force only, %d that no expansion decides; %d expansions'
          % (done, len(mains), forced, undecided, runs))
    return failed or not done


if __name__ == '__main__':
    sys.exit(main())
