// SPDX-License-Identifier: MIT
#include "scene/bounds.h"

#include <algorithm>
#include <cmath>

namespace shd::scene {
namespace {

/// Extends a box, which is initially empty, by the vertices of an instance.
void grow(const Geometry& geometry, const Matrix& m, bool* empty, Bounds* box) {
  for (const uint32_t vertex : geometry.indices) {
    double p[3], world[3];
    for (size_t c = 0; c < 3; ++c) p[c] = double{geometry.position[size_t{3} * vertex + c]} + geometry.origin[c];
    bool finite = true;
    for (size_t r = 0; r < 3; ++r) {
      world[r] = m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r];
      finite = finite && std::fabs(world[r]) < 3.4e38;
    }
    if (!finite) continue;
    for (size_t r = 0; r < 3; ++r) {
      box->low[r] = *empty ? world[r] : std::min(box->low[r], world[r]);
      box->high[r] = *empty ? world[r] : std::max(box->high[r], world[r]);
    }
    *empty = false;
  }
}

}  // namespace

double Bounds::radius() const {
  double square = 0.0;
  for (int c = 0; c < 3; ++c) square += (high[c] - low[c]) * (high[c] - low[c]);
  return std::max(0.5 * std::sqrt(square), 1e-30);
}

Bounds bounds_of(const Model& model, const std::vector<Instance>& instances) {
  Bounds box;
  bool empty = true;
  for (const Instance& instance : instances) {
    grow(model.geometries[instance.geometry], instance.object_to_world, &empty, &box);
  }
  return box;
}

}  // namespace shd::scene
