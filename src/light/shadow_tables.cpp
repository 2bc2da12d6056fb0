// SPDX-License-Identifier: MIT
// Moments of depths. Texels are either independent or exact sums, so that the bits do not depend on the workers.
#include <algorithm>
#include <cmath>

#include "core/executor.h"
#include "light/shadow.h"
#include "light/shadow_sums.h"

namespace shd::light {
namespace {

/// Sums over a column of texels of the depth relative to the middle of the range, and of its square; empty texels have
/// the far depth.
struct DepthSums {
  double first, second;
};

/// Blurs rows of a face: each result is the mean over taps x taps texels.
class Blur {
 public:
  Blur(const ShadowOptions& options, const ShadowMap& map)
      : map_(map),
        taps_(options.taps),
        far_(static_cast<double>(map.placement.far)),
        middle_(0.5 * (far_ + static_cast<double>(map.placement.near))) {}

  /// Blurs a row of the map including its padding.
  /// @param columns  [pitch + taps]
  void run(uint32_t face, int32_t y, DepthSums* columns, float* out) const {
    const int32_t pitch = static_cast<int32_t>(map_.pitch), taps = static_cast<int32_t>(taps_);
    const int32_t before = (taps - 1) / 2, first = 0 - static_cast<int32_t>(map_.pad) - before;
    for (int32_t x = 0; x < pitch + taps - 1; ++x) columns[x] = sum_column(face, first + x, y, before);
    const double weight = 1.0 / (static_cast<double>(taps) * taps);
    for (int32_t x = 0; x < pitch; ++x) {
      DepthSums sum = {0.0, 0.0};
      for (int32_t j = 0; j < taps; ++j) {
        sum.first += columns[x + j].first;
        sum.second += columns[x + j].second;
      }
      const double mean = sum.first * weight;
      out[2 * x] = static_cast<float>(middle_ + mean);
      out[2 * x + 1] = static_cast<float>(std::fmax(sum.second * weight - mean * mean, 0.0));
    }
  }

 private:
  DepthSums sum_column(uint32_t face, int32_t x, int32_t y, int32_t before) const {
    const auto size = static_cast<int32_t>(map_.size);
    DepthSums sum = {0.0, 0.0};
    for (int32_t j = 0; j < static_cast<int32_t>(taps_); ++j) {
      const int32_t row = y + j - before;
      const bool is_inside = x >= 0 && x < size && row >= 0 && row < size;
      const double depth = is_inside ? static_cast<double>(at(face, x, row)) : far_;
      const double d = std::fmin(depth, far_) - middle_;
      sum.first += d;
      sum.second += d * d;
    }
    return sum;
  }
  float at(uint32_t face, int32_t x, int32_t y) const {
    const size_t pad = map_.pad;
    return map_
        .depth[face * map_.face_stride + (static_cast<size_t>(y) + pad) * map_.pitch + static_cast<size_t>(x) + pad];
  }

  const ShadowMap& map_;
  const uint32_t taps_;
  const double far_, middle_;
};

void build_moments(const core::Context& context, const core::Allocator& allocator, const ShadowOptions& options,
                   ShadowMap* map) {
  core::Array<float> moments(allocator, 2 * map->face_stride * map->placement.face_count);
  const Blur blur(options, *map);
  const size_t columns = map->pitch + options.taps;
  const auto rows = static_cast<uint32_t>(map->pitch);
  core::Array<DepthSums> scratch(context.allocator, columns * context.executor.worker_count);
  core::parallel_for(context, map->placement.face_count * rows, [&](uint32_t i, uint32_t worker) {
    const int32_t y = static_cast<int32_t>(i % rows) - static_cast<int32_t>(map->pad);
    blur.run(i / rows, y, scratch.data() + worker * columns, moments.data() + 2 * map->pitch * i);
  });
  map->moments = std::move(moments);
  map->depth = {};
}

/// Sums along the rows of the table, then down its columns.
void build_sums(const core::Context& context, const core::Allocator& allocator, ShadowMap* map) {
  const size_t size = map->size, row = 2 * (size + 1), face_sums = row * (size + 1);
  core::Array<double> sums(allocator, core::checked_mul(face_sums, map->placement.face_count));
  const SumScale scale = sum_scale(map->placement);
  core::parallel_for(context, map->placement.face_count * map->size, [&](uint32_t i, uint32_t) {
    const size_t face = i / size, y = i % size;
    const float* depth = map->depth.data() + face * map->face_stride + y * map->pitch;
    double* out = sums.data() + face * face_sums + (y + 1) * row;
    out[0] = out[1] = 0.0;
    for (size_t x = 0; x < size; ++x) {
      const double s = quantized_depth(scale, depth[x]);
      out[2 * x + 2] = out[2 * x] + s;
      out[2 * x + 3] = out[2 * x + 1] + quantized_square(s);
    }
  });
  constexpr size_t kColumns = 64;
  const auto strips = static_cast<uint32_t>((row + kColumns - 1) / kColumns);
  core::parallel_for(context, map->placement.face_count * strips, [&](uint32_t i, uint32_t) {
    double* face = sums.data() + i / strips * face_sums;
    const size_t begin = i % strips * kColumns, end = std::min(row, begin + kColumns);
    std::fill(face + begin, face + end, 0.0);
    for (size_t y = 1; y < size; ++y) {
      for (size_t x = begin; x < end; ++x) face[(y + 1) * row + x] += face[y * row + x];
    }
  });
  map->sums = std::move(sums);
  map->depth = {};
}

}  // namespace

void build_tables(const core::Context& context, const core::Allocator& allocator, const ShadowOptions& options,
                  ShadowMap* map) {
  if (options.filter == SHD_SHADOW_FILTER_VARIANCE) build_moments(context, allocator, options, map);
  if (options.filter == SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE) build_sums(context, allocator, map);
}

}  // namespace shd::light
