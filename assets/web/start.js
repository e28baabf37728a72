// Loads the program and starts it on the canvas of the page, or says why that does not work.
import { showMirror } from "./mirror.js?VERSION";
import { atRest, passTab, wake } from "./window.js?VERSION";

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

// Each tab holds the name of its unsaved work, which others are not offered meanwhile: by a lock, or, where the browser has none, as on
// plain http, by answering those that ask.
const { locks } = navigator;
const channel = locks ? undefined : new BroadcastChannel("shading-lab");
const own = new Set();
const hold = (name) => {
  own.add(name);
  locks?.request(name, () => new Promise(() => {}));
};
async function heldNames() {
  if (locks) return (await locks.query()).held.map(({ name }) => name);
  const held = [];
  channel.onmessage = ({ data }) => { if (Array.isArray(data)) held.push(...data); else channel.postMessage([...own]); };
  channel.postMessage("who holds what?");
  if (Object.keys(localStorage).some((name) => name.startsWith("shading-lab-work-"))) await new Promise((later) => setTimeout(later, 200));
  return held;
}

/** Copies a text where scripts have no clipboard; one that cannot be copied is shown, to be copied by hand. */
function copy(text) {
  const field = document.body.appendChild(document.createElement("textarea"));
  const before = document.activeElement;
  field.value = text;
  field.select();
  const copied = document.execCommand("copy");
  field.remove();
  before?.focus({ preventScroll: true });
  if (!copied) prompt("", text);
}

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
  window.shadingLab = { module, held: await heldNames(), hold, wake, copy };
  // A figure takes the focus from the page around it when it is clicked, not when it is loaded.
  document.body.inert = "embed" in page.dataset;
  new MutationObserver((_, observer) => {
    observer.disconnect();
    document.body.inert = false;
    passTab(window.shadingLab);
    showMirror(window.shadingLab);
    atRest(() => window.shadingLab.rest());
  }).observe(page, { attributeFilter: ["data-state"] });
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
