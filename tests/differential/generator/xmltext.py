"""Spelling of XML: quoted attributes, escaped text, white space between nodes."""
from . import literals

# In values: a line end or a tab written as such, which a parser reads as a blank.
RAW_LINE_END, RAW_TAB = '\ue000', '\ue001'
SPECIAL = {'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&apos;'}


def reference(rng, char):
    """A character reference."""
    return rng.choice(['&#%d;', '&#x%x;', '&#x%X;']) % ord(char)


def escape(rng, text, must):
    """Escape the characters of `must`, sometimes others too, in one way or another."""
    out = []
    for char in text:
        if char in must:
            out.append(SPECIAL.get(char) if char in SPECIAL and rng.random() < 0.85 else reference(rng, char))
        elif char in SPECIAL and char != '&' and rng.random() < 0.1:
            out.append(SPECIAL[char])
        elif ord(char) > 127 and char not in (RAW_LINE_END, RAW_TAB) and rng.random() < 0.15:
            out.append(reference(rng, char))
        else:
            out.append(char)
    return ''.join(out)


def attribute(rng, name, value):
    """` name="value"` such that a parser reads back `value`."""
    mark = "'" if rng.random() < (0.5 if '"' in value else 0.08) else '"'
    text = escape(rng, value, '<&\n\t\r' + mark)
    if ' ' in text and rng.random() < 0.02:  # a line end in an attribute reads as a blank
        cut = text.index(' ')
        text = text[:cut] + rng.choice(['\n', '\t']) + text[cut + 1:]
    text = text.replace(RAW_LINE_END, '\n').replace(RAW_TAB, '\t')
    gap = ' ' if rng.random() < 0.96 else rng.choice(['  ', '\n    ', '\t'])
    equals = '=' if rng.random() < 0.98 else rng.choice([' = ', '= ', ' ='])
    return gap + name + equals + mark + text + mark


def content(rng, text):
    """Character data of an element."""
    if ']]>' not in text and '${' not in text and rng.random() < 0.02:
        return '<![CDATA[' + text + ']]>'
    return escape(rng, text.replace('\r', ''), '<&').replace(']]>', ']]&gt;')


def tag(rng, name, attributes, children=None, shuffle=True):
    """An element; `attributes` are (name, value), `children` its finished content."""
    attributes = list(attributes)
    if shuffle:
        rng.shuffle(attributes)
    head = '<' + name + ''.join(attribute(rng, n, v) for n, v in attributes)
    if children is None:
        if rng.random() < 0.04:
            return head + '></' + name + '>'
        return head + rng.choice(['/>', '/>', '/>', ' />'])
    return head + ('>' if rng.random() < 0.97 else ' >') + children + '</' + name + '>'


def comment_text(rng):
    """Text of a comment; expressions in it are not evaluated unless asked for."""
    text = ' '.join(rng.choice(literals.WORDS) for _ in range(rng.randrange(1, 4)))
    return rng.choice([' %s ', ' %s ', '%s', ' %s: ${1 + 1} ', '\n  %s\n', ' ${nothing} %s ', ' <%s/> & ', ' $(arg nothing) %s ', ' %s é ']) % text


def gap(rng, depth, stats):
    """What stands between two nodes: mostly a line end and indentation."""
    roll = rng.random()
    indent = '  ' * depth
    if roll < 0.70:
        return '\n' + indent
    if roll < 0.80:
        return '\n\n' + indent
    if roll < 0.86:
        return ''
    if roll < 0.89:
        return ' '
    if roll < 0.92:
        return '\n' + rng.choice(['  ', '\t', ' \t ']) + '\n' + indent
    if roll < 0.94:
        return '\n\n\n'
    if roll < 0.955:
        stats('mixed text')
        return '\n' + indent + rng.choice(['words', 'a &amp; b', 'é', '${1 + 1}', 'x ${"y"} z', "${''}", '&lt;', 'US$5', '"q"']) + rng.choice(['\n', ' ', '']) + indent
    if roll < 0.965:
        stats('CDATA')
        return rng.choice(['', '\n' + indent]) + '<![CDATA[' + rng.choice(['a < b', '${1}', '', ' & ', '\n', ']]']) + ']]>'
    if roll < 0.975:
        stats('processing instruction')
        return '\n' + indent + rng.choice(['<?tool ${1}?>', '<?x?>', '<?a b c="d" ?>'])
    if roll < 0.985:
        return rng.choice(['&#10;', '&#32;', '&#9;\n', "${'  '}", "${'\\n\\n'}"])
    return '\n' + indent + ' '


def layout(rng, nodes, depth, stats):
    """Join nodes with white space, comments and the like."""
    parts = []
    for node in nodes:
        parts.append(gap(rng, depth, stats))
        for _ in range(4):
            if rng.random() > 0.13:
                break
            stats('comment')
            parts.append('<!--' + comment_text(rng) + '-->')
            parts.append(rng.choice(['\n' + '  ' * depth] * 6 + ['\n\n', '', ' ', '\n \n', '\n\n\n']))
        if rng.random() < 0.012:
            stats('eval-comments')
            parts.append('<!-- xacro:eval-comments%s -->' % rng.choice(['', '', '', ':off']))
            parts.append(rng.choice(['\n' + '  ' * depth] * 3 + ['', '\n\n']))
            for _ in range(rng.randrange(3)):
                parts.append('<!-- %s -->' % rng.choice(['v ${1 + 1}', '$${x}', 'plain', '${[1, 2]}', "${'a' * 3} US$5", '']))
                parts.append(rng.choice(['\n' + '  ' * depth] * 3 + ['', ' ', '${1}', 'text']))
            if rng.random() < 0.4:
                parts.append('<!-- xacro:eval-comments:off -->')
        parts.append(node)
    if nodes or rng.random() < 0.1:
        parts.append(rng.choice(['\n' + '  ' * (depth - 1)] * 8 + ['', '\n\n', ' ', '<!-- last -->\n']))
    return ''.join(parts)
