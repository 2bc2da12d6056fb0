// SPDX-License-Identifier: MIT
#include "model.h"

#include <algorithm>
#include <cmath>

namespace {

struct Box {
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

void grow(Box& box, const float* m, const float* p) {
  double world[3];
  for (int row = 0; row < 3; ++row) {
    world[row] = double(m[row]) * p[0] + double(m[4 + row]) * p[1] + double(m[8 + row]) * p[2] + m[12 + row];
    if (!std::isfinite(world[row])) return;
  }
  for (int c = 0; c < 3; ++c) {
    box.low[c] = std::min(box.low[c], world[c]);
    box.high[c] = std::max(box.high[c], world[c]);
  }
}

}  // namespace

Bounds bounds_of(const Model& model) {
  Box box;
  for (const Instance& instance : model.instances) {
    const Geometry& geometry = model.geometries[instance.geometry];
    for (const uint32_t vertex : geometry.indices) {
      grow(box, instance.object_to_world.data(), &geometry.position[size_t{3} * vertex]);
    }
  }
  Bounds bounds;
  if (box.low[0] > box.high[0]) return bounds;
  double diagonal = 0.0;
  for (int c = 0; c < 3; ++c) {
    bounds.center[c] = static_cast<float>(0.5 * (box.low[c] + box.high[c]));
    diagonal += (box.high[c] - box.low[c]) * (box.high[c] - box.low[c]);
  }
  bounds.bottom = static_cast<float>(box.low[1]);
  bounds.radius = std::max(static_cast<float>(0.5 * std::sqrt(diagonal)), 1e-6f);
  return bounds;
}
