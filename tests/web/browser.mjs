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
  return { context, close };
}

/** Opens the page and waits until its window is drawn; `problems` collects what the console reports. */
export async function open(context, url) {
  const page = await context.newPage();
  const problems = [];
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(String(error)));
  await page.goto(url);
  await page.waitForFunction(() => document.documentElement.dataset.state !== "loading", undefined, { timeout: 120_000 });
  return { page, problems };
}
