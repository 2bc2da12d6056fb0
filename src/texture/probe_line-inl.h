// SPDX-License-Identifier: MIT
// Where the probes of anisotropic filtering lie: their line is found for a block of lookups before any is filtered.

#if defined(SHD_TEXTURE_PROBE_LINE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PROBE_LINE_INL_H_
#undef SHD_TEXTURE_PROBE_LINE_INL_H_
#else
#define SHD_TEXTURE_PROBE_LINE_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/footprint-inl.h"
#include "texture/shape_block-inl.h"
#include "texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A footprint this much longer than its probes are wide takes no further probe. On a receding floor at 1/2 in place of
/// 1/8 the picture is worse by 3.3 dB; more than one probe per width of the shorter axis is slower and gains 0.6 dB at
/// most, and probes that end where the footprint does, not half a width before, lose 5 dB.
constexpr float kSlack = 0.125f;

/// Writes the probes of each lookup to four columns: half the step from one to the next in u and in v, their number
/// and the clamped level of detail.
struct ProbesOf {
  const Texture& texture;
  const Sampler& sampler;
  LodRange range;
  bool lod_given;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    using V = hn::Vec<D>;
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    const Footprint<D> f = lod_given ? RoundFootprint(d, p.lod) : FootprintOf(d, p.derivatives, width, height);
    const V one = hn::Set(d, 1.0f);
    const V ratio = hn::Div(one, hn::Max(f.roundness, hn::Set(d, 1.0f / sampler.max_anisotropy)));
    const V lambda = hn::Sub(f.lambda, simd::HWY_NAMESPACE::Log2(d, ratio));
    const V count = hn::Ceil(hn::Sub(ratio, hn::Set(d, kSlack)));
    const V half_step = hn::Div(f.length, hn::Add(count, count));
    const V limit = hn::Set(d, 0x1p60f);
    const V step_u = hn::Div(hn::Mul(half_step, f.u), hn::Set(d, width));
    const V step_v = hn::Div(hn::Mul(half_step, f.v), hn::Set(d, height));
    hn::StoreU(hn::Max(hn::Min(step_u, limit), hn::Neg(limit)), d, out.channel[0] + i);
    hn::StoreU(hn::Max(hn::Min(step_v, limit), hn::Neg(limit)), d, out.channel[1] + i);
    hn::StoreU(count, d, out.channel[2] + i);
    hn::StoreU(ClampLod(d, lambda, sampler.lod_bias, range), d, out.channel[3] + i);
  }
};

/// The line of each lane's probes, from what ProbesOf wrote: it stands in the columns of derivatives.
template <class D>
struct ProbeLine {
  using V = hn::Vec<D>;
  V u, v;  // reduced coordinates of the middle
  V step_u, step_v, count, lod;
  shd_wrap wrap_u, wrap_v;

  HWY_INLINE ProbeLine(D d, const Sampler& sampler, const Points<D>& p)
      : u(ReduceCoordinate(d, sampler.wrap_u, p.u)),
        v(ReduceCoordinate(d, sampler.wrap_v, p.v)),
        step_u(Distance(d, sampler.wrap_u, p.derivatives.dudx)),
        step_v(Distance(d, sampler.wrap_v, p.derivatives.dvdx)),
        count(p.derivatives.dudy),
        lod(p.derivatives.dvdy),
        wrap_u(sampler.wrap_u),
        wrap_v(sampler.wrap_v) {}

  /// Steps from the middle to probe k; to the last one for k beyond.
  HWY_INLINE V position(D d, V k) const {
    const V last = hn::Sub(count, hn::Set(d, 1.0f));
    return hn::Sub(hn::Min(hn::Add(k, k), hn::Add(last, last)), last);
  }
  /// Reduced coordinates at a position.
  HWY_INLINE V u_at(V position) const { return At(wrap_u, u, position, step_u); }
  HWY_INLINE V v_at(V position) const { return At(wrap_v, v, position, step_v); }

 private:
  /// A distance in the units of reduced coordinates.
  static HWY_INLINE V Distance(D d, shd_wrap wrap, V step) {
    return wrap == SHD_WRAP_MIRROR ? hn::Mul(step, hn::Set(d, 0.5f)) : step;
  }
  static HWY_INLINE V At(shd_wrap wrap, V centre, V position, V step) {
    const V x = hn::Add(centre, hn::Mul(position, step));
    return wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR ? hn::Sub(x, hn::Floor(x)) : x;
  }
};

/// exp(-2 x^2).
template <class D, class V>
HWY_INLINE V ProbeGaussian(D d, V x) {
  return simd::HWY_NAMESPACE::Exp2(d, hn::Mul(hn::Mul(x, x), hn::Set(d, -2.88539008f)));  // -2 / ln 2
}

/// filter(sampler, block, out) for every block of a batch, whose points make a ProbeLine.
template <class Filter>
HWY_INLINE size_t ForEachProbeBlock(const Texture& texture, const Sampler& sampler, const Lookups& in,
                                    const Texels& out, const Filter& filter) {
  const ProbesOf shape_of = {texture, sampler, lod_range(texture, sampler), in.lod != nullptr};
  return ForEachShapeBlock(texture, sampler, shape_of, in, out, filter);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PROBE_LINE_INL_H_
