// SPDX-License-Identifier: MIT
#include "volume/transfer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume/transfer.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/finite-inl.h"
#include "simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::volume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Returns 1 - exp(-x) for x >= 0. Below 1/8 by its series, which keeps the digits of small opacities: the next term is
/// below 4e-8 of the sum.
template <class D, class V>
HWY_INLINE V OpacityOf(D d, V x) {
  const V one = hn::Set(d, 1.0f);
  V series = one - x * hn::Set(d, 1.0f / 6);
  series = one - x * hn::Set(d, 1.0f / 5) * series;
  series = one - x * hn::Set(d, 1.0f / 4) * series;
  series = one - x * hn::Set(d, 1.0f / 3) * series;
  series = x * (one - x * hn::Set(d, 0.5f) * series);
  const V large = one - simd::HWY_NAMESPACE::Exp2(d, x * hn::Set(d, -1.44269504f));
  return hn::IfThenElse(hn::Lt(x, hn::Set(d, 0.125f)), series, large);
}

}  // namespace

void TransferBatch(const Transfer& function, const float* density, const float* dt, size_t count, const Samples& out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  constexpr int kFields = sizeof(TransferPoint) / sizeof(float);
  const float* const table = &function.point[0].density;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V x = simd::HWY_NAMESPACE::ZeroIfNaN(hn::Load(d, density + i));
    // The segment is the last point whose density is not above x.
    auto segment = hn::Zero(di);
    for (uint32_t k = 1; k < function.count; ++k) {
      const auto reached = hn::Ge(x, hn::Set(d, function.density[k]));
      segment = hn::IfThenElse(hn::RebindMask(di, reached), hn::Set(di, static_cast<int32_t>(k)), segment);
    }
    const auto row = segment * hn::Set(di, kFields);
    const auto field = [&](int k) { return hn::GatherIndex(d, table, row + hn::Set(di, k)); };
    // Infinity times 0 is NaN.
    const V s = hn::Min(hn::Max(simd::HWY_NAMESPACE::ZeroIfNaN((x - field(0)) * field(1)), zero), one);
    const auto value = [&](int c) { return field(2 + c) + s * field(6 + c); };
    const V depth = hn::Max(value(0), zero) * hn::Load(d, dt + i);
    hn::Store(OpacityOf(d, depth), d, out.opacity + i);
    for (int c = 0; c < 3; ++c) hn::Store(value(1 + c), d, out.color[c] + i);
  }
}

}  // namespace shd::volume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::volume {

HWY_EXPORT(TransferBatch);

void transfer(const core::SimdTarget& simd, const Transfer& function, const float* density, const float* dt,
              size_t count, const Samples& out) {
  SHD_DISPATCH(TransferBatch, simd)(function, density, dt, count, out);
}

namespace {

/// Returns the extinction of a density that is not NaN.
float extinction_of(const Transfer& function, float density) {
  uint32_t segment = 0;
  for (uint32_t k = 1; k < function.count; ++k) segment = density >= function.density[k] ? k : segment;
  const TransferPoint& point = function.point[segment];
  const float s = (density - point.density) * point.inverse_width;
  return point.value[0] + (s > 0.0f ? s < 1.0f ? s : 1.0f : 0.0f) * point.slope[0];
}

}  // namespace

bool is_visible(const Transfer& function, float low, float high) {
  bool visible = extinction_of(function, low) > 0.0f || extinction_of(function, high) > 0.0f;
  for (uint32_t k = 0; k < function.count; ++k) {
    const bool inside = function.density[k] >= low && function.density[k] <= high;
    visible = visible || (inside && function.point[k].value[0] > 0.0f);
  }
  return visible;
}

}  // namespace shd::volume
#endif
