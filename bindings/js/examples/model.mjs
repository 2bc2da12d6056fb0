// SPDX-License-Identifier: MIT
// A model file drawn to a PNG file: node model.mjs model.glb picture.png
import { readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join, normalize } from "node:path";
import { load } from "shd";
import { encodePng } from "./png.mjs";

const [path = "model.glb", picture = "picture.png"] = process.argv.slice(2);
const shd = await load();
const context = new shd.Context();

/** The bytes of a file that the model names, below the folder of the model. */
function find(name) {
  const inside = normalize(name);
  if (inside.startsWith("..") || inside.startsWith("/")) return null;
  try {
    return readFileSync(join(dirname(path), inside));
  } catch {
    return null;
  }
}

const scene = new shd.Scene(context, readFileSync(path), { name: basename(path), find });
for (const warning of scene.warnings) console.log(`warning: ${warning}`);
const camera = scene.cameras[0] ?? { eye: [1, 0.75, 2], aspect: 640 / 480 };  // a place from which the model is seen
const { boundsMin, boundsMax } = scene.info;
if (!scene.cameras.length) shd.call("shd_camera_frame_box", camera, boundsMin, boundsMax);
const framebuffer = new shd.Framebuffer(context, { width: 640, height: 480, sampleCount: 4 });
const frame = scene.fillRender({ framebuffer, camera, clearColor: [0.05, 0.07, 0.1, 1] });
if (!frame.lights.length) {
  frame.lights = [new shd.Light(context, { kind: "directional", direction: [-0.5, -1, -0.8], intensity: [2, 2, 2] }),
                  new shd.Light(context, { kind: "ambient", intensity: [0.3, 0.3, 0.3] })];
}
const stats = shd.render(context, frame);
writeFileSync(picture, encodePng(640, 480, framebuffer.readColor()));
console.log(`${scene.info.triangleCount} triangles, ${stats.fragmentCount} fragments`);
