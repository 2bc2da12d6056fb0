// SPDX-License-Identifier: MIT
// Judges the texture unit behind WebGPU with shd-check: every filter and wrap, with derivatives and with levels.
import { makeImage, makeLookups } from "./lookups.js";
import { shdCheck } from "./shd-check.mjs";
import { MAX_ANISOTROPY, sampleOnDevice } from "./units.js";

const WRAPS = [["repeat", "repeat"], ["clamp", "mirror"]];
const IMAGES = [["rgba8", 64, 32], ["rgba8_srgb", 37, 21]];
const PLANS = [
  { filter: "nearest", withLod: false }, { filter: "bilinear", withLod: false },
  { filter: "nearest-mip", withLod: false }, { filter: "bilinear-mip", withLod: false },
  { filter: "trilinear", withLod: false }, { filter: "trilinear", withLod: true },
  { filter: "anisotropic", withLod: false },
];

/** A .npy file of texels with four channels of a byte. */
function npy(texels, width, height) {
  const header = `{'descr': '|u1', 'fortran_order': False, 'shape': (${height}, ${width}, 4), }`.padEnd(117) + "\n";
  const bytes = new Uint8Array(10 + header.length + texels.length);
  bytes.set([0x93, ..."NUMPY".split("").map((c) => c.charCodeAt(0)), 1, 0, header.length, 0]);
  bytes.set(new TextEncoder().encode(header), 10);
  bytes.set(texels, 10 + header.length);
  return bytes;
}

function csv(columns) {
  const names = Object.keys(columns);
  const row = (_, i) => names.map((name) => columns[name][i]).join();
  return [names.join(), ...Array.from({ length: columns.u.length }, row)].join("\n") + "\n";
}

/** The verdict of shd-check on results: its text, the numbers of its report, and what explains most refusals. */
async function judge(image, { filter, wrap }, lookups, [r, g, b, a]) {
  const files = { "lookups.csv": csv({ ...lookups, r, g, b, a }) };
  image.levels.forEach((texels, i) => {
    files[`${i}.npy`] = npy(texels, Math.max(image.width >> i, 1), Math.max(image.height >> i, 1));
  });
  const levels = image.levels.slice(1).flatMap((_, i) => ["--level", `${i + 1}.npy`]);
  const { code, output, errors, read } = await shdCheck([
    "--rules", "webgpu", "--filter", filter, "--wrap", wrap.join(), "--max-anisotropy", `${MAX_ANISOTROPY}`,
    ...(image.format === "rgba8_srgb" ? ["--srgb"] : []), ...levels, "--diagnose", "--list", "3",
    "--report", "report.json", "0.npy", "lookups.csv"], files);
  if (code > 1) throw new Error(errors);
  const { refused, refusals, diagnosis } = JSON.parse(read("report.json"));
  const excess = Math.max(0, ...["r", "g", "b", "a"].map((c) => Number(refusals[0]?.[`${c}_excess`] ?? 0)));
  return { refused, excess, reason: diagnosis[0], text: output };
}

/**
 * Judges `device` with `count` lookups of each plan. With the name of a fault, the unit has it (units.js). `onVerdict`
 * gets each verdict as soon as it is known.
 */
export async function checkDevice(device, count, fault, onVerdict) {
  const verdicts = [];
  for (const [format, width, height] of IMAGES) {
    const image = makeImage(format, width, height, width);
    for (const wrap of WRAPS) {
      for (const { filter, withLod } of PLANS) {
        const lookups = makeLookups(image, count, withLod, verdicts.length + 1);
        const results = await sampleOnDevice(device, image, { filter, wrap, fault }, lookups);
        const verdict = {
          format, size: `${width}x${height}`, wrap: wrap.join(), filter, by: withLod ? "level" : "derivatives",
          lookups: count, ...await judge(image, { filter, wrap }, lookups, results),
        };
        verdicts.push(verdict);
        await onVerdict(verdict);
      }
    }
  }
  return verdicts;
}
