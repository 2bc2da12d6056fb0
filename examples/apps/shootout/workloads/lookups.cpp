// SPDX-License-Identifier: MIT
#include "workload.h"

namespace shootout {

Lookups lookups_of(const Workload& workload, uint32_t phases) {
  Lookups q;
  for (std::vector<float>* column : {&q.u, &q.v, &q.dudx, &q.dvdx, &q.dudy, &q.dvdy}) {
    column->reserve(workload.count() * phases * phases);
  }
  for (uint32_t row = 0; row < workload.edge * phases; ++row) {
    for (uint32_t column = 0; column < workload.edge * phases; ++column) {
      const uint32_t x = column / phases, y = row / phases;
      const double dx = static_cast<double>(column % phases) / phases, dy = static_cast<double>(row % phases) / phases;
      shd::bench::add_lookup([&](double ex, double ey) { return workload.at(x, y, dx + ex, dy + ey); }, &q);
    }
  }
  return q;
}

}  // namespace shootout
