// SPDX-License-Identifier: MIT
// Compiles with the declarations of the package: tsc --noEmit
import { load, ShdError, type MaterialDesc, type Texture } from "shd";

declare const target: CanvasRenderingContext2D;
const shd = await load();
const context = new shd.Context({ log: (level, message) => console.log(level, message) });
const texture: Texture = new shd.Texture(context, {
  format: "rgba8_srgb", width: 2, height: 2, texels: new Uint8Array(16), tables: "mipmap|ripmap",
      swizzle: ["r", "r", "r", "a"],
});
const sampler = new shd.Sampler(context, { filter: "ewa", maxAnisotropy: 8, wrapU: "clamp" });
const columns = texture.sample(sampler, { u: new Float32Array(4), v: [0, 0, 0, 0] });
const first: number = columns.channel[0][0];
const desc: MaterialDesc = {
  model: "program",
  program: { fragment: (fragments, out) => out.r.set(fragments.u) },
  slots: [{ target: "diffuse", texture, sampler }],
};
const mesh = shd.Mesh.shape(context, { kind: "torus", segments: [8, 8, 0] });
const framebuffer = new shd.Framebuffer(context, { width: 4, height: 4, aovs: "level" });
const stats = shd.render(context, {
  framebuffer, draws: [{ mesh, material: new shd.Material(context, desc) }], camera: { eye: [0, 0, 3] },
  lights: [new shd.Light(context, { kind: "directional" })], progress: (fraction) => fraction < 0.5,
});
const pixels: Uint8ClampedArray = framebuffer.readColor();
target.putImageData(new ImageData(framebuffer.readColor("rgba8_srgb"), 4, 4), 0, 0);
target.putImageData(new ImageData(framebuffer.readColor("rgba8_srgb", new Uint8ClampedArray(64)), 4, 4), 0, 0);
const levels: Uint32Array = framebuffer.readPlane("level");
const allocation = shd.allocate(Float32Array, 16);
const sum: number = allocation.array[0] + stats.fragmentCount + first + pixels.length + levels.length;
const cache = new shd.TileCache(context, { budgetBytes: 1 << 20 });
const tiled = new shd.Texture(context, {
  format: "r8", width: 256, height: 256, tiles: { cache, load: (tiles) => tiles.forEach((t) => t.texels.fill(t.area.x)) },
});
const { nonfiniteCount } = tiled.sample(sampler, { u: [0.5], v: [0.5] });
try {
  // @ts-expect-error there is no such filter
  new shd.Sampler(context, { filter: "best" });
  // @ts-expect-error there is no such field
  new shd.Sampler(context, { anisotropy: sum + nonfiniteCount });
} catch (problem) {
  if (problem instanceof ShdError) console.log(problem.result);
}
