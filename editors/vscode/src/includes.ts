/**
 * Includes in a text, as far as the text alone tells.
 */

/** An include in a text: what its file name says, and where the value stands. */
export interface Include {
  filename: string;
  line: number;
  start: number;
  end: number;
}

/** The includes of a text, those in comments left out. */
export function includesOf(text: string): Include[] {
  const visible = text.replace(/<!--[^]*?(?:-->|$)/g, (comment) => comment.replace(/[^\n]/g, " "));
  const found: Include[] = [];
  for (const match of visible.matchAll(/<[\w-]+:include\b[^>]*?\bfilename\s*=\s*(["'])([^]*?)\1/g)) {
    const filename = match[2] ?? "";
    const at = match.index + match[0].length - 1 - filename.length;
    const before = visible.slice(0, at);
    const start = at - (before.lastIndexOf("\n") + 1);
    found.push({ filename, line: before.split("\n").length - 1, start, end: start + filename.length });
  }
  return found;
}
