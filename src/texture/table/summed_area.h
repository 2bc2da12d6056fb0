// SPDX-License-Identifier: MIT
/// @file
/// Summed-area tables (Crow, "Summed-Area Tables for Texture Mapping", 1984).
///
/// Entry (x, y) of a layer, 0 <= x <= width and 0 <= y <= height, is the sum of the texels left of x and above y, for
/// each stored channel. Unorm channels are summed as codes, other channels as linear values. Row 0 and column 0 are 0.
///
/// 8-bit unorm textures of at most 2^24 texels per layer have 32-bit integer sums. All other textures have sums of
/// doubles. The first texel of the layer, the origin, is subtracted from each texel before summation, so that the table
/// of a constant texture is 0 (Hensley et al., "Fast Summed-Area Table Generation and its Applications", 2005, subtract
/// the mean). Sums of unorm texels are integers below 2^53 and therefore exact; sums of sRGB and float texels are
/// within 2^-51 of the sum of magnitudes.
///
/// Texels that are not finite count as the origin, which is 0 if the first texel is not finite either. A second table
/// counts the texels of a rectangle that are not finite.
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// Returns whether the entries are 32-bit integers.
inline bool has_integer_sums(const Texture& texture) {
  return texture.component == image::Component::kUnorm8 && uint64_t{texture.width} * texture.height <= uint64_t{1}
                                                                                                           << 24;
}

/// Returns the number of entries of one layer, for all channels.
inline size_t sum_count(const Texture& texture) {
  return (size_t{texture.width} + 1) * (size_t{texture.height} + 1) * texture.channels;
}

/// Builds the tables of every layer from its level 0. The bits do not depend on the number of workers.
void build_summed_area(const core::Context& context, Texture* texture);

/// Returns the entries of the table of counts that an update must add if it writes texels that are not finite.
size_t spare_sums_size(const Texture& texture);

/// Rebuilds the tables of one layer. `spare` has spare_sums_size() entries; the texture takes it if it needs the table
/// of counts.
void update_summed_area(const core::Context& context, uint32_t layer, core::Array<uint32_t>* spare, Texture* texture);

}  // namespace shd::texture
