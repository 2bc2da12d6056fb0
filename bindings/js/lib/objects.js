// SPDX-License-Identifier: MIT
// Classes of the objects. Their methods call the functions of C of the same names.
import { invoke } from "./call.js";
import { SharedObject } from "./object.js";
import { Lookup } from "./lookup.js";
import { refuse } from "./error.js";

const call = (object, name, ...values) => invoke(object.module, name, [object, ...values]);

/** The module of the context that an object is made in. */
export function moduleOf(context) {
  if (context?.kind !== "context") refuse("context", "the first argument is a Context");
  return context.module;
}

/** Owner of the log and memory of its objects. `new shd.Context(desc)` */
export class Context extends SharedObject {
  constructor(module, desc = {}) { super(module, "context", "shd_context_create", [desc]); }
  get simdTarget() { return call(this, "shd_context_get_simd_target"); }
  get workerCount() { return call(this, "shd_context_get_worker_count"); }
  trim() { call(this, "shd_context_trim"); }
}

/** Columns of `count` elements as one interleaved array: the first `width` ones of `all`. */
function readColumns(object, name, values, width, count, all = width) {
  const whole = new Float32Array(width * count);
  const columns = Array.from({ length: all }, (_, i) => (i < width ? { data: whole, offset: i, stride: width } : null));
  if (whole.length) call(object, name, ...values, columns);
  return whole;
}

const CHANNELS = 4;

export class Texture extends SharedObject {
  constructor(context, desc) { super(moduleOf(context), "texture", "shd_texture_create", [context, desc]); }
  /** A texture of an image file, or of a KTX2 or DDS file as it is stored. Options are the fields of LoadDesc. */
  static load(context, bytes, desc = {}) { return new LoadedTexture(context, bytes, desc); }
  get info() { return call(this, "shd_texture_get_info"); }
  /** Filtered values of lookups: `out.channel` has r, g, b and a. Without `out` new arrays are made. */
  sample(sampler, lookups, out = null) {
    const count = lookups.count ?? lookups.u?.length ?? 0;
    out ??= { channel: Array.from({ length: CHANNELS }, () => new Float32Array(count)) };
    call(this, "shd_texture_sample", sampler, lookups, out);
    return out;
  }
  /** A batch of lookups in the memory of WebAssembly that can be run many times. */
  lookup(sampler, lookups, out) { return new Lookup(this, sampler, lookups, out); }
  queryLevels(sampler, lookups, out = null) {
    const count = lookups.count ?? lookups.u?.length ?? 0;
    out ??= { lod: new Float32Array(count), level: new Uint32Array(count) };
    call(this, "shd_texture_query_levels", sampler, lookups, out);
    return out;
  }
  /** How the lookup `index` was filtered: level of detail, axes of the footprint, texels and their blends. */
  explain(sampler, lookups, index = 0) {
    const explain = (out) => { call(this, "shd_texture_explain", sampler, lookups, index, out); return out; };
    const { tapCount, blendCount } = explain({});
    const listOf = (length) => Array.from({ length }, () => ({}));
    return explain({ taps: listOf(tapCount), tapCapacity: tapCount,
                     blends: listOf(blendCount), blendCapacity: blendCount });
  }
  readLevel(layer, level, image) { call(this, "shd_texture_read_level", layer, level, image); return image; }
  /** Size and levels of what readTable() returns. */
  tableInfo(desc) { return call(this, "shd_texture_get_table_info", desc); }
  /** A level, the sums or the picture of a table: linear r, g, b, a as one array [height][width][4]. */
  readTable(desc) {
    const { width, height } = this.tableInfo(desc);
    return readColumns(this, "shd_texture_read_table", [desc], CHANNELS, width * height);
  }
  update(layer, x, y, image) { call(this, "shd_texture_update", layer, x, y, image); }
  loadTiles(region) { call(this, "shd_texture_load_tiles", region); }
  /** Loads the tiles of a region and keeps them until unpinTiles(). */
  pinTiles(region) { call(this, "shd_texture_pin_tiles", region); }
  unpinTiles(region) { call(this, "shd_texture_unpin_tiles", region); }
  /** Drops the tiles of a region, and the coarser tiles that cover it: their source has changed. */
  dropTiles(region) { call(this, "shd_texture_drop_tiles", region); }
}

/** Memory of a fixed size for the tiles of textures whose desc has `tiles: { cache, load }`. */
export class TileCache extends SharedObject {
  constructor(context, desc = {}) { super(moduleOf(context), "tile_cache", "shd_tile_cache_create", [context, desc]); }
  get stats() { return call(this, "shd_tile_cache_get_stats"); }
  /** Loads tiles that lookups with missingTiles: "coarser" did not find, 0 = all of them. Returns their number. */
  loadRequested(maxTiles = 0) { return call(this, "shd_tile_cache_load_requested", maxTiles); }
}

export class Sampler extends SharedObject {
  constructor(context, desc = {}) { super(moduleOf(context), "sampler", "shd_sampler_create", [context, desc]); }
}

const PARTS = { positions: 3, normals: 3, tangents: 4, uv: 2, uv1: 2 };

export class Mesh extends SharedObject {
  constructor(context, desc) { super(moduleOf(context), "mesh", "shd_mesh_create", [context, desc]); }
  /** A sphere, box, plane, torus or teapot. */
  static shape(context, desc, flags = 0) { return new ShapeMesh(context, desc, flags); }
  get info() { return call(this, "shd_mesh_get_info"); }
  /** positions, normals, tangents, uv or uv1 as one interleaved array. */
  read(part) {
    if (!PARTS[part]) refuse("part", `${part} is none of ${Object.keys(PARTS).join(", ")}`);
    return readColumns(this, `shd_mesh_read_${part}`, [], PARTS[part], this.info.vertexCount);
  }
  readAttribute(index) { return readColumns(this, "shd_mesh_read_attribute", [index], 1, this.info.vertexCount); }
  readIndices() {
    const out = new Uint32Array(3 * this.info.triangleCount);
    call(this, "shd_mesh_read_indices", out);
    return out;
  }
  tessellate(context, desc) { return new TessellatedMesh(context, this, desc); }
}

class ShapeMesh extends SharedObject {
  constructor(context, desc, flags) {
    super(moduleOf(context), "mesh", "shd_mesh_create_shape", [context, desc, flags]);
  }
}
class TessellatedMesh extends SharedObject {
  constructor(context, mesh, desc) {
    super(moduleOf(context), "mesh", "shd_mesh_tessellate", [context, mesh, desc]);
  }
}
class LoadedTexture extends SharedObject {
  constructor(context, bytes, desc) {
    super(moduleOf(context), "texture", "shd_texture_load_memory", [context, bytes, desc]);
  }
}
// Their methods are those of other meshes and textures; only their constructors differ.
for (const made of [ShapeMesh, TessellatedMesh]) Object.setPrototypeOf(made.prototype, Mesh.prototype);
Object.setPrototypeOf(LoadedTexture.prototype, Texture.prototype);

/** Another reference to an object of C, such as a mesh of a scene. */
export function borrow(type, module, kind, handle) {
  return Object.setPrototypeOf(new SharedObject(module, kind, handle), type.prototype);
}

export class Material extends SharedObject {
  constructor(context, desc = {}) { super(moduleOf(context), "material", "shd_material_create", [context, desc]); }
}

export class Light extends SharedObject {
  constructor(context, desc = {}) { super(moduleOf(context), "light", "shd_light_create", [context, desc]); }
}

export class Environment extends SharedObject {
  constructor(context, desc) { super(moduleOf(context), "environment", "shd_environment_create", [context, desc]); }
  get info() { return call(this, "shd_environment_get_info"); }
  sampleIrradiance(lookups, out) { call(this, "shd_environment_sample_irradiance", lookups, out); return out; }
  sampleRadiance(lookups, out) { call(this, "shd_environment_sample_radiance", lookups, out); return out; }
}

export class Shadow extends SharedObject {
  constructor(context, desc = {}) { super(moduleOf(context), "shadow", "shd_shadow_create", [context, desc]); }
  render(context, desc) { invoke(this.module, "shd_shadow_render", [context, this, desc]); }
  get info() { return call(this, "shd_shadow_get_info"); }
  /** A face of the map: depths [height][width], or moments or sums [height][width][2]. */
  readMap(face = 0) {
    const { filter, width, height } = this.info;
    const columns = filter.endsWith("variance") ? 2 : 1;
    return readColumns(this, "shd_shadow_read_map", [face], columns, width * height, 2);
  }
  sample(lookups, out) { call(this, "shd_shadow_sample", lookups, out); return out; }
}

/** A closed mesh of triangles as a cage, for coordinates of points. */
export class Polyhedron extends SharedObject {
  #vertexCount;
  constructor(context, desc) {
    if (typeof desc?.vertexCount !== "number") refuse("desc.vertexCount", "the number of vertices is missing");
    super(moduleOf(context), "polyhedron", "shd_polyhedron_create", [context, desc]);
    this.#vertexCount = desc.vertexCount;
  }
  get vertexCount() { return this.#vertexCount; }
  /** The coordinates of points: `out.weight` has a column for each vertex. */
  evaluate(points, out) { call(this, "shd_polyhedron_evaluate", points, out); return out; }
  /** Values of the vertices at points: `out.vertexValue` are read, and `out.value` is written. */
  interpolate(points, out) { call(this, "shd_polyhedron_interpolate", points, out); return out; }
}

export class Volume extends SharedObject {
  constructor(context, desc) { super(moduleOf(context), "volume", "shd_volume_create", [context, desc]); }
}
