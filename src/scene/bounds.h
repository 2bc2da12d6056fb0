// SPDX-License-Identifier: MIT
#pragma once

#include "scene/pose.h"

namespace shd::scene {

/// The box around all vertices that triangles of instances use, world space. Vertices that are not finite are ignored.
/// Zero if no vertex is finite.
struct Bounds {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  /// Half the diagonal, at least 1e-30.
  double radius() const;
};

Bounds bounds_of(const Model& model, const std::vector<Instance>& instances);

}  // namespace shd::scene
