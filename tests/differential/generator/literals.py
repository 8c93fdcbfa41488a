"""Random words, numbers and strings, and their spelling as Python source."""

WORDS = ('arm base cam dock elbow fork grip hand idler jaw knee link mast nose pan quill rail sled tilt '
         'upper vane wrist yaw axle boom claw drum front rear left right outer inner tool probe').split()
UNICODE = ['é', 'ß', 'Ω', 'ñ', '漢字', '→', '½', '\u00a0', '\u2003', 'ａ', '𝄞', 'İ', 'ﬁ', 'e\u0301']
INTS = ['0', '1', '2', '7', '10', '42', '255', '1000', '0x1F', '0XfF', '0o17', '0b101', '1_000', '00', '99999']
BIG_INTS = ['18446744073709551616', '9223372036854775807', '-9223372036854775808', '10**30', '2**100', '123456789012345678901234567890']
FLOATS = ['0.5', '1.', '.25', '1.5', '2.75', '12.34', '100.0', '0.1', '3.14159', '1e1', '1E2', '2.5e-1', '1_0.5', '999.999', '0.333333']
ODD_FLOATS = ['1e16', '1e15', '123456789012345678.0', '1e22', '1e21', '1e-4', '1e-5', '0.00012345', '5e-324', '1.7976931348623157e308',
              '2.2250738585072014e-308', '-0.0', '0.1+0.2', '1/3', '2/3', '1e100', '9007199254740993.0', '4.35', '0.1+0.7', '1e23',
              '1e400', '-1e400', 'nan', 'inf', '-inf', '100*1.1', '1.005*1000', '3*1.1', '5e-5', '12345678.9', '1e5', '1.0e0']

# Texts of properties at the edge of the literal rule.
ODD_LITERALS = ['007', '1_000', '1e5', '.5', '5.', '+3', ' 42 ', '-0', '-0.0', '1e400', 'inf', '-inf', 'nan', 'Infinity', '-Infinity',
                'INF', 'NaN', 'infinit', 'True', 'true', 'TRUE', 'false', 'False', 'None', '0x10', '0b1', '1,5', '1 2', '\u0661\u0662',
                '\uff11\uff12', '\u00b2', "'quoted'", "''", "'", "'42'", "''42''", '"dq"', "'a' 'b'", "'1' + '2'", '', ' ', '  x  ', '--1',
                '+-1', '1e', 'e1', '1.5.2', '1__0', '_1', '1_', '+.5e-3', '1E+2', '\u00a07\u00a0', '12345678901234567890123', '1.50',
                '00', '-007', '1e22', '0.1e1', 'truE', '1 ', '\t1', '1\n', 'yes', 'no', "'true'", "'1", "1'", '1.e1', '.', '-', '+',
                '1d', '1f', '1L', '0o7', '1e+16', '123456789.123456789', '4.', '-.5', "' '", "'''", "''''", '\u0967']

ESCAPES = ['\\n', '\\t', '\\\\', "\\'", '\\"', '\\x41', '\\u00e9', '\\101', '\\x7e', '\\U0001d11e', '\\u200b', '\\xa0', '\\x7f', '\\0', '\\a']


def word(rng):
    """A lower-case word, sometimes two joined by an underscore."""
    text = rng.choice(WORDS)
    return text + '_' + rng.choice(WORDS) if rng.random() < 0.12 else text


def free_text(rng):
    """Text for humans: words, punctuation, other scripts; begins with a letter."""
    parts = [rng.choice(WORDS)]
    for _ in range(rng.randrange(4)):
        parts.append(rng.choice([' ', ' ', ', ', '-', ': ', '/', ' (', ') ', '  ', "'", ' & ', ' < ', '>', ';', '#', '%', '"', '.', '\\ ', '@']))
        parts.append(rng.choice(UNICODE) if rng.random() < 0.2 else rng.choice(WORDS))
    return ''.join(parts)


def quote(rng, text):
    """Python source of a string without `$` and `}`."""
    text = text.replace('\\', '\\\\')
    styles = ["'", "'", "'", '"', '"""', "'''"]
    mark = rng.choice(styles)
    if len(mark) == 3 and (text.endswith(mark[0]) or mark in text):
        mark = mark[0]
    if len(mark) == 1:
        text = text.replace(mark, '\\' + mark)
    prefix = rng.choice(['', '', '', '', '', '', 'u', 'f']) if '{' not in text and '\\' not in text else ''
    if '\\' not in text and rng.random() < 0.03:
        prefix = rng.choice(['r', 'R', 'rf', 'F'])
    return prefix + mark + text + mark


def word_literal(rng):
    text = word(rng)
    if rng.random() < 0.06 and len(text) > 3:  # implicit concatenation
        cut = rng.randrange(1, len(text))
        return '(%s %s)' % (quote(rng, text[:cut]), quote(rng, text[cut:]))
    return quote(rng, text)


def text_literal(rng):
    source = quote(rng, free_text(rng))
    if rng.random() < 0.25:
        source = '(%s "%s%s")' % (source, rng.choice(ESCAPES), rng.choice(['', 'z']))
    return source
