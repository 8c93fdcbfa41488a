"""The expression grammar: templates by kind of value.

A template reads `{kind:precedence}` for a sub-expression, at least that tight (1,
a conditional expression, when left out), `{kind:precedence+v=kind2}` for one that
may use the bound name `{v}` as a value of kind2. `{v}` and `{w}` are bound names,
`@N` at the end is the weight. Precedences, loosest first: 0 lambda, 1 if-else,
2 or, 3 and, 4 not, 5 comparison, 6 |, 7 ^, 8 &, 9 shift, 10 sum, 11 product,
12 sign, 13 power, 15 call, subscript and attribute, 16 display and literal.

Every value that a template can be filled with keeps the promise of its kind, so
that an expression never fails, whatever the values of the names in it are:

    idx    0 <= int <= 3                     bit    0 or 1
    int    any int                           nz     int literal, not 0
    flt    0.01 <= float <= 1000             num    any finite number
    word   not empty, no number              text   string that stays a string when stored
    ilist  two ints or more                  wlist  two words or more
    dict   has the keys a and b, values int  mix    any list, tuple or dict
    fn     function of one int               any    anything that prints the same everywhere
"""

GRAMMAR = {
    'idx': '''
        {int:11} % 4 @4
        len({word}) % 4
        min(3, {idx})
        max({idx}, {idx})
        {idx:2} if {bool:2} else {idx:1}
        int({bool})
        {int:8} & 3
        [0, 1, 2, 3][{idx}]
        python.len({wlist}) % 3
    ''',
    'bit': '''
        {int:11} % 2 @3
        {int:8} & 1
        int({bool})
        0 if {bool:2} else 1
        min({idx}, 1)
    ''',
    'int': '''
        {int:10} + {int:11} @6
        {int:10} - {int:11} @5
        {int:11} * {int:12} @4
        {int:11} // {nz:12} @3
        {int:11} % {nz:12} @3
        -{int:12} @2
        +{int:12}
        ~{int:12}
        {idx:15} ** {idx:12} @2
        -{idx:15} ** {idx:12}
        2 ** {idx:15} ** {idx:12}
        {int:9} << {idx:10}
        {int:9} >> {idx:10}
        {int:8} & {int:9}
        {int:6} | {int:7}
        {int:7} ^ {int:8}
        {int:2} if {bool:2} else {int:1} @3
        len({word}) @2
        len({text})
        len({ilist}) @2
        len({mix})
        len({dict})
        min({int}, {int}) @2
        max({int}, {int}, {int}) @2
        min({ilist})
        max({ilist}, key=lambda {v}: -{v})
        max([], default={int})
        int({flt}) @2
        int(-{flt:12})
        round({flt}) @2
        round({num})
        round({int}, -1)
        floor({num}) @2
        ceil({num}) @2
        trunc({num})
        math.floor({flt:11} / {flt:12})
        python.abs({int}) @2
        python.sum({ilist}) @2
        python.sum({ilist}, {int})
        python.sum({v} * {v} for {v} in {ilist:2})
        python.sum([{int:1+v=int} for {v} in {ilist:2}])
        python.divmod({int}, {nz})[{bit}]
        {ilist:15}[{bit}] @3
        {ilist:15}[-1]
        {ilist:15}[-{bit:12} - 1]
        {ilist:15}[1:][0]
        {dict:15}['a'] @2
        {dict:15}["b"]
        {dict:15}.get('b')
        {dict:15}.get('zz', {int})
        {word:15}.count('a')
        {word:15}.find('r')
        {word:15}.rfind('e', 1)
        python.ord({word:15}[0])
        {ilist:15}.count({int})
        {bool:10} + {bool:11}
        {bool:11} * {int:12}
        (lambda {v}: {int:1+v=int})({int})
        (lambda {v}, {w}=2: {v} * {w} - 1)({int})
        (lambda *{v}: len({v}))({int}, {any})
        (lambda {v}, **{w}: {v} + len({w}))({int}, z=1)
        (lambda {v}: lambda {w}: {v} - {w})({int})({int})
        {fn:15}({int}) @2
        gcd({int}, {int})
        math.gcd({int}, 12)
        factorial({idx})
        isqrt(python.abs({int}))
        comb(5, {idx})
        math.perm(5, {idx})
        lcm(4, {nz})
        prod({ilist})
        int(str({int}))
        int('{digit}{digit}')
        ({int}).bit_length()
        int('  %d ' % {int:12})
        int({word:15}.upper() == {word:6})
        str({int}).count('1')
        ({int}, {int})[{bit}]
        [{int}, {int}, {int}][{idx:10} - 4 + 1]
        {bool:3} and {int:4}
        {int:2} or {int:3}
        python.int({flt})
        python.max({int}, {int})
        [{v} for {v} in {ilist:2}][0]
        python.list({ilist})[1]
        xacro.dotify({dict}).a
        python.hash({idx})
        [*{ilist:6}][0]
        max(*{ilist:6})
        min(*[{int}, {int}], {int})
        list({dict:15}.values())[0]
        ({int}).real
        ({int}).numerator
        python.len({wlist})
        ({ilist:10} + [5]).pop()
    ''',
    'flt': '''
        ({flt:10} + {flt:11}) / 2 @4
        sqrt({flt}) @2
        max({flt}, {flt})
        min({flt}, {flt})
        {flt:2} if {bool:2} else {flt:1} @2
        1 + {flt:11} % 7
        {flt:11} * 0.5 + 0.01
        exp(-{flt:12} / 1000)
        round({flt}, 3)
        float({flt})
        fabs({flt})
        copysign({flt}, 1)
        {idx:10} + 0.5 @2
        atan2({flt}, {flt}) + 0.1
        python.abs(sin({num})) + 0.25
        hypot({flt}, {flt}) / 2 + .01
        (lambda {v}: {v} / 2 + 1)({flt})
        ({flt}, {flt})[{bit}]
        float('%.3f' % {flt:12}) + 0.02
        0.1 + {bit:11} * 0.2
    ''',
    'num': '''
        {int:16} @5
        {flt:16} @5
        {flt:11} * {num:12} @3
        {num:11} / {nzflt:12} @3
        {int:11} / {nz:12} @3
        {num:10} + {num:11} @3
        {num:10} - {num:11} @3
        {num:11} // {nzflt:12}
        {num:11} % {nzflt:12}
        -{num:12} % 7.5
        -{num:12} @2
        sin({num})
        cos({num})
        tan({num})
        math.sin({num})
        atan({num})
        atan2({num}, {num})
        radians({num}) @2
        degrees({num}) @2
        asinh({num})
        tanh({num})
        sinh({flt:11} / 100)
        cosh({flt:11} / 100)
        acosh(1 + {flt:11})
        atanh({flt:11} / 1001)
        acos({flt:11} / 1000)
        asin({flt:11} / 1001)
        log({flt})
        log({flt}, 2)
        log10({flt})
        log2({flt})
        log1p({flt})
        exp({flt:11} / 100)
        expm1({flt:11} / 100)
        exp2({idx})
        gamma(1 + {idx:11})
        gamma({flt:11} % 5 + 0.5)
        lgamma({flt})
        pow({flt}, 2)
        pow({flt}, -0.5)
        math.pow(2, {idx})
        {flt:15} ** 2 @2
        {flt:15} ** -{idx:12}
        {flt:15} ** 0.5
        {idx:15} ** 1.5
        2 ** -{idx:12}
        fmod({num}, 7)
        remainder({num}, 3)
        hypot({num}, {num})
        hypot(1, {num}, {num})
        dist([{num}, 0], [1, {num}])
        fsum([{num}, {num}, 0.1])
        python.sum([{num}, {num}, 0.1])
        fmod(-{flt:12}, 2)
        modf({num})[{bit}]
        frexp({num})[{bit}]
        ldexp({flt}, {idx})
        copysign({num}, -1)
        nextafter({flt}, 0)
        ulp({flt})
        round({num}, {idx}) @3
        round({flt}, -1)
        round({flt})
        python.divmod({num}, 7)[{bit}]
        float({int})
        float(str({num}))
        float(' %s ' % {num:12})
        max({num}, {num})
        min({num}, {num}, {num})
        python.abs({num}) @2
        {num:2} if {bool:2} else {num:1} @2
        pi * {num:12} @2
        {num:11} * tau
        e ** {idx:12}
        math.pi / {nz:12}
        {num:11} * pi / 180 @2
        {flt:11} / 12 * ({num:10} + {flt:15} ** 2)
        python.abs(3+4j)
        ({flt}).as_integer_ratio()[1]
        python.float({int})
        python.round({flt}, 2)
    ''',
    'bool': '''
        {num:6} < {num:6} @3
        {num:6} >= {num:6} @2
        {int:6} == {int:6} @2
        {int:6} != {num:6}
        {int:6} < {int:6} <= {int:6} @2
        {num:6} > {num:6} != {num:6}
        {word:6} == {word:6} @3
        {word:6} > {word:6}
        {any:6} == {any:6}
        {any:6} is None
        {any:6} is not None
        None is None
        {word:6} in {wlist:6} @2
        {word:6} not in {wlist:6}
        {int:6} in {ilist:6}
        {num:6} not in ({num}, {num})
        'a' in {dict:6}
        'zz' not in {dict:6}
        'a' in {word:6} @2
        not {bool:4} @3
        not {any:5}
        {bool:3} and {bool:4} @3
        {bool:2} or {bool:3} @3
        {bool:2} if {bool:2} else {bool:1}
        bool({mix})
        bool({num})
        bool({text})
        {word:15}.startswith('a')
        {word:15}.startswith(('l', 'r'))
        {word:15}.endswith({word:15}[-1])
        {word:15}.isdigit()
        {word:15}.isalpha()
        {text:15}.isalnum()
        {word:15}.isupper()
        {word:15}.islower()
        {text:15}.istitle()
        {text:15}.isspace()
        {word:15}.isidentifier()
        {text:15}.isascii()
        {text:15}.isprintable()
        str({int}).isnumeric()
        str({num}).isdecimal()
        python.isinstance({num}, int)
        python.isinstance({any}, (int, str))
        python.isinstance({bool}, int)
        python.issubclass(bool, int)
        python.any([{bool}, {bool}])
        python.all({v} > 0 for {v} in {ilist:2})
        python.any({bool:1+v=int} for {v} in {ilist:2})
        python.all([])
        isclose({flt}, {flt})
        isclose({num}, {num}, rel_tol=0.5)
        isnan(nan)
        isinf({num})
        isfinite({num})
        math.isfinite(inf)
        True == 1
        nan != nan
        ({flt}).is_integer()
        {ilist:6} == {ilist:6}
        {ilist:6} < {ilist:6}
        {wlist:6} >= {wlist:6}
        {text:6} != {word:6}
        python.type({num}) == float
        python.type({any}) is str
        [] is not {word:6}
        1 < {num:6} < 5 < 7
        python.bool({int})
        python.set({ilist}) == python.set({ilist})
        (1, {int}) <= ({int}, 2)
    ''',
    'word': '''
        {word:10} + {word:11} @3
        {word:11} * 2
        {word:10} + '_' + {word:11} @2
        {word:15}.upper() @2
        {word:15}.lower()
        {word:15}.title()
        {word:15}.capitalize() @2
        {word:15}.swapcase()
        {word:15}.casefold()
        {word:15}.replace('a', 'o') @2
        {word:15}.replace('e', '', 1) + 'w'
        {wlist:15}[{bit}] @3
        {wlist:15}[-1]
        '_'.join({wlist}) @2
        ''.join({wlist})
        '-'.join([{word}, {word}])
        '+'.join({v}.upper() for {v} in {wlist:2})
        {word:2} if {bool:2} else {word:1} @4
        {bool:3} and {word:4} or {word:3}
        '%s_%d' % ({word}, {int}) @2
        '%s%s' % ({word}, {word})
        '%s' % {word:12}
        '%(k)s_%(n)d' % dict(k={word}, n={int})
        '%-6s|' % {word:12}
        '%8s:' % {word:12}
        '%.2s%%' % {word:12}
        {word:15}[:2]
        {word:15}[::-1]
        {word:15}[-2:] + 'q'
        {word:15}[1:-1] + 'w'
        {word:15}[0] + 'q'
        {word:15}[::2] + 'w'
        {word:15}.strip('.')
        {word:15}.lstrip('ab') + 'q'
        {word:15}.rstrip({word}) + 'w'
        {word:15}.center({idx:10} + 9, '*')
        {word:15}.ljust(8, '.')
        {word:15}.rjust(8, 'x')
        {word:15}.zfill(9)
        {word:15}.partition('a')[0] + 'w'
        {word:15}.split('a')[0] + 'q'
        {word:15}.rsplit('_', 1)[-1]
        {word:15}.removeprefix('l') + 'w'
        {word:15}.removesuffix({word}) + 'q'
        str({word})
        {word:15}.encode().decode()
        {text:15}.split()[0]
        str({int}) + 'mm' @2
        str({num}) + ' m'
        '%x' % {idx:12} + 'z'
        max({wlist})
        min({wlist}, key=len)
        python.sorted({wlist})[0]
        [{v} for {v} in {wlist:2}][1]
        (lambda {v}: {v} + 'w')({word})
        ({word}, {word})[{bit}]
        'l r'.split()[{bit}] + 'w'
        xacro.tokenize('{plain}, {plain}')[{bit}]
        python.str({word})
        dict(k={word})['k']
        list({dict:15}.keys())[0] + 'w'
        python.repr({int}) + 'u'
        {word:15}.join('.,;')
        {word:15}.expandtabs()
        'x%sx' % (' '.join({wlist})) .strip()
    ''',
    'text': '''
        {text:10} + ' ' + {word:11} @3
        ' '.join([{text}, {word}])
        {text:15}.replace('a', 'e')
        {text:15}.title()
        {text:15}.upper()
        {text:15}.lower()
        {text:15}.swapcase()
        {text:15}.capitalize()
        {text:15}.casefold()
        '%s: %.3f' % ({word}, {num}) @2
        '%d %5.2f %e %g' % ({int}, {num}, {num}, {num}) @3
        '%5d|%-5d|%05d|%+d|% d' % ({int}, {int}, {int}, {int}, {int}) @2
        '%x %X %o %#x %#o' % ({idx}, {idx}, {idx}, {idx}, {idx})
        '%i%% %c %s' % ({num}, {word:15}[0], {any})
        '%r and %s' % ({text}, {mix})
        '%.0f %.1f %10.4f' % ({num}, {num}, {num})
        '%G %E %.2g %#.3g' % ({num}, {num}, {num}, {num})
        '%*d %.*f' % ({idx:10} + 4, {int}, {idx}, {num})
        '%s x' % ({ilist},)
        '%s x' % {dict:12}
        '%a z' % {text:12}
        str({ilist}) + ''
        str({dict})
        'v ' + str({any})
        'r ' + python.repr({any})
        '|'.join([str({v}) for {v} in {ilist:2}])
        ', '.join(map(str, {ilist}))
        ' / '.join({wlist})
        {text:2} if {bool:2} else {text:1}
        ({text}, {text})[{bit}]
        {text:15}.center(40)
        {text:15}.ljust(30, '~')
        {text:15}.expandtabs(4)
        {text:11} * 2
        ' '.join({text:15}.split()[::-1]) + ' w'
        'w' + {text:15}[1:]
        'w' + {text:15}[::-2]
    ''',
    'ilist': '''
        [{int}, {int}] @4
        [{int}, {int}, {int}, {int}] @2
        [{int}, {int},]
        {ilist:10} + {ilist:11} @2
        {ilist:11} * 2
        [{v} * 2 for {v} in {ilist:2}] @3
        [{int:1+v=int} for {v} in {ilist:2}] @2
        [{v} for {v} in {ilist:2} if {bool:2+v=int}] + [1, 2] @2
        [{v} for {v} in {ilist:2} if {v} > 1 if {v} < 90] + [3, 4]
        [{v} + {w} for {v} in [1, 2] for {w} in {ilist:2}]
        [[{v} * {w} for {v} in {ilist:2}][0] for {w} in [1, 2]]
        [{v} for {v}, {w} in python.zip({ilist}, {ilist})]
        [len({v}) for {v} in {wlist:2}]
        [{v} - 1 for {v}, _ in [(1, 2), (3, {int})]]
        python.sorted({ilist}) @2
        python.sorted({ilist}, key=lambda {v}: -{v})
        python.sorted({ilist}, reverse={bool})
        sorted({ilist})
        list(python.reversed({ilist}))
        {ilist:15}[::-1]
        {ilist:15}[:2]
        {ilist:15}[-2:]
        {ilist:15}[:]
        [*{ilist:6}, {int}]
        [{int}, *{ilist:6}, *python.range(2)]
        list(map(lambda {v}: {v} + 1, {ilist}))
        list(map(python.abs, {ilist}))
        list(python.range({idx}, 6))
        list(range(2, 9, {idx:10} + 1))
        list(python.range(5, {idx}, -1))
        list(python.filter(lambda {v}: {v} % 2, {ilist})) + [0, 9]
        list(python.tuple({ilist}))
        list({dict:15}.values())
        [int({v}) for {v} in '1 2 {digit}'.split()]
        [{v} for {v}, _ in python.enumerate({wlist}, 5)]
        {ilist:2} if {bool:2} else {ilist:1}
        {ilist:2} or [0, 1]
        ({ilist}, {ilist})[{bit}]
        [{ilist}, {ilist}][-1]
        {ilist:15}.copy()
        list(dict(python.zip({ilist}, {ilist})).keys()) + [1, 2]
        list(map(max, {ilist}, {ilist})) + [0, 0]
    ''',
    'wlist': '''
        [{word}, {word}] @4
        [{word}, {word}, {word}] @2
        '{plain} {plain} {plain}'.split() @3
        '{plain},{plain},x'.split(',')
        '{plain}-{plain}-x'.rsplit('-', 1)
        '{plain}\\n{plain}'.splitlines()
        xacro.tokenize('{plain} {plain};{plain}')
        xacro.tokenize('{plain}|{plain}', sep='|')
        xacro.tokenize('{plain}, {plain}', ',')
        {wlist:10} + {wlist:11}
        [{v} + '_' + {word:11} for {v} in {wlist:2}] @2
        [{word:1+v=word} for {v} in {wlist:2}]
        [{v}.upper() for {v} in {wlist:2} if True]
        ['%s%d' % {v} for {v} in python.zip({wlist}, {ilist})] + {wlist:11}
        python.sorted({wlist})
        python.sorted({wlist}, key=len)
        python.sorted({wlist}, key=lambda {v}: {v}[-1])
        {wlist:15}[::-1]
        {wlist:15}[:2]
        list(map(str.upper, {wlist}))
        list(map(lambda {v}: {v}[::-1] + 'w', {wlist}))
        list({word}) + ['w']
        {wlist:2} if {bool:2} else {wlist:1}
        list({dict:15}.keys())
        list(dict(x1=1, y1=2))
        list(python.reversed({wlist}))
        [*{wlist:6}, {word}]
        ['w' + {v} for {v} in {word:2}] + ['w']
    ''',
    'dict': '''
        dict(a={int}, b={int}) @4
        dict(b={int}, a={int}, c={int})
        dict([('a', {int}), ('b', {int}), ('c', 0)]) @2
        dict(python.zip('ab', {ilist}))
        dict({dict}, a={int})
        dict(**{dict})
        dict(({v}, len({v})) for {v} in ['a', 'b', 'cc'])
        {dict:15}.copy()
        {dict:2} if {bool:2} else {dict:1}
        dict([[{v}, 1] for {v} in 'ab'])
        xacro.dotify({dict})
    ''',
    'mix': '''
        [{any}, {any}] @3
        ({any},)
        ({any}, {any}) @2
        [None, True, {num}]
        [[{int}], ({word}, {flt})]
        [{text}, {bool}]
        {dict:16}
        [{dict}]
        {ilist:16}
        {wlist:16}
        list({dict:15}.items())
        list(python.enumerate({wlist}))
        python.divmod({int}, {nz})
        {word:15}.partition('a')
        list(python.zip({wlist}, {ilist}))
        python.tuple({ilist})
        [{odd}, {odd}]
        dict(k={any}, l=[{any}])
        list({word})
        [()]
        []
        [{any} for {v} in {ilist:2}]
        [({v}, {any}) for {v} in {wlist:2}]
        [{v} for {v} in [1, 2.5, {word}]]
        list({text:15}.split())
        dict([(1, {any}), (2.5, 'x'), (None, True)])
    ''',
    'fn': '''
        lambda {v}: {v} + 1
        lambda {v}: {int:1+v=int}
        lambda {v}, {w}=3: {v} * {w}
        lambda {v}: {v} if {v} > 0 else -{v}
        lambda *{v}: python.sum({v})
    ''',
    'any': '''
        {int:16} @3
        {num:16} @3
        {flt:16}
        {bool:16} @2
        {word:16} @3
        {text:16} @2
        {mix:16} @2
        None
        {odd:16} @2
    ''',
}

# Forms that may fail: closed expressions, tried out before they are used.
WILD = {
    'int': '''
        int('ff', 16)
        int('0b101', 0)
        int('-0x1A', 16)
        int('{digit}{digit}', {digit})
        int(' +{digit}_{digit} ')
        {int:15} ** {digit}
        {int:11} // {int:12}
        {int:11} % {int:12}
        {int:9} << {digit}
        {int:9} >> {int:10}
        {big:15}
        {big:10} + {big:11}
        {big:11} * {big:12}
        {big:11} // {int:12}
        {big:11} % {int:12}
        -{big:12} // {big:12}
        {big:8} & {big:9}
        {big:9} >> {digit}{digit}
        int({odd})
        round({odd})
        {word:15}.index('a')
        {text:15}.rindex('e', 0, 9)
        {ilist:15}[{int}]
        {word:15}.count({word:15}[:1], 1)
        [{int}, {int}].index({int})
        isqrt({big})
        gcd({big}, {big})
        factorial({digit}{digit})
        comb({digit}{digit}, {digit})
        python.ord({text:15}[-1])
        int(True) + int(1e18)
        round({int}, {nz})
        python.sum({ilist:15}[::2], start={int})
        ({big}).bit_length()
        int.from_bytes({word:15}.encode(), 'big')
        python.len({text:15}.encode('utf-8'))
        python.sum([1 for {v} in {text:2} if {v}.isupper()])
        (-{digit}) ** {digit}
    ''',
    'num': '''
        {num:15} ** {num:12}
        {num:11} / {num:12}
        {num:11} // {num:12}
        {num:11} % {num:12}
        {odd:15}
        {odd:11} * {num:12}
        {odd:10} + {odd:11}
        {odd:11} / {odd:12}
        {odd:11} // {num:12}
        {odd:11} % {num:12}
        {big:11} / {big:12}
        {big:11} * {flt:12}
        float({big})
        round({odd}, {digit})
        round({odd}, -{digit})
        log({num}, {num})
        pow({num}, {num})
        acos({num})
        sqrt({num})
        log({big})
        float('{digit}{digit}e-{digit}')
        float('.{digit}_{digit}')
        float('+1.{digit}E+1{digit}')
        float('{digit}' * 20)
        fmod({odd}, {num})
        copysign({odd}, {odd})
        max({odd}, {num})
        min([{odd}, {num}])
        fsum([{odd}, {num}, {odd}])
        hypot({odd}, {num})
        floor({odd})
        exp({num})
        python.sum([0.1] * {digit})
        prod([1.5, {num}, {num}])
        ldexp({num}, {int})
        math.dist([{num}, {num}], [{num}, {num}])
        gamma({num})
        lgamma({num})
        sin({odd})
        atan2({odd}, {odd})
        nextafter({odd}, 1)
        python.divmod({num}, {num})
        ({odd}).hex()
        ({num}).as_integer_ratio()
    ''',
    'text': '''
        {text:15}.split({word:15}[0])
        {text:15}.split(None, 1)
        {text:15}.rsplit(' ', 1)
        {text:15}.splitlines()
        {text:15}.partition(' ')
        {text:15}.rpartition({word:15}[-1])
        {text:15}.strip({word})
        {text:15}[{int}:{int}]
        {text:15}[{int}:{int}:{nz}]
        {text:15}[{int}]
        {text:15}[::{nz}]
        {text:15}.replace({word:15}[0], {text}, {idx})
        {text:15}.center({digit}{digit}, '=')
        {text:15}.zfill({digit}{digit})
        ('%d' % {int:12}).zfill(8)
        {text:15}.find({word:15}[0], {int}, {int})
        {text:15}.startswith({word}, {int})
        {text:15}.title().swapcase()
        {text:15}.translate(dict([(97, 'X'), (101, None), (105, 9)]))
        {text:15}.isidentifier(), {text:15}.isnumeric(), {text:15}.isdecimal()
        '%{digit}.{digit}f|' % {odd:12}
        '%+.{digit}e|' % {odd:12}
        '%.{digit}g|' % {odd:12}
        '%#.{digit}g|' % {odd:12}
        '%0{digit}d|' % {int:12}
        '%-{digit}d|' % {int:12}
        '% 0{digit}.2f|' % {num:12}
        '%s %s' % {odd2:12}
        '%r %a' % ({text}, {text})
        '%c%c' % ({digit}{digit}, {word:15}[0])
        '%(a)s %(b)05.1f' % dict(a={any}, b={num})
        '%d' % {odd:12}
        '%x' % {big:12}
        '%o %X' % ({int}, {int})
        '%+x %#X' % ({int}, {int})
        '%.3d %+.4i' % ({int}, {int})
        '%5s|%-5s|%.1s' % ({any}, {word}, {any})
        '%s %%' % {any:12}
        python.repr({text})
        python.repr([{text}, {text}])
        python.repr({odd})
        str({big})
        str({mix}).replace(',', ';')
        {text:15}.encode('ascii', 'replace').decode()
        {word:15}.encode()
        {text:15}.encode('utf-8')
        '{plain}'.join({text:15}.split())
        ','.join(python.sorted({text}))
        ''.join(python.reversed({text}))
        max({text})
        {text:15}.lower().count('e')
        {text:15}.casefold() == {text:15}.lower()
        {text:15}.expandtabs({digit})
        {word:15}.ljust({digit}{digit}) + '|'
        {text:15}.rstrip() + {text:15}.lstrip({word})
        {text:15} .upper()
    ''',
    'mix': '''
        {ilist:15}[{int}:{int}]
        {ilist:15}[{int}:{int}:{nz}]
        {wlist:15}[::{nz}]
        python.sorted({mix})
        python.sorted([{num}, {num}, {num}])
        python.sorted({wlist}, key=lambda {v}: ({v}[-1], len({v})))
        list(map(lambda {v}, {w}: {v} - {w}, {ilist}, {ilist}))
        list(python.zip({ilist}, {text}, {wlist}))
        list(python.enumerate({text}, {int}))[:4]
        python.set({ilist})
        python.sorted(python.set({word}))
        python.frozenset([{idx}])
        python.range({int}, {int}, {nz})
        list(python.range({idx}, {digit}{digit}, {digit}))
        python.tuple({word})
        {dict:15}.keys()
        {dict:15}.values()
        {dict:15}.items()
        python.slice({idx}, None)
        python.list(python.filter(None, {mix}))
        [{v} for {v} in python.range({digit}) if {v} % 2 for {w} in 'ab']
        [[{w} for {w} in python.range({v})] for {v} in python.range({digit})]
        dict(python.enumerate({word}))
        dict([({v}, {w}) for {w}, {v} in python.enumerate({word})])
        [*{word:6}, *{ilist:6}]
        {mix:11} * {idx:12}
        {ilist:10} + list({word})
        {mix:6} == {mix:6}
        {mix:6} < {mix:6}
        {mix:15}[{int}]
        dict({dict}, **{dict})
        {dict:15}.pop('a')
        {dict:15}.setdefault('z', {any})
        python.complex({num}, {num})
        {num:10} + 2j
        (1+2j) * {num:12}
        python.type({any})
        (lambda {v}, *{w}, k=1, **q: [{v}, {w}, k, q])({any}, {any}, z={any})
        (lambda: {any})()
        (lambda {v}=({any}): {v})()
        [{any}, ...]
        [{v} for {v} in [{any}, {any}] if {v}]
        {ilist:15}.copy().sort()
        max({wlist}, {wlist})
        min([[{int}, {any}], [{int}]])
        python.sum([[1], {ilist}], [])
        dict.fromkeys({word})
        list({dict})
        [{v} for {v} in {dict:2}]
        python.sorted({dict:15}.items(), key=lambda {v}: {v}[1])
        (1, 2, {any})[{int}:]
        ()
        ({any})
        python.any({mix}), python.all({mix})
        bool({mix}), not {mix:5}
        [x for x in [1, 2, 3] if x > 1] [-1]
        ["a" "b", 'c' r'\\d', u'é']
        xacro.tokenize({text})
        xacro.tokenize({text}, sep=' e', skip_empty=False)
    ''',
}
