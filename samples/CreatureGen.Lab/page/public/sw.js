// Keeps the page for times without a network: all of its files at the first visit; after that what the network has is newer and comes first.
const prefix = 'creature-lab-';

async function fill() {
  const { version, files } = await (await fetch('./files.json', { cache: 'no-store' })).json();
  const cache = await caches.open(prefix + version);
  // A file after the other, as somebody plays meanwhile.
  for (const file of ['./', ...files]) {
    await cache.add(file);
  }
  for (const other of await caches.keys()) {
    if (other.startsWith(prefix) && other !== prefix + version) {
      await caches.delete(other);
    }
  }
}

self.addEventListener('install', event => {
  self.skipWaiting();
  event.waitUntil(fill());
});

self.addEventListener('activate', event => event.waitUntil(self.clients.claim()));

self.addEventListener('fetch', event => {
  const { request } = event;
  if (request.method === 'GET' && new URL(request.url).origin === location.origin) {
    event.respondWith(fetch(request).catch(async problem => (await caches.match(request, { ignoreSearch: true })) ?? Promise.reject(problem)));
  }
});
