#!/usr/bin/env python3
"""Time the expansion of our examples and of long robots with the reference xacro and with xacro-lint.

    tests/bench/against_xacro.py --bin target/release/xacro-lint [--runs 7]

Whole processes, turn by turn, the processor time of each as the system counts it. A figure counts only when both
outputs are equal. Installs the reference from PyPI into target/venv when it is not there.
"""
import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(1, str(HERE.parent / 'differential'))
import reference  # noqa: E402
from robots import EXAMPLES, long_robot  # noqa: E402


def robots(folder):
    """Name and file of each input."""
    yield 'gripper of the examples', next(EXAMPLES.glob('two_joint_gripper/**/two_joint_gripper.urdf.xacro'))
    yield 'arm of the examples', next(EXAMPLES.glob('industrial_arm/**/lunder6.xacro'))
    for links in (100, 1000):
        place = folder / str(links)
        place.mkdir()
        yield f'{links} links, sizes from YAML', long_robot(place, links)


def packages(folder):
    """A folder in which the packages of the examples count as installed."""
    share = folder / 'prefix' / 'share'
    index = share / 'ament_index' / 'resource_index' / 'packages'
    index.mkdir(parents=True)
    for manifest in EXAMPLES.glob('**/package.xml'):
        name = ElementTree.parse(manifest).findtext('name')
        (index / name).touch()
        (share / name).symlink_to(manifest.parent)
    return {'AMENT_PREFIX_PATH': str(folder / 'prefix')}


def run(command, folder, env):
    """Processor seconds and output of a run."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=folder, env=env, stdout=subprocess.PIPE, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def canonical(text):
    return ElementTree.canonicalize(text.decode(), strip_text=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--bin', required=True)
    parser.add_argument('--runs', type=int, default=7)
    options = parser.parse_args()
    ours = os.path.abspath(options.bin)
    theirs = reference.command(reference.python())
    ratios, unequal = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        env = reference.environment(packages(folder))
        for robot, path in robots(folder):
            pairs = [(run([*theirs, str(path)], path.parent, env), run([ours, 'expand', str(path)], path.parent, env))
                     for _ in range(options.runs)]
            if any(canonical(a[1]) != canonical(b[1]) for a, b in pairs[:1]):
                print(f'{robot:30} outputs differ')
                unequal += 1
                continue
            slow, fast = (statistics.median(pair[side][0] for pair in pairs) for side in (0, 1))
            # the system counts in small steps, so nothing is quicker than one of them
            ratios.append(slow / max(fast, 1e-4))
            print(f'{robot:30} xacro {slow * 1e3:8.1f} ms   xacro-lint {fast * 1e3:7.2f} ms   {ratios[-1]:6.1f} times')
    print(f'geometric mean {statistics.geometric_mean(ratios):.1f} times, {unequal} with different output')
    return 1 if unequal else 0


if __name__ == '__main__':
    sys.exit(main())
