// SPDX-License-Identifier: MIT
/// @file
/// How a lookup is explained: the consumer that records (record-inl.h) computes with node numbers in place of values and
/// writes down the texels and blends of the stream.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "core/status.h"

namespace shd::texture {

/// A texel by its index in the texture's block, or the border.
struct RecordedTap {
  uint32_t index;
  bool border;
};

/// Nodes are taps by number, or blends by number with kBlendNode set.
constexpr uint32_t kBlendNode = 1u << 31;
struct RecordedBlend {
  uint32_t a, b;
  float s;
};

/// The tree of one lookup. Its tables hold what any filter needs for any input.
struct Recording {
  static constexpr size_t kMaxTaps = 4096;

  core::Array<RecordedTap> taps;
  core::Array<RecordedBlend> blends;
  size_t tap_count = 0, blend_count = 0;
  bool finished_taps = false;  // values leave the lerp domain before they are blended
  uint32_t root = 0;

  explicit Recording(const core::Allocator& allocator) : taps(allocator, kMaxTaps), blends(allocator, kMaxTaps) {}

  uint32_t tap(uint32_t index, bool border) {
    SHD_ASSERT(tap_count < kMaxTaps);
    taps[tap_count] = {index, border};
    return static_cast<uint32_t>(tap_count++);
  }
  uint32_t blend(uint32_t a, uint32_t b, float s) {
    SHD_ASSERT(blend_count < kMaxTaps);
    blends[blend_count] = {a, b, s};
    return static_cast<uint32_t>(blend_count++) | kBlendNode;
  }
};

}  // namespace shd::texture
