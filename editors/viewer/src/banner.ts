// The bar beside the robot: errors of the source, and what of the robot is not drawn.

import type { Problem } from './bodies';
import { button, el } from './dom';
import type { Location, ModelMessage } from './messages';
import type { State } from './state';

interface BannerActs {
  open: (location: Location) => void;
  select: (link: string) => void;
}

export class Banner {
  readonly element = el('div', { class: 'banner', role: 'alert' });
  /** Whether the user wants to see the list; undefined: as it fits. */
  private unfolded: boolean | undefined;

  constructor(private readonly act: BannerActs) {}

  update({ latest, times, views }: State): void {
    const broken = [...latest.values()].filter((message) => !message.ok);
    const problems = [...views.values()].flatMap((view) => [...view.bodies.problems.values()]);
    const rows = [...broken.flatMap((message) => this.errors(message)), ...problems.map((problem) => this.problem(problem))];
    const [first] = broken;
    const title = first ? errorsTitle(first, times) : problems.length > 0 ? problemsTitle(problems) : '';
    this.element.hidden = rows.length === 0 && !title;
    const text = JSON.stringify([title, rows.map((row) => row.textContent)]);
    if (this.element.dataset['text'] === text) return;
    this.element.dataset['text'] = text;
    const summary = el('summary', { title: 'show or hide the list' }, el('b', { text: title }));
    const list = el('details', {}, summary, el('ul', {}, ...rows));
    list.open = this.unfolded ?? (broken.length > 0 || rows.length < 4);
    summary.addEventListener('click', () => (this.unfolded = !list.open));
    this.element.replaceChildren(list);
  }

  private errors({ errors }: ModelMessage): HTMLElement[] {
    return errors.map(({ message, code, location }) => {
      const line = location.range.start.line + 1;
      const file = decodeURI(location.uri.split('/').pop() ?? '');
      const entry = button(message, 'go there', () => this.act.open(location), 'error');
      entry.append(el('small', { text: `${file}:${line} · ${code}` }));
      return el('li', {}, entry);
    });
  }

  private problem({ text, link }: Problem): HTMLElement {
    const entry = button(text, `select ${link}`, () => this.act.select(link), 'problem');
    entry.append(el('small', { text: `link ${link}` }));
    return el('li', {}, entry);
  }
}

/** What is shown instead of a robot with errors, and how many there are. */
function errorsTitle({ errors, goodRevision, lastGood }: ModelMessage, times: Map<number, string>): string {
  const good = goodRevision === undefined ? 'the last good revision' : `revision ${goodRevision} of ${times.get(goodRevision) ?? 'before'}`;
  const shown = lastGood ? `shows ${good}` : 'shows what could be made';
  return errors.length === 0 ? shown : `${shown}, ${errors.length} error${errors.length === 1 ? '' : 's'}`;
}

/** `2 meshes are missing`, or how many shapes are not drawn as they are. */
function problemsTitle(problems: Problem[]): string {
  const many = problems.length !== 1;
  if (problems.every(({ missing }) => missing)) return `${problems.length} mesh${many ? 'es are' : ' is'} missing`;
  return `${problems.length} shape${many ? 's' : ''} cannot be drawn`;
}
