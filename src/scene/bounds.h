// SPDX-License-Identifier: MIT
#pragma once

#include "scene/model.h"

namespace shd::scene {

/// The box around all placed vertices that triangles use, world space; what is not finite there is left out. Zero if
/// nothing is.
struct Bounds {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  /// Half the diagonal, at least 1e-6.
  double radius() const;
};

Bounds bounds_of(const Model& model);

}  // namespace shd::scene
