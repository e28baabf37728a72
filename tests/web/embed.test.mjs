// Figures in course notes: the reader scrolls over them and tabs through them, and uses one after a click.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { browser, firefox, serve, state, until, widgets } from "./browser.mjs";

let server;
before(async () => { server = await serve(process.env.SHADING_LAB_PAGE); });
after(() => server?.close());

/** Opens the notes, waits for their figures, and does something with the page, its figures, and a finger. */
async function read({ launch = browser, path = "embedding.html", ...options }, todo) {
  const own = await launch(options);
  try {
    const page = await own.context.newPage();
    await page.goto(server.url + path);
    const figures = () => page.frames().filter((frame) => frame.url().includes("embed&"));
    // What is far below is loaded once it comes near.
    for (const place of [0, 1, 2]) {
      await show(page, place);
      await until(() => figures().length > place);
    }
    await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
    for (const figure of figures()) await until(async () => (await state(figure).catch(() => "loading")) === "ready", 120_000);
    await todo(page, figures());
  } finally {
    await own.close();
  }
}

/** The values of a figure's controls. */
const values = async (figure) => (await widgets(figure)).filter(({ role }) => ["Slider", "SpinButton", "ComboBox"].includes(role)).map(({ name, value, number }) => `${name} ${value} ${number}`);
const scrolled = (page) => page.evaluate(() => scrollY);
const focused = (page) => page.evaluate(() => document.activeElement.tagName);
const top = (page, place) => page.evaluate((place) => document.querySelectorAll("iframe")[place].getBoundingClientRect().top, place);
const show = (page, place) => page.evaluate((place) => document.querySelectorAll("iframe")[place].scrollIntoView({ block: "center", behavior: "instant" }), place);

/** A control of a figure, with its place in the page. */
async function control(page, figure, place, name, role = "Slider") {
  const found = (await widgets(figure)).find((one) => one.name === name && one.role === role);
  const box = await page.evaluate((place) => { const { x, y } = document.querySelectorAll("iframe")[place].getBoundingClientRect(); return { x: x + 1, y: y + 1 }; }, place);
  return { ...found, x: found.x + box.x, y: found.y + box.y };
}

const browsers = [["Chromium", browser]];
if (process.env.FIREFOX) browsers.push(["Firefox", firefox]);
for (const [name, launch] of browsers) {
  test(`${name}: wheel and keys scroll notes over their figures, which change after a click`, async () => {
    await read({ launch }, async (page, figures) => {
      assert.equal(await focused(page), "BODY", "no figure takes the focus when it is loaded");
      const before = await Promise.all(figures.map(values));
      for (const place of figures.keys()) {
        await show(page, place);
        const at = await scrolled(page);
        const slider = await control(page, figures[place], place, ...[["n specular exponent"], ["segments", "Slider"], ["f attenuation", "ComboBox"]][place]).catch(() => ({ x: 300, y: 300, width: 100, height: 20 }));
        for (const [x, y] of [[slider.x + slider.width / 2, slider.y + slider.height / 2], [640, 350]]) {
          await page.mouse.move(x, y);
          await page.mouse.wheel(...(launch === firefox ? [{ deltaY: -120 }] : [0, -120]));
        }
        await until(async () => (await scrolled(page)) < at);
      }
      await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
      await page.keyboard.press("PageDown");
      await until(async () => (await scrolled(page)) > 100);
      assert.deepEqual(await Promise.all(figures.map(values)), before, "nothing has changed");
      // After a click the figure has the wheel and the keys.
      await show(page, 0);
      const n = await control(page, figures[0], 0, "n specular exponent");
      await page.mouse.move(n.x + 0.8 * n.width, n.y + n.height / 2);
      await widgets(figures[0]);
      await page.mouse.down();
      await widgets(figures[0]);
      await page.mouse.up();
      assert.notDeepEqual(await values(figures[0]), before[0], "a click on its slider");
      const at = await scrolled(page);
      await page.mouse.move(640, (await top(page, 0)) + 120);
      await page.mouse.wheel(...(launch === firefox ? [{ deltaY: 120 }] : [0, 120]));
      await page.waitForTimeout?.(500);
      await new Promise((later) => setTimeout(later, 500));
      assert.equal(await scrolled(page), at, "the wheel is the figure's");
    });
  });

  test(`${name}: Tab goes through the figures' controls and on`, async () => {
    await read({ launch }, async (page, figures) => {
      const seen = [];
      for (let press = 0; press < 40 && new Set(seen).size < 4; press += 1) {
        await page.keyboard.press("Tab");
        await Promise.all(figures.map(widgets));
        const place = await page.evaluate(() => [...document.querySelectorAll("iframe")].indexOf(document.activeElement));
        seen.push(place);
        if (place < 0 && seen.length > 1) break;
      }
      const places = seen.filter((place, index) => place !== seen[index - 1]);
      assert.deepEqual(places.slice(0, 3), [0, 1, 2], seen.join());
      assert.ok(seen.length < 40 && places.at(-1) < 0, `out again: ${seen.join()}`);
      assert.ok(seen.filter((place) => place === 0).length >= 3, "each control is a stop");
    });
  });

  test(`${name}: the slider of a figure has its whole width`, async () => {
    await read({ launch }, async (page, figures) => {
      const n = await control(page, figures[0], 0, "n specular exponent");
      const width = await page.evaluate(() => document.querySelector("iframe").getBoundingClientRect().width);
      assert.ok(n.width > 0.9 * width, `${n.width} of ${width}`);
    });
  });
}

test("a thumb scrolls notes over their figures, turns with two fingers, and uses a figure after a tap", async () => {
  await read({ width: 390, height: 844, hasTouch: true, isMobile: true }, async (page, figures) => {
    const fingers = await page.context().newCDPSession(page);
    const touch = (type, ...points) => fingers.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const swipe = async ([x, y], [dx, dy], steps = 12) => {
      await touch("touchStart", [x, y]);
      for (let step = 1; step <= steps; step += 1) await touch("touchMove", [x + (dx * step) / steps, y + (dy * step) / steps]);
      await touch("touchEnd");
    };
    const before = await Promise.all(figures.map(values));
    const cameras = () => Promise.all(figures.map((figure) => figure.evaluate(() => window.shadingLab.picture().then((bytes) => Array.from(bytes).join().length))));
    const pictures = await cameras();
    for (const [place, name] of [[0, "n specular exponent"], [0, "Ks specular coefficient"]]) {
      await show(page, place);
      const slider = await control(page, figures[place], place, name);
      const at = await scrolled(page);
      await swipe([slider.x + slider.width / 3, slider.y + slider.height / 2], [0, -150]);
      await until(async () => (await scrolled(page)) > at + 60);
    }
    for (const place of figures.keys()) {
      await show(page, place);
      const at = await scrolled(page);
      await swipe([200, (await top(page, place)) + 150], [0, 120]);
      await until(async () => (await scrolled(page)) < at - 40);
    }
    assert.deepEqual(await Promise.all(figures.map(values)), before, "no value has changed");
    assert.deepEqual(await cameras(), pictures, "and no picture has turned");

    // Two fingers turn it.
    await show(page, 0);
    const y = (await top(page, 0)) + 120;
    await touch("touchStart", [150, y], [230, y]);
    for (let step = 1; step <= 8; step += 1) await touch("touchMove", [150 + 8 * step, y], [230 + 8 * step, y]);
    await touch("touchEnd");
    await until(async () => (await cameras())[0] !== pictures[0]);
    // A slider is drawn sideways.
    const slider = await control(page, figures[0], 0, "n specular exponent");
    await swipe([slider.x + slider.width / 3, slider.y + slider.height / 2], [80, 0]);
    await until(async () => (await values(figures[0])).join() !== before[0].join());
    // After a tap one finger turns the picture and the page stays.
    await touch("touchStart", [200, y]);
    await touch("touchEnd");
    const [at, picture] = [await scrolled(page), (await cameras())[0]];
    // Beside the probe, which the tap has put there.
    await swipe([130, y], [0, 80]);
    await until(async () => (await cameras())[0] !== picture);
    assert.equal(await scrolled(page), at);
  });
});

test("a figure whose link is wrong says so, and nothing else", async () => {
  const own = await browser();
  try {
    const page = await own.context.newPage();
    await page.goto(`${server.url}?scene=no-such-scene&embed&controls=n`);
    await until(async () => (await state(page)) === "ready");
    const names = (await widgets(page)).map(({ name }) => name);
    assert.ok(names.some((name) => name.includes("`scene` is \"no-such-scene\"")), names);
    for (const name of ["File", "Close", "n specular exponent"]) assert.ok(!names.includes(name), name);
  } finally {
    await own.close();
  }
});

test("the lamps of a figure are seen before it is touched", async () => {
  const own = await browser({ width: 600, height: 432 });
  try {
    const page = await own.context.newPage();
    await page.goto(`${server.url}?scene=sphere&embed&controls=n`);
    await until(async () => (await state(page)) === "ready");
    await page.waitForTimeout(1000);
    const before = await page.screenshot();
    await page.mouse.move(300, 20);
    await page.waitForTimeout(1000);
    assert.ok(before.equals(await page.screenshot()), "pointing at the picture shows nothing that was not there");
  } finally {
    await own.close();
  }
});
