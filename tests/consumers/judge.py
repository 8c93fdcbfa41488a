#!/usr/bin/env python3
"""Compare what `xacro-lint consumers` predicts of robots with what the real readers do.

    tests/consumers/judge.py --bin target/release/xacro-lint --packages FOLDER FILE...
    ... --changes 5 --seed 1     also single random changes of each robot

Prints recall and precision of "rejects" and recall of "changes": for the files (plain), their changes (changed), and those whose
file the reader loads (loading); and the pairs that were wrong, most frequent reasons first.
"""
import argparse
import collections
import concurrent.futures
import itertools
import json
import pathlib
import random
import re
import subprocess
import sys

import install
import mutations
import run
import truth


def predicted(command, path, packages):
    """{consumer: outcome} and {consumer: constructs that it rejects}; every consumer rejects what cannot be expanded."""
    answer = subprocess.run([command, 'consumers', '--format', 'json', '--package-path', str(packages), str(path)],
                            capture_output=True, check=False)
    if answer.returncode != 0:
        return collections.defaultdict(lambda: 'rejects'), {}
    answer = json.loads(answer.stdout)
    return answer['consumers'], answer['constructs']


def robots(files, count, seed):
    """The files, and `count` changes of each, written beside them: {path: the file it was made from}."""
    made = {path: path for path in files}
    for path in files:
        text = path.read_text(encoding='utf-8', errors='replace')
        source = random.Random('%s %s' % (seed, path.name))
        for number in range(count):
            name, changed = mutations.mutate(text, source)
            if changed is None:
                continue
            new = path.with_name('%s__%d_%s.urdf' % (path.stem, number, name))
            new.write_text(changed, encoding='utf-8')
            made[new] = path
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', required=True, type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument('--packages', required=True, type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument('--tools', type=pathlib.Path, default=run.ROOT / 'target' / 'consumers')
    parser.add_argument('--readers', type=lambda text: text.split(','))
    parser.add_argument('--changes', type=int, default=0)
    parser.add_argument('--seed', default='1')
    parser.add_argument('--verbose', action='store_true')
    parser.add_argument('files', nargs='+', type=lambda path: pathlib.Path(path).resolve())
    options = parser.parse_args()
    tools = install.tools(options.tools, options.readers)
    readers = options.readers or tools.readers
    made = robots(options.files, options.changes, options.seed)
    paths = list(made)
    answers = run.load_all(readers, tools, options.packages, paths)
    said = {path: truth.of(path) for path in paths}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        guesses = dict(zip(paths, pool.map(lambda path: predicted(options.bin, path, options.packages), paths)))
    report(readers, made, answers, said, guesses, options.verbose)


def report(readers, made, answers, said, guesses, verbose):
    table = collections.Counter()
    wrong = collections.defaultdict(list)
    for path, plain in made.items():
        guess, constructs = guesses[path]
        for reader in readers:
            answer, usual = answers[reader][str(path)], answers[reader][str(plain)]
            known = usual if path != plain and usual['loaded'] else None
            now = truth.outcome(answer, said[path], known, said[plain]) if known or not answer['loaded'] else 'accepts'
            kinds = ['plain'] if path == plain else ['changed', 'loading'] if usual['loaded'] else ['changed']
            for key in itertools.product(('all', reader), kinds):
                table[(*key, guess[reader], now)] += 1
            if (guess[reader] == 'rejects') != (now == 'rejects'):
                why = answer.get('why', '') if now == 'rejects' else ', '.join(
                    row['construct'] for row in constructs if row['outcomes'][reader] == 'rejects')
                wrong[(reader, 'missed' if now == 'rejects' else 'false', re.sub(r"'[^']*'|`[^`]*`|/\S+|[\d.e-]+", '_', why)[:110])].append((path, why))
    for kind in ('plain', 'changed', 'loading'):
        for who in ['all', *readers]:
            show(who, kind, table)
    for (reader, what, why), places in sorted(wrong.items(), key=lambda item: -len(item[1])):
        print('%4d %s %s: %s   e.g. %s: %s' % (len(places), reader, what, why, places[0][0].name, places[0][1][:160] if verbose else ''))


def show(who, kind, table):
    count = lambda guess, now: sum(n for (a, b, g, t), n in table.items() if (a, b) == (who, kind) and g in guess and t in now)
    every = ('rejects', 'changes', 'accepts')
    hit, is_, says = count(('rejects',), ('rejects',)), count(every, ('rejects',)), count(('rejects',), every)
    changed, silent = count(('rejects', 'changes'), ('changes',)), count(every, ('changes',))
    part = lambda a, b: '%5.1f %%' % (100 * a / b) if b else '    -  '
    print('%-15s %-8s rejected %5d  recall %s  precision %s   changed %5d recall %s' % (
        who, kind, is_, part(hit, is_), part(hit, says), silent, part(changed, silent)))


if __name__ == '__main__':
    sys.exit(main())
