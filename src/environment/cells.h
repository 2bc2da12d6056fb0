// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/context.h"

namespace shd::environment {

/// Light of a square cell of the octahedral map, as if all of it came from one direction.
struct Cell {
  float x, y, z;      // mean direction, weighted by the light; unit
  float radius;       // largest distance of a point of the cell from that direction, on the unit sphere
  float flux[3];      // sum of radiance times solid angle
  float solid_angle;  // 0 = empty
};

/// A quadtree of cells: level l is a map of [kRootCells << l][kRootCells << l] cells.
constexpr uint32_t kRootCells = 4;
constexpr uint32_t kMaxCellLevels = 8;  // up to 512 x 512
struct CellTree {
  uint32_t levels;
  core::Array<Cell> cells;
  size_t first[kMaxCellLevels];  // first cell of each level
  float floor;                   // small radiance that is added to the weights, so that dark cells have a direction

  uint32_t side(uint32_t level) const { return kRootCells << level; }
};

/// An empty tree whose finest level has `side` cells a side, a power of two of 4..512. Throws std::bad_alloc.
CellTree make_cells(const core::Allocator& allocator, uint32_t side, float floor);

/// Adds light from a unit direction, whose point in the projection OCTAHEDRAL is (u, v), to the finest level.
void add_light(CellTree* tree, float u, float v, const float direction[3], const float radiance[3], float solid_angle);

/// Completes the finest level, and computes the other levels from it.
void finish_cells(const core::SimdTarget& simd, CellTree* tree);

}  // namespace shd::environment
