// SPDX-License-Identifier: MIT
// A pixel in the texture: its parallelogram and its ellipse, the level of detail, and the texels that a filter reads on
// each level with their weights.
import { Cache } from "../playground/cache.js";
import { arrow, COLOURS, grid, label, number, panels, path, point, shares } from "./paint.js";
import { Impulses } from "./impulses.js";
import { cssOf, Pixels } from "./picture.js";

const SIZE = 16, LEVELS = 5;
const FILTERS = ["nearest", "bilinear", "nearest_mip", "bilinear_mip", "nearest_mip_linear", "trilinear", "ripmap",
                 "summed_area", "anisotropic", "ewa", "exact"];
const PROFILES = { "longer vector": "vulkan", "least error": "least_error" };
const GAP = 12, TITLE = 22;

function makeTexels() {
  const texels = new Uint8Array(4 * SIZE * SIZE);
  for (let y = 0; y < SIZE; ++y) {
    for (let x = 0; x < SIZE; ++x) {
      const colour = ((x >> 1) + (y >> 1)) & 1 ? [228, 224 - 3 * y, 206 - 4 * x] : [58 + 3 * x, 92 + 2 * y, 120];
      texels.set([...colour, 255], 4 * (y * SIZE + x));
    }
  }
  return texels;
}

/** The weights of an explanation by their levels: [{ levels: [across, down], list: [[x, y, weight]] }]. */
function tablesOf(taps) {
  const tables = new Map();
  for (const { levelU, levelV, x, y, weight } of taps) {
    const key = `${levelU},${levelV}`;
    if (!tables.has(key)) tables.set(key, { levels: [levelU, levelV], cells: new Map() });
    const { cells } = tables.get(key);
    cells.set(`${x},${y}`, (cells.get(`${x},${y}`) ?? 0) + weight);
  }
  return [...tables.values()].map(({ levels, cells }) => ({
    levels, list: [...cells].map(([key, weight]) => [...key.split(",").map(Number), weight]),
  })).sort((a, b) => a.levels[0] - b.levels[0] || a.levels[1] - b.levels[1]);
}

const nameOf = ([across, down]) => (across === down ? `level ${across}` : `level (${across}, ${down})`);

export function make({ shd, context }) {
  const cache = new Cache(), impulses = new Impulses({ shd, context }, SIZE);
  const texture = new shd.Texture(context, { format: "rgba8_srgb", width: SIZE, height: SIZE, texels: makeTexels(),
                                             tables: "mipmap|ripmap|summed_area" });
  const levels = Array.from({ length: LEVELS }, (_, level) => {
    const size = SIZE >> level, pixels = new Uint8ClampedArray(4 * size * size);
    texture.readLevel(0, level, { format: "rgba8_srgb", width: size, height: size, pixels });
    return new Pixels(size, size).put(pixels);
  });
  let centre = [7.3, 8.2], x = [5.2, 1.3], y = [-1.1, 2.4];  // texels
  let area = null, colour = "#fff";

  /** The explanation, with axes of the footprint, and the weights of each level. */
  function explain({ filter, level }) {
    const desc = { filter, profile: PROFILES[level], wrapU: "clamp", wrapV: "clamp" };
    const lookups = Object.fromEntries(Object.entries({
      u: centre[0], v: centre[1], dudx: x[0], dvdx: x[1], dudy: y[0], dvdy: y[1],
    }).map(([key, value]) => [key, [value / SIZE]]));
    const samplerOf = (changes) => cache.get("sampler", { ...desc, ...changes }, () =>
      new shd.Sampler(context, { ...desc, ...changes }));
    if (!impulses.serves(filter)) {
      const explanation = texture.explain(samplerOf({}), lookups);
      return { ...explanation, tables: tablesOf(explanation.taps), isRead: true };
    }
    const { channel } = texture.sample(samplerOf({ profile: "least_error" }), lookups);
    const list = impulses.weigh(samplerOf({ profile: "least_error" }), lookups);
    return { ...texture.explain(samplerOf({ filter: "trilinear" }), lookups), filter, tapCount: list.length,
             result: channel.map(([value]) => value), tables: [{ levels: [0, 0], list }], isRead: false };
  }

  const placeOf = ({ width, x: left, y: top }, [u, v]) => [left + (u * width) / SIZE, top + (v * width) / SIZE];

  /** The pixel's parallelogram and the ellipse of the circle in the pixel. */
  function paintFootprint(target, place, { longerAxis, shorterAxis }, isMain) {
    const scale = place.width / SIZE;
    const at = (s, t) => placeOf(place, centre.map((v, i) => v + s * x[i] + t * y[i]));
    path(target, [at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)]);
    if (isMain) {
      target.fillStyle = "rgb(242 169 0 / 25%)";
      target.fill();
    }
    Object.assign(target, { strokeStyle: "#1b2430", lineWidth: isMain ? 2 : 1.25 });
    target.stroke();
    const [long, short] = [longerAxis, shorterAxis].map((axis) => Math.max(Math.hypot(...axis) * scale / 2, 0.5));
    target.beginPath();
    target.ellipse(...placeOf(place, centre), long, short, Math.atan2(longerAxis[1], longerAxis[0]), 0, 2 * Math.PI);
    Object.assign(target, { strokeStyle: COLOURS[3], lineWidth: isMain ? 2.5 : 1.5 });
    target.stroke();
  }

  function paintLevel(target, place, { levels: [across, down], list }, explanation, ink) {
    const [columns, rows] = [across, down].map((level) => SIZE >> level);
    target.save();
    target.beginPath();
    target.rect(place.x, place.y, place.width, place.height);
    target.clip();
    levels[across === down ? across : 0].draw(target, place, false);
    grid(target, place, columns, rows, "rgb(60 60 60 / 55%)");
    shares(target, place, columns, rows, list);
    paintFootprint(target, place, explanation, false);
    target.restore();
    const sum = list.reduce((total, [, , weight]) => total + weight, 0);
    label(target, `${nameOf([across, down])}: ${number(100 * sum, 0)} %`, [place.x, place.y - TITLE / 2],
          { align: "left", colour: ink, halo: null });
  }

  function textOf({ lod, filter, longerAxis, shorterAxis, tapCount, tables, result, isRead }) {
    const [lx, ly] = [Math.hypot(...x), Math.hypot(...y)], detail = Math.log2(Math.max(lx, ly));
    const [long, short] = [longerAxis, shorterAxis].map((axis) => Math.hypot(...axis));
    const sum = tables.reduce((total, { list }) => list.reduce((part, [, , weight]) => part + weight, total), 0);
    const texels = `${tapCount} ${tapCount === 1 ? "texel" : "texels"}`;
    const names = tables.map((table) => nameOf(table.levels));
    return {
      values: { lx, ly, detail, lod, sum, levels: tables.map((table) => table.levels), tapCount, result },
      text: `L_x = ${number(lx)}, L_y = ${number(ly)} texels;   D = log2 max(L_x, L_y) = ${number(detail)}\n`
        + `ellipse ${number(long)} × ${number(short)} texels, ratio ${number(long / Math.max(short, 1e-6), 1)};   `
        + `level of detail of trilinear ${number(lod)}\n`
        + `${filter.replaceAll("_", " ")}: ${isRead ? `${texels} of ${names.join(" and ")}`
          : `${texels} have a weight`}, sum ${number(sum, 3)}; result ${point(result.slice(0, 3))}`,
    };
  }

  return {
    label: "Footprint of a pixel in a texture: drag the pixel and its two derivatives",
    settings: {
      filter: { label: "Filter", options: FILTERS, value: "trilinear" },
      level: { label: "Level by", options: Object.keys(PROFILES), value: "longer vector" },
    },
    heightOf: (width, state) => layOut(width, countOf(state)).height,
    handles: () => [
      { label: "Pixel", at: placeOf(area, centre), fill: colour, move: (i, j) => { centre = texelOf([i, j]); } },
      { label: "Derivative by x", at: tipOf(x), fill: COLOURS[0], move: (i, j) => { x = sideOf([i, j]); } },
      { label: "Derivative by y", at: tipOf(y), fill: COLOURS[1], move: (i, j) => { y = sideOf([i, j]); } },
    ],
    draw(target, view, state) {
      const explanation = explain(state);
      const { main, small } = layOut(view.width, countOf(state));
      area = main;
      colour = cssOf(explanation.result);
      levels[0].draw(target, main, false);
      grid(target, main, SIZE, SIZE, "rgb(60 60 60 / 55%)");
      paintFootprint(target, main, explanation, true);
      [x, y].forEach((side, k) => {
        const tip = tipOf(side);
        arrow(target, placeOf(main, centre), tip, COLOURS[k]);
        label(target, "xy"[k], [tip[0], tip[1] + (k ? 18 : -18)]);
      });
      if (explanation.tables.length === 1) small[0].width = small[0].height = small[0].single;
      explanation.tables.forEach((table, i) => paintLevel(target, small[i], table, explanation, view.ink));
      cache.sweep();
      return textOf(explanation);
    },
  };

  function texelOf([i, j]) {
    return [i - area.x, j - area.y].map((v) => Math.min(Math.max((v * SIZE) / area.width, 0), SIZE));
  }
  function sideOf(place) {
    return texelOf(place).map((v, i) => v - centre[i]);
  }
  function tipOf(side) {
    return placeOf(area, centre.map((v, i) => v + side[i]));
  }
}

/** Panels of levels for a filter: two per axis of the ripmap. */
const countOf = ({ filter }) => (filter === "ripmap" ? 4 : 2);

/** The texture, and beside or below it the panels of the levels. */
function layOut(width, count) {
  const isWide = width >= 620;
  const size = isWide ? Math.min(440, 0.55 * width) : width;
  const column = isWide ? width - size - GAP : width;
  const rest = panels(column, count, { least: (column - GAP) / 2 - 1, top: TITLE });
  const [left, top] = isWide ? [size + GAP, 0] : [0, size + GAP];
  const small = rest.places.map((place) => ({ ...place, x: place.x + left, y: place.y + top,
                                              single: isWide ? Math.min(column, size - TITLE) : place.width }));
  return { main: { x: 0, y: 0, width: size, height: size }, small, height: Math.max(size, top + rest.height) };
}
