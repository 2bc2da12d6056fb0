// SPDX-License-Identifier: MIT
// Ties the state to the controls, the workers and the address of the page.
import { addOption, buildControls } from "./controls.js";
import { hideFootprint, showFootprint } from "./footprint.js";
import { processors } from "../lib/instance.js";
import { showLegend } from "./legend.js";
import { Pool } from "../lib/pool.js";
import { openTexture } from "./own_texture.js";
import { Stage } from "./stage.js";
import { fromHash, SETTINGS, toHash } from "./state.js";
import { setTexture } from "./textures.js";

const find = (selector) => document.querySelector(selector);
const pool = new Pool(() => new Worker(new URL("./worker.js", import.meta.url), { type: "module" }),
                      { count: Math.min(4, processors()) });
const page = { state: fromHash(location.hash), frame: null, isSpinning: false, frames: 0, error: null };
let isDrawing = false;
let isStale = true;
let pointer = null;
let times = [];
let addressTimer = 0;
let movedAt = -Infinity;
let fullTime = 0;

const WARM_FRAMES = 8;  // the browser compiles code better while it runs
const SLOW = 45;        // [ms] frames that take longer are drawn with half the size while the model moves
const REST = 250;       // [ms] without a change, until the frame is drawn in full

const showControls = buildControls(change);
const stage = new Stage(change, (pixel) => { pointer = pixel; inspect(); });

function change(key, value) {
  if (page.state[key] === value) return;
  page.state = { ...page.state, [key]: value };
  movedAt = performance.now();
  show();
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => history.replaceState(null, "", `#${toHash(page.state)}`), 150);
}

function show() {
  showControls(page.state);
  stage.show(page.state);
  showLegend(page.state.view);
  hideFootprint(!page.state.inspect);
  draw();
}

const half = (size) => size.split("x").map((v) => v / 2).join("x");

/** The state, with half the size during a movement if frames are slow. */
function stateToDraw() {
  const isMoving = performance.now() - movedAt < REST && !page.isSpinning;
  if (!isMoving || fullTime < SLOW) return page.state;
  setTimeout(draw, REST);
  return { ...page.state, size: half(page.state.size) };
}

/** The frame of a state: bands of pixels, and the milliseconds of the slowest band. */
async function drawFrame(state) {
  const bands = await pool.bands(Number(state.size.split("x")[1]), "draw", state);
  const values = bands.map(({ value }) => value);
  return { bands, size: state.size, milliseconds: Math.max(...values.map(({ milliseconds }) => milliseconds)),
           fragments: values.reduce((sum, { fragments }) => sum + fragments, 0) };
}

/** Draws the state; changes during a frame are drawn together after it. */
async function draw() {
  isStale = true;
  if (isDrawing) return;
  isDrawing = true;
  while (isStale) {
    isStale = false;
    try {
      const state = stateToDraw();
      page.frame = await drawFrame(state);
      if (state.size === page.state.size) fullTime = page.frame.milliseconds;
      stage.put(page.frame);
      report(page.frame);
      inspect();
    } catch (problem) {
      page.error = problem.message;
      find("#problem").textContent = problem.message;
      find("#problem").hidden = false;
      break;
    }
    await new Promise(requestAnimationFrame);
    if (page.frames < WARM_FRAMES) isStale = true;
    if (page.isSpinning) turn();
  }
  isDrawing = false;
}

function turn() {
  const azimuth = page.state.azimuth + 0.8;
  change("azimuth", Number((azimuth > 180 ? azimuth - 360 : azimuth).toFixed(1)));
}

function report({ milliseconds, fragments, size }) {
  const now = performance.now();
  page.frames += 1;
  times = [...times.filter(([time]) => now - time < 1000).slice(page.isSpinning ? 0 : -3), [now, milliseconds]];
  const mean = times.reduce((sum, [, value]) => sum + value, 0) / times.length;
  find("#time").value = `${mean.toFixed(1)} ms`;
  find("#rate").value = page.isSpinning && times.length > 1
    ? `${(((times.length - 1) * 1000) / (now - times[0][0])).toFixed(0)} frames/s`
        : `≈ ${(1000 / mean).toFixed(0)} frames/s`;
  find("#fragments").value = `${(fragments / 1000).toFixed(0)} k fragments`;
  find("#workers").value = `${size.replace("x", " × ")}, ${pool.count} ${pool.count === 1 ? "worker" : "workers"}`;
}

let isAsking = false;
async function inspect() {
  if (!page.state.inspect || !page.frame || isAsking) return;
  if (!pointer) return showFootprint(null);
  isAsking = true;
  const asked = pointer;
  const band = page.frame.bands.findLastIndex(({ rows: [first] }) => first <= asked.y);
  showFootprint(await pool.callOn(band, "footprint", asked.x, asked.y).catch(() => null), page.state.texture);
  isAsking = false;
  if (pointer !== asked) inspect();
}

find("#spin").addEventListener("click", (event) => {
  page.isSpinning = !page.isSpinning;
  event.currentTarget.ariaPressed = String(page.isSpinning);
  times = [];
  draw();
});
find("#reset").addEventListener("click", () => { location.hash = ""; });
find("#swap").addEventListener("click", () => {
  const { state } = page;
  const swapped = Object.entries(state).map(([key, value]) => [key.replace(/^[ab]\./,
      (side) => (side === "a." ? "b." : "a.")), value]);
  page.state = { ...state, ...Object.fromEntries(swapped) };
  change("wipe", Number((1 - state.wipe).toFixed(3)));
  show();
});
let messageTimer = 0;
/** Says a sentence below the picture for some seconds. */
function say(text) {
  find("#message").textContent = text;
  clearTimeout(messageTimer);
  messageTimer = setTimeout(() => { find("#message").textContent = ""; }, 6000);
}
find("#link").addEventListener("click", async (event) => {
  const button = event.currentTarget;
  const text = `${location.href.split("#")[0]}#${toHash(page.state)}`;
  const isCopied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
  const own = page.state.texture === "own" ? " Your texture is not a part of it." : "";
  say((isCopied ? "The address is in the clipboard." : text) + own);
  button.focus();
});
find("#save").addEventListener("click", () => find("#picture").toBlob((blob) => {
  const anchor = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: "shd.png" });
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 1000);
}));
openTexture(async (texture) => {
  setTexture("own", texture);
  await pool.all("setTexture", "own", texture);
  if (!SETTINGS.texture.options.includes("own")) addOption("texture", "own");
  if (page.state.texture === "own") draw();
  change("texture", "own");
}, say);
addEventListener("hashchange", () => { page.state = fromHash(location.hash); show(); });
window.playground = page;  // for tests
show();
