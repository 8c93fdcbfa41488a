// Marks that show what belongs together in the source and in the expanded text.

import { StateEffect, StateField } from '@codemirror/state';
import { Decoration, type DecorationSet, EditorView } from '@codemirror/view';

const put = StateEffect.define<{ from: number; to: number }[]>();
const mark = Decoration.mark({ class: 'counterpart' });

export const marks = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(now, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(put)) return Decoration.set(effect.value.filter(({ from, to }) => from < to).map(({ from, to }) => mark.range(from, to)), true);
    }
    return now.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Mark these ranges and no others; the first one is scrolled to if asked for. */
export function show(view: EditorView, ranges: { from: number; to: number }[], scroll: boolean): void {
  const length = view.state.doc.length;
  const inside = ranges.map(({ from, to }) => ({ from: Math.min(from, length), to: Math.min(to, length) }));
  const [first] = inside;
  const effects: StateEffect<unknown>[] = [put.of(inside)];
  if (scroll && first) effects.push(EditorView.scrollIntoView(first.from, { y: 'center' }));
  view.dispatch({ effects });
}
