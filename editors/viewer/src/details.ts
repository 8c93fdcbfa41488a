// What there is to say of the link that is selected: mass, inertia, poses, size, and where it stands in the source.

import * as THREE from 'three';
import { button, el, short } from './dom';
import { inWords, limitsInWords } from './joints';
import type { Joint, Link, Location } from './messages';
import type { RobotView } from './robot';
import { moves } from './values';

export class Details {
  readonly element = el('section', { class: 'details' });
  private shown: { view: RobotView; link: Link } | undefined;
  private readonly moving = new Map<string, HTMLElement>();

  constructor(
    private readonly act: {
      open: (link: string, location: Location) => void;
      fade: (link: string, share: number) => void;
      position: (joint: string) => number;
    },
  ) {
    this.element.hidden = true;
    this.element.setAttribute('aria-label', 'link');
  }

  /** Show a link, or nothing. */
  show(view?: RobotView, name?: string): void {
    const link = view?.model.links.find((one) => one.name === name);
    this.element.hidden = !link;
    this.shown = view && link ? { view, link } : undefined;
    if (!view || !link) return;
    this.moving.clear();
    const rows = [...this.inertial(link), ...this.poses(view, link), ...this.joint(view, link), ...this.size(view, link)];
    this.element.replaceChildren(this.head(link), el('dl', {}, ...rows), this.opacity(view, link));
    this.update();
  }

  /** Write what changes when joints move. */
  update(): void {
    if (!this.shown || this.element.hidden) return;
    const { view, link } = this.shown;
    const joint = view.jointAbove(link.name);
    for (const [key, field] of this.moving) {
      if (key === 'position') {
        field.textContent = joint ? inWords(joint, this.act.position(joint.name)) : '–';
        continue;
      }
      const matrix = view.poseOf(link.name, key === 'parent');
      field.textContent = matrix ? poseText(matrix) : '–';
    }
  }

  private head(link: Link): HTMLElement {
    const head = el('header', {}, el('b', { text: link.name }));
    const { origin } = link;
    if (origin) {
      const file = decodeURI(origin.uri.split('/').pop() ?? '');
      const place = `${file}:${origin.range.start.line + 1}`;
      head.append(button(place, `go to ${place}`, () => this.act.open(link.name, origin), 'source'));
    }
    return head;
  }

  private inertial({ inertial }: Link): HTMLElement[] {
    if (!inertial) return row('Mass', 'mass', 'no inertial');
    const rows = row('Mass', 'mass', `${precise(inertial.mass)} kg`);
    const center = inertial.pose.xyz.map((one) => short(one, 4)).join(' ');
    rows.push(...row('Center of mass', 'com', `${center} m`));
    if (inertial.inertia) {
      const [xx, xy, xz, yy, yz, zz] = inertial.inertia.map(precise);
      rows.push(...row('Inertia', 'inertia', `xx ${xx}  yy ${yy}  zz ${zz}\nxy ${xy}  xz ${xz}  yz ${yz} kg m²`));
    }
    return rows;
  }

  private poses(view: RobotView, link: Link): HTMLElement[] {
    const parent = view.jointAbove(link.name)?.parent;
    const rows = row('In the world', 'world', '');
    if (parent !== undefined) rows.push(...row(`In ${parent}`, 'parent', ''));
    for (const field of rows) if (field.dataset['field']) this.moving.set(field.dataset['field'], field);
    return rows;
  }

  /** The joint that holds the link, with its limits and its position in radians and degrees. */
  private joint(view: RobotView, link: Link): HTMLElement[] {
    const joint: Joint | undefined = view.jointAbove(link.name);
    if (!joint) return [];
    const rows = row('Joint', 'joint', `${joint.name}, ${joint.type}`);
    if (!moves(joint)) return rows;
    rows.push(...row('Limits', 'limits', limitsInWords(joint).replace(/^limits /, '')));
    const position = row('Position', 'position', '');
    for (const field of position) if (field.dataset['field']) this.moving.set('position', field);
    return [...rows, ...position];
  }

  private size(view: RobotView, link: Link): HTMLElement[] {
    const size = view.extentOf(link.name);
    const text = size ? `${[size.x, size.y, size.z].map((one) => short(one, 4)).join(' × ')} m` : 'no shape';
    const note = view.standsIn(link) ? ', of the collision: no visual' : '';
    return row('Bounding box', 'size', text + note);
  }

  private opacity(view: RobotView, link: Link): HTMLElement {
    const slider = el('input', { type: 'range', title: 'how opaque the link is drawn' });
    [slider.min, slider.max, slider.step] = ['0.1', '1', '0.05'];
    slider.valueAsNumber = view.opacity.get(link.name) ?? 1;
    slider.setAttribute('aria-label', `opacity of ${link.name}`);
    slider.dataset['action'] = 'opacity';
    slider.addEventListener('input', () => this.act.fade(link.name, slider.valueAsNumber));
    return el('label', {}, el('span', { text: 'Opacity' }), slider);
  }
}

function row(name: string, field: string, text: string): HTMLElement[] {
  const value = el('dd', { text });
  value.dataset['field'] = field;
  return [el('dt', { text: name, title: name }), value];
}

function precise(value: number): string {
  return value === 0 ? '0' : String(Number(value.toPrecision(4)));
}

/** Meters, and degrees about fixed axes, as URDF turns. */
function poseText(matrix: THREE.Matrix4): string {
  const [at, turn, scale] = [new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3()];
  matrix.decompose(at, turn, scale);
  const angles = new THREE.Euler().setFromQuaternion(turn, 'ZYX');
  const turns = [angles.x, angles.y, angles.z];
  const degrees = turns.map((one) => `${short(THREE.MathUtils.radToDeg(one), 2)}°`);
  const radians = turns.map((one) => short(one, 4));
  return `xyz ${[at.x, at.y, at.z].map((one) => short(one, 4)).join(' ')} m\nrpy ${degrees.join(' ')}\n= ${radians.join(' ')} rad`;
}
