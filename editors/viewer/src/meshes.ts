// Files of meshes, loaded once for each id. No loader may reach for a file by itself: what a mesh names is fetched
// by its id first.

import * as THREE from 'three';
import { ColladaLoader } from 'three/examples/jsm/loaders/ColladaLoader.js';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js';
import type { Host } from './host';
import type { MeshFile, Model } from './messages';

export interface Loaded {
  object: THREE.Object3D;
  /** Whether the file brings colours of its own. */
  coloured: boolean;
}

export class Meshes {
  private readonly loaded = new Map<string, Promise<Loaded>>();
  private readonly textures = new Map<string, Promise<THREE.Texture>>();
  pending = 0;

  constructor(
    private readonly host: Host,
    private readonly changed: () => void,
  ) {}

  /** The mesh of an id, to be cloned. */
  get(model: Model, id: string): Promise<Loaded> {
    return this.once(this.loaded, id, () => this.load(model, id));
  }

  texture(id: string): Promise<THREE.Texture> {
    return this.once(this.textures, id, async () => {
      const url = URL.createObjectURL(new Blob([await this.host.mesh(id)]));
      const texture = await new THREE.TextureLoader().loadAsync(url);
      URL.revokeObjectURL(url);
      texture.colorSpace = THREE.SRGBColorSpace;
      return texture;
    });
  }

  /** Forget what no model names any more. */
  keep(models: Model[]): void {
    const named = new Set(models.flatMap((model) => Object.keys(model.meshes)));
    for (const [id, loaded] of this.loaded) {
      if (named.has(id)) continue;
      this.loaded.delete(id);
      loaded.then(({ object }) => object.traverse(free), () => undefined);
    }
  }

  private once<T>(known: Map<string, Promise<T>>, id: string, make: () => Promise<T>): Promise<T> {
    const found = known.get(id);
    if (found) return found;
    this.pending++;
    const made = make().finally(() => {
      this.pending--;
      this.changed();
    });
    known.set(id, made);
    // one that failed is tried again with the next model
    made.catch(() => known.delete(id));
    return made;
  }

  private async load(model: Model, id: string): Promise<Loaded> {
    const file = model.meshes[id];
    if (!file) throw new Error('the model does not name it');
    const [bytes, beside] = await Promise.all([this.host.mesh(id), this.beside(model, file)]);
    const manager = new THREE.LoadingManager();
    manager.setURLModifier((url) => {
      const name = decodeURIComponent(url);
      if (/^(blob|data):/.test(url)) return url;
      return beside.urls.get(name) ?? beside.urls.get(name.replace(/^\.\//, '')) ?? 'data:,';
    });
    const pictures = whenLoaded(manager);
    const loaded = await parse(file, bytes, manager, beside);
    await pictures();
    dropLightsAndCameras(loaded.object);
    loaded.object.traverse(mendNormals);
    loaded.object.traverse(dropLostPictures);
    return loaded;
  }

  /** The files that a mesh names: pictures as addresses, material libraries as text. */
  private async beside(model: Model, file: MeshFile): Promise<Beside> {
    const found: Beside = { urls: new Map(), libraries: [] };
    const fetched = Object.entries(file.files ?? {}).map(async ([name, id]) => {
      const bytes = await this.host.mesh(id).catch(() => undefined);
      if (!bytes) return;
      if (model.meshes[id]?.format === 'mtl') found.libraries.push(new TextDecoder().decode(bytes));
      else found.urls.set(name, URL.createObjectURL(new Blob([bytes])));
    });
    await Promise.all(fetched);
    return found;
  }
}

interface Beside {
  urls: Map<string, string>;
  libraries: string[];
}

async function parse(file: MeshFile, bytes: ArrayBuffer, manager: THREE.LoadingManager, beside: Beside): Promise<Loaded> {
  const text = (): string => new TextDecoder().decode(bytes);
  switch (file.format) {
    case 'stl': {
      const geometry = new STLLoader(manager).parse(bytes);
      const coloured = geometry.hasAttribute('color');
      return { object: new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ vertexColors: coloured })), coloured };
    }
    case 'obj': {
      const loader = new OBJLoader(manager);
      if (beside.libraries.length > 0) {
        const materials = new MTLLoader(manager).parse(beside.libraries.join('\n'), '');
        materials.preload();
        loader.setMaterials(materials);
      }
      return { object: loader.parse(text()), coloured: beside.libraries.length > 0 };
    }
    case 'dae': {
      const collada = new ColladaLoader(manager).parse(text(), '');
      if (!collada) throw new Error('it is no Collada file');
      // axes are those of the file, as in RViz; the scale is that of its unit
      collada.scene.position.set(0, 0, 0);
      collada.scene.quaternion.identity();
      const object = new THREE.Group();
      object.add(collada.scene);
      return { object, coloured: true };
    }
    case 'glb':
    case 'gltf': {
      const gltf = await new GLTFLoader(manager).parseAsync(bytes, '');
      return { object: gltf.scene, coloured: true };
    }
    default:
      throw new Error(`meshes of the format ${file.format || '?'} cannot be shown`);
  }
}

/** What waits for the pictures that a loader has begun to load, if it did. */
function whenLoaded(manager: THREE.LoadingManager): () => Promise<void> {
  let begun = false;
  let done = (): void => undefined;
  const all = new Promise<void>((resolve) => (done = resolve));
  manager.onStart = () => (begun = true);
  manager.onLoad = () => done();
  const patience = 10_000;
  return () => (begun ? Promise.race([all, new Promise<void>((resolve) => setTimeout(resolve, patience))]) : Promise.resolve());
}

/** Programs for modelling export their lamps, which would make the whole robot white: the scene has its own. */
function dropLightsAndCameras(object: THREE.Object3D): void {
  const found: THREE.Object3D[] = [];
  object.traverse((part) => {
    if (part instanceof THREE.Light || part instanceof THREE.Camera) found.push(part);
  });
  for (const part of found) part.removeFromParent();
}

/** A picture that is missing or of an unknown format would be drawn black. */
function dropLostPictures(object: THREE.Object3D): void {
  if (!(object instanceof THREE.Mesh)) return;
  const materials = (Array.isArray(object.material) ? object.material : [object.material]) as THREE.Material[];
  for (const material of materials) {
    for (const [name, value] of Object.entries(material)) {
      if (!(value instanceof THREE.Texture)) continue;
      const image = value.image as { width?: number } | null | undefined;
      if (image?.width) continue;
      Object.assign(material, { [name]: null });
      material.needsUpdate = true;
    }
  }
}

/** Files without normals, or with zeros for them, would be drawn black. */
function mendNormals(object: THREE.Object3D): void {
  if (!(object instanceof THREE.Mesh)) return;
  const geometry = object.geometry as THREE.BufferGeometry;
  const normals = geometry.getAttribute('normal') as THREE.BufferAttribute | undefined;
  if (!normals || normals.array.every((value) => value === 0)) geometry.computeVertexNormals();
}

export function free(object: THREE.Object3D): void {
  if (!(object instanceof THREE.Mesh || object instanceof THREE.LineSegments || object instanceof THREE.Line)) return;
  (object.geometry as THREE.BufferGeometry).dispose();
  const materials = (Array.isArray(object.material) ? object.material : [object.material]) as THREE.Material[];
  materials.forEach((material) => material.dispose());
}
