// Workers that read mesh files: a few, each with one job at a time.

import source from 'mesh-worker';
import type { Answer, Job, Parsed } from './mesh_parts';

/** Leave a processor to the page, and memory to the machine. */
const MOST = Math.max(1, Math.min(3, (navigator.hardwareConcurrency || 2) - 1));

interface Waiting {
  job: Job;
  begin: () => void;
  done: (parsed: Parsed) => void;
  failed: (error: Error) => void;
}

export class Workers {
  private readonly idle: Worker[] = [];
  private readonly queue: Waiting[] = [];
  private started = 0;
  private url: string | undefined;

  /** Read a file; `begin` is called when its turn has come. */
  parse(job: Job, begin: () => void): Promise<Parsed> {
    return new Promise((done, failed) => {
      this.queue.push({ job, begin, done, failed });
      this.next();
    });
  }

  private next(): void {
    const waiting = this.queue[0];
    if (!waiting) return;
    const worker = this.idle.pop() ?? this.start(waiting);
    if (!worker) return;
    this.queue.shift();
    waiting.begin();
    worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      if ('parsed' in data) waiting.done(data.parsed);
      else waiting.failed(new Error(data.error));
      this.idle.push(worker);
      this.next();
    };
    worker.onerror = (event) => {
      event.preventDefault();
      waiting.failed(new Error(event.message || 'meshes cannot be read here: the page may start no worker'));
      worker.terminate();
      this.started--;
      this.next();
    };
    const beside = [waiting.job.bytes];
    worker.postMessage(waiting.job, beside);
  }

  private start(waiting: Waiting): Worker | undefined {
    if (this.started >= MOST) return undefined;
    try {
      this.url ??= URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
      const worker = new Worker(this.url);
      this.started++;
      return worker;
    } catch (error) {
      this.queue.shift();
      waiting.failed(error instanceof Error ? error : new Error(String(error)));
      return undefined;
    }
  }
}
