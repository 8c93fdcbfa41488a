// The list of files.

import { el } from './dom';
import type { Project } from './project';

export interface Listener {
  open(path: string): void;
  add(): void;
  remove(path: string): void;
}

/** The files, by folder; those with findings carry their number. */
export function list(project: Project, counts: Map<string, number>, listener: Listener): HTMLElement[] {
  const items: HTMLElement[] = [];
  let before = '';
  for (const path of [...project.files.keys()].sort()) {
    const folder = path.slice(0, path.lastIndexOf('/') + 1);
    if (folder !== before) items.push(el('li', { class: 'folder', text: folder }));
    before = folder;
    const isText = project.text(path) !== undefined;
    const count = counts.get(path) ?? 0;
    const button = el('button', {
      type: 'button', class: 'file', 'data-path': path, 'aria-current': path === project.open ? 'true' : 'false', disabled: !isText,
      title: isText ? path : `${path} (not a text)`, onclick: () => listener.open(path),
    }, path.slice(folder.length));
    if (count > 0) button.append(el('span', { class: 'count', title: `${count} findings`, text: String(count) }));
    const remove = el('button', { type: 'button', class: 'remove', title: `Remove ${path}`, 'aria-label': `Remove ${path}`, text: '×', onclick: () => listener.remove(path) });
    items.push(el('li', {}, button, remove));
  }
  const add = el('button', { type: 'button', id: 'add', text: 'Add file', onclick: () => listener.add() });
  return [el('h2', { text: 'Files' }), el('ul', {}, ...items), add];
}
