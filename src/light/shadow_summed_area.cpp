// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/shadow_summed_area.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"
#include "light/shadow_sums.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A box along one axis: the table entries at its ends, and the parts of texels between the entries and the ends.
template <class D, class V>
struct BoxSide {
  ShadowInts<D> entry[2];  // of the texels that contain the ends
  V part[2];               // of these texels before the ends
  V length;

  HWY_INLINE BoxSide(D d, V centre, V half, float size) {
    const hn::RebindToSigned<D> di;
    const V end[2] = {Clamp(d, hn::Sub(centre, half), 0.0f, size), Clamp(d, hn::Add(centre, half), 0.0f, size)};
    for (size_t k = 0; k < 2; ++k) {
      const V cell = hn::Min(hn::Floor(end[k]), hn::Set(d, size - 1.0f));
      entry[k] = hn::ConvertTo(di, cell);
      part[k] = hn::Sub(end[k], cell);
    }
    length = hn::Sub(end[1], end[0]);
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
  /// Sum from a start to an end, each a part of a texel after an entry.
  static HWY_INLINE R between(R start, R after_start, R end, R after_end, R start_part, R end_part) {
    const R whole = hn::Sub(end, start);
    const R last = hn::Mul(end_part, hn::Sub(after_end, end)), first = hn::Mul(start_part, hn::Sub(after_start, start));
    return hn::Add(whole, hn::Sub(last, first));
  }
  /// Sums of a row of the table that starts at `row`, between the ends of a box.
  HWY_INLINE R row(ShadowInts<D> row, const ShadowInts<D> (&column)[2], const R (&part)[2]) const {
    const hn::RebindToSigned<D> di;
    const auto next = hn::Set(di, 2);
    const auto start = hn::Add(row, column[0]), end = hn::Add(row, column[1]);
    return between(entry(start), entry(hn::Add(start, next)), entry(end), entry(hn::Add(end, next)), part[0], part[1]);
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
    const V half = Clamp(d, hn::Div(hn::Set(d, 0.5f * shadow.options.filter_size), at.texel), 0.5f, max_half);
    const BoxSide<D, V> across(d, at.x, half, size), along(d, at.y, half, size);
    const auto width = static_cast<int32_t>(2 * (map.size + 1));
    const auto face = hn::Mul(at.face, hn::Set(di, width * static_cast<int32_t>(map.size + 1)));
    const ShadowInts<D> column[2] = {hn::ShiftLeft<1>(across.entry[0]), hn::ShiftLeft<1>(across.entry[1])};
    const R part_x[2] = {hn::PromoteTo(real, across.part[0]), hn::PromoteTo(real, across.part[1])};
    const R part_y[2] = {hn::PromoteTo(real, along.part[0]), hn::PromoteTo(real, along.part[1])};
    const R area = hn::Mul(hn::PromoteTo(real, across.length), hn::PromoteTo(real, along.length));
    R moment[2];
    for (size_t k = 0; k < 2; ++k) {
      const BoxTable<D> table = {map.sums.data() + k};
      R row[4];
      for (size_t r = 0; r < 4; ++r) {
        const auto y = hn::Add(along.entry[r / 2], hn::Set(di, static_cast<int32_t>(r % 2)));
        row[r] = table.row(hn::Add(face, hn::Mul(y, hn::Set(di, width))), column, part_x);
      }
      moment[k] = hn::Div(BoxTable<D>::between(row[0], row[1], row[2], row[3], part_y[0], part_y[1]), area);
    }
    const R spread = hn::Max(hn::Sub(moment[1], hn::Mul(moment[0], moment[0])), hn::Zero(real));
    const R range = hn::Set(real, scale.range), middle = hn::Set(real, scale.middle);
    const V mean = hn::DemoteTo(d, hn::Add(middle, hn::Mul(moment[0], range)));
    const V variance = hn::DemoteTo(d, hn::Mul(spread, hn::Mul(range, range)));
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
