// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "film/tile_color.h"

namespace shd::film {

/// One sample of one fragment, to be sorted.
struct SortedNode {
  uint32_t position;  // sample * kTilePixels + pixel
  float distance;     // larger = farther from the eye
  uint32_t order;     // number of arrival
  FragmentColor color;
};

/// Fragments of a tile with an order-independent blend.
struct Unordered {
  core::Array<float> sums;         // [samples][5][kTilePixels]: sums of w c (three) and w a, product of 1 - a
  core::Buffer<SortedNode> nodes;  // at most kMaxNodes, unless a single pixel has more
};
constexpr size_t kMaxNodes = size_t{1} << 17;
constexpr size_t kSums = 5;

/// Resets the sums of every sample; allocates them on first use. Throws std::bad_alloc.
void clear_weighted(const core::Allocator& allocator, uint32_t samples, Unordered* unordered);
void add_weighted(uint32_t sample, uint32_t pixel, float depth, const FragmentColor& color, Unordered* unordered);
/// Blends the sums over the colour of each sample.
void blend_weighted(uint32_t samples, const Unordered& unordered, TileColor* color);

/// Sorts the nodes and blends them over the colours, far ones first.
void blend_sorted(Unordered* unordered, TileColor* color);

}  // namespace shd::film
