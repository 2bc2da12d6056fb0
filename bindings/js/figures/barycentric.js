// SPDX-License-Identifier: MIT
// Coordinates of a point in a triangle or a quadrilateral (shd/polygon.h).
import { bytesOf, Pixels } from "./picture.js";
import { COLOURS, label, line, number, path, point } from "./paint.js";

const CORNERS = {
  triangle: [[0.1, 0.86], [0.92, 0.74], [0.42, 0.1]],
  quadrilateral: [[0.1, 0.84], [0.9, 0.9], [0.8, 0.2], [0.24, 0.1]],
};
const NAMES = ["A", "B", "C", "D"], WEIGHTS = ["α", "β", "γ", "δ"];
const GRID = 128;  // points across and down at which colours are computed
const LINEAR = COLOURS.map((text) => [1, 3, 5].map((i) => (parseInt(text.slice(i, i + 2), 16) / 255) ** 2.2));

export function make({ shd, context }) {
  const corners = structuredClone(CORNERS);
  const pixels = new Pixels(GRID, GRID);
  let p = [0.47, 0.56];

  /** A column of weights for each vertex. */
  function weigh(polygon, positions) {
    const vertex = [0, 1].map((axis) => polygon.map((corner) => corner[axis]));
    const weight = polygon.map(() => new Float32Array(positions[0].length));
    shd.call("shd_polygon_evaluate", context, { kind: "mean_value", vertex }, { position: positions }, { weight });
    return weight;
  }

  /** The colours of the vertices, weighted by the coordinates of each pixel. */
  function paintColours(target, polygon, { width, height }) {
    const at = (axis) => Float32Array.from({ length: GRID * GRID },
                                          (_, i) => ((axis ? Math.floor(i / GRID) : i % GRID) + 0.5) / GRID);
    const weights = weigh(polygon, [at(0), at(1)]);
    const channel = [0, 1, 2].map((c) => weights[0].map((_, i) =>
      weights.reduce((sum, weight, k) => sum + weight[i] * LINEAR[k][c], 0)));
    target.save();
    path(target, polygon.map(([x, y]) => [x * width, y * height]));
    target.clip();
    pixels.put(bytesOf(channel)).draw(target, { x: 0, y: 0, width, height });
    target.restore();
  }

  /** Of a triangle, each corner's coordinate is the share of the area opposite to it. */
  function paintAreas(target, places, place) {
    places.forEach((_, k) => {
      path(target, [place, places[(k + 1) % 3], places[(k + 2) % 3]]);
      target.globalAlpha = 0.55;
      target.fillStyle = COLOURS[k];
      target.fill();
      target.globalAlpha = 1;
    });
  }

  function textOf(polygon, weights, sum) {
    const terms = weights.map((weight, k) => `${WEIGHTS[k]} = ${number(weight, 3)}`).join("   ");
    const mean = [0, 1].map((axis) => polygon.reduce((total, corner, k) => total + weights[k] * corner[axis], 0));
    const names = WEIGHTS.slice(0, polygon.length).map((name, k) => `${name}${NAMES[k]}`).join(" + ");
    return { mean, text: `${terms}   sum ${number(sum, 3)}\nP = ${names} = ${point(mean)}` };
  }

  return {
    label: "Barycentric coordinates: drag the corners and the point",
    settings: {
      shape: { label: "Shape", options: Object.keys(CORNERS), value: "triangle" },
      show: { label: "Show", options: ["areas", "colours"], value: "areas" },
    },
    heightOf: (width) => Math.min(0.8 * width, 380),
    handles: ({ width, height }, { shape }) => [
      ...corners[shape].map((corner, k) => ({
        label: `Corner ${NAMES[k]}`, at: [corner[0] * width, corner[1] * height], fill: COLOURS[k],
        move: (x, y) => { corner.splice(0, 2, x / width, y / height); },
      })),
      { label: "Point P", at: [p[0] * width, p[1] * height], move: (x, y) => { p = [x / width, y / height]; } },
    ],
    draw(target, view, { shape, show }) {
      const polygon = corners[shape];
      const { width, height, ink } = view;
      const weights = weigh(polygon, [[p[0]], [p[1]]]).map(([weight]) => weight);
      const sum = weights.reduce((total, weight) => total + weight, 0);
      const places = polygon.map(([x, y]) => [x * width, y * height]), place = [p[0] * width, p[1] * height];
      if (show === "areas" && shape === "triangle") paintAreas(target, places, place);
      else paintColours(target, polygon, view);
      path(target, places);
      Object.assign(target, { strokeStyle: ink, lineWidth: 1.5 });
      target.stroke();
      const middle = [0, 1].map((axis) => places.reduce((total, corner) => total + corner[axis], 0) / places.length);
      places.forEach((corner, k) => {
        line(target, place, corner, ink, 1);
        const away = Math.hypot(corner[0] - middle[0], corner[1] - middle[1]) || 1;
        const at = corner.map((v, axis) => v + (20 * (corner[axis] - middle[axis])) / away);
        label(target, NAMES[k], [Math.min(Math.max(at[0], 8), width - 8), Math.min(Math.max(at[1], 10), height - 10)],
              { size: 15, colour: ink, halo: null });
      });
      const { mean, text } = textOf(polygon, weights, sum);
      return { text, values: { weights, sum, mean, point: [...p] } };
    },
  };
}
