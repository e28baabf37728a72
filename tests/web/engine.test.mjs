// The engine of the web page, beside that of the native program: pictures, and links of all kinds.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { browser, difference, native, open, pixels, serve } from "./browser.mjs";

const skip = !native && "no native program to compare with";
// How many links are mutated; by hand 100000.
const LINKS = Number(process.env.LINKS ?? 3000);
let server;
let chromium;
let page;
let problems;

const run = (...words) => execFileSync(native, words, { encoding: "utf8", maxBuffer: 1 << 26 });
const link = (text) => page.evaluate((text) => {
  try {
    return { link: window.shadingLab.link(text) };
  } catch (error) {
    return { error: error.message };
  }
}, text);

before(async () => {
  server = await serve(process.env.SHADING_LAB_PAGE);
  chromium = await browser();
  ({ page, problems } = await open(chromium.context, server.url));
});

after(async () => {
  await chromium?.close();
  server?.close();
});

test("every built-in scene is the native picture within one code value", { skip }, async () => {
  const scenes = JSON.parse(run("scenes", "--json"));
  const names = (scenes.scenes ?? scenes).map((scene) => scene.name);
  assert.ok(names.length >= 44, names.join());
  for (const name of names) {
    const file = join(chromium.folder, `${name}.png`);
    run("render", name, "--compare", "single", "--size", "240x180", "-o", file);
    const ours = await page.evaluate((link) => Array.from(window.shadingLab.render(link, 240, 180)), `?scene=${name}`);
    const [a, b] = [await pixels(page, Buffer.from(ours)), await pixels(page, readFileSync(file))];
    const most = difference(a, b);
    assert.ok(most <= 1, `${name} is off by ${most}`);
  }
});

test("links mean the same on the page as they do natively", { skip }, async () => {
  const scenes = JSON.parse(run("scenes", "--json"));
  const names = (scenes.scenes ?? scenes).map((scene) => scene.name);
  const written = names.map((name) => run("link", name).trim());
  // Written by the tests of the native program, where these have run.
  const file = process.env.SHADING_LAB_LINKS ?? "";
  if (existsSync(file)) written.push(...readFileSync(file, "utf8").trim().split("\n"));
  for (const text of written) assert.deepEqual(await link(text), { link: text });
});

test("no link breaks the page", async () => {
  let seed = 20260101;
  const dice = (sides) => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0) % sides;
  const good = [
    "?scene=highlight&set=material.n=50&set=shading.mode=gouraud&view=profile",
    "?scene=sphere&set=light.0.position=2,2,3&probe=0.1,-0.2&line=-0.5,0,0.5,0",
    "?scene=teapot&lights=3&set=light.2.kind=spot&pane=shading.mode=exact;material.n=inf",
    "?scene=defaults&embed&controls=n,ks,light&utm_source=x",
    "#scene=7ZJBCsIwEEX3niJ0b9JWF4K9gAvBE5Q0GdtAmpRkCnp7U6Eg6M7tbGb-8OfN4sc",
  ];
  const letters = "?&=#%+;,.[]abcnkxyz0189-eE\u0000é漢\"'<>/\\ ";
  const mutated = Array.from({ length: LINKS }, () => {
    const text = [...good[dice(good.length)]];
    for (let change = dice(6); change >= 0; change -= 1) {
      const at = dice(text.length + 1);
      const part = Array.from({ length: dice(4) }, () => letters[dice(letters.length)]);
      text.splice(at, dice(4), ...part);
    }
    return text.join("");
  });
  const results = await page.evaluate((links) => links.map((text) => {
    try {
      return ["link", window.shadingLab.link(text)];
    } catch (error) {
      return [error instanceof WebAssembly.RuntimeError ? "trap" : "error", error.message];
    }
  }), mutated);
  for (const [place, [kind, text]] of results.entries()) {
    assert.notEqual(kind, "trap", mutated[place]);
    assert.ok(text.length > 0, `${mutated[place]}: nothing is said`);
  }
  assert.ok(results.some(([kind]) => kind === "link") && results.some(([kind]) => kind === "error"));
  assert.equal(await page.evaluate(() => document.documentElement.dataset.state), "ready");
  assert.deepEqual(problems, []);
});
