// The form for the arguments of the robot.

import { el } from './dom';

export interface Listener {
  set(name: string, value: string | undefined): void;
}

/** One field for each argument; those that differ from their defaults can be put back. */
export function form(values: Record<string, string>, given: Record<string, string>, listener: Listener): HTMLElement[] {
  const names = [...new Set([...Object.keys(values), ...Object.keys(given)])];
  if (names.length === 0) return [el('p', { class: 'empty', text: 'this robot has no arguments' })];
  const rows = names.map((name) => {
    const value = given[name] ?? values[name] ?? '';
    const id = `argument-${name}`;
    const set = (event: Event): void => listener.set(name, (event.target as HTMLInputElement | HTMLSelectElement).value);
    const isSwitch = ['true', 'false'].includes((values[name] ?? '').toLowerCase()) && ['true', 'false'].includes(value);
    const field = isSwitch
      ? el('select', { id, onchange: set }, ...['true', 'false'].map((one) => el('option', { value: one, selected: one === value, text: one })))
      : el('input', { id, value, spellcheck: 'false', autocomplete: 'off', onchange: set });
    const back = el('button', { type: 'button', text: 'Default', disabled: !(name in given), onclick: () => listener.set(name, undefined) });
    return el('div', { class: 'argument' }, el('label', { for: id, text: name }), field, back);
  });
  return rows;
}
