// SPDX-License-Identifier: MIT
#if defined(SHD_TEXTURE_UNORM8_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_UNORM8_INL_H_
#undef SHD_TEXTURE_UNORM8_INL_H_
#else
#define SHD_TEXTURE_UNORM8_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_UNORM8_INL_H_
