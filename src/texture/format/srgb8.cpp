// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#include "image/srgb.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/srgb8.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// r, g and b go through the table of correctly rounded linear values; alpha is a code.
struct Srgb8 : OneWord {
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, Texel<D> texel) {
    const auto code = Byte<C>(hn::RebindToSigned<D>(), texel);
    if constexpr (C == 3) return hn::ConvertTo(d, code);
    return hn::GatherIndex(d, image::kSrgb8ToLinear, code);
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    if constexpr (C == 3) return CodeToUnit(d, kScale8, value);
    return value;
  }
};

}  // namespace

FormatKernels Srgb8Kernels() {
  return KernelsOf<Srgb8>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
