// SPDX-License-Identifier: MIT
/// @file
/// Rows of quads: what linear filters hand to a format, in place of a stream, for a block of lookups that share their
/// levels, as neighbouring pixels of a surface do. Levels, sizes and operations are then constants of the block, and
/// the lower row of a quad lies at a constant distance. No texel is the border. Blocks whose lookups share no levels
/// become rows too if the consumer takes rows only; all their quads are split. A store that places streams also places
/// rows that share their levels, if all texels are at hand; its other blocks become streams.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/stream.h"

namespace shd::texture {

/// Quads on one level, one for each lookup of a block. Before a store places them, they are columns and rows of texels:
/// `upper` is the left column, other[0] the upper row, other[1] the right column, and other[2] the lower row.
struct RowQuads {
  static constexpr size_t kColumn = 256;

  alignas(64) int32_t upper[kColumn];     // left texel of the upper row
  alignas(64) float s[kColumn];           // fraction along u
  alignas(64) float t[kColumn];           // fraction along v
  alignas(64) int32_t other[3][kColumn];  // right texel, and both texels of the lower row; set in split vectors only
  int32_t down;                           // distance of the lower row [texels]
  bool split[kColumn];                    // [vector] quads lie at an edge, where texels are not neighbours
};

/// Quads of a block of lookups. Columns are filled up to a whole vector.
struct RowStream {
  size_t count;                                   // lookups
  bool blended;                                   // whether the second level is read
  RowQuads quads[2];                              // on the finer level, and on the next coarser one
  alignas(64) float fraction[RowQuads::kColumn];  // share of the coarser level
};

/// A level of an image whose quads a store places.
struct RowLevel {
  int32_t first;  // first unit of the level (Layout)
  int32_t width;  // [texels]
};

/// Replaces columns and rows of texels by their indices in the memory of a store. Returns false if some texels are not
/// at hand; the quads are then not valid.
using PlaceRows = bool (*)(void* state, const RowLevel (&levels)[2], RowStream* rows);

}  // namespace shd::texture
