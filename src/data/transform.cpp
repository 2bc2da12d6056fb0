// SPDX-License-Identifier: MIT
#include "data/transform.h"

#include <cmath>

#include "data/camera.h"

namespace shd::data {

void perspective(double fov_y, double aspect, double near_plane, double far_plane, bool reversed, double out[16]) {
  const double focal = 1.0 / tan(0.5 * fov_y), range = far_plane - near_plane;
  for (int i = 0; i < 16; ++i) out[i] = 0.0;
  out[0] = focal / aspect;
  out[5] = focal;
  out[11] = -1.0;
  if (std::isinf(far_plane)) {
    out[10] = reversed ? 0.0 : -1.0;
    out[14] = reversed ? near_plane : -near_plane;
  } else {
    out[10] = reversed ? near_plane / range : -(far_plane / range);
    out[14] = near_plane * far_plane / (reversed ? range : -range);
  }
}

void perspective(float fov_y, float aspect, float near_plane, float far_plane, float out[16]) {
  double matrix[16];
  perspective(double{fov_y}, double{aspect}, double{near_plane}, double{far_plane}, false, matrix);
  for (int i = 0; i < 16; ++i) out[i] = static_cast<float>(matrix[i]);
}

void orthographic(const float rectangle[4], double near_plane, double far_plane, bool reversed, double out[16]) {
  for (int i = 0; i < 16; ++i) out[i] = 0.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = static_cast<double>(rectangle[2 * axis]), high = static_cast<double>(rectangle[2 * axis + 1]);
    out[5 * axis] = 2.0 / (high - low);
    out[12 + axis] = 0.0 - (high + low) / (high - low);
  }
  const double range = far_plane - near_plane;
  out[10] = reversed ? 1.0 / range : -1.0 / range;
  out[14] = (reversed ? far_plane : 0.0 - near_plane) / range;
  out[15] = 1.0;
}

void from_trs(const float translation[3], const float rotation[4], const float scale[3], double out[16]) {
  double q[4], square = 0.0;
  for (int i = 0; i < 4; ++i) q[i] = static_cast<double>(rotation[i]);
  for (int i = 0; i < 4; ++i) square += q[i] * q[i];
  const double s = 2.0 / square;
  const double columns[3][3] = {
      {1.0 - s * (q[1] * q[1] + q[2] * q[2]), s * (q[0] * q[1] + q[2] * q[3]), s * (q[0] * q[2] - q[1] * q[3])},
      {s * (q[0] * q[1] - q[2] * q[3]), 1.0 - s * (q[0] * q[0] + q[2] * q[2]), s * (q[1] * q[2] + q[0] * q[3])},
      {s * (q[0] * q[2] + q[1] * q[3]), s * (q[1] * q[2] - q[0] * q[3]), 1.0 - s * (q[0] * q[0] + q[1] * q[1])}};
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) out[4 * c + r] = columns[c][r] * static_cast<double>(scale[c]);
    out[4 * c + 3] = 0.0;
    out[12 + c] = static_cast<double>(translation[c]);
  }
  out[15] = 1.0;
}

}  // namespace shd::data
