// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "frame/frame.h"

namespace shd::frame {

/// Cuts a frame into passes of at most frame.pass_triangles triangles, which are drawn one after the other: whole
/// draws, or a part of one that has more. A draw counts for kMinTriangles of them at least. Draws whose blend has no
/// order come last and stay together, however many triangles they have. One pass is enough for most frames; it is the
/// frame.
class Passes {
 public:
  /// Throws std::bad_alloc.
  Passes(const core::Allocator& allocator, const Frame& frame);

  uint64_t count() const { return count_; }
  /// The first pass at first, then the one after; there are count() of them. Valid until the next call.
  /// Throws std::bad_alloc.
  const Frame& next();

 private:
  /// How far the draws are spent.
  struct Cursor {
    size_t draw;     // those that have an order, then the others
    uint32_t begin;  // triangle of that
  };

  /// take(draw, begin, end) for the draws of the pass from here on. Returns where the one after begins.
  template <class Take>
  Cursor advance(Cursor from, const Take& take) const;
  bool is_done(const Cursor& cursor) const { return cursor.draw >= 2 * frame_.draw_count; }

  const Frame& frame_;
  uint64_t count_ = 1, unordered_ = 0;  // passes; triangles of draws without an order
  Cursor cursor_ = {0, 0};
  core::Buffer<Draw> draws_;
  Frame pass_;
};

constexpr uint64_t kMinTriangles = 16;

}  // namespace shd::frame
