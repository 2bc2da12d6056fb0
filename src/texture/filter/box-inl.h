// SPDX-License-Identifier: MIT
// Boxes of summed-area lookups. Let P(x) be the integral of the texture from 0 to x along one axis. The integral of the
// wrapped texture from 0 to x is turns P(size) + sign P(m) for some m in 0..size, or P extended by the first or last
// texel.

#if defined(SHD_TEXTURE_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_BOX_INL_H_
#undef SHD_TEXTURE_BOX_INL_H_
#else
#define SHD_TEXTURE_BOX_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/math-inl.h"
#include "simd/round-inl.h"
#include "texture/domain/block.h"
#include "texture/domain/footprint-inl.h"
#include "texture/domain/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;

/// Maximum length of a box [texels]. It keeps numbers of whole texels and their sums exact in floats.
constexpr float kLongestBox = 0x1p22f;

/// Scale (lod_bias) and limits (lod_min, lod_max) of the sides of a box [texels].
struct BoxRange {
  float scale, low, high;
};

inline BoxRange box_range(const Sampler& sampler) {
  const hn::CappedTag<float, 1> d;
  const auto power = [&](float x) {
    return hn::GetLane(simd::HWY_NAMESPACE::Exp2(d, hn::Set(d, x < 22.0f ? x : 22.0f)));
  };
  return {power(sampler.lod_bias), power(sampler.lod_min), power(sampler.lod_max)};
}

/// The boxes of a block of lookups [texels]. Each lookup has `parts` boxes of size 2 half_u x 2 half_v. The centre of
/// box k = 0..parts - 1 is the point plus (2 k + 1 - parts) / (2 parts) (side_u, side_v).
struct BoxBlock : PointBlock {
  alignas(64) float parts[kBlock];
  alignas(64) float side_u[kBlock], side_v[kBlock];
  alignas(64) float half_u[kBlock], half_v[kBlock];
};

/// The boxes of one vector of lookups.
template <class D>
struct Boxes {
  hn::Vec<D> count;
  hn::Vec<D> side_u, side_v;
  hn::Vec<D> half_u, half_v;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE V HalfSide(D d, V side, const BoxRange& range) {
  const V bounded = hn::Min(hn::Max(side, hn::Set(d, range.low)), hn::Set(d, range.high));
  return hn::Set(d, 0.5f) * bounded;
}

template <class D>
HWY_INLINE Boxes<D> SquareBoxes(D d, hn::Vec<D> lod, const BoxRange& range) {
  const auto bounded = hn::Min(hn::Max(lod, hn::Set(d, -64.0f)), hn::Set(d, 64.0f));
  const auto side = simd::HWY_NAMESPACE::Exp2(d, bounded) * hn::Set(d, range.scale);
  const auto half = HalfSide(d, side, range);
  return {hn::Set(d, 1.0f), hn::Zero(d), hn::Zero(d), half, half};
}

/// Finds the boxes along the parallelogram of the derivatives. The number of boxes is the length of the longer side
/// divided by that of the shorter side (at least one texel), rounded up and at most `max_parts`.
template <class D>
SHD_KERNEL_PART Boxes<D> BoxesOf(D d, const Derivatives<D>& j, float width, float height, float max_parts,
                                 const BoxRange& range) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f), longest = hn::Set(d, kLongestBox);
  const auto texels = [&](V derivative, float size) {
    const V side = derivative * hn::Set(d, size) * hn::Set(d, range.scale);
    return hn::Min(hn::Max(side, hn::Neg(longest)), longest);
  };
  const V xu = texels(j.dudx, width), xv = texels(j.dvdx, height);
  const V yu = texels(j.dudy, width), yv = texels(j.dvdy, height);
  Boxes<D> b;
  if (max_parts < 2.0f) {
    b.count = one;
    b.side_u = b.side_v = hn::Zero(d);
    b.half_u = HalfSide(d, hn::Abs(xu) + hn::Abs(yu), range);
    b.half_v = HalfSide(d, hn::Abs(xv) + hn::Abs(yv), range);
    return b;
  }
  const V xx = xu * xu + xv * xv, yy = yu * yu + yv * yv;
  const auto along_x = hn::Ge(xx, yy);
  b.side_u = hn::IfThenElse(along_x, xu, yu);
  b.side_v = hn::IfThenElse(along_x, xv, yv);
  const V other_u = hn::IfThenElse(along_x, yu, xu), other_v = hn::IfThenElse(along_x, yv, xv);
  const V ratio = hn::Sqrt(hn::Max(xx, yy) / hn::Max(hn::Min(xx, yy), one));
  b.count = hn::Min(hn::Max(RoundUp(ratio), one), hn::Set(d, max_parts));
  b.half_u = HalfSide(d, hn::Abs(b.side_u) / b.count + hn::Abs(other_u), range);
  b.half_v = HalfSide(d, hn::Abs(b.side_v) / b.count + hn::Abs(other_v), range);
  return b;
}

/// One end of a box along one axis, which cuts a cell of the table.
template <class D>
struct BoxEnd {
  Ints<D> inner, outer;            // table entries on both sides of the cell; `inner` is nearer to the box's middle
  hn::Vec<D> weight, sign, turns;  // weight: part of the cell in the box; above 1 outside the texture
  hn::Vec<D> place;                // m
};

template <class D>
HWY_INLINE BoxEnd<D> FoldEnd(D d, shd_wrap wrap, hn::Vec<D> x, hn::Vec<D> size, bool upper) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  BoxEnd<D> e;
  e.place = x;
  e.turns = zero;
  auto mirrored = hn::Lt(one, zero);
  switch (wrap) {
    case SHD_WRAP_REPEAT:
      e.turns = RoundDown(x / size);
      e.place = x - e.turns * size;
      break;
    case SHD_WRAP_MIRROR: {
      const V period = size + size, periods = RoundDown(x / period);
      const V rest = x - periods * period;
      mirrored = hn::Gt(rest, size);
      e.place = hn::IfThenElse(mirrored, period - rest, rest);
      e.turns = periods + periods + hn::IfThenElseZero(mirrored, hn::Set(d, 2.0f));
      break;
    }
    case SHD_WRAP_MIRROR_ONCE:
      mirrored = hn::Lt(x, zero);
      e.place = hn::Abs(x);
      break;
    case SHD_WRAP_BORDER: e.place = hn::Min(hn::Max(x, zero), size); break;
    default: break;
  }
  const V cell = hn::Min(hn::Max(RoundDown(e.place), zero), size - one), next = cell + one;
  const auto below = upper ? hn::Not(mirrored) : mirrored;  // the box contains the lower part of the cell
  e.inner = hn::ConvertTo(di, hn::IfThenElse(below, cell, next));
  e.outer = hn::ConvertTo(di, hn::IfThenElse(below, next, cell));
  e.weight = hn::IfThenElse(below, e.place - cell, next - e.place);
  e.sign = hn::IfThenElse(mirrored, hn::Neg(one), one);
  return e;
}

/// One vector of boxes along one axis: the cells at both ends, and the extent between them.
struct BoxSpans {
  alignas(64) int32_t inner[2][kMaxLanes], outer[2][kMaxLanes];
  alignas(64) float weight[2][kMaxLanes], sign[2][kMaxLanes];
  alignas(64) float turns[kMaxLanes];    // whole textures between the ends
  alignas(64) float between[kMaxLanes];  // texels between the two cells; negative if both ends cut one cell
  alignas(64) float outside[kMaxLanes];  // texels of border colour

  double inside(size_t lane) const {
    return static_cast<double>(weight[0][lane]) + static_cast<double>(between[lane]) +
           static_cast<double>(weight[1][lane]);
  }
};

/// Wraps the box from x - half to x + half. Returns the lanes whose boxes do not wrap: their table
/// entries rise from end to end.
template <class D>
SHD_KERNEL_PART MaskOf<D> WrapBox(D d, shd_wrap wrap, hn::Vec<D> x, hn::Vec<D> half, hn::Vec<D> size, BoxSpans* out) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  if (wrap != SHD_WRAP_REPEAT && wrap != SHD_WRAP_MIRROR) {
    // Beyond this limit all texels are the same.
    const V reach = half + one, low = wrap == SHD_WRAP_MIRROR_ONCE ? reach + size : reach;
    x = hn::Min(hn::Max(x, hn::Neg(low)), reach + size);
  }
  const V first = x - half, last = x + half;
  const BoxEnd<D> a = FoldEnd(d, wrap, first, size, false), b = FoldEnd(d, wrap, last, size, true);
  const V turns = b.turns - a.turns;
  const V inner_a = a.sign * hn::ConvertTo(d, a.inner), inner_b = b.sign * hn::ConvertTo(d, b.inner);
  const V between = turns * size + inner_b - inner_a;
  V outside = zero;
  if (wrap == SHD_WRAP_BORDER) outside = a.place - first + (last - b.place);
  hn::Store(a.inner, hn::RebindToSigned<D>(), out->inner[0]);
  hn::Store(a.outer, hn::RebindToSigned<D>(), out->outer[0]);
  hn::Store(a.weight, d, out->weight[0]);
  hn::Store(a.sign, d, out->sign[0]);
  hn::Store(b.inner, hn::RebindToSigned<D>(), out->inner[1]);
  hn::Store(b.outer, hn::RebindToSigned<D>(), out->outer[1]);
  hn::Store(b.weight, d, out->weight[1]);
  hn::Store(b.sign, d, out->sign[1]);
  hn::Store(turns, d, out->turns);
  hn::Store(between, d, out->between);
  hn::Store(outside, d, out->outside);
  const auto upright = hn::Eq(a.sign + b.sign, hn::Set(d, 2.0f));
  return hn::And(upright, hn::And(hn::Eq(turns, zero), hn::Ge(between, zero)));
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BOX_INL_H_
