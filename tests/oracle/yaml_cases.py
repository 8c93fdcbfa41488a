#!/usr/bin/env python3
"""yaml_cases.py: write yaml_cases.json, what PyYAML's safe loader makes of the texts below.

Run with the Python whose PyYAML is the reference (6.0.3). The tables here are the inputs; `yaml_cases.json`
holds `[text, value or null, error or null]` per case, the value as Python's `repr`, with the members of
sets sorted.
"""
import io
import json
import os
import sys

import yaml

# One plain scalar each.
SCALARS = """
yes Yes YES yEs no No NO nO on On ON off Off OFF oN true True TRUE tRue false False FALSE y Y n N t f
~ null Null NULL nUll None nil
0 1 -1 +1 00 01 07 08 09 010 012 0777 -012 +012 0o14 0O14 0b101 0B101 -0b11 0b 0b_ 0b2 0x1F 0X1F 0x -0xff
0x_f 0x_ 0xg 1_000 1__0 _1 1_ 0_ 0_7 0_8 123456789012345678901234567890 -99999999999999999999
1:30 1:30:45 -1:30 +1:30 1:60 1:5 01:30 0:30 1:30:60 190:20:30 1:30.5 1:30:45.25 -1:30.5 0:30.5 1:30. 1:3:.5
1.0 1. .5 -.5 +.5 -1.5 +1.5 0.0 -0.0 00.5 1.5e3 1.5e+3 1.5E+3 1.5e-3 1e3 1.0e3 1e+3 1.0e+3 12e03 1e-3 .5e+1
.e+1 1.5e+ 1.e+2 1_000.5 0.1_5 1._5 1.5_ _1.5 ._5 1.5e+1_0 1.7976931348623157e+309 5.0e-324 1.0e-400 1.0e+16
123456789.123456789 0.1 0.30000000000000004 100000000000000000000000.0 1.5e+300
.inf .Inf .INF -.inf +.inf .iNf .nan .NaN .NAN -.nan +.nan .Nan inf nan Infinity NaN - -- --- . .. ... -. +. + +- 1+1 1-1
2001-01-01 2001-1-1 2001-12-14t21:59:43.10-05:00 2001-12-14T21:59:43Z 2001-12-14t21:59:43 2001-01-01T1:02:03
2001-01-01t01:02:03.1234567 2001-01-01t01:02:03. 2001-01-01t01:02 2001-13-01 2001-02-29 2000-02-29 1900-02-29 0000-01-01
2001-01-32 2001-00-10 9999-12-31 2001-01-01t25:00:00 2001-01-01t01:60:00 2001-01-01t01:02:60 2001-01-01t01:02:03+5
2001-01-01t01:02:03+05:30 2001-01-01t01:02:03-00:30 2001-01-01t01:02:03+00:00 2001-01-01t01:02:03+24:00 02001-01-01
2001-01-01t01:02:03-23:59 2001-01-01t00:00:00 20010101 2001-01 2001-1-1T1:02:03
= == << < <<< <=  a a:b :a a:: ::a a#b ?a -a -1a ?x a? key. $x ${x} $(find a) a,b a]b a}b [] {} [a] {a} {a:b}
/dev/null http://a/b?c=d a&b a*b a!b a|b a>b a'b a"b a%b a@b a`b ' ' 'a' 'yes' "1" "" '' 'it''s' "a\\tb" é 日本 °
1.2.3 1,000 1e 0e0 e1 .e 1.0.0 1:2:3:4 12:30:45:50 -0 +0 -00 0xFFFFFFFFFFFFFFFFFFFF 3.14159265358979323846 1e400
!!int 5
"""

SCALAR_LINES = [
    "2001-12-14 21:59:43.10 -5", "2001-12-15 2:59:43.10", "2001-12-14 21:59:43 Z", "2001-01-01  01:02:03",
    "2001-01-01\t01:02:03", "a b", "a  b", "yes no", "1 2", "a # comment", "a #comment", "a#b c", "- a", "? a",
    "!!int 5", "!!int '5'", "!!int 0x10", "!!int 010", "!!int 0o17", "!!int 1:30", "!!int abc", "!!int ''", "!!int 1.5",
    "!!int ' 7 '", "!!int -", "!!int 08", "!!int 1_0", "!!int +5", "!!int 0b11", "!!int",
    "!!float 1", "!!float 1e3", "!!float '1e3'", "!!float abc", "!!float inf", "!!float .inf", "!!float -.inf",
    "!!float nan", "!!float 1:30", "!!float ''", "!!float -1_0.5", "!!float",
    "!!str 5", "!!str yes", "!!str", "!!str ''", "!!str ~", "!!bool yes", "!!bool 'no'", "!!bool 1", "!!bool maybe",
    "!!bool", "!!null ''", "!!null abc", "!!null", "!!binary aGVsbG8=", "!!binary aGVsbG8", "!!binary 'aGVs bG8='",
    "!!binary a", "!!binary '='", "!!binary ''", "!!binary é", "!!binary éé", "!!binary 'a=b='",
    "!!timestamp 2001-01-01", "!!timestamp '2001-1-1'", "!!timestamp abc", "!!set {a}", "!!set {a, b: 1, a}",
    "!!set [a]", "!!set a", "!!omap [a: 1, b: 2, a: 3]", "!!omap {a: 1}", "!!omap [a]", "!!omap [{a: 1, b: 2}]",
    "!!omap []", "!!omap x", "!!pairs [a: 1, a: 2]", "!!pairs {a: 1}", "!!pairs [[a, 1]]", "!!seq [a]", "!!seq {a: 1}",
    "!!seq a", "!!map {a: 1}", "!!map [a]", "!!map a", "!!str [a]", "!!str {a: 1}", "!!int [1]", "!!str {=: a}",
    "!!unknown a", "!local a", "!local [a]", "!local {a: 1}", "!<tag:yaml.org,2002:int> 7", "!<!radians> 7", "! 12",
    "! 'a'", "! [a]", "!<a", "!e!x a", "!a!b!c x", "!%61 x", "!%c3%a9 x", "!%ff x", "!%zz x", "!é x",
    "!radians pi/2", "!degrees 90", "!degrees '45 * 2'", "!meters 1", "!millimeters 5", "!foot 1", "!inches 1",
    "!degrees", "!degrees [1]", "!degrees {a: 1}", "!Degrees 90", "!deg 90", "!!python/object:os.system x",
    "!!python/tuple [1]", "!!python/none x", "!!value a", "!!merge a",
    '"\\x41\\u00e9\\U0001F600"', '"\\0\\a\\b\\e\\f\\n\\r\\t\\v\\N\\_\\L\\P\\/\\\\\\""', '"\\q"', '"\\x4"', '"\\u12"',
    '"a\\ b"', '"a\\\tb"', "'a\\nb'", "'a\"b'", "\"a'b\"", '"\\U00110000"',
    "&a x", "&a", "&a [1, 2]", "*a", "&a.b x", "&a-b_1 x", "& x", "* x", "&é x", "&a &b x", "&a !!int 5", "!!int &a 5",
    "!!int !!str 5", "&a *b", "[&a x, *a]", "[&a x, *a, *b]", "[&a x, &a y]", "[&a x, *a , *a]", "{&a x: *a}", "{*a : b}",
    "[&a [1], *a]", "[&a {k: v}, *a]",
]

DOCUMENTS = [
    "", "\n", " ", "# only a comment", "---", "---\n...", "...", "--- a", "--- a\n...", "---\na: 1", "a: 1\n...\n",
    "a: 1\n---\nb: 2", "---\n---\n", "--- a\n--- b", "a\n...\nb", "a\n...\n---\nb", "%YAML 1.1\n---\na", "%YAML 1.2\n--- 012",
    "%YAML 2.0\n--- a", "%YAML 1.1\n%YAML 1.1\n--- a", "%YAML 1\n--- a", "%YAML x\n--- a", "%YAML 1.1 x\n--- a",
    "%YAML 1.1\na", "%TAG ! tag:yaml.org,2002:\n--- !int 5", "%TAG !y! tag:yaml.org,2002:\n--- !y!int 5",
    "%TAG !y! a\n%TAG !y! b\n--- x", "%TAG y a\n--- x", "%TAG !y a\n--- x", "%TAG !y!\n--- x", "%FOO bar baz\n--- a", "%\n--- a",
    "%FOO!\n--- a", "a\n%FOO\n", "\ufeffa: 1", "\ufeff", "a: \ufeffb",
    "a: 1", "a: 1\nb: 2", "a:\n  b: 1\n  c: 2", "a:\n  - 1\n  - 2", "a:\n- 1\n- 2", "a:\n- 1\nb: 2", "- a\n- b", "- - a\n  - b",
    "- a: 1\n  b: 2\n- c", "-\n  a: 1\n-\n  - b", "- a:\n  - b\n  - c", "-\n-\n- a", "a:\nb:\n", "a:", "a: # comment\n  1",
    "a: 1 # comment\n# another\nb: 2", "a: x\n   y\n  z", "a: x\n\n   y", "a\n b\n c", "a: 'x\n  y'", "a: 'x\n\n  y'",
    'a: "x\n  y"', 'a: "x\\\n  y"', 'a: "x\\\n\n  y"', 'a: "x  \n  y"', 'a: " x "', "a: 'x \n\n\n y'",
    "a: |\n  x\n  y\n", "a: |\n  x\n  y", "a: |-\n  x\n", "a: |+\n  x\n\n\nb: 1", "a: |2\n   x\n  y\n", "a: |1\n  x\n", "a: |-2\n  x",
    "a: |2-\n  x", "a: >\n  x\n  y\n\n  z\n", "a: >\n  x\n   y\n  z\n", "a: >-\n  x\n  y", "a: >+\n  x\n\n", "a: |\n\n\n  x\n",
    "a: |\n   \n  x\n", "a: |\nb: 1", "a: |", "a: >", "- |\n a\n- >\n b", "|\n a\n b", "--- |\n a", "a: | # c\n  x", "a: |\n  # no\n  x",
    "a: >\n  x\n  \n  y", "a: >\n\tx", "a: |\n  x\n # c\nb: 1", "a: >\n  x\n\n   y\n\n  z\n",
    "{}", "[]", "{a: 1}", "{a: 1, b: 2}", "{a: 1,}", "[a, b]", "[a,]", "[a, b: c]", "[a: b, c]", "{a, b}", "{a: , b: }", "{? a: b}",
    "[? a : b]", "[?a: b]", "{? a, b}", "{a:1}", '{"a":1}', "{'a':1}", "{a: [b, {c: d}]}", "{\n a: 1,\n b: 2\n}", "[\na,\nb\n]",
    "a: [1,\n2]", "a: {b: 1,\nc: 2}", "[a b, c d]", "[a\n b]", "{a\n b: c}", "[1, 2 , 3]", "[a#b, c]", "[a #b\n, c]", "[http://x/y]",
    "[a:b]", "[a::b]", "{a: b:c}", "[-1, - 1]", "[-, a]", "[a?b]", "[a, ?]", "{a: {b: {c: {}}}}", "[[], [[]], {}]", "[[a], {b: c}]",
    "{a: b}: c", "[a]: b", "? a\n: b", "? a", "? - a\n: b", "? [a]\n: b", "? {a: 1}\n: b", "? |\n  a\n: b", "? a\n? b\n", ": a", "? a\n:\n- b",
    "{[a]: b}", "{{a: 1}: b}", "a: b: c", "a: - b", "a b: c", "'a': 1", '"a b": 1', "1: a\ntrue: b\n1.0: c", "1: a\n1: b", "yes: 1\ntrue: 2",
    ".nan: 1\n.nan: 2", "~: 1", ": 1\n", "0.5: a", "2001-01-01: a", "a: 1\na: 2\nb: 3\na: 4", "1.5: x\n1.5: y", "-0.0: a\n0: b",
    "base: &b {x: 1, y: 2}\nd:\n  <<: *b\n  y: 3\n  z: 4", "base: &b {x: 1}\nd:\n  y: 3\n  <<: *b", "a: &a {x: 1}\nb: &b {x: 2, y: 3}\nc: {<<: [*a, *b], z: 1}",
    "c: {<<: {x: 1}, <<: {x: 2}}", "c: {<<: [{x: 1}, {x: 2}]}", "<<: {a: 1}", "<<: a", "<<: [a]", "<<: [[a]]", "<<: []", "<<:", "'<<': {a: 1}", "a: <<",
    "- <<", "&a a: 1\nb: *a", "a: &x 1\nb: *x\nc: [*x, *x]", "a: &x [1, 2]\nb: *x", "a: &x\n  k: v\nb: *x", "a: &x\nb: *x", "a: &x # c\n  b",
    "x: &a {k: 1}\ny: &b {<<: *a, l: 2}\nz: {<<: *b, m: 3}", "!!map\na: 1", "--- !!map\na: 1", "a: !!str 012\nb: !!int '7'", "a: !degrees 90\nb: !radians pi",
    "a: !!set\n  ? x\n  ? y", "a: !!omap\n  - x: 1\n  - y: 2", "a: !!binary |\n  aGVs\n  bG8=", "a: =", "=: a", "? =\n: b", "[=]", "!!set {[a]}",
    "joint_limits:\n  shoulder_pan:\n    has_position_limits: true\n    min_position: !degrees -360.0\n    max_effort: 330.0\n  elbow:\n    max_velocity: !degrees  191.0\n",
    "mesh_files:\n  base:\n    visual:\n      mesh:\n        package: ur_description\n        path: meshes/visual/base.dae\n", "a: 1\n\n\n\nb: 2\n\n",
    "a:\n    b: 1\n    c:\n        - 1\n        -   x: 1\n            y: 2\n", "a: 1\r\nb: 2\r\n", "a: |\r\n  x\r\n  y\r\n", "a: 1\rb: 2", "a: x\u2028 y", "a: 'x\u2029y'",
    "a: x\x85b: 2", "a: 'x\n  \n  y'", "# c\na: 1\n# d\n", "a: '#x'", "a: x#y", "a:#b", "a :b", "a : b", "a:  b", "'a' : b", "?a: b", "-a: b", "- -a", "a: -b",
    "a: ?b", "a: :b", "a: 'b' # c", "a: [b] # c", "a: {b: c} # d", "a: *b", "k: &a\n  <<: {x: 1}\nl: *a", "a: &a {b: 1}\nc: {<<: *a, <<: *a}",
    "key with spaces: v", "a.b: 1", "a/b: 1", "\"\": 1", "'': ''", "? ''\n: 1", "a: >-\n  folded\n  text\n\n  para\nb: x", "[{a: 1}, {b: 2}]", "- {a: 1}\n- {b: 2}",
    "a:\n  - b\n  -\n    c: 1\n  - - d", "{a: 'x', b: \"y\"}", "{a: x y, b: z}", "a: [\n  1, 2, # one\n  3\n]", "a: {\n  b: 1\n  }\n", "a: [1, 2\n]\nb: 1", "a: [\n]\n",
    "--- # c\na: 1", "---\n# c\n--- \n", "a: 1\n... # c\n", "a: '''x'''", "a: 'x''y'", "- \"a\"\n- 'b'", "a: !!str\nb: 1", "a: !!null\nb: !!str ''",
]

BROKEN = [
    "a: 1\n b: 2", "a:\n  b: 1\n c: 2", "a: 1\n  b: 2", "a\nb: 1", "a: 1\nb\n", "a: 1\nb", "a: [1, 2", "a: {b: 1", "a: [1 2]: 3", "[1, 2", "{a: 1", "[a, b}", "{a: b]",
    "]", "}", ",", "[,]", "[a,,b]", "{,}", "{a: 1,, b: 2}", "a: ]", "a: b]\nc: }", "a: 'x", 'a: "x', "a: 'x\nb: 1\n", "a: \"x\n---\ny\"", "a: 'x\n...\n'", "\ta: 1", "a:\n\tb: 1", "a: 1\n\tb: 2",
    "a: 1\n\t\nb: 2", "a:\t1", "a: \t1", "a: 1\t", "a: 1\t# c", "-\ta", "- a\n\t- b", "[a,\tb]", "[\ta]", "{a:\t1}", "a: @b", "a: `b", "@a", "`a", "a: %b", "%a: 1", "a: |x\n  y", "a: |0\n  y", "a: |10\n x",
    "a: > x\n  y", "a: |+-\n  x", "- a\nb: 1", "a: 1\n- b", "- a\n b", "a:\n- b\n c", "a: - b\n- c", "a: b\n  - c", "? a\n- b", "- ? a\n  - b", "a: b: c: d", "a: 'b': c", "a: 'b' c", "a: \"b\" c", "'a' b: 1",
    "a: [b] c", "a: {b: c} d", "[a] b", "{a: 1} b", "a: *", "a: &", "a: *a*", "a: &a*b c", "*a: 1", "a: !", "a: !!", "a: !<>", "!a!", "!!int,5", "a: [!!int,5]", "a: 1\n: 2", "a\n: 1", "'a\nb': 1", "\"a\nb\": 1",
    "? a\nb", "[a\n b: c]", "[a: b: c]", "{a: b: c}", "a: |\n x\ny", "a: |\n  x\n y", "a: 1\n---\nb: [", "a: &x *x", "a: &x [*x]", "&a {k: *a}", "&a {*a : 1}", "a: \x07", "\x01", "a: \x7f", "a: \ufffe", "a: b\x00c",
    "long" * 300 + ": 1", "? " + "long" * 300 + "\n: 1", "[" + "x" * 1100 + ": 1]", "a: 1\n" + "x" * 1100 + ": 2", "{" + "x" * 1100 + ": 1}", "%", "a: 1\n%x", "--- a\n%YAML 1.1\n---\nb", "--- %x", "---a", "--- - a", "--- a: 1", "...a", "a: ---", "a:\n---", "a: '\n---'",
    "a: !e!x b", "a: 0b_", "a: !!int x\nb: !!float y", "a: {b: !!int x}\nc: !!float y", "a: [!nope 1]\nb: !nada 2", "- [[1], {[]: 2}]", "{[]: 1}", "{{}: 1}", "? {a: 1}", "!!set {{}: 1}", "a: !!binary a\nb: 1", "robot:\n  name: x\n   links: 3\n", "robot:\n  links:\n   - a\n  - b\n",
    "wheel_radius: 0.1\nwheel_width 0.2\nmass: 3\n", "a: ${b}\nc: {d}: e", "a: $(find x)/y: z", "limits: {lower: -1, upper: 1\neffort: 5\n", "- a\n-b\n", "a:b\nc: 1", "a: 1,\nb: [1, 2, 3\nc: 4\n",
]


class Unit:
    """A scalar with one of xacro's unit tags, not evaluated."""

    def __init__(self, name, text):
        self.name, self.text = name, text

    def __repr__(self):
        return 'Unit(%r, %r)' % (self.name, self.text)


class Loader(yaml.SafeLoader):
    pass


for unit in ('radians', 'degrees', 'meters', 'millimeters', 'foot', 'inches'):
    Loader.add_constructor('!' + unit, lambda loader, node, name=unit: Unit(name, loader.construct_scalar(node)))


def show(value):
    if type(value) is dict:
        return '{%s}' % ', '.join('%s: %s' % (show(k), show(v)) for k, v in value.items())
    if type(value) is list:
        return '[%s]' % ', '.join(map(show, value))
    if type(value) is tuple:
        return '(%s)' % ', '.join(map(show, value))
    if type(value) is set:
        return '{%s}' % ', '.join(sorted(map(show, value))) if value else 'set()'
    return repr(value)


def run(text):
    # As a file opened in text mode hands it to the loader.
    stream = io.StringIO(text.replace('\r\n', '\n').replace('\r', '\n'))
    stream.name = 'f.yaml'
    try:
        return show(yaml.load(stream, Loader)), None
    except RecursionError:
        return None, 'recursion'
    except Exception as error:
        return None, str(error)


def main():
    scalars = [text for line in SCALARS.strip().splitlines() for text in line.split()] + SCALAR_LINES
    sections = {'scalars': scalars, 'documents': DOCUMENTS, 'broken': BROKEN}
    target = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'yaml_cases.json')
    with open(target, 'w') as out:
        lines = ['%s: [\n%s\n]' % (json.dumps(name), ',\n'.join(json.dumps([text, *run(text)]) for text in texts))
                 for name, texts in sections.items()]
        out.write('{%s}\n' % ',\n'.join(lines))
    return 0


if __name__ == '__main__':
    sys.exit(main())
