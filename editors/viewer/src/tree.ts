// The tree of links, with a search and an eye for each link.

import { button, el } from './dom';
import type { Joint, Model } from './messages';

interface Entry {
  link: string;
  joint?: Joint;
  depth: number;
}

export class TreePanel {
  readonly element: HTMLElement;
  private readonly list = el('div', { class: 'scroll', role: 'tree' });
  private readonly search = el('input', { type: 'search' });
  private model: Model = { robot: '', links: [], joints: [], meshes: {} };
  private selected = new Set<string>();
  private shape = '';

  constructor(
    private readonly act: {
      select: (link: string, shift: boolean) => void;
      focus: (link: string) => void;
      show: (link: string, on: boolean) => void;
      hidden: () => Set<string>;
    },
    below: HTMLElement,
  ) {
    this.search.placeholder = 'Search links and joints ( / )';
    this.search.setAttribute('aria-label', 'search links and joints');
    this.search.addEventListener('input', () => this.draw());
    this.search.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.list.querySelector<HTMLElement>('.row')?.click();
      if (event.key === 'Escape') {
        this.search.value = '';
        this.draw();
        this.search.blur();
      }
    });
    this.list.addEventListener('keydown', (event) => this.key(event));
    this.list.setAttribute('aria-label', 'links');
    this.element = el('section', { class: 'panel left' }, el('header', {}, this.search), this.list, below);
  }

  focusSearch(): void {
    this.search.focus();
    this.search.select();
  }

  update(model: Model): void {
    this.model = model;
    const shape = JSON.stringify([
      model.links.map((link) => link.name),
      model.joints.map((joint) => [joint.name, joint.type, joint.parent, joint.child]),
    ]);
    if (shape !== this.shape) {
      this.shape = shape;
      this.draw();
    }
  }

  mark(names: Iterable<string>, scroll: boolean): void {
    this.selected = new Set(names);
    for (const row of this.list.querySelectorAll<HTMLElement>('.row')) {
      const on = this.selected.has(row.dataset['link'] ?? '');
      row.setAttribute('aria-selected', String(on));
      row.tabIndex = -1;
      if (on && scroll) row.scrollIntoView({ block: 'nearest' });
    }
    this.makeReachable();
  }

  /** One row can be reached by Tab: the one that is selected, or the first. */
  private makeReachable(): void {
    const row = this.list.querySelector<HTMLElement>('.row[aria-selected=true]') ?? this.list.querySelector<HTMLElement>('.row[role]');
    if (row) row.tabIndex = 0;
  }

  /** Show which links are hidden. */
  eyes(): void {
    for (const row of this.list.querySelectorAll<HTMLElement>('.row')) {
      const off = this.act.hidden().has(row.dataset['link'] ?? '');
      row.classList.toggle('hidden-link', off);
      const eye = row.querySelector('button');
      if (eye) eye.textContent = off ? '◌' : '●';
    }
  }

  private draw(): void {
    const wanted = this.search.value.trim().toLowerCase();
    const fits = (entry: Entry): boolean =>
      !wanted || entry.link.toLowerCase().includes(wanted) || !!entry.joint?.name.toLowerCase().includes(wanted);
    const rows = entries(this.model).filter(fits).map((entry) => this.row(entry, !!wanted));
    this.list.replaceChildren(...rows);
    if (rows.length === 0) this.list.append(el('p', { class: 'row', text: wanted ? 'nothing found' : 'no links' }));
    this.mark(this.selected, false);
    this.eyes();
  }

  private row(entry: Entry, flat: boolean): HTMLElement {
    const text = el('span', { class: 'text' }, el('span', { text: entry.link }));
    if (entry.joint) text.append(el('small', { text: `${entry.joint.name} · ${entry.joint.type}` }));
    const eye = button('●', `show or hide ${entry.link}`, () => this.act.show(entry.link, this.act.hidden().has(entry.link)), 'eye');
    // the space bar does the same on the row
    eye.tabIndex = -1;
    const row = el('div', { class: 'row', role: 'treeitem', tabindex: -1 }, text, eye);
    row.dataset['link'] = entry.link;
    row.setAttribute('aria-level', String(entry.depth + 1));
    row.style.paddingLeft = `${6 + (flat ? 0 : Math.min(entry.depth, 24) * 10)}px`;
    row.title = entry.joint ? `${entry.link}, child of joint ${entry.joint.name}` : entry.link;
    row.addEventListener('click', (event) => {
      if (event.target instanceof HTMLButtonElement) return;
      row.focus();
      this.act.select(entry.link, event.shiftKey);
    });
    row.addEventListener('dblclick', () => this.act.focus(entry.link));
    return row;
  }

  private key(event: KeyboardEvent): void {
    const rows = [...this.list.querySelectorAll<HTMLElement>('.row')];
    const at = rows.findIndex((row) => row === document.activeElement);
    const move: Record<string, number> = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: rows.length - 1 };
    const to = move[event.key];
    const link = rows[at]?.dataset['link'];
    if (to !== undefined) rows[Math.max(0, Math.min(rows.length - 1, to))]?.focus();
    else if (event.key === 'Enter' && link) this.act.select(link, event.shiftKey);
    else if (event.key === ' ' && link) this.act.show(link, this.act.hidden().has(link));
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

/** Links in the order of the tree, roots first; what hangs in a circle comes last. */
function entries(model: Model): Entry[] {
  const down = new Map<string, Joint[]>();
  const held = new Set<string>();
  for (const joint of model.joints) {
    const list = down.get(joint.parent) ?? [];
    list.push(joint);
    down.set(joint.parent, list);
    held.add(joint.child);
  }
  const known = new Set(model.links.map((link) => link.name));
  const seen = new Set<string>();
  const found: Entry[] = [];
  const walk = (start: string): void => {
    const open: Entry[] = [{ link: start, depth: 0 }];
    for (let entry = open.pop(); entry; entry = open.pop()) {
      if (seen.has(entry.link) || !known.has(entry.link)) continue;
      seen.add(entry.link);
      found.push(entry);
      const depth = entry.depth + 1;
      const children = (down.get(entry.link) ?? []).map((joint) => ({ link: joint.child, joint, depth }));
      open.push(...children.reverse());
    }
  };
  for (const link of model.links) if (!held.has(link.name)) walk(link.name);
  for (const link of model.links) walk(link.name);
  return found;
}
