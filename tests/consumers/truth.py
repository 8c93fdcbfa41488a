"""What a robot says by itself, and whether a reader made something else of it."""
import math
import pathlib
import xml.etree.ElementTree as ElementTree

INVALID = 'invalid'


def number(text):
    """A number as URDF means it; INVALID when it is none."""
    try:
        value = float(text)
    except ValueError:
        return INVALID
    return value if math.isfinite(value) and '_' not in text else INVALID


def of(path):
    """{links: {name: mass}, joints: {name: [lower, upper]}} of a file; none when it cannot be parsed."""
    try:
        robot = ElementTree.fromstring(pathlib.Path(path).read_bytes())
    except ElementTree.ParseError:
        return None
    links, joints = {}, {}
    for link in robot.findall('link'):
        mass = link.find('inertial/mass')
        has = link.find('inertial') is not None
        value = number(mass.get('value', '')) if mass is not None else (INVALID if has else None)
        links[link.get('name', '')] = value
    for joint in robot.findall('joint'):
        limit = joint.find('limit')
        bounded = joint.get('type') in ('revolute', 'prismatic')
        bounds = [None, None]
        if bounded:
            get = (lambda name: number(limit.get(name, ''))) if limit is not None else (lambda name: INVALID)
            bounds = [get('lower'), get('upper')]
        joints[joint.get('name', '')] = bounds
    fixed = {joint.find('child').get('link') for joint in robot.findall("joint[@type='fixed']") if joint.find('child') is not None}
    held = {joint.find('parent').get('link') for joint in robot.findall("joint[@type='fixed']") if joint.find('parent') is not None}
    children = {child.get('link') for child in robot.findall('joint/child')}
    return {'links': links, 'joints': joints, 'fixed': fixed, 'held': held, 'roots': set(links) - children}


def same(one, other):
    if one is None or other is None or INVALID in (one, other):
        return one == other
    return math.isclose(one, other, rel_tol=1e-6, abs_tol=1e-9)


def outcome(answer, said, plain, plain_said):
    """`rejects`, `changes` or `accepts`. What a reader changes in every robot does not count: `plain` is its answer to the
    robot without changes, which says `plain_said`."""
    if not answer['loaded']:
        return 'rejects'
    if said is None:
        return 'accepts'
    return 'changes' if differences(answer, said, plain, plain_said) else 'accepts'


def differences(answer, said, plain, plain_said):
    """The links and joints of which the reader made something else."""
    found = []
    usual = plain or {}
    merged = set()
    if usual.get('links'):
        # some merge links that are fixed to others, and the root with the world
        for name, links in (('tool', said['fixed'] | said['held']), ('base', said['roots'])):
            merged |= links if name not in usual['links'] else set()
    # a reader that leaves out the mass of the root does so whatever the root is called
    masses = usual.get('links') or {}
    is_root_kept = all(name not in masses or same(masses[name], plain_said['links'][name]) for name in plain_said['roots'])
    for name, mass in said['links'].items():
        links = answer.get('links')
        if links is None:
            break
        known = usual.get('links') or {}
        was_kept = not plain or name not in plain_said['links'] or name in known
        if name in merged or name in said['roots'] and name in links and not is_root_kept:
            continue
        if name not in links:
            if was_kept and not (plain is None):
                found.append('link %s is missing' % name)
            continue
        told = plain is None or same(known.get(name), plain_said['links'].get(name))
        if mass is not None and told and links[name] is not None and not same(links[name], mass):
            found.append('mass of %s' % name)
        if mass is not None and told and links[name] is None and known.get(name) is not None:
            found.append('mass of %s is missing' % name)
        if mass is None and told and name in known and links[name]:
            found.append('mass of %s from nothing' % name)
    for name, bounds in said['joints'].items():
        joints = answer.get('joints')
        if joints is None:
            break
        known = usual.get('joints') or {}
        if name not in joints:
            if name in known:
                found.append('joint %s is missing' % name)
            continue
        tells = any(value is not None for _, *pair in known.values() for value in pair)
        if tells and bounds != [None, None] and not all(map(same, joints[name][1:], bounds)):
            found.append('limits of %s' % name)
    return found
