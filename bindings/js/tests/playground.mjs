// SPDX-License-Identifier: MIT
// Drives the playground in a headless Chromium: controls, keys, divider, address, and a picture whose pixels are those
// of the library without a browser.
//
//   node playground.mjs CHROMIUM FOLDER    FOLDER gets screenshots, and scene.json with the pixels' hash
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { serve } from "./browser.mjs";
import { hashBytes } from "../examples/programs.mjs";
import { describe } from "../playground/scene.js";
import { fromHash, toHash } from "../playground/state.js";
import { makeTexels } from "../playground/textures.js";

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
      texels: Buffer.from(makeTexels(state.texture)).toString("base64") }));
  assert.equal(toHash(fromHash(toHash(state))), toHash(state));
  await shoot(fixed, "fixed");
  await shoot(await open("", { colorScheme: "dark" }), "dark");
  await shoot(await open("view=level&compare=0&b.filter=trilinear"), "level");
  await shoot(await open("view=anisotropy&shape=sphere", { colorScheme: "dark" }), "anisotropy");
  await shoot(await open("", { viewport: { width: 390, height: 844 } }), "narrow");
  await checkControls();
  await checkKeysAndDivider();
  await checkFootprint();
  for (const plain of ["compare=0&shadow=0&model=lambert&b.filter=trilinear", ""]) {
    console.log(await measure(plain));
  }
  assert.deepEqual(problems, []);
  console.log(`pixels ${hash}`);
} finally {
  await browser.close();
  server.close(), server.closeAllConnections();
}
