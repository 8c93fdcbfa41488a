// A cube of side 1 in four formats, as little text as each needs. The STL says zero for all normals, as some tools do.
import { mkdirSync, writeFileSync } from 'node:fs';

const corners = [[-.5, -.5, -.5], [.5, -.5, -.5], [.5, .5, -.5], [-.5, .5, -.5], [-.5, -.5, .5], [.5, -.5, .5], [.5, .5, .5], [-.5, .5, .5]];
const faces = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [2, 3, 7], [2, 7, 6], [1, 2, 6], [1, 6, 5], [0, 4, 7], [0, 7, 3]];

function stl() {
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, i) => face.forEach((corner, j) => corners[corner].forEach((value, k) => bytes.writeFloatLE(value, 84 + i * 50 + 12 + j * 12 + k * 4))));
  return bytes;
}

function obj() {
  const lines = ['mtllib cube.mtl', 'o cube', ...corners.map((corner) => `v ${corner.join(' ')}`), 'usemtl green'];
  return [...lines, ...faces.map((face) => `f ${face.map((i) => i + 1).join(' ')}`)].join('\n') + '\n';
}

function dae() {
  const positions = corners.flat().join(' ');
  return `<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse><color>0.8 0.1 0.1 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="24">${positions}</float_array><technique_common><accessor source="#pa" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="${faces.length}" material="s"><input semantic="VERTEX" source="#v" offset="0"/><p>${faces.flat().join(' ')}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s0"><node id="n"><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s0"/></scene></COLLADA>
`;
}

function glb() {
  const points = Buffer.alloc(96);
  corners.flat().forEach((value, i) => points.writeFloatLE(value, i * 4));
  const indices = Buffer.alloc(72);
  faces.flat().forEach((value, i) => indices.writeUInt16LE(value, i * 2));
  const data = Buffer.concat([points, indices]);
  const json = {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [0.9, 0.8, 0.1, 1], metallicFactor: 0 } }],
    buffers: [{ byteLength: data.length }],
    bufferViews: [{ buffer: 0, byteOffset: 0, byteLength: 96 }, { buffer: 0, byteOffset: 96, byteLength: 72 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 8, type: 'VEC3', min: [-.5, -.5, -.5], max: [.5, .5, .5] },
      { bufferView: 1, componentType: 5123, count: 36, type: 'SCALAR' },
    ],
  };
  const text = Buffer.from(JSON.stringify(json).padEnd(Math.ceil(JSON.stringify(json).length / 4) * 4));
  const chunk = (kind, bytes) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(bytes.length, 0);
    head.write(kind, 4, 'latin1');
    return Buffer.concat([head, bytes]);
  };
  const body = Buffer.concat([chunk('JSON', text), chunk('BIN\0', data)]);
  const head = Buffer.alloc(12);
  head.write('glTF', 0);
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + body.length, 8);
  return Buffer.concat([head, body]);
}

export function writeCubes(folder) {
  mkdirSync(folder, { recursive: true });
  const files = { 'cube.stl': stl(), 'cube.obj': obj(), 'cube.mtl': 'newmtl green\nKd 0.1 0.7 0.2\n', 'cube.dae': dae(), 'cube.glb': glb() };
  for (const [name, content] of Object.entries(files)) writeFileSync(`${folder}/${name}`, content);
}
