// Flattens what a loader made into arrays: meshes with their place, each geometry, picture and material once. Lights and
// cameras stay behind: programs for modeling export their lamps, which would make the whole robot white.

import * as THREE from 'three';
import type { Look, Parsed, Picture, Piece, Shape } from './mesh_parts';

const KEPT = ['position', 'normal', 'color', 'uv', 'uv1'];

export interface Flat {
  parsed: Omit<Parsed, 'colored'>;
  /** Buffers that change hands. */
  handed: Transferable[];
}

/** `find` gives the file that a name in the mesh means. */
export async function flat(object: THREE.Object3D, find: (name: string) => Blob | undefined): Promise<Flat> {
  object.updateMatrixWorld(true);
  const geometries: THREE.BufferGeometry[] = [];
  const materials: THREE.Material[] = [];
  const pieces: Piece[] = [];
  object.traverse((part) => {
    if (!(part instanceof THREE.Mesh)) return;
    const geometry = part.geometry as THREE.BufferGeometry;
    if (!geometry.hasAttribute('position')) return;
    const own = (Array.isArray(part.material) ? part.material : [part.material]) as THREE.Material[];
    pieces.push({ shape: put(geometries, geometry), looks: own.map((one) => put(materials, one)), matrix: part.matrixWorld.toArray() });
  });
  const handed = new Set<Transferable>();
  const shapes = geometries.map((geometry) => shapeOf(geometry, handed));
  const textures: THREE.Texture[] = [];
  const found = materials.map((material) => lookOf(material, textures));
  const pictures = await Promise.all(textures.map((texture) => pictureOf(texture, find)));
  // a picture that is missing or of an unknown format would be drawn black
  const kept = pictures.filter((picture) => picture !== undefined);
  const looks = found.map(({ material, maps }) => {
    const known = Object.entries(maps).flatMap(([name, index]) => {
      const picture = pictures[index];
      return picture ? [[name, kept.indexOf(picture)] as const] : [];
    });
    return { material, maps: Object.fromEntries(known) };
  });
  for (const { image } of kept) handed.add('data' in image ? image.data.buffer : image);
  return { parsed: { shapes, pictures: kept, looks, pieces }, handed: [...handed] };
}

function put<T>(list: T[], one: T): number {
  const known = list.indexOf(one);
  return known >= 0 ? known : list.push(one) - 1;
}

function shapeOf(geometry: THREE.BufferGeometry, handed: Set<Transferable>): Shape {
  repairNormals(geometry);
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
  const attributes: Shape['attributes'] = {};
  for (const name of KEPT) {
    const given = geometry.getAttribute(name) as THREE.BufferAttribute | THREE.InterleavedBufferAttribute | undefined;
    if (!given) continue;
    const { array, itemSize, normalized } = 'isInterleavedBufferAttribute' in given ? given.clone() as unknown as THREE.BufferAttribute : given;
    attributes[name] = { array: whole(array, handed), size: itemSize, normalized };
  }
  const index = geometry.index ? whole(geometry.index.array, handed) : undefined;
  const box = geometry.boundingBox ?? new THREE.Box3();
  const sphere = geometry.boundingSphere ?? new THREE.Sphere();
  const groups = geometry.groups.map(({ start, count, materialIndex }) => ({ start, count, ...(materialIndex === undefined ? {} : { materialIndex }) }));
  return { attributes, index, groups, box: [box.min.toArray(), box.max.toArray()], sphere: [sphere.center.toArray(), sphere.radius] };
}

/** An array that owns its buffer: a view of a larger one, or one that was handed over already, is copied. */
function whole(array: THREE.TypedArray, handed: Set<Transferable>): THREE.TypedArray {
  const shared = array.byteLength !== array.buffer.byteLength || handed.has(array.buffer as ArrayBuffer);
  const own = shared ? array.slice() : array;
  handed.add(own.buffer as ArrayBuffer);
  return own;
}

/** Files without normals, or with zeros for them, would be drawn black. */
function repairNormals(geometry: THREE.BufferGeometry): void {
  const normals = geometry.getAttribute('normal') as THREE.BufferAttribute | undefined;
  if (!normals || normals.array.every((value) => value === 0)) geometry.computeVertexNormals();
}

function lookOf(material: THREE.Material, textures: THREE.Texture[]): Look {
  const maps: Look['maps'] = {};
  const own = material.clone();
  for (const [name, value] of Object.entries(own)) {
    if (!(value instanceof THREE.Texture)) continue;
    maps[name] = put(textures, value);
    Object.assign(own, { [name]: null });
  }
  return { material: own.toJSON(), maps };
}

async function pictureOf(texture: THREE.Texture, find: (name: string) => Blob | undefined): Promise<Picture | undefined> {
  const image = await imageOf(texture, find).catch(() => undefined);
  return image && {
    image,
    wrap: [texture.wrapS, texture.wrapT],
    filters: [texture.magFilter, texture.minFilter],
    repeat: texture.repeat.toArray(),
    offset: texture.offset.toArray(),
    rotation: texture.rotation,
    channel: texture.channel,
    colorSpace: texture.colorSpace,
  };
}

/** The picture itself, turned over where the texture asks for it: the page does not turn bitmaps. */
async function imageOf(texture: THREE.Texture, find: (name: string) => Blob | undefined): Promise<Picture['image'] | undefined> {
  const given = texture.image as unknown;
  if (given instanceof ImageBitmap) return given;
  const name = texture.userData['file'] as string | undefined;
  const file = name === undefined ? undefined : find(name);
  if (file) {
    const imageOrientation = texture.flipY ? 'flipY' : 'from-image';
    return createImageBitmap(file, { imageOrientation, premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
  }
  const raw = given as { data?: unknown; width?: number; height?: number } | null | undefined;
  if (!(raw?.data instanceof Uint8Array) || !raw.width || !raw.height) return undefined;
  return { data: texture.flipY ? turned(raw.data, raw.width * 4) : raw.data.slice(), width: raw.width, height: raw.height };
}

/** Rows from bottom to top. */
function turned(data: Uint8Array, row: number): Uint8Array {
  const made = new Uint8Array(data.length);
  for (let at = 0; at < data.length; at += row) made.set(data.subarray(at, at + row), data.length - at - row);
  return made;
}
