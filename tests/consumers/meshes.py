"""The cube in Collada, PLY and glTF."""
import base64
import json
import struct


def indexed(triangles):
    points = list(dict.fromkeys(point for triangle in triangles for point in triangle))
    return points, [points.index(point) for triangle in triangles for point in triangle]


def ply(triangles):
    points, order = indexed(triangles)
    lines = ['ply', 'format ascii 1.0', 'element vertex %d' % len(points), 'property float x', 'property float y',
             'property float z', 'element face %d' % len(triangles), 'property list uchar int vertex_indices', 'end_header']
    lines += ['%g %g %g' % point for point in points]
    lines += ['3 %d %d %d' % tuple(order[n:n + 3]) for n in range(0, len(order), 3)]
    return '\n'.join([*lines, '']).encode()


def dae(triangles):
    points, order = indexed(triangles)
    floats = ' '.join('%g' % value for point in points for value in point)
    return ('''<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><created>2026-01-01T00:00:00</created><modified>2026-01-01T00:00:00</modified><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g" name="g"><mesh>
    <source id="p"><float_array id="f" count="%d">%s</float_array><technique_common><accessor source="#f" count="%d" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="%d"><input semantic="VERTEX" source="#v" offset="0"/><p>%s</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
''' % (3 * len(points), floats, len(points), len(triangles), ' '.join(map(str, order)))).encode()


def document(triangles, uri):
    points, order = indexed(triangles)
    data = b''.join(struct.pack('<3f', *point) for point in points) + struct.pack('<%dH' % len(order), *order)
    low, high = [list(map(of, zip(*points))) for of in (min, max)]
    buffer = {'byteLength': len(data)}
    if uri:
        buffer['uri'] = 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()
    start = 12 * len(points)
    return {
        'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
        'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}], 'buffers': [buffer],
        'bufferViews': [{'buffer': 0, 'byteOffset': 0, 'byteLength': start},
                        {'buffer': 0, 'byteOffset': start, 'byteLength': len(data) - start}],
        'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': len(points), 'type': 'VEC3', 'min': low, 'max': high},
                      {'bufferView': 1, 'componentType': 5123, 'count': len(order), 'type': 'SCALAR'}],
    }, data


def gltf(triangles):
    return json.dumps(document(triangles, True)[0]).encode()


def glb(triangles):
    head, data = document(triangles, False)
    text = json.dumps(head).encode()
    text += b' ' * (-len(text) % 4)
    data += b'\0' * (-len(data) % 4)
    chunks = struct.pack('<I4s', len(text), b'JSON') + text + struct.pack('<I4s', len(data), b'BIN\0') + data
    return struct.pack('<4sII', b'glTF', 2, 12 + len(chunks)) + chunks
