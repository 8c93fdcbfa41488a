"""Expressions for eval_table.py, one per line."""

EXPRESSIONS = r"""
# literals and names
1
0x1F
0b101
1_000
12345678901234567890123
1.5e3
.5
1e400
2j
1.5e3j
'a' "b"
b'ab\x00\n\'"'
r'\n'
None
...
True
pi
e
tau
inf
-inf
nan
undefined_name
n
x
s
l

# arithmetic
n*x + 2
1 + 2 * 3 - 4 / 5
2 ** 3 ** 2
-2 ** 2
(-2) ** 2
2 ** -1
0 ** -1
0.0 ** -1
0 ** 0
(-8) ** (1/3)
(-8.0) ** 2
10 ** 20
10 ** -20
2 ** 0.5
1e200 * 1e200
1e200 ** 2
(-1e200) ** 3
7 // 2
-7 // 2
7 // -2
7.5 // 2
-7.5 // 2
7 % 3
-7 % 3
7 % -3
7.5 % 2
-7.5 % 2
-1e-20 % 3
5.0 % -0.5
1 / 3
4 / 2
10**400 / 10**399
10**400 / 3
1 / 10**400
(10**400 + 1) / 10**400
3 / 10**30
10**30 / 7
-(10**30) / 7
(2**53 + 1) / 1
(2**60 + 1) / 3
(2**53 + 1) * 1.0
10**400 * 1.0
10**400 + 1.5
1 / 0
1 // 0
1 % 0
1.0 / 0
1.0 // 0
1.0 % 0
1 / 0.0
10**30 // 0
10**30 % 0
10**30 // 7
-10**30 // 7
-10**30 % 7
10**30 % -7
1 << 3
1 << 70
1 << -1
1 >> -1
-5 >> 1
5 >> 100
-5 >> 100
10**30 >> 90
1 << 10**20
0 << 10**20
6 & 3
6 | 3
6 ^ 3
-6 & 3
~5
~True
True + True
True & False
True | False
True ^ True
True & 1
-True
9223372036854775807 + 1
-9223372036854775808 - 1
9223372036854775807 * 2
-9223372036854775808 // -1
-(-9223372036854775808)
9223372036854775807 ** 2
3037000500 * 3037000500
(1+2j) * (3-4j)
(1+2j) / (3-4j)
(1+2j) ** 2
(1+2j) ** 0.5
(1+2j) ** -2
(1+2j) ** (1+1j)
0j ** -1
0j ** 1j
0j ** 0
(1+2j) / 0
(1+2j) // 1
(1+2j) % 1
1j * 1j
-1j
+1j
1j == 1j
0j
-0j
1j - 1j
python.complex(-0.0, -0.0)
python.complex(1e20, -1e-7)
python.complex('1+2j')
python.complex(' ( 1e3-.5J ) ')
python.complex('j')
python.complex('-j')
python.complex('1')
python.complex('nan+infj')
python.complex('1+2')
python.complex('1 + 2j')
python.complex('')
python.complex()
python.complex(1)
python.complex(1, 2)
python.complex(1j, 1j)
python.complex(real=1, imag=3)
python.complex([1])
python.complex('1', 2)
python.complex(1, '2')
python.complex(1, [])
python.abs(3+4j)
(1+2j).real
(1+2j).imag
(1+2j).conjugate()
(3).real
(3).imag
(3).numerator
(3).denominator
True.real
2.5.real
2.5.imag
1 + 1j < 2
python.complex(1,2) + 'a'

# comparison
1 < 2 < 3
1 < 3 < 2
3 > 2 > 1 > 0
1 == 1.0
1 == True
0 == False
2**53 == 2.0**53
2**53 + 1 == 2.0**53
10**400 > 1e308
10**400 < inf
-10**400 > -inf
1 < nan
nan == nan
nan != nan
nan in [nan]
[nan] == [nan]
10**20 == 1e20
10**22 == 1e22
10**23 == 1e23
9007199254740993 < 9007199254740992.0
9007199254740993 > 9007199254740992.0
9223372036854775807 < 9223372036854775808.0
'a' < 'b'
'a' < 'B'
'ä' > 'z'
'abc' < 'abd'
'a' < 1
1 < 'a'
None < 1
[1,2] < [1,3]
[1,2] < [1,2,0]
[1,'a'] < [1,2]
(1,2) < (1,2)
(1,2) <= (1,2)
[1] < (1,)
[1] == (1,)
dict(a=1) == dict(a=1.0)
dict(a=1) == dict(b=1)
dict(a=1) < dict(a=1)
1 is 1
None is None
None is not None
True is True
[] is []
l is l
l is not l
'a' in 'abc'
'' in ''
'd' not in 'abc'
1 in 'abc'
None in 'abc'
1 in [1,2]
1.0 in [1,2]
'1' in [1,2]
3 in python.range(5)
3.0 in python.range(5)
3.5 in python.range(5)
10**20 in python.range(5)
'a' in python.range(5)
'a' in dict(a=1)
[] in dict(a=1)
1 in 5
1 in None
1 in python.set([1])
[] in python.set([1])
python.set([1]) in python.set([python.frozenset([1])])
(1, 2) in python.zip([1], [2])
b'a' in b'abc'
97 in b'abc'
300 in b'abc'
'a' in b'abc'

# boolean
1 and 2
0 and 2
0 or 'x'
'' or None
not ''
not [0]
1 and 0 or 3
1 if [] else 2
'a' if 1 else 1/0
0 and 1/0
1 or 1/0
bool('false')
bool(0.0)
bool([])
bool()
bool(1, 2)
bool(x=1)
bool(len)
bool(nan)
bool(0j)

# strings
s.upper()
s.title()
s.capitalize()
s.swapcase()
'ÄÖß'.lower()
'straße'.upper()
'ß'.casefold()
'ΑΣ'.lower()
'ΣΑΣ'.title()
'ǆ'.title()
'ŉ'.title()
'ﬁne'.capitalize()
'ıI'.swapcase()
"they're bill's".title()
'x1y2'.title()
s.split()
' a  b c '.split()
' a  b c '.split(' ')
' a  b c '.split(None, 1)
' a  b c '.rsplit(None, 1)
'a,b,c'.split(',', 1)
'a,b,c'.rsplit(',', 1)
'a,b,c'.split(sep=',', maxsplit=1)
'a,b,c'.split(',', maxsplit=-1)
'a,b,c'.split(',', 0)
' a b '.split(None, 0)
' a b '.rsplit(None, 0)
'abc'.split('')
'abc'.split(1)
'abc'.split('b', 'c')
'abc'.split('b', 1.5)
'abc'.split('b', 1, 2)
'abc'.split(foo=1)
''.split()
''.split(',')
'aXbXc'.partition('X')
'aXbXc'.rpartition('X')
'abc'.partition('X')
'abc'.rpartition('X')
'abc'.partition('')
'abc'.partition(1)
'a\nb\r\nc\rd\x0be\x1cf\u2028g'.splitlines()
'a\nb\r\nc'.splitlines(True)
'a\n\nb\n'.splitlines(keepends=True)
''.splitlines()
','.join(['a','b'])
','.join('abc')
','.join(['a', 1])
','.join([1])
','.join(5)
','.join([])
','.join(str(i) for i in python.range(3))
','.join(map(str, l))
','.join(dict(a=1,b=2))
','.join()
'-'.join(cfg.names)
'a-b'.replace('-', '+')
'aaa'.replace('a', 'b', 2)
'aaa'.replace('a', 'b', -1)
'abc'.replace('', '-')
'abc'.replace('', '-', 2)
''.replace('', 'x')
'abc'.replace('a')
'abc'.replace('a', 1)
'abc'.replace(1, 'a')
'abc'.replace('a', 'b', 'c')
'hello'.find('l')
'hello'.rfind('l')
'hello'.find('l', 3)
'hello'.find('l', 4)
'hello'.find('l', -2)
'hello'.find('', 5)
'hello'.find('', 6)
'hello'.find('lo', 0, 4)
'héllo'.find('l')
'héllo'.rfind('l', 0, -1)
'hello'.index('z')
'hello'.rindex('l')
'hello'.find(1)
'hello'.find()
'hello'.find('a', 'b')
'hello'.count('l')
'hello'.count('')
'hello'.count('l', 3)
'aaaa'.count('aa')
'hello'.startswith('he')
'hello'.startswith(('x', 'he'))
'hello'.startswith('l', 2)
'hello'.startswith('', 5)
'hello'.startswith('', 6)
'hello'.startswith(1)
'hello'.startswith((1,))
'hello'.startswith()
'hello'.endswith('lo')
'hello'.endswith(('x', 'lo'))
'hello'.endswith('l', 0, 4)
'hello'.endswith(1)
'  x '.strip()
'  x '.lstrip()
'  x '.rstrip()
'xxaxx'.strip('x')
'abcba'.strip('ab')
'abc'.strip(None)
'abc'.strip(1)
'abc'.strip('a', 'b')
'\x1f\u3000a\xa0'.strip()
'a'.center(4)
'a'.center(5)
'ab'.center(5)
'ab'.center(4, '*')
'abc'.center(6, '-')
'a'.ljust(4) + '|'
'a'.rjust(4, '.')
'a'.center(4, 'xx')
'a'.center(4, 1)
'a'.center('4')
'a'.center()
'a'.ljust(1.5)
'a'.center(10**30)
'42'.zfill(5)
'-42'.zfill(5)
'+42'.zfill(5)
''.zfill(2)
'abc'.zfill(2)
'42'.zfill('5')
'a\tb'.expandtabs()
'a\tb'.expandtabs(4)
'ab\tc\n\td'.expandtabs(tabsize=4)
'a\tb'.expandtabs(0)
'a\tb'.expandtabs(-5)
'abc'.isalpha()
'abc1'.isalpha()
'äöü'.isalpha()
''.isalpha()
'Ⅷ'.isalpha()
'123'.isdigit()
'²'.isdigit()
'²'.isdecimal()
'½'.isnumeric()
'½'.isdigit()
'五'.isnumeric()
'五'.isalnum()
'٣'.isdecimal()
'abc1'.isalnum()
'a b'.isalnum()
'½'.isalnum()
'abc'.islower()
'aBc'.islower()
'123'.islower()
'ABC1'.isupper()
'ªº'.islower()
'Hello World'.istitle()
'Hello world'.istitle()
'HELLO'.istitle()
' \t\n'.isspace()
''.isspace()
'\x1c'.isspace()
'abc'.isidentifier()
'1abc'.isidentifier()
'a-b'.isidentifier()
'for'.isidentifier()
''.isidentifier()
'abc'.isprintable()
'a\n'.isprintable()
''.isprintable()
'\xa0'.isprintable()
'abc'.isascii()
'ä'.isascii()
'abc'.removeprefix('a')
'abc'.removeprefix('b')
'abc'.removesuffix('bc')
'abc'.removesuffix('')
'abc'.removeprefix(1)
'abc'.translate(str.maketrans('ab', 'xy'))
'abc'.translate(str.maketrans('ab', 'xy', 'c'))
'abc'.translate(str.maketrans(dict(a='1', b=None)))
'abc'.translate(dict([(97, 'zz'), (98, 65)]))
'abc'.translate('xyz')
'abc'.translate(1)
str.maketrans('ab', 'x')
str.maketrans('ab')
str.maketrans(dict([('ab', 1)]))
str.maketrans(dict([(1.5, 1)]))
str.maketrans(1, 2)
str.maketrans('a', 1)
str.maketrans()
'abc'.maketrans('a', 'b')
'abc'.encode()
'ä€'.encode()
'ä'.encode('latin-1')
'€'.encode('latin-1')
'ä'.encode('ascii')
'ä'.encode('ascii', 'ignore')
'ä'.encode('ascii', 'replace')
'ä'.encode('nope')
'ä'.encode(1)
'ä'.encode().decode()
'ä'.encode().decode('ascii')
'ä'.encode().decode('latin-1')
b'\xff'.decode()
b'\xe4a'.decode()
b'\xe2\x82'.decode()
b'\xff'.decode(errors='replace')
b'abc'.hex()
b'abc'.upper()
b'abc'[0]
b'abc'[1:]
b'abc' + b'd'
b'abc' + 'd'
'd' + b'abc'
b'ab' * 2
python.list(b'ab')
list(b'ab')
python.type(b'').fromhex('61 62')
python.type(b'').fromhex('6')
python.type(b'').fromhex('zz')
'abc'.foo
'abc'.foo()
'abc'.upper(1)
'abc'.upper(x=1)
'abc'.upper
str.upper
str.upper('a')
str.upper(1)
str.upper()
map(str.upper, ['a', 'b'])
list(map(str.upper, ['a', 'b']))
list(map(str.upper, [1]))
'abc'[0]
'abc'[-1]
'abc'[3]
'abc'[1:]
'abc'[::-1]
'abc'[-2:]
'abc'[5:]
'abc'['a']
'abc'[1.0]
'abc'[None]
'äbc'[0]
'äöü'[1:]
'äöü'[::-1]
'äöü'[::2]
'abcdef'[1:5:2]
'abcdef'[5:1:-2]
'abc'[True]
'abc'[::0]
'abc'['a':]
'abc'[10**30]
'abc'[:10**30]
'abc'[-10**30:]
'abc' * 2
2 * 'abc'
'abc' * -1
'abc' * 0
'abc' * 1.5
'abc' * 'a'
'abc' * None
'abc' * True
'abc' + 1
'abc' + None
1 + 'abc'
None + 'abc'
'a' - 'b'
-'a'
'%s' % 'a'
'%d items' % 3
'%s-%s' % ('a', 1)
'%s' % (1, 2)
'%s %s' % (1,)
'%(a)s %(b)d' % dict(a=1, b=2)
'%(a)s' % dict(b=1)
'%(a)s' % 1
'%(a' % dict(a=1)
'%*d' % (5, 42)
'%-*d|' % (5, 42)
'%.*f' % (2, 3.14159)
'%*d' % ('a', 1)
'%*d' % (-5, 42)
'%(a)*d' % dict(a=1)
'%s' % [1, 2]
'%s' % dict(a=1)
'%s' % ()
'no format' % ()
'no format' % 1
'no format' % dict(a=1)
'no format' % [1]
'no format' % 'a'
'no format' % (1,)
'%d' % 'a'
'%d' % 1.9
'%d' % -1.9
'%d' % nan
'%d' % inf
'%x' % 1.5
'%c' % 'ab'
'%c' % 1.5
'%f' % 'a'
'%f' % 10**400
'%s' % None
'%r' % 'a'
'%a' % 'ä'
'%s' % cfg.names
'%(a)s' % cfg
'{} {}'.format(1, 2)
'{0} {1} {0}'.format(1, 2)
'{a}'.format(a=1)
'{}'.format()
'{1}'.format(1)
'{a}'.format()
'{} {0}'.format(1)
'{0} {}'.format(1)
'{0.real}'.format(5)
'{0[0]}'.format([7])
'{0[a]}'.format(dict(a=1))
'{0[-1]}'.format([1])
'{a.b.c}'.format(a=cfg)
'{0.names[1]}'.format(cfg)
'{0.foo}'.format(1)
'{!r} {!s} {!a}'.format('ä', 'ä', 'ä')
'{!x}'.format(1)
'{!}'.format(1)
'{!r'.format(1)
'{:>{}}'.format('a', 5)
'{:{w}.{p}f}'.format(3.14159, w=10, p=2)
'{:{}{}}'.format(5, '>', 4)
'{:{:{}}}'.format(1, 2, 3)
'{{}}'.format()
'{{{}}}'.format(1)
'{'.format()
'}'.format()
'{}}'.format(1)
'a{'.format()
'{0'.format(1)
'{0:'.format(1)
'{0[}'.format([1])
'{0[]}'.format([1])
'{0.}'.format(1)
'{0[0]x}'.format([1])
'{ 0}'.format(1)
'{99999999999999999999}'.format(1)
'{a{}}'.format(1)
'{}'.format([1, 'a'])
'{:5}'.format([1])
'{:5}'.format(None)
'{}'.format(None)
'{:d}'.format('a')
'{:s}'.format(1)
'{:d}'.format(1.5)
'{:.2f}'.format('1')
'{:.2f}'.format(True)
'{:5}|'.format(True)
'{}'.format(True)
'{a}'.format_map(dict(a=1))
'{b}'.format_map(dict(a=1))
'{}'.format_map(dict(a=1))
'{0}'.format_map(dict(a=1))
'{a}'.format_map(cfg)
'{zz}'.format_map(cfg)
'{a}'.format_map(1)
'{a}'.format_map()
f'{n}'
f'{n:5}|'
f'{x!r:>6}'
f'{n + 1} and {s}'
f'{n=}'
f'{n = }'
f'{x=:.2f}'
f'{s=!s}'
f'{n:{n}}'
f'{{}}'
f'{undefined_thing}'
f'a' 'b' f'{n}'

# lists
[1, 2] + [3]
[1, 2] + (3,)
[1, 2] + 1
[1] * 3
3 * [1]
[1] * 1.5
[1] * 'a'
[1] - [1]
l[0]
l[-1]
l[3]
l[-4]
l['a']
l[1.0]
l[None]
l[1:]
l[::-1]
l[0:2]
l[:]
l[::2]
l[5:]
l[::0]
l['a':]
l[1:2, 3]
l[10**30]
l[True]
l.append(4)
(l.append(4), l)
[l.append(4), l][1]
(l.extend([5,6]), l)
(l.insert(0, 9), l)
(l.insert(-1, 9), l)
(l.insert(100, 9), l)
(l.pop(), l)
(l.pop(0), l)
l.pop(10)
[].pop()
l.pop('a')
(l.remove(1), l)
l.remove(9)
l.index(2)
l.index(9)
l.index(3, 1)
l.index()
l.count(1)
(l.sort(), l)
(l.sort(reverse=True), l)
(l.sort(key=lambda v: -v), l)
l.sort(1)
l.sort(foo=1)
(l.reverse(), l)
(l.clear(), l)
l.copy()
l.append()
l.append(1, 2)
l.extend(5)
l.insert(1)
l.insert('a', 1)
l.foo
[1, [2, [3]]]
[[]] * 2
(lambda a: (a.append(a), a))([])
(lambda a: (a.append(a), str(a)))([1])
(lambda a: (a.append(a), a == a))([1])
[*l, *'ab']
[*5]
[1, *[]]
(*l,)
len(l)
len('äöü')
len(5)
len()
len(1, 2)
len(dict(a=1))
len(python.range(10))
len(python.range(0, 10, 3))
len(python.range(10, 0, -3))
len(python.range(10**30))
len(python.set([1,1]))
len(map(str, l))
len(None)
max(l)
min(l)
max(1, 2.5)
max([])
min([])
max([], default=7)
max(1, 2, default=7)
max(l, key=lambda v: -v)
max()
max(1)
max('a', 'b')
max('a', 1)
min('a', 1)
min(1, 1.0)
max(1, 1.0)
max(nan, 1)
max(1, nan)
max('abc')
min(dict(b=1, a=2))
max(l, foo=1)
max(None, 1)
min([[1, 2], [1, 1]])
max([1, 'a'], key=str)
sorted(l)
python.sorted(l)
python.sorted(l, reverse=True)
python.sorted('hello')
python.sorted([1, 'a'])
python.sorted(l, key=lambda v: -v)
python.sorted(['b', 'A', 'c'], key=str.lower)
python.sorted([(1, 'b'), (1, 'a'), (0, 'z')])
python.sorted([(1, 'b'), (1, 'a')], key=lambda t: t[0], reverse=True)
python.sorted(5)
python.sorted()
python.sorted(l, 1)
python.sorted(l, foo=1)
python.sorted([3, nan, 1])
python.sorted([None, 1])
python.sorted(dict(b=1, a=2))
python.sum(l)
python.sum([0.1] * 10)
python.sum([[1], [2]], [])
python.sum(['a', 'b'])
python.sum(['a', 'b'], '')
python.sum([1, 'a'])
python.sum(l, 10)
python.sum(l, start=10)
python.sum([])
python.sum(5)
python.sum()
python.sum([10**20, 1])
python.sum([True, True])
python.sum([1, 2.5])
python.abs(-3)
python.abs(-2.5)
python.abs(-10**30)
python.abs('a')
python.abs()
python.abs(True)
python.abs(-9223372036854775808)
python.all([])
python.all([1, 0])
python.any([])
python.any([0, 1])
python.any(5)
python.all(v > 0 for v in l)
python.divmod(7, 3)
python.divmod(-7, 3)
python.divmod(7.5, 2)
python.divmod(-7.5, 2)
python.divmod(7, 0)
python.divmod(7.0, 0)
python.divmod('a', 1)
python.divmod(1j, 1)
python.divmod(10**30, 7)
python.divmod(1)
python.list(python.enumerate('ab'))
python.list(python.enumerate('ab', 1))
python.list(python.enumerate('ab', start=5))
python.enumerate()
python.enumerate(5)
python.enumerate('a', 'b')
python.list(python.zip([1, 2], 'ab'))
python.list(python.zip([1, 2], 'abc'))
python.list(python.zip([1, 2], 'abc', strict=True))
python.list(python.zip([1, 2, 3], 'ab', strict=True))
python.list(python.zip([1, 2, 3], 'abc', 'xy', strict=True))
python.list(python.zip([1, 2], 'ab', 'xyz', strict=True))
python.list(python.zip())
python.zip(1)
python.zip([], 1)
python.zip([], foo=1)
python.list(python.filter(None, [0, 1, '', 'a']))
python.list(python.filter(lambda v: v > 1, l))
python.filter(None)
python.filter(None, 5)
python.list(python.reversed(l))
python.list(python.reversed('abc'))
python.list(python.reversed(python.range(5)))
python.list(python.reversed(python.range(0, 10, 3)))
python.list(python.reversed(dict(a=1, b=2)))
python.list(python.reversed((1, 2)))
python.reversed(5)
python.reversed(python.set([1]))
python.reversed()
list(map(lambda a, b: a + b, [1, 2], [10, 20]))
list(map(str, [1, 2]))
list(map(float, '123'))
list(map(int, ['1', 'x']))
list(map(5, [1]))
map(str)
map()
map(str, 5)
list(map(pow, [2, 3], [2, 2]))
list('abc')
list()
list(5)
list(1, 2)
list(x=1)
list(dict(a=1, b=2))
list(dict(a=1, b=2).items())
list((1, 2))
python.tuple('ab')
python.tuple()
python.tuple(5)
python.tuple([1]) + (2,)
()
(1,)
(1, 2)[0]
(1, 2)[2]
(1, 2)['a']
(1, 2)[::-1]
(1, 2).index(2)
(1, 2).index(5)
(1, 2).count(1)
(1, 2) + [3]
(1, 2) * 2
(1, 2).foo
python.isinstance(1, int)
python.isinstance(True, int)
python.isinstance(1, float)
python.isinstance(1, (str, int))
python.isinstance(1, 5)
python.isinstance(1, (5,))
python.isinstance(l, list)
python.isinstance(cfg, dict)
python.isinstance(cfg.names, list)
python.isinstance('a', python.type('b'))
python.isinstance(1)
python.issubclass(bool, int)
python.issubclass(int, bool)
python.issubclass(1, int)
python.issubclass(int, 1)
python.ord('a')
python.ord('€')
python.ord('ab')
python.ord(1)
python.ord('')
python.ord(b'a')
python.repr('a')
python.repr(1.0)
python.repr([1, 'a'])
python.hash(1)
python.hash(-1)
python.hash(True)
python.hash(2**61)
python.hash(2**61 - 1)
python.hash(-10**30)
python.hash(1.0)
python.hash(1.5)
python.hash(-0.75)
python.hash(1e300)
python.hash(1e-300)
python.hash(inf)
python.hash(1+2j)
python.hash([])
python.hash(dict())
python.hash(python.set())
python.hash(([],))
python.type(1)
python.type('a')
python.type(1.5)
python.type(None)
python.type(len)
python.type(int)
python.type(l)
python.type(cfg)
python.type(cfg.names)
python.type(...)
python.type(1j)
python.type(b'')
python.type(lambda: 1)
python.type(dict().keys())
python.type(python.zip())
python.type(python.range(1))
python.type(python.slice(1))
python.type(sorted)
python.type('a'.upper)
python.type(x for x in l)
python.type(1) == int
python.type(1) is int
python.type(1, 2)
python.type()
python.slice(1)
python.slice(1, 2)
python.slice(1, 2, 3)
python.slice()
python.slice(1, None).indices(5)
python.slice(None, None, -1).indices(5)
python.slice(1).stop
l[python.slice(1)]
python.slice(1) == python.slice(1)
python.range(5)
python.range(1, 5)
python.range(1, 5, 2)
python.range(5, 1, -1)
list(python.range(5, 1, -2))
list(python.range(0))
python.range(0, 1, 0)
python.range(1.5)
python.range('a')
python.range()
python.range(1, 2, 3, 4)
python.range(10)[2]
python.range(10)[-1]
python.range(10)[10]
python.range(10)[2:5]
python.range(10)[::-1]
python.range(10)[::-3]
python.range(10)['a']
python.range(10).start
python.range(10).index(3)
python.range(10).index(30)
python.range(10).count(3)
python.range(3) == python.range(3)
python.range(0) == python.range(2, 1)
python.range(0, 3, 2) == python.range(0, 4, 2)
python.range(10**30)
python.range(3) + [1]
range(3)
list(range(3))
[i for i in range(3)]
range
sorted
dotify
round(2.5)
round(3.5)
round(-2.5)
round(2.675, 2)
round(2.5, 0)
round(1234, -2)
round(1250, -2)
round(1350, -2)
round(-1250, -2)
round(1234.5678, -2)
round(1250.0, -2)
round(15.0, -1)
round(25.0, -1)
round(1e300, -300)
round(5e-324, 400)
round(1.5, 400)
round(1.5, -400)
round(5, 400)
round(5, -400)
round(10**30, -29)
round(1.5, None)
round(5, None)
round(True)
round('a')
round(nan)
round(inf)
round(nan, 2)
round(1e308, -308)
round(1.7e308, -308)
round(0.5)
round(1.5)
round(-0.5)
round(0.1 + 0.2, 10)
round()
round(1, 2, 3)
round(1, 'a')
round(1.5, 'a')
round(number=2.5)
round(number=2.567, ndigits=1)
round(foo=1)
round(1j)
round(1e22)
round(2.0**62)

# int and float conversion
int()
int(2.9)
int(-2.9)
int('42')
int(' 42 ')
int('-42')
int('+42')
int('1_000')
int('1__000')
int('_1')
int('1_')
int('٣٤')
int('')
int('x')
int('4.5')
int('0x1F')
int('0x1F', 16)
int('1F', 16)
int('z', 36)
int('0b101', 0)
int('0o17', 0)
int('017', 0)
int('00', 0)
int('0x_1', 0)
int('12', 2)
int('12', 1)
int('12', 37)
int('12', base=3)
int(12, 3)
int(x=1)
int(base=3)
int([])
int(None)
int(nan)
int(inf)
int(-inf)
int(1e20)
int(1e300)
int(True)
int('1' * 4301)
int('1' * 4300) % 1000
int('1' * 30)
int(1, 2, 3)
int(1j)
int('- 1')
int(b'12')
int('\u200912\n')
float()
float('1.5')
float(' 1e3 ')
float('1_0.5')
float('.')
float('1e')
float('inf')
float('-Infinity')
float('nan')
float('infinit')
float('')
float('x')
float('1.5.2')
float('0x10')
float('١.٥')
float('1__0')
float([])
float(None)
float(10**400)
float('1e400')
float(1, 2)
float(x=1)
float(1j)
float('1_e3')
float(b'1.5')
float('NaN')
float('+.5')
float(' 1 2 ')
2.0.is_integer()
2.5.is_integer()
inf.is_integer()
2.5.as_integer_ratio()
0.1.as_integer_ratio()
(-0.0).as_integer_ratio()
1e300.as_integer_ratio()
5e-324.as_integer_ratio()
inf.as_integer_ratio()
nan.as_integer_ratio()
0.1.hex()
(-1.5).hex()
0.0.hex()
5e-324.hex()
1e300.hex()
inf.hex()
float.fromhex('0x1.8p3')
float.fromhex('1.8')
float.fromhex('-0x.1p-5')
float.fromhex('inf')
float.fromhex('x')
float.fromhex('0x1p2000')
float.fromhex('0x1.fffffffffffff8p0')
float.fromhex(1)
(5).bit_length()
(0).bit_length()
(-256).bit_length()
(255).bit_count()
(10**30).bit_length()
(5).to_bytes(2, 'big')
(5).to_bytes(2, 'little')
(-5).to_bytes(2, 'big', signed=True)
(-5).to_bytes(2, 'big')
(300).to_bytes(1, 'big')
(5).to_bytes()
(0).to_bytes(0, 'big')
(5).to_bytes(2, 'foo')
int.from_bytes(b'\x01\x02', 'big')
int.from_bytes(b'\xff', 'big', signed=True)
int.from_bytes(b'\x01\x02', 'little')
int.from_bytes([1, 2], 'big')
int.from_bytes('a', 'big')
(5).as_integer_ratio()
(5).conjugate()
(5).foo
(5).real.imag
5 .real
str()
str(1)
str(1.0)
str('a')
str([1, 'a', None])
str(None)
str(b'a')
str(b'a', 'utf-8')
str('a', 'utf-8')
str(1, 'utf-8')
str(object=5)
str(1, 2, 3, 4)
str(10**4299)[:3]
str(10**4300)[:3]
str(len)
str(int)
str(1e16)
str(123456789012345.0)
str(1e-5)
str(True)
str(...)
str(python.range(3))
str(1j)
str(cfg.b)
str(lambda: 1)
str(map(str, []))
str(dict().keys())
str(dict(a=1).items())
str(dict(a=1).values())
str(python.set())
str(python.frozenset([1]))
str(python.slice(1))
str('a'.upper)
str(python.abs)
str(sin)
str(python.zip([]))
str(python.enumerate([]))
str(x for x in l)

# repr of strings
'it\'s'
"say \"hi\""
'it\'s "x"'
'\n\t\r\\'
'\x00\x7f'
'\x80\xa0\xad'
'\u200b\u2028'
'é€'
'日本語'
'\U0001f600'
'\U000e0001'
'\ufeff'
'\u0378'
'e\u0301'
'\ue000'
b'\'"'
'%r' % 'it\'s'

# dicts
dict()
dict(a=1, b=2)
dict([('a', 1), ('b', 2)])
dict([(1, 'a'), (1.0, 'b'), (True, 'c')])
dict(dict(a=1), b=2)
dict([('a',)])
dict([1])
dict(['ab', 'cd'])
dict(5)
dict(1, 2)
dict([([], 1)])
dict(a=1)['a']
dict(a=1)['b']
dict(a=1)[1]
dict(a=1)[None]
dict(a=1)[[]]
dict(a=1)[(1, 'x')]
dict(a=1)[1.5]
dict(a=1).a
dict(a=1).get('a')
dict(a=1).get('b')
dict(a=1).get('b', 5)
dict(a=1).get()
dict(a=1).get([])
dict(a=1).keys()
dict(a=1).values()
dict(a=1).items()
list(dict(a=1).items())
dict(a=1).pop('a')
dict(a=1).pop('b')
dict(a=1).pop('b', 2)
dict(a=1).popitem()
dict().popitem()
dict(a=1).setdefault('b', 3)
dict(a=1).setdefault('a')
(lambda d: (d.update(b=2), d))(dict(a=1))
(lambda d: (d.update([('c', 3)]), d))(dict(a=1))
(lambda d: (d.update(dict(a=9)), d))(dict(a=1))
dict(a=1).update(5)
(lambda d: (d.clear(), d))(dict(a=1))
dict(a=1).copy()
dict.fromkeys('ab')
dict.fromkeys('ab', 0)
dict().fromkeys([1], 2)
dict.fromkeys()
dict(a=1) | dict(b=2)
dict(a=1) | 5
dict(a=1) + dict(b=2)
dict(a=1).foo
dict(a=1)['a']['b']
dict(**dict(a=1), b=2)
dict(a=1).keys() & ['a']
dict(a=1).keys() | dict(b=2).keys()
dict(a=1).keys() == python.set(['a'])
dict(a=1).items() == dict(a=1).items()
'a' in dict(a=1).keys()
1 in dict(a=1).values()
('a', 1) in dict(a=1).items()
dict(a=1).keys()[0]
dict(a=1).keys().isdisjoint('b')
[k + str(v) for k, v in dict(a=1, b=2).items()]
dict((k, v * 2) for k, v in dict(a=1).items())
dict(zip=1)
python.vars(cfg)
python.vars(1)
(lambda d: [d.pop(k) for k in d])(dict(a=1, b=2))

# sets
python.set([3, 1, 2])
python.set([10, 3, 17, 8, 1])
python.set(python.range(20))
python.set([100, 5, -1, 64])
python.set([1, 1.0, True])
python.set('a')
python.set([[]])
python.set(5)
python.frozenset([1, 2])
python.frozenset()
python.set([1, 2]) | python.set([3])
python.set([1, 2]) & python.set([2])
python.set([1, 2]) - python.set([2])
python.set([1, 2]) ^ python.set([2, 3])
python.set([1, 2]) | [3]
python.set([1]) + python.set([2])
python.set([1]) < python.set([1, 2])
python.set([1]) <= python.set([1])
python.set([1]) == python.frozenset([1])
python.set([1]).union([2], [3])
python.set([1, 2]).intersection([2])
python.set([1, 2]).difference([2])
python.set([1, 2]).symmetric_difference([2, 3])
python.set([1]).issubset([1, 2])
python.set([1]).issuperset([])
python.set([1]).isdisjoint([2])
(lambda v: (v.add(5), v))(python.set([1]))
(lambda v: (v.discard(1), v))(python.set([1]))
(lambda v: (v.update([7]), v))(python.set([1]))
(lambda v: (v.pop(), v))(python.set([1]))
python.set([1]).remove(2)
python.set([1]).remove('a')
python.set().pop()
python.set([1]).add()
python.set([1])[0]
python.frozenset([1]).add(2)
python.frozenset([1]) | python.set([2])
[v for v in python.set([2, 1])]

# comprehensions
[i*i for i in l]
[i for i in l if i > 1]
[i for i in l if i > 1 if i < 3]
[(i, j) for i in python.range(3) for j in python.range(i)]
[a + b for a, b in [(1, 2), (3, 4)]]
[a for a, *b in [(1, 2, 3)]]
[b for a, *b in [(1, 2, 3)]]
[c for a, (b, c) in [(1, (2, 3))]]
[a for a, b in [(1, 2, 3)]]
[a for a, b in [(1,)]]
[a for a, b, *c in [(1,)]]
[a for a, b in [1]]
[a for a, b in ['ab', 'cd']]
[i for i in 5]
[i for i in None]
[i for j in l for i in j]
[i + undefined_name for i in l]
[f() for f in [lambda: i for i in python.range(3)]]
[f() for f in [lambda i=i: i for i in python.range(3)]]
[[j for j in python.range(i)] for i in python.range(3)]
python.sum(i for i in l)
list(i for i in l)
(i for i in l)
python.sum([i for i in l], 1)
i for i in l
[n for n in l] + [n]
[y for v in l if (y := v * 2) > 2]
(z := 5) + z
[(t := v) for v in l] + [t]
(lambda: (w := 3) + w)()
(lambda g: [python.sum(g), python.sum(g)])(v for v in l)
(lambda it: [list(it), list(it)])(map(str, l))
list(python.zip(*[[1, 2], [3, 4]]))
[1 for i in python.range(3) if i / 0]
[x for x in [1]] and x

# lambda and calls
(lambda: 1)()
(lambda a: a)(1)
(lambda a, b=2: a + b)(1)
(lambda a, b=2: a + b)(1, b=5)
(lambda *a: a)(1, 2)
(lambda **k: k)(a=1)
(lambda a, *b, c=3, **d: (a, b, c, d))(1, 2, 3, c=4, e=5)
(lambda a, /, b: (a, b))(1, b=2)
(lambda a, /: a)(a=1)
(lambda *, a: a)(1)
(lambda *, a: a)()
(lambda *, a, b: a)()
(lambda *, a: a)(a=2)
(lambda a: a)()
(lambda a, b: a)()
(lambda a, b, c: a)()
(lambda a: a)(1, 2)
(lambda: 1)(1)
(lambda a, b: 1)(1, 2, 3)
(lambda a, b=1: 1)(1, 2, 3)
(lambda a=1: 1)(1, 2)
(lambda a: a)(b=1)
(lambda a: a)(1, a=2)
(lambda a: a)(*[1])
(lambda a: a)(**dict(a=1))
(lambda a: a)(*5)
(lambda a: a)(**5)
(lambda **k: k)(**dict([(1, 2)]))
(lambda f: f(f, 5))(lambda f, v: 1 if v == 0 else v * f(f, v - 1))
(lambda a: lambda b: a + b)(1)(2)
(lambda a, b: a)(*[1], **dict(b=2))
(lambda x: x)(x=5)
lambda: 1
5()
'a'()
None()
l()
1.5(2)
len(*[l])
int(*['12'], **dict(base=3))
(lambda a=l: a)()
sin(1)
sin()
sin(1, 2)
sin(x=1)
sin('a')
sin(None)
pow(2, 3)
pow(2)
pow(2, 3, 4)
pow('a', 1)
pow(0, -1)
pow(-1, 0.5)
pow(10, 400)
atan2(1)
log(8, 2)
log(0)
log(-1)
log(10**400)
log(10**400, 10)
log(8, 1)
log(1, 2, 3)
log()
log2(2**400)
log10(10**400)
log2(2**2000)
log(-10**400)
sqrt(-1)
sqrt('a')
sqrt(10**400)
factorial(5)
factorial(25)
factorial(-1)
factorial(2.0)
factorial('a')
factorial(10**30)
factorial(True)
comb(5, 2)
comb(50, 25)
comb(5, 6)
comb(-1, 2)
comb(2, -1)
comb(5)
comb(5.0, 2)
comb(10**30, 2)
perm(5, 2)
perm(5)
perm(5, None)
perm(5, 6)
perm(-1)
perm(5, -1)
perm(10**30, 2)
gcd(12, 18)
gcd()
gcd(0, 0)
gcd(-4, 6)
gcd(1.5, 2)
gcd(12, 18, 27)
gcd(10**30, 10**20)
lcm(4, 6)
lcm()
lcm(0, 5)
lcm(4, 6, 10)
isqrt(17)
isqrt(10**40)
isqrt(-1)
isqrt(2.0)
floor(2.7)
floor(-2.7)
floor(1e30)
floor('a')
floor(nan)
floor(inf)
ceil(2.1)
ceil(-2.1)
ceil(None)
trunc(2.7)
trunc(-2.7)
trunc('a')
trunc(1j)
hypot(3, 4)
hypot()
hypot(3, 4, 12)
hypot(inf, nan)
hypot(nan, 1)
hypot(1e300, 1e300)
hypot(5e-324, 5e-324)
hypot('a')
hypot(x=1)
dist([0, 0], [3, 4])
dist([0], [1, 2])
dist(1, 2)
dist([0], ['a'])
dist((1, 2, 3), (4, 5, 6))
fsum([0.1] * 10)
fsum([1e308, 1e308])
fsum([1e308, 1e308, -1e308])
fsum([inf, -inf])
fsum([inf, 1])
fsum([nan])
fsum(['a'])
fsum(5)
fsum([])
fsum([1e16, 1, 1e-16])
fsum([2.0**53, 1.0, 2.0**-100])
prod([1, 2, 3])
prod([])
prod([1.5, 2])
prod([2], start=5)
prod(['a', 2])
prod(5)
prod([1], 2)
isclose(1, 1 + 1e-10)
isclose(1, 1.1)
isclose(1, 1.1, rel_tol=0.2)
isclose(0, 1e-10)
isclose(0, 1e-10, abs_tol=1e-9)
isclose(1, 2, rel_tol=-1)
isclose(inf, inf)
isclose(inf, 1)
isclose(nan, nan)
isclose(1)
isclose(1, 2, 3)
isclose(1, 2, foo=3)
ldexp(1.5, 3)
ldexp(1, 2000)
ldexp(1, -2000)
ldexp(1, 10**30)
ldexp(0, 10**30)
ldexp(1, 2.0)
ldexp(5e-324, 1)
ldexp(3, -1075)
frexp(0)
frexp(8)
frexp(-5e-324)
frexp(inf)
modf(-3.25)
modf(inf)
fmod(7, -3)
fmod(1, 0)
fmod(inf, 1)
fmod(1, inf)
remainder(7, 4)
remainder(6, 4)
remainder(1, 0)
remainder(inf, 1)
remainder(1, inf)
copysign(1, -0.0)
nextafter(1, 2)
nextafter(0, -1)
ulp(1)
ulp(0)
ulp(inf)
ulp(nan)
ulp(1.7976931348623157e308)
gamma(5)
gamma(0)
gamma(-1)
gamma(0.5)
gamma(-0.5)
gamma(172)
gamma(-200.5)
gamma(inf)
gamma(-inf)
lgamma(0)
lgamma(-1)
lgamma(100)
lgamma(inf)
lgamma(1e308)
lgamma(3)
erf(0.5)
erfc(0.5)
erf(inf)
cbrt(27)
cbrt(-8)
exp2(10)
exp(1000)
exp(-1000)
expm1(1e-10)
log1p(1e-10)
log1p(-1)
log1p(-2)
sin(inf)
tan(pi/2)
acos(2)
atanh(1)
atanh(2)
acosh(0.5)
cosh(1000)
sinh(-1000)
tanh(1000)
degrees(pi)
radians(180)
math.pi
math.foo
math.sin(math.pi)
math.sin
python.foo
python.len
xacro.foo
math.floor
python.int('5')
python.True
python.map
python.str(5)

# xacro functions
xacro.tokenize('a,b;c d')
xacro.tokenize('a,,b')
xacro.tokenize('a,,b', skip_empty=False)
xacro.tokenize('a-b', '-')
xacro.tokenize('a-b_c', sep='-_')
xacro.tokenize('')
xacro.tokenize('', skip_empty=False)
xacro.tokenize(5)
xacro.tokenize('axbyc', 'x-z')
xacro.tokenize('a1b2', r'\d')
xacro.dotify(dict(a=dict(b=1))).a.b
xacro.dotify(dict(a=1))
xacro.dotify(dict(a=1)).foo
xacro.dotify(a=1).a
xacro.dotify(5)
dotify(dict(a=dict(b=5))).a.b
xacro.dotify

# yaml values
cfg.a
cfg['a']
cfg.b.c
cfg['b']['c']
cfg.b.items
cfg.b['items']
cfg.b.list[1].k
cfg.b.list[-1]['k']
cfg.zzz
cfg['zzz']
cfg[3]
cfg[4]
cfg[None]
cfg[[]]
cfg.b.zzz
cfg.get('b').c
cfg.get('b')
cfg.get('zzz')
cfg.keys()
list(cfg)
list(cfg.values())[1].c
[v.c for v in cfg.values() if python.isinstance(v, dict)]
[r for r in cfg.rows]
[a + b for a, b in cfg.rows]
cfg.rows[0][1]
cfg.rows[5]
cfg.rows['a']
cfg.rows.foo
cfg.rows + [1]
cfg.rows + 1
cfg.rows[0:1]
python.type(cfg.rows[0:1])
python.type((cfg.rows + [])[0])
python.type(cfg.rows.copy())
python.type(list(cfg.rows)[0])
python.type(cfg.rows[0])
python.type([r for r in cfg.rows][0])
python.type(cfg.copy())
python.type(cfg.get('b'))
python.type(cfg['b'])
python.type(cfg.items())
[python.type(v) for k, v in cfg.items()]
python.type(dict(cfg)['b'])
python.type(dict(cfg))
python.type([*cfg.rows][0])
python.type(python.list(python.reversed(cfg.rows))[0])
python.type(python.sorted(cfg.rows)[0])
python.type(max(cfg.rows))
python.type((cfg.rows * 2)[0])
python.type(cfg.rows.pop())
'a' in cfg
cfg == dict(a=1)
cfg.names == ['front', 'rear']
len(cfg)
cfg.names.index('rear')
cfg.names.append('x')
(cfg.names.append('x'), cfg.names)
cfg + 1
-cfg
cfg.a.b
cfg()
cfg.a()
cfg.b()
bool(cfg)
'%s' % cfg.a
str(cfg.names)
python.set(cfg.names) == python.set(['rear', 'front'])
python.set(cfg.rows)
cfg.rows < [[1, 2], [3, 5]]

# attribute errors and the rest
None.foo
(1).foo
1.5.foo
[].foo
().foo
len.foo
int.foo
str.foo
(lambda: 1).foo
b''.foo
python.set().foo
python.range(1).foo
dict().keys().foo
None[0]
5[0]
1.5[0]
len[0]
(lambda: 1)[0]
python.set()[0]
True[0]
...[0]
int['a']
l[l]
l[...]
-None
-[]
~1.5
~'a'
+None
not None
[] + None
None + 1
None + None
1 + None
1 + [1]
1.5 + 'a'
[1] + 'a'
'a' + ['b']
dict() + 1
len + 1
int + 1
1 - 'a'
'a' * []
[] * []
() * 1.5
'a' / 2
'a' // 2
2 // 'a'
'a' ** 2
2 ** 'a'
1 << 1.5
1 & 1.5
1 | None
1.5 ^ 1
1 @ 2
[1] @ [2]
None == 0
None == None
'1' == 1
[] == False
len == len
int == int
len < int
int < float
(1, 'a') == (1, 'a')
s.x
s[0].upper() + s[1:]
s.split()[1][::-1].upper()
' '.join(w.capitalize() for w in s.split())
'_'.join(python.reversed(s.split()))
python.list(python.zip(l, python.sorted(l)))
[str(i).zfill(2) for i in python.range(9, 12)]
dict(python.zip('ab', [1, 2]))
max(len(w) for w in s.split())
[l[i] for i in python.range(len(l)) if i % 2 == 0]
(n if n > 2 else x) * 2
radians(90) * n
'%s_link' % s.split()[0]
'{:.3f}'.format(pi)
1 if n == 3 and x != 1.5 else 'no'
str(n) + '_' + str(x)
int(x * 10) // 4
"link_" + str(int(n))
"link" + n
n + "link"
2 * pi * 0.05
1/12 * 2.5 * (3*0.1**2 + 0.4**2)
0.1 + 0.2
1e-3 * 5
3 * 0.1
-pi/2
"""
