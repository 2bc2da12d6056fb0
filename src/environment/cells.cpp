// SPDX-License-Identifier: MIT
#include "environment/cells.h"

#include <algorithm>
#include <cmath>

#include "environment/map.h"

namespace shd::environment {
namespace {

constexpr uint32_t kPoints = 5;  // points of a cell: its centre and its corners

/// Turns the sums of a cell into its direction and radius. Its points are those from `first` on.
void finish(const MapPoints& points, size_t first, Cell* cell) {
  const float length = std::sqrt(cell->x * cell->x + cell->y * cell->y + cell->z * cell->z);
  const bool has_direction = length > 0.0f && cell->solid_angle > 0.0f;
  const float inverse = has_direction ? 1.0f / length : 0.0f;
  cell->x = has_direction ? cell->x * inverse : points.x[first];
  cell->y = has_direction ? cell->y * inverse : points.y[first];
  cell->z = has_direction ? cell->z * inverse : points.z[first];
  float largest = 0.0f;
  for (size_t k = first + 1; k < first + kPoints; ++k) {
    const float dx = points.x[k] - cell->x, dy = points.y[k] - cell->y, dz = points.z[k] - cell->z;
    largest = std::max(largest, dx * dx + dy * dy + dz * dz);
  }
  cell->radius = std::sqrt(largest);
}

/// Adds a finished cell to the sums of its parent. The weight of its direction is its light.
void add_cell(const Cell& cell, Cell* parent, float floor) {
  const float weight = cell.flux[0] + cell.flux[1] + cell.flux[2] + floor * cell.solid_angle;
  parent->x += weight * cell.x;
  parent->y += weight * cell.y;
  parent->z += weight * cell.z;
  for (int c = 0; c < 3; ++c) parent->flux[c] += cell.flux[c];
  parent->solid_angle += cell.solid_angle;
}

/// Finds the points of cells i to end - 1 of row j of a map of `side` cells.
void find_points(const core::SimdTarget& simd, uint32_t side, uint32_t i, uint32_t end, uint32_t j, MapPoints* points) {
  points->count = 0;
  for (; i < end; ++i) {
    const auto x = static_cast<float>(i), y = static_cast<float>(j);
    points->add(side, x + 0.5f, y + 0.5f);
    for (uint32_t k = 0; k < 4; ++k) points->add(side, static_cast<float>(i + k % 2), static_cast<float>(j + k / 2));
  }
  points->find(simd);
}

}  // namespace

CellTree make_cells(const core::Allocator& allocator, uint32_t side, float floor) {
  CellTree tree = {};
  size_t count = 0;
  do {
    tree.first[tree.levels] = count;
    count += size_t{tree.side(tree.levels)} * tree.side(tree.levels);
  } while (tree.side(tree.levels++) < side);
  tree.cells = core::Array<Cell>(allocator, count);
  tree.cells.fill_zero();
  tree.floor = floor;
  return tree;
}

void add_light(CellTree* tree, float u, float v, const float direction[3], const float radiance[3], float solid_angle) {
  const uint32_t level = tree->levels - 1, side = tree->side(level);
  const auto i = std::min(static_cast<uint32_t>(u * static_cast<float>(side)), side - 1);
  const auto j = std::min(static_cast<uint32_t>(v * static_cast<float>(side)), side - 1);
  const Cell light = {direction[0],
                      direction[1],
                      direction[2],
                      0.0f,
                      {radiance[0] * solid_angle, radiance[1] * solid_angle, radiance[2] * solid_angle},
                      solid_angle};
  add_cell(light, &tree->cells[tree->first[level] + size_t{j} * side + i], tree->floor);
}

void finish_cells(const core::SimdTarget& simd, CellTree* tree) {
  constexpr auto kBlock = static_cast<uint32_t>(MapPoints::kMost / kPoints);
  MapPoints points;
  for (uint32_t level = tree->levels; level-- > 0;) {
    const uint32_t side = tree->side(level);
    for (uint32_t j = 0; j < side; ++j) {
      for (uint32_t i = 0; i < side; ++i) {
        Cell* cell = &tree->cells[tree->first[level] + size_t{j} * side + i];
        if (i % kBlock == 0) find_points(simd, side, i, std::min(side, i + kBlock), j, &points);
        finish(points, size_t{kPoints} * (i % kBlock), cell);
        if (level == 0 || cell->solid_angle == 0.0f) continue;
        const size_t parent = tree->first[level - 1] + size_t{j / 2} * (side / 2) + i / 2;
        add_cell(*cell, &tree->cells[parent], tree->floor);
      }
    }
  }
}

}  // namespace shd::environment
