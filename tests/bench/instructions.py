#!/usr/bin/env python3
"""Count the instructions of seven fixed runs, and fail when one needs 2 % more than is written down.

    tests/bench/instructions.py --bin target/release/xacro-lint [--update]

Instructions, counted by callgrind, are the same on a busy machine as on a quiet one, and with the same few variables
in the environment from one shell to another. `figures.toml` holds what is
expected, in millions; `--update` writes what was counted. A newer compiler may move all figures by a few in a hundred.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

from robots import EXAMPLES, long_robot

HERE = pathlib.Path(__file__).resolve().parent
FIGURES = HERE / 'figures.toml'
MOST = 1.02
LEAST = 0.90

def count(command):
    """Instructions of a run, in millions."""
    # threads that want the same at the same time may both make it, one time and not the next
    run = subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', *command],
                         stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                         env={'PATH': os.environ['PATH'], 'RAYON_NUM_THREADS': '1'})
    found = re.search(r'Collected : (\d+)', run.stderr)
    if not found:
        sys.exit(f'callgrind said nothing about {command}: {run.stderr[-500:]}')
    return int(found[1]) / 1e6


def runs(binary, folder):
    """Name and command of each run."""
    robot = long_robot(folder, 1000)
    generated = folder / 'long.urdf'
    expanded = subprocess.run([binary, 'expand', robot], stdout=subprocess.PIPE, check=True).stdout
    generated.write_bytes(expanded)
    # without the banner that names the source, which is expanded and compared too
    plain = folder / 'plain' / 'long.urdf'
    plain.parent.mkdir()
    plain.write_bytes(b''.join(line for line in expanded.splitlines(True) if not line.startswith(b'<!--')))
    # a copy: what lies around the checkout, such as packages of npm, would be searched too
    examples = shutil.copytree(EXAMPLES, folder / 'examples')
    # with files for MoveIt and controllers: a figure of its own
    moveit = shutil.move(examples / 'pick_arm', folder / 'pick_arm')
    arm = examples / 'industrial_arm/src/lunder6_support/urdf/lunder6.xacro'
    return {
        'start': [binary, '--version'],
        'expand the example arm': [binary, 'expand', arm],
        'expand 1,000 links': [binary, 'expand', robot],
        'check 1,000 links of plain URDF': [binary, 'check', plain],
        'check 1,000 links of generated URDF': [binary, 'check', generated],
        'check all examples': [binary, 'check', examples],
        'check an arm with MoveIt': [binary, 'check', moveit],
    }


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--bin', required=True)
    parser.add_argument('--update', action='store_true')
    options = parser.parse_args()
    binary = os.path.abspath(options.bin)
    with tempfile.TemporaryDirectory() as folder:
        found = {name: count(command) for name, command in runs(binary, pathlib.Path(folder)).items()}
    if options.update:
        lines = ''.join(f'"{name}" = {figure:.2f}\n' for name, figure in found.items())
        FIGURES.write_text('# Millions of instructions: written by `tests/bench/instructions.py --update`.\n' + lines)
    expected = tomllib.loads(FIGURES.read_text())
    failed = sorted(set(expected) ^ set(found))
    for name in sorted(set(expected) & set(found)):
        share = found[name] / expected[name]
        verdict = 'ok' if share <= MOST else 'more than 2 % above'
        if share < LEAST:
            verdict = 'ok, a tenth below: write it down with --update'
        print(f'{name:36} {found[name]:9.2f} million, {share:5.2f} of what is expected: {verdict}')
        if share > MOST:
            failed.append(name)
    print(f'instructions: {len(expected) - len(failed)} passed, {len(failed)} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
