// SPDX-License-Identifier: MIT
// Loops over a block of lookups, one vector at a time.

#if defined(SHD_TEXTURE_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_POINTS_INL_H_
#undef SHD_TEXTURE_POINTS_INL_H_
#else
#define SHD_TEXTURE_POINTS_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/finite-inl.h"
#include "texture/footprint/block.h"
#include "texture/footprint/footprint-inl.h"
#include "texture/store/wrap-inl.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::FiniteOrZero;
using simd::HWY_NAMESPACE::ZeroIfNaN;

using BatchTag = hn::CappedTag<float, kMaxLanes>;

template <class D>
HWY_INLINE hn::Vec<D> LoadOrZero(D d, const float* column, size_t i) {
  return column ? hn::LoadU(d, column + i) : hn::Zero(d);
}

/// 0 for finite x, else NaN.
template <class V>
HWY_INLINE V ZeroIfFinite(V x) {
  return x - x;
}

/// Derivatives at i; 0 where there are none, or where a level of detail replaces them.
template <class D>
HWY_INLINE Derivatives<D> LoadDerivatives(D d, const Lookups& in, size_t i) {
  if (in.lod) return {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  return {LoadOrZero(d, in.dudx, i), LoadOrZero(d, in.dvdx, i), LoadOrZero(d, in.dudy, i), LoadOrZero(d, in.dvdy, i)};
}

/// First texel of each lane's layer; the last layer for layers beyond it.
template <class D>
HWY_INLINE Ints<D> LoadFirstTexel(D, const Texture& texture, const Lookups& in, size_t i) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  if (!in.layer) return hn::Zero(di);
  const auto layer = hn::Min(hn::LoadU(du, in.layer + i), hn::Set(du, texture.layers - 1));
  return hn::BitCast(di, layer) * hn::Set(di, static_cast<int32_t>(texture.layer_texels));
}

/// The last lookups of a block, fewer than a vector has lanes, followed by copies of the last one.
struct Tail {
  float reals[kFloatColumns][kMaxLanes];
  uint32_t integers[kIntegerColumns][kMaxLanes];

  Lookups copy(const Lookups& from, size_t first) {
    const size_t count = from.count - first;
    Lookups in = from;
    for (size_t c = 0; c < kFloatColumns; ++c) in.real(c) = fill(from.real(c), first, count, reals[c]);
    for (size_t c = 0; c < kIntegerColumns; ++c) in.integer(c) = fill(from.integer(c), first, count, integers[c]);
    return in;
  }

 private:
  template <class T>
  static const T* fill(const T* from, size_t first, size_t count, T* to) {
    if (!from) return nullptr;
    for (size_t i = 0; i < kMaxLanes; ++i) to[i] = from[first + (i < count ? i : count - 1)];
    return to;
  }
};

/// body(d, in, from, to) for every vector of a block: its lookups stand at `from` of the lookups `in`, its results
/// belong at `to`.
template <class Body>
HWY_INLINE void ForEachVector(const Lookups& block, const Body& body) {
  const BatchTag d;
  const size_t lanes = hn::Lanes(d);
  Tail tail;
  Lookups in = block;
  for (size_t to = 0; to < block.count; to += lanes) {
    const bool whole = block.count - to >= lanes;
    if (HWY_UNLIKELY(!whole)) in = tail.copy(block, to);
    body(d, static_cast<const Lookups&>(in), whole ? to : 0, to);
  }
}

/// body(d, derivatives, lod, to) for every vector of a block, with 0 in place of NaN. Width and blur of the sampler are
/// applied. `finite`: whether all inputs of the block are finite.
template <class Body>
HWY_INLINE void ForEachFootprint(const Sampler& sampler, const Lookups& block, bool finite, const Body& body) {
  const bool widened = !block.lod && widens(sampler);
  ForEachVector(block, [&](auto d, const Lookups& in, size_t from, size_t to) {
    auto j = LoadDerivatives(d, in, from);
    auto lod = LoadOrZero(d, in.lod, from);
    if (HWY_UNLIKELY(!finite)) {
      j = {ZeroIfNaN(j.dudx), ZeroIfNaN(j.dvdx), ZeroIfNaN(j.dudy), ZeroIfNaN(j.dvdy)};
      lod = ZeroIfNaN(lod);
    }
    if (HWY_UNLIKELY(widened)) Widen(d, sampler, &j);
    body(d, j, lod, to);
  });
}

/// First texel of each lane's layer.
template <class D>
HWY_INLINE Ints<D> FirstTexel(D, const Texture& texture, const PointBlock& block, size_t i) {
  const hn::RebindToSigned<D> di;
  return texture.layers == 1 ? hn::Zero(di) : hn::Load(di, block.first_texel + i);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_POINTS_INL_H_
