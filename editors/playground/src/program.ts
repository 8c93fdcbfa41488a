// The program in its worker, as the page calls it.

import type { Calls, Reply } from './messages';

export class Program {
  readonly #worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
  readonly #waiting = new Map<number, { done: (value: never) => void; failed: (error: Error) => void }>();
  #last = 0;

  constructor() {
    this.#worker.addEventListener('message', (event: MessageEvent<Reply>) => {
      const { id, give, error } = event.data;
      const waiting = this.#waiting.get(id);
      this.#waiting.delete(id);
      if (error === undefined) waiting?.done(give as never);
      else waiting?.failed(new Error(error));
    });
    this.#worker.addEventListener('error', (event) => {
      for (const { failed } of this.#waiting.values()) failed(new Error(event.message || 'the program cannot be loaded'));
      this.#waiting.clear();
    });
  }

  ask<K extends keyof Calls>(name: K, take: Calls[K]['take']): Promise<Calls[K]['give']> {
    const id = ++this.#last;
    return new Promise((done, failed) => {
      this.#waiting.set(id, { done: done as (value: never) => void, failed });
      this.#worker.postMessage({ id, name, take });
    });
  }
}
