// What the page and the worker, in which the program runs, say to each other.

import type { Expanded, Finding, Fixed } from '../../wasm/src/types';

/** What is to be checked and shown. */
export interface Question {
  robot: string | undefined;
  args: Record<string, string>;
  /** Rules that run besides the default ones. */
  extendSelect: string[];
  /** Whether the 3D view is open. */
  model: boolean;
}

/** Files that changed since the last question; null for files that are gone. */
export type Changes = [path: string, content: string | Uint8Array | null][];

/** All that is known of the files as they are. */
export interface Answer {
  findings: Finding[];
  /** What keeps the files from being checked. */
  error?: string;
  robots: string[];
  robot: string | undefined;
  expanded: Expanded | undefined;
  /** A message for the viewer; absent while the model stays as it is. */
  model?: unknown;
  /** Time that the check took, in milliseconds. */
  time: number;
}

export interface Calls {
  start: { take: { wasm: string }; give: string };
  update: { take: { changes: Changes; question: Question }; give: Answer };
  fix: { take: { extendSelect: string[]; args: Record<string, string> }; give: Fixed };
  select: { take: Record<string, unknown>; give: unknown };
  mesh: { take: { id: string }; give: Uint8Array };
}

export interface Request<K extends keyof Calls = keyof Calls> {
  id: number;
  name: K;
  take: Calls[K]['take'];
}

export interface Reply {
  id: number;
  give?: unknown;
  error?: string;
}
