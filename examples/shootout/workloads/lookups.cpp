// SPDX-License-Identifier: MIT
#include "workload.h"

namespace shootout {

Lookups lookups_of(const Workload& workload, uint32_t phases) {
  constexpr double kStep = 1e-3;
  Lookups q;
  const auto add = [](std::vector<float>* column, double value) { column->push_back(static_cast<float>(value)); };
  for (std::vector<float>* column : {&q.u, &q.v, &q.dudx, &q.dvdx, &q.dudy, &q.dvdy}) {
    column->reserve(workload.count() * phases * phases);
  }
  for (uint32_t row = 0; row < workload.edge * phases; ++row) {
    for (uint32_t column = 0; column < workload.edge * phases; ++column) {
      const uint32_t x = column / phases, y = row / phases;
      const double dx = static_cast<double>(column % phases) / phases, dy = static_cast<double>(row % phases) / phases;
      const Point at = workload.at(x, y, dx, dy);
      const Point left = workload.at(x, y, dx - kStep, dy), right = workload.at(x, y, dx + kStep, dy);
      const Point above = workload.at(x, y, dx, dy - kStep), below = workload.at(x, y, dx, dy + kStep);
      add(&q.u, at.u);
      add(&q.v, at.v);
      add(&q.dudx, (right.u - left.u) / (2 * kStep));
      add(&q.dvdx, (right.v - left.v) / (2 * kStep));
      add(&q.dudy, (below.u - above.u) / (2 * kStep));
      add(&q.dvdy, (below.v - above.v) / (2 * kStep));
    }
  }
  return q;
}

}  // namespace shootout
