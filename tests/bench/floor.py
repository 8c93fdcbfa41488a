#!/usr/bin/env python3
"""How far the programs are above the floor: reading and parsing what goes in, in a process that does nothing else.

    tests/bench/floor.py --bin target/release/xacro-lint --floor target/release/deps/floor-*[!.d]

Instructions, counted by callgrind.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

from instructions import count
from robots import EXAMPLES, long_robot


def runs(binary, folder):
    """Name, what is run, and the files that it cannot do without."""
    robot = long_robot(folder, 1000)
    plain = folder / 'long.urdf'
    plain.write_bytes(subprocess.run([binary, 'expand', robot], stdout=subprocess.PIPE, check=True).stdout)
    arm = EXAMPLES / 'industrial_arm/src/lunder6_support/urdf/lunder6.xacro'
    files = subprocess.run([binary, 'deps', arm], stdout=subprocess.PIPE, check=True, text=True).stdout.split()
    return [
        ('start', [binary, '--version'], []),
        ('expand the example arm', [binary, 'expand', arm], [f for f in files if f.endswith('.xacro')]),
        ('expand 1,000 links', [binary, 'expand', robot], [robot]),
        ('check 1,000 links of plain URDF', [binary, 'check', plain], [plain]),
    ]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--bin', required=True)
    parser.add_argument('--floor', required=True)
    options = parser.parse_args()
    binary, floor = os.path.abspath(options.bin), os.path.abspath(options.floor)
    print(f'{"run":34} {"floor":>8} {"this":>8}  million instructions')
    with tempfile.TemporaryDirectory() as folder:
        for name, command, files in runs(binary, pathlib.Path(folder)):
            least, ours = count([floor, *files]), count(command)
            print(f'{name:34} {least:8.2f} {ours:8.2f}  {ours / least:5.1f} times')


if __name__ == '__main__':
    sys.exit(main())
