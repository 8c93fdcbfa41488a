// Reads mesh files, away from the page: large ones take seconds. Answers each job with arrays that are handed over, not
// copied. No loader may reach for a file by itself: what a mesh names comes with the job.

import { DOMParser } from '@xmldom/xmldom';
import * as THREE from 'three';
import { ColladaLoader } from 'three/examples/jsm/loaders/ColladaLoader.js';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js';
import { flat } from './mesh_flat';
import type { Answer, Job } from './mesh_parts';

/** Parts of Collada files that the viewer does not draw; the loader would search them by selectors, which this parser lacks. */
const LEFT_OUT = ['library_animations', 'library_kinematics_models', 'library_kinematics_scenes', 'library_joints', 'library_lights', 'library_cameras', 'instance_kinematics_scene', 'instance_light', 'instance_camera'];

// the loader for Collada expects the parser of a page
Object.assign(self, {
  DOMParser: class {
    parseFromString(text: string): unknown {
      const document = new DOMParser({ onError: onlyFatal }).parseFromString(text, 'text/xml');
      for (const name of LEFT_OUT) {
        for (const element of Array.from(document.getElementsByTagName(name))) element.parentNode?.removeChild(element);
      }
      return document;
    }
  },
});

function onlyFatal(level: string, message: string): void {
  if (level === 'fatalError') throw new Error(message.replace(/\s+/g, ' ').trim());
}

// there are no picture elements here: pictures are decoded at the end, when it is known which are used
THREE.TextureLoader.prototype.load = function (url: string): THREE.Texture<HTMLImageElement> {
  const texture = new THREE.Texture<HTMLImageElement>();
  texture.userData['file'] = url;
  return texture;
};

self.onmessage = (event: MessageEvent<Job>): void => {
  void work(event.data).then(({ answer, handed }) => self.postMessage(answer, { transfer: handed }));
};

async function work(job: Job): Promise<{ answer: Answer; handed: Transferable[] }> {
  const urls = new Map([...job.files].map(([name, file]) => [name, URL.createObjectURL(file)]));
  try {
    const { object, colored } = await parse(job, urls);
    const { parsed, handed } = await flat(object, (name) => job.files.get(bare(name)));
    return { answer: { parsed: { ...parsed, colored } }, handed };
  } catch (error) {
    return { answer: { error: error instanceof Error ? error.message : String(error) }, handed: [] };
  } finally {
    for (const url of urls.values()) URL.revokeObjectURL(url);
  }
}

/** A name of a file as the model spells it. */
function bare(url: string): string {
  return decodeURIComponent(url).replace(/^\.\//, '');
}

interface Read {
  object: THREE.Object3D;
  colored: boolean;
}

async function parse(job: Job, urls: Map<string, string>): Promise<Read> {
  const manager = new THREE.LoadingManager();
  manager.setURLModifier((url) => (/^(blob|data):/.test(url) ? url : (urls.get(decodeURIComponent(url)) ?? urls.get(bare(url)) ?? 'data:,')));
  const pictures = whenLoaded(manager);
  const read = await (READERS[job.format] ?? unknown)(job, manager);
  await pictures();
  return read;
}

type Reader = (job: Job, manager: THREE.LoadingManager) => Read | Promise<Read>;

const READERS: Record<string, Reader> = {
  stl({ bytes }, manager) {
    const geometry = new STLLoader(manager).parse(bytes);
    const colored = geometry.hasAttribute('color');
    return { object: new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ vertexColors: colored })), colored };
  },
  obj({ bytes, libraries }, manager) {
    const loader = new OBJLoader(manager);
    if (libraries.length > 0) {
      const materials = new MTLLoader(manager).parse(libraries.join('\n'), '');
      materials.preload();
      loader.setMaterials(materials);
    }
    return { object: loader.parse(new TextDecoder().decode(bytes)), colored: libraries.length > 0 };
  },
  dae({ bytes }, manager) {
    const collada = new ColladaLoader(manager).parse(new TextDecoder().decode(bytes), '');
    if (!collada) throw new Error('it is no Collada file');
    // axes are those of the file; the scale is that of its unit
    collada.scene.position.set(0, 0, 0);
    collada.scene.quaternion.identity();
    return { object: collada.scene, colored: true };
  },
  glb: gltf,
  gltf,
};

async function gltf({ bytes }: Job, manager: THREE.LoadingManager): Promise<Read> {
  return { object: (await new GLTFLoader(manager).parseAsync(bytes, '')).scene, colored: true };
}

function unknown({ format }: Job): Read {
  throw new Error(format ? `format .${format} cannot be drawn` : 'a file without an extension cannot be drawn');
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
