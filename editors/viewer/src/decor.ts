// What is drawn beside the robot itself: frames, axes with their limits, inertia, centers of mass, boxes.

import * as THREE from 'three';
import type { Inertial, Joint } from './messages';
import { bounds, moves } from './values';

const AXIS_COLOR = 0xe0a000;

/** A frame: x red, y green, z blue. */
export function frame(size: number): THREE.Object3D {
  const axes = new THREE.AxesHelper(size);
  const material = axes.material as THREE.LineBasicMaterial;
  material.depthTest = false;
  axes.renderOrder = 5;
  return axes;
}

/** The axis of a joint with the way its limits leave; lies in the joint's frame at position zero. */
export function jointAxis(joint: Joint, size: number): THREE.Object3D {
  const group = new THREE.Group();
  const axis = new THREE.Vector3(...joint.axis);
  if (!moves(joint) || axis.lengthSq() === 0) return group;
  axis.normalize();
  const arrow = new THREE.ArrowHelper(axis, new THREE.Vector3(), size * 1.4, AXIS_COLOR, size * 0.3, size * 0.15);
  group.add(arrow);
  const { min, max, endless } = bounds(joint);
  if (joint.type === 'prismatic') {
    group.add(line([axis.clone().multiplyScalar(min), axis.clone().multiplyScalar(max)], AXIS_COLOR));
    for (const end of [min, max]) {
      const tick = new THREE.Mesh(new THREE.SphereGeometry(size * 0.06), new THREE.MeshBasicMaterial({ color: AXIS_COLOR }));
      tick.position.copy(axis).multiplyScalar(end);
      group.add(tick);
    }
    return onTop(group);
  }
  const from = endless ? -Math.PI : min;
  const to = endless ? Math.PI : max;
  const start = reference(axis);
  const angles = Array.from({ length: 65 }, (_, i) => from + ((to - from) * i) / 64);
  const arc = angles.map((angle) => start.clone().applyAxisAngle(axis, angle).multiplyScalar(size));
  const closed = Math.abs(to - from) >= 2 * Math.PI - 1e-6;
  group.add(line(closed ? arc : [new THREE.Vector3(), ...arc, new THREE.Vector3()], AXIS_COLOR));
  group.add(sector(arc));
  return onTop(group);
}

/** Where a joint is now, for the arc of its axis; turns with the joint. */
export function needle(joint: Joint, size: number): THREE.Object3D {
  const axis = new THREE.Vector3(...joint.axis);
  if (!moves(joint) || joint.type === 'prismatic' || axis.lengthSq() === 0) return new THREE.Group();
  return onTop(line([new THREE.Vector3(), reference(axis.normalize()).multiplyScalar(size * 1.05)], 0xff5050));
}

/** The box of uniform density that has this inertia, at its center of mass. */
export function inertiaBox(inertial: Inertial): THREE.Object3D | undefined {
  if (!inertial.inertia || inertial.mass <= 0) return undefined;
  const { values, axes } = principal(inertial.inertia);
  const total = values[0] + values[1] + values[2];
  const side = (own: number): number => Math.sqrt(Math.max(0, (6 * (total - 2 * own)) / inertial.mass));
  const size = values.map((own) => Math.max(1e-4, side(own))) as [number, number, number];
  if (size.some((length) => !Number.isFinite(length))) return undefined;
  const geometry = new THREE.BoxGeometry(...size);
  const box = new THREE.Mesh(
    geometry,
    new THREE.MeshBasicMaterial({ color: 0x7a4fd0, transparent: true, opacity: 0.25, depthWrite: false }),
  );
  const edges = new THREE.LineSegments(new THREE.EdgesGeometry(geometry), new THREE.LineBasicMaterial({ color: 0x7a4fd0 }));
  const group = new THREE.Group();
  group.add(box, edges);
  group.quaternion.setFromRotationMatrix(axes);
  return onTop(group);
}

/** The mark of a center of mass. */
export function centerOfMass(size: number): THREE.Object3D {
  const ball = new THREE.Mesh(new THREE.SphereGeometry(size * 0.18, 16, 12), new THREE.MeshBasicMaterial({ color: 0x7a4fd0 }));
  const ring = new THREE.Mesh(
    new THREE.SphereGeometry(size * 0.1, 16, 12),
    new THREE.MeshBasicMaterial({ color: 0xffd84d }),
  );
  const group = new THREE.Group();
  ball.renderOrder = 6;
  ring.renderOrder = 7;
  group.add(ball, ring);
  return onTop(group);
}

/** The edges of a box along the axes. */
export function boxLines(box: THREE.Box3, color: THREE.ColorRepresentation): THREE.LineSegments {
  const size = box.getSize(new THREE.Vector3());
  const geometry = new THREE.EdgesGeometry(new THREE.BoxGeometry(size.x, size.y, size.z));
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: color }));
  box.getCenter(lines.position);
  return lines;
}

export function line(points: THREE.Vector3[], color: THREE.ColorRepresentation): THREE.Line {
  const geometry = new THREE.BufferGeometry().setFromPoints(points);
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({ color: color }));
}

function sector(arc: THREE.Vector3[]): THREE.Mesh {
  const corners = arc.flatMap((point, i) => {
    const next = arc[i + 1];
    return next ? [new THREE.Vector3(), point, next] : [];
  });
  const geometry = new THREE.BufferGeometry().setFromPoints(corners);
  const look = { color: AXIS_COLOR, transparent: true, opacity: 0.16, side: THREE.DoubleSide, depthWrite: false };
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial(look));
}

/** A direction across an axis: the same each time. */
function reference(axis: THREE.Vector3): THREE.Vector3 {
  const across = Math.abs(axis.x) < 0.9 ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 1, 0);
  return across.addScaledVector(axis, -across.dot(axis)).normalize();
}

function onTop<T extends THREE.Object3D>(object: T): T {
  object.traverse((part) => {
    if (part instanceof THREE.Mesh || part instanceof THREE.Line) {
      (part.material as THREE.Material).depthTest = false;
      (part.material as THREE.Material).transparent = true;
      if (part.renderOrder === 0) part.renderOrder = 4;
    }
  });
  return object;
}

/** Principal moments and axes of a symmetric tensor, by rotations of Jacobi. */
function principal(entries: readonly [number, number, number, number, number, number]): {
  values: [number, number, number];
  axes: THREE.Matrix4;
} {
  const [xx, xy, xz, yy, yz, zz] = entries;
  const a = [
    [xx, xy, xz],
    [xy, yy, yz],
    [xz, yz, zz],
  ];
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const at = (m: number[][], i: number, j: number): number => m[i]?.[j] ?? 0;
  const set = (m: number[][], i: number, j: number, value: number): void => {
    const row = m[i];
    if (row) row[j] = value;
  };
  for (let sweep = 0; sweep < 30; sweep++) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]] as const) {
      const apq = at(a, p, q);
      if (Math.abs(apq) < 1e-18) continue;
      const angle = 0.5 * Math.atan2(2 * apq, at(a, q, q) - at(a, p, p));
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      for (let k = 0; k < 3; k++) {
        const [kp, kq] = [at(a, k, p), at(a, k, q)];
        set(a, k, p, c * kp - s * kq);
        set(a, k, q, s * kp + c * kq);
      }
      for (let k = 0; k < 3; k++) {
        const [pk, qk] = [at(a, p, k), at(a, q, k)];
        set(a, p, k, c * pk - s * qk);
        set(a, q, k, s * pk + c * qk);
        const [vp, vq] = [at(v, k, p), at(v, k, q)];
        set(v, k, p, c * vp - s * vq);
        set(v, k, q, s * vp + c * vq);
      }
    }
  }
  const column = (j: number): THREE.Vector3 => new THREE.Vector3(at(v, 0, j), at(v, 1, j), at(v, 2, j));
  const [x, y] = [column(0), column(1)];
  // a rotation, not a mirror
  const axes = new THREE.Matrix4().makeBasis(x, y, x.clone().cross(y));
  return { values: [at(a, 0, 0), at(a, 1, 1), at(a, 2, 2)], axes };
}
