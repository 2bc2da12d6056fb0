// SPDX-License-Identifier: MIT
#include "film/tile_color.h"

#include <algorithm>
#include <cstring>

namespace shd::film {
namespace {

/// Of colours [samples][4].
void average(const float* from, uint32_t samples, float out[4]) {
  const float share = 1.0f / static_cast<float>(samples);
  float sum[4] = {};
  for (uint32_t s = 0; s < samples; ++s, from += 4) {
    for (size_t c = 0; c < 4; ++c) sum[c] += from[c];
  }
  for (size_t c = 0; c < 4; ++c) out[c] = sum[c] * share;
}

/// Whether colours [samples][4] are the same, to the bit.
bool are_same(const float* colors, uint32_t samples) {
  uint64_t different = 0, first[2];
  std::memcpy(first, colors, sizeof first);
  for (uint32_t s = 1; s < samples; ++s) {
    uint64_t other[2];
    std::memcpy(other, colors + 4 * s, sizeof other);
    different |= (other[0] ^ first[0]) | (other[1] ^ first[1]);
  }
  return different == 0;
}

}  // namespace

void allocate(const core::Allocator& allocator, uint32_t samples, SplitSamples* out) {
  if (samples == 1) return;
  out->color = core::Array<float>(allocator, samples * 4 * raster::kTilePixels);
  out->is_split = core::Array<uint8_t>(allocator, raster::kTilePixels);
}

TileColor::TileColor(const TileArea& area, Framebuffer* framebuffer, SplitSamples* split)
    : corner_(size_t{area.top} * framebuffer->stride + area.left),
      stride_(framebuffer->stride),
      samples_(framebuffer->samples),
      all_((1u << framebuffer->samples) - 1),
      split_(*split) {
  for (size_t c = 0; c < 4; ++c) plane_[c] = framebuffer->plane[c].data();
}

void TileColor::load() {
  if (samples_ > 1) std::fill(split_.is_split.begin(), split_.is_split.end(), uint8_t{0});
}

/// All samples of a pixel that is not split.
Below TileColor::whole(uint32_t pixel) const {
  const size_t at = position(pixel);
  return {{plane_[0] + at, plane_[1] + at, plane_[2] + at, plane_[3] + at}};
}

/// The samples of a pixel, apart from each other.
float* TileColor::split(uint32_t pixel) {
  float* samples = split_.color.data() + size_t{pixel} * samples_ * 4;
  if (split_.is_split[pixel]) return samples;
  split_.is_split[pixel] = 1;
  const size_t at = position(pixel);
  for (uint32_t s = 0; s < samples_; ++s) {
    for (size_t c = 0; c < 4; ++c) samples[4 * s + c] = plane_[c][at];
  }
  return samples;
}

void TileColor::write_some(uint32_t pixel, uint32_t mask, const FragmentColor& color) {
  float* samples = split(pixel);
  for (; mask; mask &= mask - 1) std::memcpy(samples + 4 * __builtin_ctz(mask), color.channel, sizeof color.channel);
}

void TileColor::write_row(uint32_t pixel, size_t count, const shade::Radiance& from, size_t row) {
  const size_t at = position(pixel);
  for (size_t c = 0; c < 4; ++c) {
    const float* column = from.channel[c] + row;
    for (size_t i = 0; i < count; ++i) plane_[c][at + i] = column[i];
  }
  if (samples_ > 1) std::fill_n(split_.is_split.data() + pixel, count, uint8_t{0});
}

Below TileColor::sample(uint32_t pixel, uint32_t sample) {
  if (samples_ == 1) return whole(pixel);
  float* color = split(pixel) + 4 * sample;
  return {{color, color + 1, color + 2, color + 3}};
}

void TileColor::blend(shd_blend_mode mode, uint32_t pixel, uint32_t mask, const FragmentColor& color) {
  if (mask == all_ && (samples_ == 1 || !split_.is_split[pixel])) return film::blend(mode, color, whole(pixel));
  for (; mask; mask &= mask - 1) film::blend(mode, color, sample(pixel, static_cast<uint32_t>(__builtin_ctz(mask))));
}

void TileColor::resolve() {
  if (samples_ == 1) return;
  for (uint32_t first = 0; first < raster::kTilePixels; first += 8) {
    uint64_t eight;
    std::memcpy(&eight, split_.is_split.data() + first, sizeof eight);
    for (uint32_t pixel = first; pixel < first + 8 && eight; ++pixel) {
      if (!split_.is_split[pixel]) continue;
      const float* samples = split_.color.data() + size_t{pixel} * samples_ * 4;
      float mean[4];
      if (are_same(samples, samples_)) {
        std::memcpy(mean, samples, sizeof mean);
      } else {
        average(samples, samples_, mean);
      }
      const size_t at = position(pixel);
      for (size_t c = 0; c < 4; ++c) plane_[c][at] = mean[c];
    }
  }
}

}  // namespace shd::film
