// What the tests share: a copy of the robot, the programs, a browser.
import { spawn } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { writeCubes } from './cubes.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const programs = process.env.XACRO_BIN_DIR ?? join(here, '../../target/debug');
export const bundle = join(here, '../../editors/viewer/dist/viewer.js');
const pictures = process.env.PREVIEW_SHOTS;

/** A copy of the robot in a folder of its own. */
export function rig() {
  const folder = mkdtempSync(join(tmpdir(), 'preview-'));
  cpSync(join(here, 'rig'), folder, { recursive: true });
  writeCubes(join(folder, 'meshes'));
  const file = join(folder, 'urdf/rig.urdf.xacro');
  const edit = (name, from, to) => {
    const path = join(folder, name);
    const text = readFileSync(path, 'utf8');
    if (!text.includes(from)) throw new Error(`no ${from} in ${name}`);
    // in one step: half of a file would be a revision of its own
    writeFileSync(`${path}.new`, text.replace(from, to));
    renameSync(`${path}.new`, path);
  };
  return { folder, file, edit };
}

/** `xacro-lint preview`, and the address it prints. */
export async function preview(args, cwd) {
  const child = spawn(join(programs, 'xacro-lint'), ['preview', ...args], { cwd, stdio: ['ignore', 'pipe', 'pipe'] });
  const said = [];
  child.stderr.on('data', (data) => said.push(String(data)));
  const url = await new Promise((done, failed) => {
    let text = '';
    child.stdout.on('data', (data) => {
      text += data;
      if (text.includes('\n')) done(text.trim());
    });
    child.on('exit', (code) => failed(new Error(`ended with ${code}: ${said.join('')}`)));
  });
  return { url, said: () => said.join(''), end: () => child.kill() };
}

/** The language server, with just enough of a client. */
export function server(cwd) {
  const child = spawn(join(programs, 'xacro-lsp'), [], { cwd, stdio: ['pipe', 'pipe', 'inherit'] });
  const waiting = new Map();
  const taken = [];
  let rest = Buffer.alloc(0);
  let last = 0;
  const send = (message) => {
    const body = JSON.stringify({ jsonrpc: '2.0', ...message });
    child.stdin.write(`Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`);
  };
  child.stdout.on('data', (data) => {
    rest = Buffer.concat([rest, data]);
    for (;;) {
      const end = rest.indexOf('\r\n\r\n');
      const length = Number(/Content-Length: (\d+)/i.exec(rest.subarray(0, Math.max(0, end)).toString())?.[1]);
      if (end < 0 || rest.length < end + 4 + length) return;
      const message = JSON.parse(rest.subarray(end + 4, end + 4 + length));
      rest = rest.subarray(end + 4 + length);
      if (message.method === undefined) waiting.get(message.id)?.(message);
      else {
        taken.push(message);
        if (message.id !== undefined) send({ id: message.id, result: message.method === 'window/showDocument' ? { success: true } : null });
      }
    }
  });
  return {
    taken,
    tell: (method, params) => send({ method, params }),
    ask: (method, params) => new Promise((done, failed) => {
      const id = ++last;
      waiting.set(id, ({ result, error }) => (error ? failed(new Error(error.message)) : done(result)));
      send({ id, method, params });
    }),
    end: () => child.kill(),
  };
}

let shared;
export async function browser() {
  shared ??= await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
      '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  return shared;
}

export async function endBrowser() {
  await shared?.close();
  shared = undefined;
}

/** A page whose errors make the test fail. */
export async function newPage(options = {}) {
  const context = await (await browser()).newContext({ viewport: { width: 1280, height: 800 }, colorScheme: 'light', ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(30000);
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') page.faults.push(message.text());
  });
  return page;
}

/** Wait until a revision is shown with all its files. */
export async function settled(page, revision = 1) {
  await page.waitForFunction((least) => {
    const { revision: now, loading } = document.body.dataset;
    return Number(now) >= least && loading === '0';
  }, revision);
  await drawn(page);
}

/** Wait until what was asked for is in the picture. */
export async function drawn(page) {
  await page.evaluate(() => new Promise((done) => {
    const { stage } = window.xacroViewer;
    const before = stage.pictures;
    stage.invalidate();
    const look = () => (stage.pictures > before ? done() : requestAnimationFrame(look));
    look();
  }));
}

/** How many of the picture's pixels differ from those of another one, 0 to 1. */
export async function pixels(page) {
  await drawn(page);
  return page.evaluate(() => {
    const { canvas } = window.xacroViewer.stage;
    const small = document.createElement('canvas');
    [small.width, small.height] = [320, 200];
    const context = small.getContext('2d');
    context.drawImage(canvas, 0, 0, 320, 200);
    return [...context.getImageData(0, 0, 320, 200).data];
  });
}

export function difference(a, b) {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if (Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]) > 24) count++;
  }
  return count / (a.length / 4);
}

export const value = (page, joint) => page.evaluate((name) => window.xacroViewer.values.get(name), joint);
export const camera = (page) => page.evaluate(() => window.xacroViewer.stage.camera.position.toArray());
export const revision = async (page) => Number(await page.getAttribute('body', 'data-revision'));

/** Where the middle of a link is on the page. */
export const spot = (page, link) => page.evaluate((name) => {
  const { stage, views } = window.xacroViewer;
  const at = views.get('main').box(name).getCenter(stage.orbit.target.clone());
  stage.camera.updateMatrixWorld();
  at.project(stage.camera);
  const box = stage.canvas.getBoundingClientRect();
  return { x: box.left + ((at.x + 1) / 2) * box.width, y: box.top + ((1 - at.y) / 2) * box.height };
}, link);

/** A picture for people, when PREVIEW_SHOTS names a folder. */
export async function shot(page, name) {
  if (!pictures) return;
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`) });
}
