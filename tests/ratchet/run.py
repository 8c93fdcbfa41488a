#!/usr/bin/env python3
"""Count the findings per rule on public robots; a count that changes must be explained by the change.

    tests/ratchet/run.py --bin target/release/xacro-lint        compare with counts.json
    tests/ratchet/run.py --bin target/release/xacro-lint --update

The robots come from PyPI's `example-robot-data`, which is fetched once into target/ratchet.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PACKAGE = 'example-robot-data==6.0.0'


def robots():
    """The folder with the robots."""
    folder = ROOT / 'target' / 'ratchet'
    done = folder / 'complete'
    top = folder / 'cmeel.prefix' / 'share' / 'example-robot-data'
    if done.exists():
        return top
    folder.mkdir(parents=True, exist_ok=True)
    sys.path.insert(0, str(HERE.parent / 'differential'))
    import reference  # makes a virtual environment that has pip
    subprocess.run([reference.python(), '-m', 'pip', 'download', '--quiet', '--no-deps', '--dest', str(folder), PACKAGE],
                   check=True)
    with zipfile.ZipFile(next(folder.glob('*.whl'))) as wheel:
        wheel.extractall(folder)
    # a repository of its own: what the texts of this one say of such robots does not count
    (top / '.git').mkdir(exist_ok=True)
    # the meshes are named by the package's folder, not by its name
    manifest = top / 'package.xml'
    text = manifest.read_text(encoding='utf-8')
    manifest.write_text(text.replace('<name>example_robot_descriptions</name>', '<name>example-robot-data</name>'),
                        encoding='utf-8')
    done.touch()
    return top


def count(command, folder):
    """Findings by severity and rule."""
    run = subprocess.run([command, 'check', '--no-group', '--format', 'json', '.'], cwd=folder, capture_output=True, check=False)
    if run.returncode not in (0, 1):
        sys.exit('exit status %d: %s' % (run.returncode, run.stderr.decode('utf-8', 'replace')[-500:]))
    counts = collections.Counter('%s %s' % (finding['severity'], finding['name']) for finding in json.loads(run.stdout))
    return dict(sorted(counts.items()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', required=True, type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument('--update', action='store_true')
    options = parser.parse_args()
    counts = count(options.bin, robots())
    stored = HERE / 'counts.json'
    if options.update:
        stored.write_text(json.dumps(counts, indent=2) + '\n', encoding='utf-8')
    known = json.loads(stored.read_text(encoding='utf-8'))
    changed = [rule for rule in sorted(set(known) | set(counts)) if known.get(rule, 0) != counts.get(rule, 0)]
    for rule in changed:
        print('%s: %d findings, %d before' % (rule, counts.get(rule, 0), known.get(rule, 0)))
    if changed:
        print('a change in these counts must be explained; --update stores them')
    print('%d passed, %d failed' % (len(set(known) | set(counts)) - len(changed), len(changed)))
    return 1 if changed else 0


if __name__ == '__main__':
    sys.exit(main())
