// Links of the pages as they were built: mdBook renames pages and headings, so what is right in Markdown may be wrong here.
import assert from 'node:assert/strict';
import { existsSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { pages, root, text } from './site.mjs';

const unescaped = (value) => value.replaceAll('&amp;', '&').replaceAll('&#39;', "'").replaceAll('&quot;', '"');
const attributes = (html, name) => [...html.matchAll(new RegExp(`\\s${name}="([^"]*)"`, 'g'))].map(([, value]) => unescaped(value));

const ids = new Map();
function idsOf(path) {
  if (!ids.has(path)) ids.set(path, new Set(attributes(text(path), 'id')));
  return ids.get(path);
}

/** What is wrong with a link of a page. */
function wrong(page, target) {
  if (/^(https?:|mailto:|data:|javascript:)/.test(target)) return;
  const [path, heading] = target.split('#');
  const folder = path.startsWith('/') ? '' : dirname(page);
  let file = path === '' ? page : join(folder, decodeURIComponent(path.split('?')[0]));
  if (existsSync(join(root, file)) && statSync(join(root, file)).isDirectory()) file = join(file, 'index.html');
  if (!existsSync(join(root, file))) return `${page}: ${target}: no such file`;
  if (heading && file.endsWith('.html') && !idsOf(file).has(decodeURIComponent(heading))) return `${page}: ${target}: no such heading`;
}

test('every link of the site leads somewhere', () => {
  const all = pages();
  assert.ok(all.length > 200, `${all.length} pages`);
  const found = all.flatMap((page) => {
    const html = text(page);
    return [...attributes(html, 'href'), ...attributes(html, 'src')].map((target) => wrong(page, target)).filter(Boolean);
  });
  assert.deepEqual([...new Set(found)], []);
});

test('every page has a title and a heading', () => {
  for (const page of pages()) {
    const html = text(page);
    assert.match(html, /<title>[^<]+<\/title>/, page);
    assert.match(html, /<h1 id="[^"]+"/, page);
  }
});
