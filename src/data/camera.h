// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "data/trig.h"
#include "data/vec3.h"

namespace shd::data {

/// World-to-view matrix [16], column-major: the eye is at the origin and looks along -Z, with +Y up. Computed in double
/// and rounded once. Returns false and writes nothing if eye and target coincide, or if up lies within 1e-6 rad of the
/// line of sight. Elements beyond the range of float are infinite.
inline bool look_at(const float eye[3], const float target[3], const float up[3], float out[16]) {
  const Vec3d origin = {double{eye[0]}, double{eye[1]}, double{eye[2]}};
  const Vec3d back = normalized(origin - Vec3d{double{target[0]}, double{target[1]}, double{target[2]}});
  const Vec3d side = cross(normalized(Vec3d{double{up[0]}, double{up[1]}, double{up[2]}}), back);
  if (!(length(side) > 1e-6)) return false;
  const Vec3d right = normalized(side), top = cross(back, right);

  const Vec3d rows[3] = {right, top, back};
  for (int r = 0; r < 3; ++r) {
    out[r] = static_cast<float>(rows[r].x);
    out[4 + r] = static_cast<float>(rows[r].y);
    out[8 + r] = static_cast<float>(rows[r].z);
    out[12 + r] = static_cast<float>(0.0 - dot(rows[r], origin));
    out[4 * r + 3] = 0.0f;
  }
  out[15] = 1.0f;
  return true;
}

}  // namespace shd::data
