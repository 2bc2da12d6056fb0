// SPDX-License-Identifier: MIT
#pragma once

#include <shd/view.h>

#include "data/vec3.h"

namespace shd::abi {

/// Matrices of a camera of any version. `picture_aspect` stands in for an aspect of 0. Writes nothing on failure.
shd_result read_camera(const shd_camera* camera, float picture_aspect, shd_view* out);

/// Reads a camera of any version and checks each field.
shd_result check_camera(const shd_camera* camera, shd_camera* out);

/// The parts of a camera; errors name `name` and the field.
shd_result check_projection(const char* name, float fov_y, float near_plane, float far_plane, bool may_be_infinite);
shd_result check_positive(const char* name, const char* field, float value);

/// The axes of data::find_axes(), and the matrix of data::look_at(); errors name `name` and the field.
shd_result make_axes(const char* name, const float eye[3], const float target[3], const float up[3],
                     data::Vec3d out[3]);
shd_result make_look_at(const char* name, const float eye[3], const float target[3], const float up[3], float out[16]);

}  // namespace shd::abi
