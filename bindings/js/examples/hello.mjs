// SPDX-License-Identifier: MIT
// A teapot of wood on a floor, written as a PNG file: node hello.mjs picture.png
import { writeFileSync } from "node:fs";
import { load } from "shd";
import { encodePng } from "./png.mjs";

const shd = await load();
const context = new shd.Context();
const browns = [[0.3, 0.12, 0.04, 1], [0.75, 0.45, 0.2, 1]];
const wood = { kind: "wood", size: 0.3, distortion: 0.4, colorCount: 2, colors: browns };
const tiles = { kind: "checker", size: 1.5, colorCount: 2, colors: [[0.1, 0.12, 0.15, 1], [0.8, 0.8, 0.75, 1]] };
// The floor lies inside cells of the checker.
const placeTransform = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0, 1];
const material = (solid) => new shd.Material(context, {
  model: "blinn_phong", diffuse: [1, 1, 1], slots: [{ target: "diffuse", solid, placeTransform }],
});
const framebuffer = new shd.Framebuffer(context, { width: 480, height: 320, sampleCount: 4 });
const stats = shd.render(context, {
  framebuffer,
  clearColor: [0.05, 0.07, 0.1, 1],
  draws: [
    { mesh: shd.Mesh.shape(context, { kind: "teapot" }), material: material(wood) },
    { mesh: shd.Mesh.shape(context, { kind: "plane", size: [40, 1, 40] }), material: material(tiles) },
  ],
  lights: [new shd.Light(context, { kind: "directional", direction: [-0.5, -1, -0.6], intensity: [0.8, 0.8, 0.8] })],
  camera: { eye: [3, 4.5, 7.5], target: [0.1, 1.3, 0] },
});
writeFileSync(process.argv[2] ?? "picture.png", encodePng(480, 320, framebuffer.readColor()));
console.log(`${stats.fragmentCount} fragments`);
