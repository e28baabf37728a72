// The page does nothing while nothing happens, fits small and zoomed windows, and takes slow hands as they are.
import { test } from "node:test";
import assert from "node:assert/strict";
import { address, browser, open, press, serve, site, state, until, widget, widgets } from "./browser.mjs";

const here = site();

/** Counts the frames that the page asks of the browser. */
function countFrames() {
  window.frames_asked = 0;
  const ask = window.requestAnimationFrame;
  window.requestAnimationFrame = function (...parameters) {
    window.frames_asked += 1;
    return ask.apply(window, parameters);
  };
}

test("no frame is drawn while nothing changes, on the page or in a figure", async () => {
  for (const path of ["?scene=sphere", "?scene=sphere&embed&controls=n,ks", "?lesson=diffuse&step=3"]) {
    const { page } = await open(here.browser.context, here.server.url + path, countFrames);
    const asked = () => page.evaluate(() => window.frames_asked);
    // The picture is refined, the lessons arrive, and the mirror is made.
    let before = 0;
    await until(async () => {
      before = await asked();
      await page.waitForTimeout(3000);
      return before === await asked();
    });
    assert.ok(before > 2, "frames are counted");
    await page.waitForTimeout(10_000);
    assert.equal(await asked(), before, path);
    // It wakes up again.
    if (!path.includes("embed")) {
      await page.mouse.move(640, 400);
      await page.mouse.click(640, 400);
      await page.keyboard.press("3");
      if (!path.includes("lesson")) await until(async () => (await address(page)).includes("gouraud"));
    }
    await page.mouse.move(300, 200);
    await until(async () => (await asked()) > before);
    await page.close();
  }
});

test("a button that is pressed for a second is pressed", async () => {
  await here.on("?scene=sphere", async (page) => {
    const find = () => widget(page, "Scenes", "Button");
    const { x, y, width, height } = await find();
    await page.mouse.move(x + width / 2, y + height / 2);
    await widgets(page);
    await page.mouse.down();
    await page.waitForTimeout(1500);
    await page.mouse.up();
    await until(async () => (await widgets(page)).some(({ role, name }) => role === "Heading" && name === "Scenes" || name === "Scenes" && role === "Label"));
  });
});

test("a step beyond the lesson's last one is told", async () => {
  await here.on("?lesson=diffuse&step=99", async (page) => {
    await until(async () => (await widgets(page)).some(({ name }) => name.includes("step 99")));
  });
});

/** Counts the scenes between that of a step and that of the next one, which differs in the place of a lamp. */
async function between(reducedMotion) {
  const own = await browser({ reducedMotion });
  try {
    const { page } = await open(own.context, `${here.server.url}?lesson=attenuation&step=2`);
    await until(async () => (await widgets(page)).some(({ name }) => name === "Next"));
    await page.waitForTimeout(1500);
    // The scene inside the picture: its pixels may still be those of the scene before, where drawing waits for the next frame.
    const seen = (milliseconds) => page.evaluate(async (milliseconds) => {
      const scene = (picture) => {
        const view = new DataView(picture.buffer, picture.byteOffset);
        for (let at = 8; at < picture.length; at += 12 + view.getUint32(at)) {
          if (String.fromCharCode(...picture.subarray(at + 4, at + 8)) === "iTXt") return picture.slice(at, at + 12 + view.getUint32(at)).join();
        }
        throw new Error("a picture without a scene");
      };
      const seen = [];
      const end = performance.now() + milliseconds;
      do {
        seen.push(scene(await window.shadingLab.picture()));
        await new Promise((later) => setTimeout(later, 20));
      } while (performance.now() < end);
      return seen;
    }, milliseconds);
    const [before] = await seen(0);
    await page.keyboard.press("PageDown");
    const scenes = await seen(3000);
    const after = scenes.at(-1);
    assert.notEqual(after, before, "another step has another scene");
    return scenes.filter((scene) => scene !== before && scene !== after).length;
  } finally {
    await own.close();
  }
}

test("who prefers less motion gets none", async () => {
  assert.equal(await between("reduce"), 0);
  // A machine that draws slower than the scene moves may miss it once.
  let moving = 0;
  for (let tries = 0; tries < 3 && moving === 0; tries += 1) moving = await between("no-preference");
  assert.ok(moving > 0, "others see the lamp move");
});

test("a screen of two pixels a point has its window whole", async () => {
  const server = await serve(process.env.SHADING_LAB_PAGE);
  const fine = await browser({ flags: ["--force-device-scale-factor=2"], width: undefined, viewport: null });
  try {
    const { page } = await open(fine.context, `${server.url}?scene=sphere`);
    const [canvas, window] = await page.evaluate(() => [document.querySelector("canvas").width, innerWidth * devicePixelRatio]);
    assert.equal(await page.evaluate(() => devicePixelRatio), 2);
    assert.ok(Math.abs(canvas - window) <= 1, `${canvas} of ${window}`);
    const { x, width } = await widget(page, "Picture, Phong shading", "Image");
    assert.ok(x + width <= await page.evaluate(() => innerWidth), "the picture is in the window");
  } finally {
    await fine.close();
    server.close();
  }
});

for (const [width, height, what] of [[640, 400, "at 200 % zoom"], [844, 390, "in landscape"]]) {
  test(`the picture keeps half of the window ${what}, and nothing covers it`, async () => {
    const small = await browser({ width, height });
    try {
      const { page } = await open(small.context, `${here.server.url}?scene=sphere`);
      const picture = await widget(page, "Picture, Phong shading", "Image");
      assert.ok(picture.width >= 0.45 * width && picture.height >= 0.5 * height, `${picture.width} × ${picture.height}`);
      await page.goto(`${here.server.url}?lesson=diffuse&step=3`);
      await until(async () => (await state(page)) === "ready" && (await widgets(page)).some(({ role, name }) => role === "Heading" && name === "N·L"));
      const all = await widgets(page);
      const question = all.find(({ name }) => name === "Scroll to the question");
      if (question) {
        const covered = all.filter(({ role, html }) => role === "Article" || html).filter((one) => one.y < question.y + question.height && one.y + one.height > question.y && one.x < question.x + question.width && one.x + one.width > question.x);
        const next = all.find(({ name }) => name === "Next");
        assert.ok(Math.abs(question.y - next.y) < 8, `the button is in the row below the text: ${covered.length}`);
      }
    } finally {
      await small.close();
    }
  });
}

test("Back closes the drawer, then goes a step back, then leaves the lesson", async () => {
  await here.on("?scene=sphere", async (page) => {
    await press(page, "Course");
    await press(page, "Diffuse reflection");
    const heading = (name) => until(async () => (await widgets(page)).some((one) => one.role === "Heading" && one.name === name));
    await heading("Matt surfaces");
    await until(async () => (await address(page)).includes("step=1"));
    await press(page, "Next");
    await heading("A tilted surface");
    await until(async () => (await address(page)).includes("step=2"));
    await page.goBack();
    await heading("Matt surfaces");
    await page.goBack();
    await until(async () => !(await address(page)).includes("lesson="));
    await until(async () => !(await widgets(page)).some(({ role, name }) => role === "Heading" && name === "Matt surfaces"));
    await page.goForward();
    await heading("Matt surfaces");
  });
  const phone = await browser({ width: 390, height: 844, hasTouch: true, isMobile: true });
  try {
    const { page } = await open(phone.context, `${here.server.url}?scene=sphere`);
    const slider = () => widget(page, "Kd diffuse coefficient", "Slider");
    if (await slider()) await press(page, "Scene");
    await until(async () => (await slider()) === undefined);
    await page.waitForTimeout(1000);
    await press(page, "Scene");
    await until(async () => (await slider()) !== undefined);
    await page.waitForTimeout(1000);
    await page.goBack();
    await until(async () => (await slider()) === undefined);
    assert.equal(await state(page), "ready");
  } finally {
    await phone.close();
  }
});
