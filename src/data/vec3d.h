// SPDX-License-Identifier: MIT
#pragma once

namespace shd::data {

/// Three components in double. Products of differences of any finite floats neither overflow nor vanish there.
struct Vec3d {
  double x, y, z;
};

inline Vec3d operator-(Vec3d a, Vec3d b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline double dot(Vec3d a, Vec3d b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3d cross(Vec3d a, Vec3d b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace shd::data
