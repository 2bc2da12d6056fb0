// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/unorm16.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct Unorm16 : TwoWords {
  static constexpr bool kFloat = false;

  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, const Texel<D>& texel) {
    return hn::ConvertTo(d, half<C, D>(texel) & hn::Set(hn::RebindToSigned<D>(), 0xffff));
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    return CodeToUnit(d, kScale16, value);
  }
};

}  // namespace

FormatKernels Unorm16Kernels() {
  return KernelsOf<Unorm16>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
