// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/texture.h"

namespace shd::texture {

/// Bytes after the last texel that a kernel may read: two vectors of 64 bytes.
constexpr size_t kPadding = 128;

/// Width or height of a level from that of the base.
inline uint32_t level_size(uint32_t base, uint32_t level) {
  const uint32_t size = base >> level;
  return size ? size : 1;
}

/// floor(log2(max(width, height))) + 1.
uint32_t full_level_count(uint32_t width, uint32_t height);

/// Bytes of one stored texel.
inline size_t texel_size(const Texture& texture) {
  return image::format_info(texture.format).pixel_size;
}

/// Bytes of all tables.
inline size_t byte_size(const Texture& texture) {
  return texture.texels.size() - kPadding + texture.sums.size() + texture.nonfinite_sums.size() * sizeof(uint32_t) +
         texture.sum_origins.size() * sizeof(double);
}

/// Whether texels outside the image read the border colour on some axis.
inline bool has_border(const Sampler& sampler) {
  return sampler.wrap_u == SHD_WRAP_BORDER || sampler.wrap_v == SHD_WRAP_BORDER;
}

/// First byte of row y of a level of a layer; rows are packed.
inline uint8_t* row_of(Texture& texture, uint32_t layer, uint32_t level, uint32_t y) {
  const size_t first =
      size_t{layer} * texture.layer_texels + texture.offset[level] + size_t{y} * level_size(texture.width, level);
  return texture.texels.data() + first * texel_size(texture);
}
inline const uint8_t* row_of(const Texture& texture, uint32_t layer, uint32_t level, uint32_t y) {
  return row_of(const_cast<Texture&>(texture), layer, level, y);
}

/// Fills levels 1.. of every layer of a texture whose levels 0 are there (mip.cpp).
/// Every texel is the average of the base level over its area, in linear light, rounded once to what the format
/// stores: unorm and binary16 to nearest even, binary32 to nearest, sRGB to the nearest code.
void build_mip_levels(const core::Context& context, Texture* texture);

/// Whether ripmap level (i, j) is the base or, where there is a mipmap, level max(i, j) of it.
inline bool is_mip_level(const Texture& texture, uint32_t i, uint32_t j) {
  const uint32_t level = i > j ? i : j, columns = texture.ripmap_columns, rows = texture.ripmap_rows;
  return level < texture.level_count && i == (level < columns ? level : columns - 1) &&
         j == (level < rows ? level : rows - 1);
}

/// First byte of row y of ripmap level (i, j) of a layer.
inline uint8_t* ripmap_row(Texture& texture, uint32_t layer, uint32_t i, uint32_t j, uint32_t y) {
  const size_t first = size_t{layer} * texture.layer_texels + texture.ripmap_offset[j * kMaxLevels + i] +
                       size_t{y} * level_size(texture.width, i);
  return texture.texels.data() + first * texel_size(texture);
}
inline const uint8_t* ripmap_row(const Texture& texture, uint32_t layer, uint32_t i, uint32_t j, uint32_t y) {
  return ripmap_row(const_cast<Texture&>(texture), layer, i, j, y);
}

/// Fills the ripmap levels of every layer of a texture whose levels 0 are there (ripmap.cpp): averages as those of
/// build_mip_levels.
void build_ripmap_levels(const core::Context& context, Texture* texture);

}  // namespace shd::texture
