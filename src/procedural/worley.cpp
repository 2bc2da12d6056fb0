// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/worley.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/lattice-inl.h"
#include "procedural/octaves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A feature point relative to the place, and the square of its distance.
template <class V>
struct Feature {
  V square, x, y, z;
};

template <class M, class V>
HWY_INLINE Feature<V> Choose(M mask, const Feature<V>& yes, const Feature<V>& no) {
  return {hn::IfThenElse(mask, yes.square, no.square), hn::IfThenElse(mask, yes.x, no.x),
          hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

/// The nearest and the second nearest feature point so far. Without gradients only their distances are kept.
template <class V>
struct Nearest {
  Feature<V> first, second;

  template <bool kGradient, class M>
  HWY_INLINE void Add(M lanes, const Feature<V>& found) {
    const auto is_first = hn::And(lanes, hn::Lt(found.square, first.square));
    const auto is_second = hn::And(lanes, hn::Lt(found.square, second.square));
    if constexpr (kGradient) {
      second = Choose(is_first, first, Choose(is_second, found, second));
      first = Choose(is_first, found, first);
    } else {
      const V rest = hn::IfThenElse(is_second, found.square, second.square);
      second.square = hn::IfThenElse(is_first, first.square, rest);
      first.square = hn::IfThenElse(is_first, found.square, first.square);
    }
  }
};

/// A place in its cell, and the hash of the cell before it is mixed.
template <class D>
struct CellPlace {
  Axis<D> x, y, z;
  hn::Vec<hn::RebindToUnsigned<D>> hash;
};

/// The feature point of the cell at an offset: each coordinate is a multiple of 2^-24 in [0, 1).
template <class D, class V = hn::Vec<D>>
HWY_INLINE Feature<V> FeatureOf(D d, const CellPlace<D>& place, int i, int j, int k) {
  const hn::RebindToUnsigned<D> du;
  const hn::RebindToSigned<D> di;
  const auto factor = [](int n, int axis) { return static_cast<uint32_t>(n) * kFactor[axis]; };
  const auto step = hn::Set(du, factor(i, 0) + factor(j, 1) + factor(k, 2));
  const auto hash = simd::HWY_NAMESPACE::MixBits(du, place.hash + step);
  const auto to = [&](int cell, uint32_t part, V at) {
    const auto bits = hn::ShiftRight<8>(hash * hn::Set(du, part));
    const V in_cell = hn::ConvertTo(d, hn::BitCast(di, bits)) * hn::Set(d, 0x1p-24f);
    return (in_cell - at) + hn::Set(d, static_cast<float>(cell));
  };
  const V x = to(i, 0x9e3779b9u, place.x.at), y = to(j, 0x85ebca6bu, place.y.at), z = to(k, 0xc2b2ae35u, place.z.at);
  return {x * x + y * y + z * z, x, y, z};
}

/// Adds the feature points of cells whose offsets are above `skipped` and up to `reach` in some coordinate.
template <bool kGradient, class D, class V>
HWY_INLINE void AddCells(D d, const CellPlace<D>& place, int skipped, int reach, hn::Mask<D> lanes, Nearest<V>* best) {
  const auto is_skipped = [&](int n) { return -skipped <= n && n <= skipped; };
  for (int k = -reach; k <= reach; ++k) {
    for (int j = -reach; j <= reach; ++j) {
      for (int i = -reach; i <= reach; ++i) {
        if (is_skipped(i) && is_skipped(j) && is_skipped(k)) continue;
        best->template Add<kGradient>(lanes, FeatureOf(d, place, i, j, k));
      }
    }
  }
}

/// One octave of the distances of Worley, "A Cellular Texture Basis Function" (1996), with one point in each cell.
struct WorleyNoise {
  shd_solid_distance distance;

  /// Distance to a feature point, and its gradient: the unit vector away from the point, 0 at the point itself.
  template <bool kGradient, class D, class V>
  static HWY_INLINE Sample<V> DistanceTo(D d, const Feature<V>& feature) {
    Sample<V> out;
    out.value = hn::Sqrt(feature.square);
    if constexpr (kGradient) {
      const auto is_apart = hn::Gt(out.value, hn::Zero(d));
      const V length = hn::IfThenElse(is_apart, out.value, hn::Set(d, 1.0f));
      out = {out.value, hn::Neg(feature.x / length), hn::Neg(feature.y / length), hn::Neg(feature.z / length)};
    }
    return out;
  }

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, V x, V y, V z, uint32_t seed) const {
    const hn::RebindToUnsigned<D> du;
    CellPlace<D> place = {SplitAxis(d, x), SplitAxis(d, y), SplitAxis(d, z), hn::Set(du, seed)};
    place.hash = HashEnds(du, place.x.cell, 0, place.hash).of[0];
    place.hash = HashEnds(du, place.y.cell, 1, place.hash).of[0];
    place.hash = HashEnds(du, place.z.cell, 2, place.hash).of[0];
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), far = hn::Set(d, 100.0f);
    Nearest<V> best = {{far, zero, zero, zero}, {far, zero, zero, zero}};
    const auto every_lane = hn::Eq(zero, zero);
    AddCells<kGradient>(d, place, -1, 1, every_lane, &best);
    // Points outside these 27 cells are farther away than the border of the cells. The second nearest point is at most
    // sqrt(3) away, and the border of 125 cells at least 2.
    const auto border = [&](V at) { return hn::Min(at, one - at); };
    const V to_border = one + hn::Min(border(place.x.at), hn::Min(border(place.y.at), border(place.z.at)));
    const bool needs_second = distance != SHD_SOLID_DISTANCE_F1;
    const auto unsure = hn::Gt(needs_second ? best.second.square : best.first.square, to_border * to_border);
    if (!hn::AllFalse(d, unsure)) AddCells<kGradient>(d, place, 1, 2, unsure, &best);
    if (distance == SHD_SOLID_DISTANCE_F1) return DistanceTo<kGradient>(d, best.first);
    Sample<V> out = DistanceTo<kGradient>(d, best.second);
    if (distance == SHD_SOLID_DISTANCE_F2) return out;
    const Sample<V> first = DistanceTo<kGradient>(d, best.first);
    out.value = out.value - first.value;
    if constexpr (kGradient) out = {out.value, out.dx - first.dx, out.dy - first.dy, out.dz - first.dz};
    return out;
  }
};

size_t Worley(const Solid& solid, const Places& places, const Values& out) {
  return EvaluateSum(solid, WorleyNoise{solid.distance}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Worley);

size_t evaluate_worley(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Worley, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
