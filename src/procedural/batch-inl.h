// SPDX-License-Identifier: MIT
// Loops over the rows of a batch.

#if defined(SHD_PROCEDURAL_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROCEDURAL_BATCH_INL_H_
#undef SHD_PROCEDURAL_BATCH_INL_H_
#else
#define SHD_PROCEDURAL_BATCH_INL_H_
#endif

#include <hwy/highway.h>

#include "procedural/solid.h"
#include "simd/finite-inl.h"
#include "simd/tail-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A value and its derivatives by x, y and z. Kernels without gradients leave these unset, and compilers drop them.
template <class V>
struct Sample {
  V value, dx, dy, dz;
};

/// A place and the width of its pixel; all finite, width >= 0.
template <class V>
struct Place {
  V x, y, z, width;
};

/// Reads one vector of places. Rows past the last one are copies of it. Adds the places that are not finite to `bad`.
template <class D>
HWY_INLINE Place<hn::Vec<D>> LoadPlace(D d, const Places& places, size_t at, size_t* bad) {
  using simd::HWY_NAMESPACE::IsFinite;
  using simd::HWY_NAMESPACE::LoadFirst;
  const size_t left = places.count - at;
  const size_t count = left < hn::Lanes(d) ? left : hn::Lanes(d);
  const auto load = [&](const float* column) {
    return count == hn::Lanes(d) ? hn::LoadU(d, column + at) : LoadFirst(d, column + at, count);
  };
  const auto x = load(places.x), y = load(places.y), z = load(places.z);
  const auto width = places.width ? load(places.width) : hn::Zero(d);
  const auto good = hn::And(hn::And(IsFinite(d, x), IsFinite(d, y)), hn::And(IsFinite(d, z), IsFinite(d, width)));
  if (HWY_UNLIKELY(!hn::AllTrue(d, good))) {
    *bad += hn::CountTrue(d, hn::And(hn::Not(good), hn::FirstN(d, count)));
  }
  const auto finite = [&](auto v) { return hn::IfThenElseZero(IsFinite(d, v), v); };
  const auto positive = hn::IfThenElseZero(hn::Gt(width, hn::Zero(d)), width);
  return {finite(x), finite(y), finite(z), hn::Min(positive, hn::Set(d, 3.40282347e38f))};
}

/// Evaluates pattern.At<kGradient>(d, place) at every place.
template <bool kGradient, class Pattern>
HWY_INLINE size_t EvaluateRows(const Pattern& pattern, const Places& places, const Values& out) {
  const hn::ScalableTag<float> d;
  size_t bad = 0;
  for (size_t at = 0; at < places.count; at += hn::Lanes(d)) {
    const auto sample = pattern.template At<kGradient>(d, LoadPlace(d, places, at, &bad));
    const auto store = [&](auto value, float* column) {
      simd::HWY_NAMESPACE::StoreFirst(d, value, places.count - at, column + at);
    };
    store(sample.value, out.value);
    if constexpr (kGradient) {
      store(sample.dx, out.gradient[0]);
      store(sample.dy, out.gradient[1]);
      store(sample.dz, out.gradient[2]);
    }
  }
  return bad;
}

template <class Pattern>
HWY_INLINE size_t Evaluate(const Pattern& pattern, const Places& places, const Values& out) {
  return out.gradient[0] ? EvaluateRows<true>(pattern, places, out) : EvaluateRows<false>(pattern, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROCEDURAL_BATCH_INL_H_
