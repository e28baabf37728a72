// The web page in a browser: it opens, draws what the native program draws, and follows links.
import { test } from "node:test";
import assert from "node:assert/strict";
import { address, browser, difference, drop, isNative, open, picture, pixels, press, site, state, until, widget, widgets } from "./browser.mjs";

const here = site();

test("the first picture is the native one", async (context) => {
  await here.on("", async (page) => {
    const unknown = await isNative(page, here.browser.folder);
    if (unknown) context.skip(unknown);
  });
});

test("a link opens its scene, and the address follows the state", async () => {
  const link = "?scene=sphere&set=material.n=7&set=shading.mode=gouraud&view=curves";
  await here.on(link, async (page) => {
    const before = await pixels(page, await picture(page));
    await page.keyboard.press("4");
    await until(async () => (await address(page)).includes("shading.mode=phong") || !(await address(page)).includes("gouraud"));
    assert.ok((await address(page)).includes("material.n=7"), "the rest of the link stays");
    const after = await pixels(page, await picture(page));
    assert.ok(difference(before, after) > 1, "another shading mode is another picture");
    // What the address says opens as the same picture.
    const again = await address(page);
    await here.on(again, async (other) => {
      assert.equal(difference(after, await pixels(other, await picture(other))), 0);
    });
  });
});

test("a link opens a lesson, whose text comes after the first picture", async () => {
  await here.on("?lesson=exponent&step=2", async (page) => {
    await until(async () => (await widgets(page)).some(({ name }) => name === "Check"));
    const names = (await widgets(page)).map(({ name }) => name);
    assert.ok(names.some((name) => name.startsWith("Drawing of")), "the question is to be drawn");
    await page.keyboard.press("PageDown");
    await until(async () => (await address(page)).includes("step=3"));
  });
});

test("a wrong link is told by its key, and the default scene opens", async () => {
  const wrong = [["?scene=no-such-scene", "`scene` is \"no-such-scene\""], ["?scene=gold&set=material.n=-1", "`material.n` is -1"]];
  for (const [link, words] of wrong) {
    await here.on(link, async (page) => {
      await until(async () => (await widgets(page)).some(({ name }) => name.includes(words)));
      assert.ok(await widget(page, "The link could not be opened"));
      assert.ok((await page.title()).startsWith("shading-modes"), await page.title());
      await press(page, "Close");
      await until(async () => (await widget(page, "The link could not be opened")) === undefined);
    });
  }
});

test("as a figure in another page it is the picture and the controls that the link names", async () => {
  await here.on("?scene=sphere&embed&controls=n,ks,light,no-such", async (page) => {
    const all = await widgets(page);
    const sliders = all.filter(({ role }) => role === "Slider").map(({ name }) => name);
    assert.deepEqual(sliders.sort(), ["Ks specular coefficient", "n specular exponent"]);
    const names = all.map(({ name }) => name);
    for (const name of ["Light 1 position x", "no control is called no-such", "Open in shading-lab"]) assert.ok(names.includes(name), name);
    assert.ok(!names.includes("File"), "no menu");
    const before = await pixels(page, await picture(page));
    const slider = await widget(page, "n specular exponent", "Slider");
    await page.mouse.click(slider.x + 0.9 * slider.width, slider.y + slider.height / 2, { delay: 200 });
    assert.ok(difference(before, await pixels(page, await picture(page))) > 1, "the slider changes the picture");
    await page.waitForTimeout(1000);
    assert.equal(await address(page), "?scene=sphere&embed&controls=n,ks,light,no-such", "its address stays");
  });
});

test("Chinese has its own letters, fetched when that language is chosen", async () => {
  const chinese = await browser({ locale: "zh-TW" });
  try {
    const fetched = [];
    chinese.context.on("request", (request) => fetched.push(new URL(request.url()).pathname));
    const { page, problems } = await open(chinese.context, here.server.url);
    await until(() => fetched.includes("/chinese.otf"));
    assert.equal(await page.evaluate(() => document.documentElement.lang), "zh-Hant");
    assert.ok(await widget(page, "檔案"));
    assert.deepEqual(problems, []);
    // What is said first is said in Chinese, too.
    const wrong = await open(chinese.context, `${here.server.url}?sceen=cube`);
    await until(() => widget(wrong.page, "無法開啟連結"));
  } finally {
    await chinese.close();
  }
});

test("it opens without a network", async () => {
  await here.on("", async (page) => {
    await page.evaluate(() => navigator.serviceWorker.ready);
    await here.browser.context.setOffline(true);
    try {
      await page.reload();
      await until(async () => (await state(page)) === "ready");
    } finally {
      await here.browser.context.setOffline(false);
    }
  });
});

test("a link of a lesson opens pages alone, each in a tab of its own", async () => {
  const lesson = `+++
lesson = 1
name = "links"
title = "Links"
+++

## Links

[page](${here.server.url}embedding.html)

[script](javascript:document.title=1) [data](data:text/html,x) [file](file:///etc/passwd)

\`\`\`step
scene = "sphere"
\`\`\`
`;
  await here.on("", async (page) => {
    await drop(page, "links.md", lesson);
    await until(async () => (await widget(page, "page", "Link")) !== undefined);
    const own = ["page", "script", "data", "file"];
    const links = (await widgets(page)).filter(({ role, name }) => role === "Link" && own.includes(name));
    assert.deepEqual(links.map(({ name }) => name), ["page"], "what may not be opened is text");
    const before = page.url();
    const popup = page.waitForEvent("popup");
    await press(page, "page", "Link");
    const opened = await popup;
    await opened.waitForLoadState("domcontentloaded");
    assert.ok(opened.url().endsWith("/embedding.html"), opened.url());
    assert.equal(await opened.evaluate(() => window.opener), null);
    await opened.close();
    assert.equal(page.url().split("?")[0], before.split("?")[0], "the page stays");
  });
});

test("a model is dropped with its library, and a library that is missing is named", async () => {
  const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3 4\n";
  const library = "newmtl red\nKd 0.8 0.1 0.1\n";
  const asks = async (page) => (await widgets(page)).some(({ name }) => name.includes("red.mtl: drop this file"));
  const lists = async (page) => (await widget(page, "red", "Button")) !== undefined;
  await here.on("", async (page) => {
    await drop(page, "square.obj", `mtllib red.mtl\n${square}`);
    await until(() => asks(page));
    assert.ok(!(await lists(page)));
    // The library alone completes the model.
    await drop(page, "red.mtl", library);
    await until(() => lists(page));
    assert.ok(!(await asks(page)));
  });
  await here.on("", async (page) => {
    await drop(page, "red.mtl", library, "square.obj", `mtllib ./red.mtl\n${square}`);
    await until(() => lists(page));
    assert.ok(!(await asks(page)));
    const title = await page.title();
    assert.ok(title.startsWith("square.obj"), title);
  });
});

test("the page runs no script but its own", async () => {
  const { page } = await open(here.browser.context, here.server.url);
  const { ran, refused } = await page.evaluate(async () => {
    const refused = [];
    document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => refused.push(effectiveDirective));
    const inline = document.createElement("script");
    inline.textContent = "window.ran = 'inline'";
    document.body.append(inline);
    const link = document.createElement("a");
    link.href = "javascript:window.ran='link'";
    document.body.append(link);
    link.click();
    const image = document.createElement("img");
    image.setAttribute("onerror", "window.ran = 'handler'");
    image.src = "no-such.png";
    document.body.append(image);
    await fetch("https://example.org/").catch(() => {});
    await new Promise((later) => setTimeout(later, 500));
    return { ran: window.ran, refused };
  });
  assert.equal(ran, undefined);
  for (const directive of ["script-src-elem", "script-src-attr", "connect-src"]) assert.ok(refused.includes(directive), `${directive}: ${refused}`);
  await page.close();
});

test("a trap of the program, or one in the middle of other work, is said", async () => {
  // A module whose only function runs into `unreachable`, as the program does where memory has run out.
  const trap = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 5, 1, 1, 102, 0, 0, 10, 5, 1, 3, 0, 0, 11];
  for (const late of [false, true]) {
    const { page, problems } = await open(here.browser.context, here.server.url + "?scene=sphere");
    await page.evaluate(([bytes, late]) => {
      const { exports } = new WebAssembly.Instance(new WebAssembly.Module(new Uint8Array(bytes)));
      setTimeout(late ? async () => exports.f() : () => exports.f());
    }, [trap, late]);
    await until(() => page.evaluate(() => document.documentElement.dataset.state === "stopped"));
    assert.ok(await page.getByRole("alert").isVisible());
    assert.ok(problems.some((problem) => problem.includes("unreachable")), problems);
    await page.close();
  }
});

test("a scene that takes too much memory is refused with the figure", async () => {
  const { page } = await open(here.browser.context, here.server.url + "?scene=teapot&set=object.segments=4096&set=object.rings=4096");
  assert.equal(await page.evaluate(() => document.documentElement.dataset.state), "ready");
  await until(async () => (await widgets(page)).some(({ name }) => name.includes("MB of memory")));
  await page.close();
});
