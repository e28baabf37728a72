// Keeps what the page has loaded, so that it opens without a network. With one, what the server has goes first.
const kept = "shading-lab VERSION";

self.addEventListener("install", (event) => {
  const files = FILES;
  event.waitUntil(caches.open(kept).then((cache) => cache.addAll(files)).then(() => self.skipWaiting()));
});

self.addEventListener("activate", (event) => {
  const others = caches.keys().then((names) => names.filter((name) => name.startsWith("shading-lab") && name !== kept));
  event.waitUntil(others.then((names) => Promise.all(names.map((name) => caches.delete(name)))).then(() => self.clients.claim()));
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(self.registration.scope)) return;
  // A link with a scene in it opens the same page.
  const stored = () => caches.open(kept).then((cache) => cache.match(request, { ignoreSearch: request.mode === "navigate" }));
  event.respondWith(fetch(request).catch(async (error) => {
    const answer = await stored();
    if (answer) return answer;
    throw error;
  }));
});
