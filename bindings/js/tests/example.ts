// SPDX-License-Identifier: MIT
// Compiles with the declarations of the package: tsc --noEmit
import { load, ShdError, type MaterialDesc, type Texture } from "shd";
import { Pool } from "shd/pool";

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
const flags = new shd.Framebuffer(context, { width: 1, height: 1, aovs: ["uv", "normal", "level", "draw"] });
new shd.Texture(context, { format: "r8", width: 1, height: 1, texels: new Uint8Array(1), tables: texture.info.tables });
const doubles = new Float64Array(9);
new shd.Mesh(context, { position: doubles, normal: { data: doubles, stride: 3 }, indices: Int32Array.of(0, 1, 2) });
const bytes = new Uint8Array(await (await fetch("model.glb")).arrayBuffer());
const scene = new shd.Scene(context, bytes, {
  name: "model.glb", find: (name) => (name === "wood.png" ? bytes : null), flags: "require_textures", timeLimit: 5,
  sampler: { filter: "ewa" }, texture: { tables: "mipmap", maxPixels: 1 << 24 },
});
const box: number = scene.bounds.radius + scene.info.triangleCount + scene.cameras[0].eye[0]
  + scene.pose("walk", 1.5).lights.length + scene.instances[0].objectToWorld[12];
shd.render(context, { ...scene.fillRender({ framebuffer }), camera: { eye: [0, 0, box] } });
console.log(scene.warnings[0].length, scene.names("material")[0], scene.draws[0].mesh === scene.meshes[0]);
const picture = new shd.Bitmap(context, bytes.buffer, { formats: "png|jpeg" });
const loaded: Texture = shd.Texture.load(context, picture.readPixels(), { tables: "mipmap", info: {} });
console.log(picture.width, picture.colorSpace, picture.info.fileFormat, loaded.info.levelCount);
new shd.Scene(context, bytes, { find: new Map([["a.bin", bytes]]) });
new shd.Scene(context, bytes, { find: { "a.bin": bytes.buffer } });
{
  using sampler = new shd.Sampler(context);
  using pool = new Pool<{ draw(rows: [number, number], angle: number): Uint8ClampedArray }>(() => new Worker("w.js"));
  const [{ rows: [first, last], value }] = await pool.bands(480, "draw", 0.5);
  const drawn: number = (await pool.call("draw", [first, last], 1)).length + value.length;
  console.log(drawn, sampler.isClosed, flags.info.aovs);
}
try {
  new shd.Sampler(context, { maxAnisotropy: sum + nonfiniteCount });
} catch (problem) {
  if (problem instanceof ShdError) console.log(problem.result);
}
