// SPDX-License-Identifier: MIT
// Drives the figures in a headless Chromium at the widths of a phone and of a desktop: each starts, answers to mouse,
// touch and keys, shows right numbers, and the page with all figures stays light.
//
//   node figures.mjs CHROMIUM FOLDER    FOLDER has playwright-core, and gets screenshots
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { serve } from "./browser.mjs";
import { enums } from "../lib/api.js";

const [chromium, folder] = process.argv.slice(2);
const { chromium: browserType } = createRequire(join(folder, "package.json"))("playwright-core");
const MOST_BYTES = 2.5e6;  // of a page with all figures; pages of the manual have 0.9 MB more, and 4 MB at most
const VIEWS = [
  { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, colorScheme: "light" },
  { viewport: { width: 1440, height: 900 }, deviceScaleFactor: 1, colorScheme: "dark" },
];
const near = (a, b, tolerance = 2e-3) => assert(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

const server = await serve();
const url = `http://127.0.0.1:${server.address().port}/figures/index.html`;
const browser = await browserType.launch({ executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"] });
const problems = [];

/** One figure of a page. */
class Figure {
  constructor(page, name) {
    Object.assign(this, { page, name, element: page.locator(`shd-figure[name="${name}"]`) });
  }
  async start() {
    await this.element.scrollIntoViewIfNeeded();
    await this.page.waitForFunction((name) =>
      document.querySelector(`shd-figure[name="${name}"]`).dataset.ready !== undefined, this.name, { timeout: 60000 });
    return this;
  }
  /** Changes settings, waits until the figure rests, and returns its text, its values and a hash of its pixels. */
  set(changes = {}) {
    return this.element.evaluate(async (figure, state) => {
      figure.set(state);
      const frame = () => new Promise(requestAnimationFrame);
      await frame(), await frame();
      const text = figure.shadowRoot.querySelector("#text");
      while (text.value.includes("…")) await new Promise((resume) => setTimeout(resume, 50));
      const canvas = figure.shadowRoot.querySelector("canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let hash = 0;
      for (const byte of data) hash = (Math.imul(hash, 31) + byte) | 0;
      return { text: text.value, isProblem: text.classList.contains("problem"), values: figure.values, hash };
    }, changes);
  }
  handle(index) {
    return this.element.locator("button.handle").nth(index);
  }
  async placeOf(index) {
    const box = await this.handle(index).boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  }
  async drag(index, dx, dy, isTouch) {
    await this.handle(index).scrollIntoViewIfNeeded();
    const [x, y] = await this.placeOf(index);
    if (isTouch) return this.#dragByTouch(x, y, dx, dy);
    await this.page.mouse.move(x, y);
    await this.page.mouse.down();
    await this.page.mouse.move(x + dx, y + dy, { steps: 4 });
    return this.page.mouse.up();
  }
  async #dragByTouch(x, y, dx, dy) {
    const session = await this.page.context().newCDPSession(this.page);
    const send = (type, ...touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
    await send("touchStart", { x, y });
    for (let i = 1; i <= 4; ++i) await send("touchMove", { x: x + (i * dx) / 4, y: y + (i * dy) / 4 });
    await send("touchEnd");
    await session.detach();
  }
}

/** What the values of each figure must be. `set` changes settings. */
const CHECKS = {
  async barycentric(set) {
    for (const shape of ["triangle", "quadrilateral"]) {
      const { values: { weights, sum, mean, point } } = await set({ shape });
      assert.equal(weights.length, shape === "triangle" ? 3 : 4);
      near(sum, 1, 1e-5), near(mean[0], point[0], 1e-5), near(mean[1], point[1], 1e-5);
    }
  },
  async texels(set) {
    const counts = { nearest: 1, bilinear: 4, hermite: 4, bicubic: 16 };
    for (const filter of Object.keys(counts).filter((name) => name in enums.filter)) {
      const { values: { sum, taps, fraction: [s, t] } } = await set({ filter });
      near(sum, 1, 1e-5);
      assert(taps.length <= counts[filter], `${filter}: ${taps.length} texels`);
      if (filter !== "bilinear") continue;
      const weights = taps.map(([, , weight]) => weight).sort((a, b) => a - b);
      const expected = [(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t].sort((a, b) => a - b);
      expected.slice(4 - weights.length).forEach((weight, i) => near(weights[i], weight, 1e-4));
    }
  },
  async footprint(set) {
    const { values: { lx, ly, detail, lod } } = await set({ filter: "trilinear" });
    near(detail, Math.log2(Math.max(lx, ly)), 1e-6), near(lod, detail, 5e-3);
    for (const filter of ["nearest", "bilinear", "nearest_mip", "bilinear_mip", "nearest_mip_linear", "trilinear",
                          "ripmap", "summed_area", "anisotropic", "ewa", "exact"]) {
      for (const level of ["longer vector", "least error"]) {
        const { values: { sum, tapCount }, text, isProblem } = await set({ filter, level });
        assert(!isProblem && tapCount > 0, text), near(sum, 1, 1e-3);
      }
    }
  },
  async mipmap(set) {
    const errors = [];
    for (let method = 0; method < 8; ++method) errors.push((await set({ method, texture: "checker" })).values.error);
    const [one, two, four, , , anisotropic, ewa, exact] = errors;
    assert(one > two && two > four && one > anisotropic && one > ewa && exact === 0, errors.join());
    await set({ method: 0 });
  },
  async "blinn-phong"(set) {
    for (const state of [{}, { p: 100, ks: 1 }, { specular: false }, { diffuse: false },
                         { diffuse: true, specular: true }]) {
      const { values: { sum, pixel } } = await set(state);
      near(pixel, sum, 0.01);
    }
  },
  async bump(set) {
    for (const shape of ["sphere", "plane"]) {
      for (const pattern of ["rings", "waves", "tiles"]) assert((await set({ shape, pattern })).values.steepest > 0.1);
    }
    near((await set({ amplitude: 0 })).values.steepest, 0, 0);
    await set({ amplitude: 0.1 });
  },
  async noise(set) {
    const found = new Set();
    for (const kind of ["value", "perlin", "simplex", "marble", "wood"]) {
      for (const fade of Object.keys(enums.solid_fade)) {
        const { values, text, isProblem, hash } = await set({ kind, fade, octaves: 3 });
        assert(!isProblem && Math.abs(values.value) <= 1, text);
        if (fade === "quintic") found.add(hash);
      }
    }
    assert.equal(found.size, 5);
    const fbm = await set({ kind: "perlin", sum: "fbm", fade: "quintic" });
    const turbulence = await set({ sum: "turbulence" });
    assert(turbulence.values.value >= 0 && turbulence.hash !== fbm.hash);
  },
  async shadow(set) {
    for (const filter of ["hard", "pcf", "pcss", "variance"]) {
      const { values: { visibility } } = await set({ filter });
      assert(visibility >= 0 && visibility <= 1, `${visibility}`);
      if (filter === "hard") assert(visibility === 0 || visibility === 1, `${visibility}`);
    }
  },
  async perspective(set) {
    const parts = await set({ segments: 8 });
    const { values: { near: front, far, share, affine } } = await set({ segments: 1 });
    near(share, front / (front + far), 1e-6), near(affine, 0.5, 1e-6);
    assert(Math.abs(parts.values.affine - share) < 0.2 * Math.abs(affine - share), parts.text);
  },
};
const NAMES = Object.keys(CHECKS).filter((name) => name !== "perspective" || "affine" in enums.draw_flag);

/** Pixels and text follow a handle that mouse or touch drags and keys move. */
async function checkHandles(figure, isTouch) {
  const first = await figure.set();
  assert(!first.isProblem, first.text);
  await figure.drag(0, isTouch ? 24 : 30, 18, isTouch);
  const dragged = await figure.set();
  assert(dragged.hash !== first.hash && dragged.text !== first.text, `${figure.name}: a drag changes nothing`);
  await figure.handle(0).focus();
  const before = await figure.placeOf(0);
  for (const key of ["ArrowLeft", "Shift+ArrowLeft", "ArrowUp"]) await figure.page.keyboard.press(key);
  const moved = await figure.set();
  assert(moved.hash !== dragged.hash && moved.text !== dragged.text, `${figure.name}: keys change nothing`);
  const [x, y] = await figure.placeOf(0);
  const by = [x - before[0], y - before[1]];
  assert(by[0] < -4 && by[1] < 1, `${figure.name}: the handle moved by ${by}`);
}

/** Names for programs that read the page aloud, and a canvas with the pixels of the screen. */
async function checkElements(figure, { viewport: { width }, deviceScaleFactor }) {
  const found = await figure.element.evaluate((host) => {
    const canvas = host.shadowRoot.querySelector("canvas");
    const unnamed = [...host.shadowRoot.querySelectorAll("select, input")].filter(({ labels }) => !labels.length);
    return { unnamed: unnamed.length, scale: canvas.width / canvas.clientWidth, label: canvas.ariaLabel,
             handles: [...host.shadowRoot.querySelectorAll(".handle")].map(({ ariaLabel }) => ariaLabel),
             text: host.textContent, excess: document.documentElement.scrollWidth - innerWidth };
  });
  near(found.scale, deviceScaleFactor, 0.02);
  assert(found.label && found.handles.length && found.handles.every(Boolean), JSON.stringify(found));
  assert.equal(found.unnamed, 0);
  assert(found.excess <= 0, `${figure.name}: the page is ${found.excess} pixels too wide at ${width}`);
}

/** Dark and light pages have other pixels around the figure. */
async function checkTheme(page, figure) {
  const before = await figure.set();
  await page.emulateMedia({ colorScheme: "light" });
  const light = await figure.set();
  await page.emulateMedia({ colorScheme: "dark" });
  const dark = await figure.set();
  assert(light.hash !== dark.hash && [light.hash, dark.hash].includes(before.hash), "the theme changes nothing");
}

async function checkView(view) {
  const page = await (await browser.newContext(view)).newPage();
  page.on("console", (message) => { if (message.type() === "error") problems.push(message.text()); });
  page.on("pageerror", (problem) => problems.push(String(problem)));
  await page.addInitScript(() => {
    addEventListener("ready", ({ target }) => { (window.started ??= []).push(target.getAttribute("name")); });
  });
  const responses = [];
  page.on("response", (response) => responses.push(response));
  await page.goto(url);
  for (const name of NAMES) {
    const figure = await new Figure(page, name).start();
    await checkElements(figure, view);
    await CHECKS[name]((changes) => figure.set(changes));
    await checkHandles(figure, view.hasTouch);
    await figure.element.screenshot({ path: join(folder, `${name}-${view.viewport.width}.png`) });
  }
  await checkTheme(page, new Figure(page, "barycentric"));
  const started = await page.evaluate(() => window.started);
  assert.equal(started[0], NAMES[0]);
  assert.deepEqual([...started].sort(), [...NAMES].sort());
  assert.equal(responses.filter((response) => response.url().endsWith(".wasm")).length, 1);
  const sizes = await Promise.all(responses.map(async (response) => (await response.body()).length));
  const bytes = sizes.reduce((sum, size) => sum + size, 0);
  assert(bytes > 1e6 && bytes <= MOST_BYTES, `the page loads ${bytes} bytes`);
  console.log(`${view.viewport.width} pixels: ${NAMES.length} figures, ${bytes} bytes`);
}

/** A page without the module keeps its texts. */
async function checkAbsent() {
  const page = await (await browser.newContext()).newPage();
  await page.route("**/*.wasm", (route) => route.abort());
  await page.addInitScript(() => addEventListener("problem", () => { window.isRefused = true; }, true));
  await page.goto(url);
  await page.waitForFunction(() => window.isRefused, null, { timeout: 60000 });
  assert.equal(await page.locator("shd-figure").first().innerText(), "This figure needs JavaScript.");
}

const files = readdirSync(new URL("../figures", import.meta.url));
for (const name of Object.keys(CHECKS)) assert(files.includes(`${name}.js`), name);
try {
  for (const view of VIEWS) await checkView(view);
  await checkAbsent();
  assert.deepEqual(problems, []);
} finally {
  await browser.close();
  server.close(), server.closeAllConnections();
}
