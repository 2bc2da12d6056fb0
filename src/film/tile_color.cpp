// SPDX-License-Identifier: MIT
#include "film/tile_color.h"

#include <algorithm>
#include <cstring>

#include "film/copy_runs.h"

namespace shd::film {
namespace {

/// Averages colours spaced `stride` floats apart.
void average(const float* from, uint32_t samples, size_t stride, float out[4]) {
  const float share = 1.0f / static_cast<float>(samples);
  float sum[4] = {};
  for (uint32_t s = 0; s < samples; ++s, from += stride) {
    for (size_t c = 0; c < 4; ++c) sum[c] += from[c];
  }
  for (size_t c = 0; c < 4; ++c) out[c] = sum[c] * share;
}

/// Whether colours spaced `stride` floats apart are bit-equal.
bool are_same(const float* colors, uint32_t samples, size_t stride) {
  uint64_t different = 0, first[2];
  std::memcpy(first, colors, sizeof first);
  for (uint32_t s = 1; s < samples; ++s) {
    uint64_t other[2];
    std::memcpy(other, colors + stride * s, sizeof other);
    different |= (other[0] ^ first[0]) | (other[1] ^ first[1]);
  }
  return different == 0;
}

/// Replaces the colours of the samples in a mask. Chooses in place of branches, which would be predicted wrongly.
template <uint32_t kSamples>
void choose_some(uint32_t mask, const float (&color)[4], float* samples) {
  uint32_t value[4];
  std::memcpy(value, color, sizeof value);
  for (uint32_t s = 0; s < kSamples; ++s) {
    const uint32_t keep = (mask >> s & 1) - 1;
    uint32_t bits[4];
    std::memcpy(bits, samples + 4 * s, sizeof bits);
    for (size_t c = 0; c < 4; ++c) bits[c] = (bits[c] & keep) | (value[c] & ~keep);
    std::memcpy(samples + 4 * s, bits, sizeof bits);
  }
}

Destination at(float* color) {
  return {{color, color + 1, color + 2, color + 3}};
}

}  // namespace

void allocate(const core::Allocator& allocator, uint32_t samples, uint32_t targets, SplitSamples* out) {
  if (samples == 1) return;
  const size_t floats = size_t{samples} * 4 * static_cast<size_t>(__builtin_popcount(targets));
  out->color = core::Array<float>(allocator, floats * raster::kTilePixels);
  out->is_split = core::Array<uint8_t>(allocator, raster::kTilePixels);
}

TileColor::TileColor(const TileArea& area, const TilePlanes& color, Framebuffer* framebuffer, SplitSamples* split)
    : samples_(framebuffer->samples), all_((1u << framebuffer->samples) - 1), split_(*split) {
  for (uint32_t targets = targets_of(*framebuffer); targets; targets &= targets - 1) {
    const auto target = static_cast<uint32_t>(__builtin_ctz(targets));
    planes_[target_count_] = target == 0 ? color : planes_of(area, target_plane(target), framebuffer);
    target_[target_count_++] = target;
  }
}

void TileColor::load() {
  if (samples_ > 1) std::fill(split_.is_split.begin(), split_.is_split.end(), uint8_t{0});
}

/// The destination in the planes, for a pixel that is not split.
Destination TileColor::whole(uint32_t pixel, uint32_t t) const {
  const size_t at_pixel = position(pixel, t);
  float* const* plane = planes_[t].plane;
  return {{plane[0] + at_pixel, plane[1] + at_pixel, plane[2] + at_pixel, plane[3] + at_pixel}};
}

/// The separate samples of a pixel; splits the pixel if necessary.
float* TileColor::split(uint32_t pixel) {
  float* samples = split_.color.data() + size_t{pixel} * samples_ * target_count_ * 4;
  if (split_.is_split[pixel]) return samples;
  split_.is_split[pixel] = 1;
  if (assumed_) {
    for (uint32_t s = 0; s < samples_; ++s) std::memcpy(samples + 4 * s, assumed_, 4 * sizeof(float));
    return samples;
  }
  for (uint32_t t = 0; t < target_count_; ++t) {
    const size_t at_pixel = position(pixel, t);
    float color[4];
    for (uint32_t c = 0; c < 4; ++c) color[c] = planes_[t].plane[c][at_pixel];
    for (uint32_t s = 0; s < samples_; ++s) std::memcpy(samples + 4 * (s * target_count_ + t), color, sizeof color);
  }
  return samples;
}

bool TileColor::point_to(const raster::PixelRun& run, shade::Radiance* out) {
  if (target_count_ > 1 || planes_[0].stride != raster::kTile) return false;
  for (size_t c = 0; c < 4; ++c) out->channel[c] = planes_[0].plane[c] + run.begin;
  mark_whole(run.begin, run.end);
  return true;
}

void TileColor::mark_whole(uint32_t begin, uint32_t end) {
  if (samples_ > 1) std::fill(split_.is_split.data() + begin, split_.is_split.data() + end, uint8_t{0});
}

void TileColor::write_runs(const core::SimdTarget& simd, const raster::PixelRun* runs, size_t count,
                           const shade::Radiance& from, size_t row) {
  for (uint32_t t = 0; t < target_count_; ++t) {
    const float* const* channel = from.channel + 4 * target_[t];
    const float* const column[4] = {channel[0] + row, channel[1] + row, channel[2] + row, channel[3] + row};
    copy_runs(simd, runs, count, column, planes_[t]);
  }
  for (size_t i = 0; i < count && samples_ > 1; ++i) mark_whole(runs[i].begin, runs[i].end);
}

void TileColor::write_some(uint32_t pixel, uint32_t mask, const shade::Radiance& from, size_t row) {
  float* samples = split(pixel);
  if (samples_ == 4 && target_count_ == 1) {
    const float* const* column = from.channel;
    const float color[4] = {column[0][row], column[1][row], column[2][row], column[3][row]};
    return choose_some<4>(mask, color, samples);
  }
  for (uint32_t t = 0; t < target_count_; ++t) {
    float color[4];
    for (uint32_t c = 0; c < 4; ++c) color[c] = from.channel[4 * target_[t] + c][row];
    for (uint32_t rest = mask; rest; rest &= rest - 1) {
      const auto s = static_cast<uint32_t>(__builtin_ctz(rest));
      std::memcpy(samples + 4 * (s * target_count_ + t), color, sizeof color);
    }
  }
}

Destination TileColor::sample(uint32_t pixel, uint32_t sample) {
  if (samples_ == 1) return whole(pixel, 0);
  return at(split(pixel) + 4 * size_t{sample} * target_count_);
}

void TileColor::blend(shd_blend mode, uint32_t pixel, uint32_t mask, const FragmentColor& color,
                      const shade::Radiance& from, size_t row) {
  const bool is_whole = mask == all_ && (samples_ == 1 || !split_.is_split[pixel]);
  float* samples = is_whole ? nullptr : split(pixel);
  for (uint32_t t = 0; t < target_count_; ++t) {
    FragmentColor over = color;
    for (uint32_t c = 0; t > 0 && c < 4; ++c) over.channel[c] = from.channel[4 * target_[t] + c][row];
    if (is_whole) film::blend(mode, over, whole(pixel, t));
    for (uint32_t rest = is_whole ? 0 : mask; rest; rest &= rest - 1) {
      const auto s = static_cast<uint32_t>(__builtin_ctz(rest));
      film::blend(mode, over, at(samples + 4 * (s * target_count_ + t)));
    }
  }
}

void TileColor::over(uint32_t pixel, uint32_t mask, const FragmentColor& color) {
  if (mask == all_ && (samples_ == 1 || !split_.is_split[pixel])) {
    return film::blend(SHD_BLEND_PREMULTIPLIED, color, whole(pixel, 0));
  }
  for (; mask; mask &= mask - 1) {
    film::blend(SHD_BLEND_PREMULTIPLIED, color, sample(pixel, static_cast<uint32_t>(__builtin_ctz(mask))));
  }
}

void TileColor::resolve() {
  if (samples_ == 1) return;
  const size_t stride = 4 * size_t{target_count_};
  for (uint32_t first = 0; first < raster::kTilePixels; first += 8) {
    uint64_t eight;
    std::memcpy(&eight, split_.is_split.data() + first, sizeof eight);
    for (; eight; eight &= eight - 1) {
      const uint32_t pixel = first + static_cast<uint32_t>(__builtin_ctzll(eight)) / 8;
      for (uint32_t t = 0; t < target_count_; ++t) {
        const float* samples = split_.color.data() + pixel * samples_ * stride + 4 * t;
        float mean[4];
        average(samples, samples_, stride, mean);
        if (are_same(samples, samples_, stride)) std::memcpy(mean, samples, sizeof mean);
        for (size_t c = 0; c < 4; ++c) planes_[t].plane[c][position(pixel, t)] = mean[c];
      }
    }
  }
}

}  // namespace shd::film
