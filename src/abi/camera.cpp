// SPDX-License-Identifier: MIT
#include "abi/camera.h"

#include <cmath>
#include "abi/desc.h"
#include "data/camera.h"
#include "data/transform.h"

namespace shd::abi {
namespace {

shd_result check_finite_matrix(const char* what, const float* matrix) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(matrix[i])) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "camera: its %s exceeds the range of float", what);
    }
  }
  return SHD_OK;
}

}  // namespace

shd_result check_positive(const char* name, const char* field, float value) {
  if (value > 0.0f && std::isfinite(value)) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.%s: %g is not above 0 and finite", name, field,
                    static_cast<double>(value));
}

shd_result check_projection(const char* name, float fov_y, float near_plane, float far_plane, bool may_be_infinite) {
  SHD_TRY(check_positive(name, "fov_y", fov_y));
  if (!(static_cast<double>(fov_y) < data::kPi)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.fov_y: %g is not below pi", name, static_cast<double>(fov_y));
  }
  SHD_TRY(check_positive(name, "near_plane", near_plane));
  if (!(may_be_infinite && std::isinf(far_plane) && far_plane > 0.0f)) {
    SHD_TRY(check_positive(name, "far_plane", far_plane));
  }
  if (far_plane > near_plane) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.far_plane: %g is not above near_plane %g", name,
                    static_cast<double>(far_plane), static_cast<double>(near_plane));
}

shd_result make_axes(const char* name, const float eye[3], const float target[3], const float up[3],
                     data::Vec3d out[3]) {
  SHD_TRY(check_finite(FieldName(name, "eye"), eye, 3));
  SHD_TRY(check_finite(FieldName(name, "target"), target, 3));
  SHD_TRY(check_finite(FieldName(name, "up"), up, 3));
  if (eye[0] == target[0] && eye[1] == target[1] && eye[2] == target[2]) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.target: is the eye", name);
  }
  if (up[0] == 0.0f && up[1] == 0.0f && up[2] == 0.0f) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.up: (0, 0, 0) has no direction", name);
  }
  if (data::find_axes(eye, target, up, out)) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.up: lies along the line of sight", name);
}

shd_result make_look_at(const char* name, const float eye[3], const float target[3], const float up[3], float out[16]) {
  data::Vec3d axes[3] = {};
  SHD_TRY(make_axes(name, eye, target, up, axes));
  data::look_at(eye, axes, out);
  return SHD_OK;
}

shd_result check_camera(const shd_camera* camera, shd_camera* out) {
  *out = shd_camera_default();
  SHD_TRY(read_desc("camera", camera, false, out));
  SHD_TRY(check_projection("camera", out->fov_y, out->near_plane, out->far_plane, false));
  return out->aspect != 0.0f ? check_positive("camera", "aspect", out->aspect) : SHD_OK;
}

shd_result read_camera(const shd_camera* camera, float picture_aspect, shd_view* out) {
  shd_camera read;
  SHD_TRY(check_camera(camera, &read));
  shd_view view = {};
  SHD_TRY(make_look_at("camera", read.eye, read.target, read.up, view.world_to_view));
  const float aspect = read.aspect != 0.0f ? read.aspect : picture_aspect;
  data::perspective(read.fov_y, aspect, read.near_plane, read.far_plane, view.view_to_clip);
  SHD_TRY(check_finite_matrix("world_to_view (eye, target)", view.world_to_view));
  SHD_TRY(check_finite_matrix("view_to_clip (fov_y, aspect, near_plane, far_plane)", view.view_to_clip));
  for (int axis = 0; axis < 3; ++axis) view.eye[axis] = read.eye[axis];
  *out = view;
  return SHD_OK;
}

}  // namespace shd::abi
