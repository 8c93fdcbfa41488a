// The site in a real browser: light and dark, narrow and wide. SITE_SHOTS names a folder for pictures.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { pages, serve } from './site.mjs';

/** Pages of every kind, looked at in every way; the others are looked at narrow. */
const KINDS = [
  'index.html', 'first-run.html', 'cli.html', 'configuration.html', 'editors.html', 'faq/README.html', 'faq/errors.html',
  'comparison.html', 'compatibility.html', 'architecture.html', 'rules/README.html', 'rules/multiple-parents.html',
];
const NARROW = { width: 400, height: 800 };
const WIDE = { width: 1280, height: 900 };

let browser, site;

before(async () => {
  site = await serve();
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
});

after(async () => {
  await browser?.close();
  site?.end();
});

/** A page that collects what goes wrong in it. */
async function open(viewport, colorScheme) {
  const context = await browser.newContext({ viewport, colorScheme });
  const page = await context.newPage();
  page.setDefaultTimeout(30000);
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && page.faults.push(message.text()));
  page.on('response', (answer) => answer.status() >= 400 && page.faults.push(`${answer.status()} ${answer.url()}`));
  page.on('request', (request) => request.url().startsWith('http') && !request.url().startsWith(site.address)
    && page.faults.push(`asks for ${request.url()}`));
  return page;
}

/** What is wrong with the page as it is drawn. */
const faults = (page) => page.evaluate(async () => {
  await Promise.all([...document.images].map((image) => image.decode().catch(() => {})));
  const found = [];
  for (const image of document.images) if (!image.naturalWidth) found.push(`broken picture ${image.src}`);
  const all = document.scrollingElement;
  if (all.scrollWidth > all.clientWidth) {
    const wide = [...document.querySelectorAll('main *')].filter((element) => element.getBoundingClientRect().right > all.clientWidth + 1);
    found.push(`${all.scrollWidth} wide in ${all.clientWidth}: ${wide.at(-1)?.outerHTML.slice(0, 120)}`);
  }
  const main = document.querySelector('main');
  if (!main || main.innerText.length < 80) found.push('nothing to read');
  return found;
});

async function look(page, path) {
  await page.goto(`${site.address}/${path}`);
  const found = [...page.faults.splice(0), ...(await faults(page))];
  return found.map((fault) => `${path}: ${fault}`);
}

async function shot(page, path, name) {
  if (!process.env.SITE_SHOTS) return;
  mkdirSync(process.env.SITE_SHOTS, { recursive: true });
  await page.screenshot({ path: join(process.env.SITE_SHOTS, `${path.replaceAll('/', '-').replace('.html', '')}-${name}.png`) });
}

/** How bright the paper is, 0 to 255. */
const paper = (page) => page.evaluate(() => {
  const [red, green, blue] = getComputedStyle(document.documentElement).backgroundColor.match(/[\d.]+/g).map(Number);
  return (red + green + blue) / 3;
});

for (const scheme of ['light', 'dark']) {
  for (const [name, viewport] of Object.entries({ narrow: NARROW, wide: WIDE })) {
    test(`pages of every kind, ${scheme} and ${name}`, async () => {
      const page = await open(viewport, scheme);
      const found = [];
      for (const path of KINDS) {
        found.push(...await look(page, path));
        await shot(page, path, `${scheme}-${name}`);
      }
      const bright = await paper(page);
      assert.ok(scheme === 'dark' ? bright < 90 : bright > 200, `brightness ${bright}`);
      assert.deepEqual(found, []);
      await page.context().close();
    });
  }
}

test('all pages, narrow', async () => {
  const page = await open(NARROW, 'light');
  const found = [];
  for (const path of pages().filter((path) => !KINDS.includes(path))) found.push(...await look(page, path));
  assert.deepEqual(found, []);
  await page.context().close();
});

test('code has colors, and the marks of bad examples are seen', async () => {
  const page = await open(WIDE, 'light');
  await page.goto(`${site.address}/rules/multiple-parents.html`);
  assert.ok(await page.locator('code.language-urdf .hljs-tag').count() > 10);
  assert.ok(await page.locator('code.bad .said-mark').count() > 0);
  await page.goto(`${site.address}/faq/errors.html`);
  assert.ok(await page.locator('code.language-console .said-error').count() > 5);
  await page.context().close();
});

test('the search finds a rule by its code', async () => {
  const page = await open(WIDE, 'light');
  await page.goto(`${site.address}/index.html`);
  await page.keyboard.press('s');
  await page.locator('#mdbook-searchbar, #searchbar').first().pressSequentially('STR008');
  const results = page.locator('#mdbook-searchresults li, #searchresults li');
  await results.filter({ hasText: 'orphan-link' }).first().waitFor();
  assert.deepEqual(page.faults, []);
  await page.context().close();
});
