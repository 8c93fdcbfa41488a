/**
 * Reading the expanded text: which link a line belongs to.
 */

/** A link or joint that starts on a line of the expanded text. */
const START = /^\s*<(link|joint|gazebo|ros2_control)\b[^>]*?(?:\s(?:name|reference)="([^"]*)")?[^>]*>/;
const CHILD = /<child\s[^>]*link="([^"]*)"/;
const END = /<\/(?:joint|ros2_control)>/;

/**
 * The link that a line belongs to: the one it lies in, the child of the joint it lies in, or the one that a
 * gazebo block names.
 */
export function linkOfLine(lines: readonly string[], line: number): string | undefined {
  for (let at = Math.min(line, lines.length - 1); at >= 0; at--) {
    const start = START.exec(lines[at] ?? "");
    if (!start) continue;
    const [, element, name] = start;
    if (element === "ros2_control") return undefined;
    if (element !== "joint") return name;
    const child = childOfJoint(lines, at);
    // joints inside ros2_control and transmissions have no child
    if (child !== undefined || line === at) return child;
  }
  return undefined;
}

function childOfJoint(lines: readonly string[], from: number): string | undefined {
  for (let at = from; at < lines.length; at++) {
    const text = lines[at] ?? "";
    const child = CHILD.exec(text);
    if (child) return child[1];
    if (END.test(text)) return undefined;
  }
  return undefined;
}

/** A call of a macro for a list, from a title such as "macro `leg` in `leg` at robot.xacro:7". */
export function callText(title: string): string {
  const [, name, place] = /^macro `([^`]*)` in .*? at (\S+)$/.exec(title) ?? [];
  return name === undefined || place === undefined ? title : `${name} @ ${place}`;
}

/** The first link in an expanded text. */
export function firstLink(text: string): string | undefined {
  return /<link\s[^>]*?\bname="([^"]*)"/.exec(text)?.[1];
}

/** The line in words that says what is wrong with a text that is older than its sources. */
export function bannerText(errors: number, time: Date): string {
  const clock = [time.getHours(), time.getMinutes(), time.getSeconds()]
    .map((part) => String(part).padStart(2, "0"))
    .join(":");
  return `${errors} ${errors === 1 ? "error" : "errors"} in the sources: this is the robot as of ${clock}`;
}
