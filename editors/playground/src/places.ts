// Places: rows and columns of findings, lines and units of the editor.

import type { Text } from '@codemirror/state';
import type { Position } from '../../wasm/src/types';

/** The offset of a row and a column, both from 1; columns count characters, the editor counts units of UTF-16. */
export function offset(text: Text, { row, column }: Position): number {
  if (row > text.lines) return text.length;
  const line = text.line(Math.max(1, row));
  let at = 0;
  for (let left = column - 1; left > 0 && at < line.length; left--) {
    at += (line.text.codePointAt(at) ?? 0) > 0xffff ? 2 : 1;
  }
  return line.from + Math.min(at, line.length);
}

/** The range between two places. */
export function range(text: Text, place: { location: Position; end_location: Position }): { from: number; to: number } {
  const from = offset(text, place.location);
  return { from, to: Math.max(from, offset(text, place.end_location)) };
}

/** The offset of a line and a column, both from 0 and in units of UTF-16. */
export function at(text: Text, line: number, column: number): number {
  if (line >= text.lines) return text.length;
  const { from, length } = text.line(line + 1);
  return from + Math.min(column, length);
}

/** The line and the column of an offset, both from 0. */
export function lineOf(text: Text, position: number): { line: number; character: number } {
  const line = text.lineAt(Math.min(position, text.length));
  return { line: line.number - 1, character: position - line.from };
}
