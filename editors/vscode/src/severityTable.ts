/**
 * The severity of a rule in the text of xacro-lint.toml.
 */

/** A replacement of whole lines, by numbers from zero; `to` is excluded. */
export interface LineEdit {
  from: number;
  to: number;
  text: string;
}

/** The smallest change that gives a rule a severity; comments stay. */
export function severityEdit(text: string, rule: string, severity: string): LineEdit | undefined {
  const lines = text.split(/\r?\n/);
  // without an end of the last line there is no line to put anything in front of
  if (text !== "" && lines.at(-1) !== "") return severityEdit(`${text}\n`, rule, severity);
  const header = lines.findIndex((line) => /^\s*\[\s*severity\s*\]/.test(line));
  const top = lines.findIndex((line) => /^\s*\[/.test(line));
  const before = lines.slice(0, top < 0 ? lines.length : top);
  // a table in another form is left to the user
  if (header < 0 && before.some((line) => /^\s*severity\s*[.=]/.test(line))) return undefined;
  const entry = `${rule} = "${severity}"`;
  if (header < 0) {
    const last = lines.length - 1;
    const gap = text.trim() === "" ? "" : "\n";
    return { from: last, to: last, text: `${gap}[severity]\n${entry}\n` };
  }
  const next = lines.findIndex((line, at) => at > header && /^\s*\[/.test(line));
  const end = next < 0 ? lines.length : next;
  const known = lines.findIndex((line, at) => at > header && at < end && new RegExp(`^\\s*["']?${rule}["']?\\s*=`).test(line));
  if (known < 0) return { from: header + 1, to: header + 1, text: `${entry}\n` };
  const changed = (lines[known] ?? "").replace(/=\s*(?:"[^"]*"|'[^']*')/, `= "${severity}"`);
  return { from: known, to: known + 1, text: `${changed}\n` };
}
