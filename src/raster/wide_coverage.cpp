// SPDX-License-Identifier: MIT
#include "raster/wide_coverage.h"

namespace shd::raster {
namespace {

/// Calls body(pixel, sample, z) for every covered sample whose depth z passes.
template <class Body>
void for_each_passing(const TriangleSetup& t, shd_compare compare, const Tile& tile, const Body& body) {
  const SamplePattern& pattern = *t.pattern;
  const DepthTest test = depth_test(compare);
  DepthPlane plane[kMaxSamples];
  for (uint32_t s = 0; s < pattern.count; ++s) plane[s] = plane_at(t.slope, pattern.point[s]);
  for (int32_t y = t.box.min_y; y <= t.box.max_y; ++y) {
    for (int32_t x = t.box.min_x; x <= t.box.max_x; ++x) {
      const auto pixel = static_cast<size_t>(y * kTile + x);
      for (uint32_t s = 0; s < pattern.count; ++s) {
        if (!covers(t.line, x, y, pattern.point[s])) continue;
        const float z = depth_at(plane[s], t.left + x, t.top + y);
        if (passes(test, z, tile.depth[pixel * pattern.count + s])) body(pixel, s, z);
      }
    }
  }
}

}  // namespace

void cover_wide(const TriangleSetup& triangle, const DepthState& state, uint32_t slot, Tile* tile) {
  for_each_passing(triangle, state.compare, *tile, [&](size_t pixel, uint32_t sample, float z) {
    const size_t at = pixel * tile->samples + sample;
    if (state.writes) tile->depth[at] = z;
    if (slot != kNoSlot) tile->slot[at] = slot;
  });
}

void mask_wide(const TriangleSetup& triangle, const DepthState& state, const Tile& tile, CoverMask* out) {
  for_each_passing(triangle, state.compare, tile,
                   [&](size_t pixel, uint32_t sample, float) { out->bits[pixel] |= 1u << sample; });
}

}  // namespace shd::raster
