// Keeps every file of the playground, so that it works without a network. `build.mjs` puts in the list and its version.
const VERSION = '__VERSION__';
const FILES = __FILES__;
const name = `playground-${VERSION}`;

self.addEventListener('install', (event) => {
  event.waitUntil(caches.open(name).then((cache) => cache.addAll(FILES.map((file) => new Request(file, { cache: 'reload' }))))
    .then(() => self.skipWaiting()));
});

self.addEventListener('activate', (event) => {
  const others = (names) => names.filter((one) => one.startsWith('playground-') && one !== name);
  event.waitUntil(caches.keys().then((names) => Promise.all(others(names).map((one) => caches.delete(one))))
    .then(() => self.clients.claim()));
});

self.addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET') return;
  const known = caches.open(name).then((cache) => cache.match(event.request, { ignoreSearch: true }));
  event.respondWith(known.then((answer) => answer ?? fetch(event.request)));
});
