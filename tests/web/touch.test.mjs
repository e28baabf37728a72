// The page in the hand: fingers turn and zoom the picture, everything is high enough for them, and nothing is cut off.
import { test } from "node:test";
import assert from "node:assert/strict";
import { address, browser, open, picture, pixels, serve, until, widget, widgets } from "./browser.mjs";

/** A finger needs this, points. */
const TARGET = 44;
const TARGETS = ["Button", "CheckBox", "ComboBox", "Slider"];

/** The place of an address's camera, its probe, and so on. */
const set = async (page, key) => (await address(page)).split(/[?&]/).find((pair) => pair.replace("set=", "").startsWith(key));

test("a fine screen has its pixels and letters of the usual size", async () => {
  const server = await serve(process.env.SHADING_LAB_PAGE);
  const phone = await browser({ width: 390, height: 844, hasTouch: true, isMobile: true, deviceScaleFactor: 3 });
  try {
    const { page } = await open(phone.context, `${server.url}?scene=sphere`);
    const side = await page.evaluate(() => document.querySelector("canvas").width);
    assert.equal(side, 3 * 390);
    const { height } = await widget(page, "Scene", "Button");
    assert.ok(height < 80, `${height} points`);
  } finally {
    await phone.close();
    server.close();
  }
});

for (const [width, height] of [[390, 844], [844, 390]]) {
  test(`fingers at ${width} × ${height}`, async () => {
    const server = await serve(process.env.SHADING_LAB_PAGE);
    const phone = await browser({ width, height, hasTouch: true, isMobile: true });
    try {
      const { page, problems } = await open(phone.context, `${server.url}?scene=sphere`);
      const scrolls = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth || document.documentElement.scrollHeight > innerHeight);
      assert.ok(!scrolls, "nothing is larger than the screen");
      const fingers = await phone.context.newCDPSession(page);
      const touch = async (type, ...touchPoints) => {
        await fingers.send("Input.dispatchTouchEvent", { type, touchPoints: touchPoints.map(([x, y], id) => ({ x, y, id })) });
        await widgets(page);
      };
      const tap = async ({ x, y, width, height }) => {
        await touch("touchStart", [x + width / 2, y + height / 2]);
        await touch("touchEnd");
      };
      const inPicture = async () => {
        const place = await widget(page, "Picture, Phong shading", "Image");
        return [place.x + place.width / 2, place.y + place.height / 2, place.width];
      };

      // Before the first touch already: the letters of the equation and of the table below are read rather than pressed.
      const small = (await widgets(page)).filter((one) => TARGETS.includes(one.role) && !/ (in the equation|at the probe)$/.test(one.name) && one.height < TARGET - 0.5);
      assert.deepEqual(small.map(({ name, height }) => `${name}: ${height}`), []);

      let [x, y] = await inPicture();
      assert.ok((await pixels(page, await picture(page))).width >= width / 2);
      await touch("touchStart", [x - 60, y + 40]);
      for (let step = 1; step <= 5; step += 1) await touch("touchMove", [x - 60 + 8 * step, y + 40]);
      await touch("touchEnd");
      await until(async () => (await set(page, "camera.eye")) !== undefined);
      const turned = await set(page, "camera.eye");

      await touch("touchStart", [x - 30, y], [x + 30, y]);
      for (let step = 1; step <= 5; step += 1) await touch("touchMove", [x - 30 - 4 * step, y], [x + 30 + 4 * step, y]);
      await touch("touchEnd");
      await until(async () => (await set(page, "camera.eye")) !== turned);

      const probe = await set(page, "probe=");
      await touch("touchStart", [x - 20, y - 20]);
      await page.waitForTimeout(1200);
      await touch("touchEnd");
      await until(async () => (await set(page, "probe=")) !== probe);

      // The controls come in a drawer.
      if ((await widget(page, "Kd diffuse coefficient", "Slider")) === undefined) await tap(await widget(page, "Scene", "Button"));
      await until(async () => (await widget(page, "Kd diffuse coefficient", "Slider")) !== undefined);
      const slider = await widget(page, "Kd diffuse coefficient", "Slider");
      assert.ok(slider.x >= 0 && slider.x + slider.width <= width, "it is in sight");

      // The system's keyboard takes half of the screen, and neither covers what is typed nor goes away again.
      const field = () => widget(page, "Ks specular coefficient", "SpinButton");
      await tap(await field());
      const typing = () => page.evaluate(() => document.activeElement.tagName === "INPUT");
      await until(typing);
      const low = Math.round(height * 0.5);
      await page.setViewportSize({ width, height: low });
      await until(async () => (await field()).y + TARGET <= low);
      await page.waitForTimeout(500);
      assert.ok(await typing(), "the keyboard stays");
      await page.keyboard.type("0.25");
      await page.keyboard.press("Enter");
      await until(async () => (await set(page, "material.ks"))?.endsWith("=0.25"));
      await page.setViewportSize({ width, height });
      assert.deepEqual(problems, []);
    } finally {
      await phone.close();
      server.close();
    }
  });
}
