// SPDX-License-Identifier: MIT
#include "geometry/unwrap.h"

#include <cmath>

namespace shd::geometry {
namespace {

/// The limits of a texture that a raster position lies beyond.
uint32_t outcode(const Transform& transform, float x, float y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return kOutNonfinite;
  uint32_t code = 0;
  if (x < transform.left) code |= kOutLeft;
  if (x > transform.right) code |= kOutRight;
  if (y < transform.top) code |= kOutTop;
  if (y > transform.bottom) code |= kOutBottom;
  if (std::fabs(x) > kGuardBand || std::fabs(y) > kGuardBand) code |= kOutGuard;
  return code;
}

int32_t snap(float pixels, bool usable) {
  return usable ? static_cast<int32_t>(std::nearbyint(pixels * static_cast<float>(kSubpixels))) : 0;
}

}  // namespace

void unwrap(const Atlas& atlas, const Transform& transform, size_t begin, size_t end, Vertices* vertices) {
  const bool has_second = vertices->texture1.size() != 0;
  for (size_t row = begin; row < end; ++row) {
    ScreenVertex& screen = vertices->screen[row];
    float u = u_of(*vertices)[row], v = v_of(*vertices)[row];
    if (atlas.uv_set == 1) {
      u = has_second ? u1_of(*vertices)[row] : 0.0f;
      v = has_second ? v1_of(*vertices)[row] : 0.0f;
    }
    const float x = u * static_cast<float>(atlas.width), y = v * static_cast<float>(atlas.height);
    const uint32_t code = (screen.outcode & kOutNonfinite) | outcode(transform, x, y);
    const bool usable = !(code & (kMustClip | kOutNonfinite));
    screen = {snap(x, usable), snap(y, usable), 0.0f, code};
    float* raster = &vertices->raster[4 * row];
    raster[0] = x;
    raster[1] = y;
    raster[2] = 0.0f;
    raster[3] = 1.0f;
  }
}

}  // namespace shd::geometry
