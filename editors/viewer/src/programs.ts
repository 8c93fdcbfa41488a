// What the programs that read URDF make of the robot: which reject it, which change or ignore something, and where that is written.

import { button, el } from './dom';
import type { Construct, Location, Programs } from './messages';

export class ProgramsPanel {
  readonly element = el('section', { class: 'programs' });
  private shown = '';

  constructor(private readonly open: (location: Location) => void) {
    this.element.hidden = true;
    this.element.setAttribute('aria-label', 'programs that read this robot');
  }

  /** Show what programs make of a robot; nothing is known of one with errors. */
  update(programs: Programs | undefined): void {
    const text = JSON.stringify(programs ?? null);
    if (text === this.shown) return;
    this.shown = text;
    if (!programs) return this.element.replaceChildren(el('p', { text: 'unknown while the file has errors' }));
    const { names, constructs } = programs;
    const summary = el('dl', {}, ...verdicts(names, constructs));
    if (constructs.length === 0) return this.element.replaceChildren(summary);
    const heads = ['Construct', 'Rejected by', 'Changed or ignored by', 'Where'].map((text) => el('th', { text }));
    for (const head of heads) head.scope = 'col';
    const rows = constructs.map((one) => this.row(one));
    this.element.replaceChildren(summary, el('table', {}, el('thead', {}, el('tr', {}, ...heads)), el('tbody', {}, ...rows)));
  }

  private row(construct: Construct): HTMLElement {
    const { title, help, rejected, changed, places, count } = construct;
    const what = el('td', { text: title });
    if (help) what.append(el('small', { text: help }));
    const where = el('td');
    for (const { of, location } of places) {
      const file = decodeURI(location.uri.split('/').pop() ?? '');
      const entry = button(of, `go to ${file}:${location.range.start.line + 1}`, () => this.open(location), 'construct');
      where.append(entry);
    }
    if (count > places.length) where.append(el('small', { text: `and ${count - places.length} more` }));
    return el('tr', {}, what, el('td', { class: 'rejected', text: rejected.join(', ') }), el('td', { text: changed.join(', ') }), where);
  }
}

/** The programs by the worst that they do with the robot. */
function verdicts(names: string[], constructs: Construct[]): HTMLElement[] {
  const rejecting = new Set(constructs.flatMap((one) => one.rejected));
  const changing = new Set(constructs.flatMap((one) => one.changed).filter((name) => !rejecting.has(name)));
  const groups: [string, string[]][] = [
    ['Rejected by', names.filter((name) => rejecting.has(name))],
    ['Changed by', names.filter((name) => changing.has(name))],
    ['Accepted by', names.filter((name) => !rejecting.has(name) && !changing.has(name))],
  ];
  return groups.filter(([, who]) => who.length > 0).flatMap(([text, who]) => [el('dt', { text }), el('dd', { text: who.join(', ') })]);
}
