// What the tests of the web page share: a server for the folder, browsers, and hands for the window.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { tmpdir } from "node:os";
import { after, before } from "node:test";
import { createRequire } from "node:module";

// Beside the other tools that `.ci/web` fetches.
const fetched = createRequire(join(process.env.SHADING_LAB_NODE, "package.json"));
const { chromium } = fetched("playwright-core");

const TYPES = {
  ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".png": "image/png",
  ".css": "text/css", ".webmanifest": "application/manifest+json", ".otf": "font/otf",
};

/**
 * Serves a folder on a port of the system's choice. With `own.stalled` it accepts requests and answers none; with `own.encoding`, "br" or
 * "gzip", it gives out the compressed files beside the others; the paths `own.together` are answered once all of them have been asked for;
 * `own.headers` come with each answer; `own.sent` lists what was sent.
 */
export async function serve(folder, own = {}) {
  own.sent = [];
  const missing = new Set(own.together);
  let release;
  const together = new Promise((done) => { release = done; });
  const server = createServer(async (request, response) => {
    if (own.stalled) return;
    let path = normalize(decodeURIComponent(new URL(request.url, "http://host").pathname));
    if (path.endsWith("/")) path += "index.html";
    if (missing.delete(path) && missing.size === 0) release();
    if (own.together?.includes(path)) await together;
    const headers = { ...own.headers, "Content-Type": TYPES[extname(path)] ?? "application/octet-stream" };
    try {
      let content = await readFile(join(folder, path));
      const packed = own.encoding && (await readFile(join(folder, `${path}.${own.encoding === "br" ? "br" : "gz"}`)).catch(() => undefined));
      if (packed) [content, headers["Content-Encoding"]] = [packed, own.encoding];
      own.sent.push({ path, bytes: content.length });
      response.writeHead(200, headers);
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  const { port } = server.address();
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return { url: `http://127.0.0.1:${port}/`, port, own, close };
}

/** A browser of its own, which keeps nothing. */
export async function browser({ width = 1280, height = 800, flags = [], ...others } = {}) {
  const folder = mkdtempSync(join(tmpdir(), "shading-lab-"));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", ...flags],
    viewport: { width, height },
    locale: "en-GB",
    ...others,
  });
  const close = async () => {
    await context.close();
    rmSync(folder, { recursive: true, force: true });
  };
  return { context, folder, close };
}

/** A Firefox of its own. It has WebGL without a graphics card only where it has a display. */
export async function firefox({ width = 1280, height = 800 } = {}) {
  const folder = mkdtempSync(join(tmpdir(), "shading-lab-"));
  const launched = await fetched("puppeteer-core").launch({
    browser: "firefox",
    executablePath: process.env.FIREFOX,
    headless: false,
    args: [`--width=${width}`, `--height=${height}`],
    defaultViewport: { width, height },
    extraPrefsFirefox: { "webgl.force-enabled": true, "intl.accept_languages": "en-GB" },
  });
  // As the other browser's.
  const newPage = async () => {
    const page = await launched.newPage();
    const own = { addInitScript: (script) => page.evaluateOnNewDocument(script) };
    return new Proxy(page, { get: (page, name) => own[name] ?? (typeof page[name] === "function" ? page[name].bind(page) : page[name]) });
  };
  const close = async () => {
    await launched.close();
    rmSync(folder, { recursive: true, force: true });
  };
  return { context: { newPage }, folder, close };
}

/** Notes in the page what workers are asked, and what they tell: 0 how far, 1 so far, 2 the answer, 3 why there is none. */
function noteWork() {
  window.work = [];
  const Plain = Worker;
  window.Worker = class extends Plain {
    constructor(...parameters) {
      super(...parameters);
      this.addEventListener("message", ({ data }) => this.piece?.told.push(data[0]));
    }
    postMessage(message) {
      if (Array.isArray(message)) window.work.push((this.piece = { name: message[0], told: [] }));
      super.postMessage(message);
    }
  };
}

/** What has been told about the latest work whose name has this in it; nothing before that was asked. */
export const told = (page, name) => page.evaluate((part) => window.work.findLast((piece) => piece.name.includes(part))?.told, name);

/** Forgets what the browser stores: unsaved work, and how the window looked. */
function forget() {
  localStorage.clear();
  sessionStorage.clear();
}

/**
 * Opens the page, after a script if one is given, and waits until its window is drawn; `problems` collects what the console
 * reports.
 */
export async function open(context, url, first) {
  const page = await context.newPage();
  await page.addInitScript(noteWork);
  if (first) await page.addInitScript(first);
  const problems = [];
  // Chromium says so of a swipe that follows another one at once.
  const follows = (text) => text.startsWith("Ignored attempt to cancel a touch");
  page.on("console", (message) => message.type() === "error" && !follows(message.text()) && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(String(error)));
  await page.goto(url);
  await until(async () => (await state(page)) !== "loading", 120_000);
  return { page, problems };
}

/** A server and a browser for the tests of a file. `on(path, todo)` opens the page, does this with it, and finds nothing in the console. */
export function site(launch = browser, options = {}) {
  const own = {};
  before(async () => {
    own.server = await serve(process.env.SHADING_LAB_PAGE);
    own.browser = await launch(options);
  });
  after(async () => {
    await own.browser?.close();
    own.server?.close();
  });
  own.on = async (path, todo) => {
    const { page, problems } = await open(own.browser.context, own.server.url + path, forget);
    try {
      assert.equal(await state(page), "ready");
      await todo(page);
      assert.deepEqual(problems, []);
    } finally {
      await page.close();
    }
  };
  return own;
}

/** Whether the page is loading, ready, or what hinders it. */
export const state = (page) => page.evaluate(() => document.documentElement.dataset.state);

/** Drops files on the window: the name and the content of each. */
export const drop = (page, ...files) =>
  page.evaluate((files) => {
    const dataTransfer = new DataTransfer();
    for (let at = 0; at < files.length; at += 2) {
      const bytes = Uint8Array.from(atob(files[at + 1]), (letter) => letter.charCodeAt(0));
      dataTransfer.items.add(new File([bytes], files[at]));
    }
    document.querySelector("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, files.map((text, at) => (at % 2 === 0 ? text : Buffer.from(text).toString("base64"))));

/** What stands in the address after the path. */
export const address = (page) => page.evaluate(() => location.search);

/** The size and the values of a PNG: red, green, blue and 255 of each pixel. */
export async function pixels(page, bytes) {
  const decoded = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }), { colorSpaceConversion: "none" });
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let letters = "";
    for (let at = 0; at < data.length; at += 32768) letters += String.fromCharCode(...data.subarray(at, at + 32768));
    return { width: image.width, height: image.height, data: btoa(letters) };
  }, Buffer.from(bytes).toString("base64"));
  return { ...decoded, data: new Uint8Array(Buffer.from(decoded.data, "base64")) };
}

/** The picture of the page, as a PNG with its scene inside. */
export const picture = async (page) => Buffer.from(await page.evaluate(async () => Array.from(await window.shadingLab.picture())));

/** The greatest difference of two pictures' values. */
export function difference(a, b) {
  assert.deepEqual([a.width, a.height], [b.width, b.height]);
  return a.data.reduce((most, value, index) => Math.max(most, Math.abs(value - b.data[index])), 0);
}

/** The native program, where there is one to compare with. */
export const native = existsSync(process.env.SHADING_LAB ?? "") && process.env.SHADING_LAB;

/** Whether the page in sight shows what the native program draws of its scene; says why that is not known. */
export async function isNative(page, folder) {
  const bytes = await picture(page);
  const drawn = await pixels(page, bytes);
  const values = new Set(drawn.data);
  assert.ok(values.size > 50, `${values.size} values in the picture`);
  if (!native) return "no native program to compare with";
  // The scene in the picture goes to the native program, which draws it again.
  const [ours, theirs] = ["ours", "theirs"].map((name) => join(folder, `${name}.png`));
  writeFileSync(ours, bytes);
  execFileSync(native, ["render", ours, "--size", `${drawn.width}x${drawn.height}`, "-o", theirs]);
  const most = difference(drawn, await pixels(page, readFileSync(theirs)));
  assert.ok(most <= 1, `${most} code values off`);
}

/** The controls and words of the window: their roles, names, values and places. The value of words is what they say. */
export const widgets = async (page) =>
  (await page.evaluate(() => window.shadingLab.widgets())).map((one) => ({ ...one, name: one.name || one.value || "" }));

/** The first one of a name, and of a role if that is given; nothing where there is none. */
export const widget = async (page, name, role) =>
  (await widgets(page)).find((one) => one.name === name && (role === undefined || one.role === role));

/** Waits for a control by its name, and presses its middle. */
export async function press(page, name, role = "Button") {
  let found;
  await until(async () => (found = await widget(page, name, role)) && !found.disabled);
  const [x, y] = [found.x + found.width / 2, found.y + found.height / 2];
  // A frame sees the pointer there before it is pressed.
  await page.mouse.move(x, y);
  await widgets(page);
  await page.mouse.down();
  await widgets(page);
  await page.mouse.up();
  await widgets(page);
}

/** Waits until something holds. */
export async function until(holds, milliseconds = 60_000) {
  for (const end = Date.now() + milliseconds; !(await holds()); ) {
    if (Date.now() > end) throw new Error(`not within ${milliseconds} ms: ${holds}`);
    await new Promise((again) => setTimeout(again, 100));
  }
}
