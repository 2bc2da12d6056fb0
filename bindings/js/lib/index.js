// SPDX-License-Identifier: MIT
// shd for JavaScript: `const shd = await load()`.
import { Callbacks } from "./callback.js";
import { instantiate } from "./instance.js";
import { makeShd } from "./module.js";

/** Loads shd.wasm, by default the file beside this module. `source` is a URL, a path, bytes or a WebAssembly.Module. */
export async function load(source) {
  const callbacks = new Callbacks();
  return makeShd(callbacks, await instantiate(source, callbacks.imports()));
}

export { Environment, Light, Material, Mesh, Polyhedron, Sampler, Shadow, Texture, TileCache, Volume } from "./objects.js";
export { Bitmap } from "./bitmap.js";
export { Framebuffer } from "./framebuffer.js";
export { Scene } from "./scene.js";
export { ShdError } from "./error.js";
