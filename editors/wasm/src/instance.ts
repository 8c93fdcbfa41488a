// One instance of a program: bytes in, bytes out.

/** What every program has. */
export interface Shared {
  memory: WebAssembly.Memory;
  input(length: number): number;
  output(): number;
  put(path: number): void;
  remove(): void;
}

interface Questions extends Shared {
  call(): number;
  mesh(): number;
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** A program over files in memory. */
export class Program<E extends Shared> {
  protected readonly exports: E;
  /** What a panic said. */
  panic: string | undefined;

  constructor(module: WebAssembly.Module) {
    const host = {
      now: () => performance.now(),
      panicked: (at: number, length: number) => {
        this.panic = decoder.decode(new Uint8Array(this.exports.memory.buffer, at, length));
      },
    };
    this.exports = new WebAssembly.Instance(module, { host }).exports as unknown as E;
  }

  put(path: string, content: Uint8Array): void {
    const name = encoder.encode(path);
    this.write(name, content);
    this.exports.put(name.length);
  }

  remove(path: string): void {
    this.write(encoder.encode(path));
    this.exports.remove();
  }

  protected write(...parts: Uint8Array[]): void {
    const length = parts.reduce((all, part) => all + part.length, 0);
    let at = this.exports.input(length);
    for (const part of parts) {
      new Uint8Array(this.exports.memory.buffer, at, part.length).set(part);
      at += part.length;
    }
  }

  /** The bytes of an answer; its first byte says whether it is an error. */
  protected answer(length: number): Uint8Array {
    const bytes = new Uint8Array(this.exports.memory.buffer, this.exports.output(), length);
    if (bytes[0] === 1) throw new Error(decoder.decode(bytes.subarray(1)));
    return bytes.subarray(1);
  }
}

/** The program that answers single questions. */
export class Instance extends Program<Questions> {
  call(question: string): string {
    this.write(encoder.encode(question));
    return decoder.decode(this.answer(this.exports.call()));
  }

  mesh(id: string): Uint8Array {
    this.write(encoder.encode(id));
    return this.answer(this.exports.mesh()).slice();
  }
}
