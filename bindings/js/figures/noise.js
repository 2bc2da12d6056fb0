// SPDX-License-Identifier: MIT
// A slice of a solid texture (shd/solid.h), and its values along a line.
import { enums } from "../lib/api.js";
import { bytesOf, cssOf, Pixels } from "./picture.js";
import { COLOURS, line, number, path, point } from "./paint.js";

const KINDS = ["value", "perlin", "simplex", "marble", "wood"];
const COLUMNS = 384, ROWS = 192, CELLS = 6, DEPTH = 0.37;
const CURVE = 90, GAP = 10;  // CSS pixels
const FADES = Object.keys(enums.solid_fade);
const COLOURED = {
  marble: [[0.06, 0.07, 0.09, 1], [0.5, 0.5, 0.48, 1], [0.86, 0.85, 0.8, 1]],
  wood: [[0.32, 0.14, 0.05, 1], [0.62, 0.36, 0.16, 1]],
};

export function make({ shd, context }) {
  const pixels = new Pixels(COLUMNS, ROWS);
  let p = [0.42, 0.2], picture = null, fill = "#fff";

  function descOf({ kind, octaves, sum, fade, seed }) {
    const desc = { kind, octaves, seed, fade: kind === "simplex" ? FADES[0] : fade };
    if (kind in COLOURED) {
      const colors = COLOURED[kind];
      return { ...desc, distortion: kind === "marble" ? 2.5 : 0.5, colors, colorCount: colors.length };
    }
    // Noise of both signs from black to white; the range of value noise and of sums of |n| is 0..1.
    return { ...desc, sum, range: sum === "turbulence" || kind === "value" ? [0, 1] : [-1, 1] };
  }

  /** Values, gradients or colours at points of the slice. */
  function evaluate(desc, x, y, wanted) {
    const column = () => new Float32Array(x.length);
    const out = Object.fromEntries(Object.entries(wanted).map(([key, count]) =>
      [key, count > 1 ? Array.from({ length: count }, column) : column()]));
    shd.call("shd_solid_evaluate", context, desc, { position: [x, y, new Float32Array(x.length).fill(DEPTH)] }, out);
    return out;
  }
  const across = (count) => Float32Array.from({ length: count }, (_, i) => (CELLS * (i + 0.5)) / count);

  function paintSlice(target, desc) {
    const x = new Float32Array(COLUMNS * ROWS), y = x.slice();
    for (let i = 0; i < x.length; ++i) {
      x[i] = (CELLS * ((i % COLUMNS) + 0.5)) / COLUMNS;
      y[i] = (CELLS * (Math.floor(i / COLUMNS) + 0.5)) / COLUMNS;
    }
    pixels.put(bytesOf(evaluate(desc, x, y, { channel: 4 }).channel)).draw(target, picture);
  }

  /** The curve of the values along the row of the point. */
  function paintCurve(target, desc, { width, height, ink }) {
    const top = height - CURVE, x = across(width);
    const { value } = evaluate(desc, x, x.map(() => p[1] * CELLS), { value: 1 });
    const [low, high] = [Math.min(...value, 0), Math.max(...value, 1e-3)];
    const at = (v) => top + (CURVE - 2) * (1 - (v - low) / (high - low)) + 1;
    line(target, [0, at(0)], [width, at(0)], ink, 0.5);
    path(target, [...value].map((v, i) => [i, at(v)]), false);
    Object.assign(target, { strokeStyle: COLOURS[2], lineWidth: 2 });
    target.stroke();
    line(target, [p[0] * width, top], [p[0] * width, height], COLOURS[0], 1);
    line(target, [0, p[1] * width], [width, p[1] * width], "rgb(255 255 255 / 60%)", 1);
  }

  return {
    label: "Noise and its values along a line: drag the point",
    settings: {
      kind: { label: "Kind", options: KINDS, value: "perlin" },
      fade: { label: "Fade", options: FADES, value: FADES[0] },
      sum: { label: "Sum of octaves", options: Object.keys(enums.solid_sum), value: "fbm" },
      octaves: { label: "Octaves", min: 1, max: 8, step: 1, value: 1 },
      seed: { label: "Seed", min: 0, max: 20, step: 1, value: 3 },
    },
    heightOf: (width) => Math.round((width * ROWS) / COLUMNS) + GAP + CURVE,
    handles: ({ width }) => [{
      label: "Point", at: [p[0] * width, p[1] * width], fill,
      move: (x, y) => { p = [x / width, Math.min(y, picture.height) / width]; },
    }],
    draw(target, view, state) {
      picture = { x: 0, y: 0, width: view.width, height: view.height - CURVE - GAP };
      p[1] = Math.min(p[1], picture.height / view.width);
      const desc = descOf(state);
      paintSlice(target, desc);
      paintCurve(target, desc, view);
      const place = p.map((v) => v * CELLS);
      const wanted = { value: 1, gradient: 3, channel: 4 };
      const { value, gradient, channel } = evaluate(desc, [place[0]], [place[1]], wanted);
      fill = cssOf(channel.map(([v]) => v));
      const slope = gradient.map(([v]) => v);
      return {
        text: `At ${point([...place, DEPTH])}: n = ${number(value[0], 3)}, gradient ${point(slope)}\n${state.octaves} `
          + `${state.octaves > 1 ? "octaves" : "octave"}, cells of 1; the curve has the values along the line`,
        values: { value: value[0], gradient: slope, place },
      };
    },
  };
}
