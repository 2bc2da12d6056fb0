// SPDX-License-Identifier: MIT
// Model files: meshes, materials, textures, lights and cameras, as objects of the library.
import { invoke } from "./call.js";
import { refuse } from "./error.js";
import { SharedObject } from "./object.js";
import { Light, Material, Mesh, Texture, borrow, moduleOf } from "./objects.js";

const KINDS = { mesh: Mesh, material: Material, texture: Texture, light: Light };

/** Objects of the scenes that are in use. They close with their scene. */
const parts = new WeakMap();

const list = (count, make) => Array.from({ length: count }, (_, i) => make(i));
const call = (scene, name, ...values) => invoke(scene.module, `shd_scene_${name}`, [scene, ...values]);

/** The objects of a kind, made when they are first used. */
function objectsOf(scene, kind) {
  const known = parts.get(scene) ?? parts.set(scene, {}).get(scene);
  known[kind] ??= list(scene.info[`${kind}Count`],
                       (i) => borrow(KINDS[kind], scene.module, kind, call(scene, `get_${kind}`, i) >>> 0));
  return [...known[kind]];
}

/**
 * The contents of a model file: `new shd.Scene(context, bytes, options)`. Options are the fields of SceneDesc, and
 * `name`, the name of the file, for formats without a mark of their own.
 */
export class Scene extends SharedObject {
  constructor(context, bytes, { name = "", ...desc } = {}) {
    super(moduleOf(context), "scene", "shd_scene_load_memory", [context, bytes, name, desc]);
    this.reference("scene").endFunctions();
  }
  /** Counts and bounds. */
  get info() { return call(this, "get_info"); }
  /** Parts of the file that were left out or changed, one text each. */
  get warnings() { return list(this.info.warningCount, (i) => call(this, "get_warning", i)); }
  /** The box around all instances, its centre, and half of its diagonal. */
  get bounds() {
    const { boundsMin: min, boundsMax: max } = this.info;
    return { min, max, center: min.map((low, i) => (low + max[i]) / 2),
             radius: Math.hypot(...min.map((low, i) => max[i] - low)) / 2 };
  }
  get meshes() { return objectsOf(this, "mesh"); }
  get materials() { return objectsOf(this, "material"); }
  get textures() { return objectsOf(this, "texture"); }
  get lights() { return objectsOf(this, "light"); }
  get cameras() { return list(this.info.cameraCount, (i) => call(this, "get_camera", i)); }
  get instances() { return list(this.info.instanceCount, (i) => call(this, "get_instance", i)); }
  /** The instances as draws of a frame. */
  get draws() {
    const { meshes, materials } = this;
    return this.instances.map(({ mesh, material, objectToWorld, cull }) => (
      { mesh: meshes[mesh], material: materials[material], objectToWorld, cull }));
  }
  /** Sets the draws and lights of a frame to those of the file, and returns it. */
  fillRender(frame = {}) { return Object.assign(frame, { draws: this.draws, lights: this.lights }); }
  /** The names of the parts of a kind: "mesh", "material", "texture", "light", "camera" or "animation". */
  names(part) {
    const count = this.info[`${part}Count`];
    if (count === undefined || !/^(mesh|material|texture|light|camera|animation)$/.test(part)) {
      refuse("part", `${part} is none of mesh, material, texture, light, camera, animation`);
    }
    return list(count, (i) => call(this, "get_name", part, i));
  }
  /** The first and the last key of an animation [s]. */
  animationTimes(index) {
    const { first, last } = call(this, "get_animation_times", index);
    return [first, last];
  }
  /** A scene of the file at a time of an animation, given by its number or its name. */
  pose(animation, seconds) {
    if (typeof animation !== "string") return new PosedScene(this, animation, seconds);
    const index = this.names("animation").indexOf(animation);
    if (index < 0) refuse("animation", `"${animation}" is not one of ${JSON.stringify(this.names("animation"))}`);
    return new PosedScene(this, index, seconds);
  }
  close() {
    for (const object of Object.values(parts.get(this) ?? {}).flat()) object.close();
    parts.delete(this);
    super.close();
  }
}

class PosedScene extends SharedObject {
  constructor(scene, animation, seconds) {
    super(scene.module, "scene", "shd_scene_pose", [scene, animation, seconds]);
  }
}
Object.setPrototypeOf(PosedScene.prototype, Scene.prototype);
