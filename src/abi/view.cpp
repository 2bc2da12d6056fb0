// SPDX-License-Identifier: MIT
#include <shd/view.h>

#include <cmath>
#include <cstring>

#include "abi/desc.h"
#include "abi/guard.h"
#include "data/camera.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_result check_positive(const char* field, float value) {
  if (value > 0.0f && std::isfinite(value)) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %g is not above 0 and finite", field, static_cast<double>(value));
}

shd_result check_camera(const shd_camera& camera) {
  SHD_TRY(check_positive("camera.fov_y", camera.fov_y));
  if (!(static_cast<double>(camera.fov_y) < data::kPi)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "camera.fov_y: %g is not below pi",
                      static_cast<double>(camera.fov_y));
  }
  SHD_TRY(check_positive("camera.aspect", camera.aspect));
  SHD_TRY(check_positive("camera.near_plane", camera.near_plane));
  SHD_TRY(check_positive("camera.far_plane", camera.far_plane));
  if (!(camera.far_plane > camera.near_plane)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "camera.far_plane: %g is not above near_plane %g",
                      static_cast<double>(camera.far_plane), static_cast<double>(camera.near_plane));
  }
  SHD_TRY(check_finite("camera.eye", camera.eye, 3));
  SHD_TRY(check_finite("camera.target", camera.target, 3));
  SHD_TRY(check_finite("camera.up", camera.up, 3));
  const float *eye = camera.eye, *target = camera.target, *up = camera.up;
  if (eye[0] == target[0] && eye[1] == target[1] && eye[2] == target[2]) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "camera.target: is the eye");
  }
  if (up[0] == 0.0f && up[1] == 0.0f && up[2] == 0.0f) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "camera.up: (0, 0, 0) has no direction");
  }
  return SHD_OK;
}

shd_result check_matrix(const char* what, const float* matrix) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(matrix[i])) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "camera: its %s exceeds the range of float", what);
    }
  }
  return SHD_OK;
}

}  // namespace

extern "C" shd_result shd_view_from_camera(const shd_camera* camera, shd_view* out_view) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_view", out_view));
    std::memset(out_view, 0, sizeof *out_view);
    shd_camera read = shd_camera_default();
    SHD_TRY(read_desc("camera", camera, false, &read));
    SHD_TRY(check_camera(read));
    shd_view view = {};
    if (!data::look_at(read.eye, read.target, read.up, view.world_to_view)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "camera.up: lies along the line of sight");
    }
    data::perspective(read.fov_y, read.aspect, read.near_plane, read.far_plane, view.view_to_clip);
    SHD_TRY(check_matrix("world_to_view (eye, target)", view.world_to_view));
    SHD_TRY(check_matrix("view_to_clip (fov_y, aspect, near_plane, far_plane)", view.view_to_clip));
    for (int axis = 0; axis < 3; ++axis) view.eye[axis] = read.eye[axis];
    *out_view = view;
    return SHD_OK;
  });
}
