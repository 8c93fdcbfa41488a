// What the playground begins with: an example, the bad example of a rule, or the files of a link.

import { unpack } from './archive';
import type { Stored } from './project';
import { read } from './share';

export interface Example {
  name: string;
  title: string;
  open: string;
  robot?: string;
}

interface Rule {
  files: Record<string, string>;
  data?: Record<string, string>;
}

async function fetched(path: string): Promise<Response> {
  const answer = await fetch(new URL(path, import.meta.url));
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer;
}

let known: Promise<Example[]> | undefined;

/** The examples, asked for once. */
export function examples(): Promise<Example[]> {
  return (known ??= fetched('examples.json').then((answer) => answer.json() as Promise<Example[]>));
}

export async function example(name: string): Promise<Stored> {
  const found = (await examples()).find((one) => one.name === name);
  if (!found) throw new Error(`there is no example \`${name}\``);
  const { files } = unpack(new Uint8Array(await (await fetched(`examples/${name}.zip`)).arrayBuffer()));
  return { files, open: found.open, example: name, ...(found.robot === undefined ? {} : { robot: found.robot }) };
}

async function rule(name: string): Promise<Stored> {
  const rules = (await (await fetched('rules.json')).json()) as Record<string, Rule>;
  const found = Object.hasOwn(rules, name) ? rules[name] : undefined;
  if (!found) throw new Error(`there is no rule \`${name}\``);
  const files: Record<string, string | Uint8Array> = { ...found.files };
  for (const [path, text] of Object.entries(found.data ?? {})) files[path] = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return { files, extendSelect: [name], open: Object.keys(found.files)[0] ?? '' };
}

/** What the address asks for. */
export function asked(fragment: string): Promise<Stored> {
  const wish = new URLSearchParams(fragment.replace(/^#/, ''));
  const [files, ruleName, exampleName] = ['files', 'rule', 'example'].map((name) => wish.get(name));
  if (files) return read(files, example).catch(() => { throw new Error('the link is damaged: parts of it are missing'); });
  if (ruleName) return rule(ruleName);
  return example(exampleName || FIRST);
}

export const FIRST = 'broken_cell';
