"""Whether two expansions are the same robot but for a name. Knows nothing of the linter's own comparison."""
import re
import xml.etree.ElementTree as ET

LINK, JOINT, MATERIAL = 'link', 'joint', 'material'
# what names the robot's things, by element and attribute; a reference may mean links and joints
SLOTS = {('link', 'name'): LINK, ('joint', 'name'): JOINT, ('parent', 'link'): LINK, ('child', 'link'): LINK,
         ('mimic', 'joint'): JOINT, ('material', 'name'): MATERIAL, ('gazebo', 'reference'): (LINK, JOINT),
         # what an SRDF says of the robot
         ('disable_collisions', 'link1'): LINK, ('disable_collisions', 'link2'): LINK, ('chain', 'base_link'): LINK,
         ('chain', 'tip_link'): LINK, ('end_effector', 'parent_link'): LINK, ('virtual_joint', 'child_link'): LINK,
         ('passive_joint', 'name'): JOINT}
BANNER = re.compile(r'^<!-- (=+|\|.*\|) -->\n', re.M)


def body(run):
    return BANNER.sub('', run.out)


def failures(run, old='', new=''):
    """What an expansion was refused for, without columns and quoted text."""
    found = []
    for line in run.err.splitlines():
        place = re.match(r'\s*(?:-->|:::)\s*(.*?):(\d+):\d+', line)
        if place:
            found.append(place[1].rsplit('/', 1)[-1] + ':' + place[2])
        elif re.match(r'(error|warning|note|help)\b', line):
            found.append(line)
    words = '\n'.join(found)
    return words.replace(new, old) if new else words


def difference(before, after, old, new, is_robots):
    """How a robot differs by more than the name; none when it does not."""
    if before.code or after.code:
        if not before.code:
            return 'is refused: ' + failures(after)[:300]
        if not after.code:
            return 'is accepted, and was not'
        one, other = failures(before), failures(after, old, new)
        # suggestions depend on what else has a similar name
        one, other = (re.sub(r'help: .*', '', text) for text in (one, other))
        return None if one == other else 'is refused for another reason: %s\n instead of %s' % (other[:300], one[:300])
    if not is_robots:
        return None if body(before) == body(after) else 'differs: ' + first_difference(body(before), body(after))
    return renamed_difference(ET.fromstring(before.out), ET.fromstring(after.out), old, new)


def first_difference(one, other):
    pairs = zip(one.splitlines() + ['(end)'], other.splitlines() + ['(end)'])
    return next(('%r instead of %r' % (b.strip(), a.strip()) for a, b in pairs if a != b), '')[:300]


def renamed_difference(one, other, old, new):
    pairs, stack, names, texts, either = [], [(one, other)], {}, [], []
    while stack:
        a, b = stack.pop()
        if a.tag != b.tag or a.attrib.keys() != b.attrib.keys() or len(a) != len(b):
            return 'has other elements: <%s> and <%s>' % (a.tag, b.tag)
        stack += zip(a, b)
        pairs += [((a.tag, key), a.get(key), b.get(key)) for key in a.attrib]
        texts.append((a.tag, (a.text or '').strip(), (b.text or '').strip()))
    for slot, a, b in pairs:
        # a name that follows another one, as that of a transmission, may change; a file or a number may not
        if a != b and (b.replace(new, old) != a or slot not in SLOTS and slot[1] != 'name'):
            return '%s %s: %r became %r' % (*slot, a, b)
        kind = SLOTS.get(slot)
        if isinstance(kind, str):
            names.setdefault((kind, a), set()).add(b)
        elif kind:
            either.append((a, b))
    taken = {}
    for (kind, a), became in names.items():
        if len(became) > 1:
            return '%s %r became %s' % (kind, a, sorted(became))
        for b in became:
            if taken.setdefault((kind, b), a) != a:
                return '%s %r is the name of two now' % (kind, b)
    for a, b in either:
        became = names.get((LINK, a), set()) | names.get((JOINT, a), set())
        if b not in (became or {a}):
            return 'reference %r became %r' % (a, b)
    things = {a for kind, a in names if kind in (LINK, JOINT)}
    for tag, a, b in texts:
        if a != b and (b.replace(new, old) != a or a not in things):
            return 'text of <%s>: %r became %r' % (tag, a[:80], b[:80])
    return None


def left(before, after):
    """Names of links and joints that are gone, where texts and other attributes still say them."""
    one, other = ET.fromstring(before.out), ET.fromstring(after.out)
    own = lambda root: {e.get('name') for e in root.iter() if e.tag in ('link', 'joint')}  # noqa: E731
    gone = own(one) - own(other)
    found = set()
    for element in other.iter():
        if (element.text or '').strip() in gone:
            found.add('<%s>%s' % (element.tag, element.text.strip()))
        found |= {'<%s %s="%s">' % (element.tag, key, value) for key, value in element.attrib.items() if value in gone}
    return sorted(found)
