// A cube of side 1 in four formats, as little text as each needs. The STL says zero for all normals, as some tools do.
import { mkdirSync, writeFileSync } from 'node:fs';
import { crc32, deflateSync } from './png.mjs';

const corners = [[-.5, -.5, -.5], [.5, -.5, -.5], [.5, .5, -.5], [-.5, .5, -.5], [-.5, -.5, .5], [.5, -.5, .5], [.5, .5, .5], [-.5, .5, .5]];
const faces = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [2, 3, 7], [2, 7, 6], [1, 2, 6], [1, 6, 5], [0, 4, 7], [0, 7, 3]];

function stl() {
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, i) => face.forEach((corner, j) => corners[corner].forEach((value, k) => bytes.writeFloatLE(value, 84 + i * 50 + 12 + j * 12 + k * 4))));
  return bytes;
}

function obj() {
  const uvs = ['vt 0 0', 'vt 1 0', 'vt 1 1'];
  const lines = ['mtllib cube.mtl', 'o cube', ...corners.map((corner) => `v ${corner.join(' ')}`), ...uvs, 'usemtl green'];
  return [...lines, ...faces.map((face) => `f ${face.map((i, j) => `${i + 1}/${j + 1}`).join(' ')}`)].join('\n') + '\n';
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
<library_lights><light id="l"><technique_common><directional><color>9 9 9</color></directional></technique_common></light></library_lights>
<library_visual_scenes><visual_scene id="s0"><node id="lamp"><instance_light url="#l"/></node><node id="n"><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
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

/** A picture of 4 by 4 dots, green and white. */
function png() {
  const rows = [0, 1, 2, 3].map((y) => [0, ...[0, 1, 2, 3].flatMap((x) => ((x + y) % 2 ? [30, 150, 60] : [235, 245, 235]))]);
  const chunk = (kind, data) => {
    const body = Buffer.concat([Buffer.from(kind), data]);
    const ends = [Buffer.alloc(4), Buffer.alloc(4)];
    ends[0].writeUInt32BE(data.length);
    ends[1].writeUInt32BE(crc32(body));
    return Buffer.concat([ends[0], body, ends[1]]);
  };
  const size = Buffer.from([0, 0, 0, 4, 0, 0, 0, 4, 8, 2, 0, 0, 0]);
  const mark = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([mark, chunk('IHDR', size), chunk('IDAT', deflateSync(Buffer.from(rows.flat()))), chunk('IEND', Buffer.alloc(0))]);
}

export function writeCubes(folder) {
  mkdirSync(folder, { recursive: true });
  const files = { 'cube.stl': stl(), 'cube.obj': obj(), 'cube.mtl': 'newmtl green\nKd 1 1 1\nmap_Kd textures/dots.png\n', 'cube.dae': dae(), 'cube.glb': glb() };
  mkdirSync(`${folder}/textures`, { recursive: true });
  writeFileSync(`${folder}/textures/dots.png`, png());
  for (const [name, content] of Object.entries(files)) writeFileSync(`${folder}/${name}`, content);
}
