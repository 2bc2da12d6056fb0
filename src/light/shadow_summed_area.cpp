// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/shadow_summed_area.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"
#include "light/shadow_sums.h"
#include "simd/double-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// A box along one axis: the table entries at its ends, and the fractions of texels between the entries and the ends.
template <class D, class V>
struct BoxSide {
  ShadowInts<D> entry[2];  // entry of the texel that contains each end
  V part[2];               // fraction of this texel before the end
  V length;

  HWY_INLINE BoxSide(D d, V centre, V half, float size) {
    const hn::RebindToSigned<D> di;
    const V end[2] = {Clamp(d, centre - half, 0.0f, size), Clamp(d, centre + half, 0.0f, size)};
    for (size_t k = 0; k < 2; ++k) {
      const V cell = hn::Min(RoundDown(end[k]), hn::Set(d, size - 1.0f));
      entry[k] = hn::ConvertTo(di, cell);
      part[k] = end[k] - cell;
    }
    length = end[1] - end[0];
  }
};

/// Sums of one moment over boxes. Differences of entries are exact.
template <class D>
struct BoxTable {
  using Real = hn::Rebind<double, D>;
  using R = hn::Vec<Real>;
  const double* sums;

  HWY_INLINE R entry(ShadowInts<D> index) const {
    const hn::Rebind<int64_t, D> wide;
    return hn::GatherIndex(Real(), sums, hn::PromoteTo(wide, index));
  }
  /// Sum between two positions, each given as a fraction of a texel after an entry.
  static HWY_INLINE R between(R start, R after_start, R end, R after_end, R start_part, R end_part) {
    const R whole = end - start;
    const R last = end_part * (after_end - end), first = start_part * (after_start - start);
    return whole + (last - first);
  }
  /// Sums of the table row that starts at `row`, between the ends of a box.
  HWY_INLINE R row(ShadowInts<D> row, const ShadowInts<D> (&column)[2], const R (&part)[2]) const {
    const hn::RebindToSigned<D> di;
    const auto next = hn::Set(di, 2);
    const auto start = row + column[0], end = row + column[1];
    return between(entry(start), entry(start + next), entry(end), entry(end + next), part[0], part[1]);
  }
};

/// Chebyshev's bound over a box whose side is a world length (Lauritzen, "Summed-Area Variance Shadow Maps", GPU
/// Gems 3, 2007).
void SampleSummedArea(const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  const ShadowMap& map = shadow.map;
  const SumScale scale = sum_scale(map.placement);
  using Narrow = hn::Rebind<float, hn::CappedTag<double, kMaxReceiverLanes / 2>>;
  ForEachReceiver<Narrow>(shadow, in, visibility, [&](auto d, const auto& at) {
    using D = decltype(d);
    using V = hn::Vec<D>;
    using Real = hn::Rebind<double, D>;
    using R = hn::Vec<Real>;
    const hn::RebindToSigned<D> di;
    const Real real;
    const auto size = static_cast<float>(map.size);
    const float max_half = size / static_cast<float>(kMaxRadiusPart);
    const V half = Clamp(d, hn::Set(d, 0.5f * shadow.options.filter_size) / at.texel, 0.5f, max_half);
    const BoxSide<D, V> across(d, at.x, half, size), along(d, at.y, half, size);
    const auto width = static_cast<int32_t>(2 * (map.size + 1));
    const auto face = at.face * hn::Set(di, width * static_cast<int32_t>(map.size + 1));
    const ShadowInts<D> column[2] = {hn::ShiftLeft<1>(across.entry[0]), hn::ShiftLeft<1>(across.entry[1])};
    const R part_x[2] = {hn::PromoteTo(real, across.part[0]), hn::PromoteTo(real, across.part[1])};
    const R part_y[2] = {hn::PromoteTo(real, along.part[0]), hn::PromoteTo(real, along.part[1])};
    const R area = hn::PromoteTo(real, across.length) * hn::PromoteTo(real, along.length);
    R moment[2];
    for (size_t k = 0; k < 2; ++k) {
      const BoxTable<D> table = {map.sums.data() + k};
      R row[4];
      for (size_t r = 0; r < 4; ++r) {
        const auto y = along.entry[r / 2] + hn::Set(di, static_cast<int32_t>(r % 2));
        row[r] = table.row(face + y * hn::Set(di, width), column, part_x);
      }
      moment[k] = BoxTable<D>::between(row[0], row[1], row[2], row[3], part_y[0], part_y[1]) / area;
    }
    const R spread = hn::Max(moment[1] - moment[0] * moment[0], hn::Zero(real));
    const R range = hn::Set(real, scale.range), middle = hn::Set(real, scale.middle);
    const V mean = hn::DemoteTo(d, middle + moment[0] * range);
    const V variance = hn::DemoteTo(d, spread * (range * range));
    const V z = hn::Min(at.z, hn::Set(d, map.placement.far));
    return Chebyshev(d, shadow.options, z, mean, variance);
  });
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::light {

HWY_EXPORT(SampleSummedArea);

void sample_summed_area_variance(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in,
                                 float* visibility) {
  SHD_DISPATCH(SampleSummedArea, simd)(shadow, in, visibility);
}

}  // namespace shd::light
#endif  // HWY_ONCE
