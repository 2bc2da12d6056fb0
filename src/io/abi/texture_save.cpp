// SPDX-License-Identifier: MIT
#include <shd/texture_file.h>

#include <algorithm>
#include <vector>

#include "core/read_desc.h"
#include "image/format.h"
#include "io/abi/common.h"
#include "io/bitmap/levels.h"
#include "io/container/inflate.h"
#include "io/container/ktx2_write.h"
#include "io/file/write_file.h"

namespace {

using namespace shd;
using namespace shd::extension;

shd_ktx2_desc read_ktx2_desc(const shd_ktx2_desc* in) {
  shd_ktx2_desc desc = shd_ktx2_desc_default();
  read_desc("ktx2", in, &desc);
  const uint32_t scheme = core::enum_bits(desc.supercompression);
  if (scheme > SHD_SUPERCOMPRESSION_ZLIB) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "ktx2.supercompression: %u is not a shd_supercompression", scheme);
  }
  const int32_t most = io::most_effort(desc.supercompression);
  if (desc.supercompression != SHD_SUPERCOMPRESSION_NONE && most == 0) {
    refuse(
        SHD_ERROR_UNSUPPORTED,
        "ktx2.supercompression: %u, but this libshd_io was built without its library (Debian: libzstd-dev, zlib1g-dev)",
        scheme);
  }
  if (desc.effort < 0 || desc.effort > most) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "ktx2.effort: %d is not in 0..%d", desc.effort, most);
  }
  if (desc.channel_count != 0 && desc.channel_count != 3) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "ktx2.channel_count: %zu is not 0 or 3", desc.channel_count);
  }
  return desc;
}

/// The format with the first three channels of four.
shd_format three_channels(shd_format format) {
  switch (format) {
    case SHD_FORMAT_RGBA8: return SHD_FORMAT_RGB8;
    case SHD_FORMAT_RGBA8_SRGB: return SHD_FORMAT_RGB8_SRGB;
    case SHD_FORMAT_RGBA16: return SHD_FORMAT_RGB16;
    case SHD_FORMAT_RGBA16F: return SHD_FORMAT_RGB16F;
    case SHD_FORMAT_RGBA32F: return SHD_FORMAT_RGB32F;
    default:
      refuse(SHD_ERROR_INVALID_ARGUMENT,
             "ktx2.channel_count: 3, but format %d of the texture has no four channels of "
             "pixels",
             static_cast<int>(format));
  }
}

/// Removes the fourth channel of `pixels` behind `first`.
void drop_alpha(size_t pixel_size, size_t first, std::vector<unsigned char>* pixels) {
  const size_t kept = pixel_size / 4 * 3;
  unsigned char* to = pixels->data() + first;
  for (const unsigned char* from = to; from != pixels->data() + pixels->size(); from += pixel_size, to += kept) {
    std::copy(from, from + kept, to);
  }
  pixels->resize(static_cast<size_t>(to - pixels->data()));
}

/// All images of a level.
std::vector<unsigned char> read_images(const shd_texture* texture, const shd_texture_info& info, uint32_t level,
                                       bool without_alpha) {
  shd_image image = shd_image_default();
  image.format = info.format;
  image.width = io::level_side(info.width, level);
  image.height = io::level_side(info.height, level);
  const image::RowLayout rows = image::row_layout(info.format, image.width, image.height);
  const uint32_t count = info.depth != 0 ? io::level_side(info.depth, level) : info.layer_count;
  std::vector<unsigned char> pixels;
  pixels.reserve(rows.row_size * rows.rows * count);
  for (uint32_t i = 0; i < count; ++i) {
    const size_t first = pixels.size();
    // The images of a level are packed, and those of numbers of several bytes need aligned memory.
    std::vector<unsigned char> one(rows.row_size * rows.rows);
    image.pixels = one.data();
    require(shd_texture_read_level(texture, i, level, &image));
    pixels.insert(pixels.end(), one.begin(), one.end());
    if (without_alpha) drop_alpha(shd_format_size(info.format), first, &pixels);
  }
  return pixels;
}

io::Ktx2Content read_texture(const shd_texture* texture, const shd_ktx2_desc& desc) {
  shd_texture_info info = shd_texture_info_default();
  require(shd_texture_get_info(texture, &info));
  if (info.projection != SHD_PROJECTION_NONE && info.projection != SHD_PROJECTION_CUBE) {
    refuse(SHD_ERROR_UNSUPPORTED, "texture: KTX2 has no projection %d", static_cast<int>(info.projection));
  }
  const bool cube = info.projection == SHD_PROJECTION_CUBE;
  io::Ktx2Content content;
  content.format = desc.channel_count == 3 ? three_channels(info.format) : info.format;
  content.width = info.width;
  content.height = info.height;
  content.depth = info.depth;
  content.faces = cube ? 6 : 1;
  content.layers = cube || info.layer_count == 1 ? 0 : info.layer_count;
  for (uint32_t l = 0; l < info.level_count; ++l) {
    content.levels.push_back(read_images(texture, info, l, desc.channel_count == 3));
  }
  return content;
}

}  // namespace

extern "C" {

shd_result shd_texture_save_ktx2(const shd_texture* texture, const char* path, const shd_ktx2_desc* desc) {
  return guard([&]() -> shd_result {
    const shd_ktx2_desc options = read_ktx2_desc(desc);
    require_path(path);
    const std::vector<unsigned char> file =
        io::write_ktx2(read_texture(texture, options), options.supercompression, options.effort);
    io::write_file(path, file.data(), file.size());
    return SHD_OK;
  });
}

}  // extern "C"
