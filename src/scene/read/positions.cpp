// SPDX-License-Identifier: MIT
#include "scene/read/positions.h"

#include <algorithm>
#include <cmath>

namespace shd::scene {
namespace {

constexpr double kModelRatio = 16;       // 4 of the 24 digits of a float are lost at this distance
constexpr double kGeometryRatio = 4096;  // 12 digits

/// `base`, or a place near the middle of the positions if it is more than `ratio` times as far away as they extend.
Point origin_of(const std::vector<double>& positions, const Point& base, double ratio) {
  if (positions.empty()) return base;
  Point low = {positions[0], positions[1], positions[2]}, high = low, origin = base;
  for (size_t i = 0; i < positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  double extent = 0, away = 0;
  for (size_t c = 0; c < 3; ++c) {
    extent = std::max(extent, high[c] - low[c]);
    away = std::max(away, std::fabs(0.5 * (low[c] + high[c]) - base[c]));
  }
  if (away <= ratio * extent) return base;
  // The smallest extent is a rounding step of the doubles, so that the multiple below is finite.
  const double step = std::exp2(std::floor(std::log2(std::max(extent, away * 0x1p-50))));
  for (size_t c = 0; c < 3; ++c) origin[c] = std::round(0.5 * (low[c] + high[c]) / step) * step;
  return origin;
}

}  // namespace

Point choose_origin(const std::vector<double>& positions) {
  return origin_of(positions, {0, 0, 0}, kModelRatio);
}

void set_positions(Geometry& geometry, const std::vector<double>& positions, const Point& base) {
  geometry.origin = origin_of(positions, base, kGeometryRatio);
  geometry.position.resize(positions.size());
  for (size_t i = 0; i < positions.size(); ++i) {
    geometry.position[i] = static_cast<float>(positions[i] - geometry.origin[i % 3]);
  }
}

void set_positions(Geometry& geometry, const std::vector<double>& positions) {
  set_positions(geometry, positions, choose_origin(positions));
}

}  // namespace shd::scene
