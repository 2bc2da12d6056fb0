// SPDX-License-Identifier: MIT
/// @file
/// Recording of one lookup. The consumer that records (record-inl.h) computes with node numbers in place of values and
/// stores the texels and blends of the stream.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "core/status.h"
#include "texture/stream.h"

namespace shd::texture {

/// A texel of a level, or the border colour.
struct RecordedTap {
  uint32_t x, y, first;  // column, row, and first unit of the level of the image (Layout)
  bool border;           // the border colour replaces the texel
};

/// Flag of nodes that are blends. The other bits of a node are the number of its tap or blend.
constexpr uint32_t kBlendNode = 1u << 31;

/// The blend a + s (b - a) of two nodes.
struct RecordedBlend {
  uint32_t a, b;
  float s;
};

/// Tree of blends of one lookup. The tables are large enough for every filter and input.
struct Recording {
  static constexpr size_t kMaxTaps = 4096;

  core::Array<StreamPlaces> columns;  // one
  core::Array<RecordedTap> places;    // places of the texels of streams
  core::Array<RecordedTap> taps;
  core::Array<RecordedBlend> blends;
  size_t place_count = 0, tap_count = 0, blend_count = 0;
  bool finished_taps = false;  // texels leave the lerp domain before they are blended
  float reference = 0.0f;      // clamped reference of a comparison lookup

  explicit Recording(const core::Allocator& allocator)
      : columns(allocator, 1), places(allocator, kMaxTaps), taps(allocator, kMaxTaps), blends(allocator, kMaxTaps) {}

  uint32_t tap(uint32_t place) {
    SHD_ASSERT(tap_count < kMaxTaps && place < place_count);
    taps[tap_count] = places[place];
    return static_cast<uint32_t>(tap_count++);
  }
  uint32_t blend(uint32_t a, uint32_t b, float s) {
    SHD_ASSERT(blend_count < kMaxTaps);
    blends[blend_count] = {a, b, s};
    return static_cast<uint32_t>(blend_count++) | kBlendNode;
  }
};

/// The placement of a recording, for every store: it keeps the places of the texels of lane 0, and replaces the columns
/// by their numbers.
void place_taps(void* recording, size_t end, size_t lanes, Stream* stream);

}  // namespace shd::texture
