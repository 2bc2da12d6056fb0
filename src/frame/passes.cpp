// SPDX-License-Identifier: MIT
#include "frame/passes.h"

#include <algorithm>

namespace shd::frame {
namespace {

bool is_unordered(const Draw& draw) {
  return draw.material && material::is_unordered(*draw.material);
}

/// The number of triangles that a draw is counted as.
uint64_t weight(uint64_t triangles) {
  return std::max(triangles, kMinTriangles);
}

}  // namespace

Passes::Passes(const core::Allocator& allocator, const Frame& frame) : frame_(frame), draws_(allocator), pass_(frame) {
  if (frame.visibility != SHD_VISIBILITY_DEPTH) return;  // the other methods sort all triangles together
  uint64_t total = 0;
  for (size_t i = 0; i < frame.draw_count; ++i) {
    const uint64_t triangles = weight(frame.draws[i].end - frame.draws[i].begin);
    total += triangles;
    if (is_unordered(frame.draws[i])) unordered_ += triangles;
  }
  if (total <= frame.pass_triangles) return;
  for (Cursor cursor = advance({0, 0}, [](const Draw&, uint32_t, uint32_t) {}); !is_done(cursor); ++count_) {
    cursor = advance(cursor, [](const Draw&, uint32_t, uint32_t) {});
  }
}

template <class Take>
Passes::Cursor Passes::advance(Cursor from, const Take& take) const {
  const uint32_t max_triangles = frame_.pass_triangles;
  uint64_t room = max_triangles;
  for (; from.draw < frame_.draw_count; from = {from.draw + 1, 0}) {
    const Draw& draw = frame_.draws[from.draw];
    if (is_unordered(draw)) continue;
    const uint32_t begin = draw.begin + from.begin;
    const uint64_t triangles = weight(draw.end - begin);
    if (triangles > room) {
      if (triangles <= max_triangles || room < max_triangles) return from;
      take(draw, begin, begin + max_triangles);
      return {from.draw, from.begin + max_triangles};
    }
    take(draw, begin, draw.end);
    room -= triangles;
  }
  if (unordered_ > room && room < max_triangles) return from;
  for (; !is_done(from); ++from.draw) {
    const Draw& draw = frame_.draws[from.draw - frame_.draw_count];
    if (is_unordered(draw)) take(draw, draw.begin, draw.end);
  }
  return from;
}

const Frame& Passes::next() {
  if (count_ == 1) return frame_;
  pass_.load = frame_.load || cursor_.draw || cursor_.begin;
  draws_.clear();
  cursor_ = advance(cursor_, [&](const Draw& draw, uint32_t begin, uint32_t end) {
    draws_.push_back(draw);
    draws_[draws_.size() - 1].begin = begin;
    draws_[draws_.size() - 1].end = end;
  });
  pass_.draws = draws_.data();
  pass_.draw_count = draws_.size();
  pass_.volume_count = is_done(cursor_) ? frame_.volume_count : 0;  // over the last pass
  return pass_;
}

}  // namespace shd::frame
