// SPDX-License-Identifier: MIT
// Filter on levels that are halved along each axis on its own ("ripmap": Akenine-Moller et al., "Real-Time Rendering",
// 2018, 6.2.2).
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/ripmap.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
namespace {

/// Returns log2 of the extent of the footprint along one axis in base texels, clamped to -32..31. The extent is
/// sqrt(x^2 + y^2) of the derivatives of the axis: half the width of the bounding box of the ellipse that a circle of
/// one pixel becomes. A circle therefore has the levels of trilinear.
template <class D, class V = hn::Vec<D>>
SHD_KERNEL_PART V AxisLambda(D d, V along_x, V along_y, float size) {
  const V x = along_x * hn::Set(d, size), y = along_y * hn::Set(d, size);
  const V square = x * x + y * y;  // not NaN
  const V bounded = hn::Min(hn::Max(square, hn::Set(d, 0x1p-64f)), hn::Set(d, 0x1p62f));
  return hn::Set(d, 0.5f) * simd::HWY_NAMESPACE::Log2(d, bounded);
}

/// A level of detail for each axis.
struct AxisLodBlock : PointBlock {
  alignas(64) float lod_u[kBlock], lod_v[kBlock];
};

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, AxisLodBlock* out) {
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const LodRange range_u = lod_range(texture.ripmap_columns, sampler);
  const LodRange range_v = lod_range(texture.ripmap_rows, sampler);
  const bool lod_given = in.lod != nullptr;
  const float shift = level_shift(sampler, lod_given);
  return FillBlock(texture, sampler, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    const auto& j = p.derivatives;
    const auto lambda_u = lod_given ? p.lod : AxisLambda(d, j.dudx, j.dudy, width);
    const auto lambda_v = lod_given ? p.lod : AxisLambda(d, j.dvdx, j.dvdy, height);
    hn::Store(ClampLod(d, lambda_u, shift, range_u), d, out->lod_u + to);
    hn::Store(ClampLod(d, lambda_v, shift, range_v), d, out->lod_v + to);
  });
}

/// The two levels of one axis around a level of detail.
template <class D>
struct AxisLevels {
  Ints<D> level[2];
  AxisSize<D> size[2];
  hn::Vec<D> fraction;  // share of the second level, [0, 1)
  bool blended;         // some fraction is not 0
};

template <class D>
HWY_INLINE AxisLevels<D> LevelsAround(D d, hn::Vec<D> lod, uint32_t base, uint32_t count) {
  const hn::RebindToSigned<D> di;
  const auto floor = RoundDown(lod);
  AxisLevels<D> levels;
  levels.level[0] = hn::ConvertTo(di, floor);
  levels.level[1] = hn::Min(levels.level[0] + hn::Set(di, 1), hn::Set(di, static_cast<int32_t>(count - 1)));
  for (int k = 0; k < 2; ++k) {
    const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Set(di, 127) - levels.level[k]));
    levels.size[k] = ScaledSize(d, base, scale);
  }
  levels.fraction = lod - floor;
  levels.blended = !hn::AllTrue(d, hn::Eq(levels.fraction, hn::Zero(d)));
  return levels;
}

/// SHD_FILTER_RIPMAP: bilinear lookups on the levels (i, j), (i + 1, j), (i, j + 1) and (i + 1, j + 1), blended by the
/// fractions of the levels of detail of both axes.
struct Ripmap {
  using Block = AxisLodBlock;

  const Texture& texture;
  const Sampler& sampler;

  Ripmap(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static bool is_scattered(const Texture& texture, const AxisLodBlock& block) {
    return texture::is_scattered(texture, block, block.lod_u);
  }

  template <class D>
  HWY_INLINE Level<D> LevelOf(D d, Ints<D> first_texel, const AxisLevels<D>& columns, int i, const AxisLevels<D>& rows,
                              int j) const {
    const hn::RebindToSigned<D> di;
    const auto index = rows.level[j] * hn::Set(di, static_cast<int32_t>(kMaxLevels)) + columns.level[i];
    const auto offset = hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texture.ripmap_offset.data()), index);
    (void)d;
    return {columns.size[i], rows.size[j], first_texel + offset};
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const AxisLodBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    const auto first_texel = FirstTexel(d, texture, block, i);
    const AxisLevels<D> columns = LevelsAround(d, hn::Load(d, block.lod_u + i), texture.width, texture.ripmap_columns);
    const AxisLevels<D> rows = LevelsAround(d, hn::Load(d, block.lod_v + i), texture.height, texture.ripmap_rows);
    const LinearTaps<D> x[2] = {WrapLinear(d, sampler.wrap_u, u, columns.size[0]),
                                WrapLinear(d, sampler.wrap_u, u, columns.size[1])};
    for (int j = 0; j < (rows.blended ? 2 : 1); ++j) {
      const uint32_t average = j == 0 ? 0 : kSecond;
      const LinearTaps<D> y = WrapLinear(d, sampler.wrap_v, v, rows.size[j]);
      const auto level = [&](int k) { return LevelOf(d, first_texel, columns, k, rows, j); };
      sink.quad(d, average | kStart, level(0), x[0], y);
      if (columns.blended) sink.quad(d, average | kBlend, level(1), x[1], y, columns.fraction);
    }
    if (rows.blended) sink.merge(d, rows.fraction);
    sink.finish();
  }
};

}  // namespace

size_t RunRipmap(const FilterCall& call) {
  return Run<Ripmap>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
