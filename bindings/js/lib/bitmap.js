// SPDX-License-Identifier: MIT
import { structs } from "./api.js";
import { invoke } from "./call.js";
import { PIXELS } from "./framebuffer.js";
import { SharedObject } from "./object.js";
import { moduleOf } from "./objects.js";

/** The pixels of an image file, without conversion. `new shd.Bitmap(context, bytes)` */
export class Bitmap extends SharedObject {
  constructor(context, bytes, desc = {}) {
    super(moduleOf(context), "bitmap", "shd_bitmap_load_memory", [context, bytes, desc]);
  }
  get #image() { return invoke(this.module, "shd_bitmap_get_image", [this]); }
  get format() { return this.#image.format; }
  get width() { return this.#image.width; }
  get height() { return this.#image.height; }
  /** File format, channels in the file and flags. */
  get info() { return invoke(this.module, "shd_bitmap_get_info", [this]); }
  /** The colour space of the pixels, such as "sRGB". */
  get colorSpace() { return invoke(this.module, "shd_bitmap_get_color_space", [this]); }
  /** A copy of the pixels, [height][width][4]. */
  readPixels() {
    const { format, width, height } = this.#image;
    const { memory, raw } = this.module;
    const mark = memory.mark(), { size, fields } = structs.image;
    const address = memory.scratch(size);
    memory.fill(address, size);
    memory.view.setUint32(address, size, true);
    raw.shd_bitmap_get_image(this.reference("bitmap").handle, address);
    const pixels = memory.view.getUint32(address + fields.pixels[0], true);
    memory.release(mark);
    const [type, channels] = PIXELS[format];
    return memory.array(type, pixels, width * height * channels).slice();
  }
}
