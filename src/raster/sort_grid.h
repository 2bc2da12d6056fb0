// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "geometry/pixel_box.h"
#include "raster/sort_triangle.h"

namespace shd::raster {

constexpr uint32_t kNoTriangle = 0xffffffffu;
constexpr uint32_t kNoNode = 0xffffffffu;

/// A triangle in the list of one cell.
struct SortNode {
  uint32_t triangle;
  uint32_t next;
  float farthest;  // maximum over this node and all nodes after it
};

/// Square cells over the visible pixels, each with a list of the triangles whose box touches it.
struct SortGrid {
  geometry::PixelBox pixels;
  int shift;  // log2 of the size of a cell [pixels]
  int32_t columns, rows;
  core::Array<uint32_t> head;  // [rows][columns] first node of each list
  core::Buffer<SortNode> nodes;
};

/// Builds the lists of triangles order[0], order[1], ..., in that order; about 8 nodes per triangle or fewer. Throws
/// std::bad_alloc.
void make_grid(const core::Allocator& allocator, const geometry::PixelBox& pixels, const SortTriangle* triangles,
               const uint32_t* order, size_t count, SortGrid* out);

/// Inserts a piece after the triangle that it was cut from, in every cell that the piece touches. Returns the number of
/// nodes visited.
uint64_t insert_piece(const SortTriangle* triangles, uint32_t whole, uint32_t piece, SortGrid* grid);

/// Cells that the box of a triangle touches, ends included.
struct CellRange {
  int32_t left, top, right, bottom;
};
CellRange cells_of(const SortGrid& grid, const SortTriangle& f);

/// Whether (x, y) is the first cell that two ranges share.
inline bool is_first_shared(const CellRange& a, const CellRange& b, int32_t x, int32_t y) {
  return x == (a.left > b.left ? a.left : b.left) && y == (a.top > b.top ? a.top : b.top);
}

}  // namespace shd::raster
