// SPDX-License-Identifier: MIT
#include "scene/bounds.h"

#include <algorithm>
#include <cmath>

namespace shd::scene {
namespace {

/// Extends a box, which is initially empty, by the vertices of an instance.
void grow(const Geometry& geometry, const float* m, bool* empty, Bounds* box) {
  for (const uint32_t vertex : geometry.indices) {
    const float* p = &geometry.position[size_t{3} * vertex];
    double world[3];
    bool finite = true;
    for (int r = 0; r < 3; ++r) {
      world[r] = double{m[r]} * double{p[0]} + double{m[4 + r]} * double{p[1]} + double{m[8 + r]} * double{p[2]} +
                 double{m[12 + r]};
      finite = finite && std::fabs(world[r]) < 3.4e38;
    }
    if (!finite) continue;
    for (int r = 0; r < 3; ++r) {
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
  return std::max(0.5 * std::sqrt(square), 1e-6);
}

Bounds bounds_of(const Model& model) {
  Bounds box;
  bool empty = true;
  for (const Instance& instance : model.instances) {
    grow(model.geometries[instance.geometry], instance.object_to_world.data(), &empty, &box);
  }
  return box;
}

}  // namespace shd::scene
