// SPDX-License-Identifier: MIT
#include "frame/background.h"

#include <algorithm>
#include <cmath>

#include "data/matrix.h"
#include "data/trig.h"
#include "data/vec3.h"
#include "environment/look_up.h"

namespace shd::frame {
namespace {

using data::Vec3d;

/// Row of a matrix, without its translation.
template <class T>
Vec3d row_of(const T* matrix, int row) {
  return {static_cast<double>(matrix[row]), static_cast<double>(matrix[4 + row]), static_cast<double>(matrix[8 + row])};
}

/// The direction of the point (x, y) of NDC: D = r0 x r1 + x (r1 x r3) + y (r3 x r0) with rows r of the matrix to clip
/// space, because (r0 - x r3).D and (r1 - y r3).D are 0. Points away from the eye.
void find_rays(const shd_view& view, Vec3d* ray) {
  double to_clip[16];
  data::multiply(view.view_to_clip, view.world_to_view, to_clip);
  const Vec3d r0 = row_of(to_clip, 0), r1 = row_of(to_clip, 1), r3 = row_of(to_clip, 3);
  ray[0] = data::cross(r0, r1);
  ray[1] = data::cross(r1, r3);
  ray[2] = data::cross(r3, r0);
  if (data::dot(ray[0], row_of(view.world_to_view, 2)) <= 0.0) return;  // the view looks along -Z
  for (int k = 0; k < 3; ++k) ray[k] = -1.0 * ray[k];
}

}  // namespace

Background make_background(const Frame& frame) {
  Background background = {};
  if (frame.background != SHD_BACKGROUND_ENVIRONMENT || frame.load) return background;
  background.map = frame.environment.map;
  background.intensity = frame.environment.intensity;
  background.roughness = frame.background_roughness;
  Vec3d ray[3];
  find_rays(frame.view, ray);
  // NDC of a raster position: x = (X - centre) / half, y = (centre - Y) / half.
  const geometry::Viewport& v = frame.viewport;
  const double half_x = 0.5 * v.width, half_y = 0.5 * v.height;
  ray[1] = (1.0 / half_x) * ray[1];
  ray[2] = (-1.0 / half_y) * ray[2];
  ray[0] = ray[0] - (v.x + half_x) * ray[1] - (v.y + half_y) * ray[2];
  const float* m = frame.environment.world_to_map;
  for (int k = 0; k < 3; ++k) {
    for (int r = 0; r < 3; ++r) {
      background.ray[k][r] = static_cast<double>(m[r]) * ray[k].x + static_cast<double>(m[3 + r]) * ray[k].y +
                             static_cast<double>(m[6 + r]) * ray[k].z;
    }
  }
  return background;
}

void fill_background(const core::SimdTarget& simd, const Background& background, const film::TileArea& area,
                     const film::TileArea& part, int32_t left, int32_t top, const film::TilePlanes& planes) {
  float direction[3][raster::kTile], precision[raster::kTile];
  const auto& r = background.ray;
  const Vec3d origin = {r[0][0], r[0][1], r[0][2]}, across = {r[1][0], r[1][1], r[1][2]},
              down = {r[2][0], r[2][1], r[2][2]};
  for (uint32_t y = 0; y < part.height; ++y) {
    const uint32_t column = part.left - area.left, row = part.top - area.top + y;
    const Vec3d start = origin + (top + static_cast<int32_t>(row) + 0.5) * down;
    for (uint32_t x = 0; x < part.width; ++x) {
      const Vec3d ray = start + (left + static_cast<int32_t>(column + x) + 0.5) * across;
      const double length = data::length(ray), inverse = length > 0.0 ? 1.0 / length : 0.0;
      direction[0][x] = static_cast<float>(inverse * ray.x);
      direction[1][x] = static_cast<float>(inverse * ray.y);
      direction[2][x] = static_cast<float>(inverse * ray.z);
      // The map has the precision 4 pi / w at texels of solid angle w; this is w of a pixel.
      const double area_of = data::dot(ray, data::cross(across, down)) * inverse * inverse * inverse;
      precision[x] = static_cast<float>(std::min(4.0 * data::kPi / std::max(std::fabs(area_of), 1e-12), 1e12));
    }
    float* out[4];
    for (int c = 0; c < 4; ++c) out[c] = planes.plane[c] + row * planes.stride + column;
    environment::look_up_view(simd, *background.map,
                              {part.width, {direction[0], direction[1], direction[2]}, precision}, background.roughness,
                              background.intensity, out);
    std::fill_n(out[3], part.width, 1.0f);
  }
}

}  // namespace shd::frame
