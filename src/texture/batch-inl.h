// SPDX-License-Identifier: MIT
// The loop over a batch, the same for every filter: whole vectors in place, the tail through a padded copy.

#if defined(SHD_TEXTURE_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_BATCH_INL_H_
#undef SHD_TEXTURE_BATCH_INL_H_
#else
#define SHD_TEXTURE_BATCH_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "texture/footprint-inl.h"
#include "texture/random-inl.h"
#include "texture/texture.h"
#include "texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t kMaxLanes = 16;
using BatchTag = hn::CappedTag<float, kMaxLanes>;

/// One vector of lookups, made finite: NaN and infinite coordinates and NaN derivatives are 0.
template <class D>
struct Points {
  hn::Vec<D> u, v;
  Derivatives<D> derivatives;  // of what is absent: 0
  hn::Vec<D> lod;              // not NaN
  Ints<D> first_texel;         // of the lane's layer
  Bits<D> random;              // the lane's own bits, before the seed
  size_t nonfinite;            // lanes where something was not finite
};

template <class D>
HWY_INLINE hn::Vec<D> LoadOrZero(D d, const float* column, size_t i) {
  return column ? hn::LoadU(d, column + i) : hn::Zero(d);
}

template <class D, class V>
HWY_INLINE V ZeroIfNotFinite(D d, V value) {
  return hn::IfThenElseZero(hn::Eq(hn::Sub(value, value), hn::Zero(d)), value);
}
template <class V>
HWY_INLINE V ZeroIfNaN(V value) {
  return hn::IfThenElseZero(hn::Eq(value, value), value);
}

/// First texel of each lane's layer; the last layer for those beyond.
template <class D>
HWY_INLINE Ints<D> LoadFirstTexel(D, const Texture& texture, const Lookups& in, size_t i) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  if (!in.layer || texture.layers == 1) return hn::Zero(di);
  const auto layer = hn::Min(hn::LoadU(du, in.layer + i), hn::Set(du, texture.layers - 1));
  return hn::Mul(hn::BitCast(di, layer), hn::Set(di, static_cast<int32_t>(texture.layer_texels)));
}

template <class D>
SHD_KERNEL_PART Points<D> LoadPoints(D d, const Texture& texture, const Lookups& in, size_t i) {
  Points<D> p;
  p.first_texel = LoadFirstTexel(d, texture, in, i);
  p.u = hn::LoadU(d, in.u + i);
  p.v = hn::LoadU(d, in.v + i);
  p.lod = LoadOrZero(d, in.lod, i);
  Derivatives<D>& j = p.derivatives;
  j.dudx = LoadOrZero(d, in.lod ? nullptr : in.dudx, i);
  j.dvdx = LoadOrZero(d, in.lod ? nullptr : in.dvdx, i);
  j.dudy = LoadOrZero(d, in.lod ? nullptr : in.dudy, i);
  j.dvdy = LoadOrZero(d, in.lod ? nullptr : in.dvdy, i);
  // x - x is 0 for finite x and NaN for others.
  const auto point = hn::Add(hn::Sub(p.u, p.u), hn::Sub(p.v, p.v));
  const auto along_x = hn::Add(hn::Sub(j.dudx, j.dudx), hn::Sub(j.dvdx, j.dvdx));
  const auto along_y = hn::Add(hn::Sub(j.dudy, j.dudy), hn::Sub(j.dvdy, j.dvdy));
  const auto all = hn::Add(hn::Add(point, hn::Sub(p.lod, p.lod)), hn::Add(along_x, along_y));
  const auto finite = hn::Eq(all, hn::Zero(d));
  p.nonfinite = 0;
  if (HWY_UNLIKELY(!hn::AllTrue(d, finite))) {
    p.nonfinite = hn::Lanes(d) - hn::CountTrue(d, finite);
    p.u = ZeroIfNotFinite(d, p.u);
    p.v = ZeroIfNotFinite(d, p.v);
    p.lod = ZeroIfNaN(p.lod);
    j.dudx = ZeroIfNaN(j.dudx);
    j.dvdx = ZeroIfNaN(j.dvdx);
    j.dudy = ZeroIfNaN(j.dudy);
    j.dvdy = ZeroIfNaN(j.dvdy);
  }
  p.random = in.random ? hn::LoadU(hn::RebindToUnsigned<D>(), in.random + i) : BitsOfPoint(d, p.u, p.v);
  return p;
}

/// The last `count` < Lanes lookups of a batch in columns of whole vectors, padded with zeros.
struct Tail {
  alignas(64) float in_columns[kFloatColumns][kMaxLanes];
  alignas(64) uint32_t in_integers[kIntegerColumns][kMaxLanes];
  alignas(64) float out_columns[kOutputColumns][kMaxLanes];
  Lookups in;
  Texels out;

  void copy_in(const Lookups& from, const Texels& to, size_t first) {
    const size_t count = from.count - first;
    std::memset(in_columns, 0, sizeof in_columns);
    std::memset(in_integers, 0, sizeof in_integers);
    const float* columns[] = {from.u, from.v, from.dudx, from.dvdx, from.dudy, from.dvdy, from.lod};
    for (size_t c = 0; c < kFloatColumns; ++c) {
      if (!columns[c]) continue;
      std::memcpy(in_columns[c], columns[c] + first, count * sizeof(float));
      columns[c] = in_columns[c];
    }
    const uint32_t* integers[] = {from.layer, from.random};
    for (size_t c = 0; c < kIntegerColumns; ++c) {
      if (!integers[c]) continue;
      std::memcpy(in_integers[c], integers[c] + first, count * sizeof(uint32_t));
      integers[c] = in_integers[c];
    }
    in = {count,      columns[0], columns[1], columns[2],  columns[3],
          columns[4], columns[5], columns[6], integers[0], integers[1]};
    for (size_t c = 0; c < kOutputColumns; ++c) out.column(c) = to.column(c) ? out_columns[c] : nullptr;
  }
  void copy_out(const Texels& to, size_t first) const {
    for (size_t c = 0; c < kOutputColumns; ++c) {
      if (to.column(c)) std::memcpy(to.column(c) + first, out_columns[c], in.count * sizeof(float));
    }
  }
};

/// filter(d, points, out, i) writes one vector of results to element i of the columns. Returns the number of
/// lookups that were not finite.
template <class D = BatchTag, class Filter>
HWY_NOINLINE size_t ForEachVector(const Texture& texture, const Filter& filter, const Lookups& in, const Texels& out) {
  const D d;
  const size_t lanes = hn::Lanes(d);
  const size_t whole = in.count - in.count % lanes;
  Tail tail;
  const Lookups* from = &in;
  const Texels* to = &out;
  size_t nonfinite = 0;
  const bool widened = !in.lod && widens(filter.sampler);
  // One call for vectors and tail, as it is inlined.
  for (size_t i = 0;; i += lanes) {
    if (i >= whole && from == &in) {
      if (whole == in.count) return nonfinite;
      tail.copy_in(in, out, whole);
      from = &tail.in;
      to = &tail.out;
      i = 0;
    } else if (from != &in) {
      tail.copy_out(out, whole);
      return nonfinite;
    }
    Points<D> points = LoadPoints(d, texture, *from, i);
    nonfinite += points.nonfinite;
    if (HWY_UNLIKELY(widened)) Widen(d, filter.sampler, &points.derivatives);
    filter(d, points, *to, i);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BATCH_INL_H_
