// SPDX-License-Identifier: MIT
// Runs the programs of README.md in a headless Chromium, and compares their pictures with those of Node:
// node readme_pages.mjs CHROMIUM FOLDER. FOLDER has playwright-core and three in node_modules.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { serve } from "./browser.mjs";
import { makeModel, MODEL } from "./model.mjs";
import { programsOf } from "./readme.mjs";
import { hashBytes } from "../examples/programs.mjs";
import { load } from "../lib/index.js";

const [chromium, folder] = process.argv.slice(2);
const { chromium: browserType } = createRequire(join(folder, "package.json"))("playwright-core");
const programs = programsOf(readFileSync(new URL("../README.md", import.meta.url), "utf8"));
const find = (text) => programs.find((program) => program.includes(text)) ?? assert.fail(`no program with ${text}`);

/** A hash of the alphas and of the colours of opaque pixels: a canvas rounds the others. */
function hashOf(pixels) {
  const rounded = pixels.map((byte, i) => (i % 4 === 3 || pixels[i | 3] === 255 ? byte : 0));
  return hashBytes(rounded).map((word) => word.toString(16).padStart(8, "0")).join("");
}

/** What a program of README leaves to its reader, as text: columns, texels and a canvas. */
const GIVEN = `
const texels = Uint8Array.from({ length: 64 * 64 * 4 }, (_, i) => (i * 7919) % 251);
const [u, v, dudx, dvdx, dudy, dvdy] = [0.1, 0.2, 0.03, 0, 0, 0.04].map((x) => Float32Array.of(x, x + 0.5));
`;

/** Runs a program in Node. Returns what it puts on its canvas. */
async function runHere(program, globals) {
  const body = GIVEN + program.replace(/^import .*;$/gm, "");
  let pixels = [];
  const target = { putImageData: (image) => { pixels = image; } };
  class ImageData { constructor(data) { return data; } }  // eslint-disable-line no-constructor-return
  const given = { target, ImageData, load: () => load(process.env.SHD_WASM), ...globals };
  await Object.getPrototypeOf(async () => {}).constructor(...Object.keys(given), body)(...Object.values(given));
  return Uint8Array.from(pixels);
}

const IMPORTS = {
  shd: "/lib/index.js", "shd/pool": "/lib/pool.js", "shd/threads": "/lib/threads.js",
  three: "/node_modules/three/build/three.module.js", "three/addons/": "/node_modules/three/examples/jsm/",
};
const pages = new Map([
  ["/model.glb", makeModel()],
  // Import maps are not for workers.
  ["/worker.js", find("serve(").replace('"shd/pool"', '"/lib/pool.js"')],
]);
const pageOf = (program) => `<!doctype html><link rel="icon" href="data:,"><canvas width="640" height="480"></canvas>
<script type="importmap">${JSON.stringify({ imports: IMPORTS })}</script>
<script type="module">
const target = document.querySelector("canvas").getContext("2d");
${GIVEN}${program}
globalThis.end = typeof shd === "undefined" ? {} : { threadCount: shd.threadCount };
</script>`;

const server = await serve(undefined, (path) => pages.get(path)
  ?? (path.startsWith("/node_modules/") ? readFileSync(join(folder, path)) : undefined));
const browser = await browserType.launch({ executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"] });

/** Runs a program in a page. Returns its pixels and what it left. */
async function runThere(program, name) {
  pages.set(`/${name}.html`, pageOf(program));
  const page = await browser.newPage();
  const problems = [];
  page.on("pageerror", (problem) => problems.push(String(problem)));
  page.on("console", (message) => { if (message.type() === "error") problems.push(message.text()); });
  await page.goto(`http://127.0.0.1:${server.address().port}/${name}.html`);
  await page.waitForFunction(() => globalThis.end, null, { timeout: 60000 })
    .catch(() => assert.fail(problems.join("\n")));
  const left = await page.evaluate(() => ({ ...globalThis.end,
    pixels: Array.from(document.querySelector("canvas").getContext("2d").getImageData(0, 0, 640, 480).data) }));
  await page.screenshot({ path: join(folder, `${name}.png`) });
  assert.deepEqual(problems, []);
  return { ...left, pixels: Uint8Array.from(left.pixels) };
}

/** The model of makeModel() drawn from its arrays. */
async function drawModel() {
  const program = find("GLTFLoader");
  const attribute = (array, itemSize) => ({ count: array.length / itemSize, itemSize,
                                            getComponent: (i, k) => array[i * itemSize + k] });
  class Mesh {
    geometry = { attributes: { position: attribute(MODEL.position, 3), normal: attribute(MODEL.normal, 3),
                               uv: attribute(MODEL.uv, 2) }, index: { array: MODEL.indices } };
    material = { color: { toArray: () => MODEL.color }, map: { image: MODEL }, roughness: MODEL.roughness,
                 metalness: 0 };
    matrixWorld = { elements: MODEL.matrix };
  }
  const scene = { updateMatrixWorld() {}, traverse: (run) => run(new Mesh()) };
  class GLTFLoader { loadAsync() { return { scene }; } }
  class OffscreenCanvas {
    getContext = () => ({ drawImage() {}, getImageData: () => ({ data: MODEL.texels }) });
  }
  return runHere(program, { GLTFLoader, Mesh, OffscreenCanvas });
}

/** The picture of the worker's program, drawn by one thread. */
async function drawWhole() {
  let start;
  await runHere(find("serve("), { serve: (given) => { start = given; } });
  return Uint8Array.from(start(await load(process.env.SHD_WASM)).draw([0, 480], 0.5));
}

/** Pages of programs that draw, by name: a text in the program, and the picture of Node. */
const drawn = [["first", "texture.sample(", () => runHere(find("texture.sample("))], ["three", "GLTFLoader", drawModel],
               ["pool", "new Pool(", drawWhole]];
if (readFileSync(process.env.SHD_WASM).includes("shd_scene_load_memory")) {
  const fetch = async () => ({ arrayBuffer: () => makeModel() });
  drawn.push(["scene", "new shd.Scene(", () => runHere(find("new shd.Scene("), { fetch })]);
} else {
  console.log("the program with shd.Scene was not run: the module reads no files");
}

try {
  const colours = (pixels) => new Set(new Uint32Array(pixels.buffer)).size;
  for (const [name, text, draw] of drawn) {
    const { pixels } = await runThere(find(text), name);
    assert(colours(pixels) > 50, `${name}: ${colours(pixels)} colours`);
    assert.equal(hashOf(pixels), hashOf(await draw()), name);
  }
  assert.equal((await runThere(find('"shd/threads"'), "threads")).threadCount, 4);
  console.log(`${programs.length} programs of README.md run`);
} finally {
  await browser.close();
  server.close(), server.closeAllConnections();
}
