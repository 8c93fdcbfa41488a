// Files from elsewhere: folders and zip archives that are dropped or opened; and the way back.

import { unzipSync, zipSync } from 'fflate';

const MOST_FILES = 2000;
const MOST_BYTES = 64 * 2 ** 20;
/** Folders of version control and of build tools. */
const LEFT_OUT = /(^|\/)(\.git|\.hg|\.svn|node_modules|build|install|log|__pycache__|__MACOSX)\//;

export interface Loaded {
  files: Record<string, Uint8Array>;
  /** What was not taken, as a sentence; empty: everything was. */
  left: string;
}

class Collection {
  readonly files: Record<string, Uint8Array> = {};
  #count = 0;
  #bytes = 0;
  #left = 0;

  /** Whether there is room for another file. */
  takes(path: string, size: number): boolean {
    if (LEFT_OUT.test(path)) return false;
    if (this.#count >= MOST_FILES || this.#bytes + size > MOST_BYTES) {
      this.#left++;
      return false;
    }
    this.#count++;
    this.#bytes += size;
    return true;
  }

  done(): Loaded {
    const left = this.#left ? `${this.#left} files left out: at most ${MOST_FILES} files and ${MOST_BYTES / 2 ** 20} MB are taken` : '';
    return { files: this.files, left };
  }
}

/** The files of a zip archive. */
export function unpack(bytes: Uint8Array): Loaded {
  const all = new Collection();
  const files = unzipSync(bytes, { filter: ({ name, originalSize }) => !name.endsWith('/') && all.takes(name, originalSize) });
  Object.assign(all.files, files);
  return all.done();
}

export function pack(files: Record<string, Uint8Array>): Uint8Array {
  return zipSync(files, { level: 6 });
}

/** The files of a list, by their paths in the folder that was opened. */
export async function read(list: Iterable<File>): Promise<Loaded> {
  const all = new Collection();
  for (const file of list) {
    const path = file.webkitRelativePath || file.name;
    if (!all.takes(path, file.size)) continue;
    all.files[path] = new Uint8Array(await file.arrayBuffer());
  }
  return all.done();
}

/** What was dropped: files, folders, or one zip archive. */
export async function dropped(transfer: DataTransfer): Promise<Loaded> {
  // the list is empty after the first wait
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
  const files = [...transfer.files];
  const [first] = files;
  if (files.length === 1 && first?.name.endsWith('.zip')) return unpack(new Uint8Array(await first.arrayBuffer()));
  if (!entries.some((entry) => entry.isDirectory)) return read(files);
  const all = new Collection();
  for (const entry of entries) await walk(entry, '', all);
  return all.done();
}

async function walk(entry: FileSystemEntry, folder: string, all: Collection): Promise<void> {
  const path = folder + entry.name;
  if (LEFT_OUT.test(`${path}/`)) return;
  if (entry.isFile) {
    const file = await new Promise<File>((done, failed) => (entry as FileSystemFileEntry).file(done, failed));
    if (all.takes(path, file.size)) all.files[path] = new Uint8Array(await file.arrayBuffer());
    return;
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  // it gives at most a hundred at a time
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, failed) => reader.readEntries(done, failed));
    if (some.length === 0) return;
    for (const one of some) await walk(one, `${path}/`, all);
  }
}
