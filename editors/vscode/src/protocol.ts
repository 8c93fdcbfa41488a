/**
 * What the server understands besides the Language Server Protocol. docs/lsp.md of the repository describes it.
 */
import { NotificationType, RequestType } from "vscode-languageclient";
import type { Location, Position, Range, TextDocumentIdentifier } from "vscode-languageclient";

/** A robot: its entry file and what it is run with. */
export interface Root {
  uri: string;
  args?: Record<string, string>;
  preset?: string;
  label?: string;
}

/** What kept an expansion from being complete. */
export interface ExpandError {
  message: string;
  code: string;
  location: Location;
  stack?: { name: string; location: Location }[];
}

export interface ExpandParams {
  textDocument: TextDocumentIdentifier;
  root?: Root;
  args?: Record<string, string>;
  sourceMap?: boolean;
  /** Expand what is on the disk, with these texts in place of some files; by URI. */
  texts?: Record<string, string>;
}

export interface Expanded {
  ok: boolean;
  urdf: string;
  root: Root;
  args: Record<string, string>;
  errors: ExpandError[];
  ms: number;
}

export interface ExpandAtParams {
  textDocument: TextDocumentIdentifier;
  position: Position;
  root?: Root;
  instance?: number;
}

export interface ExpandedAt {
  kind: "macro" | "expression" | "property" | "include" | "condition" | "block";
  title: string;
  range: Range;
  expanded: string;
  instances: number;
}

export type Role = "origin" | "call" | "argument" | "include";

export interface SourceLocation extends Location {
  role: Role;
}

export interface Instance {
  /** In the expanded text. */
  range: Range;
  label: string;
}

export interface Argument {
  name: string;
  value?: string;
  default?: string;
  doc?: string;
}

export interface Roots {
  active: Root | null;
  reason: string;
  candidates: (Root & { distance: number })[];
  args: Argument[];
}

export interface TreeNode {
  link: string;
  joint?: string;
  parent?: string;
  location: Location;
  /** kg */
  mass?: number;
}

/** A file that names links and joints of the robot. */
export interface FileBeside {
  uri: string;
  /** `srdf`, `controllers`, `joint-limits` and so on. */
  kind: string;
}

export interface Tree {
  nodes: TreeNode[];
  beside: FileBeside[];
  problems: ExpandError[];
}

export interface ContextChanged {
  textDocument: TextDocumentIdentifier;
  active: Root | null;
  text: string;
  /** The call of a macro of the file that was picked, such as `leg @ robot.urdf.xacro:41`. */
  instance: string | null;
}

export const expand = new RequestType<ExpandParams, Expanded, void>("xacro/expand");
export const expandAt = new RequestType<ExpandAtParams, ExpandedAt | null, void>("xacro/expandAt");
export const toSource = new RequestType<
  { root: string; position: Position },
  { locations: SourceLocation[] },
  void
>("xacro/toSource");
export const toExpanded = new RequestType<
  { textDocument: TextDocumentIdentifier; position: Position; root?: Root },
  { root: Root; instances: Instance[] },
  void
>("xacro/toExpanded");
/** The last lines of the server's log. */
export const log = new RequestType<null, string[], void>("xacro/log");
export const roots = new RequestType<{ textDocument: TextDocumentIdentifier }, Roots, void>("xacro/roots");
export const setRoot = new RequestType<
  { root: Root | null; textDocument?: TextDocumentIdentifier },
  null,
  void
>("xacro/setRoot");
export const setInstance = new RequestType<
  { textDocument: TextDocumentIdentifier; position: Position; instance: number | null },
  null,
  void
>("xacro/setInstance");
export const tree = new RequestType<{ root?: Root; textDocument?: TextDocumentIdentifier }, Tree, void>(
  "xacro/tree",
);
export const contextChanged = new NotificationType<ContextChanged>("xacro/contextChanged");
