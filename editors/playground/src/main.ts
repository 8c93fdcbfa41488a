// The page: what is shown where, and what happens when something changes.

import type { Text } from '@codemirror/state';
import type { Finding, Fix, Position } from '../../wasm/src/types';
import { dropped, type Loaded, pack, read } from './archive';
import { form } from './arguments';
import { byId, el } from './dom';
import { Editor } from './editor';
import { ExpandedText } from './expanded';
import { list as listFiles } from './files';
import { diagnostics, list as listFindings } from './findings';
import type { Answer } from './messages';
import { at, lineOf, range } from './places';
import { Program } from './program';
import { contentOf, Project, type Stored } from './project';
import { link } from './share';
import { asked, examples, FIRST } from './start';
import { follow } from './theme';
import { Viewer } from './viewer';

const project = new Project();
const program = new Program();
const status = byId('status');
let answer: Answer = { findings: [], robots: [], robot: undefined, expanded: undefined, time: 0 };
let version = '';
/** What has to be read until other files are opened. */
let kept = '';

const editor = new Editor(byId('source'), { changed: edited, moved });
const expanded = new ExpandedText(byId('expanded'), { source: (path, from, to) => openLines(path, from, to) });
const viewer = new Viewer(byId('view'), program, {
  open: openLines,
  root: (path, args) => {
    [project.robot, project.args] = [path, args];
    changed();
  },
});
const findings = { open: openPlace, fix: applyFix };

// ---- what happens

let running = false;
let again = false;

/** Ask the program about the files as they are; while it works, further wishes become one. */
function changed(): void {
  again = true;
  if (!running) void update();
}

async function update(): Promise<void> {
  running = true;
  while (again) {
    again = false;
    const began = performance.now();
    const changes = project.takeChanges();
    const { robot, args, extendSelect } = project;
    try {
      const given = await program.ask('update', { changes, question: { robot, args, extendSelect, model: viewer.isOpen } });
      // a text that was changed since then has its marks moved by the editor until the next answer
      if (project.changed.size === 0) show(given, performance.now() - began);
    } catch (error) {
      say(error instanceof Error ? error.message : String(error));
    }
  }
  running = false;
}

function show(given: Answer, time: number): void {
  answer = given;
  mark();
  byId('problems').replaceChildren(...listFindings(answer.findings, answer.error, findings));
  expanded.update(answer.expanded, answer.error);
  showArguments();
  viewer.update(answer.model);
  showFiles();
  showRobots();
  byId<HTMLButtonElement>('fix').disabled = !answer.findings.some(({ fix }) => fix?.applicability === 'safe');
  const rules = project.extendSelect.length > 0 ? `with the rule ${project.extendSelect.join(', ')}` : '';
  say([kept, rules, `checked in ${Math.round(answer.time)} ms`, `xacro-lint ${version}`, 'nothing leaves this page'].filter(Boolean).join(' · '));
  document.body.dataset['answers'] = String(Number(document.body.dataset['answers'] ?? 0) + 1);
  document.body.dataset['time'] = String(Math.round(time));
}

function mark(): void {
  const text = project.open === undefined ? undefined : project.text(project.open);
  if (project.open !== undefined && text && editor.path === project.open) {
    editor.diagnose(diagnostics(answer.findings, project.open, text, findings));
  }
}

/** A letter was typed. */
function edited(path: string, text: Text): void {
  project.put(path, text);
  changed();
}

let cursor: ReturnType<typeof setTimeout> | undefined;
/** The cursor stands somewhere else: show what is made there. */
function moved(path: string, position: number): void {
  clearTimeout(cursor);
  cursor = setTimeout(() => {
    const text = project.text(path);
    if (!text || byId('result').contains(document.activeElement)) return;
    expanded.mark(path, text, position);
    void viewer.mark(path, lineOf(text, position)).catch(() => undefined);
  }, 50);
}

function open(path: string): void {
  project.open = path;
  editor.show(path, project.text(path));
  mark();
  showFiles();
}

function openPlace(path: string, place: { location: Position; end_location: Position }): void {
  const text = project.text(path);
  if (!text) return;
  if (project.open !== path) open(path);
  const { from, to } = range(text, place);
  pane('source');
  editor.select(from, to);
}

function openLines(path: string, from: [number, number], to: [number, number]): void {
  const text = project.text(path);
  if (!text) return;
  if (project.open !== path) open(path);
  const [start, end] = [at(text, ...from), at(text, ...to)];
  editor.select(start, Math.max(start, end));
}

function applyFix(fix: Fix): void {
  // the places of the fix are those of the text before
  if (running) return;
  for (const [path, edits] of project.edits(fix)) {
    if (path === editor.path) {
      editor.edit(edits);
      continue;
    }
    const before = project.text(path)?.toString() ?? '';
    const sorted = edits.sort((a, b) => b.from - a.from);
    project.put(path, contentOf(sorted.reduce((text, { from, to, insert }) => text.slice(0, from) + insert + text.slice(to), before)));
    changed();
  }
}

async function fixAll(): Promise<void> {
  const { files, count } = await program.ask('fix', { extendSelect: project.extendSelect, args: project.args });
  for (const [path, after] of Object.entries(files)) {
    const text = project.text(path);
    if (path === editor.path && text) editor.edit([{ from: 0, to: text.length, insert: after }]);
    else project.put(path, contentOf(after));
  }
  kept = count === 1 ? '1 finding fixed' : `${count} findings fixed`;
  changed();
}

// ---- what is shown

function say(text: string): void {
  status.textContent = text;
}

function showFiles(): void {
  const counts = new Map<string, number>();
  for (const { filename } of answer.findings) counts.set(filename, (counts.get(filename) ?? 0) + 1);
  byId('files').replaceChildren(...listFiles(project, counts, {
    open: (path) => {
      open(path);
      pane('source');
    },
    add: () => {
      const path = prompt('Path of the new file', 'robot.urdf.xacro')?.trim();
      if (!path) return;
      if (!project.files.has(path)) project.put(path, contentOf('<?xml version="1.0"?>\n<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">\n  <link name="base_link"/>\n</robot>\n'));
      open(path);
      changed();
    },
    remove: (path) => {
      project.remove(path);
      editor.show(project.open, project.open === undefined ? undefined : project.text(project.open));
      changed();
    },
  }));
}

function showRobots(): void {
  const names = [...new Set([...answer.robots, ...(project.robot === undefined ? [] : [project.robot])])];
  const options = names.map((name) => el('option', { value: name, selected: name === answer.robot, text: name.split('/').pop() ?? name, title: name }));
  byId('robots').replaceChildren(...options);
}

function showArguments(): void {
  const fields = byId('arguments');
  // not below the hands of somebody who types there
  if (fields.contains(document.activeElement) && document.activeElement instanceof HTMLInputElement) return;
  fields.replaceChildren(...form(answer.expanded?.arguments ?? {}, project.args, {
    set: (name, value) => {
      const { [name]: _, ...others } = project.args;
      project.args = value === undefined ? others : { ...others, [name]: value };
      if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
      changed();
    },
  }));
}

/** Show one pane where there is no room for all. */
function pane(name: string): void {
  document.body.dataset['pane'] = name;
  for (const button of byId('panes').querySelectorAll('button')) button.setAttribute('aria-pressed', String(button.dataset['pane'] === name));
}

function tab(name: string): void {
  for (const button of document.querySelectorAll<HTMLElement>('[role=tab]')) {
    const is = button.dataset['tab'] === name;
    button.setAttribute('aria-selected', String(is));
    byId(button.dataset['tab'] ?? '').hidden = !is;
  }
  if (name === 'view' && !viewer.isOpen) {
    viewer.open();
    changed();
  }
}

// ---- where files come from

function load(stored: Stored): void {
  project.load(stored);
  kept = '';
  editor.forget();
  const text = project.open === undefined ? undefined : project.text(project.open);
  editor.show(project.open, text);
  byId<HTMLSelectElement>('examples').value = stored.example ?? '';
  showFiles();
  changed();
}

function take({ files, left }: Loaded): void {
  if (Object.keys(files).length === 0) return say(left || 'there is no file in it');
  load({ files });
  kept = left;
}

async function fromAddress(): Promise<void> {
  try {
    load(await asked(location.hash));
  } catch (error) {
    load(await asked(`#example=${FIRST}`));
    kept = error instanceof Error ? error.message : String(error);
  }
}

async function share(): Promise<void> {
  const { fragment, whole } = link(project);
  history.replaceState(null, '', fragment);
  const note = whole ? '' : '; meshes are too large for it and were left out';
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  say(`${copied ? 'link copied' : 'the link is in the address bar'} (${fragment.length} letters)${note}`);
}

function download(): void {
  const files = Object.fromEntries([...project.files].map(([path, content]) =>
    [path, content instanceof Uint8Array ? content : new TextEncoder().encode(content.toString())]));
  const url = URL.createObjectURL(new Blob([pack(files) as Uint8Array<ArrayBuffer>], { type: 'application/zip' }));
  el('a', { href: url, download: 'robot.zip' }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

// ---- the beginning

function listen(): void {
  byId('fix').addEventListener('click', () => void fixAll().catch((error: Error) => say(error.message)));
  byId('share').addEventListener('click', () => void share());
  byId('save').addEventListener('click', download);
  const folder = byId<HTMLInputElement>('folder');
  byId('open').addEventListener('click', () => folder.click());
  folder.addEventListener('change', () => void read(folder.files ?? []).then(take));
  byId('robots').addEventListener('change', (event) => {
    [project.robot, project.args] = [(event.target as HTMLSelectElement).value, {}];
    changed();
  });
  byId('examples').addEventListener('change', (event) => {
    location.hash = `example=${(event.target as HTMLSelectElement).value}`;
  });
  for (const button of document.querySelectorAll<HTMLElement>('[role=tab]')) button.addEventListener('click', () => tab(button.dataset['tab'] ?? ''));
  for (const [name, text] of [['files', 'Files'], ['source', 'Source'], ['problems', 'Findings'], ['result', 'Result']] as const) {
    byId('panes').append(el('button', { type: 'button', 'data-pane': name, onclick: () => pane(name), text }));
  }
  pane('source');
  addEventListener('hashchange', () => void fromAddress());
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', (event) => {
    if (!event.dataTransfer?.files.length) return;
    event.preventDefault();
    void dropped(event.dataTransfer).then(take, (error: Error) => say(`it cannot be read: ${error.message}`));
  });
  follow(byId('theme'), (theme) => viewer.theme(theme));
}

/** Show what the address asks for: it is there to read while the program is still on its way. */
async function beginFiles(): Promise<void> {
  const known = await examples();
  byId('examples').append(el('option', { value: '', text: '—', hidden: true }), ...known.map(({ name, title }) => el('option', { value: name, text: title })));
  await fromAddress();
}

async function begin(): Promise<void> {
  listen();
  const started = program.ask('start', { wasm: new URL('xacro_lint.wasm', import.meta.url).href });
  await Promise.all([started.then((name) => (version = name)), beginFiles()]);
  if ('serviceWorker' in navigator) await navigator.serviceWorker.register(new URL('sw.js', import.meta.url));
}

begin().catch((error: Error) => say(`the playground cannot be loaded: ${error.message}`));

// for tests, and for the curious in the console
Object.assign(window, { playground: { project, editor, expanded, findings: (): Finding[] => answer.findings } });
