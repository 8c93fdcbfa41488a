#!/usr/bin/env python3
"""Write the meshes of the example robots.

    make_meshes.py [--check]

Every part is a stack of convex rings joined to a closed, outward oriented
solid; a link is a handful of such parts in one binary STL. Collision meshes are
the convex hull of the same parts built with fewer corners, each circle drawn
around the round it stands for, so that the hull holds the visual mesh.
`--check` compares with the files on disk instead of writing them.
Standard library only; lengths in metres.
"""
import math
import os
import struct
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
FINE, COARSE = 28, 10


# --- parts: (vertices, triangles) -------------------------------------------

def loft(rings):
    """Closed solid through `rings` (equally long lists of points), flat ends."""
    n = len(rings[0])
    points = [p for ring in rings for p in ring]
    faces = []
    for k in range(len(rings) - 1):
        for i in range(n):
            a, b = k * n + i, k * n + (i + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    last = (len(rings) - 1) * n
    for i in range(1, n - 1):
        faces += [(0, i + 1, i), (last, last + i, last + i + 1)]
    return outward((points, faces))


def outward(part):
    """Flip all faces if the signed volume says that they look inward."""
    points, faces = part
    volume = sum(dot(points[a], cross(points[b], points[c])) for a, b, c in faces)
    return part if volume > 0 else (points, [(a, c, b) for a, b, c in faces])


def place(axis, u, v, t):
    """The point with coordinates u, v across and t along `axis`."""
    return {'x': (t, u, v), 'y': (v, t, u), 'z': (u, v, t)}[axis]


class Shapes:
    """Part makers for one level of detail."""

    def __init__(self, corners, around):
        self.n = corners
        self.grow = 1 / math.cos(math.pi / corners) if around else 1.0

    def turned(self, axis, profile, at=(0, 0, 0)):
        """Solid of revolution: `profile` lists (position along axis, radius)."""
        rings = []
        for t, r in profile:
            angles = [2 * math.pi * (i + 0.5) / self.n for i in range(self.n)]
            rings.append([add(at, place(axis, r * self.grow * math.cos(a), r * self.grow * math.sin(a), t))
                          for a in angles])
        return loft(rings)

    def drum(self, axis, start, end, radius, end_radius=None, edge=0.006, at=(0, 0, 0)):
        """Cylinder or cone frustum with chamfered edges."""
        r0, r1 = radius, radius if end_radius is None else end_radius
        return self.turned(axis, [(start, r0 - edge), (start + edge, r0), (end - edge, r1), (end, r1 - edge)], at)

    def arm(self, axis, start, end, a, ra, b, rb, edge=0.008):
        """Plate across `axis` that narrows from a round of ra at `a` to rb at `b`."""
        rings = []
        for t, inset in ((start, edge), (start + edge, 0), (end - edge, 0), (end, edge)):
            rings.append([place(axis, u, v, t) for u, v in self.taper(a, ra - inset, b, rb - inset)])
        return loft(rings)

    def taper(self, a, ra, b, rb):
        """Outline around two circles, counter-clockwise."""
        heading = math.atan2(b[1] - a[1], b[0] - a[0])
        open_ = math.acos((ra - rb) / math.dist(a, b))
        half = self.n // 2
        outline = []
        for centre, radius, first, last in ((a, ra, open_, 2 * math.pi - open_), (b, rb, -open_, open_)):
            for i in range(half + 1):
                angle = heading + first + (last - first) * i / half
                outline.append((centre[0] + radius * self.grow * math.cos(angle),
                                centre[1] + radius * self.grow * math.sin(angle)))
        return outline

    def block(self, size, at=(0, 0, 0), corner=0.02, edge=0.006):
        """Box centred at `at` with rounded vertical and chamfered level edges."""
        sx, sy, sz = size
        steps = max(1, self.n // 8)
        rings = []
        for t, inset in ((-sz / 2, edge), (-sz / 2 + edge, 0), (sz / 2 - edge, 0), (sz / 2, edge)):
            ring = []
            for quarter, (dx, dy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
                for i in range(steps + 1):
                    angle = math.pi / 2 * (quarter + i / steps)
                    r = (corner - inset) * (1.08 if self.grow > 1 else 1)
                    ring.append(add(at, (dx * (sx / 2 - corner) + r * math.cos(angle),
                                         dy * (sy / 2 - corner) + r * math.sin(angle), t)))
            rings.append(ring)
        return loft(rings)


# --- vectors -----------------------------------------------------------------

def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


# --- convex hull ---------------------------------------------------------------

def hull(parts):
    """Convex hull of the points of all `parts`.

    Flat caps make many points coplanar; the hull is therefore taken of points
    moved by a few micrometres, and drawn with the unmoved ones.
    """
    points = sorted({tuple(round(c, 6) for c in p) for part in parts for p in part[0]})
    moved = [tuple(c + 3e-6 * math.sin(12.9898 * (3 * i + k) + 78.233 * c) for k, c in enumerate(p))
             for i, p in enumerate(points)]
    faces = first_tetrahedron(moved)
    for i in range(len(moved)):
        faces = grow(faces, moved, i)
    return outward((points, faces))


def plane(points, face):
    """Normal of a face and its distance from the origin."""
    a, b, c = (points[i] for i in face)
    normal = cross(sub(b, a), sub(c, a))
    return normal, dot(normal, a)


def first_tetrahedron(points):
    """Four faces around four points far apart."""
    a = 0
    b = max(range(len(points)), key=lambda i: math.dist(points[i], points[a]))
    line = sub(points[b], points[a])
    c = max(range(len(points)), key=lambda i: math.hypot(*cross(line, sub(points[i], points[a]))))
    normal, level = plane(points, (a, b, c))
    d = max(range(len(points)), key=lambda i: abs(dot(normal, points[i]) - level))
    if dot(normal, points[d]) > level:
        b, c = c, b
    return [(a, b, c), (a, d, b), (b, d, c), (c, d, a)]


def grow(faces, points, i):
    """Replace the faces that see point `i` by a fan from it to their rim."""
    seen, kept = [], []
    for face in faces:
        normal, level = plane(points, face)
        (seen if i not in face and dot(normal, points[i]) > level else kept).append(face)
    edges = {(f[k], f[(k + 1) % 3]) for f in seen for k in range(3)}
    return kept + [(a, b, i) for a, b in edges if (b, a) not in edges]


# --- files ---------------------------------------------------------------------

def stl(parts, scale=1.0):
    """Binary STL of all `parts`."""
    out = bytearray(b'example robot mesh'.ljust(80))
    out += struct.pack('<I', sum(len(faces) for _, faces in parts))
    for points, faces in parts:
        for face in faces:
            normal, _ = plane(points, face)
            length = math.hypot(*normal) or 1.0
            out += struct.pack('<3f', *(c / length for c in normal))
            for i in face:
                out += struct.pack('<3f', *(c * scale for c in points[i]))
            out += b'\0\0'
    return bytes(out)


# --- robots --------------------------------------------------------------------

def arm_links(s, k):
    """The seven links of a six-axis arm; `k` scales the 0.9 m original."""

    def z(*values):
        return tuple(v * k for v in values)

    def drum(axis, start, end, r, r2=None, edge=0.006, at=(0, 0, 0)):
        return s.drum(axis, start * k, end * k, r * k, None if r2 is None else r2 * k, edge * k, z(*at))

    def arm(axis, start, end, a, ra, b, rb):
        return s.arm(axis, start * k, end * k, z(*a), ra * k, z(*b), rb * k, 0.008 * k)

    def block(size, at, corner):
        return s.block(z(*size), z(*at), corner * k, 0.006 * k)

    return {
        'base_link': [block((0.30, 0.28, 0.030), (-0.02, 0, 0.015), 0.04),
                      drum('z', 0.025, 0.175, 0.130, 0.112), drum('z', 0.170, 0.205, 0.118),
                      block((0.09, 0.12, 0.10), (-0.145, 0, 0.075), 0.012)],
        'link_1': [drum('z', -0.125, -0.050, 0.114, 0.100),
                   arm('y', -0.085, 0.040, (-0.06, 0.0), 0.100, (0.0, 0.075), 0.098),
                   drum('y', -0.105, 0.052, 0.086, at=(0.075, 0, 0)),
                   drum('y', -0.135, -0.100, 0.062, at=(0.075, 0, 0))],
        'link_2': [arm('y', 0.055, 0.120, (0.0, 0.0), 0.088, (0.340, 0.0), 0.072),
                   drum('y', 0.115, 0.138, 0.066), drum('y', 0.115, 0.138, 0.054, at=(0, 0, 0.340))],
        'link_3': [drum('y', -0.060, 0.053, 0.072),
                   arm('y', -0.058, 0.042, (0.0, 0.0), 0.066, (0.075, 0.0), 0.066),
                   drum('x', -0.095, 0.100, 0.064, at=(0, 0, 0.075)),
                   drum('x', -0.150, -0.090, 0.048, 0.052, at=(0, 0, 0.075))],
        'link_4': [drum('x', 0.103, 0.265, 0.060, 0.046),
                   arm('y', 0.032, 0.050, (0.0, 0.230), 0.040, (0.0, 0.335), 0.036),
                   arm('y', -0.050, -0.032, (0.0, 0.230), 0.040, (0.0, 0.335), 0.036)],
        'link_5': [drum('y', -0.031, 0.031, 0.034), drum('x', 0.0, 0.056, 0.031, 0.028)],
        'link_6': [drum('x', 0.058, 0.070, 0.026, edge=0.002), drum('x', 0.068, 0.080, 0.0315, edge=0.002)],
    }


def gripper_links(s):
    """Palm and one finger of the parallel gripper; the finger grips towards -y."""
    palm = [s.block((0.062, 0.130, 0.034), (0, 0, 0.023), 0.012, 0.004),
            s.drum('z', 0.0, 0.010, 0.031, edge=0.002)]
    finger = [s.block((0.022, 0.016, 0.024), (0, 0.010, 0.012), 0.003, 0.002),
              s.arm('x', -0.009, 0.009, (0.008, 0.016), 0.007, (0.005, 0.066), 0.005, 0.002),
              s.block((0.016, 0.006, 0.030), (0, 0.003, 0.056), 0.002, 0.001)]
    return {'palm': palm, 'finger': finger}


def probe_links(s):
    """Touch probe: body with a flange at the origin, pointing along +z."""
    return {'body': [s.drum('z', 0.0, 0.012, 0.0315, edge=0.002), s.drum('z', 0.010, 0.075, 0.024, 0.020),
                     s.drum('z', 0.073, 0.092, 0.014, 0.006, edge=0.001),
                     s.block((0.022, 0.016, 0.030), (0.026, 0, 0.040), 0.004, 0.002)]}


def targets():
    """(folder, part maker, scale of the numbers in the file)."""
    return [
        ('industrial_arm/src/lunder6_support/meshes', lambda s: arm_links(s, 1.0), 1.0),
        ('two_joint_gripper/src/two_joint_gripper_description/meshes', gripper_links, 1000.0),
        ('measuring_cell/src/fenn_support/meshes', lambda s: arm_links(s, 0.7), 1.0),
        ('measuring_cell/src/gauge_probe_support/meshes', probe_links, 1.0),
        ('broken_cell/src/broken_arm_support/meshes', lambda s: arm_links(s, 0.7), 1.0),
        ('broken_cell/src/broken_probe_support/meshes', probe_links, 1.0),
    ]


def main():
    check, stale = '--check' in sys.argv[1:], 0
    for folder, links, scale in targets():
        files = {('visual', name): parts for name, parts in links(Shapes(FINE, False)).items()}
        files.update({('collision', name): [hull(parts)] for name, parts in links(Shapes(COARSE, True)).items()})
        for (kind, name), parts in files.items():
            path = os.path.join(HERE, folder, kind, name + '.stl')
            data = stl(parts, scale)
            if check:
                stale += not os.path.exists(path) or open(path, 'rb').read() != data
                continue
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'wb') as out:
                out.write(data)
    if stale:
        print('%d meshes differ: run make_meshes.py' % stale)
    return 1 if stale else 0


if __name__ == '__main__':
    sys.exit(main())
