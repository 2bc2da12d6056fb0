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

/// The incomplete last vector of a block, filled with copies of the last lookup.
struct Tail {
  alignas(64) float reals[kPlaceColumns][kMaxLanes];
  alignas(64) uint32_t integers[kIntegerColumns][kMaxLanes];

  Lookups copy(const Lookups& from, size_t first) {
    const BatchTag d;
    const hn::RebindToUnsigned<BatchTag> du;
    const size_t count = from.count - first;
    Lookups in = from;
    for (size_t c = 0; c < kPlaneColumns; ++c) in.real(c) = fill(d, from.real(c), first, count, reals[c]);
    for (size_t c = kPlaneColumns; from.w && c < kPlaceColumns; ++c) {
      in.real(c) = fill(d, from.real(c), first, count, reals[c]);
    }
    for (size_t c = 0; c < kIntegerColumns; ++c) in.integer(c) = fill(du, from.integer(c), first, count, integers[c]);
    return in;
  }

 private:
  /// Whole vectors are stored, because a load of a vector waits for the stores of its parts.
  template <class D, class T>
  static HWY_INLINE const T* fill(D d, const T* from, size_t first, size_t count, T* to) {
    if (!from) return nullptr;
    hn::Store(LoadFirst(d, from + first, count), d, to);
    return to;
  }
};

/// Calls body(d, in, from, to) for every vector of a block. Its lookups are at `from` in the lookups `in`; `to` is the
/// place of its results.
template <class Body>
HWY_INLINE void ForEachVector(const Lookups& block, const Body& body) {
  const BatchTag d;
  const size_t lanes = hn::Lanes(d);
  Tail tail;
  // The whole vectors, then the incomplete one. Within each loop the columns are constants.
  for (size_t begin = 0, end = block.count / lanes * lanes; begin < block.count; begin = end, end = block.count) {
    if (begin == end) continue;
    const bool whole = begin == 0 && end >= lanes;
    const Lookups in = whole ? block : tail.copy(block, begin);
    for (size_t to = begin; to < end; to += lanes) body(d, in, to - (whole ? 0 : begin), to);
  }
}

/// Fills the columns of a PointBlock and calls body(d, points, to) for each vector, which writes its shape. Unless
/// kWidens is false, width and blur of the sampler are applied to the derivatives of `points`. Returns the number of
/// lookups that were not finite.
template <bool kWidens = true, class Body>
HWY_INLINE size_t FillBlock(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out,
                            const Body& body) {
  const bool widened = kWidens && !in.lod && widens(sampler);
  size_t nonfinite = 0;
  out->count = in.count;
  ForEachVector(WithAllColumns(in), [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    auto points = LoadPoints(d, from, i);
    if (HWY_UNLIKELY(!in.finite && !hn::AllTrue(d, points.finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(points.finite, hn::FirstN(d, in.count - to)));
    }
    hn::Store(ReduceCoordinate(d, sampler.wrap_u, points.u), d, out->u + to);
    hn::Store(ReduceCoordinate(d, sampler.wrap_v, points.v), d, out->v + to);
    if (texture.layers > 1) {
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

/// Finds nothing but the points.
inline HWY_NOINLINE size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in,
                                      PointBlock* out) {
  return FillBlock<false>(texture, sampler, in, out, [](auto, const auto&, size_t) {});
}

/// Returns a level of detail whose fraction is the share of the coarser level (shd_sampler_desc::level_blend).
template <class D, class V>
HWY_INLINE V BlendLevels(D d, const Sampler& sampler, V lod) {
  if (HWY_LIKELY(sampler.level_steepness == 1.0f)) return lod;
  const V half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
  if (sampler.level_steepness == 0.0f) return RoundUp(lod - half);
  const V floor = RoundDown(lod);
  const V share = (lod - floor - half) * hn::Set(d, sampler.level_steepness) + half;
  return floor + hn::Min(hn::Max(share, hn::Zero(d)), one);
}

/// Whether a column is absent or holds the bits of its first row in every row.
HWY_INLINE bool IsConstant(const float* column, size_t count) {
  if (!column) return true;
  const BatchTag d;
  const hn::RebindToUnsigned<BatchTag> du;
  const auto first = hn::BitCast(du, hn::Set(d, column[0]));
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const bool whole = count - i >= hn::Lanes(d);
    const auto bits = hn::BitCast(du, whole ? hn::LoadU(d, column + i) : LoadFirst(d, column + i, count - i));
    if (!hn::AllTrue(du, hn::Eq(bits, first))) return false;
  }
  return true;
}

/// Whether a column is absent or has the same value in its first and its last row.
HWY_INLINE bool EndsAlike(const float* column, size_t count) {
  return !column || column[0] == column[count - 1];
}

/// Whether all lookups have one footprint, as those of surfaces parallel to the picture.
inline HWY_NOINLINE bool ShareFootprint(const Lookups& in) {
  if (!EndsAlike(in.dudx, in.count) || !EndsAlike(in.dvdx, in.count) || !EndsAlike(in.dudy, in.count) ||
      !EndsAlike(in.dvdy, in.count)) {
    return false;
  }
  return IsConstant(in.dudx, in.count) && IsConstant(in.dvdx, in.count) && IsConstant(in.dudy, in.count) &&
         IsConstant(in.dvdy, in.count);
}

/// Whether ShareFootprint() holds and the footprint is finite.
HWY_INLINE bool ShareFiniteFootprint(const Lookups& in) {
  if (in.one_footprint) return true;
  const auto is_finite = [](const float* column) { return !column || *column - *column == 0.0f; };
  return is_finite(in.dudx) && is_finite(in.dvdx) && is_finite(in.dudy) && is_finite(in.dvdy) && ShareFootprint(in);
}

/// Fills a block of lookups that all have one level of detail, as FillBlock() does.
template <class V>
HWY_INLINE size_t FillOneLod(const Texture& texture, const Sampler& sampler, const Lookups& in, V lod, LodBlock* out) {
  size_t nonfinite = 0;
  out->count = in.count;
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    auto u = hn::LoadU(d, from.u + i), v = hn::LoadU(d, from.v + i);
    const auto finite = hn::Eq((u - u) + (v - v), hn::Zero(d));
    if (HWY_UNLIKELY(!in.finite && !hn::AllTrue(d, finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(finite, hn::FirstN(d, in.count - to)));
      u = FiniteOrZero(d, u);
      v = FiniteOrZero(d, v);
    }
    hn::Store(ReduceCoordinate(d, sampler.wrap_u, u), d, out->u + to);
    hn::Store(ReduceCoordinate(d, sampler.wrap_v, v), d, out->v + to);
    hn::Store(lod, d, out->lod + to);
    if (texture.layers > 1) {
      hn::Store(LoadFirstTexel(d, texture, from, i), hn::RebindToSigned<decltype(d)>(), out->first_texel + to);
    }
  });
  return nonfinite;
}

/// Finds the levels of detail of isotropic lookups according to the sampler's profile. They are clamped to `query` and
/// not rounded; if it is null, they are clamped to lod_range() and rounded as the filter needs them.
inline HWY_NOINLINE size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, LodBlock* out,
                                      const LodRange* query = nullptr) {
  const LodRounding rounding = query ? LodRounding::kNone : LodRounding::kFilter;
  const LodRange range = query ? *query : lod_range(texture, sampler);
  if (uses_profile(sampler, rounding)) return FindProfiledLods(texture, sampler, range, rounding, in, out);
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const bool lod_given = in.lod != nullptr;
  const bool rms = sampler.profile == SHD_PROFILE_LEAST_ERROR;
  const float shift = level_shift(sampler, lod_given);
  const auto square_of = [&](auto d, const auto& p) SHD_INLINE_LAMBDA {
    return rms ? MeanSquareOf(d, p.derivatives, width, height) : SquareOf(d, p.derivatives, width, height);
  };
  const auto lod_of = [&](auto d, auto lambda) SHD_INLINE_LAMBDA {
    const auto lod = ClampLod(d, lambda, shift, range);
    return query ? lod : BlendLevels(d, sampler, lod);
  };
  if (!lod_given && in.count > kMaxLanes && ShareFiniteFootprint(in)) {
    const BatchTag d;
    auto first = LoadPoints(d, WithAllColumns(in), 0);
    if (HWY_UNLIKELY(widens(sampler))) Widen(d, sampler, &first.derivatives);
    return FillOneLod(texture, sampler, in, lod_of(d, HalfLog2(d, square_of(d, first))), out);
  }
  const size_t nonfinite =
      FillBlock(texture, sampler, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
        hn::Store(lod_given ? p.lod : square_of(d, p), d, out->lod + to);
      });
  // A loop of its own: its chains of operations are short, so that more vectors overlap.
  const BatchTag d;
  for (size_t i = 0; i < in.count; i += hn::Lanes(d)) {
    const auto value = hn::Load(d, out->lod + i);
    hn::Store(lod_of(d, lod_given ? value : HalfLog2(d, value)), d, out->lod + i);
  }
  return nonfinite;
}

/// Divides by a size of a texture. The reciprocal of a power of two is exact, so that a product has the same bits.
struct SizeDivision {
  float size, reciprocal;
  bool exact;

  explicit SizeDivision(uint32_t of_size)
      : size(static_cast<float>(of_size)), reciprocal(1.0f / size), exact((of_size & (of_size - 1)) == 0) {}

  template <class D, class V>
  HWY_INLINE V operator()(D d, V length) const {
    if (HWY_LIKELY(exact)) return length * hn::Set(d, reciprocal);
    return length / hn::Set(d, size);
  }
};

/// Returns log2 of the size of one of the 1 / share equal parts of a footprint: the longer axis of the part, or the
/// root mean square of both axes of the part for SHD_PROFILE_LEAST_ERROR. Both are the shorter axis of the
/// footprint unless max_anisotropy limits the number of parts. SHD_PROFILE_LEAST_ERROR takes back kCoarser (1 - share)
/// of kFiner. Circles have the bits of trilinear.
template <class D, class V>
HWY_INLINE V LambdaOfPart(D d, V lambda, V roundness, V share, V ratio, bool rms) {
  if (!rms) return lambda - simd::HWY_NAMESPACE::NormalLog2(d, ratio);
  const V one = hn::Set(d, 1.0f), other = roundness * ratio;  // shorter axis of the part, divided by the longer one
  const V squares = ratio * ratio * hn::Set(d, 2.0f) / (one + other * other);
  const V part = lambda - hn::Set(d, 0.5f) * simd::HWY_NAMESPACE::NormalLog2(d, squares);
  return part + hn::Set(d, kCoarser) * (one - share);
}

/// Places probes on a footprint (FindShapes() of a ProbeBlock).
struct ProbePlacement {
  const Sampler& sampler;
  LodRange range;
  float shift, min_share;
  bool lod_given, rms, blends_all;
  SizeDivision width, height;

  ProbePlacement(const Texture& texture, const Sampler& of_sampler, const LodRange& of_range, bool of_lod, bool query)
      : sampler(of_sampler),
        range(of_range),
        shift(level_shift(sampler, of_lod)),
        min_share(1.0f / sampler.max_anisotropy),
        lod_given(of_lod),
        rms(sampler.profile == SHD_PROFILE_LEAST_ERROR),
        blends_all(query || sampler.level_steepness == 1.0f),
        width(texture.width),
        height(texture.height) {}

  template <class D>
  SHD_KERNEL_PART void place(D d, const FootprintAxes<D>& f, ProbeBlock* out, size_t to) const {
    const auto one = hn::Set(d, 1.0f), limit = hn::Set(d, 0x1p60f);
    const auto share = hn::Max(f.roundness, hn::Set(d, min_share));
    const auto ratio = one / share;
    const auto lambda = lod_given ? f.levels : LambdaOfAxes(d, f.square, f.levels);
    const auto lod = ClampLod(d, LambdaOfPart(d, lambda, f.roundness, share, ratio, rms), shift, range);
    auto blended = lod, widths = ratio;
    if (HWY_UNLIKELY(!blends_all)) {
      blended = BlendLevels(d, sampler, lod);
      widths = ratio * simd::HWY_NAMESPACE::ExpSeries(d, lod - blended);  // Exp2() of at most 1/2
    }
    const auto probes = hn::Max(RoundUp(widths - hn::Set(d, sampler.probe_slack)), one);
    const auto half_step = f.length / (probes + probes);
    const auto step_u = width(d, half_step * f.u), step_v = height(d, half_step * f.v);
    hn::Store(hn::Max(hn::Min(step_u, limit), hn::Neg(limit)), d, out->step_u + to);
    hn::Store(hn::Max(hn::Min(step_v, limit), hn::Neg(limit)), d, out->step_v + to);
    hn::Store(probes, d, out->probes + to);
    hn::Store(probes, d, out->reach + to);
    hn::Store(blended, d, out->lod + to);
  }
};

/// Finds probes along the longer axis, on the level of the shorter axis, according to the sampler's profile (McCormack,
/// Perry, Farkas and Jouppi, "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping", 1999). More than one
/// probe per width of the shorter axis is slower and gains at most 0.6 dB on a receding floor (2048^2 checkerboard).
/// Probes up to the ends of the footprint, instead of half a width before them, cost 5 dB. Where the levels are not
/// blended (shd_sampler_desc::level_blend), a probe is as wide as a texel of its level. `query`: as above.
inline HWY_NOINLINE size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in,
                                      ProbeBlock* out, const LodRange* query = nullptr) {
  const LodRounding rounding = query ? LodRounding::kNone : LodRounding::kFilter;
  const LodRange range = query ? *query : lod_range(texture, sampler);
  if (uses_profile(sampler, rounding)) return FindProfiledProbes(texture, sampler, range, rounding, in, out);
  // The operations of one lookup form a long chain. Two passes let those of more vectors overlap: 1.05 of the speed of
  // anisotropic lookups on SSE4, 1.0 on AVX2 and 0.96 on AVX-512, where divisions limit the speed.
  constexpr bool kTwoPasses = hn::MaxLanes(BatchTag()) <= 4;
  const ProbePlacement placement(texture, sampler, range, in.lod != nullptr, query != nullptr);
  const float width = placement.width.size, height = placement.height.size;
  alignas(64) float lengths[kTwoPasses ? kBlock : 1];
  const size_t nonfinite =
      FillBlock(texture, sampler, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
        const auto f = placement.lod_given ? RoundAxes(d, p.lod) : AxesOf(d, p.derivatives, width, height);
        if (!kTwoPasses) return placement.place(d, f, out, to);
        hn::Store(f.square, d, out->lod + to);
        hn::Store(f.levels, d, out->reach + to);
        hn::Store(f.length, d, lengths + to);
        hn::Store(f.roundness, d, out->probes + to);
        hn::Store(f.u, d, out->step_u + to);
        hn::Store(f.v, d, out->step_v + to);
      });
  const BatchTag d;
  for (size_t i = 0; kTwoPasses && i < in.count; i += hn::Lanes(d)) {
    const auto load = [&](const float* column) SHD_INLINE_LAMBDA { return hn::Load(d, column + i); };
    placement.place(d,
                    FootprintAxes<BatchTag>{load(out->lod), load(out->reach), load(lengths), load(out->probes),
                                            load(out->step_u), load(out->step_v)},
                    out, i);
  }
  return nonfinite;
}

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
