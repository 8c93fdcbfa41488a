#!/usr/bin/env python3
"""What one edit costs in a large robot, in instructions: those of 2N edits less those of N, divided by N.

    tests/bench/edits.py BENCH

BENCH is the program that `cargo bench --bench edits --no-run` names. Needs valgrind.
"""
import sys

from instructions import count

N = 3


def main():
    binary = sys.argv[1]
    print('| calls | expansion | check |')
    print('|---|---|---|')
    for calls in (100, 1000):
        cost = {}
        for what, edits in (('expand', N), ('check', N)):
            once, twice = (count([binary, what, str(calls), str(number)]) for number in (edits, 2 * edits))
            cost[what] = (twice - once) / edits
        print(f"| {calls:,} | {cost['expand']:.1f} M | {cost['check']:.1f} M |")


if __name__ == '__main__':
    main()
