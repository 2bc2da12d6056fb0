// SPDX-License-Identifier: MIT
#include "raster/painter.h"

#include <algorithm>
#include <limits>

namespace shd::raster {
namespace {

/// Sort key of a triangle.
struct Key {
  float distance;
  uint32_t group, entry;
};

/// A total order: no two keys are equal.
bool is_before(const Key& a, const Key& b) {
  if (a.distance != b.distance) return a.distance > b.distance;
  return a.group != b.group ? a.group < b.group : a.entry < b.entry;
}

constexpr uint64_t kPairsPerTriangle = 64;
constexpr uint64_t kPairsPerCell = 1024;

/// Counts conflicts between the triangles of one cell; each pair counts in the first of its shared cells.
uint64_t count_in_cell(const SortTriangle* triangles, const SortGrid& grid, int32_t x, int32_t y) {
  const SortNode* nodes = grid.nodes.data();
  const uint32_t head = grid.head[static_cast<size_t>(y) * static_cast<size_t>(grid.columns) + static_cast<size_t>(x)];
  uint64_t left = kPairsPerCell, conflicts = 0;
  for (uint32_t node = head; node != kNoNode; node = nodes[node].next) left += kPairsPerTriangle;
  for (uint32_t node = head; node != kNoNode; node = nodes[node].next) {
    const SortTriangle& first = triangles[nodes[node].triangle];
    const CellRange cells = cells_of(grid, first);
    for (uint32_t other = nodes[node].next; other != kNoNode && nodes[other].farthest > first.nearest;
         other = nodes[other].next) {
      if (left-- == 0) return conflicts;
      const SortTriangle& later = triangles[nodes[other].triangle];
      if (is_first_shared(cells, cells_of(grid, later), x, y)) conflicts += !may_precede(first, later);
    }
  }
  return conflicts;
}

}  // namespace

size_t sort_far_to_near(const core::Context& context, const PaintRule* rules, core::Objects<TriangleGroup>* groups) {
  const auto parts = static_cast<uint32_t>(groups->size());
  core::Array<size_t> start(context.allocator, size_t{parts} + 1), painted(context.allocator, parts);
  size_t count = 0;
  for (uint32_t g = 0; g < parts; ++g) {
    start[g] = count;
    count += (*groups)[g].size();
  }
  core::Array<Key> keys(context.allocator, count);
  core::parallel_for(context, parts, [&](uint32_t g, uint32_t) {
    const TriangleGroup& group = (*groups)[g];
    painted[g] = 0;
    for (size_t i = 0; i < group.size(); ++i) {
      const PaintRule& rule = rules[group[i].draw];
      const float distance = rule.painted ? farthest_distance(group[i], rule) : -std::numeric_limits<float>::infinity();
      keys[start[g] + i] = {distance, g, static_cast<uint32_t>(i)};
      painted[g] += rule.painted;
    }
  });
  std::sort(keys.begin(), keys.end(), is_before);
  distribute(
      context, count, [&](size_t i) { return (*groups)[keys[i].group][keys[i].entry]; }, groups);
  size_t total = 0;
  for (uint32_t g = 0; g < parts; ++g) total += painted[g];
  return total;
}

uint64_t count_conflicts(const core::Context& context, const SortTriangle* triangles, const SortGrid& grid) {
  const auto rows = static_cast<uint32_t>(grid.rows);
  core::Array<uint64_t> conflicts(context.allocator, rows);
  core::parallel_for(context, rows, [&](uint32_t y, uint32_t) {
    conflicts[y] = 0;
    for (int32_t x = 0; x < grid.columns; ++x) {
      conflicts[y] += count_in_cell(triangles, grid, x, static_cast<int32_t>(y));
    }
  });
  uint64_t total = 0;
  for (uint32_t y = 0; y < rows; ++y) total += conflicts[y];
  return total;
}

}  // namespace shd::raster
