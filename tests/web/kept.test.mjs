// Unsaved work: the browser asks before it leaves it, and it is offered when the page is opened again.
import { test } from "node:test";
import assert from "node:assert/strict";
import { address, open, press, site, state, until, widget, widgets } from "./browser.mjs";

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

test("unsaved work is asked about, kept, and offered to this tab alone", async () => {
  const { page, problems, asked, ready } = await tab("?scene=sphere");
  // The browser asks nobody who has done nothing.
  await press(page, "Picture, Phong shading", "Image");
  await page.keyboard.press("3");
  await until(async () => (await kept(page)) === 1);
  const other = await tab("?scene=cube");
  await widgets(other.page);
  assert.equal(await widget(other.page, "Restore"), undefined, "another tab is not offered what this one is working on");
  await other.page.close();
  await page.goto(here.server.url);
  await ready();
  assert.deepEqual(asked, ["beforeunload"]);
  await press(page, "Restore");
  await until(async () => (await address(page)).includes("shading.mode=gouraud"));
  assert.ok((await address(page)).includes("scene=sphere"));
  assert.ok((await page.title()).startsWith("sphere*"), await page.title());
  // It is this tab's own again, and stays so when it is loaded anew.
  await page.reload();
  await ready();
  await press(page, "Restore");
  await until(async () => (await page.title()).startsWith("sphere*"));
  assert.equal(await kept(page), 1);
  // Once it is saved nobody asks, and nothing is kept.
  const download = page.waitForEvent("download");
  await page.keyboard.press("Control+s");
  await download;
  await until(async () => (await kept(page)) === 0);
  const before = asked.length;
  await page.goto(here.server.url);
  await ready();
  await widgets(page);
  assert.equal(await widget(page, "Restore"), undefined);
  assert.equal(asked.length, before);
  assert.deepEqual(problems, []);
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
  assert.ok(!(await stored()).includes("views:false"));
  await press(page, "Close this view");
  await page.goto(`${here.server.url}?scene=cube`);
  await ready();
  assert.ok((await stored()).includes("views:false"));
  await page.close();
});
