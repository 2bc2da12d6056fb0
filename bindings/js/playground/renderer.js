// SPDX-License-Identifier: MIT
// Draws descriptions with shd. Objects that do not change from frame to frame are kept.
import { Cache } from "./cache.js";
import { textureOf } from "./textures.js";

const AOVS = { shaded: "none", level: "level", anisotropy: "derivatives" };

export class Renderer {
  #shd;
  #context;
  #cache = new Cache();
  #shadow = { key: "", object: null };
  #last = null;
  constructor(shd) {
    this.#shd = shd;
    this.#context = new shd.Context();
    this.#shadow.object = new shd.Shadow(this.#context, { size: 1024, filter: "pcf", taps: 3 });
  }

  /** Draws rows of a description, by default all. `view` and `inspect` choose the planes beside colour. */
  draw(scene, view = "shaded", inspect = false, [top, bottom] = [0, scene.height]) {
    const [shd, context, cache] = [this.#shd, this.#context, this.#cache];
    const aovs = inspect ? "uv|derivatives|level|draw" : AOVS[view];
    const size = { width: scene.width, height: scene.height, sampleCount: scene.samples, colorFormat: "rgba8_srgb", aovs };
    const framebuffer = cache.get("framebuffer", size, () => new shd.Framebuffer(context, size));
    const { id, width, height, texels } = textureOf(scene.texture);
    const texture = cache.get("texture", [scene.texture, id], () => new shd.Texture(context, {
      format: "rgba8_srgb", width, height, texels, tables: "mipmap" }));
    const lights = scene.lights.map((desc) => cache.get("light", desc, () => new shd.Light(context, desc)));
    const samplers = scene.samplers.map((desc) => cache.get("sampler", desc, () => new shd.Sampler(context, desc)));
    const sides = samplers.map((sampler, i) => this.#draws(scene, texture, sampler, [scene.samplers[i], id]));
    const frame = { framebuffer, camera: scene.camera, clearColor: scene.clearColor, lights };
    if (scene.shadow) frame.shadows = [this.#shadowOf(scene, lights[0], sides[1]), ...lights.slice(1).map(() => null)];
    const start = performance.now();
    let fragments = 0;
    for (const [side, x, end] of [[0, 0, scene.splitAt], [1, scene.splitAt, scene.width]]) {
      if (x === end || top >= bottom) continue;
      const scissor = { x, y: top, width: end - x, height: bottom - top };
      fragments += shd.render(context, { ...frame, draws: sides[side], scissor }).fragmentCount;
    }
    const milliseconds = performance.now() - start;
    cache.sweep();
    this.#last = { scene, framebuffer, texture, samplers, inspect };
    return { milliseconds, fragments };
  }

  #draws(scene, texture, sampler, made) {
    const [shd, context, cache] = [this.#shd, this.#context, this.#cache];
    return scene.draws.map(({ mesh, material, objectToWorld }) => {
      const { uvTransform, ...desc } = material;
      const key = { material, texture: scene.texture, made };
      const slots = [{ target: "diffuse", texture, sampler, uvTransform }];
      return {
        mesh: cache.get("mesh", mesh, () => shd.Mesh.shape(context, mesh)),
        material: cache.get("material", key, () => new shd.Material(context, { ...desc, slots })),
        objectToWorld,
      };
    });
  }

  #shadowOf(scene, light, draws) {
    const key = JSON.stringify([scene.lights[0], scene.draws.map((d) => [d.mesh, d.objectToWorld])]);
    if (key !== this.#shadow.key) {
      this.#shadow.object.render(this.#context, { light, draws, boundsMin: [-4, 0, -4], boundsMax: [4, 3, 4] });
      this.#shadow.key = key;
    }
    return this.#shadow.object;
  }

  /** The pixels of the last frame, as ImageData has them. */
  readColor(out = null) {
    return this.#last.framebuffer.readColor("rgba8_srgb", out);
  }
  readPlane(plane) {
    return this.#last.framebuffer.readPlane(plane);
  }

  /** The footprint of a pixel of the last frame in the texture, or null beside the objects. */
  footprint(x, y) {
    const { scene, framebuffer, texture, samplers, inspect } = this.#last;
    const side = x < scene.splitAt ? 0 : 1;
    const at = y * scene.width + x;
    if (!inspect || framebuffer.readPlane("depth")[at] >= 1) return null;
    const read = (plane) => framebuffer.readPlane(plane)[at];
    const [su, , , , sv] = scene.draws[read("draw")].material.uvTransform;
    const column = (plane, scale) => [read(plane) * scale];
    const lookups = { u: column("u", su), v: column("v", sv), dudx: column("dudx", su), dvdx: column("dvdx", sv),
                      dudy: column("dudy", su), dvdy: column("dvdy", sv) };
    const explanation = texture.explain(samplers[side], lookups);
    return { u: lookups.u[0], v: lookups.v[0], side: side ? "B" : "A", filter: explanation.filter,
             lod: explanation.lod, taps: explanation.tapCount, longer: explanation.longerAxis,
                 shorter: explanation.shorterAxis,
             colour: explanation.result };
  }
}
