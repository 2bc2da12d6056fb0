// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/vertex.h"

namespace shd::geometry {

/// A texture that triangles are unwrapped to.
struct Atlas {
  uint32_t uv_set;         // 0 or 1
  uint32_t width, height;  // texels
};

/// Replaces the raster positions of transformed rows [begin, end) by their texture coordinates: texel (u width,
/// v height), w = 1 and depth 0. Rows that are not finite stay so. Missing coordinates of the second set count as 0.
void unwrap(const Atlas& atlas, const Transform& transform, size_t begin, size_t end, Vertices* vertices);

}  // namespace shd::geometry
