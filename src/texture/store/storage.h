// SPDX-License-Identifier: MIT
/// @file
/// Levels of textures, units of stores, and texels in memory. The contract of store/ is in stores.h.
///
/// A stream names the level, column and row of each texel. Memory turns them into addresses while a filter emits them
/// (level-inl.h). Stores with a cache, bc/ and tiles/, find the places of a whole stream before it is consumed
/// (place-inl.h).
///
/// In memory, levels are packed rows of texels in the caller's format. Kernels convert 8-bit and 16-bit codes to floats
/// in registers.
///
/// Tiled layouts were measured and rejected. The table shows millions of bilinear RGBA8 lookups per second on
/// 2048 x 2048 texels, one thread of a Zen 5, AVX-512, by the loops of bench/bench_layout.cpp. "words" is one gather
/// per tap; "by rows" uses the loads of gather-inl.h. Numbers in brackets are with prefetches of the cache lines of
/// later lookups.
///
/// | storage       | floor     | floor turned by 45 degrees | random places | the same places sorted |
/// |---------------|-----------|----------------------------|---------------|------------------------|
/// | rows, by rows | 367       |                            |               |                        |
/// | rows, words   | 281 (325) | 177 (192)                  | 61 (171)      | 167 (301)              |
/// | 4 x 4 tiles   | 184 (289) | 124 (174)                  | 60 (95)       | 155 (326)              |
/// | 8 x 8 tiles   | 127 (283) |     (199)                  | 62 (118)      |                        |
/// | Morton order  | 122 (238) | 102                        | 43            |                        |
///
/// On 8192 x 8192 texels, tiles are faster only for the turned floor, whose lines miss every cache: 157 million to 107.
/// Random places give 37 to 43 (75) in every layout. The cost of tiled addresses in every lookup exceeds the savings in
/// cache lines. Therefore levels are rows, and scattered lookups are prefetched (filter/prefetch.h). Texels expanded to
/// floats would take four times the cache lines.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/store/span.h"
#include "texture/texture.h"

namespace shd::texture {

/// Number of bytes after the last texel that a kernel may read: two vectors of 64 bytes.
constexpr size_t kPadding = SHD_TEXTURE_PADDING;

/// Returns the width or height of a level, from the width or height of the base.
inline uint32_t level_size(uint32_t base, uint32_t level) {
  const uint32_t size = base >> level;
  return size ? size : 1;
}

/// Returns the number of units along an axis.
constexpr uint32_t units_along(uint32_t texels, uint32_t shift) {
  return (texels + (1u << shift) - 1) >> shift;
}

/// Returns the units of one slice of a level.
inline uint32_t slice_units(const Texture& texture, uint32_t level) {
  return units_along(level_size(texture.width, level), texture.layout.unit.shift_x) *
         units_along(level_size(texture.height, level), texture.layout.unit.shift_y);
}

/// Returns the first unit of a level of an image: of a layer, or of a slice of a 3D texture.
inline uint32_t first_unit(const Texture& texture, uint32_t image, uint32_t level) {
  const uint32_t before = texture.depth != 0 ? slice_units(texture, level) : texture.layout.layer_units;
  return image * before + texture.layout.offset[level];
}

/// Numbers the units of a texture whose sizes and levels are set. Returns the units of one layer.
uint64_t lay_out(const UnitShape& unit, Texture* texture);

/// The place of a unit: the level of an image, and the unit's number within the level of the image.
struct UnitPlace {
  uint32_t image, level, in_level;
};

/// Returns the place of a unit; the inverse of first_unit().
UnitPlace place_of_unit(const Texture& texture, uint32_t unit);

/// Returns the number of levels down to one texel: floor(log2(max(width, height, depth))) + 1.
uint32_t full_level_count(uint32_t width, uint32_t height, uint32_t depth = 1);

/// Returns the size of one stored texel, or of one decoded texel of blocks [bytes].
inline size_t texel_size(const Texture& texture) {
  return image::format_info(texture.channels, texture.component).pixel_size;
}

/// Returns the size of all tables that are not borrowed, and of the sums that updates keep [bytes]. Tiles are the
/// cache's.
inline size_t byte_size(const Texture& texture) {
  const size_t texels = texture.texels.size() ? texture.texels.size() - kPadding : 0;
  return texels + texture.mip_sums.size() * sizeof(double) + texture.sums.size() +
         texture.nonfinite_sums.size() * sizeof(uint32_t) + texture.sum_origins.size() * sizeof(double);
}

/// Returns the region of all texels of the base.
inline Region whole(const Texture& texture) {
  return {{0, texture.width}, {0, texture.height}};
}

/// Returns the first byte of a texel, which may be borrowed.
inline const uint8_t* texel_at(const Texture& texture, size_t index) {
  return (index < texture.borrowed_units ? texture.borrowed : texture.origin) + index * texel_size(texture);
}
/// Returns the first byte of a texel for writing. The texel must not be borrowed.
inline uint8_t* texel_at(Texture& texture, size_t index) {
  return const_cast<uint8_t*>(texel_at(static_cast<const Texture&>(texture), index));
}

/// Returns the first byte of row y of a level of an image in memory. Rows and slices are packed.
inline uint8_t* row_of(Texture& texture, uint32_t image, uint32_t level, uint32_t y) {
  return texel_at(texture, first_unit(texture, image, level) + size_t{y} * level_size(texture.width, level));
}
inline const uint8_t* row_of(const Texture& texture, uint32_t layer, uint32_t level, uint32_t y) {
  return row_of(const_cast<Texture&>(texture), layer, level, y);
}

/// Returns the number of images of the base: layers, or slices.
inline uint32_t image_count(const Texture& texture) {
  return texture.depth != 0 ? texture.depth : texture.layers;
}

/// Returns whether ripmap level (i, j) is the base or level max(i, j) of the texture's mipmap.
inline bool is_mip_level(const Texture& texture, uint32_t i, uint32_t j) {
  const uint32_t level = i > j ? i : j, columns = texture.ripmap_columns, rows = texture.ripmap_rows;
  return level < texture.level_count && i == (level < columns ? level : columns - 1) &&
         j == (level < rows ? level : rows - 1);
}

/// Returns the first byte of row y of ripmap level (i, j) of a layer.
inline uint8_t* ripmap_row(Texture& texture, uint32_t layer, uint32_t i, uint32_t j, uint32_t y) {
  const size_t first = size_t{layer} * texture.layout.layer_units + texture.ripmap_offset[j * kMaxLevels + i] +
                       size_t{y} * level_size(texture.width, i);
  return texel_at(texture, first);
}
inline const uint8_t* ripmap_row(const Texture& texture, uint32_t layer, uint32_t i, uint32_t j, uint32_t y) {
  return ripmap_row(const_cast<Texture&>(texture), layer, i, j, y);
}

/// Texels in the caller's memory.
struct GivenTexels {
  const uint8_t* texels;  // first texel of the region
  size_t stride;          // distance between rows [bytes]
  image::FormatInfo format;
};

/// Copies the rows `rows` of a region into a level of a layer or of a slice. Three channels become four.
void copy_rows(const GivenTexels& given, uint32_t layer, uint32_t level, const Region& region, AxisRange rows,
               Texture* texture);

}  // namespace shd::texture
