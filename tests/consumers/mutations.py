"""Single random changes of a robot, which its author might make by mistake. They know nothing of the table."""
import re

NUMBER = r'-?\d+(?:\.\d+)?(?:e-?\d+)?'
WORDS = ['abc', '', 'nan', 'inf', '1e400', '0', '-1', '0,5', '1.5f', '0x1', '1 ', ' 1', '1e-320', '\t1', '${x}', '1e10']
NAMES = ['', 'world', 'universe', 'a b', 'a/b', 'ä', '1x', '__x__', 'a::b', 'base_link', 'X-y']
TYPES = ['fixed', 'revolute', 'continuous', 'prismatic', 'floating', 'planar', 'ball', 'Revolute', '', 'screw']
URIS = ['', 'package://none/a.stl', 'none.stl', 'file:///none.stl', 'http://127.0.0.1:9/a.stl', 'package:/x/a.stl']
SHAPES = ['<box size="0.1 0.1 0.1"/>', '<sphere radius="0.1"/>', '<cylinder radius="0.1" length="0.2"/>', '<box/>', '<cone/>',
          '<capsule radius="0.1" length="0.2"/>', '<sphere radius="0"/>', '<box size="0 1 1"/>', '']


ELEMENTS = ['<mimic joint="none"/>', '<dynamics/>', '<safety_controller k_velocity="1"/>', '<origin xyz="0 0 0"/>', '<gazebo/>', '<sensor/>',
            '<calibration/>', '<material name="m"/>', '<link name="base_link"/>', '<!-- a comment -->', '<limit effort="1" velocity="1"/>',
            '<gazebo><static>true</static></gazebo>', '<transmission name="t"/>', '<mass value="1"/>', '<inertial/>', '<unknown/>', 'text',
            '<visual/>', '<axis xyz="0 0 1"/>', '<axis/>', '<joint name="j" type="fixed"/>', '<mujoco/>', '<geometry/>', '<contact/>']
CHARACTERS = ['&', '<', '"', '>', '--', ' ', 'é', '&amp;', ']]>', '<!-- -- -->', '&#1;', '\t', '/']


def one_of(found, source):
    """One of the matches; each kind of element or attribute, group 1, is as likely as any other."""
    kinds = sorted({match.group(1) for match in found})
    if not kinds:
        return None
    kind = source.choice(kinds)
    return source.choice([match for match in found if match.group(1) == kind])


def drop_element(text, source):
    found = list(re.finditer(r'<(inertial|mass|inertia|limit|axis|origin|parent|child|geometry|visual|collision|color|material|link|joint|'
                             r'mimic|dynamics|safety_controller|transmission|actuator)\b(?:[^>]*/>|[^>]*>.*?</\1>)', text, re.S))
    match = one_of(found, source)
    if match is None:
        return None
    return text[:match.start()] + text[match.end():]


def twice(text, source):
    found = list(re.finditer(r'<(inertial|mass|inertia|limit|axis|origin|parent|child|geometry|visual|collision|color|material|mimic|dynamics)'
                             r'\b(?:[^>]*/>|[^>]*>.*?</\1>)', text, re.S))
    if not found:
        return None
    match = source.choice(found)
    return text[:match.end()] + match.group(0) + text[match.end():]


def drop_attribute(text, source):
    found = list(re.finditer(r'\s(?!xmlns)([a-z_:]+)="[^"]*"', text))
    match = one_of(found, source)
    if match is None:
        return None
    return text[:match.start()] + text[match.end():]


def number(text, source):
    found = list(re.finditer(r'\b(value|ixx|ixy|izz|lower|upper|effort|velocity|xyz|rpy|size|radius|length|scale|rgba|damping|friction|'
                             r'multiplier|offset|k_velocity|rising)="([^"]*)"', text))
    match = one_of(found, source)
    if match is None:
        return None
    parts = match.group(2).split() or ['']
    way = source.randrange(4)
    if way == 0 and len(parts) > 1:
        new = ' '.join(parts[:-1])
    elif way == 1 and len(parts) > 1:
        new = ' '.join([*parts, '0'])
    else:
        parts[source.randrange(len(parts))] = source.choice(WORDS)
        new = source.choice([' ', ' ', ' ', '\t', ', ']).join(parts) if len(parts) > 1 else parts[0]
    return text[:match.start(2)] + new + text[match.end(2):]


def replaced(pattern, values):
    def change(text, source):
        found = list(re.finditer(pattern, text))
        if not found:
            return None
        match = source.choice(found)
        return text[:match.start(1)] + source.choice(values) + text[match.end(1):]
    return change


def renamed(text, source):
    found = sorted(set(re.findall(r'<(?:link|joint)\s+name="([^"]+)"', text)))
    if not found:
        return None
    return text.replace('"%s"' % source.choice(found), '"%s"' % source.choice(NAMES))


def shape(text, source):
    found = list(re.finditer(r'<geometry>(.*?)</geometry>', text, re.S))
    if not found:
        return None
    match = source.choice(found)
    return text[:match.start(1)] + source.choice(SHAPES) + text[match.end(1):]


def inserted(text, source):
    """An element that robots have, somewhere between others."""
    found = list(re.finditer(r'(?<=>)\s*(?=<(?:link|joint|visual|collision|inertial|axis|limit|geometry|/robot|/link|/joint)\b)', text))
    return text[:(at := source.choice(found).end())] + source.choice(ELEMENTS) + text[at:] if found else None


def character(text, source):
    """Something that XML does not allow, or that its readers read in several ways."""
    found = list(re.finditer(r'="[^"]*"|<[a-z]+|</[a-z]+>|>\s*<', text))
    if not found:
        return None
    at = source.choice(found).end() - 1
    return text[:at] + source.choice(CHARACTERS) + text[at + source.randrange(2):]


CHANGES = {
    'inserted': inserted, 'character': character,
    'dropped': drop_element, 'twice': twice, 'attribute': drop_attribute, 'number': number, 'renamed': renamed, 'shape': shape,
    'type': replaced(r'<joint\b[^>]*\btype="([^"]*)"', TYPES), 'mesh': replaced(r'<mesh\b[^>]*\bfilename="([^"]*)"', URIS),
    'version': replaced(r'<robot\b[^>]*?(?= |>)()', [' version="1"', ' version="1.1"', ' version="1.0"', ' version="x"']),
    'child': replaced(r'<child\s+link="([^"]*)"', NAMES), 'parent': replaced(r'<parent\s+link="([^"]*)"', NAMES),
}


def mutate(text, source):
    """The name of a change, and the changed text; none when there was nothing to change."""
    name = source.choice(sorted(CHANGES))
    return name, CHANGES[name](text, source)
