// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace shd::data {

/// Three components in double. Products of differences of any finite floats neither overflow nor vanish there.
struct Vec3d {
  double x, y, z;
};

inline Vec3d operator+(Vec3d a, Vec3d b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3d operator-(Vec3d a, Vec3d b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3d operator*(double s, Vec3d a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(Vec3d a, Vec3d b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3d cross(Vec3d a, Vec3d b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3d a) {
  return std::sqrt(dot(a, a));
}
/// a / |a|; 0, and what is not finite, gives 0.
inline Vec3d normalized(Vec3d a) {
  const double size = length(a);
  if (!(size > 0.0) || std::isinf(size)) return {0.0, 0.0, 0.0};
  return {a.x / size, a.y / size, a.z / size};
}
inline bool is_zero(Vec3d a) {
  return a.x == 0.0 && a.y == 0.0 && a.z == 0.0;
}

}  // namespace shd::data
