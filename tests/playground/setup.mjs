// What the tests of the playground share: the page as it was built, and a browser. PLAYGROUND_SHOTS names a folder for pictures.
import { mkdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { serve } from '../site/site.mjs';

export const top = join(dirname(fileURLToPath(import.meta.url)), '../..');
export const built = join(top, 'target/playground/site');
export const WIDE = { width: 1400, height: 900 };
export const NARROW = { width: 400, height: 800 };

let browser, site;

export async function begin() {
  site = await serve(built);
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
      '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
}

export async function end() {
  await browser?.close();
  site?.end();
}

export const address = (fragment = '') => `${site.address}/${fragment}`;

/** A page that collects what goes wrong in it, and every request it makes. */
export async function newPage(options = {}) {
  const context = await browser.newContext({ viewport: WIDE, colorScheme: 'light', serviceWorkers: 'block', ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(20000);
  page.faults = [];
  page.requests = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && page.faults.push(message.text()));
  context.on('request', (request) => page.requests.push(request));
  return page;
}

/** Open the playground and wait for its first answer. */
export async function open(fragment, options) {
  const page = await newPage(options);
  await page.goto(address(fragment));
  await answered(page);
  return page;
}

/** Wait until everything that was typed is answered. */
export async function answered(page) {
  await page.waitForFunction(() => document.body.dataset.answers && window.playground.project.changed.size === 0);
}

/** The names of the rules that found something. */
export const rules = (page) => page.locator('#problems li').evaluateAll((items) => items.map((item) => item.dataset.rule));

/** Put the cursor behind a text of the file that is open. */
export async function cursor(page, text, from = 0) {
  await page.evaluate(([wanted, begin]) => {
    const { editor } = window.playground;
    const at = editor.view.state.doc.toString().indexOf(wanted, begin);
    if (at < 0) throw new Error(`no ${wanted}`);
    editor.select(at + wanted.length, at + wanted.length);
  }, [text, from]);
}

export const source = (page) => page.evaluate(() => window.playground.editor.view.state.doc.toString());

export const expanded = (page) => page.evaluate(() => window.playground.expanded.view.state.doc.toString());

export async function shot(page, name) {
  const folder = process.env.PLAYGROUND_SHOTS;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}
