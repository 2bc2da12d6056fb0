// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/unorm8.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct Unorm8 : OneWord {
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, Texel<D> texel) {
    return hn::ConvertTo(d, Byte<C>(hn::RebindToSigned<D>(), texel));
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    return CodeToUnit(d, kScale8, value);
  }
};

}  // namespace

FormatKernels Unorm8Kernels() {
  return KernelsOf<Unorm8>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
