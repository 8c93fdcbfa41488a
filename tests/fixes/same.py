"""Whether two expanded robots are the same to a reader of URDF. Written apart from the linter's own comparison."""
import xml.etree.ElementTree as ET

NUMERIC = {'xyz', 'rpy', 'lower', 'upper', 'effort', 'velocity', 'size', 'radius', 'length', 'value', 'damping', 'friction', 'scale', 'rgba'}
TYPES = ('revolute', 'continuous', 'prismatic', 'planar', 'fixed', 'floating')
MOVING = ('revolute', 'continuous', 'prismatic', 'planar')


def numbers(text):
    try:
        return ' '.join(repr(float(word) + 0.0) for word in text.split())
    except ValueError:
        return text


def is_identity(origin):
    return set(origin.attrib) <= {'xyz', 'rpy'} and all(value == '0.0 0.0 0.0' for value in origin.attrib.values())


def reduce_joint(joint):
    kind = joint.get('type')
    for child in list(joint):
        ignored = child.tag in ('axis', 'limit', 'dynamics') if kind == 'fixed' else kind == 'floating' and child.tag == 'axis'
        if ignored or child.tag == 'dynamics' and not child.attrib:
            joint.remove(child)
    if kind in MOVING and joint.find('axis') is None:
        ET.SubElement(joint, 'axis', {'xyz': '1.0 0.0 0.0'})
    limit = joint.find('limit')
    if kind == 'continuous' and limit is not None:
        limit.attrib.pop('lower', None)
        limit.attrib.pop('upper', None)
    joint[:] = sorted(joint, key=lambda child: child.tag)


def reduce(element):
    for child in element:
        reduce(child)
    for key in element.attrib.keys() & NUMERIC:
        element.set(key, numbers(element.get(key)))
    if element.tag in ('joint', 'visual', 'collision', 'inertial'):
        for origin in [child for child in element if child.tag == 'origin' and is_identity(child)]:
            element.remove(origin)
    if element.tag == 'joint' and element.find('parent') is not None:
        reduce_joint(element)


def robot(text):
    """A robot as nested tuples; none when readers refuse it."""
    root = ET.fromstring(text)
    if any(joint.find('parent') is not None and joint.get('type') not in TYPES for joint in root.iter('joint')):
        return None
    reduce(root)

    def frozen(element):
        words = (' '.join((element.text or '').split()), ' '.join((element.tail or '').split()))
        return element.tag, tuple(sorted(element.attrib.items())), words, tuple(frozen(child) for child in element)
    return frozen(root)
