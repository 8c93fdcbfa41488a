// Visuals and collisions: shapes, meshes, colors, and what stands in for a shape that cannot be drawn.

import * as THREE from 'three';
import type { Loaded, Meshes } from './meshes';
import type { Body, Model, Pose, Side } from './messages';
import type { Stage } from './stage';

export interface Problem {
  link: string;
  text: string;
  /** A file that is not there; otherwise something that cannot be drawn. */
  missing: boolean;
}

export class Bodies {
  /** Shapes that could not be drawn. */
  readonly problems = new Map<string, Problem>();

  constructor(
    private readonly side: Side,
    private readonly stage: Stage,
    private readonly meshes: Meshes,
    private readonly settings: { meshMaxMB: number },
  ) {}

  /** Forget what was wrong with a link. */
  forget(link: string): void {
    this.problems.forEach((problem, key) => problem.link === link && this.problems.delete(key));
  }

  /** Draw a body; a promise when its file has to come first. */
  draw(model: Model, link: string, holder: THREE.Group, body: Body, wire: boolean): void | Promise<void> {
    const { shape } = body;
    const material = (): THREE.Material => look(body, wire);
    switch (shape.kind) {
      case 'box':
        holder.add(new THREE.Mesh(new THREE.BoxGeometry(...shape.size), material()));
        break;
      case 'sphere':
        holder.add(new THREE.Mesh(new THREE.SphereGeometry(shape.radius, wire ? 16 : 40, wire ? 10 : 24), material()));
        break;
      case 'cylinder': {
        const geometry = new THREE.CylinderGeometry(shape.radius, shape.radius, shape.length, wire ? 20 : 48);
        holder.add(new THREE.Mesh(geometry.rotateX(Math.PI / 2), material()));
        break;
      }
      case 'capsule': {
        const geometry = new THREE.CapsuleGeometry(shape.radius, shape.length, wire ? 5 : 12, wire ? 20 : 48);
        holder.add(new THREE.Mesh(geometry.rotateX(Math.PI / 2), material()));
        break;
      }
      case 'mesh':
        return this.mesh(model, link, holder, body, wire);
      case 'unknown':
        this.problem(link, holder, shape.problem, shape.problem, UNDRAWN);
    }
    this.texture(holder, body, wire);
  }

  private mesh(model: Model, link: string, holder: THREE.Group, body: Body, wire: boolean): void | Promise<void> {
    const { shape } = body;
    if (shape.kind !== 'mesh') return;
    if (shape.mesh === undefined) return this.problem(link, holder, baseName(shape.uri), `${shape.uri}: ${shape.problem ?? '?'}`);
    const file = model.meshes[shape.mesh];
    if (file && file.bytes > this.settings.meshMaxMB * 1e6) return this.huge(model, link, holder, body, wire);
    return this.meshes.get(model, shape.mesh).then(
      (loaded) => this.meshes.measured(file?.name ?? shape.uri, () => this.put(loaded, shape.scale, holder, body, wire)),
      (error: unknown) => {
        const why = error instanceof Error ? error.message : String(error);
        this.problem(link, holder, `${baseName(shape.uri)}: ${why}`, `${shape.uri}: ${why}`, UNDRAWN);
      },
    );
  }

  /** Draw a mesh that was read. */
  private put({ object, colored }: Loaded, scale: [number, number, number], holder: THREE.Group, body: Body, wire: boolean): void {
    const own = object.clone(true);
    own.traverse((part) => {
      if (!(part instanceof THREE.Mesh)) return;
      if (!colored || wire) part.material = look(body, wire);
      else part.material = copied(part.material as THREE.Material | THREE.Material[]);
    });
    // the factors of the tag are along the axes of the link
    const scaled = new THREE.Group();
    scaled.scale.set(...scale);
    scaled.add(own);
    holder.add(scaled);
    if (!colored) this.texture(holder, body, wire);
  }

  /** A mesh that is too large to draw: its box. */
  private huge(model: Model, link: string, holder: THREE.Group, body: Body, wire: boolean): void {
    const { shape } = body;
    const file = shape.kind === 'mesh' && shape.mesh !== undefined ? model.meshes[shape.mesh] : undefined;
    if (shape.kind !== 'mesh' || !file) return;
    const text = `${file.name}: ${(file.bytes / 1e6).toFixed(0)} MB, shown as a box`;
    if (!file.box) return this.problem(link, holder, text, text, UNDRAWN);
    const box = new THREE.Box3(new THREE.Vector3(...file.box[0]), new THREE.Vector3(...file.box[1]));
    const size = box.getSize(new THREE.Vector3());
    const solid = new THREE.Mesh(new THREE.BoxGeometry(size.x, size.y, size.z), look(body, wire));
    box.getCenter(solid.position);
    const scaled = new THREE.Group();
    scaled.scale.set(...shape.scale);
    scaled.add(solid);
    holder.add(scaled);
    if (!wire) this.problems.set(`${link} ${text}`, { link, text, missing: false });
  }

  /** In place of what cannot be drawn: a box of 10 cm, with a label; magenta where a file is missing. */
  private problem(link: string, holder: THREE.Group, label: string, text: string, color = MISSING): void {
    const box = new THREE.Mesh(new THREE.BoxGeometry(0.1, 0.1, 0.1), new THREE.MeshStandardMaterial({ color }));
    holder.add(box);
    const missing = color === MISSING;
    this.problems.set(`${link} ${text}`, { link, text, missing });
    const remove = this.stage.label(box, label, missing ? 'missing' : 'undrawn', this.side);
    box.addEventListener('removed', remove);
    holder.addEventListener('removed', remove);
  }

  private texture(holder: THREE.Group, body: Body, wire: boolean): void {
    if (wire || body.texture === undefined) return;
    void this.meshes.texture(body.texture).then(
      (texture) => {
        holder.traverse((part) => {
          if (part instanceof THREE.Mesh && part.material instanceof THREE.MeshStandardMaterial) {
            part.material.map = texture;
            part.material.color.set(0xffffff);
            delete part.material.userData['own'];
            part.material.needsUpdate = true;
          }
        });
        this.stage.invalidate();
      },
      () => undefined,
    );
  }
}

/** Place an object by meters and fixed-axis roll, pitch, yaw. */
export function place(object: THREE.Object3D, pose: Pose): void {
  object.position.set(...pose.xyz);
  object.quaternion.setFromEuler(new THREE.Euler(pose.rpy[0], pose.rpy[1], pose.rpy[2], 'ZYX'));
}

function look(body: Body, wire: boolean): THREE.Material {
  if (wire) return new THREE.MeshBasicMaterial({ color: 0x18a0a8, wireframe: true, transparent: true, opacity: 0.55 });
  const [red, green, blue, opacity] = body.color ?? [0.72, 0.74, 0.78, 1];
  const material = new THREE.MeshStandardMaterial({ roughness: 0.65, metalness: 0.05, side: THREE.DoubleSide });
  material.color.setRGB(red, green, blue, THREE.SRGBColorSpace);
  material.opacity = opacity;
  material.transparent = opacity < 1;
  material.depthWrite = opacity >= 1;
  return material;
}

function baseName(uri: string): string {
  return uri.split('/').pop() ?? uri;
}

const MISSING = 0xff00ff;
const UNDRAWN = 0xd29922;
const MOST_WITH_EDGES = 6000;

/** The look of a collision shape that stands in for a visual that the link does not have. */
export function standIn(part: THREE.Object3D): void {
  if (!(part instanceof THREE.Mesh)) return;
  const look = { color: 0x18a0a8, transparent: true, opacity: 0.4, roughness: 0.9, depthWrite: false, side: THREE.DoubleSide };
  part.material = new THREE.MeshStandardMaterial(look);
  const geometry = part.geometry as THREE.BufferGeometry;
  // finding the edges of a large mesh takes as long as reading it
  if ((geometry.index ?? geometry.getAttribute('position')).count > MOST_WITH_EDGES) return;
  part.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 30), new THREE.LineDashedMaterial({ color: 0x0f6a70, dashSize: 0.01, gapSize: 0.008 })).computeLineDistances());
}

/** How much of a part can be seen through, over what it is by itself. */
export function fade(part: THREE.Object3D, share: number): void {
  if (!(part instanceof THREE.Mesh)) return;
  const materials = (Array.isArray(part.material) ? part.material : [part.material]) as THREE.Material[];
  for (const material of materials) {
    const own = (material.userData['opacity'] ??= material.opacity) as number;
    material.opacity = own * share;
    material.transparent = material.opacity < 1;
    material.depthWrite = material.opacity >= 1;
    material.needsUpdate = true;
  }
}

const CHOSEN = new THREE.Color(0x2f81f7);

function copied(material: THREE.Material | THREE.Material[]): THREE.Material | THREE.Material[] {
  return Array.isArray(material) ? material.map((one) => one.clone()) : material.clone();
}

/** Color a part as chosen, or as it is by itself. */
export function glow(part: THREE.Object3D, on: boolean): void {
  if (!(part instanceof THREE.Mesh)) return;
  const materials = (Array.isArray(part.material) ? part.material : [part.material]) as THREE.Material[];
  for (const material of materials) {
    if (!('color' in material && material.color instanceof THREE.Color)) continue;
    const own = (material.userData['own'] ??= material.color.clone()) as THREE.Color;
    material.color.copy(own);
    if (on) material.color.lerp(CHOSEN, 0.55);
  }
}
