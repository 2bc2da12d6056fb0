// SPDX-License-Identifier: MIT
// The list of the paper as a depth-first search. Triangles are taken from the far end. A triangle stays open until all
// triangles that must be painted before it are painted; the paper marks them and moves them to the end of the list. An
// open triangle that is reached again is part of a cyclic overlap, which a cut resolves.
#include "raster/newell.h"

#include "raster/sort_grid.h"

namespace shd::raster {
namespace {

// States of a triangle that is not on the stack.
constexpr uint32_t kWaiting = 0xffffffffu;
constexpr uint32_t kPainted = 0xfffffffeu;
constexpr uint32_t kCut = 0xfffffffdu;
constexpr uint32_t kMaxTriangles = 0xfffffff0u;

/// Number of members of a cycle whose planes are tried for a cut.
constexpr size_t kPlanesTried = 16;

/// A triangle whose predecessors are being painted, and the current position of the search for them.
struct Open {
  uint32_t triangle;
  CellRange cells;
  int32_t x, y;   // current cell
  uint32_t node;  // latest node seen in the cell, or kNoNode before the first
};

class Newell {
 public:
  Newell(const core::Context& context, const PaintArea& area, Painting* painting)
      : area_(area),
        triangles_(painting->triangles),
        order_(painting->order),
        cuts_(painting->cuts),
        level_(context.allocator),
        next_(context.allocator),
        stack_(context.allocator),
        cuts_left_(triangles_.size() + 1024),
        comparisons_left_(1024 * uint64_t{triangles_.size()} + (1u << 22)) {
    const size_t count = triangles_.size();
    if (count >= kMaxTriangles) throw std::bad_alloc();
    order_.resize(count);
    level_.resize(count);
    next_.resize(count);
    for (size_t i = 0; i < count; ++i) {
      order_[i] = static_cast<uint32_t>(i);
      level_[i] = kWaiting;
      next_[i] = i + 1 < count ? static_cast<uint32_t>(i + 1) : kNoTriangle;
    }
    make_grid(context.allocator, area.pixels, triangles_.data(), order_.data(), count, &grid_);
    order_.clear();
  }

  void run() {
    for (uint32_t f = 0; f != kNoTriangle; f = next_[f]) {
      if (level_[f] == kWaiting) paint(f);
    }
  }

 private:
  /// Paints a triangle and all triangles that must precede it, or cuts it.
  void paint(uint32_t root) {
    open(root);
    while (stack_.size()) {
      const uint32_t current = stack_[stack_.size() - 1].triangle;
      const uint32_t other = next_predecessor(&stack_[stack_.size() - 1]);
      if (other == kNoTriangle) {
        close(stack_.size() - 1);
        level_[current] = kPainted;
        order_.push_back(current);
      } else if (!may_precede(triangles_[other], triangles_[current])) {
        cut_pair(current, other);
      } else if (level_[other] == kWaiting) {
        open(other);
      } else {
        cut_cycle(level_[other]);
      }
    }
  }

  void open(uint32_t triangle) {
    const CellRange cells = cells_of(grid_, triangles_[triangle]);
    level_[triangle] = static_cast<uint32_t>(stack_.size());
    stack_.push_back({triangle, cells, cells.left, cells.top, kNoNode});
  }

  /// Removes the open triangles from `level` on.
  void close(size_t level) {
    for (size_t i = level; i < stack_.size(); ++i) level_[stack_[i].triangle] = kWaiting;
    stack_.resize(level);
  }

  uint32_t& head_of(const Open& o) {
    return grid_.head[static_cast<size_t>(o.y) * static_cast<size_t>(grid_.columns) + static_cast<size_t>(o.x)];
  }
  bool is_gone(uint32_t triangle) const { return level_[triangle] == kPainted || level_[triangle] == kCut; }

  /// The next node of the current cell, or kNoNode at its end. Removes painted and cut triangles at the head of the
  /// list.
  uint32_t next_node(const Open& o) {
    if (o.node != kNoNode) return grid_.nodes[o.node].next;
    uint32_t& head = head_of(o);
    while (head != kNoNode && is_gone(grid_.nodes[head].triangle)) head = grid_.nodes[head].next;
    return head;
  }

  /// The next triangle that must be painted before an open one, or kNoTriangle. Pieces are inserted after the triangle
  /// that they were cut from, in the list of every cell, so that the search reaches all pieces that it has not passed.
  uint32_t next_predecessor(Open* o) {
    const SortTriangle& f = triangles_[o->triangle];
    while (o->y <= o->cells.bottom) {
      for (uint32_t node = next_node(*o); node != kNoNode && grid_.nodes[node].farthest > f.nearest;
           node = grid_.nodes[node].next) {
        if (!spend(1)) return kNoTriangle;
        o->node = node;
        const uint32_t other = grid_.nodes[node].triangle;
        if (other == o->triangle || is_gone(other)) continue;
        const SortTriangle& g = triangles_[other];
        if (is_first_shared(o->cells, cells_of(grid_, g), o->x, o->y) && !may_precede(f, g)) return other;
      }
      o->node = kNoNode;
      if (++o->x > o->cells.right) {
        o->x = o->cells.left;
        ++o->y;
      }
    }
    return kNoTriangle;
  }

  /// Cuts one of two triangles that intersect, preferably the smaller one.
  void cut_pair(uint32_t a, uint32_t b) {
    const bool a_first = doubled_area(triangles_[a].triangle) <= doubled_area(triangles_[b].triangle);
    if (!cut(a_first ? a : b, a_first ? b : a)) cut(a_first ? b : a, a_first ? a : b);
  }

  /// Cuts one of the open triangles from `level` on. They form a cycle: each must follow the next, and the last the
  /// first. If no triangle of the cycle crossed the plane of a given one, all would lie on one side of it and there
  /// would be no cycle.
  void cut_cycle(size_t level) {
    const size_t end = stack_.size();
    for (size_t i = end; i-- > level && end - i <= kPlanesTried;) {
      for (size_t j = end; j-- > level;) {
        if (!spend(1)) return;
        if (i != j && cut(stack_[j].triangle, stack_[i].triangle)) return;
      }
    }
  }

  /// Replaces a triangle by its pieces on both sides of the plane of another one. If it is open, it and all later open
  /// triangles are closed.
  bool cut(uint32_t whole, uint32_t plane) {
    TrianglePieces pieces;
    if (cuts_left_ == 0 || comparisons_left_ == 0 || !split_triangle(triangles_[whole], triangles_[plane], &pieces))
      return false;
    if (triangles_.size() + 3 >= kMaxTriangles) throw std::bad_alloc();
    for (int i = 0; i < pieces.count; ++i) {
      if (shows(pieces.piece[i])) add(whole, pieces.piece[i]);
    }
    if (level_[whole] != kWaiting) close(level_[whole]);
    level_[whole] = kCut;
    ++cuts_;
    --cuts_left_;
    return true;
  }

  bool shows(const SortTriangle& f) const {
    const geometry::PixelBox box = geometry::pixel_box(f.triangle, area_.samples);
    return !geometry::is_empty(box) && !geometry::is_empty(geometry::intersection(box, area_.pixels));
  }

  void add(uint32_t whole, const SortTriangle& piece) {
    const auto index = static_cast<uint32_t>(triangles_.size());
    const uint32_t after = next_[whole];
    triangles_.push_back(piece);
    level_.push_back(kWaiting);
    next_.push_back(after);
    next_[whole] = index;
    spend(insert_piece(triangles_.data(), whole, index, &grid_));
  }

  /// Counts comparisons, and list steps of equal cost. Returns false once the budget is spent.
  bool spend(uint64_t comparisons) {
    const bool enough = comparisons < comparisons_left_;
    comparisons_left_ = enough ? comparisons_left_ - comparisons : 0;
    return enough;
  }

  const PaintArea& area_;
  core::Buffer<SortTriangle>& triangles_;
  core::Buffer<uint32_t>& order_;
  uint64_t& cuts_;
  core::Buffer<uint32_t> level_;  // [triangle] level in the stack, or one of the constants
  core::Buffer<uint32_t> next_;   // [triangle] the list from far to near
  core::Buffer<Open> stack_;
  SortGrid grid_;
  uint64_t cuts_left_, comparisons_left_;
};

}  // namespace

void newell(const core::Context& context, const PaintArea& area, Painting* painting) {
  painting->cuts = 0;
  painting->order.clear();
  if (painting->triangles.size()) Newell(context, area, painting).run();
}

}  // namespace shd::raster
