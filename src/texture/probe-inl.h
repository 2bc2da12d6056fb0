// SPDX-License-Identifier: MIT
// Lookups in a mip pyramid whose levels are chosen once and read at several points.

#if defined(SHD_TEXTURE_PROBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PROBE_INL_H_
#undef SHD_TEXTURE_PROBE_INL_H_
#else
#define SHD_TEXTURE_PROBE_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The levels floor(lod) and the next of every lane, and the fraction between them.
template <class D>
struct LevelPair {
  Level<D> high, low;
  hn::Vec<D> fraction;
  bool blended;  // whether any fraction is not 0
};

template <class D>
SHD_KERNEL_PART LevelPair<D> LevelsOf(D d, const Texture& texture, Ints<D> first_texel, hn::Vec<D> lod) {
  const auto floor = hn::Floor(lod);
  const auto last = hn::Set(d, static_cast<float>(texture.level_count - 1));
  LevelPair<D> pair;
  pair.fraction = hn::Sub(lod, floor);
  pair.blended = !hn::AllTrue(d, hn::Eq(pair.fraction, hn::Zero(d)));
  pair.high = LevelAt(d, texture, first_texel, floor);
  pair.low = LevelAt(d, texture, first_texel, hn::Min(hn::Add(floor, hn::Set(d, 1.0f)), last));
  return pair;
}

/// The texels of one trilinear lookup; coordinates are reduced.
template <class F, class D>
struct QuadPair {
  Quad<F, D> high, low;
};

template <class F, class D>
HWY_INLINE void FetchQuads(D d, const Texture& texture, const Sampler& sampler, const LevelPair<D>& levels,
                           hn::Vec<D> u, hn::Vec<D> v, QuadPair<F, D>* out) {
  out->high = FetchQuad<F>(d, texture, sampler, levels.high, u, v);
  out->low = levels.blended ? FetchQuad<F>(d, texture, sampler, levels.low, u, v) : out->high;
}

/// Trilinear value of channel C, in the lerp domain.
template <class F, bool kBorder, size_t C, class D>
HWY_INLINE auto BlendQuads(D d, const QuadPair<F, D>& quads, const LevelPair<D>& levels, const Sampler& sampler) {
  const auto high = BlendQuad<F, kBorder, C>(d, quads.high, sampler);
  if (!levels.blended) return high;
  const auto low = BlendQuad<F, kBorder, C>(d, quads.low, sampler);
  return Blend<F, kBorder>::blend(d, high, low, levels.fraction);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PROBE_INL_H_
