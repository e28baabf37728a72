// What the tests of the web page share: a server for the folder, a browser, and the canvas.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { createRequire } from "node:module";

// Beside the other tools that `.ci/web` fetches.
const { chromium } = createRequire(join(process.env.SHADING_LAB_NODE, "package.json"))("playwright-core");

const TYPES = {
  ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".png": "image/png",
  ".webmanifest": "application/manifest+json", ".otf": "font/otf",
};

/** Serves a folder on a port of the system's choice. */
export async function serve(folder) {
  const server = createServer(async (request, response) => {
    let path = normalize(decodeURIComponent(new URL(request.url, "http://host").pathname));
    if (path.endsWith("/")) path += "index.html";
    try {
      const content = await readFile(join(folder, path));
      response.writeHead(200, { "Content-Type": TYPES[extname(path)] ?? "application/octet-stream" });
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  return { url: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

/** A browser of its own, which keeps nothing. */
export async function browser({ width = 1280, height = 800, ...others } = {}) {
  const folder = mkdtempSync(join(tmpdir(), "shading-lab-"));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
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

/** Opens the page and waits until its window is drawn; `problems` collects what the console reports. */
export async function open(context, url) {
  const page = await context.newPage();
  await page.addInitScript(noteWork);
  const problems = [];
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(String(error)));
  await page.goto(url);
  await page.waitForFunction(() => document.documentElement.dataset.state !== "loading", undefined, { timeout: 120_000 });
  return { page, problems };
}

/** The size and the values of a PNG: red, green, blue and 255 of each pixel. */
export async function pixels(page, bytes) {
  const decoded = await page.evaluate(async (text) => {
    const blob = await (await fetch(`data:image/png;base64,${text}`)).blob();
    const image = await createImageBitmap(blob, { colorSpaceConversion: "none" });
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

/** Waits until something holds. */
export async function until(holds, milliseconds = 60_000) {
  for (const end = Date.now() + milliseconds; !(await holds()); ) {
    if (Date.now() > end) throw new Error(`not within ${milliseconds} ms: ${holds}`);
    await new Promise((again) => setTimeout(again, 100));
  }
}
