// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace shd::data {

/// Three components; space and unit are the user's.
struct Vec3 {
  float x, y, z;
};

inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(float s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a / |a|, scaled by the largest component first so that nothing over- or underflows; 0 stays 0.
inline Vec3 normalized(Vec3 a) {
  const float largest = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
  if (!(largest > 0.0f) || std::isinf(largest)) return {0.0f, 0.0f, 0.0f};
  const Vec3 b = {a.x / largest, a.y / largest, a.z / largest};
  const float length = std::sqrt(dot(b, b));
  return {b.x / length, b.y / length, b.z / length};
}

}  // namespace shd::data
