// SPDX-License-Identifier: MIT
// Arrays of pixels have the size that their struct states.
import { refuse } from "./error.js";

/** Bytes of an image or of the texels of a texture. */
function bytesNeeded(read, texel) {
  const row = read("rowStride") || read("width") * texel;
  const image = row * (read("height") - 1) + read("width") * texel;
  const layers = Math.max(1, read("layers")) * Math.max(1, read("depth"));
  return (read("layerStride") || row * read("height")) * (layers - 1) + image;
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
  const texel = call.module.raw.shd_format_size(read("format"));
  const needed = bytesNeeded(read, texel);
  if (read("width") && read("height") && placed.bytes < needed) {
    refuse(`${label}.${name}`, `${placed.bytes} bytes, fewer than the ${needed} of its format, width and height`);
  }
  if (name === "texels" && read("flags") & 1) {
    if (!placed.allocation) refuse(`${label}.texels`, "borrowed texels must be an Allocation");
    call.pinned.push(placed.allocation);
  }
}
