// The viewer as an editor's webview hosts it: messages both ways, bytes of meshes by message, no network at all.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { bundle, endBrowser, newPage, revision, rig, server, settled, shot } from './setup.mjs';

const POLICY = "default-src 'none'; script-src 'nonce-abc'; style-src 'unsafe-inline'; img-src blob: data:; connect-src blob: data:; worker-src blob:; font-src data:";
let robot, lsp, page, id;

before(async () => {
  robot = rig();
  lsp = server(robot.folder);
  const uri = `file://${robot.folder}`;
  await lsp.ask('initialize', { processId: process.pid, rootUri: uri, capabilities: {}, workspaceFolders: [{ uri, name: 'rig' }] });
  lsp.tell('initialized', {});
  page = await newPage();
  await page.exposeFunction('toHost', hostSaid);
  await page.route('http://webview.test/', (route) => route.fulfill({
    contentType: 'text/html',
    headers: { 'Content-Security-Policy': POLICY },
    body: `<!doctype html><html><body class="vscode-dark"><script nonce="abc">
      function acquireVsCodeApi() { return { postMessage: (message) => window.toHost(message) }; }
      </script><script nonce="abc">${readFileSync(bundle, 'utf8').replaceAll('</script', '<\\/script')}</script></body></html>`,
  }));
  await page.goto('http://webview.test/');
  await settled(page);
});

after(async () => {
  await endBrowser();
  lsp?.end();
});

const heard = [];
/** What an editor does with the messages of the viewer. */
async function hostSaid(message) {
  heard.push(message);
  const uri = `file://${robot.file}`;
  if (message.type === 'ready') id = (await lsp.ask('xacro/preview/subscribe', { root: { uri } })).id;
  if (message.type === 'root') await lsp.ask('xacro/preview/setRoot', { id, root: message.root, compare: message.compare });
  if (message.type === 'select') lsp.tell('xacro/preview/select', { id, link: message.link, joint: message.joint });
  if (message.type === 'mesh') {
    const answer = await lsp.ask('xacro/preview/mesh', { id, mesh: message.mesh }).catch((error) => ({ error: error.message }));
    await post({ type: 'mesh', mesh: message.mesh, data: answer.data, error: answer.error });
  }
  if (message.type === 'urdf') {
    const answer = await lsp.ask('xacro/preview/urdf', { id });
    await post({ type: 'urdf', text: answer.urdf });
  }
  await pass();
}

const post = (message) => page.evaluate((one) => window.postMessage(one, '*'), message);
let passed = 0;
/** Pass on what the server sent. */
async function pass() {
  for (; passed < lsp.taken.length; ) {
    const { method, params } = lsp.taken[passed++];
    if (method === 'xacro/preview/model') await post({ type: 'model', ...params });
    if (method === 'xacro/preview/select') await post({ type: 'select', ...params });
  }
}
const pump = setInterval(() => void pass().catch(() => undefined), 20);
after(() => clearInterval(pump));

test('the robot comes by message, its meshes too', async () => {
  assert.equal(await page.locator('[role=treeitem]').count(), 8);
  assert.ok(heard.some((message) => message.type === 'mesh'));
  assert.ok(await page.locator('.banner').isHidden());
  await shot(page, 'webview');
});

test('a click tells the editor where to go', async () => {
  await page.locator('[role=treeitem][data-link=slide]').click();
  const said = heard.find((message) => message.type === 'select');
  assert.equal(said.link, 'slide');
  assert.equal(said.location.uri, `file://${robot.file}`);
});

test('URDF is offered by editors that can give it, and comes by message', async () => {
  const save = page.locator('[data-action=urdf]');
  assert.ok(await save.isHidden(), 'this editor has not said that it can');
  await post({ type: 'settings', urdf: true });
  await save.waitFor();
  const [download] = await Promise.all([page.waitForEvent('download'), save.click()]);
  assert.equal(download.suggestedFilename(), 'rig.urdf');
  assert.match(readFileSync(await download.path(), 'utf8'), /<robot name="rig"/);
});

test('the cursor in unsaved text outlines what it makes', async () => {
  const uri = `file://${robot.folder}/urdf/part.xacro`;
  const text = readFileSync(`${robot.folder}/urdf/part.xacro`, 'utf8');
  lsp.tell('textDocument/didOpen', { textDocument: { uri, languageId: 'xacro', version: 1, text } });
  const line = text.split('\n').findIndex((one) => one.includes('<axis'));
  const at = { line, character: 10 };
  lsp.tell('xacro/preview/select', { id, location: { uri, range: { start: at, end: at } } });
  await page.waitForFunction(() => document.body.dataset.selected === 'arm_joint');
  const now = await revision(page);
  lsp.tell('textDocument/didChange', { textDocument: { uri, version: 2 }, contentChanges: [{ text: text.replace('0.08 0.08', '0.02 0.02') }] });
  await settled(page, now + 1);
  const wide = await page.evaluate(() => window.xacroViewer.views.get('main').box('arm').getSize(window.xacroViewer.stage.orbit.target.clone()).y);
  assert.ok(Math.abs(wide - 0.02) < 1e-6, String(wide));
});

test('an old revision never takes the place of a newer one', async () => {
  const now = await revision(page);
  const root = { uri: 'file:///old' };
  await post({ type: 'model', id, side: 'main', revision: now - 1, ok: true, errors: [], root, args: [], choices: [], model: { robot: 'old', links: [], joints: [], meshes: {} } });
  assert.equal(await revision(page), now);
  assert.equal(await page.locator('[role=treeitem]').count(), 8);
});

test('a mesh above the limit is shown as a box', async () => {
  const now = await revision(page);
  await post({ type: 'settings', meshMaxMB: 0.0005, theme: 'dark' });
  await lsp.ask('xacro/preview/setRoot', { id, root: { uri: `file://${robot.file}`, args: { reach: '0.5' } } });
  await settled(page, now + 1);
  await page.locator('.banner', { hasText: 'shown as a box' }).waitFor();
});

test('a robot that fails without a place for it is not said to have 0 errors', async () => {
  const now = await revision(page);
  const root = { uri: 'file:///x' };
  const args = ['zone', 'arm_type', 'base'].map((name) => ({ name, value: `/a/long/path/of/${name}.yaml` }));
  const model = { robot: 'x', links: [{ name: 'a', visuals: [], collisions: [] }], joints: [], meshes: {} };
  await post({ type: 'model', id, side: 'main', revision: now + 500, ok: false, errors: [], root, args, choices: [root], lastGood: model, goodRevision: now });
  await settled(page, now + 500);
  const title = await page.locator('.banner b').innerText();
  assert.match(title, /^shows revision/);
  assert.doesNotMatch(title, /error/);
  const names = await page.locator('[data-arg]').evaluateAll((fields) => fields.map((field) => field.dataset.arg));
  assert.deepEqual(names, ['zone', 'arm_type', 'base'], 'arguments stand in the order in which they come');
});

test('names from the file are text, never markup', async () => {
  const now = await revision(page);
  const name = '<img src=x onerror=alert(1)>';
  const link = { name, visuals: [], collisions: [] };
  const root = { uri: 'file:///x' };
  await post({ type: 'model', id, side: 'main', revision: now + 1000, ok: false, errors: [{ message: name, code: name, location: { uri: 'file:///x', range: { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } } } }], root, args: [{ name, value: name }], choices: [root], model: { robot: name, links: [link], joints: [], meshes: {} } });
  await settled(page, now + 1000);
  assert.equal(await page.locator('img').count(), 0);
  assert.equal(await page.locator('[role=treeitem]').getAttribute('data-link'), name);
});

test('nothing on the page failed', () => {
  assert.deepEqual(page.faults, []);
});
