// Firefox: the page opens and draws what the native program draws.
import { test } from "node:test";
import { firefox, isNative, site } from "./browser.mjs";

if (!process.env.FIREFOX) {
  test("Firefox", { skip: process.env.NO_FIREFOX ?? "no Firefox" });
} else {
  const here = site(firefox);

  test("Firefox: the first picture is the native one", async (context) => {
    await here.on("", async (page) => {
      const unknown = await isNative(page, here.browser.folder);
      if (unknown) context.skip(unknown);
    });
  });
}
