// SPDX-License-Identifier: MIT
import { enums, structs } from "./api.js";
import { invoke } from "./call.js";
import { SharedObject } from "./object.js";
import { refuse } from "./error.js";

/** Arrays of the formats of pixels, and their channels. */
export const PIXELS = {
  rgba8: [Uint8ClampedArray, 4], rgba8_srgb: [Uint8ClampedArray, 4], rgba16: [Uint16Array, 4],
  rgba16f: [Uint16Array, 4], rgba32f: [Float32Array, 4],
};
const WORDS = new Set(["triangle", "level", "draw", "overdraw"]);

/** Colour, depth and other planes of a picture. */
export class Framebuffer extends SharedObject {
  #info;
  constructor(context, desc) {
    if (context?.kind !== "context") refuse("context", "the first argument is a Context");
    super(context.module, "framebuffer", "shd_framebuffer_create", [context, desc]);
    this.#info = invoke(this.module, "shd_framebuffer_get_info", [this]);
  }
  get info() {
    this.reference("framebuffer");
    return { ...this.#info };
  }
  /** Pixels [height][width][4], by default bytes for ImageData. `out` may be an array of an earlier call. */
  readColor(format = "rgba8_srgb", out = null) {
    const [type, channels] = PIXELS[format]
        ?? refuse("format", `${format} is none of ${Object.keys(PIXELS).join(", ")}`);
    const { width, height } = this.#info;
    out ??= new type(width * height * channels);
    invoke(this.module, "shd_framebuffer_read_color", [this, { format, width, height, pixels: out }]);
    return out;
  }
  /** A copy of a plane, [height][width]: "depth", "lod", "nx", "triangle", ... */
  readPlane(plane) {
    const { width, height } = this.#info;
    const isWords = WORDS.has(plane);
    const out = new (isWords ? Uint32Array : Float32Array)(width * height);
    invoke(this.module, `shd_framebuffer_read_${isWords ? "u32_" : ""}plane`, [this, plane, out]);
    return out;
  }
  /** A plane without a copy: {array, rowStride in elements}, valid until the memory grows or the framebuffer closes. */
  viewPlane(plane) {
    const { memory, raw } = this.module;
    if (enums.plane[plane] === undefined) refuse("plane", `${plane} is none of ${Object.keys(enums.plane).join(", ")}`);
    this.reference("framebuffer");
    const { rowStride } = invoke(this.module, "shd_framebuffer_view_plane", [this, plane]);
    const mark = memory.mark();
    const fields = structs.plane_view.fields;
    const address = memory.scratch(structs.plane_view.size);
    memory.fill(address, structs.plane_view.size);
    memory.view.setUint32(address, structs.plane_view.size, true);
    raw.shd_framebuffer_view_plane(this.reference("framebuffer").handle, enums.plane[plane], address);
    const [f32, u32] = [fields.f32[0], fields.u32[0]].map((offset) => memory.view.getUint32(address + offset, true));
    memory.release(mark);
    const length = (rowStride / 4) * (this.#info.height - 1) + this.#info.width;
    return { array: memory.array(f32 ? Float32Array : Uint32Array, f32 || u32, length), rowStride: rowStride / 4 };
  }
}
