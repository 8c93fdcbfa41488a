// The site as it was built, and a server for it.
import { createServer } from 'node:http';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { dirname, extname, join, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';

const site = join(dirname(fileURLToPath(import.meta.url)), '../../target/site');
export const root = site;

const TYPES = {
  '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.svg': 'image/svg+xml', '.png': 'image/png',
  '.json': 'application/json', '.woff2': 'font/woff2', '.wasm': 'application/wasm', '.zip': 'application/zip',
};

function* below(folder) {
  for (const name of readdirSync(folder)) {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) yield* below(path);
    else yield path;
  }
}

/** Paths of all pages, as they stand in addresses. */
export function pages() {
  const files = [...below(root)].map((path) => relative(root, path).split(sep).join('/'));
  // the frame is for browsers without scripts; the playground has tests of its own
  const others = (path) => ['404.html', 'toc.html'].includes(path) || path.startsWith('playground/');
  return files.filter((path) => path.endsWith('.html') && !others(path)).sort();
}

export const text = (page) => readFileSync(join(root, page), 'utf8');

/** The site, or another folder, on a free port of this machine. */
export async function serve(root = site) {
  const server = createServer((request, response) => {
    const path = join(root, decodeURIComponent(new URL(request.url, 'http://x').pathname));
    const file = existsSync(path) && statSync(path).isDirectory() ? join(path, 'index.html') : path;
    if (!file.startsWith(root) || !existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' }).end(readFileSync(file));
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return { address: `http://127.0.0.1:${server.address().port}`, end: () => server.close() };
}
