/**
 * The settings that the server gets: only those that somebody has set.
 *
 * VS Code answers `workspace/configuration` with the defaults of package.json filled in. Settings of an editor win
 * over `xacro-lint.toml`, so a default must not be sent as if it had been chosen.
 */

/** What `inspect` of a configuration says about one key. */
export interface Inspected {
  globalValue?: unknown;
  workspaceValue?: unknown;
  workspaceFolderValue?: unknown;
}

/** Keys that are the client's own business. */
const OWN = ["xacro.server.", "xacro.trace.", "xacro.expanded."];

/** Values that were set, nested by the parts of their keys, below `xacro`. */
export function chosenSettings(
  keys: readonly string[],
  inspect: (key: string) => Inspected | undefined,
): Record<string, unknown> {
  const chosen: Record<string, unknown> = {};
  for (const key of keys) {
    if (OWN.some((prefix) => key.startsWith(prefix))) continue;
    const found = inspect(key);
    const value = merged([found?.globalValue, found?.workspaceValue, found?.workspaceFolderValue]);
    if (value !== undefined) put(chosen, key.split(".").slice(1), value);
  }
  return chosen;
}

/** The innermost value; objects are merged, as VS Code does. */
function merged(values: unknown[]): unknown {
  return values.reduce((below, value) => {
    if (value === undefined) return below;
    return isObject(below) && isObject(value) ? { ...below, ...value } : value;
  }, undefined);
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function put(into: Record<string, unknown>, parts: string[], value: unknown): void {
  const [first, ...rest] = parts;
  if (first === undefined) return;
  if (rest.length === 0) {
    into[first] = value;
    return;
  }
  const below = into[first];
  const next = isObject(below) ? below : {};
  into[first] = next;
  put(next, rest, value);
}
