// SPDX-License-Identifier: MIT

#if defined(SHD_TEXTURE_ANISOTROPIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_ANISOTROPIC_INL_H_
#undef SHD_TEXTURE_ANISOTROPIC_INL_H_
#else
#define SHD_TEXTURE_ANISOTROPIC_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/math-inl.h"
#include "simd/round-inl.h"
#include "texture/filter/bases-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// The lines of probes of one vector of lookups.
template <class D>
struct ProbeLine {
  using V = hn::Vec<D>;
  V u, v;            // reduced coordinates of the middle
  V step_u, step_v;  // half the step between probes, in reduced coordinates
  V probes;
  shd_wrap wrap_u, wrap_v;

  HWY_INLINE ProbeLine(D d, const Sampler& sampler, const ProbeBlock& block, size_t i)
      : u(hn::Load(d, block.u + i)),
        v(hn::Load(d, block.v + i)),
        step_u(Distance(d, sampler.wrap_u, hn::Load(d, block.step_u + i))),
        step_v(Distance(d, sampler.wrap_v, hn::Load(d, block.step_v + i))),
        probes(hn::Load(d, block.probes + i)),
        wrap_u(sampler.wrap_u),
        wrap_v(sampler.wrap_v) {}

  /// Returns the position of probe k, in half steps from the middle. It is the last probe's for k beyond it.
  HWY_INLINE V position(D d, V k) const {
    const V last = probes - hn::Set(d, 1.0f);
    return hn::Min(k + k, last + last) - last;
  }
  /// Return the reduced coordinates at a position.
  HWY_INLINE V u_at(V position) const { return at(wrap_u, u, position, step_u); }
  HWY_INLINE V v_at(V position) const { return at(wrap_v, v, position, step_v); }

  /// Returns the reduced coordinate at a position of an axis.
  static HWY_INLINE V at(shd_wrap wrap, V centre, V position, V step) {
    const V x = centre + position * step;
    return wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR ? x - RoundDown(x) : x;
  }

  /// Converts a distance to the unit of reduced coordinates.
  static HWY_INLINE V Distance(D d, shd_wrap wrap, V step) {
    return wrap == SHD_WRAP_MIRROR ? step * hn::Set(d, 0.5f) : step;
  }
};

/// Returns exp(-2 x^2).
template <class D, class V>
HWY_INLINE V ProbeGaussian(D d, V x) {
  return simd::HWY_NAMESPACE::Exp2(d, x * x * hn::Set(d, -2.88539008f));  // -2 / ln 2
}

/// The filter SHD_FILTER_ANISOTROPIC. All probes read the same two levels. Bilinear lookups on the finer level form the
/// first average, lookups on the coarser level the second. The merge blends the averages by the fraction between the
/// levels.
struct Anisotropic : OnMipLevels {
  using OnMipLevels::OnMipLevels;
  using Block = ProbeBlock;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const ProbeBlock& block, size_t i, Sink& sink) const {
    const ProbeLine<D> line(d, sampler, block, i);
    const LevelPair<D> levels = LevelsOf(d, texture, FirstTexel(d, texture, block, i), hn::Load(d, block.lod + i));
    if constexpr (Sink::kTakesLines) {
      sink.line(d, line, levels);
      return sink.finish();
    } else {
      emit_probes(d, block, i, line, levels, sink);
    }
  }

 private:
  template <class D, class Sink>
  HWY_INLINE void emit_probes(D d, const ProbeBlock& block, size_t i, const ProbeLine<D>& line,
                              const LevelPair<D>& levels, Sink& sink) const {
    using V = hn::Vec<D>;
    const float max_probes = hn::GetLane(hn::MaxOfLanes(d, line.probes));
    const V reach = hn::Load(d, block.reach + i);
    V total = hn::Zero(d);
    uint32_t how = kStart;
    for (float k = 0.0f; k < max_probes; k += 1.0f) {
      // Finished lanes repeat their last probe with weight 0.
      const V position = line.position(d, hn::Set(d, k));
      const V u = line.u_at(position), v = line.v_at(position);
      const auto active = hn::Lt(hn::Set(d, k), line.probes);
      V share;
      if (sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL) {
        share = hn::IfThenElseZero(active, hn::Set(d, 1.0f / (k + 1.0f)));
      } else {
        const V weight = hn::IfThenElseZero(active, ProbeGaussian(d, position / reach));
        total = total + weight;
        share = weight / total;
      }
      sink.quad(d, how, levels.high, u, v, share);
      if (levels.blended) sink.quad(d, how | kSecond, levels.low, u, v, share);
      how = kBlend;
    }
    if (levels.blended) sink.merge(d, levels.fraction);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_ANISOTROPIC_INL_H_
