#!/usr/bin/env python3
"""Plant single defects in thirty robots: what was found before must still be found.

    tests/planted/run.py --bin target/release/xacro-lint             compare with expected.json
    tests/planted/run.py --bin target/release/xacro-lint --update    store what this binary finds
    tests/planted/run.py --bin NEW --reference OLD [--each 3]     compare with another binary
    tests/planted/run.py --bin NEW --reference OLD --robots DIR     the same in folders with other robots

A defect is one wrong place in one file: a name, number, unit, tag, bracket, file, parent. Each is checked alone. The
stored errors and warnings are those that the clean robot does not have; the test passes when at least 99 % of the
defects that had one still have one. Defects in macros that nothing calls are not planted.
"""
import argparse
import collections
import concurrent.futures
import functools
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import defects  # noqa: E402
import robots  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ENOUGH = 0.99
JOBS = 2
SUFFIXES = ('.xacro', '.urdf')
ENVIRONMENT = {k: v for k, v in os.environ.items() if not k.startswith(('ROS', 'AMENT', 'CMAKE_PREFIX', 'COLCON'))}


@functools.cache
def ungrouped(command):
    """The flag that lists every place: a defect that joins a group of equal findings is still found. None in old versions."""
    run = subprocess.run([command, 'check', '--help'], capture_output=True, check=False)
    return ('--no-group',) if b'--no-group' in run.stdout else ()


def findings(command, folder):
    """Errors and warnings as (rule, file, line, message)."""
    run = subprocess.run([command, 'check', *ungrouped(command), '--format', 'json', '.'], cwd=folder, env=ENVIRONMENT, capture_output=True, check=False)
    if run.returncode not in (0, 1):
        raise RuntimeError('exit status %d: %s' % (run.returncode, run.stderr.decode('utf-8', 'replace')[-500:]))
    return [(f['name'], f['filename'], f['location']['row'], f['message']) for f in json.loads(run.stdout)
            if f['severity'] in ('error', 'warning')]


def new_findings(after, before):
    """What `after` has more of than `before`; lines may have moved, so they do not count."""
    known = collections.Counter((rule, file, message) for rule, file, _, message in before)
    fresh = set()
    for rule, file, line, message in after:
        if known[rule, file, message] > 0:
            known[rule, file, message] -= 1
        else:
            fresh.add('%s@%s:%d' % (rule, file, line))
    return fresh


def nearness(finding, defect):
    """Sorts findings: those nearest to the defect come first."""
    file, line = finding.split('@')[1].rsplit(':', 1)
    return file != defect.file, abs(int(line) - defect.line), finding


def texts(folder):
    """Every robot file of a folder, as far as it is text."""
    found = {}
    for path in sorted(pathlib.Path(folder).rglob('*')):
        if path.suffix in SUFFIXES and path.is_file() and not path.is_symlink():
            try:
                found[path.relative_to(folder).as_posix()] = path.read_bytes().decode('utf-8')
            except UnicodeDecodeError:
                pass
    return found


def check_robot(task):
    """(robot, {command: (findings of the clean robot, {defect id: new findings})})"""
    commands, robot, folder, each = task
    files = texts(folder)
    result = {command: (findings(command, folder), {}) for command in commands}
    for defect in defects.plan(robot, files, each):
        path, text = pathlib.Path(folder, defect.file), files[defect.file]
        path.write_bytes((text[:defect.start] + defect.text + text[defect.end:]).encode())
        name = '%s %s %s %s:%d:%d' % (robot, defect.kind, defect.place, defect.file, defect.line, defect.column)
        for command, (clean, found) in result.items():
            fresh = new_findings(findings(command, folder), clean)
            found[name] = [f.replace('@' + defect.file, '@') for f in sorted(fresh, key=lambda f, d=defect: nearness(f, d))]
        path.write_bytes(text.encode())
    return robot, result


def measure(commands, folder, names, each):
    """Clean findings by robot and new findings by defect, for each command."""
    clean, found = {c: {} for c in commands}, {c: {} for c in commands}
    tasks = [(commands, name, str(pathlib.Path(folder, name)), each) for name in names]
    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        for robot, result in pool.map(check_robot, tasks):
            for command, (before, after) in result.items():
                clean[command][robot] = before
                found[command].update(after)
    return clean, found


def agree(expected, found, part):
    """Whether a finding has the same rule (part 0) or place (part 1) as an expected one."""
    return bool({e.split('@')[part] for e in expected} & {f.split('@')[part] for f in found})


def report(expected, found):
    """Print figures and what was lost; returns (kept, lost)."""
    before = {name: rules for name, rules in expected.items() if rules}
    lost = [name for name in before if not found.get(name)]
    rules, lines = (sum(agree(e, found.get(name, ()), part) for name, e in before.items()) for part in (0, 1))
    for name in lost:
        print('lost: %s: %s' % (name, ', '.join(before[name][:3])))
    gained = sum(1 for name, rules_now in found.items() if rules_now and not expected.get(name))
    kept, all_ = len(before) - len(lost), max(1, len(before))
    print('%d defects planted, %d had an error or a warning; of these %d still have one (%.2f %%), %d of the same rule '
          '(%.2f %%), %d on the same line (%.2f %%); %d had none and have one now'
          % (len(found), len(before), kept, 100 * kept / all_, rules, 100 * rules / all_, lines, 100 * lines / all_, gained))
    for field, what in ((2, 'place'), (1, 'kind')):
        total, missing = (collections.Counter(name.split()[field] for name in names) for names in (before, lost))
        for value in sorted(total if field == 2 else missing):
            print('  %s %s: %d of %d lost' % (what, value, missing[value], total[value]))
    return kept, len(lost)


def compare_binaries(options):
    """Plant in the own robots or in every folder of DIR, and run two binaries."""
    with tempfile.TemporaryDirectory() as folder:
        if options.robots:
            names = sorted(path.name for path in pathlib.Path(options.robots).iterdir() if path.is_dir() and texts(path))
            for name in names:
                shutil.copytree(pathlib.Path(options.robots, name), pathlib.Path(folder, name), symlinks=True)
        else:
            names = robots.write(folder)
        _, found = measure(list(dict.fromkeys([options.reference, options.bin])), folder, names, options.each)
    kept, lost = report(found[options.reference], found[options.bin])
    print('%d passed, %d failed' % (kept, lost))
    return 0 if kept >= ENOUGH * (kept + lost) else 1


def store(found, path):
    """Write the findings, one defect a line, at most two findings each."""
    lines = ['%s: %s' % (json.dumps(name), json.dumps(found[name][:2])) for name in sorted(found)]
    path.write_text('{\n' + ',\n'.join(lines) + '\n}\n', encoding='utf-8')


def own_robots(options):
    """Plant in the robots of `robots.py` and compare with the stored findings."""
    stored = HERE / 'expected.json'
    with tempfile.TemporaryDirectory() as folder:
        names = robots.write(folder)
        clean, found = measure([options.bin], folder, names, options.each)
    dirty = sorted((name, finding) for name, list_ in clean[options.bin].items() for finding in list_)
    for name, (rule, file, line, message) in dirty:
        print('the clean robot %s has a finding: %s:%d: %s [%s]' % (name, file, line, message, rule))
    found = found[options.bin]
    if options.update:
        store(found, stored)
    expected = json.loads(stored.read_text(encoding='utf-8'))
    changed = sorted(set(expected) ^ set(found))
    for name in changed:
        print('%s: %s' % ('no longer planted' if name in expected else 'not in expected.json, run --update', name))
    kept, lost = report(expected, found)
    good = kept >= ENOUGH * (kept + lost) and kept + lost >= 1000 and not dirty and not changed
    print('%d passed, %d failed' % (kept, lost + len(dirty) + len(changed) if not good else 0))
    return 0 if good else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', required=True, type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument('--update', action='store_true')
    parser.add_argument('--robots', help='a folder with one folder per robot or package')
    parser.add_argument('--reference', type=lambda path: str(pathlib.Path(path).resolve()), help='the binary to compare with')
    parser.add_argument('--each', type=int, default=1, help='places of a kind in a robot [default: 1]')
    options = parser.parse_args()
    if options.robots:
        options.reference or parser.error('--robots needs --reference')
    if options.reference:
        return compare_binaries(options)
    return own_robots(options)


if __name__ == '__main__':
    sys.exit(main())
