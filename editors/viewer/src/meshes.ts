// Files of meshes, fetched and read once for each id. Workers read them (`mesh_worker.ts`); here they only become objects.

import * as THREE from 'three';
import type { Host } from './host';
import { build, type Parsed } from './mesh_parts';
import type { MeshFile, Model } from './messages';
import { Workers } from './workers';

export interface Loaded {
  object: THREE.Object3D;
  /** Whether the file brings colors of its own. */
  colored: boolean;
}

export class Meshes {
  private readonly loaded = new Map<string, Promise<Loaded>>();
  private readonly textures = new Map<string, Promise<THREE.Texture>>();
  private readonly workers = new Workers();
  /** Milliseconds of the page that each file took, by name: for measurements. */
  readonly script = new Map<string, number>();
  pending = 0;
  private begun = 0;
  private current = '';

  constructor(
    private readonly host: Host,
    private readonly changed: () => void,
  ) {}

  /** How far loading is: `3 of 20 files: arm.dae`. */
  get progress(): string {
    const name = this.current ? `: ${this.current}` : '';
    return `${this.begun - this.pending} of ${this.begun} files${name}`;
  }

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
    if (this.pending === 0) this.begun = 0;
    this.pending++;
    this.begun++;
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
    const parsed = await this.workers.parse({ format: file.format, bytes, ...beside }, () => {
      this.current = file.name;
      this.changed();
    });
    return this.measured(file.name, () => made(parsed));
  }

  /** Do work for a file and write down how long the page was busy with it. */
  measured<T>(name: string, work: () => T): T {
    const begin = performance.now();
    const result = work();
    this.script.set(name, (this.script.get(name) ?? 0) + performance.now() - begin);
    return result;
  }

  /** The files that a mesh names: material libraries as text, all others as they are. */
  private async beside(model: Model, file: MeshFile): Promise<Beside> {
    const found: Beside = { files: new Map(), libraries: [] };
    const fetched = Object.entries(file.files ?? {}).map(async ([name, id]) => {
      const bytes = await this.host.mesh(id).catch(() => undefined);
      if (!bytes) return;
      if (model.meshes[id]?.format === 'mtl') found.libraries.push(new TextDecoder().decode(bytes));
      else found.files.set(name.replace(/^\.\//, ''), new Blob([bytes]));
    });
    await Promise.all(fetched);
    return found;
  }
}

interface Beside {
  files: Map<string, Blob>;
  libraries: string[];
}

function made(parsed: Parsed): Loaded {
  return { object: build(parsed), colored: parsed.colored };
}

export function free(object: THREE.Object3D): void {
  if (!(object instanceof THREE.Mesh || object instanceof THREE.LineSegments || object instanceof THREE.Line)) return;
  (object.geometry as THREE.BufferGeometry).dispose();
  const materials = (Array.isArray(object.material) ? object.material : [object.material]) as THREE.Material[];
  materials.forEach((material) => material.dispose());
}
