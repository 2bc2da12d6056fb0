// SPDX-License-Identifier: MIT
/// @file
/// Summed-area tables (Crow, "Summed-Area Tables for Texture Mapping", 1984).
///
/// Entry (x, y) of a layer, 0 <= x <= width and 0 <= y <= height, holds for each stored channel the sum of the texels
/// left of x and above y, as codes for unorm channels and as linear values for the others. Row 0 and column 0 are 0.
/// 8-bit unorm textures of at most 2^24 texels a layer have 32-bit integers. All others have doubles, of the texels
/// less the layer's first one (Hensley et al., "Fast Summed-Area Table Generation and its Applications", 2005, take
/// off the mean), so that a constant texture is a table of zeros: whole numbers below 2^53, hence exact, for
/// unorm; within 2^-51 of the sum of the magnitudes for sRGB and floats.
/// Texels that are not finite count as 0 or, where there is an origin, as the origin. A second table counts how many a
/// rectangle has.
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// Whether the entries are 32-bit integers.
inline bool has_integer_sums(const Texture& texture) {
  return texture.component == image::Component::kUnorm8 && uint64_t{texture.width} * texture.height <= uint64_t{1}
                                                                                                           << 24;
}

/// Entries of one layer, all channels.
inline size_t sum_count(const Texture& texture) {
  return (size_t{texture.width} + 1) * (size_t{texture.height} + 1) * texture.channels;
}

/// Builds the tables of every layer of a texture whose levels 0 are there. The bits do not depend on the number of
/// workers.
void build_summed_area(const core::Context& context, Texture* texture);

/// Entries of the table of texels that are not finite that an update may have to take on.
size_t spare_sums_size(const Texture& texture);

/// Builds the tables of one layer again; `spare` has spare_sums_size() entries.
void update_summed_area(const core::Context& context, uint32_t layer, core::Array<uint32_t>* spare, Texture* texture);

}  // namespace shd::texture
