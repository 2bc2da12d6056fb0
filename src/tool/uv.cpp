// SPDX-License-Identifier: MIT
#include "tool/uv.h"

#include <algorithm>

namespace {

/// view_to_clip * world_to_view.
void find_world_to_clip(const shd_view& view, float* out) {
  for (size_t c = 0; c < 4; ++c) {
    for (size_t r = 0; r < 4; ++r) {
      double sum = 0.0;
      for (size_t k = 0; k < 4; ++k) sum += double(view.view_to_clip[4 * k + r]) * view.world_to_view[4 * c + k];
      out[4 * c + r] = static_cast<float>(sum);
    }
  }
}

}  // namespace

shd_uv_projection projection_of(Uv uv) {
  switch (uv) {
    case Uv::kPlanar: return SHD_UV_PROJECTION_PLANAR;
    case Uv::kSpherical: return SHD_UV_PROJECTION_SPHERICAL;
    case Uv::kCylindrical: return SHD_UV_PROJECTION_CYLINDRICAL;
    case Uv::kBox: return SHD_UV_PROJECTION_BOX;
    default: return SHD_UV_PROJECTION_NONE;
  }
}

std::array<float, 16> fit_box(const Box& box, double middle, double side) {
  double longest = 0.0;
  for (size_t c = 0; c < 3; ++c) longest = std::max(longest, box.high[c] - box.low[c]);
  const double scale = longest > 0.0 ? side / longest : 1.0;
  std::array<float, 16> out = {};
  for (size_t c = 0; c < 3; ++c) {
    const double center = longest > 0.0 ? 0.5 * (box.low[c] + box.high[c]) : 0.0;
    out[5 * c] = static_cast<float>(scale);
    out[12 + c] = static_cast<float>(middle - scale * center);
  }
  out[15] = 1.0f;
  return out;
}

shd_slot uv_slot(Uv uv, const Box& box, const Camera& camera) {
  shd_slot slot = shd_slot_default();
  slot.place_space = SHD_PLACE_SPACE_WORLD;
  if (uv == Uv::kTriplanar) {
    const std::array<float, 16> fit = fit_box(box, 0.5, 1.0);
    slot.coordinates = SHD_SLOT_COORDINATES_TRIPLANAR;
    std::copy(fit.begin(), fit.end(), slot.place_transform);
  } else if (uv == Uv::kCamera) {
    const float to_uv[6] = {0.5f, 0.0f, 0.5f, 0.0f, -0.5f, 0.5f};  // from clip space
    slot.coordinates = SHD_SLOT_COORDINATES_PROJECTED;
    find_world_to_clip(camera.view, slot.place_transform);
    std::copy(to_uv, to_uv + 6, slot.uv_transform);
  }
  return slot;
}
