// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_ripmap.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// log2 of the extent of the footprint along one axis in texels, sqrt(x^2 + y^2) of the derivatives of that axis: the
/// half width of the bounding box of the ellipse that a circle of one pixel becomes, so that a footprint along the
/// axes has the levels of trilinear's. Clamped to 2^-32..2^31.
template <class D, class V = hn::Vec<D>>
SHD_KERNEL_PART V AxisLambda(D d, V along_x, V along_y, float size) {
  const V x = hn::Mul(along_x, hn::Set(d, size)), y = hn::Mul(along_y, hn::Set(d, size));
  const V square = hn::Add(hn::Mul(x, x), hn::Mul(y, y));  // not NaN
  const V bounded = hn::Min(hn::Max(square, hn::Set(d, 0x1p-64f)), hn::Set(d, 0x1p62f));
  return hn::Mul(hn::Set(d, 0.5f), simd::HWY_NAMESPACE::Log2(d, bounded));
}

/// The two levels of one axis around a level of detail, and where between them it lies.
template <class D>
struct AxisLevels {
  Ints<D> first, second;
  hn::Vec<D> fraction;
};

template <class D>
HWY_INLINE AxisLevels<D> LevelsAround(D d, hn::Vec<D> lod, uint32_t count) {
  const hn::RebindToSigned<D> di;
  const auto floor = hn::Floor(lod);
  const auto first = hn::ConvertTo(di, floor);
  const auto last = hn::Set(di, static_cast<int32_t>(count - 1));
  (void)d;
  return {first, hn::Min(hn::Add(first, hn::Set(di, 1)), last), hn::Sub(lod, floor)};
}

/// Texels of an axis at a level per lane.
template <class D>
HWY_INLINE AxisSize<D> SizeAt(D d, uint32_t base, Ints<D> level) {
  const hn::RebindToSigned<D> di;
  return ScaledSize(d, base, hn::BitCast(d, hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), level))));
}

/// Bilinear on the levels (i, j), (i + 1, j), (i, j + 1) and (i + 1, j + 1), blended by the fractions of the levels
/// of detail of both axes.
template <class F, bool kBorder>
struct Ripmap {
  using B = Blend<F, kBorder>;

  const Texture& texture;
  const Sampler& sampler;
  LodRange range_u, range_v;
  bool lod_given;

  template <class D>
  struct Four {
    typename B::template Value<D> channel[4] = {};

    template <size_t C>
    HWY_INLINE auto of() const {
      return channel[C];
    }
  };

  template <class D>
  HWY_INLINE Level<D> LevelAt(D d, const Points<D>& p, const AxisSize<D>& across, const AxisSize<D>& down, Ints<D> i,
                              Ints<D> j) const {
    const hn::RebindToSigned<D> di;
    const auto index = hn::Add(hn::Mul(j, hn::Set(di, static_cast<int32_t>(kMaxLevels))), i);
    const auto offset = hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texture.ripmap_offset), index);
    (void)d;
    return {across, down, hn::Add(p.first_texel, offset)};
  }

  template <size_t C, class D>
  HWY_INLINE void Set(D d, const Quad<F, D>& quad, Four<D>* to) const {
    to->channel[C] = BlendQuad<F, kBorder, C>(d, quad, sampler);
  }
  template <size_t C, class D>
  HWY_INLINE void Mix(D d, const Quad<F, D>& quad, hn::Vec<D> s, Four<D>* to) const {
    to->channel[C] = B::blend(d, to->channel[C], BlendQuad<F, kBorder, C>(d, quad, sampler), s);
  }

  /// The blend along u of the levels (levels.first, j) and (levels.second, j).
  template <class D>
  SHD_KERNEL_PART void Row(D d, const Points<D>& p, const AxisLevels<D>& levels, Ints<D> j,
                           const AxisSize<D> (&width)[2], const AxisSize<D>& height, const LinearTaps<D> (&x)[2],
                           const LinearTaps<D>& y, bool both, const Texels& out, Four<D>* to) const {
    {
      const Quad<F, D> quad = FetchTaps<F>(d, texture, LevelAt(d, p, width[0], height, levels.first, j), x[0], y);
      if (B::wanted(out, 0)) Set<0>(d, quad, to);
      if (B::wanted(out, 1)) Set<1>(d, quad, to);
      if (B::wanted(out, 2)) Set<2>(d, quad, to);
      if (B::wanted(out, 3)) Set<3>(d, quad, to);
    }
    if (!both) return;
    const Quad<F, D> quad = FetchTaps<F>(d, texture, LevelAt(d, p, width[1], height, levels.second, j), x[1], y);
    if (B::wanted(out, 0)) Mix<0>(d, quad, levels.fraction, to);
    if (B::wanted(out, 1)) Mix<1>(d, quad, levels.fraction, to);
    if (B::wanted(out, 2)) Mix<2>(d, quad, levels.fraction, to);
    if (B::wanted(out, 3)) Mix<3>(d, quad, levels.fraction, to);
  }

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t k) const {
    const Derivatives<D>& j = p.derivatives;
    const auto u = ReduceCoordinate(d, sampler.wrap_u, p.u);
    const auto v = ReduceCoordinate(d, sampler.wrap_v, p.v);
    const auto lambda_u = lod_given ? p.lod : AxisLambda(d, j.dudx, j.dudy, static_cast<float>(texture.width));
    const auto lambda_v = lod_given ? p.lod : AxisLambda(d, j.dvdx, j.dvdy, static_cast<float>(texture.height));
    const AxisLevels<D> columns =
        LevelsAround(d, ClampLod(d, lambda_u, sampler.lod_bias, range_u), texture.ripmap_columns);
    const AxisLevels<D> rows = LevelsAround(d, ClampLod(d, lambda_v, sampler.lod_bias, range_v), texture.ripmap_rows);
    const bool both_columns = !hn::AllTrue(d, hn::Eq(columns.fraction, hn::Zero(d)));
    const bool both_rows = !hn::AllTrue(d, hn::Eq(rows.fraction, hn::Zero(d)));

    const AxisSize<D> width[2] = {SizeAt(d, texture.width, columns.first), SizeAt(d, texture.width, columns.second)};
    const AxisSize<D> height[2] = {SizeAt(d, texture.height, rows.first), SizeAt(d, texture.height, rows.second)};
    const LinearTaps<D> x[2] = {WrapLinear(d, sampler.wrap_u, u, width[0]), WrapLinear(d, sampler.wrap_u, u, width[1])};
    Four<D> upper = {}, lower = {};
    Row(d, p, columns, rows.first, width, height[0], x, WrapLinear(d, sampler.wrap_v, v, height[0]), both_columns, out,
        &upper);
    if (both_rows) {
      Row(d, p, columns, rows.second, width, height[1], x, WrapLinear(d, sampler.wrap_v, v, height[1]), both_columns,
          out, &lower);
      if (B::wanted(out, 0)) upper.channel[0] = B::blend(d, upper.channel[0], lower.channel[0], rows.fraction);
      if (B::wanted(out, 1)) upper.channel[1] = B::blend(d, upper.channel[1], lower.channel[1], rows.fraction);
      if (B::wanted(out, 2)) upper.channel[2] = B::blend(d, upper.channel[2], lower.channel[2], rows.fraction);
      if (B::wanted(out, 3)) upper.channel[3] = B::blend(d, upper.channel[3], lower.channel[3], rows.fraction);
    }
    StoreChannels<F, kBorder>(d, upper, out, k);
  }
};

struct RipmapKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    return WithBorder<F>(sampler, [&](auto border) {
      const Ripmap<F, decltype(border)::value> filter = {texture, sampler, lod_range(texture.ripmap_columns, sampler),
                                                         lod_range(texture.ripmap_rows, sampler), in.lod != nullptr};
      return ForEachVector<typename TagOf<F>::Type>(texture, filter, in, out);
    });
  }
};

FilterKernels RipmapKernels() {
  return KernelsOf<RipmapKernel, true>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(RipmapKernels);
}  // namespace

FilterKernels ripmap_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(RipmapKernels, simd)();
}

}  // namespace shd::texture
#endif
