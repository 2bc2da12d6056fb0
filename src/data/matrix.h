// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace shd::data {

/// Three components; space and unit are the user's.
struct Vec3 {
  float x, y, z;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(float s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// a / |a|, scaled by the largest component first so that nothing over- or underflows; 0 stays 0.
inline Vec3 normalized(Vec3 a) {
  const float largest = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
  if (!(largest > 0.0f) || std::isinf(largest)) return {0.0f, 0.0f, 0.0f};
  const Vec3 b = {a.x / largest, a.y / largest, a.z / largest};
  const float length = std::sqrt(dot(b, b));
  return {b.x / length, b.y / length, b.z / length};
}

/// Column-major 4x4 matrix acting on column vectors: element (row r, column c) is m[4 * c + r].
struct Mat4 {
  float m[16];
};

inline Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 product;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      float sum = a.m[r] * b.m[4 * c];
      for (int k = 1; k < 4; ++k) sum += a.m[4 * k + r] * b.m[4 * c + k];
      product.m[4 * c + r] = sum;
    }
  }
  return product;
}

}  // namespace shd::data
