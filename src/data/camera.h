// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "data/trig.h"
#include "data/vec3.h"

namespace shd::data {

inline Vec3d to_double(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

/// Axes of a view in world space: right, up, and back, from the target to the eye. Returns false if eye and target
/// coincide, or if up lies within 1e-6 rad of the line of sight.
inline bool find_axes(const float eye[3], const float target[3], const float up[3], Vec3d out[3]) {
  const Vec3d back = normalized(to_double(eye) - to_double(target));
  const Vec3d side = cross(normalized(to_double(up)), back);
  if (!(length(side) > 1e-6)) return false;
  out[0] = normalized(side);
  out[1] = cross(back, out[0]);
  out[2] = back;
  return true;
}

/// Distance from the centre of a box at which it fills a view with these axes: the nearest one at which all corners are
/// in the picture. A corner at (x, y) of the view, with z towards the eye, is in it if |x| <= tan_x (distance - z) and
/// |y| <= tan_y (distance - z). `half` is half of the size of the box.
inline double framing_distance(const Vec3d axes[3], const Vec3d& half, double tan_x, double tan_y) {
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d q = {corner & 1 ? half.x : 0.0 - half.x, corner & 2 ? half.y : 0.0 - half.y,
                     corner & 4 ? half.z : 0.0 - half.z};
    const double x = std::fabs(dot(axes[0], q)) / tan_x, y = std::fabs(dot(axes[1], q)) / tan_y;
    distance = std::fmax(distance, std::fmax(x, y) + dot(axes[2], q));
  }
  return distance;
}

/// World-to-view matrix [16], column-major, with these axes: the eye is at the origin and looks along -Z, with +Y up.
/// Computed in double and rounded once. Elements beyond the range of float are infinite.
inline void look_at(const float eye[3], const Vec3d axes[3], float out[16]) {
  const Vec3d origin = to_double(eye);
  for (int r = 0; r < 3; ++r) {
    out[r] = static_cast<float>(axes[r].x);
    out[4 + r] = static_cast<float>(axes[r].y);
    out[8 + r] = static_cast<float>(axes[r].z);
    out[12 + r] = static_cast<float>(0.0 - dot(axes[r], origin));
    out[4 * r + 3] = 0.0f;
  }
  out[15] = 1.0f;
}

}  // namespace shd::data
