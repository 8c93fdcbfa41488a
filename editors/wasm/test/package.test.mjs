// The package as users get it: packed, installed into a folder, and called from there.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';

const here = join(dirname(fileURLToPath(import.meta.url)), '..');
const top = join(here, '../..');
const folder = mkdtempSync(join(tmpdir(), 'xacro-lint-wasm-'));
after(() => rmSync(folder, { recursive: true }));

const npm = (args, cwd) => execFileSync('npm', args, { cwd, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
const packed = JSON.parse(npm(['pack', '--ignore-scripts', '--json', '--pack-destination', folder], here))[0];
writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
npm(['install', '--silent', '--offline', '--no-audit', '--no-fund', join(folder, packed.filename)], folder);
const installed = join(folder, 'node_modules/xacro-lint-wasm');
const { Linter, check, expand } = await import(pathToFileURL(join(installed, 'dist/index.js')).href);

function* below(at) {
  for (const name of readdirSync(at)) {
    const path = join(at, name);
    if (statSync(path).isDirectory()) yield* below(path);
    else yield path;
  }
}

function example(name) {
  const root = join(top, 'docs/examples', name);
  return Object.fromEntries([...below(root)].map((path) => [relative(root, path), new Uint8Array(readFileSync(path))]));
}

test('holds what it needs, and is small', () => {
  for (const name of ['dist/index.d.ts', 'dist/xacro_lint.wasm', 'LICENSE-MIT']) assert.ok(existsSync(join(installed, name)), name);
  const size = gzipSync(readFileSync(join(installed, 'dist/xacro_lint.wasm')), { level: 9 }).length;
  assert.ok(size < 3_000_000, `${size} bytes compressed`);
});

test('finds a mistake, and its fix', async () => {
  const robot = (child) => `<robot name="arm"><link name="base_link"/><link name="upper_arm"/>
<joint name="shoulder" type="fixed"><parent link="base_link"/><child link="${child}"/></joint></robot>`;
  const [found] = await check({ 'arm.urdf': robot('uper_arm') }, { select: ['undefined-link'] });
  assert.deepEqual([found.code, found.filename, found.location.row], ['STR003', 'arm.urdf', 2]);
  assert.equal(found.fix.edits[0].content, 'upper_arm');
  assert.deepEqual(await check({ 'arm.urdf': robot('upper_arm') }, { select: ['undefined-link'] }), []);
  await assert.rejects(check({}, { select: ['no-such-rule'] }), /no-such-rule/);
});

test('expands with arguments, and says where from', async () => {
  const file = 'src/lunder6_support/urdf/lunder6.xacro';
  const { text, map, files } = await expand(example('industrial_arm'), file, { prefix: 'left_' });
  assert.match(text, /<link name="left_base_link">/);
  assert.ok(map.map.length > 100 && files.length === 3, `${map.map.length} ${files}`);
});

test('has types that a program in TypeScript can use', () => {
  const program = `import { Linter, type Finding } from 'xacro-lint-wasm';
const linter = await Linter.create();
linter.replace({ 'a.urdf': '<robot name="a"/>', 'a.stl': new Uint8Array(84) });
export const found: Finding[] = linter.check({ select: ['STR003'], profile: ['ros2'], args: { prefix: 'left_' } });
export const line: number | undefined = found[0]?.fix?.edits[0]?.end_location.row;
export const text: string | null = linter.expand('a.urdf').text;`;
  writeFileSync(join(folder, 'program.ts'), program);
  const options = ['--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022', '--lib', 'es2023,dom'];
  execFileSync(process.execPath, [join(here, 'node_modules/typescript/bin/tsc'), ...options, 'program.ts'], { cwd: folder, stdio: 'inherit' });
});

// The same texts give the same answers, whoever is asked. The command line gets a copy: what lies around an example in this
// repository is not known to the package.
const program = process.env.XACRO_BIN_DIR && join(process.env.XACRO_BIN_DIR, 'xacro-lint');
const skip = program ? false : 'XACRO_BIN_DIR names no program to compare with';
const run = (args, cwd) => {
  const { stdout, status } = spawnSync(program, args, { cwd, encoding: 'utf8', env: { HOME: join(folder, 'home') }, maxBuffer: 2 ** 28 });
  return { stdout, status };
};
// what differs: how many folders above an example were searched, and where the example lies
const known = (text, cwd) => text.replaceAll(/\(searched \d+ folders?\)/g, '(searched folders)').replaceAll(cwd ?? '/workspace', '/workspace');
/** The first line that differs, instead of two whole texts. */
const same = (ours, theirs, about) => {
  const [one, other] = [ours.split('\n'), theirs.split('\n')];
  const at = one.findIndex((line, index) => line !== other[index]);
  assert.ok(ours === theirs, `${about}, line ${at + 1}: ${one[at]} instead of ${other[at]}`);
};

for (const name of readdirSync(join(top, 'docs/examples')).filter((one) => !one.includes('.'))) {
  const copy = (to) => {
    const cwd = join(folder, 'copies', name, to);
    cpSync(join(top, 'docs/examples', name), cwd, { recursive: true });
    return cwd;
  };

  test(`finds in ${name} what the command line finds`, { skip }, async () => {
    const { stdout } = run(['check', '--format', 'json', '--exit-zero', '.'], copy('check'));
    same(known(JSON.stringify(await check(example(name)), null, 2)), known(stdout.trimEnd()), name);
  });

  test(`expands ${name} as the command line does`, { skip }, async () => {
    const cwd = copy('expand');
    const linter = await Linter.create();
    linter.replace(example(name));
    const files = Object.keys(example(name)).filter((file) => /\.(xacro|urdf|srdf)$/.test(file));
    assert.ok(files.length > 0 && linter.robots().every((robot) => files.includes(robot)), linter.robots().join());
    for (const file of files) {
      const { stdout, status } = run(['expand', file], cwd);
      const { text, problems } = linter.expand(file);
      same(text ?? '', known(stdout, cwd), file);
      assert.equal(problems.some(({ severity }) => severity === 'error'), status !== 0, `${file}: ${JSON.stringify(problems[0])}`);
    }
  });

  for (const unsafeFixes of [false, true]) {
    test(`fixes ${name} as the command line does, ${unsafeFixes ? 'unsafely' : 'safely'}`, { skip }, async () => {
      const cwd = copy(unsafeFixes ? 'unsafe' : 'safe');
      run(['check', '--fix', ...(unsafeFixes ? ['--unsafe-fixes'] : []), '--exit-zero', '.'], cwd);
      const before = example(name);
      const changed = [...below(cwd)].map((path) => [relative(cwd, path), readFileSync(path)])
        .filter(([path, bytes]) => !bytes.equals(before[path]));
      const linter = await Linter.create();
      linter.replace(before);
      assert.deepEqual(linter.fix({ unsafeFixes }).files, Object.fromEntries(changed.map(([path, bytes]) => [path, String(bytes)])));
    });
  }
}

test('goes on after text that nests without end', async () => {
  const linter = await Linter.create();
  const nested = (depth) => '<robot name="r">' + '<a>'.repeat(depth) + '</a>'.repeat(depth) + '</robot>';
  linter.put('deep.urdf', nested(20_000));
  try {
    assert.ok(linter.check().length > 0);
  } catch (error) {
    assert.match(error.message, /nests more deeply/);
  }
  linter.put('deep.urdf', '<robot name="r"><link name="a"/></robot>');
  assert.deepEqual(linter.check(), []);
  assert.deepEqual(linter.robots(), ['deep.urdf']);
});
