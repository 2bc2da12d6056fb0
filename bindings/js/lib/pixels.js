// SPDX-License-Identifier: MIT
// Arrays of pixels have the size that their struct states.
import { enums } from "./api.js";
import { refuse } from "./error.js";

/** Slices, faces or layers of a texture; an image has none of the fields. */
function imagesOf(read) {
  const is3d = read("kind") === enums.texture_kind["3d"];
  return Math.max(1, read(is3d ? "depth" : "layerCount"));
}

/** Bytes of an image or of the texels of a texture: rows of texels, or of compressed blocks of 4 x 4 texels. */
function bytesNeeded(read, raw) {
  // A module of an earlier build has no such function, and refuses compressed blocks itself.
  const block = raw.shd_format_block_size?.(read("format")) ?? 0, side = block ? 4 : 1;
  const packed = Math.ceil(read("width") / side) * (block || raw.shd_format_size(read("format")));
  const rows = Math.ceil(read("height") / side), row = read("rowStride") || packed;
  return (read("layerStride") || row * rows) * (imagesOf(read) - 1) + row * (rows - 1) + packed;
}

/** Compares the length of `pixels` or `texels` with the width, height, layers and strides of a struct. */
export function checkPixels(call, struct, address, data, label) {
  const name = struct.name === "image" ? "pixels" : struct.name === "texture_desc" ? "texels" : "";
  const placed = data.get(name);
  if (!placed) return;
  const read = (key) => {
    const field = struct.fields.get(key);
    return field ? call.memory.view.getUint32(address + field.offset, true) : 0;
  };
  const needed = bytesNeeded(read, call.module.raw);
  if (read("width") && read("height") && placed.bytes < needed) {
    refuse(`${label}.${name}`, `${placed.bytes} bytes, fewer than the ${needed} of its format, width and height`);
  }
  if (name === "texels" && read("flags") & 1) {
    if (!placed.allocation) refuse(`${label}.texels`, "borrowed texels must be an Allocation");
    call.pinned.push(placed.allocation);
  }
}
