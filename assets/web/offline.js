// Keeps what the page has loaded, so that it opens without a network, or with one that does not answer.
const kept = "shading-lab VERSION";

/** How long the server may take for the page itself when there is one to show already, milliseconds. */
const PATIENCE = 2000;

self.addEventListener("install", (event) => {
  const files = FILES;
  // What the page has just loaded comes from the browser's own store.
  const requests = files.map((file) => new Request(file, { cache: file.includes("?") ? "force-cache" : "default" }));
  event.waitUntil(caches.open(kept).then((cache) => cache.addAll(requests)).then(() => self.skipWaiting()));
});

self.addEventListener("activate", (event) => {
  const others = caches.keys().then((names) => names.filter((name) => name.startsWith("shading-lab") && name !== kept));
  event.waitUntil(others.then((names) => Promise.all(names.map((name) => caches.delete(name)))).then(() => self.clients.claim()));
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(self.registration.scope)) return;
  event.respondWith(answer(request));
});

async function answer(request) {
  const page = request.mode === "navigate";
  // A link with a scene in it opens the same page.
  const stored = await (await caches.open(kept)).match(request, { ignoreSearch: page });
  // What has the hash of its content in its address never changes.
  if (!stored || new URL(request.url).search === "?VERSION") return stored ?? fetch(request);
  const late = new Promise((use) => { setTimeout(() => use(stored), PATIENCE); });
  return Promise.race([whole(request), late]).catch(() => stored);
}

/** What the server answers, once all of it has come. */
async function whole(request) {
  const answer = await fetch(request);
  if (!answer.ok) throw new Error(answer.statusText);
  await answer.clone().arrayBuffer();
  return answer;
}
