// SPDX-License-Identifier: MIT
// Flat, Gouraud and Phong shading with the terms of Blinn and Phong, side by side.
import { Cache } from "../playground/cache.js";
import { Picture } from "./picture.js";
import { label, number, panels } from "./paint.js";
import { LightHandle } from "./light.js";

const FREQUENCIES = [["Flat", "flat"], ["Gouraud", "gouraud"], ["Phong", "phong"]];
const SIZE = 241, TITLE = 22;  // an odd number of pixels has one in the middle
const SHAPES = {
  sphere: { mesh: { kind: "sphere", segments: [16, 9, 0] }, camera: { eye: [0, 0, 20], fovY: 0.108 } },
  teapot: { mesh: { kind: "teapot", segments: [3, 0, 0] },
            camera: { eye: [0, 3, 10], target: [0, 1.35, 0], fovY: 0.62 } },
};
const COLOUR = [0.85, 0.3, 0.15];
const range = (name, max, step, value) => ({ label: name, min: 0, max, step, value });
const toggle = (name) => ({ label: name, toggle: true, value: true });

export function make({ shd, context }) {
  const cache = new Cache(), light = new LightHandle(0.45, 0.5);
  const pictures = FREQUENCIES.map(() => new Picture({ shd, context }, SIZE, SIZE));
  let places = null;

  function frameOf(state) {
    const { mesh, camera } = SHAPES[state.shape];
    const lightDescs = [{ kind: "directional", direction: light.direction.map((v) => -v) }, { kind: "ambient" }];
    const factor = (term, key) => (state[term] ? state[key] : 0);
    const desc = { model: "blinn_phong", exponent: state.p,
                   diffuse: COLOUR.map((v) => v * factor("diffuse", "kd")),
                   ambient: COLOUR.map((v) => v * factor("ambient", "ka")),
                   specular: Array(3).fill(factor("specular", "ks")) };
    return {
      camera, lights: lightDescs.map((one) => cache.get("light", one, () => new shd.Light(context, one))),
      draw: { mesh: cache.get("mesh", mesh, () => shd.Mesh.shape(context, mesh)), cull: "back",
              material: cache.get("material", desc, () => new shd.Material(context, desc)) },
    };
  }

  /** The terms at the point of the sphere that faces the eye, for red. */
  function termsOf({ ambient, diffuse, specular, ka, kd, ks, p }) {
    const [x, y, z] = light.direction, length = Math.hypot(x, y, z + 1);
    const nl = z, nh = (z + 1) / length;
    const terms = [ambient ? ka * COLOUR[0] : 0, diffuse ? kd * COLOUR[0] * nl : 0,
                   specular && nl > 0 ? ks * nh ** p : 0];
    return { nl, nh, terms, sum: terms[0] + terms[1] + terms[2] };
  }

  return {
    label: "Flat, Gouraud and Phong shading: drag the light",
    settings: {
      shape: { label: "Shape", options: Object.keys(SHAPES), value: "sphere" },
      ka: range("Ambient k_a", 1, 0.05, 0.1), kd: range("Diffuse k_d", 1, 0.05, 0.7),
      ks: range("Specular k_s", 1, 0.05, 0.5), p: range("Exponent p", 128, 1, 24),
      ambient: toggle("Ambient"), diffuse: toggle("Diffuse"), specular: toggle("Specular"),
    },
    heightOf: (width) => layOut(width).height,
    handles: () => [light.handle(places[1])],
    draw(target, { width, ink }, state) {
      ({ places } = layOut(width));
      const { draw, ...frame } = frameOf(state);
      FREQUENCIES.forEach(([name, frequency], i) => {
        pictures[i].render({ ...frame, draws: [{ ...draw, frequency }], clearColor: [0.02, 0.024, 0.03, 1] });
        pictures[i].draw(target, places[i]);
        label(target, name, [places[i].x + places[i].width / 2, places[i].y - TITLE / 2], { colour: ink, halo: null });
      });
      cache.sweep();
      const { nl, nh, terms, sum } = termsOf(state);
      const middle = 4 * ((SIZE >> 1) * SIZE + (SIZE >> 1));
      const pixel = pictures[2].framebuffer.readColor("rgba32f")[middle];
      return {
        text: `Where the surface faces the eye: n·l = ${number(nl)}, n·h = ${number(nh, 3)}, `
          + `(n·h)^p = ${number(nh ** state.p, 3)}\nred: ambient ${number(terms[0], 3)} `
          + `+ diffuse ${number(terms[1], 3)} + specular ${number(terms[2], 3)} = ${number(sum, 3)}`
          + (state.shape === "sphere" ? `; middle of the Phong sphere ${number(pixel, 3)}` : ""),
        values: { nl, nh, sum, pixel },
      };
    },
  };
}

const layOut = (width) =>
  panels(width, FREQUENCIES.length, { least: 105, most: 300, gap: width < 500 ? 6 : 12, top: TITLE });
