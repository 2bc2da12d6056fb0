// SPDX-License-Identifier: MIT
// The points, the levels of detail and the probes of lookups.
#include "texture/domain/block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/shapes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/domain/places-inl.h"
#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

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
HWY_NOINLINE bool ShareFootprint(const Lookups& in) {
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

}  // namespace

void Tail::copy(const Lookups& block, size_t first) {
  const BatchTag d;
  const hn::RebindToUnsigned<BatchTag> du;
  const size_t count = block.count - first;
  // Whole vectors are stored, because a load of a vector waits for the stores of its parts.
  const auto fill = [&](const auto& load) SHD_INLINE_LAMBDA {
    const auto fill_real = [&](size_t c) SHD_INLINE_LAMBDA {
      const float* column = block.real(c);
      hn::Store(column ? load(d, column + first) : hn::Zero(d), d, reals[c]);
    };
    for (size_t c = 0; c < kPlaneColumns; ++c) fill_real(c);
    for (size_t c = kPlaneColumns; block.w && c < kPlaceColumns; ++c) fill_real(c);
    for (size_t c = 0; c < kIntegerColumns; ++c) {
      if (const uint32_t* column = block.integer(c)) hn::Store(load(du, column + first), du, integers[c]);
    }
  };
  if (HWY_LIKELY(count == 1))
    return fill([](auto tag, const auto* from) SHD_INLINE_LAMBDA { return hn::Set(tag, *from); });
  fill([count](auto tag, const auto* from) SHD_INLINE_LAMBDA { return LoadFirst(tag, from, count); });
}

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out) {
  return FillBlock<false>(texture, sampler, in, out, [](auto, const auto&, size_t) {});
}

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, LodBlock* out,
                  const LodRange* query) {
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

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, ProbeBlock* out,
                  const LodRange* query) {
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

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PlaceBlock* out) {
  return FillPlaces(texture, sampler, in, out, out->w, [](auto, const auto&, size_t) {});
}

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PlaceLodBlock* out,
                  const LodRange* query) {
  const LodRange range = query ? *query : lod_range(texture, sampler);
  const bool lod_given = in.lod != nullptr, rms = sampler.profile == SHD_PROFILE_LEAST_ERROR;
  const float shift = level_shift(sampler, lod_given);
  return FillPlaces(texture, sampler, in, out, out->w, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    const auto lod = ClampLod(d, lod_given ? p.lod : LambdaOfPlaces(d, p, rms), shift, range);
    hn::Store(query ? lod : BlendLevels(d, sampler, lod), d, out->lod + to);
  });
}

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PlaceProbeBlock* out,
                  const LodRange* query) {
  const LodRange range = query ? *query : lod_range(texture, sampler);
  const ProbePlacement placement(texture, sampler, range, in.lod != nullptr, query != nullptr);
  const SizeDivision depth(texture.depth);
  return FillPlaces(texture, sampler, in, out, out->w, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    const auto f = placement.lod_given ? RoundPlaceAxes(d, p.lod) : AxesOfPlaces(d, p);
    placement.place(d, f, out, to);
    const auto probes = hn::Load(d, out->probes + to), limit = hn::Set(d, 0x1p60f);
    const auto step = depth(d, f.length / (probes + probes) * f.w);
    hn::Store(hn::Max(hn::Min(step, limit), hn::Neg(limit)), d, out->step_w + to);
  });
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
