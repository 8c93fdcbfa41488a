// What goes in and comes out. Findings are those of `xacro-lint check --format json`.

/** Files by their paths, with `/` between folders; text, or the bytes of a mesh. */
export type Files = Record<string, string | Uint8Array>;

/** A place in a text: row and column from 1, columns in characters. */
export interface Position {
  row: number;
  column: number;
}

/** A piece of a file. */
export interface Place {
  filename: string;
  location: Position;
  end_location: Position;
}

export type Severity = 'error' | 'warning' | 'info' | 'hint';

/** What is wrong, at the text that caused it. */
export interface Finding extends Place {
  code: string;
  /** Name of the rule. */
  name: string;
  severity: Severity;
  message: string;
  help: string | null;
  related: (Place & { message: string })[];
  /** How many places the finding is about. */
  places: number;
  fix: Fix | null;
  /** The page of the rule. */
  url: string | null;
}

/** A change that removes a finding. */
export interface Fix {
  applicability: 'safe' | 'unsafe';
  message: string;
  edits: (Place & { content: string })[];
}

/** Options of a check, as those of `xacro-lint check` of the same names. */
export interface CheckOptions {
  /** Files and folders; all files where it is absent. */
  paths?: string[];
  /** Files that are robots even if they look like macro libraries. */
  entry?: string[];
  /** Arguments of the robots. */
  args?: Record<string, string>;
  select?: string[];
  extendSelect?: string[];
  ignore?: string[];
  profile?: string[];
  /** Programs whose limits are reported, too. */
  for?: string[];
  packagePath?: string[];
  config?: string;
  /** Report each location of a cause by itself. */
  noGroup?: boolean;
}

/** Files that fixes change, with their texts afterwards. */
export interface Fixed {
  count: number;
  files: Record<string, string>;
}

/** A robot: a file, with arguments over its defaults. */
export interface Robot {
  file: string;
  args?: Record<string, string>;
  packagePath?: string[];
}

/** Something that xacro would refuse or warn of. */
export interface Problem {
  severity: 'error' | 'warning';
  message: string;
  help: string | null;
  filename: string;
  location: Position;
  end_location: Position;
}

/** Where expanded text comes from. Lines and columns from 0, columns in units of JavaScript strings. */
export interface SourceMap {
  version: number;
  root: string;
  files: string[];
  /** Parent frame, file, start line and column, end line and column of the tag, name; the first is the root. */
  frames: [number, number, number, number, number, number, string][];
  /** Start line and column, end line and column in the expanded text; file, start and end in the source; frame; kind. */
  map: [number, number, number, number, number, number, number, number, number, number, number][];
}

/** An expanded robot; without text and map when there were errors. */
export interface Expanded {
  text: string | null;
  map: SourceMap | null;
  problems: Problem[];
  /** The arguments of the robot with their values. */
  arguments: Record<string, string>;
  /** The files that were read, the robot first. */
  files: string[];
}
