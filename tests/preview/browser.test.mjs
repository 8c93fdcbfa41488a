// The viewer in a browser on `xacro-lint preview`: every control by click and by key, edits on the disk.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { camera, difference, drawn, endBrowser, newPage, pixels, preview, revision, rig, settled, shot, spot, value } from './setup.mjs';

let robot, program, page;

before(async () => {
  robot = rig();
  program = await preview([robot.file], robot.folder);
  page = await newPage();
  await page.goto(program.url);
  await settled(page);
});

after(async () => {
  await endBrowser();
  program?.end();
});

const layer = (name) => page.evaluate((one) => window.xacroViewer.layers[one], name);
const row = (joint) => page.locator(`.joint[data-joint="${joint}"]`);
const action = (name) => page.locator(`[data-action="${name}"]`).first();

async function changes(what, by = 0.002) {
  const old = await pixels(page);
  await what();
  const share = difference(old, await pixels(page));
  assert.ok(share > by, `only ${(share * 100).toFixed(2)} % of the pixels changed`);
}

test('the robot is there, with meshes of every format', async () => {
  assert.equal(await page.locator('[role=treeitem]').count(), 8);
  assert.equal(await page.locator('.joint').count(), 5);
  assert.ok(await page.locator('.banner').isHidden(), await page.locator('.banner').innerText());
  const black = await page.evaluate(() => {
    // the STL says zero for all normals: they have to be made again
    const found = [];
    window.xacroViewer.views.get('main').group.traverse((part) => {
      const normal = part.geometry?.attributes?.normal;
      if (part.isMesh && (!normal || normal.array.every((one) => one === 0)) && part.material.isMeshStandardMaterial) found.push(part.name);
    });
    return found;
  });
  assert.deepEqual(black, []);
  const lamps = await page.evaluate(() => {
    let count = 0;
    window.xacroViewer.views.get('main').group.traverse((part) => (count += part.isLight || part.isCamera ? 1 : 0));
    return count;
  });
  assert.equal(lamps, 0, 'the lamp in the Collada file lights nothing');
  const texture = await page.evaluate(() => {
    let width;
    window.xacroViewer.views.get('main').link('right').traverse((part) => (width ??= part.material?.map?.image?.width));
    return width;
  });
  assert.equal(texture, 4, 'the texture that the material library names');
  await shot(page, 'first');
});

test('meshes are read by a worker, not by the page', async () => {
  assert.ok(page.workers().length >= 1);
  const script = await page.evaluate(() => [...window.xacroViewer.meshes.script]);
  assert.deepEqual(script.map(([name]) => name).sort(), ['cube.dae', 'cube.glb', 'cube.obj', 'cube.stl']);
  const boxes = await page.evaluate(() => {
    const found = [];
    window.xacroViewer.views.get('main').link('panel').traverse((part) => part.isMesh && found.push(part.geometry.boundingBox?.max.toArray()));
    return found;
  });
  assert.deepEqual(boxes, [[0.5, 0.5, 0.5]], 'the box comes with the mesh');
});

test('a slider moves its joint and the picture', async () => {
  const slider = row('arm_joint').locator('input[type=range]');
  await changes(() => slider.fill('0.8'));
  assert.ok(Math.abs((await value(page, 'arm_joint')) - 0.8) < 0.01);
  await slider.press('ArrowRight');
  assert.ok((await value(page, 'arm_joint')) > 0.8);
  await slider.press('End');
  assert.ok(Math.abs((await value(page, 'arm_joint')) - Math.PI / 2) < 0.01);
});

test('a value is typed in degrees, clipped at the limit, and shown in radians', async () => {
  const typed = row('arm_joint').locator('input[type=number]');
  await typed.fill('30');
  await typed.press('Enter');
  assert.ok(Math.abs((await value(page, 'arm_joint')) - Math.PI / 6) < 1e-6);
  await typed.fill('400');
  await typed.press('Enter');
  assert.equal(await typed.inputValue(), '90', 'what was clipped is seen at once');
  assert.ok(Math.abs((await value(page, 'arm_joint')) - Math.PI / 2) < 1e-6);
  await action('unit').click();
  assert.equal(await row('arm_joint').locator('input[type=number]').inputValue(), '1.571');
  await action('unit').click();
  assert.equal(await row('arm_joint').locator('input[type=number]').inputValue(), '90');
  assert.equal(await typed.getAttribute('title'), '1.571 rad (90°)');
});

test('meters stay meters', async () => {
  const typed = row('lift').locator('input[type=number]');
  await typed.fill('0.15');
  await typed.press('Enter');
  assert.equal(await value(page, 'lift'), 0.15);
});

test('a continuous joint has a wheel without an end', async () => {
  const wheel = row('spin').locator('.wheel');
  await wheel.focus();
  for (let i = 0; i < 8; i++) await page.keyboard.press('PageUp');
  assert.ok(Math.abs((await value(page, 'spin')) - 4) < 1e-6);
  const box = await wheel.boundingBox();
  await page.mouse.move(box.x + 10, box.y + 8);
  await page.mouse.down();
  await page.mouse.move(box.x + 70, box.y + 8, { steps: 6 });
  await page.mouse.up();
  assert.ok((await value(page, 'spin')) > 4.2);
  await page.keyboard.press('Home');
  assert.equal(await value(page, 'spin'), 0);
});

test('a joint that follows another one follows', async () => {
  assert.equal(await row('right_finger').locator('input').count(), 0);
  await row('left_finger').locator('input[type=range]').fill('0.3');
  assert.ok(Math.abs((await value(page, 'right_finger')) + 0.3) < 0.01);
  assert.match(await row('right_finger').innerText(), /follows left_finger/);
});

test('reset, random and sweep', async () => {
  await page.keyboard.press('Escape');
  await page.locator('canvas').first().focus();
  await page.keyboard.press('r');
  assert.equal(await value(page, 'arm_joint'), 0);
  await changes(() => action('random').click());
  await action('reset').click();
  assert.equal(await value(page, 'spin'), 0);
  const sweep = row('arm_joint').locator('[data-action=sweep]');
  await sweep.click();
  await page.waitForFunction(() => Math.abs(window.xacroViewer.values.get('arm_joint')) > 0.2);
  assert.equal(await sweep.getAttribute('aria-pressed'), 'true');
  await sweep.click();
  const stopped = await value(page, 'arm_joint');
  await drawn(page);
  assert.equal(await value(page, 'arm_joint'), stopped);
  await action('reset').click();
});

test('every layer by its key and by its box', async () => {
  const keys = { visual: 'v', collision: 'c', frames: 'x', names: 'n', axes: 'a', inertia: 'i', com: 'o', bbox: 'b', grid: 'g' };
  for (const [name, key] of Object.entries(keys)) {
    const was = await layer(name);
    await page.locator('canvas').first().focus();
    const press = async () => {
      await page.keyboard.press(key);
      assert.equal(await layer(name), !was, name);
    };
    if (name === 'names') await press();
    else await changes(press, 0.0003);
    await action('layers').click();
    await page.locator(`[data-layer="${name}"]`).click();
    assert.equal(await layer(name), was, name);
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('.menu').first().isHidden());
  }
});

test('all layers at once', async () => {
  await page.locator('canvas').first().focus();
  await page.keyboard.type('cxnaiob');
  await drawn(page);
  assert.equal(await page.locator('.labels .name:visible').count(), 8);
  assert.match(await page.locator('.labels .size').innerText(), /× .* m$/);
  await row('arm_joint').locator('input[type=range]').fill('0.5');
  await drawn(page);
  await shot(page, 'layers');
  await page.locator('canvas').first().focus();
  await page.keyboard.type('cxnaiobr');
});

test('a click selects a link, says where it is written, and shift the call', async () => {
  const at = await spot(page, 'arm');
  await page.mouse.move(at.x, at.y);
  await page.locator('.tip', { hasText: 'arm' }).waitFor();
  assert.match(await page.locator('.tip').innerText(), /1 kg[\s\S]*base → arm_joint → arm/);
  await changes(() => page.mouse.click(at.x, at.y));
  assert.equal(await page.getAttribute('body', 'data-selected'), 'arm arm_joint');
  assert.equal(await page.locator('[role=treeitem][aria-selected=true]').getAttribute('data-link'), 'arm');
  const said = async (text) => {
    for (let i = 0; i < 200 && !program.said().includes(text); i++) await drawn(page);
    assert.ok(program.said().includes(text), program.said());
  };
  await said('urdf/part.xacro:5:5');
  await page.keyboard.down('Shift');
  await page.mouse.click(at.x, at.y);
  await page.keyboard.up('Shift');
  await said('urdf/rig.urdf.xacro:12:3');
  await shot(page, 'selected');
  await page.mouse.click(400, 700);
  await drawn(page);
  assert.equal(await page.getAttribute('body', 'data-selected'), '');
  // what the program says to the click before selects nothing any more
  for (let i = 0; i < 10; i++) await drawn(page);
  assert.equal(await page.getAttribute('body', 'data-selected'), '');
});

test('dragging a link moves its joint, dragging elsewhere the camera', async () => {
  const at = await spot(page, 'arm');
  const from = await camera(page);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 60, at.y + 5, { steps: 8 });
  await page.mouse.up();
  assert.ok(Math.abs(await value(page, 'arm_joint')) > 0.1);
  assert.deepEqual(await camera(page), from);
  await page.mouse.move(420, 700);
  await page.mouse.down();
  await page.mouse.move(520, 690, { steps: 5 });
  await page.mouse.up();
  assert.notDeepEqual(await camera(page), from);
  await page.keyboard.press('r');
});

test('the prismatic joint is dragged along its axis', async () => {
  await page.keyboard.press('1');
  await drawn(page);
  // its lower half is inside of the arm
  const at = await spot(page, 'slide');
  at.y -= 12;
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x, at.y - 50, { steps: 8 });
  await page.mouse.up();
  assert.ok((await value(page, 'lift')) > 0.02, String(await value(page, 'lift')));
  await page.keyboard.press('r');
});

test('views by number and the whole robot by F', async () => {
  for (const key of ['1', '2', '3', '4']) {
    const old = await camera(page);
    await page.keyboard.press(key);
    if (key !== '1') assert.notDeepEqual(await camera(page), old);
  }
  await page.mouse.move(600, 400);
  await page.mouse.wheel(0, 600);
  const far = await camera(page);
  await page.keyboard.press('f');
  assert.notDeepEqual(await camera(page), far);
  await page.mouse.wheel(0, 600);
  const again = await camera(page);
  await action('fit').click();
  assert.notDeepEqual(await camera(page), again);
  await page.keyboard.press('4');
});

test('two clicks measure a distance', async () => {
  await page.locator('canvas').first().focus();
  await page.keyboard.press('m');
  const a = await spot(page, 'base');
  const b = await spot(page, 'slide');
  await page.mouse.click(a.x, a.y);
  await page.mouse.click(b.x, b.y);
  await page.locator('.labels .measure').waitFor();
  assert.match(await page.locator('.labels .measure').innerText(), /^0\.\d+ m \(/);
  const c = await spot(page, 'panel');
  await page.mouse.click(c.x, c.y);
  assert.match(await page.locator('.labels .measure').innerText(), /^\d+(\.\d+)?° \(0\.\d+ m, 0\.\d+ m\)$/);
  await shot(page, 'measure');
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.labels .measure').count(), 0);
  await action('measure').click();
  assert.equal(await action('measure').getAttribute('aria-pressed'), 'true');
  await action('measure').click();
});

test('the tree: search, keys, eyes', async () => {
  await page.locator('canvas').first().focus();
  await page.keyboard.press('/');
  await page.keyboard.type('finger');
  assert.equal(await page.locator('[role=treeitem]').count(), 2);
  await page.keyboard.press('Enter');
  assert.match(await page.getAttribute('body', 'data-selected'), /left/);
  await page.locator('input[type=search]').focus();
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('[role=treeitem]').count(), 8);
  const arm = page.locator('[role=treeitem][data-link=arm]');
  await changes(() => arm.locator('button').click());
  assert.match(await arm.getAttribute('class'), /hidden-link/);
  await arm.focus();
  await page.keyboard.press(' ');
  assert.doesNotMatch(await arm.getAttribute('class'), /hidden-link/);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  assert.match(await page.getAttribute('body', 'data-selected'), /slide/);
  const old = await camera(page);
  await page.locator('[role=treeitem][data-link=rotor]').dblclick();
  assert.notDeepEqual(await camera(page), old);
  await page.keyboard.press('f');
});

test('the panel of a link: mass, poses, size, source, opacity', async () => {
  await action('reset').click();
  await page.locator('[role=treeitem][data-link=arm]').click();
  const panel = page.locator('.details');
  const field = (name) => panel.locator(`[data-field=${name}]`).innerText();
  assert.equal(await field('mass'), '1 kg');
  assert.equal(await field('com'), '0 0 0.2 m');
  assert.match(await field('inertia'), /xx 0\.015\s+yy 0\.015\s+zz 0\.001/);
  assert.match(await field('world'), /xyz 0 0 0\.1 m\s+rpy 0° 0° 0°/);
  assert.match(await field('size'), /0\.08 × 0\.08 × 0\.4 m/);
  await row('arm_joint').locator('input[type=number]').fill('30');
  await row('arm_joint').locator('input[type=number]').press('Enter');
  assert.match(await field('parent'), /rpy 0° 30° 0°/, 'the pose follows the joint');
  assert.equal(await panel.locator('[data-action=source]').innerText(), 'part.xacro:5');
  await changes(() => panel.locator('[data-action=opacity]').fill('0.3'));
  await shot(page, 'details');
  await panel.locator('[data-action=opacity]').fill('1');
  await page.locator('canvas').first().focus();
  await page.keyboard.press('r');
});

test('a view without perspective, and back', async () => {
  await page.keyboard.press('4');
  const old = await camera(page);
  await changes(() => page.keyboard.press('p'));
  assert.equal(await action('parallel').getAttribute('aria-pressed'), 'true');
  const lines = await page.evaluate(() => {
    const { camera, orbit } = window.xacroViewer.stage;
    const wide = (depth) => {
      const at = (side) => orbit.target.clone().addScaledVector(camera.position.clone().sub(orbit.target).normalize(), depth).add(camera.up.clone().multiplyScalar(side)).project(camera).y;
      return at(0.1) - at(-0.1);
    };
    return wide(0.3) / wide(-0.3);
  });
  assert.ok(Math.abs(lines - 1) < 0.01, `what is near is ${lines} times as large as what is far`);
  await page.keyboard.press('p');
  const now = await camera(page);
  assert.ok(old.every((one, i) => Math.abs(one - now[i]) < 1e-3));
});

test('the picture as a file', async () => {
  const [download] = await Promise.all([page.waitForEvent('download'), action('picture').click()]);
  assert.equal(download.suggestedFilename(), 'rig.png');
  const bytes = readFileSync(await download.path());
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  assert.ok(bytes.readUInt32BE(16) > 400);
});

test('the tree is reached by Tab', async () => {
  await page.locator('input[type=search]').focus();
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('role')), 'treeitem');
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('role')), 'treeitem');
});

test('half a window: joints open, tree closed, the bar in its place', async () => {
  const half = await newPage({ viewport: { width: 640, height: 800 }, colorScheme: 'dark' });
  await half.goto(program.url);
  await settled(half);
  assert.ok(await half.locator('.panel.right').isVisible());
  assert.ok(await half.locator('.panel.left').isHidden());
  assert.equal(await half.locator('[data-action=joints]').innerText(), 'Joints');
  const inside = () => half.evaluate(() => {
    const { stage, views } = window.xacroViewer;
    const box = views.get('main').box();
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => box.min.clone().set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z));
    return corners.every((corner) => corner.project(stage.camera) && Math.abs(corner.x) <= 1 && Math.abs(corner.y) <= 1);
  });
  assert.ok(await inside());
  await half.locator('[data-action=tree]').click();
  await drawn(half);
  await half.waitForFunction(() => document.querySelector('.view').clientWidth < 300);
  await drawn(half);
  assert.ok(await inside(), 'the robot is fitted again when a panel opens');
  await shot(half, 'half');
  await half.context().close();
});

test('the menu of a link', async () => {
  await page.keyboard.press('4');
  await drawn(page);
  const open = async () => {
    const at = await spot(page, 'arm');
    await page.mouse.click(at.x, at.y, { button: 'right' });
    await page.locator('[data-action=go-joint]').waitFor();
  };
  await open();
  await page.locator('[data-action=go-joint]').click();
  assert.equal(await page.getAttribute('body', 'data-selected'), 'arm arm_joint');
  await open();
  await page.locator('[data-action=hide]').click();
  assert.match(await page.locator('[role=treeitem][data-link=arm]').getAttribute('class'), /hidden-link/);
  await page.locator('[role=treeitem][data-link=arm] button').click();
  await open();
  await page.keyboard.press('Escape');
  assert.ok(await page.locator('[data-action=go-joint]').isHidden());
});

test('panels and help open and close', async () => {
  await action('tree').click();
  assert.ok(await page.locator('.panel.left').isHidden());
  await action('tree').click();
  await action('joints').click();
  assert.ok(await page.locator('.panel.right').isHidden());
  await action('joints').click();
  await page.locator('canvas').first().focus();
  await page.keyboard.press('?');
  assert.ok(await page.locator('.help').isVisible());
  await shot(page, 'help');
  await page.keyboard.press('Escape');
  assert.ok(await page.locator('.help').isHidden());
});

test('the table of programs: who rejects and changes what, and where that is', async () => {
  const panel = page.locator('.programs');
  assert.ok(await panel.isHidden());
  await action('programs').click();
  assert.match(await panel.innerText(), /Rejected by|Changed by|Accepted by/);
  const rows = await panel.locator('tbody tr').count();
  const more = '<link name="universe"/><joint name="to_universe" type="fixed"><parent link="base"/><child link="universe"/></joint></robot>';
  robot.edit('urdf/rig.urdf.xacro', '</robot>', more);
  const named = panel.locator('tbody tr', { hasText: 'link `universe`' }).first();
  await named.waitFor();
  assert.ok((await panel.locator('tbody tr').count()) > rows);
  assert.match(await named.innerText(), /Pinocchio/);
  await shot(page, 'programs');
  await named.locator('button').first().click();
  for (let i = 0; i < 200 && !/rig\.urdf\.xacro:\d+/.test(program.said()); i++) await drawn(page);
  assert.match(program.said(), /rig\.urdf\.xacro:\d+/);
  robot.edit('urdf/rig.urdf.xacro', more, '</robot>');
  await named.waitFor({ state: 'detached' });
  await action('programs').click();
  assert.ok(await panel.isHidden());
});

test('an edit keeps camera, joints, selection and what is hidden', async () => {
  await page.locator('canvas').first().focus();
  await row('arm_joint').locator('input[type=range]').fill('0.4');
  await page.locator('[role=treeitem][data-link=slide]').click();
  await page.locator('[role=treeitem][data-link=lamp] button').click();
  const [at, now, old] = [await camera(page), await revision(page), await pixels(page)];
  const mesh = await page.evaluate(() => window.xacroViewer.views.get('main').link('panel').uuid);
  robot.edit('urdf/part.xacro', '0.08 0.08 ${length}', '0.16 0.16 ${length}');
  await settled(page, now + 1);
  assert.deepEqual(await camera(page), at);
  assert.ok(Math.abs((await value(page, 'arm_joint')) - 0.4) < 0.01);
  assert.match(await page.getAttribute('body', 'data-selected'), /slide/);
  assert.match(await page.locator('[role=treeitem][data-link=lamp]').getAttribute('class'), /hidden-link/);
  assert.ok(difference(old, await pixels(page)) > 0.002);
  assert.equal(await page.evaluate(() => window.xacroViewer.views.get('main').link('panel').uuid), mesh, 'what did not change stays');
  await page.locator('[role=treeitem][data-link=lamp] button').click();
});

test('broken text keeps the last good robot and says what is wrong', async () => {
  const good = await revision(page);
  const old = await pixels(page);
  robot.edit('urdf/rig.urdf.xacro', '<link name="slide">', '<link name="slide"');
  await settled(page, good + 1);
  await page.locator('.banner').waitFor();
  assert.match(await page.locator('.banner b').innerText(), new RegExp(`shows revision ${good} of .*, \\d+ error`));
  assert.equal(await page.locator('[role=treeitem]').count(), 8);
  assert.equal(await page.getAttribute('body', 'data-ok'), 'false');
  const places = await page.evaluate(() => [document.querySelector('.banner').getBoundingClientRect().bottom, document.querySelector('canvas').getBoundingClientRect().top]);
  assert.ok(places[0] <= places[1], 'the list does not cover the robot');
  const error = page.locator('[data-action=error]').first();
  assert.match(await error.innerText(), /rig\.urdf\.xacro:\d+/);
  await error.click();
  await shot(page, 'broken');
  robot.edit('urdf/rig.urdf.xacro', '<link name="slide"', '<link name="slide">');
  await settled(page, good + 2);
  assert.ok(await page.locator('.banner').isHidden());
  assert.ok(difference(old, await pixels(page)) < 0.01);
});

test('a mesh that is not there is a magenta box with a name', async () => {
  const now = await revision(page);
  robot.edit('urdf/rig.urdf.xacro', 'cube.dae', 'gone.dae');
  await settled(page, now + 1);
  await page.locator('.labels .missing', { hasText: 'gone.dae' }).waitFor();
  assert.match(await page.locator('.banner').innerText(), /1 mesh is missing[\s\S]*gone\.dae/);
  const magenta = await page.evaluate(() => {
    let found;
    window.xacroViewer.views.get('main').link('panel').traverse((part) => (found ??= part.isMesh && part.material.color?.getHex() === 0xff00ff ? part : undefined));
    return found?.geometry.parameters;
  });
  assert.deepEqual([magenta?.width, magenta?.height, magenta?.depth], [0.1, 0.1, 0.1]);
  await shot(page, 'missing');
  robot.edit('urdf/rig.urdf.xacro', 'gone.dae', 'cube.dae');
  await settled(page, now + 2);
  assert.equal(await page.locator('.labels .missing').count(), 0);
});

test('a link without a visual is shown by its collision shape, with a mark', async () => {
  const now = await revision(page);
  const [visual, collision] = ['visual', 'collision'].map((tag) => `<link name="rotor"><${tag}><geometry><sphere radius="0.05"/></geometry></${tag}></link>`);
  robot.edit('urdf/rig.urdf.xacro', visual, collision);
  await settled(page, now + 1);
  const look = await page.evaluate(() => {
    let found;
    window.xacroViewer.views.get('main').link('rotor').children[0].traverse((part) => (found ??= part.isMesh ? part.material : undefined));
    return { color: found?.color.getHex(), opacity: found?.opacity };
  });
  assert.notEqual(look.color, 0xff00ff, 'magenta means a missing file only');
  assert.ok(look.opacity < 0.5);
  await page.locator('[role=treeitem][data-link=rotor]').click();
  assert.match(await page.locator('.details [data-field=size]').innerText(), /of the collision: no visual/);
  await shot(page, 'stand-in');
  robot.edit('urdf/rig.urdf.xacro', collision, visual);
  await settled(page, now + 2);
});

test('a mesh that changes on the disk is loaded again', async () => {
  const now = await revision(page);
  robot.edit('meshes/cube.obj', 'v 0.5 0.5 0.5', 'v 2 2 2');
  await settled(page, now + 1);
  const box = await page.evaluate(() => window.xacroViewer.views.get('main').box('right').max.toArray());
  assert.ok(box.some((one) => one > 0.05));
});

test('presets and arguments are chosen in the bar', async () => {
  const high = () => page.evaluate(() => window.xacroViewer.views.get('main').box('slide').max.z);
  await action('reset').click();
  const [now, low] = [await revision(page), await high()];
  const choices = await page.locator('[data-action=root] option').allInnerTexts();
  assert.ok(choices.some((text) => text.includes('long')), choices.join());
  await action('root').selectOption({ label: choices.find((text) => text.includes('long')) });
  await settled(page, now + 1);
  await page.waitForFunction((least) => window.xacroViewer.views.get('main').box('slide').max.z > least + 0.4, low);
  const field = page.locator('[data-arg=reach]');
  await field.fill('0.2');
  await field.press('Enter');
  await page.waitForFunction((most) => window.xacroViewer.views.get('main').box('slide').max.z < most, low);
});

test('two presets side by side', async () => {
  const now = await revision(page);
  const choices = await page.locator('[data-action=compare] option').allInnerTexts();
  await action('compare').selectOption({ label: choices.find((text) => text.includes('long')) });
  await page.waitForFunction(() => window.xacroViewer.views.size === 2);
  await settled(page, now);
  const heights = await page.evaluate(() => [...window.xacroViewer.views.values()].map((view) => view.box('slide').max.z));
  assert.ok(heights[1] > heights[0] + 0.4, heights.join());
  await row('arm_joint').locator('input[type=range]').fill('0.6');
  await page.locator('canvas').first().focus();
  await page.keyboard.press('f');
  await drawn(page);
  await shot(page, 'compare');
  await action('compare').selectOption('');
  await page.waitForFunction(() => window.xacroViewer.views.size === 1);
});

test('a dark page', async () => {
  await page.keyboard.press('f');
  await changes(() => page.emulateMedia({ colorScheme: 'dark' }), 0.3);
  await shot(page, 'dark');
  await page.emulateMedia({ colorScheme: 'light' });
});

test('the page comes back when the connection was lost', async () => {
  const other = await preview([robot.file], robot.folder);
  const lost = await newPage();
  await lost.goto(other.url);
  await settled(lost);
  other.end();
  await lost.waitForFunction(() => document.body.dataset.connection === 'lost');
  assert.equal(await lost.locator('[role=treeitem]').count(), 8);
  await lost.context().close();
});

test('a wrong token is refused for good', async () => {
  const other = await newPage();
  await other.goto(program.url.replace(/token=[0-9a-f]+/, 'token=00000000000000000000000000000000'));
  await other.waitForFunction(() => document.body.dataset.connection === 'refused');
  assert.match(await other.locator('.empty').innerText(), /no longer valid/);
  await other.context().close();
});

test('nothing on the page failed', () => {
  assert.deepEqual(page.faults, []);
});
