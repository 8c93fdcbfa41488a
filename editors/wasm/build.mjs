// Puts what is built elsewhere beside the scripts: the program (tests/playground/build.sh makes it) and the licenses.
import { copyFileSync, existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const top = join(here, '../..');
const program = process.env.XACRO_LINT_WASM ?? join(top, 'target/playground/xacro_lint.wasm');
if (!existsSync(program)) {
  console.error(`${program} is missing: run tests/playground/build.sh first`);
  process.exit(1);
}
copyFileSync(program, join(here, 'dist/xacro_lint.wasm'));
for (const license of ['LICENSE-MIT', 'LICENSE-APACHE']) copyFileSync(join(top, license), join(here, license));
