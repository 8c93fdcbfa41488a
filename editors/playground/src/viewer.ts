// The 3D view: the viewer of the editors in a frame of its own, which is loaded when it is looked at for the first time.

import { el } from './dom';
import type { Program } from './program';

interface Location {
  uri: string;
  range: { start: { line: number; character: number }; end: { line: number; character: number } };
}

export interface Listener {
  open(path: string, from: [line: number, column: number], to: [line: number, column: number]): void;
  root(path: string, args: Record<string, string>): void;
}

type Message =
  | { type: 'ready' }
  | { type: 'select' | 'open'; location?: Location }
  | { type: 'root'; root: { uri: string; args?: Record<string, string> } }
  | { type: 'mesh'; mesh: string };

export class Viewer {
  readonly #parent: HTMLElement;
  readonly #program: Program;
  readonly #listener: Listener;
  #frame: HTMLIFrameElement | undefined;
  #ready = false;
  #last: unknown;
  #theme: 'light' | 'dark' = 'light';

  constructor(parent: HTMLElement, program: Program, listener: Listener) {
    this.#parent = parent;
    this.#program = program;
    this.#listener = listener;
    addEventListener('message', (event: MessageEvent<Message>) => {
      if (event.origin === location.origin && event.source === this.#frame?.contentWindow) void this.#take(event.data);
    });
  }

  get isOpen(): boolean {
    return this.#frame !== undefined;
  }

  /** Load the viewer. */
  open(): void {
    if (this.#frame) return;
    this.#frame = el('iframe', { src: 'viewer.html', title: '3D view of the robot' });
    this.#parent.append(this.#frame);
  }

  /** Show a model, if it changed. */
  update(model: unknown): void {
    if (!model) return;
    this.#last = model;
    if (this.#ready) this.#post(model);
  }

  theme(theme: 'light' | 'dark'): void {
    this.#theme = theme;
    if (this.#ready) this.#post({ type: 'settings', theme });
  }

  /** Outline what the text at a place makes. */
  async mark(path: string, at: { line: number; character: number }): Promise<void> {
    if (!this.#ready) return;
    const selection = await this.#program.ask('select', { location: { uri: path, range: { start: at, end: at } } });
    if (selection) this.#post(selection);
  }

  async #take(message: Message): Promise<void> {
    if (message.type === 'ready') {
      this.#ready = true;
      this.theme(this.#theme);
      if (this.#last) this.#post(this.#last);
    } else if (message.type === 'mesh') {
      const { mesh } = message;
      const answer = await this.#program.ask('mesh', { id: mesh }).then((data) => ({ data }), (error: Error) => ({ error: error.message }));
      this.#post({ type: 'mesh', mesh, ...answer });
    } else if (message.type === 'root') {
      this.#listener.root(message.root.uri, message.root.args ?? {});
    } else if (message.location) {
      const { uri, range: { start, end } } = message.location;
      this.#listener.open(uri, [start.line, start.character], [end.line, end.character]);
    }
  }

  #post(message: unknown): void {
    this.#frame?.contentWindow?.postMessage(message, location.origin);
  }
}
