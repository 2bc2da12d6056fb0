// SPDX-License-Identifier: MIT
#pragma once

namespace shd::data {

/// Matrices of shd/transform.h, column-major, from checked values to doubles that the caller rounds once.

/// View-to-clip matrix of a perspective projection. far_plane may be infinite. reversed: depth 1 near, 0 far.
void perspective(double fov_y, double aspect, double near_plane, double far_plane, bool reversed, double out[16]);

/// Perspective projection of floats with a finite far plane, depth 0 near .. 1 far, rounded once.
void perspective(float fov_y, float aspect, float near_plane, float far_plane, float out[16]);

/// View-to-clip matrix of a parallel projection; rectangle: left, right, bottom, top.
void orthographic(const float rectangle[4], double near_plane, double far_plane, bool reversed, double out[16]);

/// translation * rotation * scale. The quaternion x, y, z, w is not 0.
void from_trs(const float translation[3], const float rotation[4], const float scale[3], double out[16]);

}  // namespace shd::data
