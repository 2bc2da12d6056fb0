// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "data/trig.h"

namespace shd::data {

/// World-to-view matrix [16], column-major: the eye at the origin looking along -Z, +Y up. Computed in double
/// and rounded once. False, and nothing written, when up is along the line of sight (within 1e-6 rad) or there is none.
/// Elements beyond the range of float come out infinite.
inline bool look_at(const float eye[3], const float target[3], const float up[3], float out[16]) {
  const auto unit = [](double v[3]) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3; ++k) v[k] = v[k] / length;
    return length;
  };
  const auto cross = [](const double a[3], const double b[3], double c[3]) {
    for (int k = 0; k < 3; ++k) c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  };
  double back[3], top[3], right[3];
  for (int k = 0; k < 3; ++k) {
    back[k] = double{eye[k]} - double{target[k]};
    top[k] = double{up[k]};
  }
  unit(back);
  unit(top);
  cross(top, back, right);
  if (!(unit(right) > 1e-6)) return false;
  cross(back, right, top);

  const double* const rows[3] = {right, top, back};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out[4 * c + r] = static_cast<float>(rows[r][c]);
    const double shift = rows[r][0] * eye[0] + rows[r][1] * eye[1] + rows[r][2] * eye[2];
    out[12 + r] = static_cast<float>(0.0 - shift);
    out[4 * r + 3] = 0.0f;
  }
  out[15] = 1.0f;
  return true;
}

/// View-to-clip matrix [16], column-major: NDC y up, depth 0 at the near plane and 1 at the far plane.
/// fov_y in (0, pi) [rad], aspect = width / height. Computed in double and rounded once.
/// After the perspective projection of the Vulkan specification's clip space with y up.
inline void perspective(float fov_y, float aspect, float near_plane, float far_plane, float out[16]) {
  const double focal = 1.0 / tan(0.5 * fov_y);
  const double range = double{near_plane} - double{far_plane};
  for (int i = 0; i < 16; ++i) out[i] = 0.0f;
  out[0] = static_cast<float>(focal / aspect);
  out[5] = static_cast<float>(focal);
  out[10] = static_cast<float>(far_plane / range);
  out[11] = -1.0f;
  out[14] = static_cast<float>(double{near_plane} * far_plane / range);
}

}  // namespace shd::data
