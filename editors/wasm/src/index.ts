// Checks and expands robots whose files are in memory.

import { Instance } from './instance.js';
import type { CheckOptions, Expanded, Files, Finding, Fixed, Robot } from './types.js';

export type * from './types.js';

/** Where the program comes from: its bytes, a compiled module, or an address to fetch. */
export type Source = BufferSource | WebAssembly.Module | URL | string;

/** Files, and answers about them. What was made of files that did not change is kept from call to call. */
export class Linter {
  readonly #module: WebAssembly.Module;
  readonly #files = new Map<string, Uint8Array>();
  #instance: Instance;

  private constructor(module: WebAssembly.Module) {
    this.#module = module;
    this.#instance = new Instance(module);
  }

  /** A linter without files. Without a source, the program that lies beside this script. */
  static async create(source?: Source): Promise<Linter> {
    return new Linter(await compiled(source ?? new URL('./xacro_lint.wasm', import.meta.url)));
  }

  /** Put a file there, or other content into it. */
  put(path: string, content: string | Uint8Array): void {
    const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
    this.#files.set(path, bytes);
    this.#instance.put(path, bytes);
  }

  /** Take a file away. */
  remove(path: string): void {
    if (this.#files.delete(path)) this.#instance.remove(path);
  }

  /** Have these files and no others. */
  replace(files: Files): void {
    for (const path of [...this.#files.keys()]) if (!(path in files)) this.remove(path);
    for (const [path, content] of Object.entries(files)) this.put(path, content);
  }

  /** The findings, as `xacro-lint check --format json` prints them. */
  check(options: CheckOptions = {}): Finding[] {
    return this.call<Finding[]>({ call: 'check', ...options });
  }

  /** What `xacro-lint check --fix` would write; the files here stay as they are. */
  fix(options: CheckOptions & { unsafeFixes?: boolean } = {}): Fixed {
    return this.call<Fixed>({ call: 'fix', ...options });
  }

  /** The expanded text of a robot, byte for byte as xacro prints it, with the source of each piece. */
  expand(file: string, args: Record<string, string> = {}, options: Omit<Robot, 'file' | 'args'> = {}): Expanded {
    return this.call<Expanded>({ call: 'expand', file, args, ...options });
  }

  /** The files that are robots by themselves. */
  robots(): string[] {
    return this.call<string[]>({ call: 'robots' });
  }

  /** The version of the program. */
  version(): string {
    return this.call<string>({ call: 'version' });
  }

  /** The bytes of a file that the last model names. */
  mesh(id: string): Uint8Array {
    return this.#guarded((instance) => instance.mesh(id));
  }

  /** Ask anything that the program knows; the other methods say how. */
  call<T>(question: Record<string, unknown>): T {
    return JSON.parse(this.#guarded((instance) => instance.call(JSON.stringify(question)))) as T;
  }

  /** What breaks an instance, as texts that nest deeper than the stack admits, does not break the next call. */
  #guarded<T>(work: (instance: Instance) => T): T {
    try {
      return work(this.#instance);
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError) && !(error instanceof RangeError)) throw error;
      const why = this.#instance.panic ?? String(error);
      this.#instance = new Instance(this.#module);
      for (const [path, bytes] of this.#files) this.#instance.put(path, bytes);
      const nested = error instanceof RangeError;
      throw new Error(nested ? 'the robot nests more deeply than the stack of this program admits' : `internal error: ${why}`);
    }
  }
}

/** Check files once. */
export async function check(files: Files, options: CheckOptions = {}): Promise<Finding[]> {
  return (await linter(files)).check(options);
}

/** Expand a robot once; `file` is its path in `files`. */
export async function expand(files: Files, file: string, args: Record<string, string> = {}): Promise<Expanded> {
  return (await linter(files)).expand(file, args);
}

let shared: Promise<Linter> | undefined;

async function linter(files: Files): Promise<Linter> {
  const one = await (shared ??= Linter.create());
  one.replace(files);
  return one;
}

async function compiled(source: Source): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (typeof source !== 'string' && !(source instanceof URL)) return WebAssembly.compile(source);
  const url = new URL(source, import.meta.url);
  if (url.protocol === 'file:') {
    // not for bundlers: in a browser nothing is read from a disk
    const fs = 'node:fs/promises';
    const { readFile } = (await import(/* @vite-ignore */ fs)) as typeof import('node:fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url.href}: ${answer.status} ${answer.statusText}`);
  // compiled while it arrives, which a server has to allow by the type that it gives
  const isNamed = answer.headers.get('content-type')?.startsWith('application/wasm');
  return isNamed ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}
