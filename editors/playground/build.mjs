// Builds the playground into target/playground/site: static files, to be put beside the pages of the documentation.
//
// What is built elsewhere has to be there: the program for WebAssembly and the viewer. tests/playground/site.sh builds all.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { examples, rules } from './content.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const top = join(here, '../..');
const out = join(top, 'target/playground/site');

function built(path, how) {
  if (existsSync(join(top, path))) return readFileSync(join(top, path));
  console.error(`${path} is missing: run ${how} first`);
  process.exit(1);
}

const { outputFiles } = await build({
  absWorkingDir: here,
  entryPoints: { playground: 'src/main.ts', worker: 'src/worker.ts' },
  outdir: 'dist',
  bundle: true,
  minify: true,
  format: 'esm',
  target: 'es2022',
  legalComments: 'eof',
  logLevel: 'warning',
  write: false,
});
const docs = join(top, 'docs');
const files = {
  ...Object.fromEntries(readdirSync(join(here, 'static')).map((name) => [name, readFileSync(join(here, 'static', name))])),
  ...Object.fromEntries(outputFiles.map(({ path, contents }) => [path.split(/[\\/]/).pop(), Buffer.from(contents)])),
  ...examples(docs),
  ...rules(docs),
  'xacro_lint.wasm': built('target/playground/xacro_lint.wasm', 'tests/playground/build.sh'),
  'viewer.js': built('editors/viewer/dist/viewer.js', '`npm run build` in editors/viewer'),
};

// the worker that keeps the files for use without a network knows them, and when they changed
const kept = Object.keys(files).filter((name) => name !== 'sw.js').sort();
const version = createHash('sha256');
for (const name of kept) version.update(name).update(files[name]);
const worker = String(files['sw.js']).replace('__VERSION__', version.digest('hex').slice(0, 16)).replace('__FILES__', JSON.stringify(['./', ...kept]));
files['sw.js'] = Buffer.from(worker);

rmSync(out, { recursive: true, force: true });
for (const [name, content] of Object.entries(files)) {
  mkdirSync(dirname(join(out, name)), { recursive: true });
  writeFileSync(join(out, name), content);
}
