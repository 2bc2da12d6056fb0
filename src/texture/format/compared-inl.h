// SPDX-License-Identifier: MIT
// Comparisons: each texel becomes 0 or 1 before it is blended (shd_compare).

#if defined(SHD_TEXTURE_COMPARED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_COMPARED_INL_H_
#undef SHD_TEXTURE_COMPARED_INL_H_
#else
#define SHD_TEXTURE_COMPARED_INL_H_
#endif

#include <cmath>

#include <hwy/highway.h>

#include "data/compare.h"
#include "simd/tail-inl.h"
#include "texture/format/unpacked-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A Blend of the comparisons of texels with the references of lookups (clamped_reference()).
struct Compared : Blend<Unpacked, true> {
  using Values = Blend<Unpacked, true>;

  const Consumption& lookups;
  const data::Comparison comparison;
  const float least, largest;  // limits of references

  explicit Compared(const Consumption& c)
      : Values(c),
        lookups(c),
        comparison(data::comparison_of(c.sampler.compare)),
        least(c.unorm ? 0.0f : -HUGE_VALF),
        largest(c.unorm ? 1.0f : HUGE_VALF) {}

  template <size_t C, class D>
  HWY_INLINE hn::Vec<D> tap(D d, const Unpacked::Texel<D>& texel, MaskOf<D> in) const {
    return passed(d, Values::tap<C>(d, texel, in));
  }

 private:
  /// The result of a comparison of a texel: 1 or 0. Not inline: a stream has many taps.
  template <class D>
  HWY_NOINLINE hn::Vec<D> passed(D d, hn::Vec<D> value) const {
    const auto reference = reference_of(d);
    const auto number = [&](bool result) { return hn::Set(d, result ? 1.0f : 0.0f); };
    auto result = number(comparison.unordered());
    result = hn::IfThenElse(hn::Lt(reference, value), number(comparison.less), result);
    result = hn::IfThenElse(hn::Eq(reference, value), number(comparison.equal), result);
    return hn::IfThenElse(hn::Gt(reference, value), number(comparison.greater), result);
  }

  /// Returns the references of the current vector of lookups.
  template <class D>
  HWY_INLINE hn::Vec<D> reference_of(D d) const {
    if (!lookups.reference) return hn::Zero(d);
    const size_t left = lookups.count - lookups.done;
    const float* const from = lookups.reference + lookups.done;
    const auto reference =
        HWY_LIKELY(left >= hn::Lanes(d)) ? hn::LoadU(d, from) : simd::HWY_NAMESPACE::LoadFirst(d, from, left);
    const auto low = hn::Set(d, least), high = hn::Set(d, largest);
    return hn::IfThenElse(hn::Lt(reference, low), low, hn::IfThenElse(hn::Gt(reference, high), high, reference));
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_COMPARED_INL_H_
