// SPDX-License-Identifier: MIT
/// @file
/// Faces of a cube in doubles, by the tables of Vulkan and OpenGL: "Cube Map Face Selection".
#pragma once

#include <cmath>
#include <cstdint>

namespace shd::texture {

/// Component of a vector, 1..3 for x, y, z; negative = with the other sign.
struct CubeFace {
  int axis, right, down;
};
constexpr CubeFace kCubeFaces[6] = {{1, -3, -2}, {-1, 3, -2}, {2, 1, 3}, {-2, 1, -3}, {3, 1, -2}, {-3, -1, -2}};

template <class T>
T component(const T (&vector)[3], int axis) {
  return axis > 0 ? vector[axis - 1] : -vector[-axis - 1];
}

template <class T>
void set_component(int axis, T value, T (&vector)[3]) {
  vector[(axis > 0 ? axis : -axis) - 1] = axis > 0 ? value : -value;
}

/// Returns the face at which a signed axis points.
inline uint32_t face_at(int axis) {
  return static_cast<uint32_t>((axis > 0 ? axis - 1 : -axis - 1) * 2 + (axis < 0));
}

}  // namespace shd::texture
