// SPDX-License-Identifier: MIT
// Kernels that fill blocks: the points of lookups and their shapes. FindShapes() is overloaded for each block. Each
// overload returns the number of lookups with an input that is not finite.

#if defined(SHD_TEXTURE_SHAPES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_SHAPES_INL_H_
#undef SHD_TEXTURE_SHAPES_INL_H_
#else
#define SHD_TEXTURE_SHAPES_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/finite-inl.h"
#include "simd/round-inl.h"
#include "simd/tail-inl.h"
#include "texture/domain/block.h"
#include "texture/domain/footprint-inl.h"
#include "texture/domain/profile.h"
#include "texture/domain/wrap-inl.h"
#include "texture/lanes-inl.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::FiniteOrZero;
using simd::HWY_NAMESPACE::LoadFirst;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;
using simd::HWY_NAMESPACE::ZeroIfNaN;

/// One vector of lookups. NaN and infinite coordinates, NaN derivatives and NaN levels of detail are replaced by 0.
template <class D>
struct Points {
  hn::Vec<D> u, v;
  Derivatives<D> derivatives;  // 0 if the lookups have no derivatives
  hn::Vec<D> lod;              // 0 if the lookups have no level of detail
  MaskOf<D> finite;            // lanes whose inputs were all finite
};

template <class D>
HWY_INLINE hn::Vec<D> LoadOrZero(D d, const float* column, size_t i) {
  return column ? hn::LoadU(d, column + i) : hn::Zero(d);
}

/// Returns the first texel of the layer of each lane. Layers beyond the last one are clamped to it.
template <class D>
HWY_INLINE Ints<D> LoadFirstTexel(D, const Texture& texture, const Lookups& in, size_t i) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  if (!in.layer) return hn::Zero(di);
  const auto layer = hn::Min(hn::LoadU(du, in.layer + i), hn::Set(du, texture.layers - 1));
  return hn::BitCast(di, layer) * hn::Set(di, static_cast<int32_t>(texture.layout.layer_units));
}

/// Returns lookups of a block with every column that LoadPoints() reads. A level of detail replaces the derivatives.
HWY_INLINE Lookups WithAllColumns(const Lookups& in) {
  Lookups all = in;
  const bool j = !in.lod;
  all.lod = in.lod ? in.lod : kNoColumn;
  all.dudx = j && in.dudx ? in.dudx : kNoColumn;
  all.dvdx = j && in.dvdx ? in.dvdx : kNoColumn;
  all.dudy = j && in.dudy ? in.dudy : kNoColumn;
  all.dvdy = j && in.dvdy ? in.dvdy : kNoColumn;
  return all;
}

/// Replaces NaN and infinite coordinates by 0. Callers pass a copy: a pointer to the points of a loop would keep these
/// in memory.
template <class D>
HWY_NOINLINE void MakeUsable(D d, Points<D>* p) {
  Derivatives<D>& j = p->derivatives;
  p->u = FiniteOrZero(d, p->u);
  p->v = FiniteOrZero(d, p->v);
  p->lod = ZeroIfNaN(p->lod);
  j.dudx = ZeroIfNaN(j.dudx);
  j.dvdx = ZeroIfNaN(j.dvdx);
  j.dudy = ZeroIfNaN(j.dudy);
  j.dvdy = ZeroIfNaN(j.dvdy);
}

/// Loads a vector of lookups that have all columns.
template <class D>
SHD_KERNEL_PART Points<D> LoadPoints(D d, const Lookups& in, size_t i) {
  Points<D> p;
  p.u = hn::LoadU(d, in.u + i);
  p.v = hn::LoadU(d, in.v + i);
  p.lod = hn::LoadU(d, in.lod + i);
  Derivatives<D>& j = p.derivatives;
  j.dudx = hn::LoadU(d, in.dudx + i);
  j.dvdx = hn::LoadU(d, in.dvdx + i);
  j.dudy = hn::LoadU(d, in.dudy + i);
  j.dvdy = hn::LoadU(d, in.dvdy + i);
  if (HWY_LIKELY(in.finite)) {
    p.finite = hn::Eq(hn::Zero(d), hn::Zero(d));
    return p;
  }
  // x - x is 0 for finite x and NaN for others.
  const auto point = (p.u - p.u) + (p.v - p.v);
  const auto along_x = (j.dudx - j.dudx) + (j.dvdx - j.dvdx);
  const auto along_y = (j.dudy - j.dudy) + (j.dvdy - j.dvdy);
  p.finite = hn::Eq((point + (p.lod - p.lod)) + (along_x + along_y), hn::Zero(d));
  if (HWY_UNLIKELY(!hn::AllTrue(d, p.finite))) {
    Points<D> usable = p;
    MakeUsable(d, &usable);
    return usable;
  }
  return p;
}

/// The incomplete last vector of a block, filled up with copies of the last lookup.
struct Tail {
  alignas(64) float reals[kPlaceColumns][kMaxLanes];
  alignas(64) uint32_t integers[kIntegerColumns][kMaxLanes];

  /// Copies the lookups from `first` on, which are less than a vector. Columns of floats that are absent become 0.
  void copy(const Lookups& block, size_t first);

  /// Returns the lookups of a block, with the copies as their columns. Derivatives that the block lacks are columns of
  /// 0; other columns that it lacks are absent.
  HWY_INLINE Lookups columns_of(const Lookups& block) const {
    Lookups in = block;
    in.u = reals[0], in.v = reals[1];
    in.dudx = reals[2], in.dvdx = reals[3], in.dudy = reals[4], in.dvdy = reals[5];
    if (block.lod) in.lod = reals[6];
    if (HWY_UNLIKELY(block.w != nullptr)) in.w = reals[7], in.dwdx = reals[8], in.dwdy = reals[9];
    if (block.layer) in.layer = integers[0];
    if (block.random) in.random = integers[1];
    return in;
  }
};

/// Calls body(d, in, from, to) for every vector of a block. Its lookups are at `from` in the lookups `in`; `to` is the
/// place of its results. complete(lookups) returns the lookups `in` for those of the block, or for copies of them.
template <class Complete, class Body>
HWY_INLINE void ForEachVector(const Lookups& block, const Complete& complete, const Body& body) {
  const BatchTag d;
  const size_t lanes = hn::Lanes(d), whole = block.count / lanes * lanes;
  Tail tail;
  Lookups in = complete(block);
  // One pass over the whole vectors, then one over the incomplete one. Within each, the columns are constants.
  for (size_t to = 0, first = 0; to < block.count;) {
    const bool last = to == whole;
    if (last) {
      first = whole;
      tail.copy(block, first);
      in = complete(tail.columns_of(block));
    }
    for (const size_t end = last ? block.count : whole; to < end; to += lanes) body(d, in, to - first, to);
  }
}
template <class Body>
HWY_INLINE void ForEachVector(const Lookups& block, const Body& body) {
  ForEachVector(
      block, [](const Lookups& in) SHD_INLINE_LAMBDA { return in; }, body);
}

/// Fills the columns of a PointBlock and calls body(d, points, to) for each vector, which writes its shape. Unless
/// kWidens is false, width and blur of the sampler are applied to the derivatives of `points`. Returns the number of
/// lookups that were not finite.
template <bool kWidens = true, class Body>
HWY_INLINE size_t FillBlock(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out,
                            const Body& body) {
  const bool widened = kWidens && !in.lod && widens(sampler), layered = texture.layers > 1;
  const shd_wrap wrap_u = sampler.wrap_u, wrap_v = sampler.wrap_v;
  size_t nonfinite = 0;
  out->count = in.count;
  ForEachVector(in, WithAllColumns, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    auto points = LoadPoints(d, from, i);
    if (HWY_UNLIKELY(!in.finite && !hn::AllTrue(d, points.finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(points.finite, hn::FirstN(d, in.count - to)));
    }
    hn::Store(ReduceCoordinate(d, wrap_u, points.u), d, out->u + to);
    hn::Store(ReduceCoordinate(d, wrap_v, points.v), d, out->v + to);
    if (layered) {
      hn::Store(LoadFirstTexel(d, texture, from, i), hn::RebindToSigned<decltype(d)>(), out->first_texel + to);
    }
    if (HWY_UNLIKELY(widened)) {
      auto wide = points.derivatives;
      Widen(d, sampler, &wide);
      points.derivatives = wide;
    }
    body(d, points, to);
  });
  return nonfinite;
}

/// Find levels of detail and probes for the profiles of other texture units.
size_t FindProfiledLods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                        const Lookups& in, LodBlock* out);
size_t FindProfiledProbes(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                          const Lookups& in, ProbeBlock* out);

/// Finds nothing but the points. This overload and the next two are in shapes.cpp.
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out);

/// Finds the levels of detail of isotropic lookups according to the sampler's profile. They are clamped to `query` and
/// not rounded; if it is null, they are clamped to lod_range() and rounded as the filter needs them.
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, LodBlock* out,
                  const LodRange* query = nullptr);

/// Finds probes along the longer axis, on the level of the shorter axis, according to the sampler's profile (McCormack,
/// Perry, Farkas and Jouppi, "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping", 1999). More than one
/// probe per width of the shorter axis is slower and gains at most 0.6 dB on a receding floor (2048^2 checkerboard).
/// Probes up to the ends of the footprint, instead of half a width before them, cost 5 dB. Where the levels are not
/// blended (shd_sampler_desc::level_blend), a probe is as wide as a texel of its level. `query`: as above.
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, ProbeBlock* out,
                  const LodRange* query = nullptr);

/// Finds ellipses; in ellipses.cpp.
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, EllipseBlock* out);

/// Returns the first texel of the layer of each lane.
template <class D>
HWY_INLINE Ints<D> FirstTexel(D, const Texture& texture, const PointBlock& block, size_t i) {
  const hn::RebindToSigned<D> di;
  return texture.layers == 1 ? hn::Zero(di) : hn::Load(di, block.first_texel + i);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SHAPES_INL_H_
