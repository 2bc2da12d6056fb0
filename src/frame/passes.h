// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "frame/frame.h"

namespace shd::frame {

/// Divides a frame into passes of at most frame.pass_triangles triangles, which are drawn one after the other. A pass
/// holds whole draws, or a part of one larger draw; each draw is counted as at least kMinTriangles. Draws with
/// order-independent blends share the last pass, for any number of triangles. Most frames have one pass.
class Passes {
 public:
  /// Throws std::bad_alloc.
  Passes(const core::Allocator& allocator, const Frame& frame);

  uint64_t count() const { return count_; }
  /// Returns the next of count() passes, valid until the next call. Throws std::bad_alloc.
  const Frame& next();

 private:
  /// Position of the next triangle to draw.
  struct Cursor {
    size_t draw;     // draws blended in order come first; the other draws follow, from frame.draw_count on
    uint32_t begin;  // next triangle of the draw
  };

  /// Calls take(draw, begin, end) for the draws of one pass. Returns the start of the next pass.
  template <class Take>
  Cursor advance(Cursor from, const Take& take) const;
  bool is_done(const Cursor& cursor) const { return cursor.draw >= 2 * frame_.draw_count; }

  const Frame& frame_;
  uint64_t count_ = 1, unordered_ = 0;  // number of passes; number of triangles of order-independent draws
  Cursor cursor_ = {0, 0};
  core::Buffer<Draw> draws_;
  Frame pass_;
};

constexpr uint64_t kMinTriangles = 16;

}  // namespace shd::frame
