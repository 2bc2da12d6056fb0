// SPDX-License-Identifier: MIT
/// @file
/// Levels are packed rows of texels as the caller's format has them; 8-bit and 16-bit codes become floats in registers.
///
/// Why not tiles: millions of bilinear RGBA8 lookups a second on 2048 x 2048 texels, one thread of a Zen 5, AVX-512, by
/// the loops of bench/bench_layout.cpp, words = one gather a tap, rows = the loads of gather-inl.h; in brackets with
/// the lines of lookups ahead prefetched:
///
/// | storage       | floor     | floor turned by 45 degrees | random places | the same places sorted |
/// |---------------|-----------|----------------------------|---------------|------------------------|
/// | rows, by rows | 367       |                            |               |                        |
/// | rows, words   | 281 (325) | 177 (192)                  | 61 (171)      | 167 (301)              |
/// | 4 x 4 tiles   | 184 (289) | 124 (174)                  | 60 (95)       | 155 (326)              |
/// | 8 x 8 tiles   | 127 (283) |     (199)                  | 62 (118)      |                        |
/// | Morton order  | 122 (238) | 102                        | 43            |                        |
///
/// On 8192 x 8192 texels tiles win where lines of a turned floor miss every cache, 157 to 107, and nowhere else: random
/// places 37 to 43 (75) in any order. What a tile saves in lines its address costs in every lookup. Hence rows, and
/// prefetch-inl.h for lookups that are scattered. Texels expanded to floats would take four times the lines.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/store/span.h"
#include "texture/texture.h"

namespace shd::texture {

/// Bytes after the last texel that a kernel may read: two vectors of 64 bytes.
constexpr size_t kPadding = SHD_TEXTURE_PADDING;

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

/// Bytes of all tables that are not borrowed, and of the sums that updates keep.
inline size_t byte_size(const Texture& texture) {
  return texture.texels.size() - kPadding + texture.mip_sums.size() * sizeof(double) + texture.sums.size() +
         texture.nonfinite_sums.size() * sizeof(uint32_t) + texture.sum_origins.size() * sizeof(double);
}

/// All texels of the base.
inline Region whole(const Texture& texture) {
  return {{0, texture.width}, {0, texture.height}};
}

/// Whether texels outside the image read the border colour on some axis.
inline bool has_border(const Sampler& sampler) {
  return sampler.wrap_u == SHD_WRAP_BORDER || sampler.wrap_v == SHD_WRAP_BORDER;
}

/// First byte of a texel, wherever it is kept.
inline const uint8_t* texel_at(const Texture& texture, size_t index) {
  return (index < texture.borrowed_texels ? texture.borrowed : texture.origin) + index * texel_size(texture);
}
/// Address to write a texel to; the texel is not borrowed.
inline uint8_t* texel_at(Texture& texture, size_t index) {
  return const_cast<uint8_t*>(texel_at(static_cast<const Texture&>(texture), index));
}

/// First byte of row y of a level of a layer; rows are packed.
inline uint8_t* row_of(Texture& texture, uint32_t layer, uint32_t level, uint32_t y) {
  const size_t first =
      size_t{layer} * texture.layer_texels + texture.offset[level] + size_t{y} * level_size(texture.width, level);
  return texel_at(texture, first);
}
inline const uint8_t* row_of(const Texture& texture, uint32_t layer, uint32_t level, uint32_t y) {
  return row_of(const_cast<Texture&>(texture), layer, level, y);
}

/// Whether shd built the mip levels; otherwise there are none or the caller gave them.
inline bool has_built_levels(const Texture& texture) {
  return texture.tables & SHD_TABLE_MIPMAP && !texture.levels_given;
}

/// Doubles that build_mip_levels keeps of one layer.
size_t mip_sums_size(const Texture& texture);

/// Fills levels 1.. of a layer, whose level 0 is there, over a region of the base (mip.cpp).
/// Every texel is the average of the base level over its area, in linear light, rounded once to what the format
/// stores: unorm and binary16 to nearest even, binary32 to nearest, sRGB to the nearest code.
/// `sums`, mip_sums_size() of them, hold unrounded averages: those over the region are written, those over the rest of
/// the layer are read, as they were left by a call for the same layer.
void build_mip_levels(const core::Context& context, Texture* texture, uint32_t layer, const Region& region,
                      double* sums);

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
  return texel_at(texture, first);
}
inline const uint8_t* ripmap_row(const Texture& texture, uint32_t layer, uint32_t i, uint32_t j, uint32_t y) {
  return ripmap_row(const_cast<Texture&>(texture), layer, i, j, y);
}

/// Doubles that build_ripmap_levels needs as scratch.
size_t ripmap_scratch_size(const core::Context& context, const Texture& texture);

/// Fills the ripmap levels of a layer, whose level 0 is there, over a region of the base (ripmap.cpp): averages as
/// those of build_mip_levels. Reads all columns of the base in the rows that the texels cover.
void build_ripmap_levels(const core::Context& context, Texture* texture, uint32_t layer, const Region& region,
                         double* scratch);

/// Texels in the caller's memory, of the format that the texture was made from.
struct GivenTexels {
  const uint8_t* texels;  // of the first texel of the region
  size_t stride;          // bytes between rows
  image::FormatInfo format;
};

/// Writes rows [first, end) of a region of a level.
void copy_rows(const GivenTexels& given, uint32_t layer, uint32_t level, const Region& region, AxisRange rows,
               Texture* texture);

}  // namespace shd::texture
