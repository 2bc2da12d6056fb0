// SPDX-License-Identifier: MIT
// The frame of floor.c in WebAssembly: node floor.mjs [trilinear|anisotropic|ewa]
import { load } from "../lib/index.js";
import { hashBytes } from "../examples/programs.mjs";

const SIZE = 512;
const FRAMES = 80;  // the first ones run code that is not yet optimised

export function renderFloor(shd, filter = "trilinear") {
  const context = new shd.Context({ workerCount: 1 });
  const texels = new Uint8Array(SIZE * SIZE * 4);
  for (let y = 0, i = 0; y < SIZE; ++y) {
    for (let x = 0; x < SIZE; ++x, i += 4) texels.set([x >> 1, y >> 1, (x ^ y) & 255, 255], i);
  }
  const texture = new shd.Texture(context, { width: SIZE, height: SIZE, format: "rgba8_srgb", texels,
      tables: "mipmap" });
  const sampler = new shd.Sampler(context, { filter });
  const material = new shd.Material(context, {
    model: "unlit", diffuse: [1, 1, 1],
    slots: [{ target: "diffuse", texture, sampler, uvTransform: [32, 0, 0, 0, 32, 0] }],
  });
  const framebuffer = new shd.Framebuffer(context, { width: 640, height: 480, colorFormat: "rgba8_srgb" });
  const frame = {
    framebuffer, draws: [{ mesh: shd.Mesh.shape(context, { kind: "plane", size: [32, 1, 32] }), material }],
    camera: { eye: [0, 1, 8], target: [0, 0.5, 0] },
  };
  let best = Infinity;
  for (let i = 0; i < FRAMES; ++i) {
    const start = performance.now();
    shd.render(context, frame);
    best = Math.min(best, performance.now() - start);
  }
  const hash = hashBytes(framebuffer.readColor("rgba8_srgb")).map((word) => word.toString(16).padStart(8, "0"))
      .join("");
  return `${context.simdTarget} ${filter} ${best.toFixed(3)} ms ${hash}`;
}

if (typeof process !== "undefined" && process.argv?.[1]?.endsWith("floor.mjs")) {
  console.log(renderFloor(await load(process.env.SHD_WASM), process.argv[2]));
}
