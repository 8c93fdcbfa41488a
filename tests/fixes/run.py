#!/usr/bin/env python3
"""Fix random robots with random defects: no robot changes by a safe fix.

    tests/fixes/run.py --bin target/release/xacro-lint [--count 120] [--seed 1] [--keep DIR]

Each robot is one of tests/planted with a few defects that the linter can fix, in files of any of its roles. It is fixed
with the default rules or with all of them, and expanded before and after: with its defaults, with each switch turned
over, and with random arguments. Every expansion must describe the same robot, unless it was refused before, or held a tag
that was meant for xacro. A second run changes nothing. Unsafe fixes leave every file as well-formed as it was.
"""
import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ET

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / 'planted')]
import defects  # noqa: E402
import robots  # noqa: E402
import same  # noqa: E402

JOBS = 2
KILLS = 20
ENVIRONMENT = {k: v for k, v in os.environ.items() if not k.startswith(('ROS', 'AMENT', 'CMAKE_PREFIX', 'COLCON'))}
LEAKING = ('without_prefix', 'call_without_prefix')
TURNED = {'true': 'false', 'false': 'true', 'True': 'False', 'False': 'True', '0': '1', '1': '0'}
ARGUMENT = re.compile(r'<xacro:arg\s+name="(\w+)"\s+default="([^"]*)"')


def run(command, *args, folder):
    return subprocess.run([command, *args], cwd=folder, env=ENVIRONMENT, capture_output=True, check=False)


def descriptions(folder):
    return sorted(p.relative_to(folder).as_posix() for p in pathlib.Path(folder).rglob('*') if p.suffix in ('.xacro', '.urdf'))


def text_of(folder, file):
    return pathlib.Path(folder, file).read_bytes().decode('utf-8')


def settings(rng, text):
    """The arguments of the expansions to compare."""
    declared = ARGUMENT.findall(text)
    found = [[]] + [['%s:=%s' % (name, TURNED[value])] for name, value in declared if value in TURNED]
    if declared:
        values = ['maybe', '2', 'true', 'fixed', 'revolute']
        found += [['%s:=%s' % (rng.choice(declared)[0], rng.choice(values))] for _ in range(2)]
    return found


def expanded(command, folder, file, args):
    """The robot; none when it is refused."""
    result = run(command, 'expand', file, *args, folder=folder)
    if result.returncode != 0:
        return None
    text = result.stdout.decode('utf-8').replace(str(folder), '')
    try:
        return same.robot(text)
    except ET.ParseError:
        return None


def differences(command, before, after, planted, rng):
    for file in descriptions(before):
        for args in settings(rng, text_of(before, file)):
            old, new = (expanded(command, folder, file, args) for folder in (before, after))
            if old == new or old is None or new is not None and any(kind in LEAKING for kind in planted):
                continue
            yield '%s %s: %s' % (file, ' '.join(args), 'is refused now' if new is None else 'is another robot')


def new_line_ends(before, after):
    """Whether a text has line ends of a kind that it did not have."""
    bare = re.compile(r'(?<!\r)\n')
    return '\r\n' in before and len(bare.findall(after)) > len(bare.findall(before)) or '\r' in after and '\r' not in before


def well_formed(folder):
    good = set()
    for file in descriptions(folder):
        try:
            ET.fromstring(pathlib.Path(folder, file).read_bytes())
            good.add(file)
        except ET.ParseError:
            pass
    return good


def try_robot(command, sources, place, seed):
    """What is wrong with the fixes of one robot."""
    rng = random.Random(seed)
    before, after = pathlib.Path(place, 'before'), pathlib.Path(place, 'after')
    shutil.copytree(rng.choice(sources), before)
    texts = {file: text_of(before, file) for file in descriptions(before)}
    planted = defects.plant(rng, texts, rng.randrange(1, 5))
    for file, text in texts.items():
        pathlib.Path(before, file).write_bytes(text.encode())
    shutil.copytree(before, after)
    select = rng.choice([[], ['--select', 'ALL']])
    run(command, 'fix', '--exit-zero', *select, '.', folder=after)
    wrong = list(differences(command, before, after, planted, rng))
    wrong += ['%s: line ends' % file for file in texts if new_line_ends(texts[file], text_of(after, file))]
    wrong += ['%s: byte order mark' % file for file in texts if text_of(after, file).startswith('\ufeff') != texts[file].startswith('\ufeff')]
    fixed = {file: text_of(after, file) for file in texts}
    run(command, 'fix', '--exit-zero', *select, '.', folder=after)
    wrong += ['%s: a second run changes it' % file for file in texts if text_of(after, file) != fixed[file]]
    sound = well_formed(before)
    run(command, 'fix', '--exit-zero', '--unsafe-fixes', *select, '.', folder=before)
    wrong += ['%s: broken by unsafe fixes' % file for file in sound - well_formed(before)]
    return ['seed %s, %s %s: %s' % (seed, ' '.join(planted), ' '.join(select), text) for text in wrong], fixed != texts


def try_kills(command, source, place, rng):
    """Kill `fix` at random moments: every file is the old or the new one, and nothing else is left behind."""
    broken = pathlib.Path(place, 'broken')
    shutil.copytree(source, broken)
    for file in descriptions(broken):
        for number in range(40):
            copy = pathlib.Path(broken, file).with_name('copy_%d_%s' % (number, pathlib.Path(file).name))
            copy.write_text(text_of(broken, file).replace('<?xml version="1.0"?>\n', ''))
    old = {file: text_of(broken, file) for file in descriptions(broken)}
    whole = pathlib.Path(place, 'whole')
    shutil.copytree(broken, whole)
    began = time.monotonic()
    run(command, 'fix', '--exit-zero', '--select', 'ALL', '.', folder=whole)
    seconds = time.monotonic() - began
    new = {file: text_of(whole, file) for file in descriptions(whole)}
    wrong, midway = [], 0
    for number in range(KILLS):
        folder = pathlib.Path(place, 'killed_%d' % number)
        shutil.copytree(broken, folder)
        process = subprocess.Popen([command, 'fix', '--exit-zero', '--select', 'ALL', '.'], cwd=folder, env=ENVIRONMENT,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        # most of the time goes into finding what to write
        time.sleep(seconds * rng.uniform(0.5, 1.0))
        process.kill()
        process.wait()
        texts = {file: text_of(folder, file) for file in old}
        wrong += ['killed: %s is neither old nor new' % file for file in old if texts[file] not in (old[file], new[file])]
        midway += texts != old and texts != new
    return wrong, midway


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n\n')[0])
    parser.add_argument('--bin', required=True)
    parser.add_argument('--count', type=int, default=120)
    parser.add_argument('--seed', default='1')
    parser.add_argument('--keep', help='folder for the robots')
    options = parser.parse_args()
    command = str(pathlib.Path(options.bin).resolve())
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(options.keep or folder).resolve()
        names = robots.write(folder / 'sources')
        sources = [folder / 'sources' / name for name in names]
        seeds = ['%s.%d' % (options.seed, number) for number in range(options.count)]
        with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
            outcomes = list(pool.map(lambda seed: try_robot(command, sources, folder / seed, seed), seeds))
        wrong, midway = try_kills(command, sources[0], folder, random.Random(options.seed))
        print('%d kills, %d of them between two files' % (KILLS, midway))
    wrong += [text for texts, _ in outcomes for text in texts]
    changed = sum(changed for _, changed in outcomes)
    print('\n'.join(wrong[:40]))
    print('%d robots, %d of them fixed, %d faults' % (len(outcomes), changed, len(wrong)))
    if changed * 3 < len(outcomes):
        wrong.append('too few robots were fixed for the test to mean anything')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
