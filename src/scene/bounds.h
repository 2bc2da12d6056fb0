// SPDX-License-Identifier: MIT
#pragma once

#include "scene/pose.h"

namespace shd::scene {

/// The box around the vertices that triangles of instances use, world space. Vertices that are not finite are ignored.
/// Zero if no vertex is finite.
struct Bounds {
  std::array<double, 3> low = {0, 0, 0}, high = {0, 0, 0};
  bool is_empty = true;
  /// Half the diagonal, at least 1e-30.
  double radius() const;
  std::array<double, 3> center() const;
};

/// Extends a box by the vertices [vertex][3] that indices name, through a matrix.
void grow(const std::vector<float>& position, const std::vector<uint32_t>& indices, const Matrix& to_world,
          Bounds* box);

/// A matrix after a translation, so that it takes positions without `origin`.
Matrix with_origin(const Matrix& matrix, const std::array<double, 3>& origin);

Bounds bounds_of(const Model& model, const std::vector<Instance>& instances);

/// The point to which coordinates are moved before they become floats: the centre of the box if it is so far from 0
/// that floats lose much of the extent, else 0.
std::array<double, 3> origin_of(const Bounds& box);

}  // namespace shd::scene
