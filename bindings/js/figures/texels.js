// SPDX-License-Identifier: MIT
// The texels of a lookup in a magnified texture, with their weights (shd/explain.h).
import { Cache } from "../playground/cache.js";
import { enums } from "../lib/api.js";
import { bytesOf, cssOf, Pixels } from "./picture.js";
import { grid, line, number, point, shares } from "./paint.js";

const SIZE = 8;
const FINE = 160;  // lookups across and down of the filtered picture
const FILTERS = ["nearest", "bilinear", "hermite", "bicubic"].filter((name) => name in enums.filter);
const CUBICS = ["catmull_rom", "b_spline", "mitchell"];

/** A picture of few texels: a disc on stripes. */
function makeTexels() {
  const texels = new Uint8Array(4 * SIZE * SIZE);
  for (let y = 0; y < SIZE; ++y) {
    for (let x = 0; x < SIZE; ++x) {
      const isDisc = Math.hypot(x - 3.2, y - 3.6) < 2.4;
      const ground = (x + 2 * y) % 5 < 2 ? [38, 70 + 10 * x, 120] : [226, 222, 205 - 9 * y];
      texels.set([...(isDisc ? [225, 90 + 14 * y, 60] : ground), 255], 4 * (y * SIZE + x));
    }
  }
  return texels;
}

export function make({ shd, context }) {
  const texels = makeTexels();
  const texture = new shd.Texture(context, { format: "rgba8_srgb", width: SIZE, height: SIZE, texels });
  const cache = new Cache();
  const raw = new Pixels(SIZE, SIZE).put(new Uint8ClampedArray(texels)), fine = new Pixels(FINE, FINE);
  const across = Float32Array.from({ length: FINE * FINE }, (_, i) => ((i % FINE) + 0.5) / FINE);
  const down = across.map((_, i) => (Math.floor(i / FINE) + 0.5) / FINE);
  let p = [0.41, 0.36];
  let last = { size: 1, left: 0, colour: "#fff" };

  /** Below: the place between the texels' centres. */
  function textOf({ taps, result }) {
    const place = p.map((v) => v * SIZE - 0.5), [i, j] = place.map(Math.floor);
    const fraction = place.map((v) => v - Math.floor(v));
    const sum = taps.reduce((total, { weight }) => total + weight, 0);
    const texel = (axis, k) => `${"uv"[axis]} = ${number(p[axis], 3)} → ${"xy"[axis]} = ${SIZE} ${"uv"[axis]} − ½ `
      + `= ${number(place[axis])}: texel ${k}, ${"st"[axis]} = ${number(fraction[axis])}`;
    const total = `${taps.length} texels with weights in %, sum ${number(100 * sum, 1)}`;
    return { sum, fraction, text: `${texel(0, i)}\n${texel(1, j)}\n${total}; result, linear: `
      + point(result.slice(0, 3), 3) };
  }

  return {
    label: "Texels of a lookup: drag the point",
    settings: {
      filter: { label: "Filter", options: FILTERS, value: "bilinear" },
      cubic: { label: "Kernel of bicubic", options: CUBICS, value: "catmull_rom" },
      show: { label: "Show", options: ["texels", "filtered"], value: "texels" },
    },
    heightOf: (width) => Math.min(width, 420),
    handles: () => [{
      label: "Lookup", at: [last.left + p[0] * last.size, p[1] * last.size], fill: last.colour,
      move: (x, y) => { p = [x - last.left, y].map((v) => Math.min(Math.max(v / last.size, 0), 1)); },
    }],
    draw(target, { width, height }, { filter, cubic, show }) {
      const area = { x: (width - height) / 2, y: 0, width: height, height };
      const desc = { filter, cubic, wrapU: "clamp", wrapV: "clamp" };
      const sampler = cache.get("sampler", desc, () => new shd.Sampler(context, desc));
      const explanation = texture.explain(sampler, { u: [p[0]], v: [p[1]] });
      if (show === "texels") raw.draw(target, area, false);
      else fine.put(bytesOf(texture.sample(sampler, { u: across, v: down }).channel)).draw(target, area);
      grid(target, area, SIZE, SIZE, "rgb(128 128 128 / 60%)");
      const found = new Map();  // at the edges, texels are read several times
      for (const { x, y, weight } of explanation.taps) found.set(`${x},${y}`, (found.get(`${x},${y}`) ?? 0) + weight);
      const list = [...found].map(([key, weight]) => [...key.split(",").map(Number), weight]);
      shares(target, area, SIZE, SIZE, list);
      const place = [area.x + p[0] * height, p[1] * height];
      for (const [i, j] of list) {
        line(target, place, [area.x + ((i + 0.5) * height) / SIZE, ((j + 0.5) * height) / SIZE], "rgb(0 0 0 / 35%)", 1);
      }
      cache.sweep();
      last = { size: height, left: area.x, colour: cssOf(explanation.result) };
      const { sum, fraction, text } = textOf(explanation);
      return { text, values: { sum, fraction, result: explanation.result, taps: list, point: [...p] } };
    },
  };
}
