// SPDX-License-Identifier: MIT
// Choices that nearly all lanes decide in one way, for kernels that test them once for many vectors.

#if defined(SHD_SIMD_CHOICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_CHOICES_INL_H_
#undef SHD_SIMD_CHOICES_INL_H_
#else
#define SHD_SIMD_CHOICES_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Chooses lane by lane.
template <class D>
struct Choices {
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  HWY_INLINE explicit Choices(D) {}
  HWY_INLINE V Select(M mask, V usual, V other) { return hn::IfThenElse(mask, usual, other); }
  HWY_INLINE V OrZero(M mask, V usual) { return hn::IfThenElseZero(mask, usual); }
  /// x must not be NaN.
  HWY_INLINE V AtLeast(V x, V floor) { return hn::Max(x, floor); }
};

/// Takes the usual value in every choice. The results are those of Choices if all lanes of `usual` are set at the end.
template <class D>
struct UsualChoices {
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  HWY_INLINE explicit UsualChoices(D d) : usual(hn::Eq(hn::Zero(d), hn::Zero(d))) {}
  HWY_INLINE V Select(M mask, V value, V) {
    usual = hn::And(usual, mask);
    return value;
  }
  HWY_INLINE V OrZero(M mask, V value) {
    usual = hn::And(usual, mask);
    return value;
  }
  HWY_INLINE V AtLeast(V x, V floor) {
    usual = hn::And(usual, hn::Ge(x, floor));
    return x;
  }

  M usual;
};

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_CHOICES_INL_H_
