// SPDX-License-Identifier: MIT
// SHD_FILTER_EXACT, scalar and in doubles: the reference for the error of other filters. The bilinear reconstruction is
// a u + b v + c u v + d on each cell of the lattice of texel centres, so the moments of a piece of a cell give its
// integral over the piece. In 3D textures the reconstruction has eight such terms, and the footprint is a parallelogram
// in space, or the box of a given level of detail. Images of directions go on beyond their edges by the texels that
// BILINEAR and EWA read there; only on the cube a footprint is cut at the edges, and each part lies on its own face.
#include "texture/filter/exact.h"

#include <cmath>
#include <limits>

#include "texture/domain/block.h"
#include "texture/domain/cube_pieces.h"
#include "texture/domain/exact_footprint.h"
#include "texture/domain/wrap.h"
#include "texture/format/codec.h"
#include "texture/format/texel_codec.h"
#include "texture/store/reader.h"
#include "texture/store/storage.h"
#include "texture/store/stores.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/exact.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/domain/fold-inl.h"
#include "texture/domain/project-inl.h"
#include "texture/filter/directions-inl.h"
#include "texture/filter/filters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

size_t RunExact(const FilterCall& call) {
  return run_exact(call, RunBilinear);
}
size_t RunExactInSlices(const FilterCall& call) {
  return run_exact(call, RunLinearInSlices);
}

FaceTexel FoldOne(const Texture& texture, uint32_t level, const FaceTexel& beyond) {
  const hn::CappedTag<float, 1> d;
  const hn::RebindToSigned<decltype(d)> di;
  const auto texel = FoldFar(d, texture.projection, SameLevel(d, texture, hn::Zero(di), level),
                             hn::Set(d, static_cast<float>(beyond.x)), hn::Set(d, static_cast<float>(beyond.y)),
                             hn::Set(di, static_cast<int32_t>(beyond.face)));
  return {static_cast<int64_t>(hn::GetLane(texel.x)), static_cast<int64_t>(hn::GetLane(texel.y)),
          static_cast<uint32_t>(hn::GetLane(texel.face))};
}

bool LacksCorner(const Texture& texture, uint32_t face, bool left, bool top) {
  const hn::CappedTag<float, 1> d;
  const auto number = hn::Set(hn::RebindToSigned<decltype(d)>(), static_cast<int32_t>(face));
  const auto lacks = WithFold(texture.projection, [&](auto fold) {
    return fold.lacks_corner(d, number, hn::FirstN(d, left ? 1 : 0), hn::FirstN(d, top ? 1 : 0));
  });
  return hn::AllTrue(d, lacks);
}

size_t RunExactDirections(const FilterCall& call) {
  const Sampler sampler = SamplerOfDirections(call.texture, call.sampler);
  const DirectionFunctions functions = {TraitsOf(call.texture.projection), ProjectPrecisely, FoldOne, LacksCorner};
  return run_exact({call.texture, sampler, call.in, call.out, call.format, call.record, call.recording, call.placement},
                   DirectionFilterOf(SHD_FILTER_BILINEAR), &functions);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {

/// Weighted means of the channels of texels. Deviations from the first value are summed, so equal values give exactly
/// this value. Values that are not finite are summed separately, without weights; the sum then replaces the mean.
class Means {
 public:
  void add(const double (&texel)[4], double weight) {
    const double finite = (texel[0] - texel[0]) + (texel[1] - texel[1]) + (texel[2] - texel[2]) + (texel[3] - texel[3]);
    if (HWY_UNLIKELY(!started_ || finite != 0)) return add_each(texel, weight);
    for (size_t c = 0; c < 4; ++c) sum_[c] += weight * (texel[c] - first_[c]);
  }

  double over(size_t channel, double weight) const {
    return poisoned_[channel] ? canonical(nonfinite_[channel]) : first_[channel] + sum_[channel] / weight;
  }

 private:
  void add_each(const double (&texel)[4], double weight) {
    started_ = true;
    for (size_t c = 0; c < 4; ++c) {
      if (!std::isfinite(texel[c])) {
        nonfinite_[c] += texel[c];
        poisoned_[c] = true;
        started_ = started_ && has_first_[c];
        continue;
      }
      if (!has_first_[c]) first_[c] = texel[c];
      has_first_[c] = true;
      sum_[c] += weight * (texel[c] - first_[c]);
    }
  }

  double first_[4] = {}, sum_[4] = {}, nonfinite_[4] = {};
  bool has_first_[4] = {}, poisoned_[4] = {};
  bool started_ = false;  // all channels have their first value
};

/// Integrates the reconstruction of one level. A visitor of visit_cells(), and for 3D textures of
/// visit_cells_in_space(). `directions`: null for other textures.
class Integral {
 public:
  Integral(const Texture& texture, const Sampler& sampler, const ExactFootprint& footprint,
           const DirectionFunctions* directions)
      : codec_(codec_of(texture.component, texture.channels)),
        texture_(texture),
        sampler_(sampler),
        footprint_(footprint),
        directions_(directions),
        negligible_(texture.depth != 0 ? 0x1p-30
                    : footprint.thin   ? 0x1p-20
                                       : 0x1p-40),
        reader_(texture) {
    start({footprint.x, footprint.y, footprint.layer});
    width_ = level_size(texture.width, footprint.level);
    height_ = level_size(texture.height, footprint.level);
    depth_ = level_size(texture.depth, footprint.level);
    for (size_t c = 0; c < 4; ++c) border_[c] = static_cast<double>(sampler.border[c]) * codec_.one[c];
  }

  /// Cells from now on are relative to this texel.
  void start(const FaceTexel& origin) {
    origin_ = origin;
    first_ = first_unit(texture_, origin.face, footprint_.level);
  }

  void cell(int64_t i, int64_t j, const Moments& m) {
    const double least = m.one * negligible_;
    const Line lower = row(j), upper = row(j + 1);
    const auto add_if = [&](const Line& from, int64_t x, double weight) {
      if (weight > least) add(from, x, weight);
    };
    add_if(lower, i, m.one - m.x - m.y + m.xy);
    add_if(lower, i + 1, m.x - m.xy);
    add_if(upper, i, m.y - m.xy);
    add_if(upper, i + 1, m.xy);
  }

  void cell(int64_t i, int64_t j, int64_t k, const SpaceMoments& m) {
    if (!(footprint_.depth > 0)) return cell_in_space(i, j, k, m);
    // A box: each cell of its middle face is a column of cells.
    const double bottom = footprint_.center.z - footprint_.depth / 2, top = bottom + footprint_.depth;
    for (double floor = std::floor(bottom); floor < top; floor += 1) {
      const double low = floor > bottom ? 0 : bottom - floor, high = floor + 1 < top ? 1 : top - floor;
      const double part = (high - low) / footprint_.depth, z = part * (low + high) / 2;
      cell_in_space(i, j, static_cast<int64_t>(floor),
                    {m.one * part, m.x * part, m.y * part, m.one * z, m.xy * part, m.x * z, m.y * z, m.xy * z});
    }
  }

  void run(int64_t j, int64_t begin, int64_t end) {
    for (const Line& from : {row(j), row(j + 1)}) {
      add(from, begin, 0.25);
      for (int64_t i = begin + 1; i < end; ++i) add(from, i, 0.5);
      add(from, end, 0.25);
    }
  }

  float channel(size_t c) const { return static_cast<float>(means_.over(c, weight_) / codec_.one[c]); }

 private:
  /// A row of an image: the first unit of its level, and y after wrapping, or -1 for the border colour.
  struct Line {
    uint32_t first;
    int64_t y;
  };
  /// Returns row j of slice k.
  Line row(int64_t j, int64_t k = 0) const {
    if (directions_) return {first_, origin_.y + j};
    const int64_t y = wrap_index(sampler_.wrap_v, footprint_.y + j, height_);
    if (texture_.depth == 0) return {first_, y};
    const int64_t z = wrap_index(sampler_.wrap_w, footprint_.z + k, depth_);
    if (z < 0) return {first_, -1};
    return {first_unit(texture_, static_cast<uint32_t>(z), footprint_.level), y};
  }

  void cell_in_space(int64_t i, int64_t j, int64_t k, const SpaceMoments& m) {
    const double least = m.one * negligible_;
    // Moments of the four rows: of the product of their weights in y and z, and of this product and x.
    const double rows[4][2] = {{m.one - m.y - m.z + m.yz, m.x - m.xy - m.xz + m.xyz},
                               {m.y - m.yz, m.xy - m.xyz},
                               {m.z - m.yz, m.xz - m.xyz},
                               {m.yz, m.xyz}};
    for (int64_t n = 0; n < 4; ++n) {
      const Line from = row(j + n % 2, k + n / 2);
      const double left = rows[n][0] - rows[n][1], right = rows[n][1];
      if (left > least) add(from, i, left);
      if (right > least) add(from, i + 1, right);
    }
  }

  void add(const Line& from, int64_t i, double weight) {
    if (directions_) return add_continued(origin_.x + i, from.y, weight);
    add_texel(from, wrap_index(sampler_.wrap_u, footprint_.x + i, width_), weight);
  }

  /// Adds a texel of an image of directions, or of its continuation, as BILINEAR reads it: a corner of the cube is the
  /// mean of the three texels around it, and beyond a pole a texel of an odd width is the mean of two.
  void add_continued(int64_t x, int64_t y, double weight) {
    const FoldTraits& traits = directions_->traits;
    if (traits.is_periodic) {
      x = wrap_index(SHD_WRAP_REPEAT, x, 2 * width_), y = wrap_index(SHD_WRAP_REPEAT, y, 2 * height_);
    }
    const int64_t in_x = wrap_index(SHD_WRAP_CLAMP, x, width_), in_y = wrap_index(SHD_WRAP_CLAMP, y, height_);
    const bool inside = x == in_x && y == in_y;
    if (inside && !traits.is_disc) {
      add_texel({first_, y}, x, weight);
    } else if (traits.lacks_corners && x != in_x && y != in_y &&
               directions_->lacks_corner(texture_, origin_.face, x < 0, y < 0)) {
      add_folded(in_x, in_y, weight / 3);
      add_folded(x, in_y, weight / 3);
      add_folded(in_x, y, weight / 3);
    } else if (traits.turns_at_poles && y != in_y && width_ % 2 != 0) {
      add_folded(x - 1, y, weight / 2);
      add_folded(x, y, weight / 2);
    } else {
      add_folded(x, y, weight);
    }
  }

  void add_folded(int64_t x, int64_t y, double weight) {
    const FaceTexel texel = directions_->fold(texture_, footprint_.level, {x, y, origin_.face});
    add_texel({first_unit(texture_, texel.face, footprint_.level), texel.y}, texel.x, weight);
  }

  void add_texel(const Line& from, int64_t x, double weight) {
    weight_ += weight;
    if (from.y < 0 || x < 0) return means_.add(border_, weight);
    const auto width = static_cast<uint32_t>(width_);
    codec_.load(reader_.at(from.first, width, static_cast<uint32_t>(x), static_cast<uint32_t>(from.y)), 1, texel_);
    means_.add(texel_, weight);
  }

  const TexelCodec& codec_;
  const Texture& texture_;
  const Sampler& sampler_;
  const ExactFootprint& footprint_;
  const DirectionFunctions* const directions_;
  FaceTexel origin_;
  const double
      negligible_;  // part of a piece's area; smaller weights come from rounding, or from the width of thin footprints
  int64_t width_, height_, depth_;
  double border_[4];
  double weight_ = 0;
  uint32_t first_;
  TexelReader reader_;
  double texel_[4] = {};  // the latest one; channels that the texture lacks are 0
  Means means_;
};

/// Integrates over the parts of a footprint on the faces of the cube, if it does not lie on one face.
bool integrate_over_edges(const Texture& texture, const ExactFootprint& f, Integral* integral) {
  const double half = static_cast<double>(level_size(texture.width, f.level)) / 2;
  const Vec2 center = {static_cast<double>(f.x) + f.center.x, static_cast<double>(f.y) + f.center.y};
  const auto within = [&](double at, double a, double b) {
    return std::fabs(at + 0.5 - half) + (std::fabs(a) + std::fabs(b)) / 2 <= half;
  };
  if (within(center.x, f.a.x, f.b.x) && within(center.y, f.a.y, f.b.y)) return false;
  for (uint32_t face = 0; face < 6; ++face) {
    const Polygon part = part_on_face(parallelogram(center, f.a, f.b), half, f.layer, face);
    integral->start({0, 0, face});
    if (part.count > 2) visit_cells(part, integral);
  }
  return true;
}

void integrate(const Texture& texture, const Sampler& sampler, const ExactFootprint& footprint,
               const DirectionFunctions* directions, const Texels& out) {
  Integral integral(texture, sampler, footprint, directions);
  if (texture.depth != 0) {
    visit_cells_in_space(footprint.center, footprint.a, footprint.b, &integral);
  } else if (!directions || !directions->traits.has_planes || !integrate_over_edges(texture, footprint, &integral)) {
    visit_cells(parallelogram(footprint.center, footprint.a, footprint.b), &integral);
  }
  for (size_t c = 0; c < texture.channels; ++c) {
    if (out.channel[c]) *out.channel[c] = integral.channel(c);
  }
}

/// integrate() while the call is paused: it may load texels.
void integrate_alone(const FilterCall& call, const ExactFootprint& footprint, const DirectionFunctions* directions,
                     const Texels& out) {
  const StoreRow& store = functions_of(call.texture.store);
  if (store.pause) store.pause(call.placement.state);
  integrate(call.texture, call.sampler, footprint, directions, out);
  if (store.resume) store.resume(call.placement.state);
}

/// Filters lookup i as a batch of its own, which waits for texels that are not at hand.
void filter_point(const FilterCall& call, const Sampler& bilinear, size_t i, RunFilter run_linear, const Texels& out) {
  const StoreRow& store = functions_of(call.texture.store);
  if (store.begin) store.begin(call.placement.state, 1, nullptr);
  const Lookups lookup = part_of(call.in, i, 1);
  run_linear({call.texture, bilinear, lookup, out, call.format, nullptr, nullptr, call.placement});
}

}  // namespace

size_t run_exact(const FilterCall& call, RunFilter run_linear, const DirectionFunctions* directions) {
  Sampler bilinear = call.sampler;
  bilinear.filter = SHD_FILTER_BILINEAR;
  size_t nonfinite = 0;
  for (size_t i = 0; i < call.in.count; ++i) {
    const DirectionPoint point = directions ? directions->project(call.texture, call.in, i) : DirectionPoint();
    const ExactFootprint footprint =
        exact_footprint(call.texture, call.sampler, call.in, i, directions ? &point : nullptr);
    const Texels out = part_of(call.out, i);
    nonfinite += !footprint.finite;
    if (footprint.point) {
      filter_point(call, bilinear, i, run_linear, out);
    } else {
      integrate_alone(call, footprint, directions, out);
    }
  }
  return nonfinite;
}

}  // namespace shd::texture
#endif
