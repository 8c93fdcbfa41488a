#!/usr/bin/env python3
"""Print random expressions of the safe subset with what Python makes of them: `expression<TAB>result` a line.

    python_oracle.py --seed N --count N

To be run by a Python 3.11 that has xacro 2.1.1. The result is the repr of the value, or `! ` and the text of the
exception. Nothing here needs much time or memory: powers, shifts and repetitions have small operands.
"""
import argparse
import io
import random
import re
import sys
import warnings

from xacro import create_global_symbols, safe_eval

UNARY = ('abs acos asin atan ceil cos degrees exp fabs floor isfinite isnan radians sin sqrt tan trunc len str '
         'repr int float bool round sorted min max sum list tuple').split()
PLAIN = {'abs', 'len', 'str', 'int', 'float', 'bool', 'round', 'sorted', 'min', 'max', 'sum', 'list', 'tuple'}
METHODS = ('upper lower strip title capitalize swapcase split isdigit isalpha isalnum isspace islower casefold '
           'lstrip rstrip splitlines isupper istitle isidentifier').split()
SPECS = ['', 'd', '.2f', '>8', '^10', '08.3f', 'x', 'e', 'g', ',', '%', 's', '+d', '#b', '.3', '*<6']
TEXTS = ['', 'a', 'left_', 'Wheel 1', 'x y  z', '0.5', '-3', '1e3', 'é', 'ß', '%d', 'a,b,c', 'İ', '\\n', '٣']
NUMBERS = ['0', '1', '-1', '2', '3', '7', '10', '255', '10**20', '2**53+1', '0.0', '-0.0', '0.1', '0.5', '2.5', '1e22',
           '1e-7', '3.14159', '1e308', 'inf', 'nan', 'pi', 'True', 'False', '2j', 'n', 'x', '1_000', '0x1f']


class Maker:
    def __init__(self, rng):
        self.rng = rng

    def expression(self, depth):
        r = self.rng
        if depth == 0:
            return self.leaf()
        kind = r.randrange(14)
        sub = lambda: self.expression(depth - 1)
        if kind < 3:
            op = r.choice(['+', '-', '*', '/', '//', '%', '+', '-', '*'])
            return f'({sub()} {op} {sub()})'
        if kind == 3:
            return f'({sub()} {r.choice(["==", "!=", "<", "<=", ">", ">=", "in", "not in", "and", "or"])} {sub()})'
        if kind == 4:
            return f'({r.choice(["-", "+", "not ", "~"])}{sub()})'
        if kind == 5:
            return f'({sub()} if {sub()} else {sub()})'
        if kind == 6:
            name = r.choice(UNARY)
            name = f'python.{name}' if name in PLAIN and r.random() < 0.3 else name
            return f'{name}({sub()})'
        if kind == 7:
            return f'{sub()}[{r.choice([sub(), "0", "-1", "1:", ":2", "::-1", "1:5:2", ":"])}]'
        if kind == 8:
            items = ', '.join(sub() for _ in range(r.randrange(4)))
            return r.choice([f'[{items}]', f'({items},)' if items else '()'])
        if kind == 9:
            return f'[{sub()} for i in {r.choice([sub(), "l", "python.range(4)", "s"])}{r.choice(["", " if i"])}]'
        if kind == 10:
            return f'{self.text()}.{r.choice(METHODS)}()'
        if kind == 11:
            return self.formatted(sub)
        if kind == 12:
            return f'({r.choice(["2", "-2", "0.5", "n", "x", "10"])} ** {r.choice(["0", "1", "-1", "2", "0.5", "n", "x", "-0.0"])})'
        return self.call(sub)

    def call(self, sub):
        r = self.rng
        return r.choice([
            lambda: f'round({sub()}, {r.choice(["0", "1", "2", "-1", "17"])})',
            lambda: f'max({sub()}, {sub()})', lambda: f'min({sub()}, {sub()})',
            lambda: f'atan2({sub()}, {sub()})', lambda: f'pow({r.choice(NUMBERS[:8])}, {r.choice(["2", "-1", "0.5"])})',
            lambda: f'int({self.text()}, {r.choice(["10", "16", "0", "2"])})',
            lambda: f'{self.text()}.replace({self.text()}, {self.text()})',
            lambda: f'{self.text()}.join({sub()})', lambda: f'{self.text()}.find({self.text()})',
            lambda: f'{self.text()}.startswith({self.text()})', lambda: f'{self.text()}.count({self.text()})',
            lambda: f'{self.text()}.split({self.text()})', lambda: f'{self.text()}.rjust({r.randrange(12)})',
            lambda: f'{self.text()}.zfill({r.randrange(12)})', lambda: f'(({sub()}) * {r.randrange(-1, 4)})',
            lambda: f'dict(a={sub()}, b={sub()})', lambda: f"dict(a={sub()})['{r.choice('ab')}']",
            lambda: f'python.list(python.range({r.randrange(-3, 9)}, {r.randrange(-3, 9)}))',
            lambda: f'python.sorted({sub()}, reverse=True)', lambda: f'(lambda i: {sub()})({sub()})',
            lambda: f'python.list(python.zip({sub()}, l))',
            lambda: f'({r.choice(NUMBERS[:8])} {r.choice(["&", "|", "^", "<<", ">>"])} {r.randrange(9)})',
            lambda: f'{{{sub()}: {sub()}}}', lambda: f'{{{sub()}}}',
        ])()

    def formatted(self, sub):
        r = self.rng
        spec = r.choice(SPECS)
        return r.choice([f"'{{:{spec}}}'.format({sub()})", f"'%{r.choice(['d', 's', '.2f', 'r', 'x', '5d', 'g', 'e'])}' % ({sub()},)",
                         f"'{{}}-{{}}'.format({sub()}, {sub()})", f'f"{{{sub()}:{spec}}}"', f"'{{0[0]}}'.format({sub()})"])

    def text(self):
        return repr(self.rng.choice(TEXTS)) if self.rng.random() < 0.8 else 's'

    def leaf(self):
        r = self.rng
        return r.choice([lambda: r.choice(NUMBERS), lambda: self.text(), lambda: r.choice(['n', 'x', 's', 'l', 'None', 'i']),
                         lambda: repr(round(r.uniform(-10, 10), r.randrange(12))), lambda: str(r.randrange(-50, 50))])()


def result(expression):
    table = create_global_symbols()
    # the same properties as in tests/fuzz/harness/expressions.rs
    table['n'], table['x'], table['s'], table['l'] = 3, 1.5, 'hello world', [3, 1, 2]
    stderr, sys.stderr = sys.stderr, io.StringIO()
    try:
        text = repr(safe_eval(expression, table))
    except RecursionError:
        text = '! maximum recursion depth exceeded'
    except Exception as error:
        text = '! ' + str(error)
    finally:
        sys.stderr = stderr
    text = re.sub(r' at 0x[0-9a-f]{8,}', ' at 0x7f0000000000', text)
    return text.replace('\n', '⏎').replace('\r', '␍')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--count', type=int, default=10000)
    options = parser.parse_args()
    warnings.simplefilter('ignore')
    rng = random.Random(options.seed)
    maker = Maker(rng)
    for _ in range(options.count):
        expression = maker.expression(rng.randrange(1, 5))
        print(f'{expression}\t{result(expression)}')


if __name__ == '__main__':
    main()
