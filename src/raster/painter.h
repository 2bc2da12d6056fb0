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

/// Replaces the contents of the groups by at(0), ..., at(count - 1), in parts of equal size; `at` may read the old
/// contents. Throws Failure and std::bad_alloc.
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

/// The painter's algorithm: a stable sort of the triangles of all groups by their farthest vertex, far ones first.
/// Triangles that are not painted follow in submission order. Returns the number of painted triangles. O(n log n).
/// Throws Failure and std::bad_alloc.
/// @param rules  [draw]
size_t sort_far_to_near(const core::Context& context, const PaintRule* rules, core::Objects<TriangleGroup>* groups);

/// Counts pairs of triangles that are painted in the wrong order, which means that may_precede() is false. Compares the
/// pairs of each cell of the grid, up to 64 times its number of triangles plus 1024. Throws Failure and std::bad_alloc.
/// @param grid  built from triangles[order[0]], triangles[order[1]], ..., in the order of painting
uint64_t count_conflicts(const core::Context& context, const SortTriangle* triangles, const SortGrid& grid);

}  // namespace shd::raster
