// The page on networks as they are: one that stalls, plain http, a strict policy, compressed files; and what a visit transfers.
import { test } from "node:test";
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { browser, firefox, open, press, serve, state, until, widget, widgets } from "./browser.mjs";

const folder = process.env.SHADING_LAB_PAGE;
/** A name that no browser takes for its own machine, so that plain http is no secure context there. */
const NAME = "lab.test";

/** Serves the page and opens a browser for one test. */
async function within({ launch = browser, server: own = {}, ...options }, todo) {
  const server = await serve(folder, own);
  const launched = await launch(options);
  try {
    await todo(launched.context, server, own);
  } finally {
    await launched.close();
    server.close();
  }
}

const browsers = [["Chromium", browser]];
if (process.env.FIREFOX) browsers.push(["Firefox", firefox]);
for (const [name, launch] of browsers) {
  test(`${name}: a page that is kept opens although its server stalls`, async () => {
    await within({ launch }, async (context, server, own) => {
      const { page } = await open(context, server.url);
      const full = () => page.evaluate(async () => {
        const [kept] = await caches.keys();
        return kept !== undefined && (await (await caches.open(kept)).keys()).length > 8 && Boolean(navigator.serviceWorker.controller);
      });
      await until(full);
      await page.close();
      own.stalled = true;
      const again = await context.newPage();
      const started = performance.now();
      await again.goto(`${server.url}?scene=cube`);
      await until(async () => (await state(again)) === "ready", 20_000);
      const seconds = (performance.now() - started) / 1000;
      assert.ok(seconds < 8, `${seconds} s`);
      assert.ok((await again.title()).startsWith("cube"));
      await again.close();
    });
  });
}

test("the program's files are requested together, before any has come", async () => {
  const together = ["/start.js", "/shading-lab.js", "/shading-lab_bg.wasm"];
  await within({ server: { together } }, async (context, server, own) => {
    const { page } = await open(context, server.url);
    assert.equal(await state(page), "ready");
    for (const path of together) assert.ok(own.sent.some((sent) => sent.path === path), path);
  });
});

test("each file has its compressed forms beside it, which unpack to it, and the first picture takes at most 2.6 MB", async (context) => {
  const packed = readdirSync(folder).filter((file) => /\.(html|css|js|wasm|otf|txt|webmanifest)$/.test(file));
  assert.ok(packed.length > 9, packed.join());
  if (!existsSync(join(folder, "index.html.br"))) return context.skip("no brotli where the page was built");
  for (const file of packed) {
    const plain = readFileSync(join(folder, file));
    assert.ok(gunzipSync(readFileSync(join(folder, `${file}.gz`))).equals(plain), file);
    assert.ok(brotliDecompressSync(readFileSync(join(folder, `${file}.br`))).equals(plain), file);
  }
  const first = ["index.html", "page.css", "start.js", "window.js", "mirror.js", "shading-lab.js", "shading-lab_bg.wasm"];
  const bytes = first.reduce((sum, file) => sum + readFileSync(join(folder, `${file}.br`)).length, 0);
  assert.ok(bytes <= 2.6e6, `${bytes} bytes`);
});

test("what a visit transfers", async (context) => {
  if (!existsSync(join(folder, "index.html.br"))) return context.skip("no brotli where the page was built");
  /** The bytes of a first visit and of the next one. */
  const visit = async (encoding) => {
    let bytes;
    await within({ server: { encoding } }, async (browser, server, own) => {
      const { page } = await open(browser, server.url);
      await page.evaluate(() => navigator.serviceWorker.ready);
      await page.waitForTimeout(1500);
      const sent = () => own.sent.splice(0).reduce((sum, { bytes }) => sum + bytes, 0);
      bytes = [sent()];
      await page.close();
      await open(browser, server.url);
      bytes.push(sent());
      const told = bytes.map((bytes) => `${(bytes / 1e6).toFixed(3)} MB`);
      context.diagnostic(`${encoding ?? "plain"}: ${told.join(", then ")}`);
    });
    return bytes;
  };
  const [plain, gzip, brotli] = [await visit(), await visit("gzip"), await visit("br")];
  assert.ok(brotli[0] < gzip[0] && gzip[0] < plain[0]);
  for (const [, next] of [plain, gzip, brotli]) assert.ok(next < 50_000, `${next} bytes once more`);
});

test("on plain http a link is copied, and a second tab is not offered the work of the first", async () => {
  const options = { flags: [`--host-resolver-rules=MAP ${NAME} 127.0.0.1`], permissions: [] };
  await within(options, async (context, server) => {
    const url = `http://${NAME}:${server.port}/`;
    const { page, problems } = await open(context, `${url}?scene=sphere`);
    assert.equal(await page.evaluate(() => isSecureContext), false);
    await page.evaluate(() => {
      window.copied = [];
      document.addEventListener("copy", () => window.copied.push(document.getSelection().toString() || document.activeElement.value), true);
    });
    await press(page, "Picture, Phong shading", "Image");
    await page.keyboard.press("Control+Shift+L");
    await until(() => page.evaluate(() => window.copied.some((text) => text.includes("?scene=sphere"))));
    await until(async () => (await widgets(page)).some(({ name }) => name.startsWith("Copied the link")));
    // Work that this tab has and another one must not be offered.
    await page.keyboard.press("3");
    await until(() => page.evaluate(() => Object.keys(localStorage).some((name) => name.startsWith("shading-lab-work-"))));
    const other = await open(context, `${url}?scene=cube`);
    await widgets(other.page);
    assert.equal(await widget(other.page, "Restore"), undefined);
    assert.deepEqual(problems, []);
  });
});

test("it opens under the strictest policy that a server can set", async () => {
  const headers = { "Content-Security-Policy": "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self'; connect-src 'self'; worker-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none'" };
  await within({ server: { headers } }, async (context, server) => {
    const { page, problems } = await open(context, `${server.url}?scene=sphere&view=study`);
    assert.equal(await state(page), "ready");
    await until(async () => (await widget(page, "Measure")) !== undefined);
    assert.deepEqual(problems, []);
  });
});
