// SPDX-License-Identifier: MIT
#include "io/container/texture_file.h"

#include <algorithm>

#include "core/failure.h"
#include "io/bitmap/levels.h"

namespace shd::io {

namespace {

constexpr uint64_t kMaxLayers = 2048;

void check_side(const char* file, const char* name, uint64_t value, uint64_t most) {
  if (value > most) core::refuse(SHD_ERROR_LIMIT, "%s: %s %llu is above %llu", file, name, wide(value), wide(most));
}

/// Kinds of texture that shd has.
void check_kind(const char* file, const TextureFile& parsed) {
  const shd_texture_file_info& info = parsed.info;
  if (info.width == 0 || info.height == 0) {
    core::refuse(SHD_ERROR_CORRUPT, "%s: %u x %u texels", file, info.width, info.height);
  }
  if (info.face_count != 1 && info.face_count != 6) {
    core::refuse(SHD_ERROR_CORRUPT, "%s: %zu faces, not 1 or 6", file, info.face_count);
  }
  if (info.face_count == 6 && (info.width != info.height || info.depth != 0)) {
    core::refuse(SHD_ERROR_CORRUPT, "%s: a cube map of %u x %u texels and %u slices", file, info.width, info.height,
                 info.depth);
  }
  if (info.depth != 0 && info.layer_count != 1) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "%s: an array of 3D textures", file);
  }
}

/// Bytes of all levels and images of the texture. Cannot overflow: at most 2^56 texels of 16 bytes in the base, and
/// less than three times as many in all levels.
uint64_t texture_bytes(const TextureFile& parsed) {
  uint64_t bytes = 0;
  for (uint32_t l = 0; l < parsed.info.level_count; ++l) bytes += uint64_t{unpacked_size(parsed, l)} * parsed.images;
  return bytes;
}

}  // namespace

uint64_t image_size(const TextureFile& parsed, uint32_t level) {
  const Storage& storage = parsed.storage;
  const shd_texture_file_info& info = parsed.info;
  const uint64_t columns = (level_side(info.width, level) + storage.block_width - 1) / storage.block_width;
  const uint64_t rows = (level_side(info.height, level) + storage.block_height - 1) / storage.block_height;
  return columns * rows * level_side(info.depth, level) * storage.unit_size;
}

size_t unpacked_size(const TextureFile& parsed, uint32_t level) {
  TextureFile unpacked;
  unpacked.info = parsed.info;
  unpacked.storage = plain_storage(parsed.storage.format);
  return static_cast<size_t>(image_size(unpacked, level));
}

uint32_t whole_level_count(const shd_texture_file_info& info) {
  return full_level_count(std::max(info.width, info.depth), info.height);
}

void check_sizes(const char* file, const Limits& limits, TextureFile* parsed) {
  const shd_texture_file_info& info = parsed->info;
  check_side(file, "width", info.width, limits.side);
  check_side(file, "height", info.height, limits.side);
  check_side(file, "depth", info.depth, kMaxSide);
  check_kind(file, *parsed);
  if (info.layer_count == 0) core::refuse(SHD_ERROR_CORRUPT, "%s: no layers", file);
  const uint64_t images = uint64_t{info.layer_count} * info.face_count;
  if (images > kMaxLayers * (info.face_count == 6 ? 6 : 1)) {
    core::refuse(SHD_ERROR_LIMIT, "%s: %zu layers are above %llu", file, info.layer_count, wide(kMaxLayers));
  }
  parsed->images = static_cast<uint32_t>(images);
  // A texture has one cube map of an array.
  const uint64_t slices = std::max(info.depth, 1u);
  const uint64_t slice = uint64_t{info.width} * info.height;
  const uint64_t read = slice * slices * (info.face_count == 6 ? 6 : info.layer_count);  // at most 2^56
  const uint64_t all = slice * slices * images;
  if (read > limits.texels) core::refuse(SHD_ERROR_LIMIT, "%s: %llu texels are above 2^28", file, wide(read));
  if (all > limits.pixels) {
    core::refuse(SHD_ERROR_LIMIT, "%s: %llu texels are above load.max_pixels %llu", file, wide(all),
                 wide(limits.pixels));
  }
  if (info.level_count == 0 || info.level_count > whole_level_count(info)) {
    core::refuse(SHD_ERROR_CORRUPT, "%s: %zu levels, not 1..%u for %u x %u x %u texels", file, info.level_count,
                 whole_level_count(info), info.width, info.height, std::max(info.depth, 1u));
  }
  const uint64_t bytes = texture_bytes(*parsed);
  if (bytes > limits.bytes) {
    core::refuse(SHD_ERROR_LIMIT, "%s: %llu bytes of texels are above load.max_bytes %llu", file, wide(bytes),
                 wide(limits.bytes));
  }
}

TextureFile parse_texture_file(const unsigned char* bytes, size_t size, shd_color_encoding encoding, bool partial,
                               const Limits& limits, uint64_t behind) {
  const ByteReader in{bytes, size, false, true, behind};
  TextureFile parsed;
  if (is_ktx2(bytes, size)) {
    parsed = parse_ktx2(in, encoding, limits);
  } else if (is_dds(bytes, size)) {
    parsed = parse_dds(in, encoding, partial, limits);
  } else {
    core::refuse(SHD_ERROR_UNSUPPORTED, "the file is neither KTX 2.0 nor DDS");
  }
  const uint64_t unpacked = texture_bytes(parsed);
  if (unpacked > kRatioFloor && static_cast<double>(unpacked) > limits.ratio * static_cast<double>(in.file_size())) {
    core::refuse(SHD_ERROR_LIMIT, "%llu bytes of texels from %llu are above load.max_ratio %g", wide(unpacked),
                 wide(in.file_size()), limits.ratio);
  }
  return parsed;
}

}  // namespace shd::io
