// What people take out of the preview and bring back: views as text, the expanded robot; and what they see of large,
// bright and unusual robots.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { camera, drawn, endBrowser, newPage, preview, revision, rig, settled, shot, spot, value } from './setup.mjs';

let robot, program, page;
const ended = [];

before(async () => {
  robot = rig();
  program = await preview([robot.file], robot.folder);
  ended.push(program);
  page = await newPage();
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.goto(program.url);
  await settled(page);
});

after(async () => {
  await endBrowser();
  for (const one of ended) one.end();
});

const action = (on, name) => on.locator(`[data-action="${name}"]`).first();
const paste = (on, text) => on.evaluate((one) => {
  const clipboardData = new DataTransfer();
  clipboardData.setData('text/plain', one);
  document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
}, text);

/** A robot of its own in a folder of its own, shown in a page of its own. */
async function shown(text, { files = {}, observe, ...options } = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'preview-'));
  for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
  const file = join(folder, 'own.urdf.xacro');
  writeFileSync(file, text(folder));
  const own = await preview([file], folder);
  ended.push(own);
  const made = await newPage(options);
  if (observe) await made.addInitScript(observe);
  await made.goto(own.url);
  await settled(made);
  return made;
}

/** What can be seen of the state. */
const state = (on) => on.evaluate(() => {
  const { stage, values, layers, views } = window.xacroViewer;
  return {
    joints: ['arm_joint', 'lift', 'spin'].map((name) => Number(values.get(name).toFixed(4))),
    layers: { ...layers },
    hidden: [...views.get('main').hidden],
    selected: document.body.dataset.selected,
    camera: [...stage.camera.position.toArray(), ...stage.orbit.target.toArray()].map((one) => Number(one.toFixed(4))),
    reach: document.querySelector('[data-arg=reach]').value,
  };
});

let copied;

test('the token is not in the address bar, and the page can be loaded again', async () => {
  assert.match(program.url, /token=[0-9a-f]{32}/);
  assert.doesNotMatch(page.url(), /token/);
  await page.locator('.joint[data-joint="lift"] input[type=number]').fill('0.1');
  await page.locator('.joint[data-joint="lift"] input[type=number]').press('Enter');
  await page.waitForURL(/joint\.lift=0\.1/);
  await page.reload();
  await settled(page);
  await page.waitForFunction(() => Math.abs(window.xacroViewer.values.get('lift') - 0.1) < 1e-6);
  assert.doesNotMatch(page.url(), /token/);
});

test('a copied view can be pasted into another preview of the robot', async () => {
  const now = await revision(page);
  await page.locator('[data-arg=reach]').fill('0.3');
  await page.locator('[data-arg=reach]').press('Enter');
  await settled(page, now + 1);
  await page.locator('.joint[data-joint="arm_joint"] input[type=number]').fill('30');
  await page.locator('.joint[data-joint="arm_joint"] input[type=number]').press('Enter');
  await page.locator('[role=treeitem][data-link=lamp] button').click();
  await page.locator('[role=treeitem][data-link=arm]').click();
  await page.locator('canvas').first().focus();
  await page.keyboard.type('ag2');
  await drawn(page);
  await action(page, 'copy-view').click();
  await page.locator('.notice', { hasText: 'view copied' }).waitFor();
  await shot(page, 'copied');
  copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(copied, /^xacro-view#file=rig\.urdf\.xacro&/);
  assert.doesNotMatch(copied, /token|[0-9a-f]{32}|127\.0\.0\.1/, 'nothing of this session');
  const other = await preview([robot.file], robot.folder);
  ended.push(other);
  const there = await newPage();
  await there.goto(other.url);
  await settled(there);
  const from = await revision(there);
  await paste(there, copied);
  await settled(there, from + 1);
  await there.waitForFunction(() => Math.abs(window.xacroViewer.values.get('arm_joint') - Math.PI / 6) < 1e-3);
  await drawn(there);
  const [one, two] = [await state(page), await state(there)];
  assert.deepEqual(two, one);
  assert.equal(two.reach, '0.3');
  assert.deepEqual(two.hidden, ['lamp']);
  assert.equal(two.selected, 'arm arm_joint');
  assert.ok(two.layers.axes && !two.layers.grid);
  assert.deepEqual(there.faults, []);
  await there.context().close();
});

test('a view in the address is taken over, other texts are ignored', async () => {
  await paste(page, 'a text that has nothing to do with it');
  const old = await state(page);
  await page.evaluate((text) => (location.hash = text), copied.replace(/^xacro-view#/, '').replace(/joint\.lift=[^&]*/, 'joint.lift=0.05'));
  await page.waitForFunction(() => Math.abs(window.xacroViewer.values.get('lift') - 0.05) < 1e-6);
  assert.deepEqual((await state(page)).camera, old.camera);
  await paste(page, copied.replace('rig.urdf.xacro', 'other.urdf.xacro'));
  assert.match(await page.locator('.notice').innerText(), /of other\.urdf\.xacro, not of rig\.urdf\.xacro/);
  await paste(page, 'xacro-view#file=rig.urdf.xacro&show=visual,grid&joint.lift=NaN&camera=1,2&opacity.arm=x&hide=nothing&select=nothing');
  assert.equal(await value(page, 'lift'), 0);
  assert.ok((await camera(page)).every(Number.isFinite));
  assert.deepEqual((await state(page)).hidden, []);
});

test('the robot shown for comparison is part of the view', async () => {
  const beside = action(page, 'compare');
  const label = (await beside.locator('option').allInnerTexts()).find((text) => text.includes('long'));
  await beside.selectOption({ label });
  const shows = (sides) => page.waitForFunction((count) => window.xacroViewer.views.size === count, sides);
  await shows(2);
  await page.evaluate(() => navigator.clipboard.writeText(''));
  await action(page, 'copy-view').click();
  await page.waitForFunction(async () => (await navigator.clipboard.readText()) !== '');
  const compared = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(compared, /&beside=rig\.urdf\.xacro&beside\.preset=long&/);
  await beside.selectOption('');
  await shows(1);
  await paste(page, compared);
  await shows(2);
  assert.equal(await beside.locator('option:checked').innerText(), label);
  // taken back before the server has answered
  await beside.evaluate((select, text) => {
    select.value = '';
    select.dispatchEvent(new Event('change', { bubbles: true }));
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', text);
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
  }, compared);
  assert.equal(await beside.locator('option:checked').innerText(), label);
  await shows(2);
  await page.waitForURL(/beside\.preset=long/);
  await page.reload();
  await shows(2);
  await paste(page, compared.replace('beside.preset=long', 'beside.preset=none'));
  await shows(1);
  assert.equal(await beside.inputValue(), '');
});

test('a view that cannot be copied by the page stands in a field', async () => {
  await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined, configurable: true }));
  await action(page, 'copy-view').click();
  const field = page.locator('.notice input');
  await field.waitFor();
  assert.match(await field.inputValue(), /^xacro-view#file=/);
});

test('the expanded robot as a file, with the arguments chosen', async () => {
  const now = await revision(page);
  await page.locator('[data-arg=reach]').fill('0.25');
  await page.locator('[data-arg=reach]').press('Enter');
  await settled(page, now + 1);
  const [download] = await Promise.all([page.waitForEvent('download'), action(page, 'urdf').click()]);
  assert.equal(download.suggestedFilename(), 'rig.urdf');
  const text = readFileSync(await download.path(), 'utf8');
  assert.match(text, /<robot name="rig"/);
  assert.match(text, /<box size="0\.08 0\.08 0\.25"\/>/);
  assert.doesNotMatch(text, /xacro:/);
  const bare = await page.request.get(`${new URL(page.url()).origin}/urdf/1`);
  assert.equal(bare.status(), 403, 'nobody gets it without the token');
});

test('a robot with errors is not saved as URDF, and the page says why', async () => {
  const now = await revision(page);
  robot.edit('urdf/rig.urdf.xacro', '<link name="slide">', '<link name="slide"');
  await settled(page, now + 1);
  const refused = page.faults.length;
  await action(page, 'urdf').click();
  await page.locator('.notice', { hasText: 'the robot has errors' }).waitFor();
  // the browser writes an answer that is an error down by itself
  page.faults.length = refused;
  robot.edit('urdf/rig.urdf.xacro', '<link name="slide"', '<link name="slide">');
  await settled(page, now + 2);
});

test('a format that cannot be drawn is amber, with a label that says so', async () => {
  const now = await revision(page);
  writeFileSync(join(robot.folder, 'meshes/cube.fbx'), 'Kaydara FBX Binary');
  robot.edit('urdf/rig.urdf.xacro', 'cube.dae', 'cube.fbx');
  await settled(page, now + 1);
  const label = page.locator('.labels .undrawn');
  await label.waitFor();
  assert.match(await label.innerText(), /^cube\.fbx: format \.fbx cannot be drawn$/);
  assert.equal(await page.locator('.labels .missing').count(), 0, 'magenta means a missing file only');
  const [red, green, blue] = (await label.evaluate((one) => getComputedStyle(one).backgroundColor)).match(/\d+/g).map(Number);
  assert.ok(red > green && green > blue, 'amber');
  await shot(page, 'undrawn');
  robot.edit('urdf/rig.urdf.xacro', 'cube.fbx', 'cube.dae');
  await settled(page, now + 2);
  assert.equal(await label.count(), 0);
});

test('limits and positions are read in degrees and in radians', async () => {
  const row = page.locator('.joint[data-joint="arm_joint"]');
  await row.locator('input[type=number]').fill('30');
  await row.locator('input[type=number]').press('Enter');
  assert.equal(await row.locator('.other').innerText(), '0.524 rad');
  assert.match(await row.locator('.head').getAttribute('title'), /limits -1\.571 … 1\.571 rad \(-90° … 90°\)/);
  await action(page, 'unit').click();
  assert.equal(await row.locator('.other').innerText(), '30°');
  await action(page, 'unit').click();
  await page.locator('[role=treeitem][data-link=arm]').click();
  const field = (name) => page.locator(`.details [data-field=${name}]`).innerText();
  assert.equal(await field('limits'), '-1.571 … 1.571 rad (-90° … 90°)');
  assert.equal(await field('position'), '0.524 rad (30°)');
  assert.match(await field('parent'), /rpy 0° 30° 0°\n= 0 0\.5236 0 rad/);
  assert.ok(await page.locator('.joint[data-joint="lift"] .other').isHidden(), 'meters have one unit');
  await shot(page, 'units');
});

test('20 arguments in half a window: all visible, in their order, and the robot beside them', async () => {
  const names = Array.from({ length: 20 }, (_, i) => `argument_${(i * 7) % 20}_of_the_robot`);
  const half = await shown(() => `<robot name="own" xmlns:xacro="http://www.ros.org/wiki/xacro">
    ${names.map((name) => `<xacro:arg name="${name}" default="${name.length}"/>`).join('')}
    <link name="base"><visual><geometry><box size="0.4 0.3 0.9"/></geometry></visual></link></robot>`, { viewport: { width: 640, height: 800 }, colorScheme: 'dark' });
  assert.deepEqual(await half.locator('[data-arg]').evaluateAll((fields) => fields.map((field) => field.dataset.arg)), names);
  const cut = await half.locator('[data-arg]').evaluateAll((fields) => fields.filter((field) => {
    const { left, top, width, height } = field.getBoundingClientRect();
    const ends = [[left + 2, top + 2], [left + width - 2, top + height - 2]];
    return !ends.every(([x, y]) => document.elementFromPoint(x, y) === field);
  }).map((field) => field.dataset.arg));
  assert.deepEqual(cut, [], 'no argument is cut off or covered');
  const view = await half.locator('.view').boundingBox();
  assert.ok(view.height > 800 / 4, `the robot has ${view.height} pixels`);
  const inside = () => half.evaluate(() => {
    const { stage, views } = window.xacroViewer;
    const { min, max } = views.get('main').box();
    return [min, max].every((corner) => corner.project(stage.camera) && Math.abs(corner.x) <= 1 && Math.abs(corner.y) <= 1);
  });
  assert.ok(await inside());
  await shot(half, 'arguments');
  await action(half, 'programs').click();
  await half.waitForFunction((high) => document.querySelector('.view').clientHeight < high, view.height);
  await drawn(half);
  assert.ok(await inside(), 'the robot is fitted again when a panel opens');
  await half.context().close();
});

/** A wavy sheet as Collada, with a lamp that is far too bright. */
function sheet(side) {
  const steps = Array.from({ length: side }, (_, i) => i);
  const points = steps.flatMap((y) => steps.map((x) => `${x / side - 0.5} ${y / side - 0.5} ${(0.05 * Math.sin(x / 5)).toFixed(4)}`));
  const faces = steps.slice(1).flatMap((y) => steps.slice(1).map((x) => {
    const [a, b, c, d] = [(y - 1) * side + x - 1, (y - 1) * side + x, y * side + x, y * side + x - 1];
    return `${a} ${b} ${c} ${a} ${c} ${d}`;
  }));
  return `<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse><color>0.1 0.2 0.6 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_lights><light id="l"><technique_common><point><color>50 50 50</color></point></technique_common></light><light id="a"><technique_common><ambient><color>20 20 20</color></ambient></technique_common></light></library_lights>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="${points.length * 3}">${points.join(' ')}</float_array><technique_common><accessor source="#pa" count="${points.length}" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="${faces.length * 2}" material="s"><input semantic="VERTEX" source="#v" offset="0"/><p>${faces.join(' ')}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s0"><node id="x"><translate>0 0 1</translate><instance_light url="#l"/></node><node id="y"><instance_light url="#a"/></node><node id="n"><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s0"/></scene></COLLADA>`;
}

const linkOf = (name, geometry, color) => `<link name="${name}"><visual><geometry>${geometry}</geometry>${color ? `<material name="m_${name}"><color rgba="${color}"/></material>` : ''}</visual></link>`;

/** Shares of the picture without grid: of what is not background, how much is all but white. */
const white = (on) => on.evaluate(() => {
  const { canvas } = window.xacroViewer.stage;
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  const [r, g, b] = data;
  let [all, bright] = [0, 0];
  for (let i = 0; i < data.length; i += 4) {
    if (Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 12) continue;
    all++;
    if (Math.min(data[i], data[i + 1], data[i + 2]) > 250) bright++;
  }
  return { robot: all / (data.length / 4), white: bright / Math.max(1, all) };
});

test('a large Collada file is read beside the page, with progress, and its lamps light nothing', async () => {
  const observe = () => {
    window.said = [];
    const watch = new MutationObserver(() => window.said.push(document.querySelector('.status')?.textContent ?? ''));
    document.addEventListener('DOMContentLoaded', () => watch.observe(document.body, { subtree: true, childList: true, characterData: true }));
  };
  const mesh = (folder, name) => `<mesh filename="file://${folder}/${name}"/>`;
  const begin = performance.now();
  const large = await shown((folder) => `<robot name="own">${linkOf('base', mesh(folder, 'large.dae'))}${linkOf('tip', mesh(folder, 'small.dae'))}
    <joint name="j" type="fixed"><parent link="base"/><child link="tip"/><origin xyz="0 0 0.4"/></joint></robot>`,
  { files: { 'large.dae': sheet(400), 'small.dae': sheet(12) }, observe, colorScheme: 'dark' });
  const whole = performance.now() - begin;
  const said = (await large.evaluate(() => window.said)).join('\n');
  for (const name of ['large.dae', 'small.dae']) assert.match(said, new RegExp(`\\d of 2 files: ${name}`), said);
  assert.ok(large.workers().length >= 1);
  const found = await large.evaluate(() => {
    let triangles = 0;
    window.xacroViewer.views.get('main').link('base').traverse((part) => (triangles = Math.max(triangles, part.isMesh ? (part.geometry.index ?? part.geometry.attributes.position).count / 3 : 0)));
    return { triangles, script: window.xacroViewer.meshes.script.get('large.dae') };
  });
  assert.ok(found.triangles > 300_000, `${found.triangles} triangles`);
  // a share and not a time: both grow on a busy machine
  assert.ok(found.script < whole / 20, `the page was busy for ${found.script} of ${whole} ms`);
  console.log(`large Collada: ${found.script.toFixed(1)} ms of the page, ${whole.toFixed(0)} ms in all`);
  await large.keyboard.press('g');
  await drawn(large);
  const share = await white(large);
  assert.ok(share.robot > 0.05, `the robot covers ${share.robot}`);
  assert.ok(share.white < 0.001, `${share.white} of the robot is white`);
  await shot(large, 'lamps');
  assert.deepEqual(large.faults, []);
  await large.context().close();
});

test('white and light gray parts keep their shades', async () => {
  const parts = ['1 1 1 1', '0.9 0.9 0.9 1', '0.75 0.75 0.75 1', '1 0.95 0.85 1'].map((color, i) => {
    const shape = i % 2 ? '<sphere radius="0.2"/>' : '<box size="0.35 0.35 0.5"/>';
    const joint = i === 0 ? '' : `<joint name="j${i}" type="fixed"><parent link="p0"/><child link="p${i}"/><origin xyz="${(i % 2) * 0.45} ${Math.floor(i / 2) * 0.45} 0"/></joint>`;
    return linkOf(`p${i}`, shape, color) + joint;
  });
  const bright = await shown(() => `<robot name="own">${parts.join('')}</robot>`, { colorScheme: 'dark' });
  await bright.keyboard.press('g');
  for (const key of ['4', '3', '1']) {
    await bright.keyboard.press(key);
    await drawn(bright);
    const share = await white(bright);
    assert.ok(share.robot > 0.1, `the robot covers ${share.robot}`);
    assert.ok(share.white < 0.02, `${share.white} of the robot is white (view ${key})`);
  }
  await shot(bright, 'bright');
  await bright.context().close();
});

test('a Collada file with a lamp keeps its color', async () => {
  await page.locator('canvas').first().focus();
  await page.keyboard.press('4');
  await drawn(page);
  const at = await spot(page, 'panel');
  const color = await page.evaluate(({ x, y }) => {
    const { canvas } = window.xacroViewer.stage;
    const box = canvas.getBoundingClientRect();
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const scale = canvas.width / box.width;
    return [...context.getImageData((x - box.left) * scale, (y - box.top) * scale, 1, 1).data];
  }, at);
  assert.ok(color[0] > color[1] + 60 && color[1] < 120, `red stays red: ${color}`);
});

test('nothing on the page failed', () => {
  assert.deepEqual(page.faults, []);
});
