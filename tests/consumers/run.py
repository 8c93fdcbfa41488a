#!/usr/bin/env python3
"""Load a robot for each construct of the table of consumers with the real readers, and compare what they do with the table.

    tests/consumers/run.py                 install the readers below target/consumers and compare
    tests/consumers/run.py --readers urdfdom,mujoco
    tests/consumers/run.py --bin target/release/xacro-lint
    tests/consumers/run.py --update        write what the readers do into the table

The table is `src/rules/consumers/table/*.toml`; `robot.urdf` is the robot that each construct changes in one place.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tomllib

import install
import robots
import truth

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TABLE = ROOT / 'src' / 'rules' / 'consumers' / 'table'
OUTCOMES = ('rejects', 'changes')


def rows():
    """The constructs of the table, each with the file that it stands in."""
    for path in sorted(TABLE.glob('*.toml')):
        for row in tomllib.loads(path.read_text(encoding='utf-8'))['construct']:
            yield path, row


def asked(folder):
    """What an answer rests on beside the robot: how readers are installed and asked, and the files of the robots."""
    sources = [path for path in HERE.rglob('*') if path.suffix in ('.py', '.cpp', '.rs', '.toml', '.mjs')]
    meshes = [path for path in pathlib.Path(folder).rglob('*') if path.suffix in ('.stl', '.obj', '.dae')]
    digest = hashlib.sha1()
    for path in sorted(path for path in sources + meshes if path.is_file()):
        digest.update(path.read_bytes())
    return digest


def load(reader, tools, folder, files):
    """What a reader makes of files, by file. What it said of the same text before is not asked again."""
    around = asked(folder)

    def key_of(path):
        digest = around.copy()
        digest.update(path.read_bytes())
        return digest.hexdigest()

    store = tools.answers / ('%s.jsonl' % reader)
    known = {}
    if store.exists():
        known = {answer['hash']: answer for answer in map(json.loads, store.read_text(encoding='utf-8').splitlines())}
    hashes = {str(path): key_of(pathlib.Path(path)) for path in files}
    new = [path for path, key in hashes.items() if key not in known]
    for answer in ask(reader, tools, folder, new) if new else []:
        answer['hash'] = hashes[answer['file']]
        known[answer['hash']] = answer
    store.parent.mkdir(parents=True, exist_ok=True)
    store.write_text(''.join(json.dumps(answer) + '\n' for answer in known.values()), encoding='utf-8')
    return {path: known[key] for path, key in hashes.items()}


def load_all(readers, tools, folder, files):
    """What each reader makes of files; two readers at a time."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = {reader: pool.submit(load, reader, tools, folder, files) for reader in readers}
    return {reader: job.result() for reader, job in jobs.items()}


def ask(reader, tools, folder, files):
    command = [tools.python, str(HERE / 'readers.py'), reader, str(folder), '-']
    run = subprocess.run(command, input='\n'.join(files).encode(), capture_output=True, check=False,
                         env={**os.environ, 'CONSUMERS_PROGRAMS': str(tools.programs)})
    answers = [json.loads(line) for line in run.stdout.decode('utf-8', 'replace').splitlines()]
    if len(answers) != len(files):
        sys.exit('%s: %d answers to %d robots: %s' % (reader, len(answers), len(files), run.stderr.decode()[-500:]))
    return answers


def measure(readers, tools, folder, made):
    """{row name: {reader: outcome}}; `made` are the robots by row name, the unchanged one by ''."""
    found = collections.defaultdict(dict)
    files = list(made.values())
    expected = {name: truth.of(path) for name, path in made.items()}
    for reader, answers in load_all(readers, tools, folder, files).items():
        for name, path in made.items():
            usual = robots.WITHOUT + name if robots.WITHOUT + name in made else ''
            plain = answers[str(made[usual])]
            found[name][reader] = truth.outcome(answers[str(path)], expected[name], plain, expected[usual])
    return found


def update(found, readers):
    """Write the outcomes of readers into the table; those of consumers that were not run stay."""
    for path in sorted(TABLE.glob('*.toml')):
        parts = re.split(r'(?m)^(?=\[\[construct\]\])', path.read_text(encoding='utf-8'))
        for number, part in enumerate(parts[1:], 1):
            (row,) = tomllib.loads(part)['construct']
            lines = [line for line in part.rstrip('\n').split('\n') if not line.startswith(OUTCOMES)]
            for outcome in OUTCOMES:
                kept = [name for name in row.get(outcome, '').split() if len(name) > 2 and name not in readers]
                names = kept + [name for name in readers if found[row['name']].get(name) == outcome]
                if names:
                    lines.append('%s = "%s"' % (outcome, ' '.join(sorted(names))))
            parts[number] = '\n'.join(lines) + ('\n\n' if number < len(parts) - 1 else '\n')
        path.write_text(''.join(parts), encoding='utf-8')


def compare(found, readers):
    """Print the rows that readers do not agree with; how many agree, and how many do not."""
    agree, differ = 0, 0
    for path, row in rows():
        for reader in readers:
            known = next((outcome for outcome in OUTCOMES if reader in row.get(outcome, '').split()), 'accepts')
            now = found[row['name']][reader]
            if known == now:
                agree += 1
            else:
                differ += 1
                print('%s: %s: %s now %s, and the row says that it %s' % (path.name, row['name'], reader, now, known))
    return agree, differ


def detected(command, made, folder):
    """Print the constructs that `xacro-lint consumers` does not find in their robots; how many it finds, and how many it does not."""
    found, missed = 0, 0
    for _, row in rows():
        run = subprocess.run([command, 'consumers', '--all', '--format', 'json', '--package-path', str(folder), str(made[row['name']])],
                             capture_output=True, check=False)
        names = [construct['construct'] for construct in json.loads(run.stdout)['constructs']] if run.returncode == 0 else []
        if row['name'] in names:
            found += 1
        else:
            missed += 1
            print('%s: not found in its robot, which has: %s' % (row['name'], ' '.join(names) or 'nothing'))
    return found, missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--readers', type=lambda text: text.split(','))
    parser.add_argument('--tools', type=pathlib.Path, default=ROOT / 'target' / 'consumers')
    parser.add_argument('--bin', help='also check that this xacro-lint finds each construct in its robot')
    parser.add_argument('--update', action='store_true')
    options = parser.parse_args()
    tools = install.tools(options.tools, options.readers)
    readers = options.readers or tools.readers
    folder = options.tools / 'packages'
    made = robots.make(folder, [row for _, row in rows()])
    found = measure(readers, tools, folder, made)
    for reader in readers:
        if found[''][reader] != 'accepts':
            print('the robot without changes: %s %s' % (reader, found[''][reader]))
    if options.update:
        update(found, readers)
        return 0
    agree, differ = compare(found, readers)
    if options.bin:
        also, missed = detected(options.bin, made, folder)
        agree, differ = agree + also, differ + missed
    print('%d passed, %d failed' % (agree, differ))
    return 1 if differ else 0


if __name__ == '__main__':
    sys.exit(main())
