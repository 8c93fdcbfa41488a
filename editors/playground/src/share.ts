// Links that hold files: JSON, compressed, in the part of the address behind `#`, which browsers do not send.

import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';
import type { Project, Stored } from './project';

/** Longer links do not pass through many programs. */
export const MOST = 100_000;
/** A link may say that it unpacks to anything: no more is read of it. */
const MOST_BYTES = 16 * 2 ** 20;

interface Shared {
  /** Format of the rest. */
  v: 1;
  example?: string;
  /** Texts; null for files of the example that are gone. */
  files: Record<string, string | null>;
  /** Other files, as base64. */
  data?: Record<string, string>;
  open?: string;
  robot?: string;
  args?: Record<string, string>;
  select?: string[];
}

/** The address of the present state; `whole` is false when other files than texts had to be left out. */
export function link(project: Project): { fragment: string; whole: boolean } {
  const shared: Shared = { v: 1, files: {} };
  const data: Record<string, string> = {};
  for (const [path, content] of project.files) {
    if (project.example !== undefined && project.before.get(path) === content) continue;
    if (content instanceof Uint8Array) data[path] = base64(content);
    else shared.files[path] = content.toString();
  }
  if (project.example !== undefined) {
    shared.example = project.example;
    for (const path of project.before.keys()) if (!project.files.has(path)) shared.files[path] = null;
  }
  if (project.open !== undefined) shared.open = project.open;
  if (project.robot !== undefined) shared.robot = project.robot;
  if (Object.keys(project.args).length > 0) shared.args = project.args;
  if (project.extendSelect.length > 0) shared.select = project.extendSelect;
  const withData = Object.keys(data).length > 0 ? encode({ ...shared, data }) : encode(shared);
  if (withData.length <= MOST) return { fragment: `#files=${withData}`, whole: true };
  return { fragment: `#files=${encode(shared)}`, whole: Object.keys(data).length === 0 };
}

/** What a link holds. `example` gives the files that it began with. */
export async function read(text: string, example: (name: string) => Promise<Stored>): Promise<Stored> {
  const shared = decode(text);
  const begin = shared.example === undefined ? { files: {} } : await example(shared.example);
  const files: Record<string, string | Uint8Array> = { ...begin.files };
  for (const [path, content] of Object.entries(shared.files)) {
    if (content === null) delete files[path];
    else files[path] = content;
  }
  for (const [path, content] of Object.entries(shared.data ?? {})) files[path] = bytes(content);
  return {
    files,
    ...(shared.open === undefined ? {} : { open: shared.open }),
    ...(shared.robot === undefined ? {} : { robot: shared.robot }),
    args: shared.args ?? {},
    extendSelect: shared.select ?? [],
  };
}

function encode(shared: Shared): string {
  return base64(deflateSync(strToU8(JSON.stringify(shared)), { level: 9 })).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function decode(text: string): Shared {
  const packed = bytes(text.replaceAll('-', '+').replaceAll('_', '/'));
  // one byte more than may be used tells a text that is too long
  const room = new Uint8Array(Math.min(MOST_BYTES, packed.length * 1100 + 64));
  const shared: unknown = JSON.parse(strFromU8(inflateSync(packed, { out: room })));
  if (typeof shared !== 'object' || shared === null || !('v' in shared) || shared.v !== 1) throw new Error('another format');
  const { files, data, args, select } = shared as Partial<Shared>;
  const texts = [...Object.values(files ?? {}), ...Object.values(data ?? {}), ...Object.values(args ?? {}), ...(select ?? [])];
  if (!files || texts.some((one) => one !== null && typeof one !== 'string')) throw new Error('another format');
  return shared as Shared;
}

function base64(data: Uint8Array): string {
  let text = '';
  for (const byte of data) text += String.fromCharCode(byte);
  return btoa(text);
}

function bytes(text: string): Uint8Array {
  const raw = atob(text);
  return Uint8Array.from(raw, (letter) => letter.charCodeAt(0));
}
