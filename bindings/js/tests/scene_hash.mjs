// SPDX-License-Identifier: MIT
// Pictures of the models of scene_files.mjs, in Node and in pages. scene_native.py draws the same ones.

export const MODELS = ["model.glb", "external.gltf", "moving.gltf", "square.obj"];

/** The hash FNV-1a of the picture of a scene. */
function hashOf(shd, context, scene) {
  const framebuffer = new shd.Framebuffer(context, { width: 96, height: 64, sampleCount: 4 });
  const [camera = { eye: [1, 1.5, 3], target: scene.bounds.center }] = scene.cameras;
  const frame = scene.fillRender({ framebuffer, camera, clearColor: [0.1, 0.2, 0.3, 1] });
  if (!frame.lights.length) {
    frame.lights = [new shd.Light(context, { kind: "directional", direction: [-0.5, -1, -2], intensity: [2, 2, 2] })];
  }
  shd.render(context, frame);
  let hash = 0xcbf29ce484222325n;
  for (const byte of framebuffer.readColor()) hash = ((hash ^ BigInt(byte)) * 0x100000001b3n) & 0xffffffffffffffffn;
  return hash.toString(16).padStart(16, "0");
}

/** Lines "name hash" of all models, and of a pose. */
export function hashLines(shd, context, files) {
  const lines = MODELS.map((name) => {
    const scene = new shd.Scene(context, files[name], { name, find: files });
    if (scene.warnings.length) throw new Error(scene.warnings.join("\n"));
    return `${name} ${hashOf(shd, context, scene)}`;
  });
  const posed = new shd.Scene(context, files["moving.gltf"]).pose("slide", 1.5);
  return [...lines, `pose ${hashOf(shd, context, posed)}`];
}
