// Positions of joints: those that move by themselves have a value of their own, the others follow.

import type { Joint, Model } from './messages';

export interface Bounds {
  min: number;
  max: number;
  /** No end: continuous joints, and those without a limit. */
  endless: boolean;
}

/** Whether a joint has one position that can be set. */
export function moves(joint: Joint): boolean {
  return joint.type === 'revolute' || joint.type === 'continuous' || joint.type === 'prismatic';
}

export function bounds(joint: Joint): Bounds {
  if (joint.type === 'continuous') return { min: -Math.PI, max: Math.PI, endless: true };
  if (!joint.limit) {
    const reach = joint.type === 'prismatic' ? 1 : Math.PI;
    return { min: -reach, max: reach, endless: false };
  }
  const { lower, upper } = joint.limit;
  return { min: Math.min(lower, upper), max: Math.max(lower, upper), endless: false };
}

export class Values {
  private readonly own = new Map<string, number>();
  private joints = new Map<string, Joint>();
  private readonly sweeping = new Map<string, number>();

  constructor(private readonly changed: () => void) {}

  /** Take over the joints of a model; what still exists keeps its value, as far as its limits go. */
  update(models: Model[]): void {
    this.joints = new Map(models.flatMap((model) => model.joints).reverse().map((joint) => [joint.name, joint]));
    for (const [name, value] of this.own) {
      const joint = this.joints.get(name);
      if (joint) this.own.set(name, clamp(joint, value));
    }
    for (const name of this.sweeping.keys()) if (!this.joints.has(name)) this.sweeping.delete(name);
  }

  joint(name: string): Joint | undefined {
    return this.joints.get(name);
  }

  /** The joint that a joint goes with in the end, and by which factor. */
  leader(name: string): { joint: Joint; factor: number } | undefined {
    let factor = 1;
    const seen = new Set<string>();
    for (let joint = this.joints.get(name); joint; joint = this.joints.get(joint.mimic.joint)) {
      if (!moves(joint) || seen.has(joint.name)) return undefined;
      seen.add(joint.name);
      if (!joint.mimic) return { joint, factor };
      factor *= joint.mimic.multiplier;
    }
    return undefined;
  }

  /** The position of a joint, of one that follows too. */
  get(name: string, depth = 0): number {
    const joint = this.joints.get(name);
    if (joint?.mimic && depth < 64) {
      return joint.mimic.multiplier * this.get(joint.mimic.joint, depth + 1) + joint.mimic.offset;
    }
    const fallback = joint ? clamp(joint, 0) : 0;
    return this.own.get(name) ?? fallback;
  }

  set(name: string, value: number): void {
    const joint = this.joints.get(name);
    if (!joint || !moves(joint) || joint.mimic || !Number.isFinite(value)) return;
    this.own.set(name, clamp(joint, value));
    this.changed();
  }

  /** The joints that were moved, with their positions. */
  moved(): Map<string, number> {
    return new Map([...this.own].filter(([name, value]) => this.joints.has(name) && value !== 0));
  }

  /** Move joints to these positions, and all others to zero. */
  place(positions: Map<string, number>): void {
    this.own.clear();
    this.sweeping.clear();
    for (const [name, value] of positions) {
      const joint = this.joints.get(name);
      if (joint && moves(joint) && !joint.mimic) this.own.set(name, clamp(joint, value));
    }
    this.changed();
  }

  reset(): void {
    this.own.clear();
    this.sweeping.clear();
    this.changed();
  }

  random(): void {
    for (const joint of this.joints.values()) {
      if (!moves(joint) || joint.mimic) continue;
      const { min, max } = bounds(joint);
      this.own.set(joint.name, min + Math.random() * (max - min));
    }
    this.changed();
  }

  isSweeping(name: string): boolean {
    return this.sweeping.has(name);
  }

  /** Move to and fro between the limits, from where it is; again: stop. */
  sweep(name: string, now: number): void {
    const joint = this.joints.get(name);
    if (this.sweeping.delete(name) || !joint || joint.mimic || !moves(joint)) return this.changed();
    const { min, max } = bounds(joint);
    const part = max > min ? (this.get(name) - min) / (max - min) : 0.5;
    this.sweeping.set(name, now - (Math.acos(1 - 2 * Math.min(1, Math.max(0, part))) / (2 * Math.PI)) * PERIOD);
    this.changed();
  }

  /** Go on with what is sweeping; whether there is something. */
  step(now: number): boolean {
    for (const [name, start] of this.sweeping) {
      const joint = this.joints.get(name);
      if (!joint) continue;
      const { min, max } = bounds(joint);
      const part = (1 - Math.cos(((now - start) / PERIOD) * 2 * Math.PI)) / 2;
      this.own.set(name, min + part * (max - min));
    }
    if (this.sweeping.size > 0) this.changed();
    return this.sweeping.size > 0;
  }
}

/** Milliseconds to and fro. */
const PERIOD = 4000;

function clamp(joint: Joint, value: number): number {
  const { min, max, endless } = bounds(joint);
  return endless ? value : Math.min(max, Math.max(min, value));
}
