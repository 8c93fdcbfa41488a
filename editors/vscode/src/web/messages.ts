/**
 * What the extension and the worker of the server tell each other.
 */

/** Files as they are now, by their paths in the worker. */
export interface Changes {
  put: [path: string, content: Uint8Array][];
  /** Files of which only the names are given. */
  names: string[];
  removed: string[];
}

export type ToWorker = { wasm: Uint8Array } | { files: Changes } | { message: string };

export type FromWorker =
  | { ready: true }
  | { message: string }
  /** The content of these files is needed. */
  | { wanted: string[] }
  /** The server ended. */
  | { failed: string };
