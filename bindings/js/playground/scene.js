// SPDX-License-Identifier: MIT
// The picture of a state as descs of shd. They are data alone, so that another program can draw the same picture.
import { sideOf } from "./state.js";

const SHAPES = {
  teapot: { desc: { kind: "teapot", segments: [10, 0, 0] }, scale: 0.62, lift: 0, uv: 1 },
  torus: { desc: { kind: "torus", radius: 1, tubeRadius: 0.42, segments: [96, 48, 0] }, scale: 1, lift: 0.42,
      uv: [4, 2] },
  sphere: { desc: { kind: "sphere", segments: [96, 48, 0] }, scale: 1, lift: 1, uv: [4, 2] },
  plane: { desc: { kind: "plane", size: [2.4, 1, 2.4] }, scale: 1, lift: 0.02, uv: 1 },
};
const FLOOR = 240;
const SKY = [0.2, 0.27, 0.36, 1];
const radians = (degrees) => (degrees * Math.PI) / 180;

/** The direction at an azimuth and an elevation [degrees]. */
function direction(azimuth, elevation) {
  const [a, e] = [radians(azimuth), radians(elevation)];
  return [Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e)];
}

const scaling = ([u, v], repeat) => [u * repeat, 0, 0, 0, v * repeat, 0];
const placement = (scale, y) => [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, y, 0, 1];

function materialOf(state, uvTransform) {
  const isRough = state.model === "metallic_roughness";
  return {
    model: state.model, diffuse: [1, 1, 1], specular: [0.35, 0.35, 0.35], exponent: 2 / state.roughness ** 3,
    roughness: state.roughness, ambientShare: isRough ? 1 : 0.35, uvTransform,
  };
}

/** Meshes, materials, samplers, lights and camera of a state. */
export function describe(state) {
  const shape = SHAPES[state.shape];
  const repeat = state.repeat;
  const uv = Array.isArray(shape.uv) ? shape.uv : [shape.uv, shape.uv];
  const [width, height] = state.size.split("x").map(Number);
  const draws = [{ mesh: shape.desc, material: materialOf(state, scaling(uv, repeat)),
      objectToWorld: placement(shape.scale, shape.lift) }];
  if (state.floor) {
    draws.push({ mesh: { kind: "plane", size: [FLOOR, 1, FLOOR] }, material: materialOf(state, scaling([FLOOR / 2,
        FLOOR / 2], repeat)),
                 objectToWorld: placement(1, 0) });
  }
  const target = [0, state.shape === "teapot" ? 0.85 : 0.6, 0];
  const eye = direction(state.azimuth, state.elevation).map((v,
      i) => v * state.distance + target[i] * (i === 1 ? 1 : 0));
  const sun = direction(state.sun, state.height).map((v) => -v);
  return {
    width, height, samples: Number(state.samples), texture: state.texture, draws,
    lights: [{ kind: "directional", direction: sun, intensity: [1, 0.97, 0.9].map((v) => v * state.power) },
             { kind: "ambient", intensity: [0.5, 0.56, 0.65] }],
    shadow: state.shadow && state.model !== "unlit",
    camera: { eye, target, fovY: 0.75, nearPlane: 0.05, farPlane: 400 },
    clearColor: SKY,
    samplers: ["a", "b"].map((prefix) => sideOf(state, prefix)),
    splitAt: state.compare ? Math.round(state.wipe * width) : 0,
  };
}
