// SPDX-License-Identifier: MIT
// Consumers of comparisons: each texel becomes 0 or 1 before it is blended (shd_compare).
#include "texture/stream.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/compared.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "data/compare.h"
#include "texture/format/consume-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/formats.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::LoadFirst;
namespace {

/// A Blend whose values are the comparisons of texels of format F.
template <class F>
struct Compared : Blend<F, true> {
  const Consumption& lookups;
  const data::Comparison comparison;

  explicit Compared(const Consumption& c)
      : Blend<F, true>(c), lookups(c), comparison(data::comparison_of(c.sampler.compare)) {}

  template <size_t C, class D>
  HWY_INLINE hn::Vec<D> tap(D d, const typename F::template Texel<D>& texel, MaskOf<D> in) const {
    const auto value = Blend<F, true>::template tap<C>(d, texel, in), reference = reference_of(d);
    const auto number = [&](bool result) { return hn::Set(d, result ? 1.0f : 0.0f); };
    auto result = number(comparison.unordered());
    result = hn::IfThenElse(hn::Lt(reference, value), number(comparison.less), result);
    result = hn::IfThenElse(hn::Eq(reference, value), number(comparison.equal), result);
    return hn::IfThenElse(hn::Gt(reference, value), number(comparison.greater), result);
  }

 private:
  /// Returns the references of the current vector of lookups.
  template <class D>
  HWY_INLINE hn::Vec<D> reference_of(D d) const {
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    if (!lookups.reference) return zero;
    const size_t left = lookups.count - lookups.done;
    const float* const from = lookups.reference + lookups.done;
    const auto reference = HWY_LIKELY(left >= hn::Lanes(d)) ? hn::LoadU(d, from) : LoadFirst(d, from, left);
    if constexpr (F::kFloat) return reference;
    return hn::IfThenElse(hn::Lt(reference, zero), zero, hn::IfThenElse(hn::Gt(reference, one), one, reference));
  }
};

}  // namespace

Consume ComparedOf(image::Component component) {
  switch (component) {
#define SHD_TEXTURE_CASE(name, Format) \
  case image::Component::name: return ConsumeStream<Compared<Format>, Format, true>;
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
  return nullptr;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
