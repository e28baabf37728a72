// Unsaved work: it is kept without a question, and there again when the page is loaded again.
import { test } from "node:test";
import assert from "node:assert/strict";
import { address, drop, open, press, site, state, until, widget, widgets } from "./browser.mjs";

const here = site();

/** How many pieces of unsaved work the browser stores. */
const kept = (page) => page.evaluate(() => Object.keys(localStorage).filter((name) => name.startsWith("shading-lab-work-")).length);

/** Opens a link and notes what the browser asks, which is answered by leaving. */
async function tab(link) {
  const { page, problems } = await open(here.browser.context, here.server.url + link);
  const asked = [];
  page.on("dialog", (dialog) => {
    asked.push(dialog.type());
    dialog.accept();
  });
  const ready = () => until(async () => (await state(page)) === "ready");
  await ready();
  return { page, problems, asked, ready };
}

test("changed work survives reloads without a question, and is offered to this tab alone", async () => {
  const { page, problems, asked, ready } = await tab("?scene=sphere");
  await press(page, "Picture, Phong shading", "Image");
  await page.keyboard.press("3");
  await until(async () => (await address(page)).includes("shading.mode=gouraud"));
  // At once, before it would be kept of itself.
  for (let again = 0; again < 2; again += 1) {
    await page.reload();
    await ready();
    await until(async () => (await page.title()).startsWith("sphere*"));
    assert.equal(await widget(page, "Restore"), undefined, "nobody asks");
    assert.ok((await address(page)).includes("shading.mode=gouraud"));
    await until(async () => (await kept(page)) === 1);
  }
  const other = await tab("?scene=cube");
  await widgets(other.page);
  assert.equal(await widget(other.page, "Restore"), undefined, "another tab is not offered what this one is working on");
  await other.page.close();
  // Elsewhere it is offered.
  await page.goto(here.server.url);
  await ready();
  await press(page, "Restore");
  await until(async () => (await address(page)).includes("shading.mode=gouraud"));
  assert.ok((await page.title()).startsWith("sphere*"), await page.title());
  assert.deepEqual(asked, [], "the browser asks nobody");
  // Once it is saved nothing is kept.
  const download = page.waitForEvent("download");
  await page.keyboard.press("Control+s");
  await download;
  await until(async () => (await kept(page)) === 0);
  await page.goto(here.server.url);
  await ready();
  await widgets(page);
  assert.equal(await widget(page, "Restore"), undefined);
  assert.deepEqual(problems, []);
  await page.close();
});

test("the browser asks before it leaves work that cannot be kept", async () => {
  const { page, asked, ready } = await tab("?scene=sphere");
  await drop(page, "corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  await until(async () => (await page.title()).startsWith("corner.obj"));
  await press(page, "Picture, Phong shading", "Image");
  await page.keyboard.press("3");
  await until(async () => (await page.title()).startsWith("corner.obj*"));
  await page.goto(`${here.server.url}?scene=cube`);
  await ready();
  assert.deepEqual(asked, ["beforeunload"]);
  await page.close();
});

test("what a closed tab leaves behind is offered to the next", async () => {
  const first = await tab("?scene=sphere");
  await first.page.keyboard.press("3");
  await until(async () => (await kept(first.page)) === 1);
  await first.page.close();
  const { page } = await tab("?scene=cube");
  await until(async () => (await widget(page, "Restore")) !== undefined);
  await press(page, "Delete");
  await until(async () => (await kept(page)) === 0);
  await page.close();
});

test("how the window looks is kept when the page is left at once", async () => {
  const { page, ready } = await tab("?scene=sphere");
  const stored = () => page.evaluate(() => localStorage.look ?? "");
  assert.ok(!(await stored()).includes('"views":false'));
  await press(page, "Close this view");
  await page.goto(`${here.server.url}?scene=cube`);
  await ready();
  assert.ok((await stored()).includes('"views":false'));
  await page.close();
});
