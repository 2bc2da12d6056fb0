// SPDX-License-Identifier: MIT
#include "volume/rays.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <shd/volume.h>

#include "data/inverse.h"
#include "data/matrix.h"

namespace shd::volume {
namespace {

struct Homogeneous {
  double x, y, z, w;
};

Homogeneous world_of(const Lens& lens, double x, double y, double depth) {
  const double* m = lens.clip_to_world;
  const double u = x * lens.to_ndc[0] + lens.to_ndc[1], v = y * lens.to_ndc[2] + lens.to_ndc[3];
  const auto row = [&](int r) { return m[r] * u + m[4 + r] * v + m[8 + r] * depth + m[12 + r]; };
  return {row(0), row(1), row(2), row(3)};
}

Vec3d point_of(const Homogeneous& h) {
  const double scale = 1.0 / h.w;
  return {h.x * scale, h.y * scale, h.z * scale};
}

}  // namespace

Lens make_lens(const shd_view& view, const double (&viewport)[4], bool depth_falls) {
  Lens lens = {};
  double world_to_clip[16];
  data::multiply(view.view_to_clip, view.world_to_view, world_to_clip);
  lens.is_valid = data::invert(world_to_clip, lens.clip_to_world);
  for (const double element : lens.clip_to_world) lens.is_valid = lens.is_valid && std::isfinite(element);
  lens.to_ndc[0] = 2.0 / viewport[2];
  lens.to_ndc[1] = (1.0 - 2.0 * viewport[0]) / viewport[2] - 1.0;
  lens.to_ndc[2] = -2.0 / viewport[3];
  lens.to_ndc[3] = 1.0 - (1.0 - 2.0 * viewport[1]) / viewport[3];
  lens.near_depth = depth_falls ? 1.0 : 0.0;
  return lens;
}

Sight sight_of(const Lens& lens, double x, double y) {
  const Homogeneous near = world_of(lens, x, y, lens.near_depth), far = world_of(lens, x, y, 1.0 - lens.near_depth);
  Sight sight = {};
  if (!(near.w > 0.0) || !(far.w >= 0.0)) return sight;
  sight.origin = point_of(near);
  // The direction between both points, which is that of the far point where this lies at infinity.
  sight.direction = data::normalized(
      Vec3d{far.x * near.w - near.x * far.w, far.y * near.w - near.y * far.w, far.z * near.w - near.z * far.w});
  sight.end = far.w > 0.0 ? data::length(point_of(far) - sight.origin) : INFINITY;
  sight.is_valid = !data::is_zero(sight.direction);
  return sight;
}

double distance_of(const Lens& lens, const Sight& sight, double x, double y, double depth) {
  const Homogeneous point = world_of(lens, x, y, depth);
  return point.w > 0.0 ? data::dot(point_of(point) - sight.origin, sight.direction) : sight.end;
}

bool make_world_to_box(const float (&object_to_world)[16], const double (&box_min)[3], const double (&box_max)[3],
                       WorldToBox* out) {
  double inverse[16];
  if (!data::invert(object_to_world, inverse)) return false;
  bool finite = true;
  for (int r = 0; r < 3; ++r) {
    const double scale = 1.0 / (box_max[r] - box_min[r]);
    for (int c = 0; c < 4; ++c) {
      out->row[r][c] = (inverse[4 * c + r] - (c == 3 ? box_min[r] : 0.0)) * scale;
      finite = finite && std::isfinite(out->row[r][c]);
    }
  }
  return finite;
}

bool make_ray(const Sight& sight, const WorldToBox& box, double end, float step, Ray* out) {
  double origin[3], direction[3], first = 0.0, last = std::min(end, sight.end);
  for (int c = 0; c < 3; ++c) {
    const double* row = box.row[c];
    origin[c] = row[0] * sight.origin.x + row[1] * sight.origin.y + row[2] * sight.origin.z + row[3];
    direction[c] = row[0] * sight.direction.x + row[1] * sight.direction.y + row[2] * sight.direction.z;
    if (!std::isfinite(origin[c]) || !std::isfinite(direction[c])) return false;
    if (direction[c] == 0.0) {  // parallel to two faces: between them, or outside
      if (!(origin[c] >= 0.0 && origin[c] <= 1.0)) return false;
      continue;
    }
    const double to_min = -origin[c] / direction[c], to_max = (1.0 - origin[c]) / direction[c];
    first = std::max(first, std::min(to_min, to_max));
    last = std::min(last, std::max(to_min, to_max));
  }
  const double length = last - first;
  if (!(length > 0.0) || !std::isfinite(length)) return false;
  const double steps = std::ceil(length / static_cast<double>(step));
  out->count = steps < SHD_MAX_VOLUME_STEPS ? static_cast<uint32_t>(std::max(steps, 1.0)) : SHD_MAX_VOLUME_STEPS;
  const double dt = length / out->count;
  out->dt = static_cast<float>(dt);
  const double from[3] = {sight.origin.x, sight.origin.y, sight.origin.z};
  const double along[3] = {sight.direction.x, sight.direction.y, sight.direction.z};
  for (int c = 0; c < 3; ++c) {
    out->origin[c] = static_cast<float>(origin[c] + first * direction[c]);
    out->step[c] = static_cast<float>(dt * direction[c]);
    out->world_origin[c] = static_cast<float>(from[c] + first * along[c]);
    out->world_step[c] = static_cast<float>(dt * along[c]);
  }
  return true;
}

}  // namespace shd::volume
