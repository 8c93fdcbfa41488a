// The panel of joints: a slider each, with limits, typed values, and buttons to sweep, reset and scatter.

import { button, el, short, toggle } from './dom';
import type { Joint, Model } from './messages';
import { bounds, moves, type Values } from './values';

interface Row {
  element: HTMLElement;
  key: string;
  show: () => void;
}

export class JointPanel {
  readonly element: HTMLElement;
  private readonly list = el('div', { class: 'scroll' });
  private readonly rows = new Map<string, Row>();
  private readonly unit: HTMLButtonElement;
  private degrees = true;
  private model: Model | undefined;

  constructor(
    private readonly values: Values,
    private readonly act: { select: (joint: string) => void },
  ) {
    this.unit = button('deg', 'show angles in radians', () => this.switchUnit(), 'unit');
    const reset = button('Reset', 'all joints to zero (R)', () => values.reset(), 'reset');
    const random = button('Random', 'all joints anywhere within their limits', () => values.random(), 'random');
    const header = el('header', {}, el('b', { text: 'Joints' }), this.unit, reset, random);
    this.element = el('section', { class: 'panel right' }, header, this.list);
    this.element.setAttribute('aria-label', 'joints');
  }

  private switchUnit(): void {
    this.degrees = !this.degrees;
    this.unit.textContent = this.degrees ? 'deg' : 'rad';
    this.unit.title = this.degrees ? 'show angles in radians' : 'show angles in degrees';
    this.rows.clear();
    if (this.model) this.update(this.model);
  }

  /** Show the joints of a model; rows that did not change stay, with the focus in them. */
  update(model: Model): void {
    this.model = model;
    const joints = model.joints.filter(moves);
    const names = new Set(joints.map((joint) => joint.name));
    for (const name of [...this.rows.keys()]) if (!names.has(name)) this.rows.delete(name);
    const rows = joints.map((joint) => {
      const key = JSON.stringify([joint.type, joint.limit, joint.mimic]);
      const known = this.rows.get(joint.name);
      if (known?.key === key) return known.element;
      const row = this.row(joint, key);
      this.rows.set(joint.name, row);
      return row.element;
    });
    const same = rows.length === this.list.children.length && rows.every((row, i) => this.list.children[i] === row);
    if (!same) this.list.replaceChildren(...rows);
    if (rows.length === 0) this.list.replaceChildren(el('p', { class: 'row', text: 'no joint of this robot moves' }));
    this.show();
  }

  /** Write the values as they are now. */
  show(): void {
    for (const row of this.rows.values()) row.show();
  }

  mark(names: Iterable<string>, scroll: boolean): void {
    const marked = new Set(names);
    for (const [name, row] of this.rows) {
      row.element.dataset['on'] = String(marked.has(name));
      if (scroll && marked.has(name)) row.element.scrollIntoView({ block: 'nearest' });
    }
  }

  focus(name: string): void {
    this.rows.get(name)?.element.querySelector<HTMLElement>('input, .wheel')?.focus();
  }

  private row(joint: Joint, key: string): Row {
    const angle = joint.type !== 'prismatic';
    const factor = angle && this.degrees ? 180 / Math.PI : 1;
    const digits = factor === 1 ? 3 : 1;
    const unit = angle ? (this.degrees ? '°' : 'rad') : 'm';
    const { min, max, endless } = bounds(joint);
    const range = endless ? 'endless' : `${short(min * factor, digits)} … ${short(max * factor, digits)}`;
    const note = joint.limit || endless ? range : `${range}, no limit given`;
    const head = el('div', { class: 'head', title: `${joint.name}: ${joint.type}, ${joint.parent} → ${joint.child}\n${limitsInWords(joint)}` });
    head.append(el('span', { class: 'text', text: joint.name }), el('small', { text: note }));
    head.addEventListener('click', (event) => {
      if (!(event.target instanceof HTMLButtonElement)) this.act.select(joint.name);
    });
    const body = el('div', { class: 'body' });
    const element = el('div', { class: 'joint' }, head, body);
    element.dataset['joint'] = joint.name;
    if (joint.mimic) {
      const follows = el('small', { text: '' });
      body.append(el('small', { class: 'text', text: `follows ${joint.mimic.joint}` }), follows);
      const show = (): void => {
        const value = this.values.get(joint.name);
        follows.textContent = short(value * factor, digits) + unit;
        follows.title = inWords(joint, value);
      };
      return { element, key, show };
    }
    const sweep = toggle('▶', `sweep ${joint.name} between its limits`, false, () => this.values.sweep(joint.name, performance.now()), 'sweep');
    head.append(sweep);
    const control = endless ? this.wheel(joint) : this.slider(joint, min, max);
    const typed = el('input', { type: 'number' });
    typed.step = 'any';
    typed.setAttribute('aria-label', `${joint.name} in ${unit === '°' ? 'degrees' : unit}`);
    typed.addEventListener('change', () => {
      this.values.set(joint.name, typed.valueAsNumber / factor);
      // what was clipped is seen at once, also while the field has the focus
      typed.value = short(this.values.get(joint.name) * factor, digits);
      show();
    });
    typed.disabled = min === max;
    const other = el('small', { class: 'other' });
    other.hidden = !angle;
    body.append(control.element, typed, el('span', { class: 'unit', text: unit }), other);
    const show = (): void => {
      const value = this.values.get(joint.name);
      control.show(value);
      if (document.activeElement !== typed || this.values.isSweeping(joint.name)) typed.value = short(value * factor, digits);
      typed.title = inWords(joint, value);
      other.textContent = this.degrees ? `${short(value, 3)} rad` : `${short((value * 180) / Math.PI, 1)}°`;
      sweep.setAttribute('aria-pressed', String(this.values.isSweeping(joint.name)));
    };
    typed.addEventListener('blur', show);
    return { element, key, show };
  }

  private slider(joint: Joint, min: number, max: number): { element: HTMLElement; show: (value: number) => void } {
    const slider = el('input', { type: 'range' });
    slider.min = String(min);
    slider.max = String(max);
    slider.step = String(Math.max((max - min) / 1000, 1e-6));
    slider.disabled = min === max;
    slider.setAttribute('aria-label', joint.name);
    slider.addEventListener('input', () => this.values.set(joint.name, slider.valueAsNumber));
    slider.addEventListener('dblclick', () => this.values.set(joint.name, 0));
    return { element: slider, show: (value) => (slider.valueAsNumber = value) };
  }

  /** A wheel without an end. */
  private wheel(joint: Joint): { element: HTMLElement; show: (value: number) => void } {
    const wheel = el('div', { class: 'wheel', role: 'slider', tabindex: 0, title: 'drag, or use the arrow keys' });
    wheel.setAttribute('aria-label', joint.name);
    const turn = (by: number): void => this.values.set(joint.name, this.values.get(joint.name) + by);
    wheel.addEventListener('pointerdown', (event) => wheel.setPointerCapture(event.pointerId));
    wheel.addEventListener('pointermove', (event) => {
      if (wheel.hasPointerCapture(event.pointerId)) turn(event.movementX * 0.015);
    });
    wheel.addEventListener('wheel', (event) => {
      event.preventDefault();
      turn(-Math.sign(event.deltaY) * 0.05);
    });
    wheel.addEventListener('dblclick', () => this.values.set(joint.name, 0));
    wheel.addEventListener('keydown', (event) => {
      const steps: Record<string, number> = { ArrowRight: 0.05, ArrowUp: 0.05, ArrowLeft: -0.05, ArrowDown: -0.05, PageUp: 0.5, PageDown: -0.5 };
      const by = steps[event.key];
      if (by === undefined && event.key !== 'Home') return;
      event.preventDefault();
      if (by === undefined) this.values.set(joint.name, 0);
      else turn(by);
    });
    const show = (value: number): void => {
      wheel.setAttribute('aria-valuenow', short(value, 3));
      wheel.style.backgroundPositionX = `${value / 0.015}px`;
    };
    return { element: wheel, show };
  }
}

/** The limits of a joint in all its units: `limits -1.571 … 1.571 rad (-90° … 90°)`. */
export function limitsInWords(joint: Joint): string {
  const { min, max, endless } = bounds(joint);
  if (endless) return 'turns without end';
  const given = joint.limit ? 'limits' : 'no limit given, shown within';
  if (joint.type === 'prismatic') return `${given} ${short(min, 4)} … ${short(max, 4)} m`;
  const [from, to] = [min, max].map((one) => `${short((one * 180) / Math.PI, 1)}°`);
  return `${given} ${short(min, 3)} … ${short(max, 3)} rad (${from} … ${to})`;
}

/** A position with its unit: `-1.658 rad (-95°)`, `0.25 m`. */
export function inWords(joint: Joint, value: number): string {
  if (joint.type === 'prismatic') return `${short(value, 4)} m`;
  return `${short(value, 3)} rad (${short((value * 180) / Math.PI, 1)}°)`;
}
