// SPDX-License-Identifier: MIT
#include "scene/bounds.h"

#include <algorithm>
#include <cmath>

namespace shd::scene {
namespace {

// A float has 2^-24 of its value: at this distance the rounding error is 2^-14 of the radius.
constexpr double kFarRadii = 1024;

}  // namespace

void grow(const std::vector<float>& position, const std::vector<uint32_t>& indices, const Matrix& to_world,
          Bounds* box) {
  for (const uint32_t vertex : indices) {
    const float* p = &position[size_t{3} * vertex];
    const std::array<double, 3> world =
        transform(to_world, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    const bool finite = std::all_of(world.begin(), world.end(), [](double c) { return std::fabs(c) < 3.4e38; });
    if (!finite) continue;
    for (size_t r = 0; r < 3; ++r) {
      box->low[r] = box->is_empty ? world[r] : std::min(box->low[r], world[r]);
      box->high[r] = box->is_empty ? world[r] : std::max(box->high[r], world[r]);
    }
    box->is_empty = false;
  }
}

Matrix with_origin(const Matrix& matrix, const std::array<double, 3>& origin) {
  Matrix out = matrix;
  const std::array<double, 3> moved = transform(matrix, origin);
  std::copy(moved.begin(), moved.end(), out.begin() + 12);
  return out;
}

double Bounds::radius() const {
  double square = 0.0;
  for (size_t c = 0; c < 3; ++c) square += (high[c] - low[c]) * (high[c] - low[c]);
  return std::max(0.5 * std::sqrt(square), 1e-30);
}

std::array<double, 3> Bounds::center() const {
  return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
}

Bounds bounds_of(const Model& model, const std::vector<Instance>& instances) {
  Bounds box;
  for (const Instance& instance : instances) {
    const Geometry& geometry = model.geometries[instance.geometry];
    grow(geometry.position, geometry.indices, with_origin(instance.object_to_world, geometry.origin), &box);
  }
  return box;
}

std::array<double, 3> origin_of(const Bounds& box) {
  const std::array<double, 3> center = box.center();
  const double away = std::max({std::fabs(center[0]), std::fabs(center[1]), std::fabs(center[2])});
  return away > kFarRadii * box.radius() ? center : std::array<double, 3>{0, 0, 0};
}

}  // namespace shd::scene
