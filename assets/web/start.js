// Loads the program and starts it on the canvas of the page, or says why that does not work.
const page = document.documentElement;
const say = (state) => { page.dataset.state = state; };
if ((navigator.language || "").toLowerCase().startsWith("zh")) page.lang = "zh-Hant";
if (matchMedia("(prefers-reduced-motion: reduce)").matches) page.dataset.motion = "reduce";
if (matchMedia("(pointer: coarse)").matches) page.dataset.coarse = "";

// Where the browser's tools imitate another screen, device pixels are those of the real one: then CSS pixels and their ratio count.
window.ResizeObserver = class extends ResizeObserver {
  constructor(callback) {
    super((entries, observer) => {
      const [{ contentRect, devicePixelContentBoxSize: pixels }] = entries;
      if (pixels && Math.abs(pixels[0].inlineSize - contentRect.width * devicePixelRatio) > 1) {
        delete ResizeObserverEntry.prototype.devicePixelContentBoxSize;
      }
      callback(entries, observer);
    });
  }
};

// What no program can catch, such as memory that has run out, stops it as well.
const isTrap = (error) => error instanceof WebAssembly.RuntimeError;
addEventListener("error", ({ error }) => { if (isTrap(error)) say("stopped"); });
addEventListener("unhandledrejection", ({ reason }) => { if (isTrap(reason)) say("stopped"); });

// A function that makes a vector: browsers without SIMD refuse it.
const simd = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]);
const canvas = document.createElement("canvas");
if (!(canvas.getContext("webgl2") || canvas.getContext("webgl"))) say("no-webgl");
else if (typeof WebAssembly !== "object" || !WebAssembly.validate(simd)) say("no-simd");
else try {
  const { default: start } = await import("./shading-lab.js?VERSION");
  const answer = await fetch("shading-lab_bg.wasm?VERSION");
  if (!answer.ok) throw new Error(`${answer.url}: ${answer.status}`);
  const bar = document.querySelector("progress");
  let read = 0;
  const counted = answer.body.pipeThrough(new TransformStream({
    transform(piece, out) {
      read += piece.length;
      bar.value = read / WASM_BYTES;
      out.enqueue(piece);
    },
  }));
  const headers = { "Content-Type": "application/wasm" };
  const module = await WebAssembly.compileStreaming(new Response(counted, { headers }));
  // Each tab holds a lock of the name of its unsaved work, which others are not offered meanwhile.
  const { locks } = navigator;
  const held = locks ? (await locks.query()).held.map(({ name }) => name) : [];
  const hold = (name) => { locks?.request(name, () => new Promise(() => {})); };
  window.shadingLab = { module, held, hold };
  // The window's toolkit stores the window's look at an event that browsers do not have. Phones have the second one only.
  for (const leaving of ["beforeunload", "pagehide"]) addEventListener(leaving, () => dispatchEvent(new Event("onbeforeunload")));
  await start({ module_or_path: window.shadingLab.module });
  if ("serviceWorker" in navigator && isSecureContext) navigator.serviceWorker.register("offline.js").catch(() => {});
} catch (error) {
  console.error(error);
  // A browser too old for the page's policy compiles nothing.
  const old = error instanceof WebAssembly.CompileError;
  if (isTrap(error)) say("stopped");
  else if (page.dataset.state === "loading") say(old ? "no-simd" : "no-file");
}
