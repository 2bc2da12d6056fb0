// SPDX-License-Identifier: MIT
// One height map as a bump map, as a normal map and as displacement.
import { Cache } from "../playground/cache.js";
import { Picture } from "./picture.js";
import { label, number, panels, point } from "./paint.js";
import { LightHandle } from "./light.js";

const WAYS = ["Bump map", "Normal map", "Displacement"];
const SIZE = 220, TEXELS = 128, TITLE = 22, FINE = 64;
const SHAPES = {
  sphere: { mesh: { kind: "sphere", segments: [FINE, FINE / 2, 0] }, camera: { eye: [0, 0, 6], fovY: 0.42 },
            repeat: [4, 2], extent: [2 * Math.PI, Math.PI] },
  plane: { mesh: { kind: "plane", size: [2, 1, 2], segments: [FINE, 0, FINE] },
           camera: { eye: [0, 2.3, 3.1], target: [0, -0.05, 0], fovY: 0.5 }, repeat: [2, 2], extent: [2, 2] },
};
const PATTERNS = {
  rings(u, v) {
    const radius = Math.hypot(u - 0.5, v - 0.5);
    return 0.5 - 0.5 * Math.cos(6 * Math.PI * radius) * Math.max(0, 1 - 2 * radius);
  },
  waves: (u, v) => 0.5 + 0.25 * Math.sin(2 * Math.PI * (2 * u + v)) + 0.25 * Math.sin(2 * Math.PI * (3 * v - u)),
  tiles: (u, v) => Math.min(1, 7 * Math.min(...[u, v].map((t) => Math.min((2 * t) % 1, 1 - ((2 * t) % 1))))),
};

const MODEL = { model: "blinn_phong", diffuse: [0.55, 0.45, 0.36], ambientShare: 0.25, specular: [0.35, 0.35, 0.35],
                exponent: 40 };

/** Heights of a pattern that repeats. */
const heightsOf = (pattern) => Float32Array.from({ length: TEXELS * TEXELS }, (_, i) =>
  PATTERNS[pattern](((i % TEXELS) + 0.5) / TEXELS, (Math.floor(i / TEXELS) + 0.5) / TEXELS));

/** Normals (x, y, z) of heights whose texels are `step` apart across and down the surface; y points up in the image. */
function normalsOf(heights, amplitude, step) {
  const normals = new Float32Array(4 * TEXELS * TEXELS);
  let steepest = 0;
  const at = (x, y) => heights[((y + TEXELS) % TEXELS) * TEXELS + ((x + TEXELS) % TEXELS)];
  for (let y = 0; y < TEXELS; ++y) {
    for (let x = 0; x < TEXELS; ++x) {
      const slope = [(at(x + 1, y) - at(x - 1, y)) / step[0], (at(x, y + 1) - at(x, y - 1)) / step[1]]
        .map((v) => 0.5 * amplitude * v);
      const length = Math.hypot(...slope, 1);
      steepest = Math.max(steepest, Math.hypot(...slope));
      normals.set([-slope[0] / length, slope[1] / length, 1 / length, 1], 4 * (y * TEXELS + x));
    }
  }
  return { normals, steepest };
}

export function make({ shd, context }) {
  const cache = new Cache(), light = new LightHandle(-0.5, 0.55);
  const pictures = WAYS.map(() => new Picture({ shd, context }, SIZE, SIZE));
  const sampler = new shd.Sampler(context, { filter: "bicubic", cubic: "b_spline" });
  let places = null, made = { key: "" };

  /** The normals of a pattern, computed when the settings change. */
  function normalsFor(key, pattern, amplitude, step) {
    if (made.key !== String(key)) made = { key: String(key), ...normalsOf(heightsOf(pattern), amplitude, step) };
    return made;
  }
  const textureOf = (name, key, texels, format) => cache.get(name, key, () => new shd.Texture(context, {
    format, width: TEXELS, height: TEXELS, texels: texels(), tables: "mipmap" }));

  /** Mesh and material of each way. */
  function drawsOf({ shape, pattern, amplitude }) {
    const { mesh: desc, repeat, extent } = SHAPES[shape];
    const key = [shape, pattern, amplitude];
    const heights = textureOf("heights", pattern, () => heightsOf(pattern), "r32f");
    const step = extent.map((v, axis) => v / (repeat[axis] * TEXELS));
    const { normals, steepest } = normalsFor(key, pattern, amplitude, step);
    const normalMap = textureOf("normals", key, () => normals, "rgba32f");
    const uvTransform = [repeat[0], 0, 0, 0, repeat[1], 0];
    const material = (name, made) => cache.get(name, key, () => new shd.Material(context, { ...MODEL, ...made }));
    const slot = (target, texture) => ({ slots: [{ target, texture, sampler, uvTransform }] });
    const base = cache.get("mesh", desc, () => shd.Mesh.shape(context, desc));
    const repeated = cache.get("repeated", [shape], () => repeatUv(base, repeat));
    const displaced = cache.get("displaced", key, () => repeated.tessellate(context, {
      segments: 2, displacement: heights, sampler, amplitude, offset: 0.5 }));
    const bump = { bump: "gradient", bumpScale: amplitude };
    return { steepest, triangles: displaced.info.triangleCount, draws: [
      { mesh: base, material: material("bump", { ...bump, ...slot("height", heights) }) },
      { mesh: base, material: material("normal", slot("normal", normalMap)) },
      { mesh: displaced, material: material("plain", {}) },
    ] };
  }

  /** The mesh with uv of several periods, for displacement. */
  function repeatUv(mesh, repeat) {
    const uv = mesh.read("uv").map((v, i) => v * repeat[i % 2]);
    return new shd.Mesh(context, { position: mesh.read("positions"), normal: mesh.read("normals"), uv,
                                   indices: mesh.readIndices() });
  }

  return {
    label: "Bump map, normal map and displacement: drag the light",
    settings: {
      shape: { label: "Surface", options: Object.keys(SHAPES), value: "sphere" },
      pattern: { label: "Heights", options: Object.keys(PATTERNS), value: "tiles" },
      amplitude: { label: "Amplitude", min: 0, max: 0.2, step: 0.01, value: 0.08 },
    },
    heightOf: (width) => layOut(width).height,
    handles: () => [light.handle(places[1])],
    draw(target, { width, ink }, state) {
      ({ places } = layOut(width));
      const { draws, steepest, triangles } = drawsOf(state);
      const [x, y, z] = light.direction;
      // Of the plane, the light is seen from above.
      const direction = state.shape === "plane" ? [-x, -z - 0.15, y] : [-x, -y, -z];
      const lights = [{ kind: "directional", direction }, { kind: "ambient" }].map((desc) =>
        cache.get("light", desc, () => new shd.Light(context, desc)));
      draws.forEach((draw, i) => {
        const { camera } = SHAPES[state.shape];
        pictures[i].render({ draws: [draw], lights, camera, clearColor: [0.02, 0.024, 0.03, 1] });
        pictures[i].draw(target, places[i]);
        label(target, WAYS[i], [places[i].x + places[i].width / 2, places[i].y - TITLE / 2],
              { colour: ink, halo: null, size: width < 500 ? 11 : 13 });
      });
      cache.sweep();
      return {
        text: `Light from ${point(direction.map((v) => -v))}. Steepest slope ${number(steepest)}: `
          + `normals tilt by up to ${number((180 * Math.atan(steepest)) / Math.PI, 0)}°\n`
          + `The maps keep the outline; displacement moves ${triangles} triangles and changes it`,
        values: { steepest, triangles },
      };
    },
  };
}

const layOut = (width) => panels(width, WAYS.length, { least: 105, most: 300, gap: width < 500 ? 6 : 12, top: TITLE });
