"""A robot for each construct of the table: `robot.urdf`, changed in one place, in a package with meshes."""
import pathlib
import re
import shutil
import struct

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = '''<package format="3">
  <name>arm</name>
  <version>0.0.1</version>
  <description>The robot of the suite</description>
  <maintainer email="someone@example.com">someone</maintainer>
  <license>MIT</license>
</package>
'''
WITHOUT = 'without-'
# What an attribute holds that is wrong in one way; {} is the number or the numbers that are right.
FAULTS = {
    'text': lambda numbers: ' '.join(['abc', *numbers[1:]]),
    'tail': lambda numbers: ' '.join([numbers[0] + 'f', *numbers[1:]]),
    'empty': lambda numbers: '',
    'nan': lambda numbers: ' '.join(['nan', *numbers[1:]]),
    'inf': lambda numbers: ' '.join(['inf', *numbers[1:]]),
    'overflow': lambda numbers: ' '.join(['1e400', *numbers[1:]]),
    'subnormal': lambda numbers: ' '.join(['1e-320', *numbers[1:]]),
    'hex': lambda numbers: ' '.join(['0x1', *numbers[1:]]),
    'space-after': lambda numbers: ' '.join(numbers) + ' ',
    'tab': lambda numbers: '\t'.join(numbers) if len(numbers) > 1 else '\n%s\n' % numbers[0],
    'comma': lambda numbers: ','.join(numbers) if len(numbers) > 1 else '0,5',
    'few': lambda numbers: ' '.join(numbers[:-1]),
    'many': lambda numbers: ' '.join([*numbers, '0']),
}
# What the robot has to have before an attribute can be changed.
NEEDED = {
    'mimic': ('<axis xyz="1 0 0"/>', '<axis xyz="1 0 0"/><mimic joint="pitch" multiplier="0.5" offset="0.1"/>'),
    'safety_controller': ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><safety_controller soft_lower_limit="-0.9" '
                          'soft_upper_limit="1.4" k_position="10" k_velocity="20"/>'),
    'calibration': ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><calibration rising="0.1" falling="0.2"/>'),
    'visual/mesh': ('<visual><geometry><sphere radius="0.05"/>',
                    '<visual><geometry><mesh filename="{folder}/arm/meshes/cube.obj" scale="1 1 1"/>'),
    'collision/mesh': ('<collision><geometry><sphere radius="0.05"/>',
                       '<collision><geometry><mesh filename="{folder}/arm/meshes/cube.obj" scale="1 1 1"/>'),
}


def box(size):
    """Triangles of a box around the origin."""
    half = size / 2
    corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return [tuple(corners[n] for n in face) for a, b, c, d in faces for face in ((a, b, c), (a, c, d))]


def stl(triangles):
    """A binary STL file."""
    parts = [struct.pack('<12fH', 0, 0, 0, *[v for point in t for v in point], 0) for t in triangles]
    return b'binary'.ljust(80) + struct.pack('<I', len(triangles)) + b''.join(parts)


def ascii_stl(triangles):
    lines = ['solid box']
    for triangle in triangles:
        lines += ['facet normal 0 0 0', 'outer loop', *('vertex %g %g %g' % point for point in triangle), 'endloop', 'endfacet']
    return '\n'.join([*lines, 'endsolid box', '']).encode()


def obj(triangles):
    points = list(dict.fromkeys(point for triangle in triangles for point in triangle))
    lines = ['v %g %g %g' % point for point in points]
    lines += ['f %d %d %d' % tuple(points.index(point) + 1 for point in triangle) for triangle in triangles]
    return '\n'.join([*lines, '']).encode()


def grid(count):
    """Triangles of a closed surface with more than `count` of them: a sphere of strips."""
    import math
    rows = int(math.sqrt(count / 2)) + 2

    def at(i, j):
        a, b = math.pi * i / rows, 2 * math.pi * (j % rows) / rows
        return 0.1 * math.sin(a) * math.cos(b), 0.1 * math.sin(a) * math.sin(b), 0.1 * math.cos(a)
    quads = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(rows) for j in range(rows)]
    return [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d)) if len(set(t)) == 3]


def meshes(folder):
    """The mesh files that rows name."""
    cube = box(0.1)
    flat = [((0, 0, 0), (0.1, 0, 0), (0.1, 0.1, 0)), ((0, 0, 0), (0.1, 0.1, 0), (0, 0.1, 0))]
    import meshes as formats
    files = {
        'cube.stl': stl(cube), 'upper.STL': stl(cube), 'my cube.obj': obj(cube), 'ascii.stl': ascii_stl(cube),
        'cube.obj': obj(cube), 'other/cube.obj': obj(box(0.3)), 'cube.dae': formats.dae(cube), 'cube.ply': formats.ply(cube),
        'cube.gltf': formats.gltf(cube), 'cube.glb': formats.glb(cube), 'cube.fbx': b'Kaydara FBX Binary  \0',
        'corrupt.stl': stl(cube)[:300], 'empty.stl': stl([]), 'flat.stl': stl(flat), 'triangle.stl': stl(flat[:1]),
        'huge.stl': stl(grid(201000)),
    }
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def changed(text, old, new):
    if old not in text:
        raise ValueError('robot.urdf has no %s' % old)
    return text.replace(old, new)


def with_fault(text, attribute, fault, folder):
    """The robot with one attribute changed: `limit/upper` of the first element that has it."""
    *around, element, name = attribute.split('/')
    for key in dict.fromkeys((element, '/'.join([*around, element]))):
        if key in NEEDED:
            text = changed(text, *NEEDED[key]).replace('{folder}', str(folder))
    start = text.index('<%s' % around[0]) if around else 0
    if element == 'mass' or around and around[0] == 'inertial':
        # not of the root, which some leave out
        start = text.index('<inertial><origin')
    pattern = re.compile(r'(<%s [^>]*?)\b%s="([^"]*)"' % (element, name))
    if around and around[0] in ('visual', 'collision'):
        found = re.compile(r'<%s>(?:(?!</%s>).)*?<%s ' % (around[0], around[0], element), re.S).search(text)
        start = found.end() - len(element) - 2
    elif around and around[0] == 'joint':
        start = text.index('<joint name="mount"')
    found = pattern.search(text, start)
    value = '' if fault == 'missing' else '%s="%s"' % (name, FAULTS[fault](found.group(2).split()))
    return text[:found.start()] + found.group(1) + value + text[found.end():]


def without(text, row, folder):
    """The robot without the construct of a row, where that is not the robot itself."""
    for old, new in row['instead']:
        text = changed(text, old, new.replace('{folder}', str(folder)))
    return text


def robot(text, row, folder):
    """The robot of a row."""
    if 'text' in row:
        return row['text']
    if 'fault' in row:
        return with_fault(text, row['attributes'][0], row['fault'], folder)
    if 'repeat' in row:
        old, piece, count = row['repeat']
        pieces = ''.join(piece.replace('{n}', str(n)).replace('{p}', str(n - 1)) for n in range(count))
        return changed(text, old, pieces.replace('"l-1"', '"tool"') + old)
    for old, new in row['edit']:
        text = changed(text, old, new.replace('{folder}', str(folder)))
    return text


def make(folder, rows):
    """Write the robots of rows into a package below `folder`: {row name: path}, the unchanged one by ''; a construct that this one
    has by itself is compared with a robot of the row that has it not, by WITHOUT and the name."""
    package = folder / 'arm'
    shutil.rmtree(package, ignore_errors=True)
    (package / 'urdf').mkdir(parents=True)
    (package / 'package.xml').write_text(PACKAGE, encoding='utf-8')
    meshes(package / 'meshes')
    text = (HERE / 'robot.urdf').read_text(encoding='utf-8')
    made = {'': text, **{row['name']: robot(text, row, folder) for row in rows}}
    made |= {WITHOUT + row['name']: without(text, row, folder) for row in rows if 'instead' in row}
    for name, content in made.items():
        path = package / 'urdf' / ('%s.urdf' % (name or 'robot'))
        path.write_text(content, encoding='utf-8')
        made[name] = path
    return made
