// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

namespace shd::data {

/// Three components of a point or direction, for setup code. The user defines space and unit.
template <class T>
struct BasicVec3 {
  T x, y, z;
};
using Vec3 = BasicVec3<float>;
/// In double, products of up to four differences of finite floats neither overflow nor underflow.
using Vec3d = BasicVec3<double>;

template <class T>
BasicVec3<T> operator+(const BasicVec3<T>& a, const BasicVec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
BasicVec3<T> operator-(const BasicVec3<T>& a, const BasicVec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
BasicVec3<T> operator*(std::common_type_t<T> s, const BasicVec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const BasicVec3<T>& a, const BasicVec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
BasicVec3<T> cross(const BasicVec3<T>& a, const BasicVec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(const BasicVec3<T>& a) {
  return std::sqrt(dot(a, a));
}
template <class T>
bool is_zero(const BasicVec3<T>& a) {
  return a.x == T{0} && a.y == T{0} && a.z == T{0};
}

/// a / |a|. 0 for the zero vector, and where |a| overflows or is NaN.
inline Vec3d normalized(const Vec3d& a) {
  const double size = length(a);
  if (!(size > 0.0) || std::isinf(size)) return {0.0, 0.0, 0.0};
  return {a.x / size, a.y / size, a.z / size};
}

/// a / |a| for every length: dividing by the largest component first keeps the squares from overflow and underflow. 0
/// for the zero vector, and for infinite components.
inline Vec3 normalized(const Vec3& a) {
  const float largest = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
  if (!(largest > 0.0f) || std::isinf(largest)) return {0.0f, 0.0f, 0.0f};
  const Vec3 b = {a.x / largest, a.y / largest, a.z / largest};
  const float size = length(b);
  return {b.x / size, b.y / size, b.z / size};
}

}  // namespace shd::data
