// SPDX-License-Identifier: MIT
/// @file
/// Lookups that lie all over a large texture wait for memory, one vector after the other. The lines of a stream are
/// asked for at once before it is consumed; where neighbours lie near each other that would only cost.
#pragma once

#include "texture/footprint/block.h"
#include "texture/stream.h"

namespace shd::texture {

/// Whether most neighbouring lookups of a block read lines of memory far from each other, as eight pairs of them show,
/// in a texture that is larger than a cache close to a core. `lod` holds their levels of detail, or is null for level
/// 0. Decides how fast the lookups are, not what they give.
bool is_scattered(const Texture& texture, const PointBlock& block, const float* lod);

/// The columns that a batch of lookups has.
class InputColumns {
 public:
  explicit InputColumns(const Lookups& in);

  /// Asks for the lines of lookup i, if there is one.
  void prefetch(size_t i) const {
    if (i >= count_) return;
    for (size_t c = 0; c < columns_; ++c) __builtin_prefetch(column_[c] + i);
  }

 private:
  size_t count_, columns_ = 0;
  const uint32_t* column_[kFloatColumns + kIntegerColumns];  // of any four bytes
};

/// Asks for the lines of elements first..end - 1: of quads, of rows, and of texels that begin a line.
void prefetch_elements(const TexelSource& source, const Stream& stream, size_t first, size_t end, size_t lanes);

}  // namespace shd::texture
