// The mouse in the picture: hovering, clicking, dragging joints, measuring.

import * as THREE from 'three';
import { line } from './decor';
import { short } from './dom';
import type { Joint } from './messages';
import type { RobotView } from './robot';
import type { Pane, Stage } from './stage';
import { type Values } from './values';

export interface PointerActs {
  hover: (view: RobotView | undefined, link: string | undefined, at: { x: number; y: number }) => void;
  click: (view: RobotView, link: string, shift: boolean) => void;
  clickNothing: () => void;
  menu: (view: RobotView, link: string, at: { x: number; y: number }) => void;
  dragging: (joint: string | undefined) => void;
}

interface Drag {
  view: RobotView;
  pane: Pane;
  joint: Joint;
  /** How much the leading joint moves for the one that is held. */
  leader: string;
  factor: number;
  /** The joint's frame when the drag began. */
  pivot: THREE.Vector3;
  axis: THREE.Vector3;
  grip: THREE.Vector3;
  start: number;
  turned: number;
  last: number;
}

export class Pointer {
  private pressed: { x: number; y: number; view: RobotView; link: string; shift: boolean } | undefined;
  private drag: Drag | undefined;
  private moved = false;
  private measuring = false;
  private readonly points: THREE.Vector3[] = [];
  private readonly marks = new THREE.Group();
  private unlabel: (() => void) | undefined;

  constructor(
    private readonly stage: Stage,
    private readonly views: () => RobotView[],
    private readonly values: Values,
    private readonly act: PointerActs,
  ) {
    const { canvas } = stage;
    stage.pane('main')?.scene.add(this.marks);
    // in front of the listeners that turn the camera
    stage.element.addEventListener('pointerdown', (event) => this.down(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', () => this.release());
    canvas.addEventListener('pointerleave', () => this.act.hover(undefined, undefined, { x: 0, y: 0 }));
    canvas.addEventListener('contextmenu', (event) => {
      event.preventDefault();
      const met = this.meet(event);
      if (met && !this.moved) this.act.menu(met.view, met.link, { x: event.clientX, y: event.clientY });
    });
  }

  measure(on: boolean): void {
    this.measuring = on;
    this.stage.canvas.style.cursor = on ? 'crosshair' : '';
    this.points.length = 0;
    this.drawMeasure();
  }

  private meet(event: { clientX: number; clientY: number }): { view: RobotView; pane: Pane; link: string; point: THREE.Vector3 } | undefined {
    const cast = this.stage.ray(event);
    const view = cast && this.views().find((one) => one.side === cast.pane.side);
    const hit = view?.hit(cast!.ray);
    return hit && view && cast ? { view, pane: cast.pane, ...hit } : undefined;
  }

  private down(event: PointerEvent): void {
    this.moved = false;
    if (event.target !== this.stage.canvas || event.button !== 0 || event.ctrlKey) return;
    this.stage.canvas.focus({ preventScroll: true });
    const met = this.meet(event);
    this.pressed = undefined;
    if (!met) return;
    if (this.measuring) {
      event.stopPropagation();
      this.mark(met.point);
      return;
    }
    this.pressed = { x: event.clientX, y: event.clientY, view: met.view, link: met.link, shift: event.shiftKey };
    if (event.shiftKey || !this.grab(met)) return;
    event.stopPropagation();
    this.stage.canvas.setPointerCapture(event.pointerId);
  }

  /** Take hold of the nearest joint above a link that can move; whether there is one. */
  private grab(met: { view: RobotView; pane: Pane; link: string; point: THREE.Vector3 }): boolean {
    for (let joint = met.view.jointAbove(met.link); joint; joint = met.view.jointAbove(joint.parent)) {
      const leader = this.values.leader(joint.name);
      const frame = met.view.jointFrame(joint.name);
      if (!leader || !frame || leader.factor === 0) continue;
      const pivot = frame.getWorldPosition(new THREE.Vector3());
      const turn = frame.getWorldQuaternion(new THREE.Quaternion());
      const axis = new THREE.Vector3(...joint.axis).normalize().applyQuaternion(turn);
      if (axis.lengthSq() === 0) continue;
      this.drag = {
        view: met.view, pane: met.pane, joint, leader: leader.joint.name, factor: leader.factor,
        pivot, axis, grip: met.point.clone(), start: this.values.get(leader.joint.name), turned: 0, last: 0,
      };
      return true;
    }
    return false;
  }

  private move(event: PointerEvent): void {
    const { pressed, drag } = this;
    if (pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > 3) this.moved = true;
    else if (!pressed && event.buttons !== 0) this.moved = true;
    if (drag && this.moved) {
      this.act.hover(undefined, undefined, { x: 0, y: 0 });
      this.act.dragging(drag.joint.name);
      this.pull(drag, event);
      return;
    }
    if (event.buttons !== 0) return;
    const met = this.meet(event);
    if (!this.measuring) this.stage.canvas.style.cursor = met ? 'pointer' : '';
    this.act.hover(met?.view, met?.link, { x: event.clientX, y: event.clientY });
  }

  /** Move the joint so that the place that is held follows the mouse. */
  private pull(drag: Drag, event: PointerEvent): void {
    const cast = this.stage.ray(event, drag.pane);
    if (!cast) return;
    const { ray } = cast.ray;
    let by: number;
    if (drag.joint.type === 'prismatic') {
      const along = (near: THREE.Ray): number => nearestOnLine(near, drag.grip, drag.axis);
      by = along(ray);
    } else {
      const angle = this.angle(drag, ray);
      if (angle === undefined) return;
      // over half a turn: the way that is shorter
      const step = Math.atan2(Math.sin(angle - drag.last), Math.cos(angle - drag.last));
      drag.last = angle;
      drag.turned += step;
      by = drag.turned;
    }
    this.values.set(drag.leader, drag.start + by / drag.factor);
  }

  /** The angle about the axis from the grip to the mouse. */
  private angle(drag: Drag, ray: THREE.Ray): number | undefined {
    const { axis, pivot, grip } = drag;
    const from = grip.clone().sub(pivot);
    from.addScaledVector(axis, -from.dot(axis));
    if (Math.abs(ray.direction.dot(axis)) > 0.2 && from.lengthSq() > 1e-10) {
      const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(axis, grip);
      const met = ray.intersectPlane(plane, new THREE.Vector3());
      if (!met) return undefined;
      const to = met.sub(pivot);
      to.addScaledVector(axis, -to.dot(axis));
      return Math.atan2(axis.dot(from.clone().cross(to)), from.dot(to));
    }
    // the axis lies in the picture: what counts is the way across it
    const across = axis.clone().cross(ray.direction).normalize();
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(ray.direction, grip);
    const met = ray.intersectPlane(plane, new THREE.Vector3());
    if (!met) return undefined;
    const reach = Math.max(from.length(), 0.02);
    const sign = Math.sign(axis.clone().cross(from).dot(across)) || 1;
    return (sign * met.sub(grip).dot(across)) / reach;
  }

  private up(event: PointerEvent): void {
    const { pressed } = this;
    const still = !this.moved;
    this.release();
    if (event.button !== 0 || this.measuring) return;
    if (pressed && still) this.act.click(pressed.view, pressed.link, pressed.shift);
    else if (!pressed && still) this.act.clickNothing();
  }

  private release(): void {
    if (this.drag) this.act.dragging(undefined);
    this.drag = undefined;
    this.pressed = undefined;
  }

  private mark(point: THREE.Vector3): void {
    if (this.points.length >= 3) this.points.length = 0;
    this.points.push(point.clone());
    this.drawMeasure();
  }

  private drawMeasure(): void {
    this.marks.clear();
    this.unlabel?.();
    this.unlabel = undefined;
    const size = this.stage.camera.position.distanceTo(this.stage.orbit.target) * 0.006;
    const color = 0x2f81f7;
    for (const point of this.points) {
      const dot = new THREE.Mesh(new THREE.SphereGeometry(size), new THREE.MeshBasicMaterial({ color: color, depthTest: false }));
      dot.position.copy(point);
      dot.renderOrder = 9;
      this.marks.add(dot);
    }
    const [a, b, c] = this.points;
    if (a && b && c) this.drawAngle(a, b, c, color);
    else if (a && b) {
      const between = line([a, b], color);
      (between.material as THREE.LineBasicMaterial).depthTest = false;
      between.renderOrder = 9;
      const middle = new THREE.Object3D();
      middle.position.copy(a).lerp(b, 0.5);
      this.marks.add(between, middle);
      const delta = b.clone().sub(a);
      const parts = [delta.x, delta.y, delta.z].map((part) => short(part, 4)).join(', ');
      this.unlabel = this.stage.label(middle, `${short(delta.length(), 4)} m (${parts})`, 'measure');
    }
    this.stage.invalidate();
  }

  private drawAngle(a: THREE.Vector3, b: THREE.Vector3, c: THREE.Vector3, color: number): void {
    const legs = line([a, b, c], color);
    (legs.material as THREE.LineBasicMaterial).depthTest = false;
    legs.renderOrder = 9;
    const corner = new THREE.Object3D();
    corner.position.copy(b);
    this.marks.add(legs, corner);
    const lengths = [a.distanceTo(b), b.distanceTo(c)].map((length) => `${short(length, 4)} m`).join(', ');
    this.unlabel = this.stage.label(corner, `${short(angleAt(a, b, c), 2)}° (${lengths})`, 'measure');
  }
}

/** The angle at the middle one of three points, in degrees. */
function angleAt(a: THREE.Vector3, b: THREE.Vector3, c: THREE.Vector3): number {
  return THREE.MathUtils.radToDeg(a.clone().sub(b).angleTo(c.clone().sub(b)));
}

/** How far along a line from `origin` its point nearest to a ray lies. */
function nearestOnLine(ray: THREE.Ray, origin: THREE.Vector3, axis: THREE.Vector3): number {
  const between = origin.clone().sub(ray.origin);
  const cos = axis.dot(ray.direction);
  const across = 1 - cos * cos;
  if (across < 1e-4) return 0;
  return (cos * ray.direction.dot(between) - axis.dot(between)) / across;
}
