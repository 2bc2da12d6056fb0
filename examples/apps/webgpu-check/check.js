// SPDX-License-Identifier: MIT
// Judges the texture unit behind WebGPU: every filter and wrap, with derivatives and with levels.
import { Judge, makeImage, makeLookups } from "./judge.js";
import { sampleOnDevice } from "./units.js";

const WRAPS = [["repeat", "repeat"], ["clamp", "mirror"]];
const IMAGES = [["rgba8", 64, 32], ["rgba8_srgb", 37, 21]];
const PLANS = [
  { filter: "nearest", withLod: false }, { filter: "bilinear", withLod: false },
  { filter: "nearest_mip", withLod: false }, { filter: "bilinear_mip", withLod: false },
  { filter: "trilinear", withLod: false }, { filter: "trilinear", withLod: true },
  { filter: "anisotropic", withLod: false },
];

/** The lookups with coordinates half a texel off: a bug, to show that the bounds refuse it. */
function shifted(lookups, image) {
  const move = (column, size) => column.map((x) => x + 0.5 / size);
  return { ...lookups, u: move(lookups.u, image.width), v: move(lookups.v, image.height) };
}

/** The lookup of a refusal, as it would be in a table for shd-check. */
function lookupOf(lookups, row) {
  return Object.fromEntries(Object.entries(lookups).map(([name, column]) => [name, column[row]]));
}

/**
 * Judges `device` with `count` lookups of each plan, by `shd`. `onVerdict` gets each verdict as soon as it is known.
 * A verdict has the refused lookups of the device, of the library itself, which has none, and of the library with a bug.
 */
export async function checkDevice(shd, device, count, onVerdict) {
  const verdicts = [];
  for (const [format, width, height] of IMAGES) {
    const image = makeImage(format, width, height, width);
    for (const wrap of WRAPS) {
      for (const { filter, withLod } of PLANS) {
        const lookups = makeLookups(image, count, withLod, verdicts.length + 1);
        const judge = new Judge(shd, image, { filter, wrap });
        const refusals = judge.refusals(lookups, await sampleOnDevice(device, image, { filter, wrap }, lookups));
        const verdict = {
          format, size: `${width}x${height}`, wrap: wrap.join(","), filter, by: withLod ? "level" : "derivatives",
          lookups: count, refused: refusals.length,
          worst: refusals.slice(0, 3).map((refusal) => ({ ...refusal, lookup: lookupOf(lookups, refusal.row) })),
          library: judge.refusals(lookups, judge.sample(lookups)).length,
          shifted: judge.refusals(lookups, judge.sample(shifted(lookups, image))).length,
        };
        judge.close();
        verdicts.push(verdict);
        await onVerdict(verdict);
      }
    }
  }
  return verdicts;
}
