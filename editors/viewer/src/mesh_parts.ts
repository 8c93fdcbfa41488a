// What the worker hands over of a mesh file, and what is made of it: only arrays are passed on, so the page does no work
// that grows with the file.

import * as THREE from 'three';

export interface Job {
  format: string;
  bytes: ArrayBuffer;
  /** Texts of material libraries. */
  libraries: string[];
  /** Files that the mesh names, by the name it gives them. */
  files: Map<string, Blob>;
}

export interface Attribute {
  array: THREE.TypedArray;
  size: number;
  normalized: boolean;
}

export interface Shape {
  attributes: Record<string, Attribute>;
  index: THREE.TypedArray | undefined;
  groups: { start: number; count: number; materialIndex?: number }[];
  box: [number[], number[]];
  sphere: [number[], number];
}

export interface Picture {
  /** Decoded, in the order of rows that the graphics card wants. */
  image: ImageBitmap | { data: Uint8Array; width: number; height: number };
  wrap: [number, number];
  filters: [number, number];
  repeat: [number, number];
  offset: [number, number];
  rotation: number;
  channel: number;
  colorSpace: string;
}

export interface Look {
  /** As `Material.toJSON` writes it, without pictures. */
  material: unknown;
  /** Indices of pictures, by the property of the material. */
  maps: Record<string, number>;
}

/** A mesh in place. */
export interface Piece {
  shape: number;
  looks: number[];
  matrix: number[];
}

export interface Parsed {
  shapes: Shape[];
  pictures: Picture[];
  looks: Look[];
  pieces: Piece[];
  /** Whether the file brings colors of its own. */
  colored: boolean;
}

export type Answer = { parsed: Parsed } | { error: string };

/** The objects of a mesh. */
export function build(parsed: Parsed): THREE.Group {
  const shapes = parsed.shapes.map(geometry);
  const pictures = parsed.pictures.map(texture);
  const looks = parsed.looks.map((look) => material(look, pictures));
  const group = new THREE.Group();
  for (const piece of parsed.pieces) {
    const own = piece.looks.flatMap((index) => looks[index] ?? []);
    const mesh = new THREE.Mesh(shapes[piece.shape], own.length === 1 ? own[0] : own);
    mesh.matrixAutoUpdate = false;
    mesh.matrix.fromArray(piece.matrix);
    group.add(mesh);
  }
  return group;
}

function geometry(shape: Shape): THREE.BufferGeometry {
  const made = new THREE.BufferGeometry();
  for (const [name, { array, size, normalized }] of Object.entries(shape.attributes)) {
    made.setAttribute(name, new THREE.BufferAttribute(array, size, normalized));
  }
  if (shape.index) made.setIndex(new THREE.BufferAttribute(shape.index, 1));
  for (const { start, count, materialIndex } of shape.groups) made.addGroup(start, count, materialIndex);
  made.boundingBox = new THREE.Box3(new THREE.Vector3().fromArray(shape.box[0]), new THREE.Vector3().fromArray(shape.box[1]));
  made.boundingSphere = new THREE.Sphere(new THREE.Vector3().fromArray(shape.sphere[0]), shape.sphere[1]);
  return made;
}

function texture(picture: Picture): THREE.Texture {
  const { image } = picture;
  const made = 'data' in image ? new THREE.DataTexture(image.data, image.width, image.height) : new THREE.Texture(image);
  made.flipY = false;
  [made.wrapS, made.wrapT] = picture.wrap as [THREE.Wrapping, THREE.Wrapping];
  made.magFilter = picture.filters[0] as THREE.MagnificationTextureFilter;
  made.minFilter = picture.filters[1] as THREE.MinificationTextureFilter;
  made.repeat.fromArray(picture.repeat);
  made.offset.fromArray(picture.offset);
  made.rotation = picture.rotation;
  made.channel = picture.channel;
  made.colorSpace = picture.colorSpace as THREE.ColorSpace;
  made.generateMipmaps = true;
  made.needsUpdate = true;
  return made;
}

function material(look: Look, pictures: THREE.Texture[]): THREE.Material {
  const made = new THREE.MaterialLoader().parse(look.material);
  for (const [name, index] of Object.entries(look.maps)) Object.assign(made, { [name]: pictures[index] });
  return made;
}
