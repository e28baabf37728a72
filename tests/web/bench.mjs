// Sizes of the web page, and its times beside the native program's with one thread; called by .ci/web-bench.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { browser, open, serve } from "./browser.mjs";

const folder = process.env.SHADING_LAB_PAGE;
const FRAMES = 31;
const ROUNDS = 3;
/** The native program's vectors, `sse4.2` for those of 128 bits that a page has; none for the machine's best. */
const LEVEL = process.env.SIMD ? ["--simd", process.env.SIMD] : [];
const SCENES = [["sphere", 768, "phong"], ["sphere", 768, "gouraud"], ["shadows", 768, "phong"], ["glass-ball", 512, "phong"]];

let sum = 0;
for (const file of ["index.html", "shading-lab.js", "shading-lab_bg.wasm"]) {
  const bytes = readFileSync(join(folder, file));
  const small = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } }).length;
  sum += small;
  console.log(`${file}: ${bytes.length} bytes, ${small} with brotli`);
}
console.log(`first picture: ${(sum / 1e6).toFixed(2)} MB with brotli`);

const median = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1];
const server = await serve(folder);
const chromium = await browser();
const opened = performance.now();
const { page } = await open(chromium.context, server.url);
console.log(`open: ${Math.round(performance.now() - opened)} ms from the address to the first picture`);
console.log("scene | native full | page full | ratio | native light | page light | ratio");
for (const [scene, side, mode] of SCENES) {
  const link = `?scene=${scene}&set=shading.mode=${mode}`;
  const times = { native: [], page: [] };
  for (let round = 0; round < ROUNDS; round += 1) {
    const words = ["bench", link, "--threads", "1", "--size", `${side}x${side}`, "--frames", String(FRAMES), ...LEVEL, "--json"];
    times.native.push(JSON.parse(execFileSync(process.env.SHADING_LAB, words, { encoding: "utf8" })));
    const parameters = [link, side, FRAMES];
    times.page.push(JSON.parse(await page.evaluate(([link, side, frames]) => window.shadingLab.bench(link, side, side, frames), parameters)));
  }
  const figure = (get) => [times.native, times.page].map((runs) => median(runs.map(get)));
  const row = [figure((run) => run.full.median_ms), figure((run) => run.changes.light.median_ms)];
  const cells = row.flatMap(([a, b]) => [a.toFixed(2), b.toFixed(2), (b / a).toFixed(2)]);
  console.log(`${scene} ${mode} ${side}² | ${cells.join(" | ")}`);
}
await chromium.close();
server.close();
