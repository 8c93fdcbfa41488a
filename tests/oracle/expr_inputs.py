"""The inputs of `expr_table.py`: expressions that are valid, and texts that are not."""

# As they stand in robot descriptions.
DESCRIPTIONS = """
x
radius
wheel_radius*2
-wheel_separation/2
pi/2
-pi / 2.0
2*pi/3 - 0.1
0.5*mass*(3*r*r + h*h)/12
(1/12) * mass * (y*y + z*z)
mass*radius**2/2
1/12.0*m*(3*r**2+l**2)
reflect*(base_width/2+0.02)
prefix + 'base_link'
prefix+'_wheel_'+suffix
'left' if reflect > 0 else 'right'
1 if use_gripper else 0
radians(90)
math.radians(-45.5)
cos(theta)*length + sin(theta)*width
sqrt(x**2+y**2)
max(a, b, c)
min([1, 2, 3])
not simulation
use_sim and not fake
a or b and not c
name == 'arm'
name != "arm" and index < 3
index in [1, 2, 3]
'x' not in params
side is None
side is not None
0 < i <= count
xacro.load_yaml('config.yaml')
xacro.load_yaml(config_file)['joints']['shoulder'].lower
limits['shoulder_pan']['max_position'] * scale
joint_limits.shoulder.effort
props.links[0].mass
list(range(5))
[i * 2 for i in range(4)]
[x for x in names if x.startswith('arm')]
' '.join([str(v) for v in origin])
str(x) + ' ' + str(y)
'%s_%d' % (name, i)
'{} {}'.format(a, b)
len(wheels) - 1
int(round(angle * 180 / pi))
dict(a=1, b=2)['a']
python.sorted(d.keys(), key=lambda k: d[k])
xacro.arg('name')
xacro.error('bad', x)
xacro.message(f'value {x:.3f} and {y!r}')
name.split('_')[-1].upper()
path[:-5] + '.stl'
values[1:]
values[::2]
values[::-1]
values[i:i+3]
matrix[0][1]
matrix[0, 1]
(x, y, z)[axis]
[1.0, 2.0, 3.0][axis]
{'a': 1, 'b': 2}['a']
a if a else b if b else c
(lambda m, r: m * r ** 2)(mass, radius)
sum([m for _, m in parts])
any(w.driven for w in wheels)
float('inf')
0.0
-1.0
1e-3
1.5E+10
"0 0 0"
'it''s'
True
False
None
inertia.ixx if inertia else 0.001 * mass
abs_filename(pkg) + '/' + file
python.isinstance(x, python.tuple)
math.atan2(y, x) % (2*math.pi)
-(a+b)
+x
~flags & 0xff
1 << 4 | 2
""".strip().splitlines()

ATOMS = """
a
_
_a1
été
名前
match
case
type
print
...
()
[]
{}
(a)
((a))
(a,)
(a, b)
(a, b,)
a,
a, b
a, b,
[a]
[a,]
[a, b]
{a}
{a,}
{a: b}
{a: b,}
{a: b, **c, d: e}
{**a}
{*a, b}
[*a, *b]
(*a,)
(*a, b)
(a := 1)
[a := 1, b]
{a := 1}
f(a := 1)
x[a := 1]
""".strip().splitlines()

NUMBERS = """
0
00
0_0
1_000
1234567890123456789
9223372036854775807
9223372036854775808
123456789012345678901234567890
0x1F
0X_ff
0xDEAD_BEEF_0000_0000_1
0o17
0O7_7
0b101
0B1_0
1.
.5
1.5
1_0.0_1
1e5
1E5
1e+5
1e-05
1.e3
.5e1
1_0e1_0
0e0
00.5
09.5
09e1
1j
1.5J
09j
1e3j
0.1
1e400
1e-400
0x1for x in y
1if a else b
1or 2
1and 2
0xfor 1
1 .real
1..real
1.0.real
0x1.real
1in a
1is a
1not in a
""".strip().splitlines()

STRINGS = r"""
'a'
"a"
''
'a' 'b'
'a' "b" '''c'''
"it's"
'say "x"'
'a\nb'
'\\ \' \" \a \b \f \r \t \v'
'\x41\u00e9\U0001F600'
'\0'
'\101\7\777\18'
'\d\w\ '
'\é'
r'\n'
R"\'"
u'a'
U'a'
b'a'
b'\x41\101\n\d\777'
B"a" b'b'
rb'\x'
bR'\n'
Rb'\n'
'''a'b'''
'é名'
'__'
f''
f'a'
f'{a}'
f'{a}b{c}'
f'{{a}}'
f'{a!r}'
f'{a!s:>10}'
f'{a:{b}}'
f'{a:{b}.{c}}'
f'{a:%Y-{b!r}}'
f'{a=}'
f'{a = }'
f'{a=!s}'
f'{a=:.2f}'
f'{a["b"]}'
f'{a[b:c]}'
f'{a, b}'
f'{a,}'
f'{(lambda x: x)}'
f'{a!=b}'
f'{a==b}'
f'{a<=b}'
f'{a>b}'
f'{ {1: 2}[1] }'
f'{ a }'
f'{a if b else c}'
f'{f"{a}"}'
f'{[x for x in y]}'
f'{x for x in y}'
f'{a}' 'b' f'{c}'
'a' f'b'
rf'\d{a}\n'
fR'{a}'
f'\x41{a}\n'
f'\{a}'
f'{"a" "b"}'
f'{a:}'
""".strip().splitlines()

OPERATORS = """
a+b-c
a-b+c
a*b+c
a+b*c
a*b/c//d%e@f
a**b**c
-a**b
a**-b
a**+b**~c
(-a)**b
-a.b
--a
-+~a
not not a
not a == b
not a in b
a and b or c and d
a or b or c
(a or b) or c
a or (b or c)
a and b and c
a<b<c
a<b==c!=d>e>=f<=g
(a<b)<c
a in b in c
a not in b
a is b is not c
a is not b
not a is not b
a|b^c&d<<e>>f
a<<b+c
a&b==c
a+b<c+d
a if b else c
a if b else c if d else e
(a if b else c) if d else e
a or b if c and d else e or f
lambda: a
lambda a: a
lambda a, b: a
lambda a=1: a
lambda a, b=1, *c, d, e=2, **f: a
lambda *a: a
lambda **a: a
lambda *, a: a
lambda *, a=1, b: a
lambda a, /: a
lambda a, /, b: a
lambda a, b=1, /, c=2, *, d: a
lambda a,: a
lambda *a,: a
lambda **a,: a
lambda a, /,: a
lambda: lambda: a
lambda a: a if b else c
lambda a=lambda: 1: a
a if lambda_ else lambda: b
lambda: (a, b)
(lambda: a)()
lambda: (yield_)
lambda a: (a := 1)
""".strip().splitlines()

POSTFIX = """
a.b
a.b.c
a . b
a.b()
a().b
a()()
a[b]
a[b][c]
a[b].c(d)
a[b,]
a[b, c]
a[b, c,]
a[:]
a[b:]
a[:b]
a[b:c]
a[::]
a[b::]
a[:b:]
a[::b]
a[b:c:d]
a[b:c, d]
a[:, :]
a[::2, ..., None]
a[*b]
a[*b, c]
a[(b, c)]
a[b if c else d:e]
a[lambda: b]
a[b:=c]
f()
f(a)
f(a,)
f(a, b)
f(a, b,)
f(*a)
f(**a)
f(a, *b, c, *d)
f(a=b)
f(a=b,)
f(a, b=c, **d)
f(a=b, *c)
f(**a, b=c)
f(**a, **b)
f(*a, b=c, *d, **e)
f(a if b else c)
f(lambda: a)
f(a for a in b)
f((a for a in b))
f((a for a in b), c)
f(a)(b)(c)
f(a == b)
f(not a)
f(match=1)
f(a)[b]
'a'.join(b)
'%d' % a
(a).b
(a, b)[0]
[a, b][0]
{a: b}[a]
1 if a else 2 .real
"a" "b".upper()
(a)(b)
(a)[b]
-f(a)
a.b**c.d
a[-1]
await_.x
""".strip().splitlines()

COMPREHENSIONS = """
[a for a in b]
[a for a in b if c]
[a for a in b if c if d]
[a for a in b for c in d]
[a for a in b if c for d in e if f]
[(a, b) for a, b in c]
[a for a, in b]
[a for (a, b) in c]
[a for [a, b] in c]
[a for a, *b in c]
[a for a.b in c]
[a for a[0] in c]
[a for a, (b, c) in d]
{a for a in b}
{a: b for a, b in c}
{a: b for a in c if a}
(a for a in b)
(a for a in b for c in d)
[a if b else c for a in d]
[lambda: a for a in b]
[[a for a in b] for b in c]
[a for a in b or c]
[a for a in (b if c else d)]
[a for a in b if a and c]
[a for a in b if (c if d else e)]
[a for a in lambda_]
[a.b for a in b.c]
[y := f(x), y**2]
[y for x in z if (y := x)]
[(y := x) for x in z]
{a: (b, c) for a in d}
{(a, b): c for a in d}
[a for a in range(3)][0]
sum(a*b for a, b in c)
[not a for a in b]
[*a, *[b for b in c]]
""".strip().splitlines()

LAYOUT = [
    "(a\n+\nb)",
    "[\n  a,\n  b,\n]",
    "f(\n  a, # first\n  b=c\n)",
    "a # comment",
    "a\n# comment",
    "a\n",
    "a + \\\n  b",
    "a \\\n+ b",
    "a\t+\x0cb",
    "(a)  ",
    "( a )",
    "( a , b )",
    "f ( a )",
    "a [ b ]",
    "a\n\n  \n",
    "(a\r\n+ b)",
    "(\n\n#c\n\na)",
    "'''a\n\nb''' + c",
    "{\n'a':\n1\n}",
    "(a if\n b else\n c)",
    "a# c",
    "(# c\na)",
    "é + (\nü)",
    "[x\nfor x\nin y\nif z]",
    "'''a\nb'''",
    "\"\"\"a\"b\"\"\"",
    "'a\\\nb'",
    "f'''{a\n}'''",
    "'''a\r\nb'''",
]

# Every pair of operators, for their precedence.
PAIRS = [
    f"a {x} b {y} c"
    for x in ["or", "and", "==", "in", "|", "^", "&", "<<", "+", "*", "**"]
    for y in ["or", "and", "not in", "|", "^", "&", ">>", "-", "%", "**"]
]

VALID = (
    DESCRIPTIONS + ATOMS + NUMBERS + STRINGS + OPERATORS + POSTFIX + COMPREHENSIONS
    + LAYOUT + PAIRS
)

INVALID = [
    # half typed
    "", " ", "# c", "a +", "a + ", "f(1,", "f(", "f(a", "f(a b", "f(a b c", "d['a'", "d['a", "d[", "x.", "x.y.", "(x.)",
    "f(x.)", "f(x.", "[1, 2", "[1, 2 +", "{1:", "{1: 2", "{1", "lambda", "lambda x", "lambda x:", "lambda:", "(lambda",
    "a if", "a if b", "a if b else", "(a if", "(a if b", "(a if b else", "(a if b)", "[a if b]", "f(a if b)", "a and",
    "a or", "not", "a not", "a in", "a is", "a is not", "a <", "a < b <", "a *", "a **", "-", "~", "[x for", "[x for y",
    "[x for y in", "[x for y in z", "[x for y in z if", "[x for]", "[x for y]", "[x for y in]", "[x for y in z if]",
    "[for x in y]", "f(for x in y)", "{for x in y}", "f(a=", "f(a=)", "f(a=, b)", "f(*", "f(*)", "f(**", "f(**)", "f(,",
    "f(,)", "f(a,,b)", "[,]", "[a,,b]", "(,)", "{,}", "a,,b", ",", "a[", "a[]", "a[b", "a[b:", "a[,]", "a[b c]", "(", "[",
    "{", "((a)", "(a, [b", "(a, (b)", "(a :=", "(a :=)", "f(a(b)", "a(b)c", "a[0]b",
    # words
    "a b", "a 1", "1 a", "a 'b'", "'a' b", "(a b)", "(a 'b')", "(1 'b')", "('a' b)", "(a b c)", "[a b]", "[a, b c]",
    "{a b}", "{a: b c: d}", "{a: b, c d}", "f(a b)", "f(a, b c)", "f(a b=1)", "f(a=b c)", "(a not b)", "a not b",
    "(match b)", "(_ b)", "(a lambda: b)", "(a.b c)", "(a + b c)", "(a 1)", "(1 2)", "(a {b})", "(a if b c)",
    "(a if b else c d)", "(lambda: a b)", "[*a b]", "f(*a b)", "f(**a b)", "(a, b c, d)", "(a == b c)", "(not a b)",
    "print a", "(print a)", "print 'a'", "f(print a)", "exec a", "a = 1", "a == b = c", "a += 1", "a := 1",
    "a ; b", "a;", "a: b", "a -> b", "a <> b", "a!", "!a", "a ? b : c", "a$", "`a`", "a && b", "a || b", "a++", "++",
    "a === b", "a => b", "a =< b", "a.1", "a.'b'", "a.(b)", "a..b", "a.if", "if", "if a", "import os", "class", "def f",
    "return a", "for x in y", "while", "pass", "del a", "async", "assert a", "raise", "with", "global a", "from",
    "a from b", "True = 1", "None.1", "else", "a else b", "a if b elif c", "*a", "**a", "*a, b", "a, *b", "(*a)", "(**a)",
    "f(a, b for b in c)", "f(a for a in b, c)", "f(a for a in b,)", "f(a for a in b for)", "f(a=1, 2)", "f(**a, b)",
    "f(**a, *b)", "f(a=1, b, c=2)", "f(a=b for b in c)", "f(a.b=1)", "f(1=2)", "f(True=1)", "f(None=1)", "f(a+b=1)",
    "f(a()=1)", "f(a=1, a=2)", "f(a:=1, b:=)", "f(a==)", "(a=1)", "[a=1]", "(a.b=1)", "(a[0]=1)", "(1=2)", "(a()=1)",
    "('a'=1)", "(a=b=c)", "(a<b=c)", "x[a=1]", "(True=1)", "((a, b)=1)", "([a]=1)", "(a.b:=1)", "(1:=2)", "(a[0]:=1)",
    "((a, b):=1)", "(None:=1)", "(f():=1)", "(lambda: a:=1)", "a[b=c]", "{a=1}", "(a if b else c = 1)", "(-a = 1)",
    # comprehensions
    "[a, b for a in c]", "{a, b for a in c}", "(a, b for a in c)", "[a, for a in c]", "[*a for a in b]", "{*a for a in b}",
    "(*a for a in b)", "{**a for a in b}", "{a: b, c: d for a in e}", "[a for 1 in b]", "[a for f() in b]",
    "[a for a+b in c]", "[a for 'x' in c]", "[a for (a, 1) in c]", "[a for None in c]", "[a for *a in b]",
    "[a for a in b, c]", "[a for a in b if c else d]", "[a for a in b c]", "[a for a in b if c d]", "[a async for a in b]",
    "[a for lambda in b]", "[a for a in *b]", "[a for a of b]", "[a for a]", "(a for a in b, c)", "[a:=1 for a in b]",
    "[a for a in (b:=c)]", "[a for a, *b, *c in d]", "[(a:=1) for a in b]", "[a for b in c for a in (a:=c)]",
    "[[(x:=1) for y in z] for x in w]", "[x for x in [(y:=1)]]", "(lambda: [x for x in (a:=1)])", "[x for x in y for z in lambda: (x:=1)]",
    # brackets
    ")", "]", "a)", "(a))", "(a]", "[a)", "{a)", "(a, [b)", "([a)]", "f(a]", "f(a, [b, c)", "(\na]", "(a\nb", "(a +\nb", "((a\n b c)",
    "(\na b\n", "(a,\nb c", "{a: b", "}", "a}", "f(a}", "{a]", "[(a]", "(1 + 2", "((1 + 2)", "1 + 2)", "x[1", "x[1)", "(a\n= b", "(a\n)b",
    # dicts
    "{1: 2, 3}", "{1:}", "{1:, 2: 3}", "{1: 2, 3:}", "{1, 2: 3}", "{1: *a}", "{**a, b}", "{**}", "{*}", "{: 1}", "{1: 2 3}", "{1: 2,, 3: 4}",
    "{a b: c}", "{1:2, **}", "{1:2, *a}",
    # lambda
    "lambda a a: b", "lambda a=1, b: c", "lambda (a): b", "lambda (a, b): c", "lambda *: a", "lambda *, **a: b", "lambda *, : a",
    "lambda **a, b: c", "lambda **a, *b: c", "lambda *a, *b: c", "lambda *a=1: b", "lambda **a=1: b", "lambda /: a", "lambda a, /, /: b",
    "lambda *a, /: b", "lambda a, a: b", "lambda a, *a: b", "lambda 1: a", "lambda a.b: c", "lambda a=: b", "lambda None: a", "lambda a", "lambda a, b",
    "1 + lambda: a", "a if lambda: b else c", "a == not b", "- not a", "a ** not b", "a + not b", "not lambda: a", "(lambda a", "(lambda a:",
    # numbers
    "1_", "1__0", "0x", "0xg", "0x_", "0b", "0b2", "0b1_", "0b12", "0o", "0o8", "0o18", "012", "0777", "0_7", "00001", "1a", "1abc", "1.5x", "1e", "1e+",
    "1e5x", "1jx", "0xfg", "1.real", "1._5", "1_.5", "1e_5", "1_000_", "0b1a", "0o1a", "1 2", "1.2.3", "08", "09", "1é", "0x1é", "1__", "5m", "10cm", "3.14rad",
    "1if", "1 if", "0b102", "0o_", "1e5_", "1E", "1ex", "1" * 4301,
    # strings
    "'abc", '"abc', "'''abc", '"""abc', "'abc\ndef'", "'''abc\ndef", "'abc\"", "'a' + 'b", "it's", "'\\x'", "'\\x4'", "'\\xg1'", "'\\u12'", "'\\U0011'",
    "'\\U00110000'", "'é\\x4'", "'\\é\\x4'", "b'\\x'", "b'a\\x1'", "b'é'", "b'a' 'b'", "'a' b'b'", "f'a' b'b'", "'\\N'", "'\\N{'", "'\\N{}'", "ur'a'", "bu'a'", "fb'a'",
    "f(\n'abc)", "'a\\", "x'a'", "('a\n')", "rb'é'",
    # f-strings
    "f'{'", "f'}'", "f'{a'", "f'{}'", "f'{ }'", "f'{!r}'", "f'{a!}'", "f'{a!x}'", "f'{a!r'", "f'{a!rr}'", "f'{a:'", "f'{a:{'", "f'{a:{b'", "f'{a b}'", "f'{a +}'",
    "f'{a:{b:{c}}}'", "f'{a\\n}'", "f'{#}'", "f'{(}'", "f'{)}'", "f'{a[}'", "f'{a(]}'", "f'{a['", "f'{\"a}'", "f'{*a}'", "f'{a=!x}'", "f'{012}'", "f'{a}}'", "f'{{a}'", "f'{a=b}'",
    "f'{lambda x: 1}'", "f'{a $ b}'", "f'{1a}'", "f'{f(}'", "f'a {b' + c", "f'''{\na b}'''", "f'{a.}'", "f'{a if b}'", "f'{a:{}}'", "f'{a!r:{b!q}}'", "f'{yield}'", "f'{a}' +",
    "f'{\"'", "f'{x:=5'", "f'{**a}'", "f'{a=1!r'",
    # characters
    "a\u00a0b", "a\u2028b", "\u200ba", "a€", "€", "a “b”", "‘a’", "a – b", "a × b", "2²", "a²", "π/2 °", "½", "a\x01b", "\x7f", "a\\b", "a \\", "\\", "\\ \na", "a \\ b",
    "\ufeffa", "a٣€",
    # lines
    "a\nb", "a\n b", "a +\nb", "a\n+ b", "# c\n a", "a\n  # c\n  b", "\na b", "(a\n+ b\nc)", "a b\nc", "(a)\n(b", "f(a,\n  b c)", "f(a,\n  b,\n  c d", "a\n)", "'a\n b'", "(a +\n", "a,\nb",
    # not for expressions
    "yield", "(yield)", "(yield a)", "yield a", "await a", "(await a)", "await", "f(yield)", "[a async for a in b]", "a async",
]
