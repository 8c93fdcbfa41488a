/**
 * Messages of the viewer, checked: what comes out of here has the shape that its type says.
 */
import type { Root } from "./protocol";
import { isFileUri } from "./schemes";

export interface Place {
  uri: string;
  range: { start: { line: number; character: number }; end: { line: number; character: number } };
}

export type FromViewer =
  | { type: "ready" }
  | { type: "select"; link?: string; joint?: string; location?: Place }
  | { type: "open"; location: Place }
  | { type: "root"; root: Root; compare: Root | null }
  | { type: "mesh"; mesh: string }
  | { type: "urdf" };

/** The message, or nothing when it is none of ours. */
export function fromViewer(message: unknown): FromViewer | undefined {
  if (!isObject(message)) return undefined;
  switch (message["type"]) {
    case "ready":
      return { type: "ready" };
    case "urdf":
      return { type: "urdf" };
    case "open": {
      const location = place(message["location"]);
      return location && { type: "open", location };
    }
    case "select":
      return select(message);
    case "root": {
      const root = asRoot(message["root"]);
      return root && { type: "root", root, compare: asRoot(message["compare"]) ?? null };
    }
    case "mesh":
      return typeof message["mesh"] === "string" ? { type: "mesh", mesh: message["mesh"] } : undefined;
    default:
      return undefined;
  }
}

function select(message: Record<string, unknown>): FromViewer {
  const { link, joint } = message;
  const location = place(message["location"]);
  return {
    type: "select",
    ...(typeof link === "string" ? { link } : {}),
    ...(typeof joint === "string" ? { joint } : {}),
    ...(location ? { location } : {}),
  };
}

/** A place in a file; other schemes could name commands. */
function place(value: unknown): Place | undefined {
  if (!isObject(value) || typeof value["uri"] !== "string" || !isFileUri(value["uri"])) return undefined;
  const range = value["range"];
  if (!isObject(range)) return undefined;
  const [start, end] = [position(range["start"]), position(range["end"])];
  return start && end && { uri: value["uri"], range: { start, end } };
}

function position(value: unknown): { line: number; character: number } | undefined {
  if (!isObject(value)) return undefined;
  const { line, character } = value;
  return isIndex(line) && isIndex(character) ? { line, character } : undefined;
}

function asRoot(value: unknown): Root | undefined {
  if (!isObject(value) || typeof value["uri"] !== "string" || !isFileUri(value["uri"])) return undefined;
  const { args, preset } = value;
  const given = isObject(args) ? Object.entries(args).filter((entry): entry is [string, string] => typeof entry[1] === "string") : [];
  return {
    uri: value["uri"],
    ...(given.length > 0 ? { args: Object.fromEntries(given) } : {}),
    ...(typeof preset === "string" ? { preset } : {}),
  };
}

function isIndex(value: unknown): value is number {
  return typeof value === "number" && Number.isSafeInteger(value) && value >= 0;
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
