// SPDX-License-Identifier: MIT
/// @file
/// Prefetches for lookups that are scattered over a large texture. Without prefetches, each vector of such lookups
/// waits for memory on its own. Texels are prefetched some elements before they are consumed.
/// Lookups that are near their neighbours are not prefetched, because prefetches would only cost time.
#pragma once

#include "texture/domain/block.h"
#include "texture/stream.h"

namespace shd::texture {

/// Returns whether most neighbouring lookups of a block read distant cache lines of a texture that is larger than a
/// cache close to a core. Eight pairs of neighbours are tested. `lod` holds the levels of detail; null = level 0. The
/// answer changes the speed of the lookups, not their results.
bool is_scattered(const Texture& texture, const PointBlock& block, const float* lod);

/// is_scattered() of lookups in a 3D texture; `w` is the third coordinate.
bool is_scattered_in_slices(const Texture& texture, const PointBlock& block, const float* w, const float* lod);

/// The input columns that a batch of lookups has.
class InputColumns {
 public:
  explicit InputColumns(const Lookups& in) : count_(in.count) {
    if (count_ > kBlock) find(in);  // no lookup of a single block is prefetched
  }

  /// Prefetches the columns at lookup i if it is in the batch.
  void prefetch(size_t i) const {
    if (i >= count_) return;
    for (size_t c = 0; c < columns_; ++c) __builtin_prefetch(column_[c] + i);
  }

 private:
  void find(const Lookups& in);

  size_t count_, columns_ = 0;
  const uint32_t* column_[kFloatColumns + kIntegerColumns];  // columns of any type of four bytes
};

/// Prefetches the texels of an element: of quads, of rows, and of single texels with kNewLine. `index0` and `index2`
/// are its columns Elements::index.
void prefetch_element(const TexelSource& source, uint32_t op, const int32_t* index0, const int32_t* index2,
                      size_t lanes);

/// Prefetches the texels of rows of quads, whose vectors have `lanes` lookups.
void prefetch_rows(const TexelSource& source, const RowStream& rows, size_t lanes);

}  // namespace shd::texture
