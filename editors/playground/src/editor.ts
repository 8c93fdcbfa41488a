// The editor: one view, and a state for each file that was opened.

import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { xml } from '@codemirror/lang-xml';
import { yaml } from '@codemirror/lang-yaml';
import { bracketMatching, foldGutter, foldKeymap, indentOnInput, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { type Diagnostic, lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { highlightSelectionMatches, searchKeymap } from '@codemirror/search';
import { EditorState, type Extension, type Text } from '@codemirror/state';
import {
  Decoration, drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers, MatchDecorator, ViewPlugin, type ViewUpdate,
} from '@codemirror/view';
import { classHighlighter } from '@lezer/highlight';
import { marks } from './marks';

/** `${…}` and `$(…)` in the values of attributes. */
const expressions = new MatchDecorator({ regexp: /\$\{[^}\n]*\}|\$\([^)\n]*\)/g, decoration: Decoration.mark({ class: 'expression' }) });
const expressionMarks = ViewPlugin.define(
  (view) => ({
    decorations: expressions.createDeco(view),
    update(update: ViewUpdate) {
      this.decorations = expressions.updateDeco(update, this.decorations);
    },
  }),
  { decorations: (plugin) => plugin.decorations },
);

/** What the source and the expanded text have in common. */
export function common(path: string): Extension {
  return [
    lineNumbers(),
    foldGutter(),
    drawSelection(),
    bracketMatching(),
    highlightSelectionMatches(),
    syntaxHighlighting(classHighlighter),
    /\.ya?ml$/.test(path) ? yaml() : /\.(py|txt|toml|md)$/.test(path) ? [] : [xml(), expressionMarks],
    marks,
    EditorView.lineWrapping,
  ];
}

export interface Listener {
  /** The text of the file that is open was changed. */
  changed(path: string, text: Text): void;
  /** The cursor was put somewhere. */
  moved(path: string, position: number): void;
}

export class Editor {
  readonly view: EditorView;
  readonly #states = new Map<string, EditorState>();
  readonly #listener: Listener;
  path: string | undefined;

  constructor(parent: HTMLElement, listener: Listener) {
    this.#listener = listener;
    this.view = new EditorView({ parent });
    this.show(undefined, undefined);
  }

  /** Forget the files that were opened, with what can be undone in them. */
  forget(): void {
    this.#states.clear();
    this.path = undefined;
  }

  /** Show a file; nothing where it is not a text. */
  show(path: string | undefined, text: Text | undefined): void {
    if (this.path !== undefined) this.#states.set(this.path, this.view.state);
    this.path = text ? path : undefined;
    const known = path === undefined ? undefined : this.#states.get(path);
    // a fix may have changed a file that was not shown
    const state = known && text && known.doc.eq(text) ? known : this.#state(path, text);
    this.view.setState(state);
  }

  /** Change the file that is shown. */
  edit(changes: { from: number; to: number; insert: string }[]): void {
    this.view.dispatch({ changes, userEvent: 'input.fix' });
  }

  select(from: number, to: number): void {
    this.view.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    this.view.focus();
  }

  diagnose(diagnostics: Diagnostic[]): void {
    this.view.dispatch(setDiagnostics(this.view.state, diagnostics));
  }

  #state(path: string | undefined, text: Text | undefined): EditorState {
    const keys = [...defaultKeymap, ...historyKeymap, ...searchKeymap, ...foldKeymap, ...lintKeymap, indentWithTab];
    return EditorState.create({
      doc: text ?? '',
      extensions: [
        common(path ?? ''),
        history(),
        indentOnInput(),
        indentUnit.of('  '),
        highlightActiveLine(),
        lintGutter(),
        keymap.of(keys),
        EditorState.readOnly.of(!text),
        EditorView.contentAttributes.of({ 'aria-label': path ?? 'no text' }),
        EditorView.updateListener.of((update) => {
          if (this.path === undefined) return;
          if (update.docChanged) this.#listener.changed(this.path, update.state.doc);
          if (update.selectionSet || update.docChanged) this.#listener.moved(this.path, update.state.selection.main.head);
        }),
      ],
    });
  }
}
