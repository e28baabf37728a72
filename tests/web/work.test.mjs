// What the page does in the background: better pictures, analyses, exports.
import { test } from "node:test";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { address, difference, drop, picture, pixels, press, site, told, until, widget, widgets } from "./browser.mjs";

const here = site();

test("a worker refines the picture", async () => {
  await here.on("?scene=sphere", async (page) => {
    await until(async () => (await told(page, "Supersampled"))?.includes(2));
  });
});

test("a study is done by a worker while a slider moves", async () => {
  await here.on("?scene=sphere&view=study", async (page) => {
    // Many frames are timed.
    await press(page, "27 ×");
    await press(page, "Measure");
    await until(async () => (await told(page, "StudyQuestion")) !== undefined);
    const slider = await widget(page, "Ks specular coefficient", "Slider");
    const y = slider.y + slider.height / 2;
    await page.mouse.move(slider.x + 0.4 * slider.width, y);
    await widgets(page);
    await page.mouse.down();
    const seen = new Set();
    for (let part = 0.42; part < 0.8; part += 0.02) {
      await page.mouse.move(slider.x + part * slider.width, y);
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

test("a study that is stopped keeps what is known, and its worker ends", async () => {
  await here.on("?scene=teapot&view=study", async (page) => {
    await press(page, "27 ×");
    await press(page, "Measure");
    // Something has been told.
    await until(async () => (await told(page, "StudyQuestion"))?.includes(1), 120_000);
    await press(page, "Stop");
    await until(async () => (await widgets(page)).some(({ name }) => name.startsWith("Stopped")));
    const soFar = (await told(page, "StudyQuestion")).length;
    await page.waitForTimeout(2000);
    const after = await told(page, "StudyQuestion");
    assert.equal(after.length, soFar, "nothing more comes");
    assert.ok(!after.includes(2), "it did not come to its end");
  });
});

test("a picture that is exported opens again", async () => {
  await here.on("?scene=cube&set=material.kd=0.5", async (page) => {
    const drawn = await pixels(page, await picture(page));
    const download = page.waitForEvent("download", { timeout: 120_000 });
    download.catch(() => {});
    await page.keyboard.press("Control+e");
    await press(page, "Export");
    const file = await (await download).path();
    const bytes = readFileSync(file);
    assert.equal((await pixels(page, bytes)).width, 1920);
    await page.keyboard.press("1");
    await until(async () => (await address(page)).includes("flat"));
    // Dropped on the page it is the scene that it was made from.
    await drop(page, "again.png", bytes);
    await until(async () => (await page.title()).startsWith("again.png"));
    assert.equal(difference(drawn, await pixels(page, await picture(page))), 0);
  });
});
