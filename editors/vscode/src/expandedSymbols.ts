/**
 * The outline of an expanded text.
 */

export interface Symbol {
  /** The element: `link`, `joint` and so on. */
  element: string;
  name: string;
  /** What the element says besides: the type of a joint, the links it connects. */
  detail: string;
  /** Lines, from zero. */
  first: number;
  last: number;
  children: Symbol[];
}

/** Elements that stand in the outline. */
const SHOWN = new Set(["robot", "link", "joint", "gazebo", "transmission", "ros2_control", "sensor", "plugin", "material"]);
const TAG = /<!--[\s\S]*?-->|<(\/?)([\w:.-]+)((?:\s+[\w:.-]+\s*=\s*(?:"[^"]*"|'[^']*'))*)\s*(\/?)>/g;

/** The elements of a text that have a name, nested as they are. */
export function symbolsOf(text: string): Symbol[] {
  const top: Symbol[] = [];
  /** The elements around a place; those that are not shown count too. */
  const open: { tag: string; symbol?: Symbol }[] = [];
  const lineAt = lines(text);
  for (const { 0: all, index, 1: end, 2: tag = "", 3: attributes = "", 4: selfClosed } of text.matchAll(TAG)) {
    if (tag === "") continue;
    if (end === "/") {
      const closed = open.pop();
      if (closed?.symbol) closed.symbol.last = lineAt(index);
      continue;
    }
    const parent = open.findLast(({ symbol }) => symbol)?.symbol;
    const symbol = symbolFor(tag, attributes, parent);
    if (symbol) {
      symbol.first = lineAt(index);
      symbol.last = lineAt(index + all.length);
      (parent?.children ?? top).push(symbol);
    } else if (parent?.element === "joint" && (tag === "parent" || tag === "child")) {
      parent.detail += `${tag === "parent" ? ", " : " → "}${attribute(attributes, "link")}`;
    }
    if (selfClosed !== "/") open.push(symbol ? { tag, symbol } : { tag });
  }
  return top;
}

/** The symbols around a line, outermost first. */
export function symbolsAt(symbols: readonly Symbol[], line: number): Symbol[] {
  const found = symbols.find(({ first, last }) => first <= line && line <= last);
  return found ? [found, ...symbolsAt(found.children, line)] : [];
}

function symbolFor(element: string, attributes: string, parent: Symbol | undefined): Symbol | undefined {
  if (!SHOWN.has(element)) return undefined;
  // materials of visuals are names of others
  if (element === "material" && parent?.element !== "robot") return undefined;
  const name = attribute(attributes, "name") || attribute(attributes, "reference") || element;
  return { element, name, detail: attribute(attributes, "type"), first: 0, last: 0, children: [] };
}

function attribute(attributes: string, name: string): string {
  return new RegExp(`\\s${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)')`).exec(attributes)?.slice(1).find(Boolean) ?? "";
}

/** Gives the line of an offset; offsets have to come in order. */
function lines(text: string): (offset: number) => number {
  let [line, at] = [0, 0];
  return (offset) => {
    for (; at < offset; at++) if (text[at] === "\n") line++;
    return line;
  };
}
