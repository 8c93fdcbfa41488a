// How long the preview takes, on robots that are named:
//
//   XACRO_BIN_DIR=target/release node tests/preview/timing.mjs [--edits 60] [--folder PACKAGES] 'FILE [name:=value ...]' ...
//
// The folder with the packages of the robot is copied, since its file is changed.
//
// open:  from the start of `xacro-lint preview` to the page with the robot's tree and joints (browser already running)
// whole: the same with all meshes drawn
// model: from the start of the subscription to the first model, by the language server (no mesh of it known yet)
// edit:  from a change of the unsaved text to the model message that follows, 95th percentile
// save:  from a saved file to the revision in the page, 95th percentile (the program looks at the disk every 30 ms)
import { cpSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { endBrowser, newPage, preview, revision, server, settled } from './setup.mjs';

const { values, positionals } = parseArgs({ options: { edits: { type: 'string', default: '60' }, folder: { type: 'string' } }, allowPositionals: true });
const edits = Number(values.edits);

const sorted = (times) => [...times].sort((a, b) => a - b);
const share = (times, part) => sorted(times)[Math.min(times.length - 1, Math.floor(times.length * part))];

/** The text with one number of a pose or a size changed, another one each time; without one, with a link more. */
function changed(text, turn) {
  const found = /\b(?:xyz|size|radius|length)="[^"$]*?(\d+(?:\.\d+)?)/.exec(text);
  if (!found) return text.replace(/<\/robot>\s*$/, `<link name="timing_${turn}"/></robot>\n`);
  const at = found.index + found[0].length - found[1].length;
  const number = found[1].includes('.') ? found[1] : `${found[1]}.0`;
  return `${text.slice(0, at)}${number}${1 + (turn % 9)}${turn}${text.slice(at + found[1].length)}`;
}

/** `open` and `save`. */
async function inBrowser(file, args, folder) {
  const page = await newPage();
  const begin = performance.now();
  const program = await preview([file, ...args], folder);
  await page.goto(program.url);
  await page.waitForFunction(() => Number(document.body.dataset.revision) > 0, undefined, { polling: 5 });
  const open = performance.now() - begin;
  await settled(page);
  const whole = performance.now() - begin;
  const original = readFileSync(file, 'utf8');
  const save = [];
  try {
    for (let turn = 0; turn < Math.min(edits, 30); turn++) {
      const now = await revision(page);
      const start = performance.now();
      writeFileSync(`${file}.new`, changed(original, turn));
      renameSync(`${file}.new`, file);
      await page.waitForFunction((least) => Number(document.body.dataset.revision) > least, now, { polling: 5 });
      save.push(performance.now() - start);
    }
  } finally {
    writeFileSync(file, original);
  }
  const links = await page.locator('[role=treeitem]').count();
  const faults = [...page.faults];
  program.end();
  await page.context().close();
  return { open, whole, save, links, faults };
}

/** `model` and `edit`. */
async function inEditor(file, args, folder) {
  const lsp = server(folder);
  const uri = `file://${folder}`;
  await lsp.ask('initialize', { processId: process.pid, rootUri: uri, capabilities: {}, workspaceFolders: [{ uri, name: 'robot' }] });
  lsp.tell('initialized', {});
  const document = `file://${file}`;
  const text = readFileSync(file, 'utf8');
  lsp.tell('textDocument/didOpen', { textDocument: { uri: document, languageId: 'xacro', version: 1, text } });
  const models = () => lsp.taken.filter((one) => one.method === 'xacro/preview/model');
  const next = async (count) => {
    while (models().length <= count) await new Promise((done) => setImmediate(done));
  };
  const begin = performance.now();
  const given = Object.fromEntries(args.map((arg) => arg.split(':=')));
  await lsp.ask('xacro/preview/subscribe', { root: { uri: document, args: given } });
  await next(0);
  const model = performance.now() - begin;
  const edit = [];
  for (let turn = 0; turn < edits; turn++) {
    const count = models().length;
    const start = performance.now();
    const contentChanges = [{ text: changed(text, turn) }];
    lsp.tell('textDocument/didChange', { textDocument: { uri: document, version: turn + 2 }, contentChanges });
    await next(count);
    edit.push(performance.now() - start);
    // a person at the keyboard leaves the checks some time, too
    await new Promise((done) => setTimeout(done, 60));
  }
  lsp.end();
  return { model, edit };
}

const ms = (time) => `${time.toFixed(0)} ms`;
console.log('| robot | links | open | whole | model | edit, median | edit, p95 | save, median | save, p95 |\n|---|---|---|---|---|---|---|---|---|');
for (const named of positionals) {
  const [given, ...args] = named.split(/\s+/);
  const source = resolve(values.folder ?? dirname(given));
  const copy = mkdtempSync(join(tmpdir(), 'timing-'));
  const folder = join(copy, basename(source));
  cpSync(source, folder, { recursive: true, dereference: true });
  const file = join(folder, resolve(given).slice(source.length + 1));
  await newPage().then((page) => page.context().close());
  const { open, whole, save, links, faults } = await inBrowser(file, args, folder);
  const { model, edit } = await inEditor(file, args, folder);
  const row = [basename(file), links, ms(open), ms(whole), ms(model), ms(share(edit, 0.5)), ms(share(edit, 0.95)), ms(share(save, 0.5)), ms(share(save, 0.95))];
  console.log(`| ${row.join(' | ')} |${faults.length ? ` ${faults[0]}` : ''}`);
  rmSync(copy, { recursive: true });
}
await endBrowser();
process.exit(0);
