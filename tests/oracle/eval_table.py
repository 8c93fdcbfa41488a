#!/usr/bin/env python3
"""Print `expression<TAB>result` as the reference evaluates it.

Needs xacro 2.1.1 on CPython 3.11. The result is the repr of the value, or `! ` and the text of the
exception. Usage: eval_table.py TABLE, where TABLE is one of those at the end of this file; the output
belongs in src/expr/testdata/TABLE.txt.
"""

import io
import itertools
import json
import random
import re
import struct
import sys

from xacro import Table, YamlDictWrapper, create_global_symbols, get_boolean_value, safe_eval

import eval_expressions as plain


def symbols():
    table = create_global_symbols()
    # The same properties as in the host of the Rust test.
    table['n'] = 3
    table['x'] = 1.5
    table['s'] = 'hello world'
    table['l'] = [3, 1, 2]
    table['cfg'] = YamlDictWrapper({
        'a': 1,
        'b': {'c': 2.5, 'items': 7, 'list': [1, {'k': 'v'}]},
        'names': ['front', 'rear'],
        'rows': [[1, 2], [3, 4]],
        3: 'three',
    })
    return table


def result(expression):
    stderr, sys.stderr = sys.stderr, io.StringIO()
    try:
        text = repr(safe_eval(expression, symbols()))
    except RecursionError:
        text = '! maximum recursion depth exceeded'
    except Exception as error:
        text = '! ' + str(error)
    finally:
        sys.stderr = stderr
    text = re.sub(r' at 0x[0-9a-f]{8,}', ' at 0x7f0000000000', text)
    return text.replace('\n', '⏎')


def expressions():
    seen = set()
    for line in plain.EXPRESSIONS.splitlines():
        line = line.strip()
        if line and not line.startswith('#') and line not in seen:
            seen.add(line)
            yield line


def operators():
    values = ['7', '-3', '0', '2.5', '-0.0', 'True', "'ab'", '[1, 2]', '(1,)', 'None', '1j', '10**20',
              'dict(a=1)', 'python.set([1])', "b'x'", 'python.range(3)', 'len', 'int']
    binary = ['+', '-', '*', '/', '//', '%', '**', '<<', '>>', '&', '|', '^', '@', '==', '!=', '<', '<=', '>', '>=',
              'in', 'is']
    everything = [f'{a} {op} {b}' for a, op, b in itertools.product(values, binary, values)
                  if not (op in ('**', '<<') and b == '10**20')]
    if '--all' in sys.argv:
        chosen = everything
    else:
        chosen = random.Random(1).sample(everything, 1500)
    # CPython warns about `is` with a literal but goes on.
    yield from (e for e in chosen if 'is' not in e.split() or re.match(r'(None|True|len|int) is', e))
    for op, value in itertools.product(['-', '+', '~', 'not '], values):
        yield op + value


def math():
    unary = ['acos', 'acosh', 'asin', 'asinh', 'atan', 'atanh', 'cbrt', 'ceil', 'cos', 'cosh', 'degrees', 'erf',
             'erfc', 'exp', 'exp2', 'expm1', 'fabs', 'floor', 'frexp', 'gamma', 'isfinite', 'isinf', 'isnan', 'lgamma',
             'log', 'log10', 'log1p', 'log2', 'modf', 'radians', 'sin', 'sinh', 'sqrt', 'tan', 'tanh', 'trunc', 'ulp']
    points = ['0', '-0.0', '1', '-1', '0.5', '-0.5', '2', '3.7', '-3.7', '1e-9', '1e-300', '100', '171.5', '1e5',
              '1e308', '-800.0', '710', 'inf', '-inf', 'nan', 'True', '10**30', "'a'", 'None', '10**400']
    rng = random.Random(2)
    for name in unary:
        for point in points:
            yield f'{name}({point})'
        for _ in range(20):
            yield f'{name}({rng.uniform(-6, 6)!r})'
            yield f'{name}({10 ** rng.uniform(-5, 5)!r})'
    binary = ['atan2', 'copysign', 'fmod', 'hypot', 'nextafter', 'pow', 'remainder', 'log']
    points = ['0.0', '-0.0', '1', '-1', '0.5', '2', '-3.7', '1e300', 'inf', '-inf', 'nan']
    for name, a, b in itertools.product(binary, points, points):
        yield f'{name}({a}, {b})'
    for name in binary:
        for _ in range(20):
            yield f'{name}({rng.uniform(-9, 9)!r}, {rng.uniform(-9, 9)!r})'
    for _ in range(60):
        numbers = ', '.join(repr(rng.uniform(-1, 1) * 10 ** rng.randint(-8, 8)) for _ in range(rng.randint(3, 8)))
        yield f'hypot({numbers})'
        yield f'fsum([{numbers}])'
        yield f'python.sum([{numbers}])'
        yield f'prod([{numbers}])'


def formats():
    numbers = ['0', '7', '-42', '1234567', '10**20', 'True', '0.0', '-0.0', '3.14159', '-1234.5678', '1e-7', '1.5e22',
               '0.5', '2.675', '1e16', '123456.0', 'inf', 'nan', "'text'", "'ä€'", '1+2j', 'None']
    specs = ['', 'd', 'x', '#x', 'X', 'o', '#o', 'b', '#b', 'c', 'e', 'E', 'f', 'F', 'g', 'G', 'n', '%', 's', '.0f',
             '.1f', '.2f', '.3e', '.0e', '#.0f', '#.0e', '.3g', '#.3g', '.10g', '.0g', '.3', '.0', '.1', '8', '<8', '>8', '^8', '=8',
             '*^9', '08', '010.3f', '+', '+.2f', ' ', ' d', '-', ',', ',.2f', '_', '_x', '_b', '020,', '020,.2f', '+08d',
             '<08', 'z.1f', 'z', '#', '.3s', '.20f', '.400f', '10s', '-^10', '5%', '.1%', '{', 'q', 'dd', ',,', ',_',
             ',x', '.', '.f', '99999999999999999999', ',s', '=s', 'zd', '+c', '#c', '.2d', 'ds', '<<8', '{<8']
    for number, spec in itertools.product(numbers, specs):
        if '{' not in spec and len(spec) < 10 or number == '7':
            yield f"'{{:{spec}}}'.format({number})" if '{' not in spec else f"'{{:{{}}}}'.format({number}, '{spec}')"
    percent = ['%d', '%5d', '%-5d|', '%05d', '%+d', '% d', '%x', '%#x', '%X', '%o', '%#o', '%#X', '%e', '%.2e', '%f', '%.0f',
               '%#.0f', '%.3f', '%10.2f', '%-10.2f|', '%010.2f', '%+.1f', '%g', '%.3g', '%#g', '%G', '%E', '%s', '%r',
               '%a', '%5s', '%-7s|', '%.2s', '%c', '%5c', '%%', '%i', '%u', '%.5d', '%.5x', '%ld', '%q', '%', '%5', '%.',
               '%(a)s', '%s %s', '%08.3e', '%F', '%.50f', '%+x', '%#05x', '%.0g', '%#.0g', '%.0e']
    numbers.extend(["[1, 'a']", '(1,)', '(1, 2)', '()', 'dict(a=1)', "'c'", '65', '8364', '-1', '1114112', '2**31'])
    for number, spec in itertools.product(numbers, percent):
        yield f"'{spec}' % {number}" if '+' not in number else f"'{spec}' % ({number},)"


def floats():
    rng = random.Random(3)
    values = [0.0, -0.0, 1.0, 0.1, 1e22, 1e23, 5e-324, 1.7976931348623157e308, 2.2250738585072014e-308, 1e16, 1e15,
              9999999999999998.0, 1e-4, 1e-5, 9.999e-5, 123456789.123, float('inf'), float('-inf'), float('nan')]
    values += [float(f'{m}e{e}') for e in range(-30, 31) for m in (1, 1.5, 9.999999999999999)]
    while len(values) < 2000:
        kind = rng.randrange(3)
        if kind == 0:
            value = struct.unpack('<d', struct.pack('<Q', rng.getrandbits(64)))[0]
        elif kind == 1:
            value = round(rng.uniform(-1000, 1000), rng.randint(0, 6))
        else:
            value = rng.uniform(-1, 1) * 10.0 ** rng.randint(-20, 20)
        if value == value:
            values.append(value)
    for value in values:
        print(struct.unpack('<Q', struct.pack('<d', value))[0], repr(value), sep='\t')


def literals():
    """Texts as JSON, the literal they are, and the boolean they are."""
    texts = ['', ' ', '0', '-0', '+1', '007', '-007', ' 42 ', '1 2', '1.5', '1.50', '.5', '5.', '.', '1e3', '1E3', '1e',
             'e3', '1e+3', '1e-3', '1e400', '-1e400', 'inf', '-inf', '+Inf', 'INFINITY', 'infinit', 'nan', '-nan', 'NaN',
             '1_000', '_1', '1_', 'a_b', '0x10', '0b1', '0o7', '1j', 'true', 'True', 'TRUE', 'tRue', ' true', 'false',
             'False', 'yes', 'no', 'on', 'None', "'", "''", "'" * 3, "'a'", "'1'", "''1''", "' 1'", " '1'", "'1' ", '"1"',
             "'a", "a'", "'1_0'", '--1', '+-1', '- 1', '1-1', '1,5', '٣', '٣.٥', '१२', '１２', '1٣', '²', '½', '\u00a012\u2003',
             '\u200b1', '1\n', '\t1', '\x1c5\x1f', '5\x00', '1.5f', '1d', '1L', '99999999999999999999',
             '-99999999999999999999', '9' * 4300, '9' * 4301, '1' + '0' * 400, '0.1e1', '00.5', '1.e5', '.e5', '+.5',
             '-.5e-5', 'infinity ', 'i', 'n', 't', 'f', 'base_link', 'base', '0 0 1', '1 ', '𝟏𝟐', '𝟘', '𝟿', '\u0be6', '1e٣',
             '\u22121', '1\u066b5', '1e1_0', 'Infinity', 'iNfInItY', 'nanx']
    rng = random.Random(4)
    for _ in range(400):
        texts.append(''.join(rng.choice("0011259.+-eE_ 'xinfatrue٣") for _ in range(rng.randint(1, 6))))
    for text in dict.fromkeys(texts):
        try:
            boolean = get_boolean_value(text, None)
        except Exception:
            boolean = None
        value = Table._eval_literal(text)
        shown = type(value).__name__ if isinstance(value, int) and abs(value) > 10**4000 else ascii(value)
        print(json.dumps(text), shown, boolean, sep='\t')


TABLES = {'literals': literals, 'eval': expressions, 'operators': operators, 'math': math, 'format': formats, 'floats': floats}

if __name__ == '__main__':
    for line in TABLES[sys.argv[1]]() or ():
        print(line, result(line), sep='\t')
