// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <optional>

#include "core/failure.h"
#include "image/format.h"
#include "io/bitmap/levels.h"
#include "io/bitmap/raw_voxels.h"
#include "io/container/astc.h"
#include "io/container/inflate.h"
#include "io/container/texture_file.h"

namespace shd::io {

namespace {

/// Whether the stored bytes are the texels.
bool is_stored_as_is(const TextureFile& parsed, const Selection& selection) {
  const bool wide_numbers = image::format_info(parsed.storage.format).channel_size > 1;
  const bool swapped_bytes = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__ && wide_numbers;
  return parsed.info.supercompression == SHD_SUPERCOMPRESSION_NONE && parsed.storage.unpack == Unpack::kNone &&
         !selection.flip_rows && !swapped_bytes;
}

/// Whether levels can be read where they are in the file.
bool is_aligned(const TextureFile& parsed, const unsigned char* bytes, uint32_t level_count) {
  const size_t alignment = std::max<size_t>(image::format_info(parsed.storage.format).channel_size, 1);
  for (uint32_t l = 0; l < level_count; ++l) {
    const uintptr_t address = reinterpret_cast<uintptr_t>(bytes) + parsed.levels[l].offset;
    if (address % alignment != 0 || parsed.image_stride[l] % alignment != 0) return false;
  }
  return true;
}

void swap_red_blue(size_t count, size_t channels, bool opaque, unsigned char* pixels) {
  for (unsigned char* pixel = pixels; pixel != pixels + count * channels; pixel += channels) {
    std::swap(pixel[0], pixel[2]);
    if (opaque) pixel[3] = 255;
  }
}

/// A bit field as a code of 8 bits, rounded to the nearest; 0 for no field, 255 for alpha without one.
unsigned char field_of(uint32_t pixel, uint32_t mask, bool alpha) {
  if (mask == 0) return alpha ? 255 : 0;
  const uint32_t most = mask >> __builtin_ctz(mask);
  const uint32_t value = (pixel & mask) >> __builtin_ctz(mask);
  return static_cast<unsigned char>((value * 255 + most / 2) / most);
}

void unpack_masks(const Storage& storage, size_t count, const unsigned char* in, unsigned char* out) {
  for (size_t i = 0; i < count; ++i, in += storage.unit_size, out += 4) {
    uint32_t pixel = 0;
    for (uint32_t b = 0; b < storage.unit_size; ++b) pixel |= uint32_t{in[b]} << 8 * b;
    for (int c = 0; c < 4; ++c) out[c] = field_of(pixel, storage.masks[c], c == 3);
  }
}

/// Unpacks the images of a selection, one after the other.
class Unpacker {
 public:
  Unpacker(const TextureFile& parsed, const Selection& selection, const Deadline& deadline)
      : parsed_(parsed), selection_(selection), deadline_(deadline) {
    if (parsed.storage.unpack == Unpack::kAstc) astc_.emplace(parsed.storage);
  }

  /// One image of a level, from stored to texels. `in` may be `out` if both have one size.
  void run(uint32_t level, const unsigned char* in, unsigned char* out) {
    deadline_.check();
    const uint32_t width = level_side(parsed_.info.width, level), height = level_side(parsed_.info.height, level);
    const uint32_t depth = level_side(parsed_.info.depth, level);
    const size_t size = unpacked_size(parsed_, level), stored = static_cast<size_t>(image_size(parsed_, level));
    const size_t pixels = size_t{width} * height * depth;
    switch (parsed_.storage.unpack) {
      case Unpack::kMasks: unpack_masks(parsed_.storage, pixels, in, out); break;
      case Unpack::kAstc:
        for (uint32_t z = 0; z < depth; ++z) {
          astc_->decode(in + stored / depth * z, width, height, out + size / depth * z);
        }
        break;
      default:
        if (in != out) std::memcpy(out, in, size);
        break;
    }
    if (parsed_.storage.unpack == Unpack::kSwapRgb) swap_red_blue(pixels, 3, false, out);
    if (parsed_.storage.unpack == Unpack::kSwapRgba) swap_red_blue(pixels, 4, false, out);
    if (parsed_.storage.unpack == Unpack::kSwapRgbx) swap_red_blue(pixels, 4, true, out);
    order_numbers(size, out);
    if (selection_.flip_rows) flip_rows(size / depth / height, height, depth, out);
  }

 private:
  /// The numbers of a file are little-endian.
  void order_numbers(size_t size, unsigned char* pixels) {
    const size_t number = image::format_info(parsed_.storage.format).channel_size;
    if (parsed_.storage.unpack != Unpack::kNone || number < 2) return;
    order_bytes(SHD_BYTE_ORDER_LITTLE, number == 2 ? SHD_RAW_SAMPLE_U16 : SHD_RAW_SAMPLE_F32, size / number, pixels);
  }

  const TextureFile& parsed_;
  const Selection& selection_;
  const Deadline& deadline_;
  std::optional<AstcDecoder> astc_;
};

/// The stored images of a level, decompressed into `out` if they fit there as they are, else into *memory.
const unsigned char* read_level(const TextureFile& parsed, uint32_t level, const unsigned char* bytes,
                                const Selection& selection, const Memory& allocator, unsigned char* out,
                                Buffer* memory) {
  const Span span = parsed.levels[level];
  const size_t image = static_cast<size_t>(parsed.image_stride[level]);
  const size_t first = selection.first_image * image;
  if (parsed.info.supercompression == SHD_SUPERCOMPRESSION_NONE) return bytes + span.offset + first;
  const size_t size = static_cast<size_t>(image_size(parsed, level) * parsed.images);
  const bool fits = selection.image_count == parsed.images && parsed.storage.unpack != Unpack::kAstc;
  if (!fits) *memory = Buffer(allocator, size);
  unsigned char* const to = fits ? out : memory->data();
  inflate_level(parsed.info.supercompression, bytes + span.offset, static_cast<size_t>(span.size), to, size);
  return to + first;
}

}  // namespace

TextureTexels unpack_levels(const TextureFile& parsed, const unsigned char* bytes, const Selection& selection,
                            const Limits& limits, const Memory& memory) {
  TextureTexels out;
  if (is_stored_as_is(parsed, selection) && is_aligned(parsed, bytes, selection.level_count)) {
    for (uint32_t l = 0; l < selection.level_count; ++l) {
      const size_t stride = static_cast<size_t>(parsed.image_stride[l]);
      out.levels[l] = {bytes + parsed.levels[l].offset + selection.first_image * stride, stride};
    }
    return out;
  }
  const Deadline deadline(limits.seconds);
  Unpacker unpacker(parsed, selection, deadline);
  size_t size = 0;
  for (uint32_t l = 0; l < selection.level_count; ++l) size += unpacked_size(parsed, l) * selection.image_count;
  out.memory = Buffer(memory, size);
  unsigned char* to = out.memory.data();
  for (uint32_t l = 0; l < selection.level_count; ++l) {
    const size_t image = unpacked_size(parsed, l);
    Buffer inflated;
    const unsigned char* const from = read_level(parsed, l, bytes, selection, memory, to, &inflated);
    out.levels[l] = {to, image};
    for (uint32_t i = 0; i < selection.image_count; ++i, to += image) {
      unpacker.run(l, from + i * parsed.image_stride[l], to);
    }
  }
  return out;
}

}  // namespace shd::io
