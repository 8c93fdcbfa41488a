/**
 * What `xacro-lint check --format json` prints, and how it is called.
 */

export interface Spot {
  file: string;
  /** From zero. */
  line: number;
  column: number;
  endLine: number;
  endColumn: number;
}

export interface Finding extends Spot {
  rule: string;
  severity: string;
  message: string;
  related: (Spot & { message: string })[];
}

/** A finding as the language server shows it. */
export interface Shown {
  rule: string;
  message: string;
  file: string;
  line: number;
}

/** The command line of a check with the settings that were chosen in the editor. */
export function checkArguments(settings: Readonly<Record<string, unknown>>, more: readonly string[]): string[] {
  const chosen = Object.keys(settings).length > 0 ? ["--settings", JSON.stringify(settings)] : [];
  return ["check", "--format", "json", ...chosen, ...more];
}

/** The findings in an output; `undefined` when it holds none, not even an empty list. */
export function findingsOf(output: string): Finding[] | undefined {
  let list: unknown;
  try {
    list = JSON.parse(output);
  } catch {
    return undefined;
  }
  if (!Array.isArray(list)) return undefined;
  return list.map(record).map((one) => ({
    ...spot(one),
    rule: text(one.name),
    severity: text(one.severity),
    message: text(one.message),
    related: (Array.isArray(one.related) ? one.related : [])
      .map(record)
      .map((place) => ({ ...spot(place), message: text(place.message) })),
  }));
}

/** A finding in one line, as compilers write them. */
export function lineOf({ file, line, column, severity, message, rule }: Finding): string {
  return `${file}:${line + 1}:${column + 1}: ${severity}: ${message} [${rule}]`;
}

/** The findings in words. */
export function summary(findings: readonly Finding[]): string {
  if (findings.length === 0) return "no findings";
  const counts = ["error", "warning", "info", "hint"].map((severity) => ({
    severity: severity === "info" ? "note" : severity,
    count: findings.filter((finding) => finding.severity === severity).length,
  }));
  const parts = counts.filter(({ count }) => count > 0).map(({ severity, count }) => counted(count, severity));
  return `${parts.join(", ")} in ${counted(new Set(findings.map(({ file }) => file)).size, "file")}`;
}

/**
 * Whether the server shows a finding already: with the same rule, where it is or at one of the calls that lead to it.
 * The message of the command line may go on with the roots that it is about.
 */
export function isShown(finding: Finding, shown: readonly Shown[]): boolean {
  const places = [finding, ...finding.related];
  return shown.some(
    ({ rule, message, file, line }) =>
      rule === finding.rule &&
      places.some((place) => place.file === file && place.line === line) &&
      ((finding.file === file && finding.line === line) || finding.message.startsWith(message)),
  );
}

/** `1 file`, `2 files`. */
export function counted(count: number, thing: string): string {
  return `${count} ${thing}${count === 1 ? "" : "s"}`;
}

function spot(one: Record<string, unknown>): Spot {
  const [start, end] = [record(one.location), record(one.end_location)];
  const at = (value: unknown): number => (typeof value === "number" && value >= 1 ? value - 1 : 0);
  return {
    file: text(one.filename),
    line: at(start.row),
    column: at(start.column),
    endLine: Math.max(at(start.row), at(end.row)),
    endColumn: at(end.column),
  };
}

function record(value: unknown): Record<string, unknown> {
  return typeof value === "object" && value !== null ? (value as Record<string, unknown>) : {};
}

function text(value: unknown): string {
  return typeof value === "string" ? value : "";
}
