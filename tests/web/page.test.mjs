// The web page in a browser: it opens, draws what the native program draws, follows links, and works in the background.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { browser, open, pixels, serve, until } from "./browser.mjs";

const folder = process.env.SHADING_LAB_PAGE;
const native = process.env.SHADING_LAB;
let server;
let chromium;

before(async () => {
  server = await serve(folder);
  chromium = await browser();
});

after(async () => {
  await chromium?.close();
  server?.close();
});

/** Opens the page, does this with it, and finds nothing in the console. */
async function on(path, todo) {
  const { page, problems } = await open(chromium.context, server.url + path);
  try {
    assert.equal(await page.evaluate(() => document.documentElement.dataset.state), "ready");
    await todo(page);
    assert.deepEqual(problems, []);
  } finally {
    await page.close();
  }
}

/** The picture of the page, as a PNG with its scene inside. */
const picture = async (page) => Buffer.from(await page.evaluate(async () => Array.from(await window.shadingLab.picture())));
const address = (page) => page.evaluate(() => location.search);

/** The greatest difference of two pictures' values. */
function difference(a, b) {
  assert.deepEqual([a.width, a.height], [b.width, b.height]);
  return a.data.reduce((most, value, index) => Math.max(most, Math.abs(value - b.data[index])), 0);
}

test("the first picture is the native one", async (context) => {
  await on("", async (page) => {
    const bytes = await picture(page);
    const drawn = await pixels(page, bytes);
    const values = new Set(drawn.data);
    assert.ok(values.size > 50, `${values.size} values in the first picture`);
    if (!existsSync(native ?? "")) return context.skip("no native program to compare with");
    // The scene in the picture goes to the native program, which draws it again.
    const [ours, theirs] = ["ours", "theirs"].map((name) => join(chromium.folder, `${name}.png`));
    writeFileSync(ours, bytes);
    execFileSync(native, ["render", ours, "--size", `${drawn.width}x${drawn.height}`, "-o", theirs]);
    const expected = await pixels(page, readFileSync(theirs));
    assert.ok(difference(drawn, expected) <= 1, "at most one code value off");
  });
});

test("a link opens its scene, and the address follows the state", async () => {
  const link = "?scene=sphere&set=material.n=7&set=shading.mode=gouraud&view=curves";
  await on(link, async (page) => {
    const before = await pixels(page, await picture(page));
    await page.keyboard.press("4");
    await until(async () => (await address(page)).includes("shading.mode=phong") || !(await address(page)).includes("gouraud"));
    assert.ok((await address(page)).includes("material.n=7"), "the rest of the link stays");
    const after = await pixels(page, await picture(page));
    assert.ok(difference(before, after) > 1, "another shading mode is another picture");
    // What the address says opens as the same picture.
    const again = await address(page);
    await on(again, async (other) => {
      assert.equal(difference(after, await pixels(other, await picture(other))), 0);
    });
  });
});

test("a wrong link is told and the page opens", async () => {
  await on("?scene=no-such-scene", async (page) => {
    assert.ok((await pixels(page, await picture(page))).width > 100);
  });
});

test("a worker refines the picture", async () => {
  await on("?scene=sphere", async (page) => {
    await until(() => page.workers().length === 1);
  });
});

test("it opens without a network", async () => {
  await on("", async (page) => {
    await page.evaluate(() => navigator.serviceWorker.ready);
    await chromium.context.setOffline(true);
    try {
      await page.reload();
      await page.waitForFunction(() => document.documentElement.dataset.state === "ready");
    } finally {
      await chromium.context.setOffline(false);
    }
  });
});
