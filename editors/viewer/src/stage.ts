// The picture: one camera, one or two scenes side by side, drawn again only when something changed.

import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Side } from './messages';
import { themeColor } from './style';

THREE.Object3D.DEFAULT_UP.set(0, 0, 1);

/** A scene and its part of the canvas: from `left` to `right`, 0 to 1. */
export interface Pane {
  side: Side;
  scene: THREE.Scene;
  left: number;
  right: number;
}

interface Label {
  element: HTMLElement;
  object: THREE.Object3D;
  side: Side;
}

/** The angle of view, in degrees. */
const PERSPECTIVE = 40;
const PARALLEL = 0.5;

export class Stage {
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly camera = new THREE.PerspectiveCamera(PERSPECTIVE, 1, 0.001, 1000);
  readonly orbit: OrbitControls;
  readonly panes: Pane[] = [];
  /** Called in front of each picture. */
  before: ((now: number) => boolean)[] = [];
  /** Called when the picture has another size. */
  resized: () => void = () => undefined;
  maxFps = 60;
  pictures = 0;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly labelLayer = document.createElement('div');
  private readonly titles = document.createElement('div');
  private readonly labels = new Set<Label>();
  private dirty = true;
  private last = 0;
  private gridShown = true;

  constructor() {
    this.element = document.createElement('div');
    this.element.className = 'view';
    this.canvas = document.createElement('canvas');
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('aria-label', 'robot; drag to turn, drag a link to move its joint');
    this.labelLayer.className = 'labels';
    this.titles.className = 'titles';
    this.element.append(this.canvas, this.titles, this.labelLayer);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.autoClear = false;
    // bright colors keep their shades, and what is darker stays as the file says it
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.camera.position.set(1.8, -1.6, 1.3);
    this.orbit = new OrbitControls(this.camera, this.canvas);
    this.orbit.target.set(0, 0, 0.3);
    this.orbit.zoomToCursor = true;
    this.orbit.addEventListener('change', () => this.invalidate());
    this.orbit.update();
    this.addPane('main');
    new ResizeObserver(() => {
      this.resized();
      this.invalidate();
    }).observe(this.element);
    requestAnimationFrame((now) => this.tick(now));
  }

  get parallel(): boolean {
    return this.camera.fov < PERSPECTIVE;
  }

  /** Look from very far away, which is as good as a parallel projection, and keep the size of things at the center. */
  set parallel(on: boolean) {
    const old = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    this.camera.fov = on ? PARALLEL : PERSPECTIVE;
    const share = old / Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    this.camera.position.sub(this.orbit.target).multiplyScalar(share).add(this.orbit.target);
    this.orbit.update();
    this.invalidate();
  }

  /** Have the picture drawn again. */
  invalidate(): void {
    this.dirty = true;
  }

  pane(side: Side): Pane | undefined {
    return this.panes.find((pane) => pane.side === side);
  }

  /** A scene beside the others. */
  addPane(side: Side): Pane {
    const known = this.pane(side);
    if (known) return known;
    const scene = new THREE.Scene();
    // together they leave white surfaces just below the brightest white, so that their shape can be seen
    scene.add(new THREE.HemisphereLight(0xffffff, 0x9099a8, 1.5));
    const sun = new THREE.DirectionalLight(0xffffff, 1.5);
    sun.position.set(2, -3, 5);
    const fill = new THREE.DirectionalLight(0xffffff, 0.5);
    fill.position.set(-4, 3, 1);
    scene.add(sun, fill);
    const pane: Pane = { side, scene, left: 0, right: 1 };
    this.panes.push(pane);
    this.layout();
    this.recolor();
    return pane;
  }

  removePane(side: Side): void {
    const at = this.panes.findIndex((pane) => pane.side === side);
    if (at >= 0) this.panes.splice(at, 1);
    this.layout();
  }

  /** Write a title over each pane; none: no titles, and no line between the panes. */
  title(texts: Map<Side, string>): void {
    const titles = this.panes.flatMap((pane) => {
      const title = document.createElement('b');
      title.className = 'title';
      title.textContent = texts.get(pane.side) ?? '';
      title.style.left = `${pane.left * 100}%`;
      title.style.width = `${(pane.right - pane.left) * 100}%`;
      return texts.has(pane.side) ? [title] : [];
    });
    this.titles.replaceChildren(...titles);
  }

  private layout(): void {
    this.panes.forEach((pane, i) => {
      pane.left = i / this.panes.length;
      pane.right = (i + 1) / this.panes.length;
    });
    this.invalidate();
  }

  get grid(): boolean {
    return this.gridShown;
  }

  set grid(on: boolean) {
    this.gridShown = on;
    this.recolor();
  }

  /** Take the colors of the theme over, and make the grid again. */
  recolor(): void {
    for (const { scene } of this.panes) {
      scene.background = new THREE.Color(themeColor('--bg'));
      scene.children.filter((child) => child.name === 'grid').forEach((child) => child.removeFromParent());
      if (!this.gridShown) continue;
      const grid = new THREE.GridHelper(10, 100, themeColor('--grid-strong'), themeColor('--grid'));
      grid.rotation.x = Math.PI / 2;
      const coarse = new THREE.GridHelper(10, 10, themeColor('--grid-strong'), themeColor('--grid-strong'));
      coarse.rotation.x = Math.PI / 2;
      const all = new THREE.Group();
      all.name = 'grid';
      all.add(grid, coarse);
      all.traverse((part) => {
        if (part instanceof THREE.LineSegments) {
          part.material.transparent = true;
          part.material.opacity = part === coarse ? 0.7 : 0.45;
          part.material.depthWrite = false;
        }
      });
      scene.add(all);
    }
    this.invalidate();
  }

  /** A text that stays at an object. */
  label(object: THREE.Object3D, text: string, kind: string, side: Side = 'main'): () => void {
    const element = document.createElement('span');
    element.className = kind;
    element.textContent = text;
    this.labelLayer.append(element);
    const label = { element, object, side };
    this.labels.add(label);
    this.invalidate();
    return () => {
      element.remove();
      this.labels.delete(label);
    };
  }

  /** Put the camera so that a box fills the picture, from where it looks now or from `direction`. */
  fit(box: THREE.Box3, direction?: THREE.Vector3): void {
    if (box.isEmpty()) return;
    const center = box.getCenter(new THREE.Vector3());
    const from = direction?.clone() ?? this.camera.position.clone().sub(this.orbit.target);
    if (from.lengthSq() === 0) from.set(1, -1, 0.7);
    from.normalize();
    const right = new THREE.Vector3().crossVectors(this.camera.up, from).normalize();
    const up = new THREE.Vector3().crossVectors(from, right);
    const high = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    const wide = (high * this.element.clientWidth) / this.panes.length / Math.max(1, this.element.clientHeight);
    // each corner has to lie inside of the picture, from the distance it has itself
    let distance = 0.05;
    for (const x of [box.min.x, box.max.x]) {
      for (const y of [box.min.y, box.max.y]) {
        for (const z of [box.min.z, box.max.z]) {
          const corner = new THREE.Vector3(x, y, z).sub(center);
          const across = Math.max(Math.abs(corner.dot(right)) / Math.max(wide, 0.05), Math.abs(corner.dot(up)) / high);
          distance = Math.max(distance, corner.dot(from) + across * 1.15);
        }
      }
    }
    this.orbit.target.copy(center);
    this.camera.position.copy(center).addScaledVector(from, distance);
    this.orbit.update();
    this.invalidate();
  }

  /** The pane under a point of the page and the ray through it. */
  ray(event: { clientX: number; clientY: number }, held?: Pane): { pane: Pane; ray: THREE.Raycaster } | undefined {
    const box = this.canvas.getBoundingClientRect();
    const x = (event.clientX - box.left) / box.width;
    const y = (event.clientY - box.top) / box.height;
    const pane = held ?? this.panes.find((one) => one.left <= x && x < one.right);
    if (!pane) return undefined;
    const at = new THREE.Vector2(((x - pane.left) / (pane.right - pane.left)) * 2 - 1, 1 - y * 2);
    const ray = new THREE.Raycaster();
    ray.params.Line.threshold = 0;
    ray.setFromCamera(at, this.camera);
    return { pane, ray };
  }

  private tick(now: number): void {
    requestAnimationFrame((next) => this.tick(next));
    if (now - this.last < 1000 / this.maxFps - 2) return;
    for (const work of this.before) if (work(now)) this.dirty = true;
    if (!this.dirty) return;
    this.dirty = false;
    this.last = now;
    this.draw();
  }

  /** Near and far planes: around what is looked at. */
  private clip(): void {
    const distance = this.camera.position.distanceTo(this.orbit.target);
    this.camera.near = this.parallel ? distance * 0.5 : distance / 200;
    this.camera.far = this.parallel ? distance * 2 : distance * 60;
  }

  draw(): void {
    this.clip();
    const width = Math.max(1, this.element.clientWidth);
    const height = Math.max(1, this.element.clientHeight);
    const size = this.renderer.getSize(new THREE.Vector2());
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    this.renderer.setScissorTest(true);
    for (const pane of this.panes) {
      const left = Math.round(pane.left * width);
      const wide = Math.max(1, Math.round(pane.right * width) - left);
      this.camera.aspect = wide / height;
      this.camera.updateProjectionMatrix();
      this.renderer.setViewport(left, 0, wide, height);
      this.renderer.setScissor(left, 0, wide, height);
      this.renderer.clear();
      this.renderer.render(pane.scene, this.camera);
      this.place(pane, left, wide, height);
    }
    this.pictures++;
  }

  private place(pane: Pane, left: number, wide: number, height: number): void {
    const at = new THREE.Vector3();
    for (const label of this.labels) {
      if (label.side !== pane.side) continue;
      label.object.getWorldPosition(at).project(this.camera);
      const seen = at.z < 1 && Math.abs(at.x) <= 1 && Math.abs(at.y) <= 1 && shown(label.object);
      label.element.hidden = !seen;
      if (!seen) continue;
      const x = left + ((at.x + 1) / 2) * wide;
      const y = ((1 - at.y) / 2) * height;
      label.element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(6px, -50%)`;
    }
  }
}

function shown(object: THREE.Object3D | null): boolean {
  for (let one = object; one; one = one.parent) if (!one.visible) return false;
  return true;
}
