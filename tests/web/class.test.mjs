// The live class on phones: the lecturer's program serves a page, and real browsers join, answer, lose their connection and cheat.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { join } from "node:path";
import { tmpdir } from "node:os";
import { createInterface } from "node:readline";
import { browser, firefox, native, until } from "./browser.mjs";

const EVERY_KIND = "tests/data/every-kind.md";
/** The first view of a phone: the page, its style and script, the step and its pictures. */
const FIRST_VIEW = 80_000;

/** A class that the program teaches without a window; `events` are the lines that it prints. */
async function teach(lesson, { record, port, ownPace, language = "en" } = {}) {
  const folder = record ? undefined : mkdtempSync(join(tmpdir(), "shading-lab-class-"));
  const file = record ?? join(folder, "class.jsonl");
  const options = ["--headless", "--bind", "127.0.0.1", "-o", file, "--language", language, ...(ownPace ? ["--own-pace"] : [])];
  const program = spawn(native, ["class", lesson, ...options, ...(port ? ["--port", port] : [])], { stdio: ["pipe", "pipe", "ignore"] });
  const events = [];
  createInterface({ input: program.stdout }).on("line", (line) => events.push(JSON.parse(line)));
  const ended = new Promise((done) => program.on("exit", done));
  await until(() => events.length > 0 || program.exitCode !== null);
  assert.equal(events[0]?.event, "open", "the class has started");
  const last = (event) => events.findLast((one) => one.event === event);
  const say = (word) => program.stdin.write(`${word}\n`);
  return {
    url: events[0].address,
    port: String(events[0].port),
    file,
    events,
    last,
    /** Does what the lecturer wants, and waits until the class is there. */
    async go(word, phase, step) {
      say(word);
      await until(() => last("step").phase === phase && (!step || last("step").step === step));
    },
    answered: (count) => until(() => last("answered").answered === count),
    /** The answers of the class, once they are graded. */
    async shown(step, rounds = 1) {
      await until(() => last("shown")?.step === step && last("shown").rounds.length === rounds);
      return last("shown").rounds;
    },
    async kill() {
      program.kill("SIGKILL");
      await ended;
    },
    async end() {
      program.kill("SIGKILL");
      await ended;
      if (folder) rmSync(folder, { recursive: true, force: true });
    },
  };
}

const PHONE = { width: 390, height: 844, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** A phone that has joined a class; `problems` is what its console reports. */
async function phone(url, options = {}) {
  const own = await browser({ ...PHONE, ...options });
  const page = await own.context.newPage();
  const problems = [];
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  await page.goto(url);
  const sent = () => page.locator(".sent").textContent();
  const saved = () => until(async () => /^Saved/.test(await sent()));
  const at = (step) => page.waitForSelector(`article[data-step="${step}"]`);
  const send = async () => {
    await page.locator(".send").click();
    await saved();
  };
  return { ...own, page, problems, sent, saved, at, send };
}

/** What a class answers to a request of a page of its own. */
const ask = (page, path, body, credentials = "same-origin") =>
  page.evaluate(
    async ([path, body, credentials]) => {
      const options = body ? { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) } : {};
      const response = await fetch(path, { ...options, credentials });
      return response.status;
    },
    [path, body, credentials],
  );

/** Draws with a finger through places of an element, as fractions of its size. */
async function draw(page, selector, places) {
  const fingers = await page.context().newCDPSession(page);
  await page.locator(selector).scrollIntoViewIfNeeded();
  const box = await page.locator(selector).boundingBox();
  const touch = (type, place) => {
    const points = place ? [{ x: box.x + place[0] * box.width, y: box.y + place[1] * box.height }] : [];
    return fingers.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  };
  await touch("touchStart", places[0]);
  for (const place of places.slice(1)) await touch("touchMove", place);
  await touch("touchEnd");
}

/** Taps a place of the picture, in units of its shorter side from the middle. */
async function tap(page, [x, y]) {
  const picture = page.locator(".place svg");
  await picture.scrollIntoViewIfNeeded();
  const box = await picture.boundingBox();
  const side = Math.min(box.width, box.height);
  await page.touchscreen.tap(box.x + box.width / 2 + x * side, box.y + box.height / 2 + y * side);
}

const skip = native ? false : "no native program that teaches";

test("three phones: one draws, one loses its connection, one cheats", { skip }, async () => {
  const class1 = await teach("mach-bands");
  const phones = [];
  try {
    for (let index = 0; index < 3; index += 1) phones.push(await phone(class1.url));
    const [ada, bob, eve] = phones;
    await until(() => class1.last("joined")?.joined === 3);
    assert.ok(await ada.page.locator("#pager").isHidden(), "all follow the lecturer");

    // A place in the picture. One answers without a connection; it is sent as soon as there is one.
    await tap(ada.page, [0.22, -0.002]);
    assert.match(await ada.page.locator("#place").textContent(), /^Cross at 0\.2\d, 0\.00 /);
    await ada.send();
    await bob.context.setOffline(true);
    await tap(bob.page, [-0.2, 0.1]);
    await bob.page.locator(".send").click();
    await until(async () => /^Not sent yet/.test(await bob.sent()));
    assert.match(await bob.page.locator("#connection").textContent(), /^No connection/);
    assert.equal(class1.last("answered").answered, 1);
    await bob.context.setOffline(false);
    await bob.saved();
    await until(async () => (await bob.page.locator("#connection").textContent()) === "");
    await class1.answered(2);

    // What is not open, or not shown yet, or somebody else's.
    const point = { step: 1, round: 1, answer: { point: [0, 0] } };
    assert.equal(await ask(eve.page, "answers", { ...point, step: 2, answer: { curve: Array(65).fill(0.5) } }), 409);
    assert.equal(await ask(eve.page, "answers", { ...point, round: 2 }), 409);
    assert.equal(await ask(eve.page, "answers", { ...point, answer: { choice: 0 } }), 400);
    assert.equal(await ask(eve.page, "answers", point, "omit"), 401);
    assert.equal(await ask(eve.page, "steps/1/explanation"), 403);
    assert.equal(await ask(eve.page, "steps/2"), 403);
    assert.equal(await ask(eve.page, "steps/2/1.png"), 403);
    assert.equal(await ask(eve.page, "answers", point), 200);
    await class1.answered(3);

    // The answers are shown: no more of them. Then again, and before and after side by side.
    await class1.go("show", "spread");
    const [first] = await class1.shown(1);
    const given = first.answers.map((one) => one.given);
    assert.ok(Math.hypot(given[0][0] - 0.22, given[0][1]) < 0.02, `${given[0]}`);
    assert.ok(Math.hypot(given[1][0] + 0.2, given[1][1] - 0.1) < 0.02, `${given[1]}`);
    assert.deepEqual([first.right, first.answers[0].right], [1, true]);
    assert.equal(await ask(eve.page, "answers", point), 409);
    assert.equal(await ask(eve.page, "steps/1/explanation"), 403);
    await until(async () => /being shown/.test(await ada.sent()));
    assert.ok(await ada.page.locator("fieldset").evaluate((fields) => fields.disabled));
    await class1.go("again", "ask");
    await until(async () => /^Asked again/.test(await bob.sent()));
    await tap(bob.page, [0.2233, 0]);
    await bob.send();
    await class1.answered(1);
    await class1.go("explain", "explain");
    const rounds = await class1.shown(1, 2);
    assert.deepEqual(rounds.map((round) => round.right), [1, 1]);
    await bob.page.waitForSelector(".explanation .points .cross.own");
    assert.match(await bob.page.locator(".explanation").textContent(), /At the right edge/);

    // A curve, drawn with a finger.
    await class1.go("next", "ask", 2);
    await ada.at(2);
    await draw(ada.page, ".plot svg", Array.from({ length: 41 }, (_, step) => [0.02 + 0.024 * step, 0.3 + 0.01 * step]));
    await ada.send();
    await class1.go("explain", "explain");
    const [curves] = await class1.shown(2);
    const curve = curves.answers[0].given;
    const drawn = curve.filter((value) => value !== null);
    assert.equal(curve.length, 65);
    assert.ok(drawn.length === 65 && drawn.every((value, index) => index === 0 || value <= drawn[index - 1] + 1e-9), `${curve}`);
    await ada.page.waitForSelector(".explanation .plot .curve.own");

    // A choice, and a step back, which is as it was left.
    await class1.go("next", "ask", 3);
    await class1.go("next", "ask", 4);
    await ada.at(4);
    await ada.page.getByRole("radio").first().check();
    await ada.send();
    await class1.answered(1);
    await class1.go("back", "ask", 3);
    await ada.at(3);
    await class1.go("next", "ask", 4);
    await ada.at(4);
    await until(() => ada.page.getByRole("radio").first().isChecked());
    await ada.saved();

    // The file has what the phones were told is saved.
    const collected = JSON.parse(execFileSync(native, ["collect", class1.file, "--json"]));
    assert.equal(collected.rows.length, 3);
    assert.deepEqual(collected.rows.map((row) => row.answers.filter((answer) => answer.given !== null).length), [3, 1, 1]);
    for (const one of [ada, eve]) assert.deepEqual(one.problems.filter((words) => !/40[0-9]/.test(words)), []);
  } finally {
    for (const one of phones) await one.close();
    await class1.end();
  }
});

test("a class that is started again goes on with the same students, and nothing that was typed is lost", { skip }, async () => {
  const first = await teach(EVERY_KIND);
  const own = await phone(first.url);
  let second;
  try {
    await own.page.getByLabel("Nickname (optional)").fill("Ada");
    await own.page.getByRole("button", { name: "Save" }).click();
    await own.page.getByRole("radio").nth(0).check();
    await own.send();
    await first.kill();
    await until(async () => /^No connection/.test(await own.page.locator("#connection").textContent()));
    await own.page.getByRole("radio").nth(1).check();
    await own.page.locator(".send").click();
    await until(async () => /^Not sent yet/.test(await own.sent()));
    await own.page.reload().catch(() => {});
    second = await teach(EVERY_KIND, { record: first.file, port: first.port });
    // The page of the failed reload may still be on its way, and take this one's place.
    await until(() => own.page.goto(second.url).then(() => true, () => false));
    await own.saved();
    assert.ok(await own.page.getByRole("radio").nth(1).isChecked());
    await second.go("show", "spread");
    const [round] = await second.shown(1);
    assert.deepEqual(round.answers.map((one) => one.given), [1]);

    // A second tab is the same student, and knows what the first one has sent.
    const tab = await own.context.newPage();
    await tab.goto(second.url);
    await until(() => tab.getByRole("radio").nth(1).isChecked());
    await until(() => second.last("joined").connected === 1);
    assert.equal(second.last("joined").joined, 1);
  } finally {
    await own.close();
    await second?.end();
    await first.end();
  }
});

/** Moves the focus on until it is on what this selects. */
async function tabTo(page, selector) {
  for (let step = 0; step < 60; step += 1) {
    if (await page.evaluate((selector) => document.activeElement?.matches(selector), selector)) return;
    await page.keyboard.press("Tab");
  }
  assert.fail(`the keyboard does not reach ${selector}`);
}

test("every kind of question is answered by keyboard alone", { skip }, async () => {
  const own = await teach(EVERY_KIND);
  const { page, saved, at, close, problems } = await phone(own.url, { hasTouch: false, isMobile: false });
  const type = async (selector, words) => {
    await tabTo(page, selector);
    await page.keyboard.type(words);
  };
  const enter = async () => {
    await tabTo(page, ".send");
    await page.keyboard.press("Enter");
    await saved();
  };
  const choose = async () => {
    await tabTo(page, "input[type=radio]");
    await page.keyboard.press("Space");
    await page.keyboard.press("ArrowDown");
  };
  const point = async () => {
    await tabTo(page, ".place svg");
    for (const key of ["ArrowRight", "ArrowRight", "Shift+ArrowUp"]) await page.keyboard.press(key);
  };
  const curve = async () => {
    await tabTo(page, "summary");
    await page.keyboard.press("Enter");
    for (let place = 0; place <= 64; place += 8) await type(`.values input[data-at="${place}"]`, String(1 - place / 100));
  };
  const order = async () => {
    await tabTo(page, ".order li:first-child .down");
    await page.keyboard.press("Enter");
  };
  const numbers = (...values) => async () => {
    for (const [index, value] of values.entries()) await type(`#number-${index}`, value);
  };
  const formula = (words) => () => type(".formula textarea", words);
  const kinds = [
    [choose, 1], [choose, 1], [numbers("0,5"), 0.5], [point, [0.02, -0.1]], [point, [0.02, -0.1]], [curve], [curve],
    [numbers("30"), 30], [numbers("0.5"), 0.5], [order, [1, 2, 0]], [numbers("0.2"), [0.2]], [numbers("0.3", "0.4"), [0.3, 0.4]],
    [formula("kd * max(0, NL)"), "kd * max(0, NL)"],
  ];
  try {
    for (const [index, [answer, expected]] of kinds.entries()) {
      await at(index + 1);
      await answer();
      await enter();
      await own.answered(1);
      await own.go("show", "spread");
      const [round] = await own.shown(index + 1);
      const { given } = round.answers[0];
      if (expected === undefined) {
        assert.deepEqual([given[0], given[4], given[64]].map((value) => Number(value.toFixed(3))), [1, 0.96, 0.36]);
      } else if (typeof expected === "string") {
        assert.deepEqual([given, round.right], [expected, 1]);
      } else {
        const flat = [given].flat();
        assert.ok([expected].flat().every((value, place) => Math.abs(value - flat[place]) < 1e-6), `${index + 1}: ${given}`);
      }
      await own.go("explain", "explain");
      await page.waitForSelector(".explanation h3");
      if (index + 1 < kinds.length) await own.go("next", "ask", index + 2);
    }
    assert.deepEqual(problems, []);
  } finally {
    await close();
    await own.end();
  }
});

test("at their own pace phones turn the steps, and a formula is typed with a thumb", { skip }, async () => {
  const own = await teach(EVERY_KIND, { ownPace: true });
  const { page, send, at, close, problems } = await phone(own.url);
  const where = () => page.locator("#pager span").textContent();
  let again;
  try {
    const [back, next] = ["Back", "Next"].map((name) => page.getByRole("button", { name, exact: true }));
    await until(async () => (await where()) === "Step 1 of 13");
    assert.ok(await back.isDisabled());
    await next.tap();
    await at(2);
    await until(async () => (await where()) === "Step 2 of 13 (the lecturer is at step 1)");
    await page.getByRole("radio").first().check();
    await send();
    assert.equal(await ask(page, "steps/2/explanation"), 403, "what is not explained yet");
    assert.deepEqual([own.last("step").step, own.last("answered").answered], [1, 0]);

    // At the lecturer's step one follows the lecturer again.
    await own.go("next", "ask", 2);
    await until(async () => (await where()) === "Step 2 of 13");
    await own.answered(1);
    await own.go("next", "ask", 3);
    for (let step = 4; step <= 13; step += 1) {
      await at(step - 1);
      await page.waitForTimeout(300);
      await next.tap();
    }
    await at(13);
    assert.ok(await next.isDisabled());
    const [keys, field] = [page.locator(".keys button"), page.locator(".formula textarea")];
    await field.scrollIntoViewIfNeeded();
    const [top, bottom] = [await field.boundingBox(), await keys.last().boundingBox()];
    assert.ok(bottom.y + bottom.height - top.y < 300, "the signs are beside the field");
    const signs = await keys.allTextContents();
    for (const name of ["kd", "N·L", "·", "^", "(", ")"]) assert.ok(signs.includes(name), `${name} in ${signs}`);
    const put = (name) => keys.nth(signs.indexOf(name)).tap();
    await put("kd");
    await page.keyboard.type(" * max(");
    await put("N·L");
    await page.keyboard.type(", 0)");
    await send();

    // Started again, the class finds the phone where it was.
    await own.kill();
    again = await teach(EVERY_KIND, { record: own.file, port: own.port, ownPace: true });
    await until(() => again.last("joined")?.connected === 1);
    await until(async () => (await where()) === "Step 13 of 13 (the lecturer is at step 3)");
    const collected = JSON.parse(execFileSync(native, ["collect", own.file, "--json"]));
    const given = collected.rows[0].answers.map((answer) => answer.given);
    assert.deepEqual([given[1], given[12], collected.rows[0].answers[12].right], [0, "kd * max(N·L, 0)", true]);
    assert.deepEqual(problems.filter((words) => !/40[0-9]|ERR_/.test(words)), []);
  } finally {
    await close();
    await again?.end();
    await own.end();
  }
});

test("choice, value and order by what the accessibility tree tells alone", { skip }, async () => {
  const own = await teach(EVERY_KIND);
  const { page, at, close } = await phone(own.url);
  const send = async () => {
    await page.getByRole("button", { name: "Send" }).click();
    await page.getByRole("status").filter({ hasText: /^Saved/ }).waitFor();
  };
  try {
    await page.getByRole("group", { name: "Choice" }).getByRole("radio", { name: "B. No" }).check();
    await send();
    await own.go("next", "ask", 2);
    await own.go("next", "ask", 3);
    await at(3);
    const field = page.getByRole("textbox", { name: "Your answer", exact: true });
    await field.fill("7");
    await page.getByRole("button", { name: "Send" }).click();
    await page.getByRole("alert").filter({ hasText: "Enter a number from −1 to 1." }).waitFor();
    assert.equal(await page.evaluate(() => document.activeElement.id), "number-0");
    await field.fill("-0.25");
    await send();
    for (let step = 4; step <= 10; step += 1) await own.go("next", "ask", step);
    await at(10);
    const items = () => page.getByRole("listitem").evaluateAll((items) => items.map((item) => item.querySelector(".words").textContent));
    assert.deepEqual(await items(), ["C. B", "B. A", "A. C"]);
    await page.getByRole("button", { name: "Move up: B. A" }).click();
    await page.getByRole("status").filter({ hasText: "B. A: place 1" }).waitFor();
    assert.deepEqual(await items(), ["B. A", "C. B", "A. C"]);
    await send();
    await own.go("show", "spread");
    const [round] = await own.shown(10);
    assert.deepEqual([round.answers[0].given, round.answers[0].right], [[1, 2, 0], true]);
  } finally {
    await close();
    await own.end();
  }
});

for (const [language, words] of [["en", "Send"], ["zh-Hant", "送出"]]) {
  test(`the first view has at most 80 KB and fits the screen: ${language}`, { skip }, async () => {
    const own = await teach("mach-bands", { language });
    const { context, close } = await browser({ ...PHONE, colorScheme: "dark" });
    try {
      const page = await context.newPage();
      let bytes = 0;
      page.on("response", async (response) => {
        const body = await response.body().catch(() => undefined);
        bytes += body?.length ?? 0;
      });
      await page.goto(own.url);
      await page.getByRole("button", { name: words, exact: true }).waitFor();
      await until(() => own.last("joined")?.connected === 1);
      await page.waitForTimeout(500);
      console.log(`first view, ${language}: ${bytes} bytes`);
      assert.ok(bytes > 10_000 && bytes <= FIRST_VIEW, `${bytes} bytes`);
      const [wide, ground] = await page.evaluate(() => [document.documentElement.scrollWidth, getComputedStyle(document.body).backgroundColor]);
      assert.equal(wide, 390);
      assert.equal(ground, "rgb(20, 22, 26)", "a dark page");
      const small = await page.evaluate(() => [...document.querySelectorAll("button, input, summary, .option")].map((one) => one.getBoundingClientRect()).filter((box) => box.height > 0 && box.height < 44).length);
      assert.equal(small, 0, "targets are high enough for a finger");
    } finally {
      await close();
      await own.end();
    }
  });
}

if (!process.env.FIREFOX) {
  test("the class in Firefox", { skip: process.env.NO_FIREFOX ?? "no Firefox" });
} else {
  const here = {};
  before(async () => native && (here.browser = await firefox({ width: 500, height: 844 })));
  after(() => here.browser?.close());

  test("the class in Firefox", { skip }, async () => {
    const own = await teach("mach-bands");
    try {
      const page = await here.browser.context.newPage();
      await page.goto(own.url);
      await page.waitForSelector("article[data-step='1'] .place svg");
      const box = await (await page.$(".place svg")).boundingBox();
      await page.mouse.click(box.x + 0.72 * box.width, box.y + box.height / 2);
      await page.click(".send");
      const sent = () => page.$eval(".sent", (told) => told.textContent);
      await until(async () => /^Saved/.test(await sent()));
      await own.go("next", "ask", 2);
      await page.waitForSelector("article[data-step='2'] .plot svg");
      const plot = await page.$(".plot svg");
      await plot.scrollIntoView();
      const area = await plot.boundingBox();
      await page.mouse.move(area.x + 2, area.y + 0.4 * area.height);
      await page.mouse.down();
      await page.mouse.move(area.x + area.width - 2, area.y + 0.4 * area.height, { steps: 40 });
      await page.mouse.up();
      await page.click(".send");
      await until(async () => /^Saved/.test(await sent()));
      await own.go("explain", "explain");
      await page.waitForSelector(".explanation .curve.own");
      const [round] = await own.shown(2);
      assert.equal(round.answers[0].given.filter((value) => value !== null).length, 65);
      await page.close();
    } finally {
      await own.end();
    }
  });
}
