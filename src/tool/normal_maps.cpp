// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <vector>

#include "tool/failure.h"
#include "tool/textures.h"

namespace {

/// Loads a normal map of 8 or 16 bits as RGBA of 16 bits with maximal alpha.
bool load_wide(shd_context* context, const std::string& path, std::vector<uint16_t>& texels, shd_image& out) {
  Bitmap bitmap;
  shd_image image = shd_image_default();
  shd_load_desc desc = shd_load_desc_default();
  desc.color_space = SHD_COLOR_ENCODING_DATA;
  if (shd_bitmap_load(context, path.c_str(), &desc, bitmap.out()) != SHD_OK) return false;
  if (shd_bitmap_image(bitmap.get(), &image) != SHD_OK) return false;
  const bool wide = image.format == SHD_FORMAT_RGBA16;
  if (!wide && image.format != SHD_FORMAT_RGBA8 && image.format != SHD_FORMAT_RGBA8_SRGB) {
    throw Failure(kExitInput, path + ": a normal map of 8 or 16 bits is wanted");
  }
  const size_t row = size_t{4} * image.width, stride = image.row_stride ? image.row_stride : row * (wide ? 2 : 1);
  for (uint32_t y = 0; y < image.height; ++y) {
    const auto* bytes = static_cast<const unsigned char*>(image.pixels) + y * stride;
    const auto* words = reinterpret_cast<const uint16_t*>(bytes);
    for (size_t i = 0; i < row; ++i) {
      const uint16_t code = wide ? words[i] : static_cast<uint16_t>(257 * bytes[i]);
      texels.push_back(i % 4 == 3 ? uint16_t{65535} : code);
    }
  }
  out = shd_image_default();
  out.format = SHD_FORMAT_RGBA16;
  out.width = image.width;
  out.height = image.height;
  out.pixels = texels.data();
  return true;
}

/// Makes levels of unit normals with the length of their mean in alpha (Toksvig, "Mipmapping Normal Maps", 2005).
bool create_with_lengths(shd_context* context, const shd_image& base, Texture& out) {
  std::vector<std::vector<uint16_t>> memory;
  std::vector<shd_image> levels;
  for (uint32_t side = std::max(base.width, base.height), l = 1; side > 1; side /= 2, ++l) {
    shd_image level = base;
    level.width = std::max(1u, base.width >> l);
    level.height = std::max(1u, base.height >> l);
    memory.emplace_back(size_t{4} * level.width * level.height);
    level.pixels = memory.back().data();
    levels.push_back(level);
  }
  shd_mip_desc mip = shd_mip_desc_default();
  mip.content = SHD_TEXEL_CONTENT_NORMAL;
  const auto count = static_cast<uint32_t>(levels.size());
  if (shd_mip_build(context, &base, &mip, count, levels.data()) != SHD_OK) return false;
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = base.format;
  desc.width = base.width;
  desc.height = base.height;
  desc.texels = base.pixels;
  desc.tables = SHD_TABLE_MIPMAP;
  desc.levels = levels.data();
  desc.level_count = count;
  return shd_texture_create(context, &desc, out.out()) == SHD_OK;
}

/// Makes a texture of slopes and their squares, as floats (Olano and Baker, "LEAN Mapping", 2010).
bool create_moments(shd_context* context, const shd_image& base, Texture& out) {
  std::vector<float> texels(size_t{4} * base.width * base.height);
  shd_image moments = base;
  moments.format = SHD_FORMAT_RGBA32F;
  moments.pixels = texels.data();
  if (shd_normal_moments(context, &base, &moments) != SHD_OK) return false;
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = moments.format;
  desc.width = base.width;
  desc.height = base.height;
  desc.texels = texels.data();
  desc.tables = SHD_TABLE_MIPMAP;
  return shd_texture_create(context, &desc, out.out()) == SHD_OK;
}

}  // namespace

Texture load_normal_map(shd_context* context, const Options& options) {
  if (options.keep == KeepRoughness::kNone) {
    return load_texture(context, options.normal_map, true, tables_of(options.filter));
  }
  std::vector<uint16_t> texels;
  shd_image base = shd_image_default();
  Texture texture;
  const bool done = load_wide(context, options.normal_map, texels, base) &&
                    (options.keep == KeepRoughness::kToksvig ? create_with_lengths(context, base, texture)
                                                             : create_moments(context, base, texture));
  if (!done) throw Failure(kExitInput, options.normal_map + ": " + shd_last_error());
  return texture;
}
