// SPDX-License-Identifier: MIT
// Shadows of a moving light by the filters of shadow maps (shd/shadow.h).
import { Cache } from "../playground/cache.js";
import { Picture } from "./picture.js";
import { number, point } from "./paint.js";

const FILTERS = ["hard", "pcf", "pcss", "variance"];
const WIDTH = 480, HEIGHT = 320;
const CAMERA = { eye: [0, 5, 6.5], target: [0, 0.9, 0], fovY: 0.8 };
const LIGHT_HEIGHT = 3;
const OBJECTS = [
  [{ kind: "box", size: [0.9, 1.8, 0.9] }, [-1.1, 0.9, 0.1], [0.75, 0.35, 0.2]],
  [{ kind: "sphere", radius: 0.55, segments: [48, 24, 0] }, [0.55, 0.55, 0.5], [0.25, 0.5, 0.75]],
  [{ kind: "torus", radius: 0.5, tubeRadius: 0.16 }, [1.7, 1.1, -0.7], [0.7, 0.62, 0.25]],
  [{ kind: "plane", size: [14, 1, 14] }, [0, 0, 0], [0.72, 0.72, 0.7]],
];
const placed = ([x, y, z]) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

export function make({ shd, context }) {
  const cache = new Cache(), picture = new Picture({ shd, context }, WIDTH, HEIGHT);
  const draws = OBJECTS.map(([mesh, place, diffuse]) => ({
    mesh: shd.Mesh.shape(context, mesh), objectToWorld: placed(place),
    material: new shd.Material(context, { diffuse, ambientShare: 0.3 }),
  }));
  const ambient = new shd.Light(context, { kind: "ambient" });
  const view = shd.call("shd_view_from_camera", { ...CAMERA, aspect: WIDTH / HEIGHT });
  const inverse = shd.call("shd_matrix_invert", view.worldToView);
  let light = [-1.6, 1.4], p = [1.15, 0.96];  // x and z
  let size = [1, 1];

  /** The place of a world point in the picture, in CSS pixels. */
  function project([x, y, z]) {
    const m = view.worldToView, c = view.viewToClip;
    const [a, b, d] = [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i]);
    return [(0.5 + (0.5 * c[0] * a) / -d) * size[0], (0.5 - (0.5 * c[5] * b) / -d) * size[1]];
  }
  /** The point of a horizontal plane at a place of the picture, as x and z. */
  function unproject(i, j, height) {
    const c = view.viewToClip;
    const ray = [(2 * i / size[0] - 1) / c[0], (1 - 2 * j / size[1]) / c[5], -1];
    const d = [0, 1, 2].map((k) => inverse[k] * ray[0] + inverse[4 + k] * ray[1] + inverse[8 + k] * ray[2]);
    const t = (height - view.eye[1]) / Math.min(d[1], -1e-3);  // rays above the horizon end far away
    return [0, 2].map((k) => Math.min(Math.max(view.eye[k] + t * d[k], -3.2), 3.2));
  }

  /** The shadow of the light, with its map. */
  function shadowOf(lamp, { filter, bias, mapSize, taps, lightSize }) {
    const desc = { filter, bias, size: Number(mapSize), taps, lightSize, biasSlope: 0 };
    const shadow = cache.get("shadow", desc, () => new shd.Shadow(context, desc));
    shadow.render(context, { light: lamp, draws: draws.slice(0, -1), nearPlane: 0.5, farPlane: 12 });
    return shadow;
  }

  return {
    label: "Shadows: drag the light and the point on the floor",
    settings: {
      filter: { label: "Filter", options: FILTERS, value: "pcf" },
      mapSize: { label: "Texels across the map", options: ["64", "128", "256", "512"], value: "256" },
      bias: { label: "Bias", min: 0, max: 0.3, step: 0.005, value: 0.04 },
      taps: { label: "Taps across", min: 1, max: 15, step: 1, value: 5 },
      lightSize: { label: "Size of the light (PCSS)", min: 0, max: 1, step: 0.05, value: 0.4 },
    },
    heightOf: (width) => Math.round((width * HEIGHT) / WIDTH),
    handles: () => [
      { label: "Light", at: project([light[0], LIGHT_HEIGHT, light[1]]), fill: "#ffd34d",
        move: (x, y) => { light = unproject(x, y, LIGHT_HEIGHT); } },
      { label: "Point on the floor", at: project([p[0], 0, p[1]]), move: (x, y) => { p = unproject(x, y, 0); } },
    ],
    draw(target, { width, height }, state) {
      size = [width, height];
      const place = [light[0], LIGHT_HEIGHT, light[1]];
      const desc = { kind: "point", position: place, intensity: [9, 8.6, 7.8] };
      const lamp = cache.get("light", desc, () => new shd.Light(context, desc));
      const shadow = shadowOf(lamp, state);
      picture.render({ draws, lights: [lamp, ambient], shadows: [shadow, null], view,
                       clearColor: [0.3, 0.36, 0.45, 1] });
      picture.draw(target, { x: 0, y: 0, width, height });
      const { visibility } = shadow.sample({ position: [[p[0]], [0], [p[1]]], normal: [[0], [1], [0]] },
                                           { visibility: new Float32Array(1) });
      cache.sweep();
      return {
        text: `Light at ${point(place, 1)}; at ${point([p[0], 0, p[1]], 1)} its visibility is `
          + `${number(visibility[0], 3)}\n${state.filter}: map of ${state.mapSize} × ${state.mapSize} texels a face, `
          + `bias ${number(state.bias, 3)}`,
        values: { visibility: visibility[0], light: place },
      };
    },
  };
}
