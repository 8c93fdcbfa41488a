// The examples and the bad examples of the rules, as the playground loads them.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { zipSync } from 'fflate';
import { stl } from './meshes.mjs';

/** The examples, the one with the most mistakes first, with the file that is open at first. */
const EXAMPLES = [
  { name: 'broken_cell', title: 'A work cell with 14 mistakes', open: 'src/broken_cell/urdf/broken_cell.xacro' },
  { name: 'defects', title: 'One mistake in each file', open: 'urdf/two_parents.urdf' },
  { name: 'two_joint_gripper', title: 'Two joints and a gripper', open: 'src/two_joint_gripper_description/urdf/two_joint_gripper.urdf.xacro' },
  { name: 'industrial_arm', title: 'A six-axis arm', open: 'src/lunder6_support/urdf/lunder6.xacro' },
  { name: 'measuring_cell', title: 'A work cell of three packages', open: 'src/measuring_cell/urdf/measuring_cell.xacro' },
  { name: 'pick_arm', title: 'An arm with MoveIt files', open: 'src/pick_arm_description/urdf/pick_arm.urdf.xacro' },
].map((example) => ({ ...example, robot: example.open }));

function* below(folder) {
  for (const name of readdirSync(folder).sort()) {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) yield* below(path);
    else yield path;
  }
}

/** The files of the site that hold the examples. */
export function examples(docs) {
  const folders = readdirSync(join(docs, 'examples')).filter((name) => statSync(join(docs, 'examples', name)).isDirectory());
  const forgotten = folders.filter((name) => !EXAMPLES.some((example) => example.name === name));
  if (forgotten.length > 0) throw new Error(`content.mjs does not list the examples ${forgotten}`);
  const files = { 'examples.json': Buffer.from(JSON.stringify(EXAMPLES)) };
  for (const { name, open } of EXAMPLES) {
    const folder = join(docs, 'examples', name);
    const own = Object.fromEntries([...below(folder)].map((path) => [relative(folder, path).split(sep).join('/'), readFileSync(path)]));
    if (!(open in own)) throw new Error(`${name} has no file ${open}`);
    // the same files give the same archive
    files[`examples/${name}.zip`] = Buffer.from(zipSync(own, { level: 9, mtime: '2000-01-01T12:00:00' }));
  }
  return files;
}

/** The first bad example of each rule; tests/rules.rs describes the blocks. */
export function rules(docs) {
  const folder = join(docs, 'rules');
  const all = {};
  for (const page of readdirSync(folder).sort()) {
    if (!page.endsWith('.md') || page === 'README.md') continue;
    const block = /^```(\w+),bad([^\n]*)\n(.*?)^```$/ms.exec(readFileSync(join(folder, page), 'utf8'));
    if (!block) throw new Error(`${page} has no bad example`);
    const [, kind, how, text] = block;
    all[page.slice(0, -3)] = rule(`robot.${kind}`, how.includes('latin-1'), text);
  }
  return { 'rules.json': Buffer.from(JSON.stringify(all)) };
}

function rule(first, isLatin1, text) {
  const files = [[first, []]];
  for (const line of text.split('\n').slice(0, -1)) {
    const [, name] = /^\/\/- (.*)$/.exec(line) ?? [];
    if (name !== undefined) {
      // the block begins with a name of its own
      if (files.length === 1 && files[0][1].length === 0) files.pop();
      files.push([name, []]);
    } else if (!/^ *\^+[ ^]*$/.test(line)) {
      files.at(-1)[1].push(line);
    }
  }
  const made = { files: {} };
  for (const [name, lines] of files) {
    const content = lines.map((line) => `${line}\n`).join('');
    const [path, recipe] = name.split(': ');
    if (recipe === undefined && !isLatin1) made.files[path] = content;
    else (made.data ??= {})[path] = (recipe === undefined ? Buffer.from(content, 'latin1') : stl(recipe)).toString('base64');
  }
  return made;
}
