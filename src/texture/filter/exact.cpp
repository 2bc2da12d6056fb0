// SPDX-License-Identifier: MIT
// SHD_FILTER_EXACT, scalar and in doubles: the reference for the error of other filters. The bilinear reconstruction is
// a u + b v + c u v + d on each cell of the lattice of texel centres, so the moments of a piece of a cell give its
// integral over the piece.
#include "texture/filter/exact.h"

#include <cmath>
#include <limits>

#include "texture/domain/block.h"
#include "texture/domain/exact_footprint.h"
#include "texture/domain/wrap.h"
#include "texture/format/codec.h"
#include "texture/format/texel_codec.h"
#include "texture/store/reader.h"
#include "texture/store/storage.h"
#include "texture/store/tiles/lease.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/exact.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/filters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

size_t RunExact(const FilterCall& call) {
  return run_exact(call, RunBilinear);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {

/// Weighted mean of values. Deviations from the first value are summed, so equal values give exactly this value. Values
/// that are not finite are summed separately, without weights; the sum then replaces the mean.
struct Mean {
  double first = 0, sum = 0, nonfinite = 0;
  bool started = false, poisoned = false;

  void add(double value, double weight) {
    if (!std::isfinite(value)) {
      nonfinite += value;
      poisoned = true;
      return;
    }
    if (!started) first = value;
    started = true;
    sum += weight * (value - first);
  }
  double over(double weight) const { return poisoned ? canonical(nonfinite) : first + sum / weight; }
};

/// Integrates the reconstruction of one level. A visitor of visit_cells().
class Integral {
 public:
  Integral(const Texture& texture, const Sampler& sampler, const ExactFootprint& footprint)
      : codec_(codec_of(texture.component, texture.channels)),
        texture_(texture),
        sampler_(sampler),
        footprint_(footprint),
        negligible_(footprint.thin ? 0x1p-20 : 0x1p-40),
        first_(first_unit(texture, footprint.layer, footprint.level)),
        reader_(texture) {
    width_ = level_size(texture.width, footprint.level);
    height_ = level_size(texture.height, footprint.level);
    for (size_t c = 0; c < 4; ++c) border_[c] = static_cast<double>(sampler.border[c]) * codec_.one[c];
  }

  void cell(int64_t i, int64_t j, const Moments& m) {
    const double least = m.one * negligible_;
    const int64_t lower = row(j), upper = row(j + 1);
    const auto add_if = [&](int64_t from, int64_t x, double weight) {
      if (weight > least) add(from, x, weight);
    };
    add_if(lower, i, m.one - m.x - m.y + m.xy);
    add_if(lower, i + 1, m.x - m.xy);
    add_if(upper, i, m.y - m.xy);
    add_if(upper, i + 1, m.xy);
  }

  void run(int64_t j, int64_t begin, int64_t end) {
    for (const int64_t from : {row(j), row(j + 1)}) {
      add(from, begin, 0.25);
      for (int64_t i = begin + 1; i < end; ++i) add(from, i, 0.5);
      add(from, end, 0.25);
    }
  }

  float channel(size_t c) const { return static_cast<float>(mean_[c].over(weight_) / codec_.one[c]); }

 private:
  /// Returns row j after wrapping, or -1 for the border colour.
  int64_t row(int64_t j) const { return wrap_index(sampler_.wrap_v, footprint_.y + j, height_); }

  void add(int64_t y, int64_t i, double weight) {
    const int64_t x = wrap_index(sampler_.wrap_u, footprint_.x + i, width_);
    double loaded[4];
    const double* value = border_;
    if (y >= 0 && x >= 0) {
      codec_.load(reader_.at(first_, static_cast<uint32_t>(width_), static_cast<uint32_t>(x), static_cast<uint32_t>(y)),
                  1, loaded);
      value = loaded;
    }
    weight_ += weight;
    for (size_t c = 0; c < codec_.channels; ++c) mean_[c].add(value[c], weight);
  }

  const TexelCodec& codec_;
  const Texture& texture_;
  const Sampler& sampler_;
  const ExactFootprint& footprint_;
  const double
      negligible_;  // part of a piece's area; smaller weights come from rounding, or from the width of thin footprints
  int64_t width_, height_;
  double border_[4];
  double weight_ = 0;
  uint32_t first_;
  TexelReader reader_;
  Mean mean_[4];
};

void integrate(const Texture& texture, const Sampler& sampler, const ExactFootprint& footprint, const Texels& out) {
  Integral integral(texture, sampler, footprint);
  visit_cells(parallelogram(footprint.center, footprint.a, footprint.b), &integral);
  for (size_t c = 0; c < texture.channels; ++c) {
    if (out.channel[c]) *out.channel[c] = integral.channel(c);
  }
}

/// integrate() without the lease of a call of a texture in tiles: it may load tiles.
void integrate_alone(const FilterCall& call, const ExactFootprint& footprint, const Texels& out) {
  auto* const tiles = has_tiles(call.texture) ? static_cast<TileCall*>(call.placement.state) : nullptr;
  if (tiles) tiles->give_lease();
  integrate(call.texture, call.sampler, footprint, out);
  if (tiles) tiles->take_lease();
}

}  // namespace

size_t run_exact(const FilterCall& call, RunFilter run_bilinear) {
  Sampler bilinear = call.sampler;
  bilinear.filter = SHD_FILTER_BILINEAR;
  size_t nonfinite = 0;
  for (size_t i = 0; i < call.in.count; ++i) {
    const ExactFootprint footprint = exact_footprint(call.texture, call.sampler, call.in, i);
    const Texels out = part_of(call.out, i);
    nonfinite += !footprint.finite;
    if (footprint.point) {
      const Lookups lookup = part_of(call.in, i, 1);
      run_bilinear({call.texture, bilinear, lookup, out, call.format, nullptr, nullptr, call.placement});
    } else {
      integrate_alone(call, footprint, out);
    }
  }
  return nonfinite;
}

}  // namespace shd::texture
#endif
