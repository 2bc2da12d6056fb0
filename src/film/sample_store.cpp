// SPDX-License-Identifier: MIT
#include "film/sample_store.h"

#include <cstring>

namespace shd::film {
namespace {

/// Copies the colours of the pixels that are split.
void copy_split(const uint8_t* is_split, const float* from, size_t pixel_size, float* to) {
  for (size_t pixel = 0; pixel < raster::kTilePixels; ++pixel) {
    const size_t at = pixel * pixel_size;
    if (is_split[pixel]) std::memcpy(to + at, from + at, pixel_size * sizeof(float));
  }
}

}  // namespace

SampleStore::SampleStore(const core::Allocator& allocator, const Framebuffer& framebuffer, uint32_t tiles)
    : depths_(framebuffer.samples),
      colors_(size_t{4} * framebuffer.samples * static_cast<size_t>(__builtin_popcount(targets_of(framebuffer)))),
      is_saved_(allocator, tiles),
      depth_(allocator, tiles * raster::kTilePixels * depths_),
      is_split_(allocator, tiles * raster::kTilePixels),
      color_(allocator, tiles * raster::kTilePixels * colors_) {
  is_saved_.fill_zero();
}

bool SampleStore::load(uint32_t index, raster::Tile* tile, SplitSamples* split) const {
  if (!is_saved_[index]) return false;
  const size_t first = index * raster::kTilePixels;
  std::memcpy(tile->depth.data(), &depth_[first * depths_], tile->depth.size() * sizeof(float));
  std::memcpy(split->is_split.data(), &is_split_[first], raster::kTilePixels);
  copy_split(&is_split_[first], &color_[first * colors_], colors_, split->color.data());
  return true;
}

void SampleStore::save(uint32_t index, const raster::Tile& tile, const SplitSamples& split) {
  const size_t first = index * raster::kTilePixels;
  std::memcpy(&depth_[first * depths_], tile.depth.data(), tile.depth.size() * sizeof(float));
  std::memcpy(&is_split_[first], split.is_split.data(), raster::kTilePixels);
  copy_split(split.is_split.data(), split.color.data(), colors_, &color_[first * colors_]);
  is_saved_[index] = 1;
}

}  // namespace shd::film
