/**
 * The server in its worker: messages in, messages out, and files in memory.
 */
import { Program } from "../../../wasm/src/instance.js";
import type { Shared } from "../../../wasm/src/instance.js";
import type { FromWorker, ToWorker } from "./messages";

interface Exports extends Shared {
  name(): void;
  receive(): void;
  poll(): number;
  outgoing(): number;
  wanted(): number;
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

class LanguageServer extends Program<Exports> {
  name(path: string): void {
    this.write(encoder.encode(path));
    this.exports.name();
  }

  receive(message: string): void {
    this.write(encoder.encode(message));
    this.exports.receive();
  }

  /** Does one piece of work; milliseconds until there is more, or less than zero. */
  poll(): number {
    return this.exports.poll();
  }

  outgoing(): string | undefined {
    const length = this.exports.outgoing();
    return length === 0 ? undefined : decoder.decode(this.answer(length));
  }

  wanted(): string[] {
    const length = this.exports.wanted();
    return length === 0 ? [] : (JSON.parse(decoder.decode(this.answer(length))) as string[]);
  }
}

let server: LanguageServer | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;
let isDue = false;

const tell = (message: FromWorker): void => {
  postMessage(message);
};

// a task of its own for each piece of work, without the pause of a timer: messages that came meanwhile go first
const next = new MessageChannel();
next.port1.onmessage = () => {
  isDue = false;
  guarded(work);
};

function soon(): void {
  clearTimeout(timer);
  if (isDue) return;
  isDue = true;
  next.port2.postMessage(null);
}

function work(running: LanguageServer): void {
  const wait = running.poll();
  for (let message = running.outgoing(); message !== undefined; message = running.outgoing()) tell({ message });
  const wanted = running.wanted();
  if (wanted.length > 0) tell({ wanted });
  if (wait === 0) soon();
  else if (wait > 0) timer = setTimeout(soon, wait);
}

/** After a fault the instance is of no use. */
function guarded(run: (running: LanguageServer) => void): void {
  if (!server) return;
  try {
    run(server);
  } catch (error) {
    const failed = server.panic ?? String(error);
    server = undefined;
    tell({ failed });
  }
}

async function begin(wasm: Uint8Array): Promise<void> {
  try {
    server = new LanguageServer(await WebAssembly.compile(wasm as BufferSource));
    tell({ ready: true });
  } catch (error) {
    tell({ failed: String(error) });
  }
}

addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  if ("wasm" in data) return void begin(data.wasm);
  guarded((running) => {
    if ("message" in data) {
      running.receive(data.message);
      return soon();
    }
    for (const [path, content] of data.files.put) running.put(path, content);
    for (const path of data.files.names) running.name(path);
    for (const path of data.files.removed) running.remove(path);
  });
});
