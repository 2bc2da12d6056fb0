// SPDX-License-Identifier: MIT
#include "raster/sort_grid.h"

#include <algorithm>

namespace shd::raster {
namespace {

constexpr int kSmallestShift = 3;
constexpr size_t kNodesPerTriangle = 8;
constexpr size_t kCellsPerTriangle = 4;

void set_shift(const geometry::PixelBox& pixels, int shift, SortGrid* grid) {
  grid->shift = shift;
  grid->columns = ((pixels.max_x - pixels.min_x) >> shift) + 1;
  grid->rows = ((pixels.max_y - pixels.min_y) >> shift) + 1;
}

size_t count_cells(const CellRange& cells) {
  return static_cast<size_t>(cells.right - cells.left + 1) * static_cast<size_t>(cells.bottom - cells.top + 1);
}

/// Chooses the smallest cells that keep the lists short. Returns the number of nodes.
size_t choose_shift(const SortTriangle* triangles, const uint32_t* order, size_t count, SortGrid* grid) {
  for (int shift = kSmallestShift;; ++shift) {
    set_shift(grid->pixels, shift, grid);
    size_t nodes = 0;
    for (size_t i = 0; i < count; ++i) nodes += count_cells(cells_of(*grid, triangles[order[i]]));
    const size_t cells = static_cast<size_t>(grid->columns) * static_cast<size_t>(grid->rows);
    if (cells == 1 || (nodes <= kNodesPerTriangle * count && cells <= kCellsPerTriangle * count)) return nodes;
  }
}

}  // namespace

CellRange cells_of(const SortGrid& grid, const SortTriangle& f) {
  const auto cell = [&](int32_t fixed, int32_t low, int32_t high) {
    return (std::min(std::max(fixed >> geometry::kSubpixelBits, low), high) - low) >> grid.shift;
  };
  const geometry::PixelBox& p = grid.pixels;
  return {cell(f.min_x, p.min_x, p.max_x), cell(f.min_y, p.min_y, p.max_y), cell(f.max_x, p.min_x, p.max_x),
          cell(f.max_y, p.min_y, p.max_y)};
}

void make_grid(const core::Allocator& allocator, const geometry::PixelBox& pixels, const SortTriangle* triangles,
               const uint32_t* order, size_t count, SortGrid* out) {
  out->pixels = pixels;
  const size_t nodes = choose_shift(triangles, order, count, out);
  if (nodes >= kNoNode) throw std::bad_alloc();
  out->head = core::Array<uint32_t>(allocator, static_cast<size_t>(out->columns) * static_cast<size_t>(out->rows));
  for (uint32_t& head : out->head) head = kNoNode;
  out->nodes.attach(allocator);
  out->nodes.reserve(nodes);
  for (size_t i = count; i-- > 0;) {
    const SortTriangle& f = triangles[order[i]];
    const CellRange cells = cells_of(*out, f);
    for (int32_t y = cells.top; y <= cells.bottom; ++y) {
      for (int32_t x = cells.left; x <= cells.right; ++x) {
        uint32_t& head = out->head[static_cast<size_t>(y) * static_cast<size_t>(out->columns) + static_cast<size_t>(x)];
        const float rest = head == kNoNode ? f.farthest : out->nodes[head].farthest;
        out->nodes.push_back({order[i], head, std::max(f.farthest, rest)});
        head = static_cast<uint32_t>(out->nodes.size() - 1);
      }
    }
  }
}

uint64_t insert_piece(const SortTriangle* triangles, uint32_t whole, uint32_t piece, SortGrid* grid) {
  const SortTriangle& f = triangles[piece];
  const CellRange cells = cells_of(*grid, f);
  uint64_t passed = 0;
  for (int32_t y = cells.top; y <= cells.bottom; ++y) {
    for (int32_t x = cells.left; x <= cells.right; ++x) {
      uint32_t node = grid->head[static_cast<size_t>(y) * static_cast<size_t>(grid->columns) + static_cast<size_t>(x)];
      for (; grid->nodes[node].triangle != whole; ++passed) node = grid->nodes[node].next;
      const uint32_t next = grid->nodes[node].next;
      if (grid->nodes.size() + 1 >= kNoNode) throw std::bad_alloc();
      const float rest = next == kNoNode ? f.farthest : grid->nodes[next].farthest;
      grid->nodes.push_back({piece, next, std::max(f.farthest, rest)});
      grid->nodes[node].next = static_cast<uint32_t>(grid->nodes.size() - 1);
    }
  }
  return passed;
}

}  // namespace shd::raster
