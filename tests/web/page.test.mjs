// The web page in a browser: it opens, draws what the native program draws, follows links, and works in the background.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { browser, open, pixels, serve, told, until } from "./browser.mjs";

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
    await until(async () => (await told(page, "Supersampled"))?.includes(2));
  });
});

test("a study is done by a worker while a slider moves", async () => {
  await on("?scene=sphere&view=study", async (page) => {
    // Places in a window of 1280 × 800 points: many frames timed, the study's button, and the slider of Ks.
    await page.waitForTimeout(500);
    await page.mouse.move(546, 649);
    await page.waitForTimeout(200);
    await page.mouse.click(546, 649, { delay: 200 });
    await until(async () => {
      // A frame sees the pointer there, then pressed.
      await page.mouse.move(375, 709);
      await page.waitForTimeout(200);
      await page.mouse.click(375, 709, { delay: 200 });
      await page.waitForTimeout(500);
      return (await told(page, "StudyQuestion")) !== undefined;
    });
    await page.mouse.move(167, 212);
    await page.waitForTimeout(200);
    await page.mouse.down();
    await page.waitForTimeout(200);
    const seen = new Set();
    for (let x = 168; x < 200; x += 2) {
      await page.mouse.move(x, 212);
      const mark = await page.evaluate(async () => {
        const digest = await crypto.subtle.digest("SHA-256", await window.shadingLab.picture());
        return new Uint8Array(digest).join();
      });
      if (!(await told(page, "StudyQuestion")).includes(2)) seen.add(mark);
    }
    await page.mouse.up();
    // What is dragged may be drawn coarser, which is another picture too.
    assert.ok(seen.size > 4, `${seen.size} pictures followed the slider while the study went on`);
    await until(async () => (await told(page, "StudyQuestion")).includes(2), 300_000);
    assert.ok((await told(page, "StudyQuestion")).includes(0), "it tells how far it is");
    await until(async () => (await address(page)).includes("material.ks="));
  });
});

test("a picture that is exported opens again", async () => {
  await on("?scene=cube&set=material.kd=0.5", async (page) => {
    const drawn = await pixels(page, await picture(page));
    const download = page.waitForEvent("download", { timeout: 120_000 });
    await page.keyboard.press("Control+e");
    await until(async () => {
      await page.waitForTimeout(1000);
      await page.keyboard.press("Enter");
      return (await told(page, "Exported")) !== undefined;
    });
    const file = await (await download).path();
    const bytes = readFileSync(file);
    assert.equal((await pixels(page, bytes)).width, 1920);
    await page.keyboard.press("1");
    await until(async () => (await address(page)).includes("flat"));
    // Dropped on the page it is the scene that it was made from.
    await page.evaluate((text) => {
      const content = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], "again.png", { type: "image/png" }));
      document.querySelector("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    }, bytes.toString("base64"));
    await until(async () => (await page.title()).startsWith("again.png"));
    assert.equal(difference(drawn, await pixels(page, await picture(page))), 0);
  });
});

test("on a phone the picture fills the width", async () => {
  const phone = await browser({ width: 390, height: 844, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  try {
    const { page, problems } = await open(phone.context, `${server.url}?scene=sphere`);
    const size = await pixels(page, await picture(page));
    assert.equal(size.width, await page.evaluate(() => document.querySelector("canvas").width));
    const scrolls = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    assert.ok(!scrolls, "nothing is wider than the screen");
    assert.deepEqual(problems, []);
  } finally {
    await phone.close();
  }
});

test("Chinese has its own letters, fetched when that language is chosen", async () => {
  const chinese = await browser({ locale: "zh-TW" });
  try {
    const fetched = [];
    chinese.context.on("request", (request) => fetched.push(new URL(request.url()).pathname));
    const { page, problems } = await open(chinese.context, server.url);
    await until(() => fetched.includes("/chinese.otf"));
    assert.equal(await page.evaluate(() => document.documentElement.lang), "zh-Hant");
    assert.deepEqual(problems, []);
  } finally {
    await chinese.close();
  }
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
