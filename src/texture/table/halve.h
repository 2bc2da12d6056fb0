// SPDX-License-Identifier: MIT
/// @file
/// Averages of neighbouring texels, and weighted sums of rows: the parts that the builders of mip levels of 2D and 3D
/// textures share (mip.cpp, mip_slices.cpp, mip_stream.h).
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/format/texel_codec.h"
#include "texture/store/span.h"

namespace shd::texture {

/// Averages pairs of columns (or a single column) of two rows. The rows are `down` doubles apart; 0 for a single row.
/// `to` may be `row`.
void halve_rows(size_t channels, const double* row, size_t down, uint32_t width, double* to);

/// Averages squares of 2 x 2 texels of two stored rows. Both rows are the same if the height is 1.
void halve_texels(const TexelCodec& codec, const uint8_t* top, const uint8_t* bottom, uint32_t width, double* to);

/// Adds the weighted sum of the texels of `span` in one stored row.
void add_row(const TexelCodec& codec, const uint8_t* row, const AxisSpan& span, double weight, double* sum);

/// Stores sums / area of `count` texels.
void store_averages(const TexelCodec& codec, const double* sums, double area, size_t count, uint8_t* texels);

}  // namespace shd::texture
