// SPDX-License-Identifier: MIT
// Trilinear probes along the longer axis of the footprint (McCormack, Perry, Farkas and Jouppi, "Feline: Fast
// Elliptical Lines for Anisotropic Texture Mapping", 1999), on the level of its shorter one.
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_anisotropic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/batch-inl.h"
#include "texture/block.h"
#include "texture/filter-inl.h"
#include "texture/footprint-inl.h"
#include "texture/probe-inl.h"
#include "texture/record-inl.h"

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

/// The lookups of a second pass: what the first wrote stands in the columns of derivatives.
template <class F, bool kBorder>
struct Anisotropic {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    using V = hn::Vec<D>;
    const V step_u = Distance(d, sampler.wrap_u, p.derivatives.dudx);
    const V step_v = Distance(d, sampler.wrap_v, p.derivatives.dvdx);
    const V count = p.derivatives.dudy;
    const LevelPair<D> levels = LevelsOf(d, texture, p.first_texel, p.derivatives.dvdy);
    const V u = ReduceCoordinate(d, sampler.wrap_u, p.u), v = ReduceCoordinate(d, sampler.wrap_v, p.v);
    const V last = hn::Sub(count, hn::Set(d, 1.0f));
    const float most = hn::GetLane(hn::MaxOfLanes(d, count));
    QuadPair<F, D> quads;
    if (most == 1.0f) {
      FetchQuads<F>(d, texture, sampler, levels, u, v, &quads);
      return StoreChannels<F, kBorder>(d, ProbeValue<D>{quads, levels, sampler}, out, i);
    }
    Sum<D> sum;
    V total = hn::Zero(d);
    for (float k = 0.0f; k < most; k += 1.0f) {
      // Lanes that are done stay at their last probe with weight 0.
      const V position = hn::Sub(hn::Min(hn::Set(d, 2.0f * k), hn::Add(last, last)), last);
      FetchQuads<F>(d, texture, sampler, levels, At(sampler.wrap_u, u, position, step_u),
                    At(sampler.wrap_v, v, position, step_v), &quads);
      const auto active = hn::Lt(hn::Set(d, k), count);
      V share;
      if (sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL) {
        share = hn::IfThenElseZero(active, hn::Set(d, 1.0f / (k + 1.0f)));
      } else {
        const V weight = hn::IfThenElseZero(active, Gaussian(d, hn::Div(position, count)));
        total = hn::Add(total, weight);
        share = hn::Div(weight, total);
      }
      if (k == 0.0f) {
        sum.set(d, out, ProbeValue<D>{quads, levels, sampler});
      } else {
        sum.add(d, out, ProbeValue<D>{quads, levels, sampler}, share);
      }
    }
    StoreChannels<F, kBorder>(d, sum, out, i);
  }

  /// A distance in the units of reduced coordinates.
  template <class D, class V>
  static HWY_INLINE V Distance(D d, shd_wrap wrap, V step) {
    return wrap == SHD_WRAP_MIRROR ? hn::Mul(step, hn::Set(d, 0.5f)) : step;
  }

  /// The reduced coordinate `position` steps from another.
  template <class V>
  static HWY_INLINE V At(shd_wrap wrap, V centre, V position, V step) {
    const V x = hn::Add(centre, hn::Mul(position, step));
    return wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR ? hn::Sub(x, hn::Floor(x)) : x;
  }

  /// exp(-2 x^2).
  template <class D, class V>
  static HWY_INLINE V Gaussian(D d, V x) {
    return simd::HWY_NAMESPACE::Exp2(d, hn::Mul(hn::Mul(x, x), hn::Set(d, -2.88539008f)));  // -2 / ln 2
  }

  template <class D>
  struct ProbeValue {
    const QuadPair<F, D>& quads;
    const LevelPair<D>& levels;
    const Sampler& sampler;

    template <size_t C>
    HWY_INLINE auto of() const {
      return BlendQuads<F, kBorder, C>(D(), quads, levels, sampler);
    }
  };

  /// Running averages of the wanted channels.
  template <class D>
  struct Sum {
    using B = Blend<F, kBorder>;
    using Value = typename B::template Value<D>;
    Value value[4] = {};

    template <size_t C>
    HWY_INLINE Value of() const {
      return value[C];
    }
    HWY_INLINE void set(D, const Texels& out, const ProbeValue<D>& probe) {
      if (out.channel[0]) value[0] = probe.template of<0>();
      if (out.channel[1]) value[1] = probe.template of<1>();
      if (out.channel[2]) value[2] = probe.template of<2>();
      if (out.channel[3]) value[3] = probe.template of<3>();
    }
    HWY_INLINE void add(D d, const Texels& out, const ProbeValue<D>& probe, hn::Vec<D> share) {
      if (out.channel[0]) value[0] = B::blend(d, value[0], probe.template of<0>(), share);
      if (out.channel[1]) value[1] = B::blend(d, value[1], probe.template of<1>(), share);
      if (out.channel[2]) value[2] = B::blend(d, value[2], probe.template of<2>(), share);
      if (out.channel[3]) value[3] = B::blend(d, value[3], probe.template of<3>(), share);
    }
  };
};

template <class F>
size_t AnisotropicOfFormat(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  using D = typename TagOf<F>::Type;
  const ProbesOf probes = {texture, sampler, lod_range(texture, sampler), in.lod != nullptr};
  Sampler unwidened = sampler;
  unwidened.width_x = unwidened.width_y = 1.0f;
  unwidened.blur_u = unwidened.blur_v = 0.0f;
  alignas(64) float columns[4][kBlock];
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kBlock) {
    const size_t count = in.count - first < kBlock ? in.count - first : kBlock;
    const Lookups given = part_of(in, first, count);
    nonfinite += ForEachVector(texture, probes, given, {{columns[0], columns[1], columns[2], columns[3]}});
    const Lookups block = {count,      given.u,    given.v, columns[0],  columns[1],
                           columns[2], columns[3], nullptr, given.layer, nullptr};
    const Texels to = part_of(out, first);
    if (has_border(sampler)) {
      ForEachVector<D>(texture, Anisotropic<F, true>{texture, unwidened}, block, to);
    } else {
      ForEachVector<D>(texture, Anisotropic<F, false>{texture, unwidened}, block, to);
    }
  }
  return nonfinite;
}

struct AnisotropicOfTexture {
  const Texture& texture;
  const Sampler& sampler;
  const Lookups& in;
  const Texels& out;

  template <class F>
  size_t run() const {
    return AnisotropicOfFormat<F>(texture, sampler, in, out);
  }
};

size_t AnisotropicBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForFormat(texture, AnisotropicOfTexture{texture, sampler, in, out});
}

#if HWY_TARGET == HWY_STATIC_TARGET
void RecordAnisotropic(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  AnisotropicOfFormat<Recorded>(texture, sampler, in, out);
}
#endif

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(AnisotropicBatch);
}  // namespace

size_t sample_anisotropic(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                          const Lookups& lookups, const Texels& out) {
  return SHD_DISPATCH(AnisotropicBatch, simd)(texture, sampler, lookups, out);
}

void record_anisotropic(const Texture& texture, const Sampler& sampler, const Lookups& lookups) {
  float unused[1];
  HWY_STATIC_DISPATCH(RecordAnisotropic)(texture, sampler, lookups, {{unused}});
}

}  // namespace shd::texture
#endif
