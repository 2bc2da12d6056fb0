// SPDX-License-Identifier: MIT
#include <shd/view.h>

#include <algorithm>
#include <cstring>

#include "abi/camera.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "data/camera.h"
#include "data/trig.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr double kMargin = 1.04;  // factor of the distance: nothing touches the edges of the picture

/// Half of the size of a box.
shd_result read_box(const float* bounds_min, const float* bounds_max, data::Vec3d* out) {
  SHD_TRY(check_not_null("bounds_min", bounds_min));
  SHD_TRY(check_not_null("bounds_max", bounds_max));
  SHD_TRY(check_finite("bounds_min", bounds_min, 3));
  SHD_TRY(check_finite("bounds_max", bounds_max, 3));
  for (int axis = 0; axis < 3; ++axis) {
    if (bounds_min[axis] <= bounds_max[axis]) continue;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "bounds_max[%d]: %g is below bounds_min[%d], %g", axis,
                      static_cast<double>(bounds_max[axis]), axis, static_cast<double>(bounds_min[axis]));
  }
  *out = 0.5 * (data::to_double(bounds_max) - data::to_double(bounds_min));
  if (data::length(*out) > 0.0) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "bounds_max: is bounds_min, a point has no size");
}

/// A camera at this distance from the target, along the direction `back`.
shd_result place_camera(const data::Vec3d& target, const data::Vec3d& back, double distance, double radius,
                        shd_camera* camera) {
  const data::Vec3d eye = target + distance * back;
  const double to[3] = {target.x, target.y, target.z}, from[3] = {eye.x, eye.y, eye.z};
  for (int axis = 0; axis < 3; ++axis) {
    camera->target[axis] = static_cast<float>(to[axis]);
    camera->eye[axis] = static_cast<float>(from[axis]);
  }
  camera->near_plane = static_cast<float>(std::max(distance - radius, 0.001 * distance));
  camera->far_plane = static_cast<float>(distance + radius);
  // The rounding of the target moves the box by less than a thousandth of its distance, or the picture shows it.
  double moved = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    moved = std::max({moved, std::abs(static_cast<double>(camera->target[axis]) - to[axis]),
                      std::abs(static_cast<double>(camera->eye[axis]) - from[axis])});
  }
  if (moved <= 0.001 * distance) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                    "bounds_max: the box is too small for its place, or too large for a camera of floats");
}

}  // namespace

extern "C" shd_result shd_camera_frame_box(shd_camera* camera, const float bounds_min[3], const float bounds_max[3]) {
  return guard([&]() -> shd_result {
    shd_camera made;
    SHD_TRY(check_camera(camera, &made));
    data::Vec3d half = {}, axes[3] = {};
    SHD_TRY(read_box(bounds_min, bounds_max, &half));
    SHD_TRY(make_axes("camera", made.eye, made.target, made.up, axes));
    const double tan_y = data::tan(0.5 * static_cast<double>(made.fov_y));
    const double tan_x = made.aspect != 0.0f ? tan_y * static_cast<double>(made.aspect) : tan_y;
    const double distance = kMargin * data::framing_distance(axes, half, tan_x, tan_y);
    const data::Vec3d target = 0.5 * (data::to_double(bounds_min) + data::to_double(bounds_max));
    SHD_TRY(place_camera(target, axes[2], distance, 1.01 * data::length(half), &made));
    shd_view view;
    SHD_TRY(read_camera(&made, 1.0f, &view));  // a camera that shd_render() takes
    write_desc(made, camera);
    return SHD_OK;
  });
}

extern "C" shd_result shd_view_from_camera(const shd_camera* camera, shd_view* out_view) {
  using namespace shd::abi;
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_view", out_view));
    std::memset(out_view, 0, sizeof *out_view);
    return read_camera(camera, 1.0f, out_view);
  });
}
