// The files, and what is asked about them.

import { Text } from '@codemirror/state';
import { range } from './places';
import type { Fix } from '../../wasm/src/types';

export type Content = Text | Uint8Array;

/** What a link or an example holds. */
export interface Stored {
  files: Record<string, string | Uint8Array>;
  open?: string;
  robot?: string;
  args?: Record<string, string>;
  extendSelect?: string[];
  /** The example that the files began with; links hold only what differs. */
  example?: string;
}

const decoder = new TextDecoder('utf-8', { fatal: true });

/** Files that are shown as text, whatever their names: those that are text. */
export function contentOf(bytes: string | Uint8Array): Content {
  if (typeof bytes === 'string') return Text.of(bytes.split(/\r\n?|\n/));
  if (bytes.subarray(0, 8000).includes(0) || bytes.length > 2_000_000) return bytes;
  try {
    return contentOf(decoder.decode(bytes));
  } catch {
    return bytes;
  }
}

export class Project {
  readonly files = new Map<string, Content>();
  /** The texts as they were when the project was opened. */
  before = new Map<string, Content>();
  open: string | undefined;
  robot: string | undefined;
  args: Record<string, string> = {};
  extendSelect: string[] = [];
  example: string | undefined;
  /** Files that the program has not seen as they are. */
  readonly changed = new Set<string>();

  /** Have other files. */
  load(stored: Stored): void {
    for (const path of this.files.keys()) this.changed.add(path);
    this.files.clear();
    for (const [path, content] of Object.entries(stored.files).sort(([a], [b]) => (a < b ? -1 : 1))) this.put(path, contentOf(content));
    this.before = new Map(this.files);
    this.robot = stored.robot;
    this.args = { ...stored.args };
    this.extendSelect = [...(stored.extendSelect ?? [])];
    this.example = stored.example;
    this.open = stored.open ?? this.first();
  }

  put(path: string, content: Content): void {
    this.files.set(path, content);
    this.changed.add(path);
  }

  remove(path: string): void {
    this.files.delete(path);
    this.changed.add(path);
    if (this.open === path) this.open = this.first();
  }

  text(path: string): Text | undefined {
    const content = this.files.get(path);
    return content instanceof Uint8Array ? undefined : content;
  }

  /** The files that the program has not seen. */
  takeChanges(): [string, string | Uint8Array | null][] {
    const paths = [...this.changed];
    this.changed.clear();
    return paths.map((path) => {
      const content = this.files.get(path);
      return [path, content === undefined ? null : content instanceof Uint8Array ? content : content.toString()];
    });
  }

  /** The edits of a fix, by file. */
  edits(fix: Fix): Map<string, { from: number; to: number; insert: string }[]> {
    const edits = new Map<string, { from: number; to: number; insert: string }[]>();
    for (const edit of fix.edits) {
      const text = this.text(edit.filename);
      if (!text) continue;
      const list = edits.get(edit.filename) ?? [];
      list.push({ ...range(text, edit), insert: edit.content });
      edits.set(edit.filename, list);
    }
    return edits;
  }

  private first(): string | undefined {
    const texts = [...this.files.keys()].filter((path) => this.text(path));
    return texts.find((path) => /\.(urdf|xacro)$/.test(path)) ?? texts[0];
  }
}
