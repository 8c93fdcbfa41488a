import { readFileSync } from 'node:fs';
const base = './setup.mjs';
const { preview, newPage, settled, drawn, endBrowser, shot } = await import(base);
const [name, cwd, ...args] = process.argv.slice(2);
const act = process.env.ACT ?? '';
const program = await preview(args, cwd);
const page = await newPage(process.env.DARK ? { colorScheme: 'dark' } : {});
await page.route('**/viewer.js', (route) => route.fulfill({ contentType: 'text/javascript', body: readFileSync('/work/wt-preview/editors/viewer/dist/viewer.js') }));
const begin = Date.now();
await page.goto(program.url);
await settled(page);
console.log(name, 'loaded in', Date.now() - begin, 'ms', await page.evaluate(() => document.querySelector('.banner').innerText.slice(0, 300)));
if (act) await page.evaluate(new Function(act));
if (process.env.KEYS) { await page.locator('canvas').first().focus(); for (const k of process.env.KEYS) await page.keyboard.press(k); }
await drawn(page);
await shot(page, name);
console.log(page.faults);
await endBrowser(); program.end();
