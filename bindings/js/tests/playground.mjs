// SPDX-License-Identifier: MIT
// Drives the playground in a headless Chromium: controls, keys, divider, address, and a picture whose pixels are those
// of the library without a browser.
//
//   node playground.mjs CHROMIUM FOLDER    FOLDER gets screenshots, and scene.json with the pixels' hash
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { serve } from "./browser.mjs";
import { hashBytes } from "../examples/programs.mjs";
import { describe } from "../playground/scene.js";
import { fromHash, toHash } from "../playground/state.js";
import { setTexture, textureOf } from "../playground/textures.js";
import { Renderer } from "../playground/renderer.js";
import { load } from "../lib/index.js";

const [chromium, folder] = process.argv.slice(2);
const { chromium: browserType } = createRequire(join(folder, "package.json"))("playwright-core");
const FIXED = "shape=torus&texture=checker&a.filter=trilinear&b.filter=ewa&wipe=0.4&azimuth=30&shadow=0";

mkdirSync(folder, { recursive: true });
const server = await serve();
const url = `http://127.0.0.1:${server.address().port}/playground/index.html`;
const browser = await browserType.launch({ executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"] });
const problems = [];

async function open(hash, options = {}) {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options })).newPage();
  page.on("console", (message) => { if (message.type() === "error") problems.push(message.text()); });
  page.on("pageerror", (problem) => problems.push(String(problem)));
  await page.goto(`${url}#${hash}`);
  await settle(page);
  return page;
}

/** Waits until no newer frame comes, and returns the state. */
async function settle(page) {
  await page.waitForFunction(() => window.playground?.frame || window.playground?.error, null, { timeout: 60000 });
  for (let last = -1, now = 0; last !== now;) {
    last = now;
    await page.waitForTimeout(300);
    now = await page.evaluate(() => window.playground.frames);
  }
  return page.evaluate(() => ({ ...window.playground.state, error: window.playground.error }));
}

const pixelsOf = async (page) => Uint8Array.from(await page.evaluate(() => {
  const canvas = document.querySelector("#picture");
  return Array.from(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data);
}));
const hex = (bytes) => hashBytes(bytes).map((word) => word.toString(16).padStart(8, "0")).join("");
const shoot = (page, name) => page.screenshot({ path: join(folder, `${name}.png`) });

async function checkControls() {
  const page = await open("");
  const before = hex(await pixelsOf(page));
  for (const [selector, value, key] of [["#set-b-filter", "nearest", "b.filter"],
      ["#set-b-anisotropy", "4", "b.anisotropy"],
                                        ["#set-texture", "zone", "texture"], ["#set-shape", "sphere", "shape"],
                                        ["#set-model", "gooch", "model"],
                                            ["#set-b-precision", "fast", "b.precision"]]) {
    await page.selectOption(selector, value);
    assert.equal((await settle(page))[key], value);
  }
  await page.fill("#set-b-bias", "1.5");
  await page.fill("#set-sun", "-60");
  await page.uncheck("#set-floor");
  assert.notEqual(hex(await pixelsOf(page)), before);
  const state = await settle(page);
  assert.deepEqual([state["b.bias"], state.sun, state.floor], [1.5, -60, false]);
  const changed = hex(await pixelsOf(page));
  const again = await open(new URL(page.url()).hash.slice(1));  // the address has the state
  assert.equal(hex(await pixelsOf(again)), changed);
  await page.click("#reset");
  await settle(page);
  assert.equal(hex(await pixelsOf(page)), before);
}

async function checkKeysAndDivider() {
  const page = await open("");
  await page.focus("#picture");
  for (const key of ["ArrowLeft", "ArrowUp", "+", "]"]) await page.keyboard.press(key);
  let state = await settle(page);
  assert.deepEqual([state.azimuth, state.elevation, state.distance, state.wipe], [21, 17, 4.7, 0.52]);
  await page.focus("#divider");
  await page.keyboard.press("ArrowLeft");
  assert.equal((await settle(page)).wipe, 0.5);
  const box = await page.locator("#divider").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x - 150, box.y + 210, { steps: 4 });
  await page.mouse.up();
  state = await settle(page);
  assert(state.wipe > 0.2 && state.wipe < 0.4, `${state.wipe}`);
  await page.click("#swap");
  const swapped = await settle(page);
  assert.equal(swapped["a.filter"], state["b.filter"]);
  assert(Math.abs(swapped.wipe - (1 - state.wipe)) < 1e-3);
}

async function checkFootprint() {
  const page = await open("inspect=1&texture=checker");
  const box = await page.locator("#picture").boundingBox();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.4 * box.height);
  await page.waitForFunction(() => /texels read/.test(document.querySelector("#footprint output").value));
  const text = await page.locator("#footprint output").innerText();
  assert.match(text, /B: anisotropic · \d+ texels read/);
  await shoot(page, "footprint");
}

/** Drops a file on the page: a PNG image of `width` x `height` texels, or bytes that are no image. */
async function drop(page, name, width, height, texels) {
  await page.evaluate(async ([fileName, size, bytes]) => {
    let blob = new Blob([Uint8Array.from(bytes)]);
    if (size[0]) {
      const paper = Object.assign(document.createElement("canvas"), { width: size[0], height: size[1] });
      paper.getContext("2d").putImageData(new ImageData(Uint8ClampedArray.from(bytes), ...size), 0, 0);
      blob = await new Promise((resolve) => paper.toBlob(resolve));
    }
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([blob], fileName, { type: blob.type }));
    for (const type of ["dragover", "drop"]) {
      document.querySelector("#picture").dispatchEvent(
        new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, [name, [width, height], [...texels]]);
}

/** The pixels of a state without a browser. */
async function drawHere(state) {
  const renderer = new Renderer(await load(process.env.SHD_WASM));
  renderer.draw(describe(state));
  return renderer.readColor();
}

const message = (page, text) => page.waitForFunction((part) =>
  document.querySelector("#message").textContent.includes(part), text);

async function checkOwnTexture() {
  const page = await open(FIXED);
  const before = hex(await pixelsOf(page));
  for (const [width, height, seed] of [[30, 20, 7919], [64, 64, 104729]]) {
    const texels = Uint8Array.from({ length: width * height * 4 }, (_, i) => (i % 4 === 3 ? 255 : (i * seed) % 251));
    await drop(page, "own.png", width, height, texels);
    await message(page, `own.png: ${width} × ${height} texels`);
    const state = await settle(page);
    assert.equal(state.texture, "own");
    setTexture("own", { width, height, texels });
    assert.equal(hex(await pixelsOf(page)), hex(await drawHere(state)));
  }
  assert.match(page.url(), /^[^#]*#(?!.*texture=own)/);
  await shoot(page, "own");
  await drop(page, "notes.txt", 0, 0, [1, 2, 3]);
  await message(page, "notes.txt is not an image that this browser reads.");
  await page.selectOption("#set-texture", "checker");
  await settle(page);
  assert.equal(hex(await pixelsOf(page)), before);
  await page.selectOption("#set-texture", "own");
  assert.equal((await settle(page)).texture, "own");
  const file = join(folder, "own.png");
  await page.setInputFiles("#own", file);
  await message(page, "own.png: 1280 × 800 texels");
}

/** Dragging the badges selects no text, the links lead to files, and the button changes and keeps the colours. */
async function checkPage(width) {
  const page = await open("", { viewport: { width, height: 844 } });
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert(overflow <= 0, `the page is ${overflow} pixels too wide at ${width}`);
  const badge = await page.locator("#divider .tag.a").boundingBox();
  await page.mouse.move(badge.x + 5, badge.y + 10);
  await page.mouse.down();
  await page.mouse.move(badge.x - 40, badge.y + 90, { steps: 6 });
  await page.mouse.up();
  assert.equal(await page.evaluate(() => getSelection().toString()), "");
  assert(Math.abs((await settle(page)).wipe - 0.5) > 0.02);
  for (const address of await page.locator("nav a").evaluateAll((links) => links.map((link) => link.href))) {
    assert.equal((await fetch(address)).status, 200, address);
  }
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await background();
  await page.click("#theme");
  assert.equal(await page.getAttribute("#theme", "aria-pressed"), "true");
  assert.notEqual(await background(), light);
  const dark = await background();
  await page.reload();
  await settle(page);
  assert.equal(await background(), dark);
  await shoot(page, `page-${width}`);
  await page.click("#theme");
  assert.equal(await background(), light);
}

/** examples/page.html draws the picture that its program draws in Node. */
async function checkExample() {
  const text = readFileSync(new URL("../examples/page.html", import.meta.url), "utf8");
  const [, program] = text.match(/<script type="module">\n(.*?)<\/script>/s);
  const body = program.replace(/import .* from "..\/lib\/index.js";/, "");
  let pixels = null;
  const canvas = { width: 480, height: 360, addEventListener() {},
                   getContext: () => ({ putImageData(image) { pixels = image; } }) };
  const run = Object.getPrototypeOf(async () => {}).constructor("load", "document", "ImageData", body);
  await run(() => load(process.env.SHD_WASM), { querySelector: () => canvas }, function image(data) { return data; });
  const page = await (await browser.newContext()).newPage();
  page.on("pageerror", (problem) => problems.push(String(problem)));
  await page.goto(url.replace("playground/index.html", "examples/page.html"));
  await page.waitForFunction(() => document.querySelector("canvas").getContext("2d").getImageData(0, 0, 1, 1).data[3]);
  await shoot(page, "example");
  const drawn = () => page.evaluate(() => Array.from(document.querySelector("canvas").getContext("2d")
    .getImageData(0, 0, 480, 360).data));
  assert.equal(hex(await drawn()), hex(pixels));
  await page.mouse.move(300, 200);
  await page.mouse.down();
  await page.mouse.move(360, 200, { steps: 3 });
  assert.notEqual(hex(await drawn()), hex(pixels));
}

/** Frames per second of a turning plain scene. */
async function measure(hash) {
  const page = await open(hash);
  await page.click("#spin");
  await page.waitForTimeout(4000);
  const start = await page.evaluate(() => [window.playground.frames, performance.now()]);
  await page.waitForTimeout(3000);
  const end = await page.evaluate(() => [window.playground.frames, performance.now()]);
  const text = await page.locator("#time").innerText();
  await page.context().close();
  return `${((1000 * (end[0] - start[0])) / (end[1] - start[1])).toFixed(1)} frames/s, frame ${text}: ${hash}`;
}

try {
  const fixed = await open(FIXED);
  const state = fromHash(FIXED);
  const scene = describe(state);
  const hash = hex(await pixelsOf(fixed));
  writeFileSync(join(folder, "scene.json"), JSON.stringify({ hash, scene,
      texels: Buffer.from(textureOf(state.texture).texels).toString("base64") }));
  assert.equal(toHash(fromHash(toHash(state))), toHash(state));
  await shoot(fixed, "fixed");
  await shoot(await open("", { colorScheme: "dark" }), "dark");
  await shoot(await open("view=level&compare=0&b.filter=trilinear"), "level");
  await shoot(await open("view=anisotropy&shape=sphere", { colorScheme: "dark" }), "anisotropy");
  await shoot(await open("", { viewport: { width: 390, height: 844 } }), "narrow");
  await checkControls();
  await checkKeysAndDivider();
  await checkFootprint();
  await checkOwnTexture();
  for (const width of [390, 1440]) await checkPage(width);
  await checkExample();
  for (const plain of ["compare=0&shadow=0&model=lambert&b.filter=trilinear", ""]) {
    console.log(await measure(plain));
  }
  assert.deepEqual(problems, []);
  console.log(`pixels ${hash}`);
} finally {
  await browser.close();
  server.close(), server.closeAllConnections();
}
