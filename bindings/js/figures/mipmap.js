// SPDX-License-Identifier: MIT
// A plane in perspective, from point sampling to the exact mean of each pixel, and the spectrum of its near half.
import { Cache } from "../playground/cache.js";
import { textureOf } from "../playground/textures.js";
import { bytesOf, encode, Pixels } from "./picture.js";
import { label, number, panels } from "./paint.js";
import { spectrum } from "./spectrum.js";

const WIDTH = 256, HEIGHT = 192, SPECTRUM = 128;
/** Points across a pixel, and the filter of each. */
const METHODS = [
  ["one point", 1, "nearest"], ["2 × 2 points", 2, "nearest"], ["4 × 4 points", 4, "nearest"],
  ["nearest mip level", 1, "nearest_mip"], ["trilinear", 1, "trilinear"], ["anisotropic", 1, "anisotropic"],
  ["EWA", 1, "ewa"], ["exact", 1, "exact"],
];
const REPEAT = 14;

export function make({ shd, context }) {
  const cache = new Cache();
  const picture = new Pixels(WIDTH, HEIGHT), frequencies = new Pixels(SPECTRUM, SPECTRUM);
  const mesh = shd.Mesh.shape(context, { kind: "plane", size: [40, 1, 40] });
  let turn = 0.12, height = 1.1;
  let exact = { key: "", columns: null };
  let places = null;

  /** The plane with a filter, as columns r, g and b; `points` across a pixel are averaged. */
  function columnsOf(name, filter, points) {
    const { width, height: rows, texels } = textureOf(name);
    const texture = cache.get("texture", name, () => new shd.Texture(context, {
      format: "rgba8_srgb", width, height: rows, texels, tables: "mipmap" }));
    const sampler = cache.get("sampler", filter, () => new shd.Sampler(context, { filter, tolerance: 0.125 }));
    const material = cache.get("material", [name, filter], () => new shd.Material(context, {
      model: "unlit", diffuse: [1, 1, 1],
      slots: [{ target: "diffuse", texture, sampler, uvTransform: [REPEAT, 0, 0, 0, REPEAT, 0] }] }));
    const size = { width: WIDTH * points, height: HEIGHT * points, colorFormat: "rgba32f" };
    const framebuffer = cache.get("framebuffer", size, () => new shd.Framebuffer(context, size));
    const camera = { eye: [0, height, 0], target: [Math.sin(turn), height - 0.3, -Math.cos(turn)], fovY: 0.9 };
    shd.render(context, { framebuffer, draws: [{ mesh, material }], camera, clearColor: [0.35, 0.5, 0.7, 1] });
    return meansOf(framebuffer.readColor("rgba32f"), points);
  }

  /** The exact mean of each pixel, if it is known or may take its time; else null. */
  function exactOf(name, isResting) {
    const key = JSON.stringify([turn, height, name]);
    if (exact.key !== key && !isResting) return null;
    if (exact.key !== key) exact = { key, columns: columnsOf(name, "exact", 1) };
    return exact.columns;
  }

  return {
    label: "A plane in perspective and its spectrum: drag the view and choose a filter",
    settings: {
      method: { label: "Method", min: 0, max: METHODS.length - 1, step: 1, value: 0,
                names: METHODS.map(([name]) => name) },
      texture: { label: "Texture", options: ["checker", "zone", "brick"], value: "checker" },
    },
    heightOf: (width) => layOut(width).height,
    handles({ width }) {
      const [view] = layOut(width).places;
      return [{
        label: "View", at: [view.x + view.width * (0.5 - turn / 0.8), view.y + (view.height * height) / 3],
        move(x, y) {
          turn = Math.min(Math.max(0.8 * (0.5 - (x - view.x) / view.width), -0.4), 0.4);
          height = Math.min(Math.max((3 * (y - view.y)) / view.height, 0.2), 3);
        },
      }];
    },
    draw(target, { width, ink, isResting }, { method, texture }) {
      const [name, points, filter] = METHODS[method];
      ({ places } = layOut(width));
      const means = exactOf(texture, isResting);
      // The exact mean is slow: until the view rests, EWA stands for it.
      const columns = filter !== "exact" ? columnsOf(texture, filter, points) : means ?? columnsOf(texture, "ewa", 1);
      picture.put(bytesOf(columns)).draw(target, places[0], false);
      const { bytes, high } = spectrum(middle(columns), SPECTRUM);
      frequencies.put(bytes).draw(target, places[1]);
      [name, "spectrum of the square below the horizon"].forEach((title, i) =>
        label(target, title, [places[i].x, places[i].y - 11], { align: "left", colour: ink, halo: null, size: 13 - i }));
      cache.sweep();
      const error = means ? errorOf(columns, means) : null;
      return {
        isRough: !means, values: { error, high },
        text: `${name}: error against the exact mean ${means ? number(error, 4) : "…"} `
          + `(root of the mean square, linear)\n${number(100 * high, 2)} % of the spectrum's power lies above half of `
          + "the highest frequency",
      };
    },
  };
}

const layOut = (width) => {
  const top = 22, gap = 12;
  if (width < 560) {
    const rest = panels(width, 2, { aspect: WIDTH / HEIGHT, least: width, top });
    rest.places[1].x += (rest.places[1].width - rest.places[1].height) / 2;
    rest.places[1].width = rest.places[1].height;
    return rest;
  }
  const height = Math.min(330, (width - gap) / (1 + WIDTH / HEIGHT));
  const wide = (height * WIDTH) / HEIGHT, left = (width - gap - wide - height) / 2;
  return { places: [{ x: left, y: top, width: wide, height }, { x: left + wide + gap, y: top, width: height, height }],
           height: height + top };
};

/** The root of the mean square of the differences of columns. */
function errorOf(columns, others) {
  let sum = 0;
  columns.forEach((column, c) => column.forEach((v, i) => { sum += (v - others[c][i]) ** 2; }));
  return Math.sqrt(sum / (3 * columns[0].length));
}

/** Means of points x points pixels, as columns. */
function meansOf(rgba, points) {
  const columns = [0, 1, 2].map(() => new Float32Array(WIDTH * HEIGHT));
  const share = 1 / points ** 2, width = WIDTH * points;
  for (let i = 0; i < rgba.length / 4; ++i) {
    const at = Math.floor(i / width / points) * WIDTH + Math.floor((i % width) / points);
    for (let c = 0; c < 3; ++c) columns[c][at] += share * rgba[4 * i + c];
  }
  return columns;
}

/** Luma of a square below the horizon. */
function middle([r, g, b]) {
  const left = (WIDTH - SPECTRUM) / 2, top = 40;
  return Float64Array.from({ length: SPECTRUM ** 2 }, (_, k) => {
    const i = (top + Math.floor(k / SPECTRUM)) * WIDTH + left + (k % SPECTRUM);
    return (encode(r[i]) + 2 * encode(g[i]) + encode(b[i])) / 1020;
  });
}
