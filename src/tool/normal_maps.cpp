// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <vector>

#include "command/failure.h"
#include "tool/textures.h"

namespace {

/// Loads a normal map of 8 or 16 bits as RGBA of 16 bits with maximal alpha.
bool load_wide(shd_context* context, const std::string& path, std::vector<uint16_t>& texels, shd_image& out) {
  Bitmap bitmap;
  shd_image image = shd_image_default();
  shd_load_desc desc = shd_load_desc_default();
  desc.encoding = SHD_COLOR_ENCODING_DATA;
  if (shd_bitmap_load(context, path.c_str(), &desc, bitmap.out()) != SHD_OK) return false;
  if (shd_bitmap_get_image(bitmap.get(), &image) != SHD_OK) return false;
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
  desc.level_images = levels.data();
  desc.level_count = count;
  return shd_texture_create(context, &desc, out.out()) == SHD_OK;
}

bool create_data(shd_context* context, const shd_image& image, const Options& options, Texture& out) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = image.format;
  desc.width = image.width;
  desc.height = image.height;
  desc.texels = image.pixels;
  desc.tables = tables_of(options.filter);
  return shd_texture_create(context, &desc, out.out()) == SHD_OK;
}

/// Makes textures of slopes and their squares and products, as floats (Olano and Baker, "LEAN Mapping", 2010).
bool create_moments(shd_context* context, const shd_image& base, const Options& options, NormalMap& out) {
  const size_t count = size_t{base.width} * base.height;
  std::vector<float> texels(4 * count), products(count);
  shd_image moments = shd_image_default(), mixed = shd_image_default();
  moments.format = SHD_FORMAT_RGBA32F;
  mixed.format = SHD_FORMAT_R32F;
  moments.width = mixed.width = base.width;
  moments.height = mixed.height = base.height;
  moments.pixels = texels.data();
  mixed.pixels = products.data();
  return shd_mip_build_moments(context, &base, &moments, &mixed) == SHD_OK &&
         create_data(context, moments, options, out.texture) && create_data(context, mixed, options, out.mixed);
}

}  // namespace

NormalMap load_normal_map(shd_context* context, const Options& options) {
  NormalMap map;
  if (options.keep == KeepRoughness::kNone) {
    map.texture = load_texture(context, options.normal_map, true, tables_of(options.filter));
    return map;
  }
  std::vector<uint16_t> texels;
  shd_image base = shd_image_default();
  const bool done = load_wide(context, options.normal_map, texels, base) &&
                    (options.keep == KeepRoughness::kToksvig ? create_with_lengths(context, base, map.texture)
                                                             : create_moments(context, base, options, map));
  if (!done) throw Failure(kExitInput, options.normal_map + ": " + shd_last_error());
  return map;
}
