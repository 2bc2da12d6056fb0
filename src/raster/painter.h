// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/context.h"
#include "core/executor.h"
#include "raster/bin.h"
#include "raster/sort_grid.h"
#include "raster/sort_triangle.h"

namespace shd::raster {

/// Fills the groups anew with at(0), ..., at(count - 1), in parts of the same size; `at` may read the old ones. Throws.
template <class At>
void distribute(const core::Context& context, size_t count, const At& at, core::Objects<TriangleGroup>* groups) {
  const size_t parts = groups->size();
  core::Objects<TriangleGroup> filled(context.allocator, parts);
  core::parallel_for(context, static_cast<uint32_t>(parts), [&](uint32_t g, uint32_t) {
    const size_t begin = count * g / parts, end = count * (g + 1) / parts;
    filled[g].attach(context.allocator);
    filled[g].reserve(end - begin);
    for (size_t i = begin; i < end; ++i) filled[g].push_back(at(i));
  });
  for (size_t g = 0; g < parts; ++g) (*groups)[g] = std::move(filled[g]);
}

/// The painter's algorithm: sorts the triangles of all groups by their farthest vertex, far ones first, equal ones in
/// the order that they had. Those that are not painted follow, in the order that they had. Returns how many are
/// painted. O(n log n). Throws.
/// @param rules  [draw]
size_t sort_far_to_near(const core::Context& context, const PaintRule* rules, core::Objects<TriangleGroup>* groups);

/// Pairs of triangles that a later one should not cover where it does, by may_precede. Triangles that share a cell of
/// the grid are compared: every pair of them, up to 64 for each triangle of a cell on average and 1024 more in a cell.
/// Throws.
/// @param grid  made of triangles[order[0]], triangles[order[1]], ..., in the order of painting
uint64_t count_conflicts(const core::Context& context, const SortTriangle* triangles, const SortGrid& grid);

}  // namespace shd::raster
