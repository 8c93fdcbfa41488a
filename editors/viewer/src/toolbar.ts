// The bar on top: what is shown, with which arguments, and how.

import { button, el, toggle } from './dom';
import type { ModelMessage, Root } from './messages';
import { LAYERS, type Layer, type Layers } from './robot';

export interface ToolbarActs {
  root: (root: Root, compare: Root | null) => void;
  layer: (layer: Layer, on: boolean) => void;
  fit: () => void;
  measure: (on: boolean) => void;
  parallel: (on: boolean) => void;
  picture: () => void;
  urdf: () => void;
  copy: () => void;
  panel: (which: 'left' | 'right' | 'programs', on: boolean) => void;
  help: () => void;
}

const NAMES: Record<Layer, [string, string]> = {
  visual: ['Visual', 'V'],
  collision: ['Collision', 'C'],
  frames: ['Frames', 'X'],
  names: ['Names', 'N'],
  axes: ['Joint axes and limits', 'A'],
  inertia: ['Inertia', 'I'],
  com: ['Center of mass', 'O'],
  bbox: ['Bounding box', 'B'],
  grid: ['Grid', 'G'],
};

export class Toolbar {
  readonly element: HTMLElement;
  readonly menu = el('div', { class: 'menu' });
  readonly measure: HTMLButtonElement;
  readonly parallel: HTMLButtonElement;
  readonly urdf: HTMLButtonElement;
  private readonly name = el('span', { class: 'name' });
  private readonly root = el('select', { title: 'robot and preset' });
  private readonly compare = el('select', { title: 'show another preset beside it' });
  private readonly args = el('div', { class: 'args' });
  private readonly boxes = new Map<Layer, HTMLInputElement>();
  private readonly beside = el('label', {}, el('span', { text: 'beside' }), this.compare);
  private message: ModelMessage | undefined;
  private comparing: Root | null = null;
  private shown = '';

  constructor(
    private readonly layers: Layers,
    private readonly act: ToolbarActs,
  ) {
    const left = toggle('Links', 'tree of links', true, (on) => act.panel('left', on), 'tree');
    const right = toggle('Joints', 'positions of joints', true, (on) => act.panel('right', on), 'joints');
    const layerButton = button('Layers ▾', 'what is drawn', () => this.openMenu(layerButton), 'layers');
    layerButton.setAttribute('aria-haspopup', 'true');
    this.measure = toggle('Measure', 'measure the distance of two points, with a third the angle (M)', false, act.measure, 'measure');
    this.parallel = toggle('Parallel', 'orthographic view: no perspective (P)', false, act.parallel, 'parallel');
    this.urdf = button('URDF', 'save the expanded robot as a URDF file', act.urdf, 'urdf');
    this.root.setAttribute('aria-label', 'robot and preset');
    this.compare.setAttribute('aria-label', 'compare with');
    this.root.dataset['action'] = 'root';
    this.compare.dataset['action'] = 'compare';
    this.root.addEventListener('change', () => this.choose());
    this.compare.addEventListener('change', () => this.choose());
    this.menu.hidden = true;
    for (const layer of LAYERS) this.menu.append(this.layerBox(layer));
    this.element = el(
      'div',
      { class: 'bar', role: 'toolbar' },
      left,
      this.name,
      this.root,
      this.beside,
      this.args,
      el(
        'span',
        { class: 'tools' },
        layerButton,
        this.measure,
        this.parallel,
        button('Fit', 'show the whole robot (F)', act.fit, 'fit'),
        button('PNG', 'save the picture as a PNG file', act.picture, 'picture'),
        this.urdf,
        button('Copy view', 'copy joints, camera, layers, selection and arguments as text, to paste (Ctrl+V) into a preview of this robot', act.copy, 'copy-view'),
        toggle('Programs', 'what Gazebo, MuJoCo and other programs make of the robot', false, (on) => act.panel('programs', on), 'programs'),
        button('?', 'keys', act.help, 'help'),
        right,
      ),
    );
  }

  /** The root that is shown for comparison. */
  get compared(): Root | null {
    return this.comparing;
  }

  /** Show a root, and another one for comparison. */
  select(root: Root, beside: Root | null): void {
    this.comparing = beside;
    this.act.root(root, beside);
    if (this.message) this.update(this.message);
  }

  update(message: ModelMessage): void {
    this.message = message;
    const name = (message.model ?? message.lastGood)?.robot ?? '';
    this.name.textContent = name || 'robot';
    const shown = JSON.stringify([message.choices, message.root, message.args, this.comparing]);
    if (shown === this.shown) return;
    this.shown = shown;
    this.fill(this.root, message.choices, message.root);
    this.root.hidden = message.choices.length < 2;
    this.beside.hidden = message.choices.length < 2 && !this.comparing;
    const blank = el('option', { text: '–' });
    blank.value = '';
    this.fill(this.compare, message.choices, this.comparing);
    this.compare.prepend(blank);
    if (!this.comparing) this.compare.value = '';
    this.fillArgs(message);
  }

  /** Set a layer, by its key. */
  switch(layer: Layer): void {
    const box = this.boxes.get(layer);
    if (box) box.click();
  }

  closeMenu(): void {
    this.menu.hidden = true;
  }

  private layerBox(layer: Layer): HTMLElement {
    const [name, key] = NAMES[layer];
    const box = el('input', { type: 'checkbox' });
    box.checked = this.layers[layer];
    box.dataset['layer'] = layer;
    box.addEventListener('change', () => this.act.layer(layer, box.checked));
    this.boxes.set(layer, box);
    return el('label', {}, box, el('span', { text: name }), el('kbd', { text: key }));
  }

  private openMenu(below: HTMLElement): void {
    this.menu.hidden = !this.menu.hidden;
    const box = below.getBoundingClientRect();
    this.menu.style.top = `${box.bottom + 4}px`;
    this.menu.style.left = `${Math.max(4, Math.min(box.left, innerWidth - 230))}px`;
    if (!this.menu.hidden) this.menu.querySelector('input')?.focus();
  }

  private fill(select: HTMLSelectElement, choices: Root[], chosen: Root | null): void {
    const same = chosen ? choices.findIndex((root) => JSON.stringify(root) === JSON.stringify(chosen)) : -1;
    const options = choices.map((root, i) => {
      const option = el('option', { text: label(root, choices), title: decodeURI(root.uri) });
      option.value = String(i);
      return option;
    });
    select.replaceChildren(...options);
    if (same >= 0) select.value = String(same);
  }

  private fillArgs(message: ModelMessage): void {
    // a field that is being typed in stays
    if (this.args.contains(document.activeElement)) return;
    const fields = message.args.map(({ name, value }) => {
      const field = el('input', { type: 'text' });
      field.value = value;
      field.title = value;
      field.dataset['arg'] = name;
      field.setAttribute('aria-label', `argument ${name}`);
      field.addEventListener('change', () => {
        // no longer what the preset says
        const root = { uri: message.root.uri, args: { ...message.root.args, [name]: field.value } };
        this.act.root(root, this.comparing);
      });
      field.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') field.blur();
      });
      return el('label', { title: `argument ${name}` }, el('span', { text: name }), field);
    });
    this.args.classList.toggle('many', fields.length > 2);
    this.args.replaceChildren(...fields);
    // of a path, the end says which one it is
    for (const field of this.args.querySelectorAll('input')) field.scrollLeft = field.scrollWidth;
  }

  private choose(): void {
    // what was filled in is no longer what the lists show, also where the choice is taken back before an answer
    this.shown = '';
    const choices = this.message?.choices ?? [];
    const root = choices[Number(this.root.value)] ?? this.message?.root;
    this.comparing = this.compare.value === '' ? null : (choices[Number(this.compare.value)] ?? null);
    if (root) this.act.root(root, this.comparing);
  }
}

/** A root in a few words. */
export function label(root: Root, all: Root[]): string {
  const name = decodeURI(root.uri.split('/').pop() ?? root.uri);
  const args = Object.entries(root.args ?? {}).map(([arg, value]) => `${arg}:=${value}`);
  const file = all.every((other) => other.uri === root.uri) && (root.preset || args.length > 0) ? '' : `${name} `;
  return `${file}${root.preset ?? args.join(' ')}`.trim() || name;
}
