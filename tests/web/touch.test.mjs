// The page in the hand: fingers turn and zoom the picture, everything is high enough for them, and nothing is cut off.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { address, browser, native, open, picture, pixels, serve, until, widget, widgets } from "./browser.mjs";

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
      assert.ok((await pixels(page, await picture(page))).width >= 0.45 * width);
      await touch("touchStart", [x - 60, y + 40]);
      for (let step = 1; step <= 5; step += 1) await touch("touchMove", [x - 60 + 8 * step, y + 40]);
      await touch("touchEnd");
      await until(async () => (await set(page, "camera.eye")) !== undefined);
      const turned = await set(page, "camera.eye");

      await touch("touchStart", [x - 30, y], [x + 30, y]);
      for (let step = 1; step <= 5; step += 1) await touch("touchMove", [x - 30 - 4 * step, y], [x + 30 + 4 * step, y]);
      await touch("touchEnd");
      await until(async () => (await set(page, "camera.eye")) !== turned);

      // A tap sets the probe, and so does a finger that rests, which opens a menu as well.
      for (const [milliseconds, aside] of [[50, 20], [1200, 30]]) {
        const probe = await set(page, "probe=");
        await touch("touchStart", [x - aside, y - aside]);
        await page.waitForTimeout(milliseconds);
        await touch("touchEnd");
        await until(async () => (await set(page, "probe=")) !== probe);
      }
      const menu = () => widget(page, "Add a light here", "Button");
      await until(async () => (await menu()) !== undefined);
      await page.keyboard.press("Escape");
      await until(async () => (await menu()) === undefined);

      // The controls come in a drawer.
      if ((await widget(page, "Kd diffuse coefficient", "Slider")) === undefined) await tap(await widget(page, "Scene", "Button"));
      await until(async () => (await widget(page, "Kd diffuse coefficient", "Slider")) !== undefined);
      const slider = await widget(page, "Kd diffuse coefficient", "Slider");
      assert.ok(slider.x >= 0 && slider.x + slider.width <= width, "it is in sight");

      // A thumb that goes up over it scrolls, and changes nothing; one that goes sideways changes it.
      const before = await address(page);
      const middle = [slider.x + slider.width / 2, slider.y + slider.height / 2];
      await touch("touchStart", middle);
      for (let step = 1; step <= 10; step += 1) await touch("touchMove", [middle[0] + step, middle[1] - 12 * step]);
      await touch("touchEnd");
      await until(async () => ((await widget(page, "Kd diffuse coefficient", "Slider"))?.y ?? -999) < slider.y - 60);
      await page.waitForTimeout(800);
      assert.equal(await address(page), before, "no value has changed");
      const field = () => widget(page, "Ks specular coefficient", "SpinButton");
      const over = await field();
      await touch("touchStart", [over.x + over.width / 2, over.y + over.height / 2]);
      for (let step = 1; step <= 10; step += 1) await touch("touchMove", [over.x + over.width / 2, over.y + over.height / 2 + 8 * step]);
      await touch("touchEnd");
      await until(async () => (await field()).y > over.y + 40);
      assert.equal(await page.evaluate(() => document.activeElement.tagName), "CANVAS", "the field is not typed in");
      await page.waitForTimeout(800);
      assert.equal(await address(page), before);
      const now = await widget(page, "Kd diffuse coefficient", "Slider");
      assert.ok(now.width > 0.85 * (width < height ? width : now.width), `a slider has the whole width: ${now.width}`);
      await touch("touchStart", [now.x + now.width / 2, now.y + now.height / 2]);
      for (let step = 1; step <= 6; step += 1) await touch("touchMove", [now.x + now.width / 2 + 8 * step, now.y + now.height / 2 + step]);
      await touch("touchEnd");
      await until(async () => (await set(page, "material.kd")) !== undefined);

      // The system's keyboard takes half of the screen, and neither covers what is typed nor goes away again.
      await tap(await field());
      const typing = () => page.evaluate(() => document.activeElement.tagName === "INPUT");
      await until(typing);
      const half = Math.round(height * 0.5);
      await page.setViewportSize({ width, height: half });
      await until(async () => (await field()).y + TARGET <= half);
      await page.waitForTimeout(500);
      assert.ok(await typing(), "the keyboard stays");
      await page.keyboard.type("0.25");
      await page.keyboard.press("Enter");
      await until(async () => (await set(page, "material.ks"))?.endsWith("=0.25"));
      await page.setViewportSize({ width, height });

      // Menus scroll, and name no keys.
      await tap(await widget(page, "Menu", "Button"));
      await until(async () => (await widget(page, "View", "Button")) !== undefined);
      await tap(await widget(page, "View", "Button"));
      const language = () => widget(page, "Language", "Button");
      await until(async () => (await language()) !== undefined);
      assert.ok(!(await widgets(page)).some(({ name }) => /Ctrl|^F\d/.test(name)));
      const item = await widget(page, "Overlays", "Button");
      assert.ok(item, "what is many has a menu of its own");
      const at = [item.x + 30, Math.min(item.y + 20, height - 60)];
      for (let swipe = 0; swipe < 6 && (await language()).y + TARGET > height; swipe += 1) {
        await touch("touchStart", [at[0], height - 80]);
        for (let step = 1; step <= 8; step += 1) await touch("touchMove", [at[0], height - 80 - (step * height) / 14]);
        await touch("touchEnd");
        await page.waitForTimeout(400);
      }
      const { y: low } = await language();
      assert.ok(low >= 0 && low + TARGET <= height, `Language is in sight: ${low}`);
      assert.deepEqual(problems, []);
    } finally {
      await phone.close();
      server.close();
    }
  });
}

test("a lesson is done by touch alone, from the enlarged list to a hand-in that is graded", async (context) => {
  const server = await serve(process.env.SHADING_LAB_PAGE);
  const phone = await browser({ width: 390, height: 844, hasTouch: true, isMobile: true });
  try {
    const { page, problems } = await open(phone.context, `${server.url}?scene=sphere`);
    const fingers = await phone.context.newCDPSession(page);
    const touch = async (type, ...touchPoints) => {
      await fingers.send("Input.dispatchTouchEvent", { type, touchPoints: touchPoints.map(([x, y], id) => ({ x, y, id })) });
      return widgets(page);
    };
    const swipe = async (...points) => {
      await touch("touchStart", points[0]);
      for (const point of points.slice(1)) await touch("touchMove", point);
      await touch("touchEnd");
    };
    const middle = ({ x, y, width, height }) => [x + width / 2, y + height / 2];
    /** The top and the bottom of what the panel shows: it ends above its row of buttons. */
    const panel = (all) => {
      const picture = all.find(({ role }) => role === "Image");
      const back = all.find(({ role, name }) => role === "Button" && name === "Back");
      return [picture ? picture.y + picture.height + 50 : 100, (back?.y ?? 780) - 4];
    };
    /** Scrolls with a finger on the panel's edge until a control is in sight, and returns it. */
    const find = async (role, name, above = true) => {
      let found;
      await until(async () => {
        const all = await widgets(page);
        found = all.find((one) => one.role === role && one.name.startsWith(name) && !one.disabled);
        if (!found) return false;
        const [top, bottom] = panel(all);
        const [, y] = middle(found);
        if (!above || (found.y >= top && y + 10 <= bottom)) return true;
        const way = Math.min(Math.max((top + bottom) / 2 - y, -150), 150);
        const from = (top + bottom) / 2 - way / 2;
        await swipe([8, from], ...[0.2, 0.4, 0.6, 0.8, 1].map((part) => [8, from + part * way]));
        await page.waitForTimeout(700);
        return false;
      });
      return found;
    };
    const tap = async (...which) => {
      await touch("touchStart", middle(await find(...which)));
      await touch("touchEnd");
    };
    const says = (words) => until(async () => (await widgets(page)).some(({ role, name }) => role === "Label" && words.test(name)));
    const heading = (name) => until(async () => (await widgets(page)).some((one) => one.role === "Heading" && one.name === name));
    const next = () => tap("Button", "Next", false);

    await tap("Button", "Course", false);
    await tap("Button", "Enlarge this view", false);
    await tap("Button", "Diffuse reflection");
    await heading("Matt surfaces");
    assert.ok((await widgets(page)).some(({ role }) => role === "Image"), "the picture of the first step is in sight");
    await next();

    // A curve is drawn, roughly.
    await heading("A tilted surface");
    const { x, y, width, height } = await find("Canvas", "");
    const curve = Array.from({ length: 17 }, (_, at) => [x + 34 + (at / 16) * (width - 44), y + 12 + (1 - Math.max(Math.cos((at / 16) * (2 / 3) * Math.PI), 0)) * (height - 50)]);
    await swipe(...curve);
    await tap("Button", "Check");
    await says(/^(Right|Not)/);
    await next();

    // A number is typed: the field opens the system's keyboard.
    await heading("N·L");
    await tap("TextInput", "Your answer");
    await until(() => page.evaluate(() => document.activeElement.tagName === "INPUT"));
    await page.keyboard.type("0.6");
    await tap("Button", "Check");
    await says(/^Right/);
    await next();

    // A point: the words speak of taps, and a tap is enough.
    await heading("Where the light ends");
    await find("Label", "Tap in the picture.");
    const words = (await widgets(page)).map(({ name }) => name).join("\n");
    assert.ok(!/click|F3/i.test(words), words);
    const ball = await find("Image", "", false);
    const [left, top] = middle(ball);
    await touch("touchStart", [left + 0.1 * ball.height, top]);
    await touch("touchEnd");
    await tap("Button", "Check");
    await says(/^Right/);
    await next();

    await heading("Walk round the ball");
    await tap("RadioButton", "As bright as before");
    await tap("Button", "Check");
    await says(/^Right/);
    await next();

    // A formula: the names and signs that a phone's keyboard hides have buttons.
    await heading("Write the term");
    await tap("MultilineTextInput", "Your answer");
    await until(() => page.evaluate(() => ["INPUT", "TEXTAREA"].includes(document.activeElement.tagName)));
    await page.keyboard.type("kd*ip*max(");
    await tap("Button", "Insert N·L");
    await page.keyboard.type(",0)");
    await tap("Button", "Check");
    await says(/^Right/);
    await next();

    // An order: each item is moved up until it is where it belongs.
    await heading("Material and angle together");
    const items = async () => (await widgets(page)).filter(({ role, name }) => role === "Button" && name.startsWith("Move up: ")).map(({ name }) => name.match(/Kd = ([\d.]+),/)[1]);
    for (const [place, item] of ["0.95", "0.35", "0.5", "0.9"].entries()) {
      for (let at = (await items()).indexOf(item); at > place; at -= 1) {
        await tap("Button", (await widgets(page)).find(({ name }) => name.startsWith("Move up") && name.includes(`Kd = ${item},`)).name);
        await until(async () => (await items()).indexOf(item) === at - 1);
      }
    }
    await tap("Button", "Check");
    await says(/^Right/);

    await tap("Button", "Results", false);
    await heading("Results");
    await tap("Button", "Hand in", false);
    await tap("TextInput", "Your name", false);
    await page.keyboard.type("Ada");
    const download = page.waitForEvent("download");
    await tap("Button", "Write", false);
    const file = join(phone.folder, "ada.png");
    await (await download).saveAs(file);
    assert.deepEqual(problems, []);
    if (!native) return context.skip("no native program to grade it");
    const graded = execFileSync(native, ["collect", file, "--json"], { encoding: "utf8" });
    assert.ok(graded.includes("Ada") && graded.includes("diffuse"), graded);
  } finally {
    await phone.close();
    server.close();
  }
});
