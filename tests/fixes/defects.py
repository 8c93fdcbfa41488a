"""Defects that the linter can fix, written into the texts of a robot at random."""
import re

NUMBER = re.compile(r'"(-?(?:0|[1-9]\d?)\.\d*[1-9])"')


def replace_one(rng, text, pattern, new):
    """One match of a pattern replaced, picked at random; none when there is no match."""
    matches = list(re.finditer(pattern, text))
    if not matches:
        return None
    match = rng.choice(matches)
    made = new(match) if callable(new) else match.expand(new)
    return text[:match.start()] + made + text[match.end():]


def behind_root(rng, text, content):
    """Content as the first child of the root element."""
    del rng
    match = re.search(r'<robot\b[^>]*[^/]>', text)
    return match and text[:match.end()] + content + text[match.end():]


def before_end(text, content):
    at = text.rfind('</robot>')
    return text[:at] + content + text[at:] if at > 0 else None


def no_declaration(rng, text):
    del rng
    return re.sub(r'^<\?xml.*?\?>\s*', '', text) if text.startswith('<?xml') else None


def blank_in_front(rng, text):
    del rng
    return '\n' + text if text.startswith('<?xml') else None


def other_namespace(rng, text):
    address = rng.choice(['http://ros.org/wiki/xacro', 'http://www.ros.org/xacro', 'https://www.ros.org/wiki/xacro'])
    return replace_one(rng, text, r'xmlns:xacro="[^"]*"', 'xmlns:xacro="%s"' % address)


def identity_origin(rng, text):
    origin = rng.choice(['<origin xyz="0 0 0" rpy="0 0 0"/>', '<origin/>', '<origin xyz="0 0 0"/>', '<origin rpy="0.0 0 -0"/>'])
    return replace_one(rng, text, r'<(visual|collision)>(?!\s*<origin)', r'<\1>' + origin)


def no_axis(rng, text):
    return replace_one(rng, text, r'\s*<axis xyz="[^"]*"\s*/>', '')


def axis_of_fixed(rng, text):
    extra = rng.choice(['<axis xyz="0 0 1"/>', '<limit lower="0" upper="1" effort="1" velocity="1"/>', '<dynamics damping="0.1"/>'])
    return replace_one(rng, text, r'(<joint\b[^>]*type="fixed"[^>]*>)', r'\1' + extra)


def empty_dynamics(rng, text):
    return replace_one(rng, text, r'(<joint\b[^>]*type="(?:revolute|continuous|prismatic)"[^>]*>)', r'\1<dynamics/>')


def limits_of_continuous(rng, text):
    limit = '<limit lower="-3" upper="3" effort="1" velocity="1"/>'
    return replace_one(rng, text, r'(<joint\b[^>]*type="continuous"[^>]*>)(?![\s\S]{0,400}<limit)', r'\1' + limit)


def needless_expression(rng, text):
    return replace_one(rng, text, NUMBER, r'"${\1}"')


def type_in_capitals(rng, text):
    return replace_one(rng, text, r'type="(revolute|fixed|continuous|prismatic)"', lambda m: 'type="%s"' % m[1].capitalize())


def without_prefix(rng, text):
    return replace_one(rng, text, r'<xacro:(property|include|if)\b([^>]*)/>', r'<\1\2/>')


def call_without_prefix(rng, text):
    names = set(re.findall(r'<xacro:macro name="(\w+)"', text))
    calls = [m for m in re.finditer(r'<xacro:(\w+)\b([^>]*)/>', text) if m[1] in names]
    if not calls:
        return None
    match = rng.choice(calls)
    return text[:match.start()] + '<%s%s/>' % (match[1], match[2]) + text[match.end():]


def switch_as_text(rng, text):
    name, value = 'sw%d' % rng.randrange(1000), rng.choice(['true', 'false'])
    test = rng.choice(["%s == 'true'", "%s != 'True'", "'false' == %s", "%s == 'true' or %s == 'maybe'"]).replace('%s', name)
    source = rng.choice(['<xacro:arg name="%s" default="%s"/><xacro:property name="%s" value="$(arg %s)"/>' % (name, value, name, name),
                         '<xacro:property name="%s" value="%s"/>' % (name, value)])
    return behind_root(rng, text, source) and before_end(behind_root(rng, text, source), '<xacro:if value="${%s}"><material name="m_%s"/></xacro:if>' % (test, name))


def macro_with_text(rng, text):
    name = 'tx%d' % rng.randrange(1000)
    values = rng.sample(['true', 'false', 'maybe', 'True', '1'], 2)
    body = '<xacro:if value="${q == \'true\'}"><material name="${q}_%s"/></xacro:if>' % name
    calls = ''.join('<xacro:%s q="%s"/>' % (name, value) for value in values)
    return before_end(text, '<xacro:macro name="%s" params="q">%s</xacro:macro>%s' % (name, body, calls))


def joint_macro(rng, text):
    name, kinds = 'jm%d' % rng.randrange(1000), rng.sample(['fixed', 'revolute', 'continuous'], 2)
    extra = rng.choice(['<axis xyz="0 1 0"/>', '', '<dynamics/>'])
    body = ('<joint name="${n}" type="${k}"><parent link="${n}_a"/><child link="${n}_b"/>%s'
            '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint><link name="${n}_b"/>' % extra)
    calls = ''.join('<xacro:%s n="%s%d" k="%s"/>' % (name, name, i, kind) for i, kind in enumerate(kinds))
    return before_end(text, '<xacro:macro name="%s" params="n k">%s</xacro:macro>%s' % (name, body, calls))


def include_again(rng, text):
    includes = re.findall(r'<xacro:include filename="[^"$]*"\s*/>', text)
    if not includes:
        return None
    between = rng.choice(['', '<xacro:property name="again" value="1"/>'])
    return before_end(text, between + rng.choice(includes))


def idle_suppression(rng, text):
    rule = rng.choice(['zero-mass', 'orphan-link', 'missing-axis', 'no-such-rule', 'orphan-lnk'])
    return replace_one(rng, text, r'\n(\s*)(<(?:link|joint|xacro:if)\b)',
                       lambda m: '\n%s<!-- xacro-lint: disable-next-line %s -->\n%s%s' % (m[1], rule, m[1], m[2]))


def near_pi(rng, text):
    return replace_one(rng, text, r'rpy="0 0 0"', 'rpy="0 0 1.57"')


def returns(rng, text):
    del rng
    return text.replace('\n', '\r\n') if '\r' not in text else None


def marked(rng, text):
    del rng
    return '\ufeff' + text if not text.startswith('\ufeff') else None


ALL = [no_declaration, blank_in_front, other_namespace, identity_origin, no_axis, axis_of_fixed, empty_dynamics,
       limits_of_continuous, needless_expression, type_in_capitals, without_prefix, call_without_prefix, switch_as_text,
       macro_with_text, joint_macro, include_again, idle_suppression, near_pi, returns, marked]


def plant(rng, texts, count):
    """Write `count` defects into the texts of a robot (by file name); the names of those that found a place."""
    planted = []
    for _ in range(count * 5):
        if len(planted) == count:
            break
        defect, file = rng.choice(ALL), rng.choice(sorted(texts))
        changed = defect(rng, texts[file])
        if changed and changed != texts[file]:
            texts[file] = changed
            planted.append(defect.__name__)
    return planted
