// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/allocator.h"
#include "film/framebuffer.h"
#include "film/worker.h"

namespace shd::film {

/// Depth, colour and targets of the samples of a framebuffer with several of them, from one pass of a frame to the
/// next.
class SampleStore {
 public:
  /// 4 bytes a sample and 16 for each of its targets, one a pixel, in whole tiles; empty for none. Throws
  /// std::bad_alloc.
  SampleStore(const core::Allocator& allocator, const Framebuffer& framebuffer, uint32_t tiles);

  bool is_empty() const { return is_saved_.size() == 0; }
  /// What a tile held when it was saved; false if it never was. Different tiles may come and go at a time.
  bool load(uint32_t tile, Worker* worker) const;
  void save(uint32_t tile, const Worker& worker);

 private:
  const size_t depths_, colors_;   // elements of a pixel
  core::Array<uint8_t> is_saved_;  // [tile]
  core::Array<float> depth_;       // [tile][kTilePixels][depths]
  core::Array<uint8_t> is_split_;  // [tile][kTilePixels]
  core::Array<float> color_;       // [tile][kTilePixels][colors]; of split pixels
};

}  // namespace shd::film
