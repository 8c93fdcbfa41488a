// A robot in a scene. A new model changes what differs and leaves the rest alone: links and joints are known by name.

import * as THREE from 'three';
import { Bodies, fade, glow, place, standIn } from './bodies';
import { boxLines, centerOfMass, frame, inertiaBox, jointAxis, needle } from './decor';
import { free, type Meshes } from './meshes';
import type { Body, Joint, Link, Model, Side } from './messages';
import type { Stage } from './stage';
import type { Values } from './values';

export const LAYERS = ['visual', 'collision', 'frames', 'names', 'axes', 'inertia', 'com', 'bbox', 'grid'] as const;
export type Layer = (typeof LAYERS)[number];
export type Layers = Record<Layer, boolean>;

interface LinkNode {
  link: Link;
  /** The link's frame. */
  frame: THREE.Group;
  visual: THREE.Group;
  collision: THREE.Group;
  /** Frame, name, inertia, center of mass, by layer. */
  decor: THREE.Group;
  bodies: string;
  inertial: string;
  labels: (() => void)[];
  outline?: THREE.Object3D;
}

interface JointNode {
  joint: Joint;
  /** The joint's frame at position zero; hangs in the parent link. */
  frame: THREE.Group;
  /** What moves; the child link hangs in it. */
  motion: THREE.Group;
  decor: string;
}

export class RobotView {
  readonly group = new THREE.Group();
  model: Model = { robot: '', links: [], joints: [], meshes: {} };
  readonly bodies: Bodies;
  readonly hidden = new Set<string>();
  /** How opaque links are drawn, where it is not fully. */
  readonly opacity = new Map<string, number>();
  /** Links whose meshes are still to come. */
  loading = 0;
  private readonly links = new Map<string, LinkNode>();
  private readonly joints = new Map<string, JointNode>();
  private readonly extent = new THREE.Group();
  private extentLabel: (() => void) | undefined;
  private selected = new Set<string>();
  private size = 0.1;

  constructor(
    readonly side: Side,
    private readonly stage: Stage,
    meshes: Meshes,
    private readonly values: Values,
    private readonly layers: Layers,
    private readonly settings: { meshMaxMB: number },
    private readonly changed: () => void,
  ) {
    this.bodies = new Bodies(side, stage, meshes, settings);
    this.group.name = 'robot';
    stage.addPane(side).scene.add(this.group, this.extent);
  }

  dispose(): void {
    for (const name of [...this.links.keys()]) this.dropLink(name);
    this.extentLabel?.();
    this.group.removeFromParent();
    this.extent.removeFromParent();
  }

  /** Show another revision. */
  update(model: Model): void {
    this.model = model;
    const links = new Map(model.links.map((link) => [link.name, link]));
    const joints = new Map(model.joints.map((joint) => [joint.name, joint]));
    for (const name of [...this.joints.keys()]) if (!joints.has(name)) this.dropJoint(name);
    for (const name of [...this.links.keys()]) if (!links.has(name)) this.dropLink(name);
    for (const link of links.values()) this.putLink(link);
    for (const joint of joints.values()) this.putJoint(joint);
    this.hang(model);
    this.pose();
    this.measureSize();
    this.decorate();
    this.select(this.selected);
  }

  link(name: string): THREE.Object3D | undefined {
    return this.links.get(name)?.frame;
  }

  /** The joint that holds a link. */
  jointAbove(link: string): Joint | undefined {
    const node = this.links.get(link);
    const motion = node?.frame.parent;
    for (const { joint, motion: own } of this.joints.values()) if (own === motion) return joint;
    return undefined;
  }

  /** Names from a link up to the root. */
  chain(link: string): string[] {
    const names = [link];
    for (let joint = this.jointAbove(link); joint && names.length < 500; joint = this.jointAbove(joint.parent)) {
      names.push(joint.name, joint.parent);
    }
    return names;
  }

  jointFrame(name: string): THREE.Object3D | undefined {
    return this.joints.get(name)?.frame;
  }

  /** Move all joints to where they are. */
  pose(): void {
    for (const { joint, motion } of this.joints.values()) {
      const value = this.values.get(joint.name);
      const axis = new THREE.Vector3(...joint.axis);
      motion.position.set(0, 0, 0);
      motion.quaternion.identity();
      if (axis.lengthSq() === 0) continue;
      axis.normalize();
      if (joint.type === 'prismatic') motion.position.copy(axis).multiplyScalar(value);
      else if (joint.type === 'revolute' || joint.type === 'continuous') motion.quaternion.setFromAxisAngle(axis, value);
    }
    this.group.updateMatrixWorld(true);
    this.drawExtent();
    this.stage.invalidate();
  }

  /** The box around what is shown of the robot, or of one link. */
  box(link?: string): THREE.Box3 {
    const box = new THREE.Box3();
    const nodes = link === undefined ? [...this.links.values()] : [this.links.get(link)];
    this.group.updateMatrixWorld(true);
    for (const node of nodes) {
      if (!node || (link === undefined && this.hidden.has(node.link.name))) continue;
      const bare = node.visual.children.length === 0;
      const bodies = this.layers.collision || bare ? [node.visual, node.collision] : [node.visual];
      for (const part of bodies.flatMap((body) => body.children)) {
        const own = new THREE.Box3().setFromObject(part);
        if (!own.isEmpty()) box.union(own);
      }
    }
    if (box.isEmpty()) {
      for (const node of nodes) if (node) box.expandByPoint(node.frame.getWorldPosition(new THREE.Vector3()));
      if (!box.isEmpty()) box.expandByScalar(0.1);
    }
    return box;
  }

  /** What a ray meets first: the link and the place. */
  hit(ray: THREE.Raycaster): { link: string; point: THREE.Vector3 } | undefined {
    const seen = [...this.links.values()].filter((node) => !this.hidden.has(node.link.name));
    const bodies = seen.flatMap((node) => [node.visual, node.collision]).filter((body) => body.visible);
    const met = ray.intersectObjects(bodies, true).find(({ object }) => object instanceof THREE.Mesh);
    for (let one: THREE.Object3D | null = met?.object ?? null; one && met; one = one.parent) {
      const link = one.userData['link'] as string | undefined;
      if (link !== undefined) return { link, point: met.point };
    }
    return undefined;
  }

  show(link: string, on: boolean): void {
    if (on) this.hidden.delete(link);
    else this.hidden.add(link);
    this.applyLayers();
  }

  /** Draw a link more or less opaque, 0 to 1. */
  fade(link: string, share: number): void {
    this.opacity.set(link, share);
    this.links.get(link)?.visual.traverse((part) => fade(part, share));
    this.stage.invalidate();
  }

  /** Whether a link without a visual is shown by its collision shape. */
  standsIn(link: Link): boolean {
    return link.visuals.length === 0 && link.collisions.length > 0;
  }

  /** The pose of a link in the world, or in the link it hangs on. */
  poseOf(name: string, inParent: boolean): THREE.Matrix4 | undefined {
    const node = this.links.get(name);
    if (!node) return undefined;
    this.group.updateMatrixWorld(true);
    const parent = inParent ? this.links.get(this.jointAbove(name)?.parent ?? '') : undefined;
    if (inParent && !parent) return undefined;
    const own = node.frame.matrixWorld.clone();
    return parent ? parent.frame.matrixWorld.clone().invert().multiply(own) : own;
  }

  /** The size of a link's shapes along the axes of the link. */
  extentOf(name: string): THREE.Vector3 | undefined {
    const node = this.links.get(name);
    const box = node && localBox(node);
    return box && !box.isEmpty() ? box.getSize(new THREE.Vector3()) : undefined;
  }

  /** Outline links. */
  select(names: Iterable<string>): void {
    this.selected = new Set(names);
    for (const [name, node] of this.links) {
      const on = this.selected.has(name);
      node.visual.traverse((part) => glow(part, on));
      node.outline?.removeFromParent();
      delete node.outline;
      if (!on) continue;
      const box = localBox(node);
      if (box.isEmpty()) continue;
      node.outline = boxLines(box.expandByScalar(this.size * 0.04), 0x2f81f7);
      node.frame.add(node.outline);
    }
    this.stage.invalidate();
  }

  applyLayers(): void {
    const on = this.layers;
    for (const [name, node] of this.links) {
      const shown = !this.hidden.has(name);
      node.visual.visible = on.visual && shown;
      node.collision.visible = on.collision && shown;
      for (const part of node.decor.children) part.visible = on[part.userData['layer'] as Layer] && shown;
    }
    for (const { frame: own, motion } of this.joints.values()) {
      for (const part of [...own.children, ...motion.children]) {
        if (part.userData['layer']) part.visible = on[part.userData['layer'] as Layer];
      }
    }
    this.drawExtent();
    this.stage.invalidate();
  }

  private putLink(link: Link): void {
    let node = this.links.get(link.name);
    if (!node) {
      const [own, visual, collision, decor] = [0, 1, 2, 3].map(() => new THREE.Group()) as [
        THREE.Group,
        THREE.Group,
        THREE.Group,
        THREE.Group,
      ];
      own.add(visual, collision, decor);
      node = { link, frame: own, visual, collision, decor, bodies: '', inertial: '', labels: [] };
      this.links.set(link.name, node);
    }
    node.link = link;
    // what stands where in the text changes with every line; what is drawn does not
    const drawn = (body: Body): unknown => [body.pose, body.shape, body.color, body.texture];
    const bodies = JSON.stringify([link.visuals.map(drawn), link.collisions.map(drawn), this.settings.meshMaxMB]);
    if (bodies !== node.bodies) {
      node.bodies = bodies;
      this.bodies.forget(link.name);
      this.fill(node, node.visual, this.standsIn(link) ? link.collisions : link.visuals, false);
      this.fill(node, node.collision, link.collisions, true);
    }
  }

  private fill(node: LinkNode, group: THREE.Group, bodies: Body[], wire: boolean): void {
    const old = [...group.children];
    const made = bodies.map((body) => {
      const holder = new THREE.Group();
      holder.userData['link'] = node.link.name;
      place(holder, body.pose);
      return { holder, ready: this.bodies.draw(this.model, node.link.name, holder, body, wire) };
    });
    // old meshes stay until the new ones are there, so that nothing flickers
    const loading = made.some(({ ready }) => ready instanceof Promise);
    const swap = (): void => {
      if (loading) this.loading--;
      old.forEach((part) => part.removeFromParent());
      if (!wire && this.standsIn(node.link)) group.traverse(standIn);
      const share = this.opacity.get(node.link.name);
      if (!wire && share !== undefined) group.traverse((part) => fade(part, share));
      this.select(this.selected);
      this.measureSize();
      this.applyLayers();
      this.changed();
    };
    made.forEach(({ holder }) => group.add(holder));
    if (!loading) return swap();
    this.loading++;
    void Promise.all(made.map(({ ready }) => ready)).then(swap);
  }

  private putJoint(joint: Joint): void {
    let node = this.joints.get(joint.name);
    if (!node) {
      node = { joint, frame: new THREE.Group(), motion: new THREE.Group(), decor: '' };
      node.frame.add(node.motion);
      this.joints.set(joint.name, node);
    }
    node.joint = joint;
    place(node.frame, joint.pose);
  }

  /** Hang links and joints into each other. A child of several joints hangs on the first; what would close a circle
   * hangs on the ground. */
  private hang(model: Model): void {
    const up = new Map<string, Joint>();
    for (const joint of model.joints) {
      if (this.links.has(joint.parent) && this.links.has(joint.child) && !up.has(joint.child)) up.set(joint.child, joint);
    }
    for (const [child, joint] of up) {
      const seen = new Set([child]);
      for (let at: string | undefined = joint.parent; at !== undefined; at = up.get(at)?.parent) {
        if (seen.has(at)) {
          up.delete(child);
          break;
        }
        seen.add(at);
      }
    }
    for (const [name, node] of this.links) {
      const joint = up.get(name);
      const holder = joint ? this.joints.get(joint.name)?.motion : this.group;
      if (holder && node.frame.parent !== holder) holder.add(node.frame);
    }
    for (const node of this.joints.values()) {
      const used = up.get(node.joint.child) === node.joint;
      const parent = used ? this.links.get(node.joint.parent)?.frame : undefined;
      if (!parent) node.frame.removeFromParent();
      else if (node.frame.parent !== parent) parent.add(node.frame);
    }
  }

  private measureSize(): void {
    const box = this.box();
    const sphere = box.getBoundingSphere(new THREE.Sphere());
    const size = Math.min(0.5, Math.max(0.01, sphere.radius * 0.14));
    // not with every small change of the pose
    if (Math.abs(size - this.size) > this.size * 0.25) {
      this.size = size;
      this.decorate();
    }
  }

  private decorate(): void {
    for (const [name, node] of this.links) {
      const key = JSON.stringify([node.link.inertial, this.size]);
      if (key === node.inertial) continue;
      node.inertial = key;
      node.labels.splice(0).forEach((remove) => remove());
      node.decor.traverse(free);
      node.decor.clear();
      this.add(node.decor, 'frames', frame(this.size));
      const anchor = this.add(node.decor, 'names', new THREE.Object3D());
      node.labels.push(this.stage.label(anchor, name, 'name', this.side));
      if (!node.link.inertial) continue;
      const holder = new THREE.Group();
      place(holder, node.link.inertial.pose);
      const box = inertiaBox(node.link.inertial);
      if (box) {
        const turned = this.add(node.decor, 'inertia', holder.clone());
        turned.add(box);
      }
      this.add(node.decor, 'com', holder).add(centerOfMass(this.size));
    }
    for (const node of this.joints.values()) {
      const key = JSON.stringify([node.joint.axis, node.joint.type, node.joint.limit, this.size]);
      if (key === node.decor) continue;
      node.decor = key;
      for (const part of [...node.frame.children, ...node.motion.children]) {
        if (!part.userData['layer']) continue;
        part.traverse(free);
        part.removeFromParent();
      }
      this.add(node.frame, 'axes', jointAxis(node.joint, this.size));
      this.add(node.motion, 'axes', needle(node.joint, this.size));
    }
    this.applyLayers();
  }

  private add(group: THREE.Object3D, layer: Layer, part: THREE.Object3D): THREE.Object3D {
    part.userData['layer'] = layer;
    part.visible = this.layers[layer];
    group.add(part);
    return part;
  }

  private drawExtent(): void {
    this.extent.traverse(free);
    this.extent.clear();
    this.extentLabel?.();
    this.extentLabel = undefined;
    if (!this.layers.bbox) return;
    const box = this.box();
    if (box.isEmpty()) return;
    this.extent.add(boxLines(box, 0x2fa34f));
    const corner = new THREE.Object3D();
    box.getCenter(corner.position).setZ(box.max.z);
    this.extent.add(corner);
    const size = box.getSize(new THREE.Vector3());
    const text = [size.x, size.y, size.z].map((length) => length.toFixed(3)).join(' × ');
    this.extentLabel = this.stage.label(corner, `${text} m`, 'size', this.side);
  }

  private dropLink(name: string): void {
    const node = this.links.get(name);
    if (!node) return;
    node.labels.forEach((remove) => remove());
    // links that hang on it may stay: only its own labels go
    for (const holder of [...node.visual.children, ...node.collision.children]) holder.removeFromParent();
    node.decor.traverse(free);
    node.frame.removeFromParent();
    this.links.delete(name);
    this.bodies.forget(name);
  }

  private dropJoint(name: string): void {
    const node = this.joints.get(name);
    node?.frame.removeFromParent();
    this.joints.delete(name);
  }
}

/** The box around a link's visuals in its own frame. */
function localBox(node: LinkNode): THREE.Box3 {
  node.frame.updateMatrixWorld(true);
  const inverse = node.frame.matrixWorld.clone().invert();
  const box = new THREE.Box3();
  const group = node.visual.children.length > 0 ? node.visual : node.collision;
  group.traverse((part) => {
    if (!(part instanceof THREE.Mesh)) return;
    const geometry = part.geometry as THREE.BufferGeometry;
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    if (!geometry.boundingBox) return;
    const turned = new THREE.Matrix4().multiplyMatrices(inverse, part.matrixWorld);
    box.union(geometry.boundingBox.clone().applyMatrix4(turned));
  });
  return box;
}
