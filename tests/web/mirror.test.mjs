// The window as a screen reader meets it, in Chromium's own accessibility tree, operated by what assistive technology can do: giving
// the focus to an element, and keys.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { firefox, native, open, serve, site, until } from "./browser.mjs";

const here = site();

/** The nodes of the browser's accessibility tree that a screen reader meets. */
async function tree(page) {
  page.reader ??= await page.context().newCDPSession(page);
  const { nodes } = await page.reader.send("Accessibility.getFullAXTree");
  const property = (node, name) => node.properties?.find((one) => one.name === name)?.value.value;
  return nodes.filter(({ ignored }) => !ignored).map((node) => ({
    role: node.role?.value,
    name: node.name?.value ?? "",
    value: node.value?.value,
    about: node.description?.value ?? "",
    checked: property(node, "checked"),
    focused: property(node, "focused"),
    disabled: property(node, "disabled"),
    element: node.backendDOMNodeId,
  }));
}

/** Waits for the node of a role whose name begins with these words. */
async function meet(page, role, name) {
  let found;
  await until(async () => (found = (await tree(page)).find((node) => node.role === role && node.name.startsWith(name) && !node.disabled)));
  return found;
}

/** Gives a node the focus, as a screen reader does, and presses a key on it. */
async function use(page, role, name, key = "Enter") {
  const { element } = await meet(page, role, name);
  await page.reader.send("DOM.focus", { backendNodeId: element });
  if (key) await page.keyboard.press(key);
}

/** Waits until the live region says something that has these words in it. */
const hear = (page, words) => until(() => page.evaluate((words) => document.querySelector("[role=status]").textContent.includes(words), words));

test("the picture, its controls and headings are read", async () => {
  await here.on("?scene=sphere", async (page) => {
    const picture = await meet(page, "image", "Picture, Phong shading");
    assert.match(picture.about, /sphere in Phong shading, lit from .*; brightest at .*\. Probe at \d+, \d+/);
    const kd = await meet(page, "slider", "Kd diffuse coefficient");
    const value = Number(kd.value);
    assert.ok(value > 0 && value < 1, kd.value);
    await use(page, "slider", "Kd diffuse coefficient", "ArrowRight");
    await until(async () => Number((await meet(page, "slider", "Kd diffuse coefficient")).value) > value);
    // The focus stays where it is, and the window shows it.
    assert.ok((await meet(page, "slider", "Kd diffuse coefficient")).focused);
    // A field is typed in.
    await use(page, "textbox", "Ks specular coefficient", "");
    await page.keyboard.press("Control+A");
    await page.keyboard.type("0.25");
    await page.keyboard.press("Enter");
    await until(() => page.evaluate(() => location.search.includes("material.ks=0.25")));
    // The probe is told when it has moved.
    await use(page, "image", "Picture", "ArrowRight");
    await hear(page, "Probe at");
  });
});

test("the window's own focus is told", async () => {
  await here.on("?scene=sphere", async (page) => {
    await page.mouse.click(700, 400);
    await page.keyboard.press("F10");
    await until(async () => (await tree(page)).some(({ role, name }) => role === "application" && name === "shading-lab: File"));
  });
});

test("a lesson is done through the mirror alone, from the list to a hand-in that is graded", async (context) => {
  const { page, problems } = await open(here.browser.context, `${here.server.url}?scene=sphere`);
  await use(page, "button", "Course");
  await use(page, "button", "Diffuse reflection");
  await meet(page, "heading", "Matt surfaces");
  const next = () => use(page, "button", "Next");
  await next();
  await meet(page, "heading", "A tilted surface");
  await next();
  await meet(page, "heading", "N·L");
  assert.ok((await tree(page)).some(({ name }) => name.includes("the diffuse coefficient of the material")), "the lesson's text is read");

  // A value.
  await use(page, "textbox", "Your answer", "");
  await page.keyboard.type("0.6");
  await page.keyboard.press("Tab");
  await use(page, "button", "Check");
  await hear(page, "Right");
  await next();
  await meet(page, "heading", "Where the light ends");
  await next();
  await meet(page, "heading", "Walk round the ball");

  // A choice, wrong at first.
  await use(page, "radio", "Brighter than before", "Space");
  await until(async () => (await meet(page, "radio", "Brighter than before")).checked === "true");
  await use(page, "button", "Check");
  await hear(page, "Not");
  await use(page, "radio", "As bright as before", "Space");
  await until(async () => (await meet(page, "radio", "As bright as before")).checked === "true");
  await use(page, "button", "Check");
  await hear(page, "Right");
  await next();

  // A formula.
  await meet(page, "heading", "Write the term");
  await use(page, "textbox", "Your answer", "");
  await page.keyboard.type("kd*ip*max(0, N·L)");
  await page.keyboard.press("Tab");
  await use(page, "button", "Check");
  await hear(page, "Right");
  await next();
  await meet(page, "heading", "Material and angle together");

  // An order: each item is moved up until it is where it belongs.
  const wanted = ["0.95", "0.35", "0.5", "0.9"];
  const items = async () => (await tree(page)).filter(({ role, name }) => role === "button" && name.startsWith("Move up: ")).map(({ name }) => name.match(/Kd = ([\d.]+),/)[1]);
  for (const [place, item] of wanted.entries()) {
    for (let at = (await items()).indexOf(item); at > place; at -= 1) {
      const { element } = (await tree(page)).find(({ role, name, disabled }) => role === "button" && !disabled && name.startsWith("Move up") && name.includes(`Kd = ${item},`));
      await page.reader.send("DOM.focus", { backendNodeId: element });
      await page.keyboard.press("Enter");
      await until(async () => (await items()).indexOf(item) === at - 1);
    }
  }
  await use(page, "button", "Check");
  await hear(page, "Right");

  // The hand-in.
  await use(page, "button", "Results");
  await meet(page, "heading", "Results");
  await use(page, "button", "Hand in");
  await use(page, "textbox", "Your name", "");
  await page.keyboard.type("Ada");
  await page.keyboard.press("Tab");
  const download = page.waitForEvent("download");
  await use(page, "button", "Write");
  const file = join(here.browser.folder, "ada.png");
  await (await download).saveAs(file);
  assert.deepEqual(problems, []);
  await page.close();
  if (!native) return context.skip("no native program to grade it");
  const graded = JSON.parse(execFileSync(native, ["collect", file, "--json"], { encoding: "utf8" }));
  const text = JSON.stringify(graded);
  assert.ok(text.includes("Ada") && text.includes("diffuse"), text);
});

// Its accessibility tree cannot be asked for, so its elements stand for it.
test("Firefox: the window is there as elements, which operate it", { skip: !process.env.FIREFOX && "no Firefox" }, async () => {
  const server = await serve(process.env.SHADING_LAB_PAGE);
  const other = await firefox();
  try {
    const { page, problems } = await open(other.context, `${server.url}?scene=sphere`);
    const find = (selector, words) => page.evaluate((selector, words) => [...document.querySelectorAll(`#mirror ${selector}`)].some((one) => (one.ariaLabel ?? one.textContent).startsWith(words)), selector, words);
    const click = async (words) => {
      await until(() => find("button", words));
      await page.evaluate((words) => [...document.querySelectorAll("#mirror button")].find((one) => one.textContent.startsWith(words)).click(), words);
    };
    await until(() => find("[role=img]", "Picture, Phong shading"));
    await until(() => find("input[type=range]", "Kd diffuse coefficient"));
    await click("Course");
    await click("Diffuse reflection");
    await until(() => find("h2", "Matt surfaces"));
    await until(() => page.evaluate(() => document.querySelector("#mirror article").textContent.includes("Lambertian reflection")));
    assert.deepEqual(problems, []);
  } finally {
    await other.close();
    server.close();
  }
});
