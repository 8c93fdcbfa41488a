// The expanded text, and the way from there to the source and back.

import { EditorState, Text } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import type { Expanded, SourceMap } from '../../wasm/src/types';
import { el } from './dom';
import { common } from './editor';
import { show } from './marks';
import { at, lineOf } from './places';

type Row = SourceMap['map'][number];

/** Whether a place (line, column) lies in the range that begins at `start` of a row of the map. */
function holds(row: Row, start: 0 | 5, line: number, column: number): boolean {
  const [sl, sc, el, ec] = row.slice(start, start + 4) as [number, number, number, number];
  return (line > sl || (line === sl && column >= sc)) && (line < el || (line === el && column <= ec));
}

/** How much text a range covers: lines first. */
function size(row: Row, start: 0 | 5): number {
  const [sl, sc, el, ec] = row.slice(start, start + 4) as [number, number, number, number];
  return (el - sl) * 10_000 + (ec - sc);
}

export interface Listener {
  /** The source of a place that was clicked. */
  source(path: string, from: [line: number, column: number], to: [line: number, column: number]): void;
}

export class ExpandedText {
  readonly view: EditorView;
  readonly #banner = el('p', { class: 'banner', role: 'alert', hidden: true });
  #map: SourceMap | undefined;
  #text = '';

  constructor(parent: HTMLElement, listener: Listener) {
    parent.append(this.#banner);
    const state = EditorState.create({
      extensions: [
        common('robot.urdf'),
        EditorState.readOnly.of(true),
        EditorView.contentAttributes.of({ 'aria-label': 'Expanded text' }),
        EditorView.updateListener.of((update) => {
          if (update.selectionSet && update.transactions.some((one) => one.isUserEvent('select'))) this.#follow(listener);
        }),
      ],
    });
    this.view = new EditorView({ parent, state });
  }

  /** Show what a robot expands to now; while it has errors, the last text without any. */
  update(expanded: Expanded | undefined, error: string | undefined): void {
    const problem = expanded?.problems.find(({ severity }) => severity === 'error')?.message ?? error;
    const text = expanded?.text ?? undefined;
    this.#banner.hidden = text !== undefined;
    this.#banner.textContent = expanded || error
      ? `${problem ?? 'the robot has errors'}${this.#text ? ' (below: the last text without errors)' : ''}`
      : 'there is no robot among these files';
    if (text === undefined || !expanded?.map) {
      this.#map = undefined;
      if (!expanded && this.#text) this.#replace('');
      return;
    }
    this.#map = expanded.map;
    this.#replace(text);
  }

  /** Mark what a place in the source made. */
  mark(path: string, text: Text, position: number): void {
    const file = this.#map?.files.indexOf(path) ?? -1;
    if (!this.#map || file < 0) return show(this.view, [], false);
    const { line, character } = lineOf(text, position);
    const rows = this.#map.map.filter((row) => row[4] === file && holds(row, 5, line, character));
    const least = Math.min(...rows.map((row) => size(row, 5)));
    const ranges = rows.filter((row) => size(row, 5) === least).map((row) => this.#range(row));
    show(this.view, ranges, true);
  }

  #range(row: Row): { from: number; to: number } {
    const { doc } = this.view.state;
    return { from: at(doc, row[0], row[1]), to: at(doc, row[2], row[3]) };
  }

  #follow(listener: Listener): void {
    const { line, character } = lineOf(this.view.state.doc, this.view.state.selection.main.head);
    const rows = this.#map?.map.filter((row) => holds(row, 0, line, character)) ?? [];
    const row = rows.reduce<Row | undefined>((best, one) => (best && size(best, 0) <= size(one, 0) ? best : one), undefined);
    const path = row && this.#map?.files[row[4]];
    if (!row || path === undefined) return;
    // not while the view is being updated
    queueMicrotask(() => {
      show(this.view, [this.#range(row)], false);
      listener.source(path, [row[5], row[6]], [row[7], row[8]]);
    });
  }

  /** Only what differs is replaced, so that the place that is shown stays. */
  #replace(text: string): void {
    const before = this.#text;
    this.#text = text;
    if (text === before) return;
    let from = 0;
    while (from < text.length && text[from] === before[from]) from++;
    let behind = 0;
    while (behind < Math.min(text.length, before.length) - from && text.at(-1 - behind) === before.at(-1 - behind)) behind++;
    this.view.dispatch({ changes: { from, to: before.length - behind, insert: text.slice(from, text.length - behind) } });
  }
}
