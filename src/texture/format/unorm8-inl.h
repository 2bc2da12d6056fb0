// SPDX-License-Identifier: MIT
#ifndef SHD_TEXTURE_UNORM8_CODEC_
#define SHD_TEXTURE_UNORM8_CODEC_

#include "texture/format/codec.h"

namespace shd::texture {

template <size_t kCount>
struct Unorm8Codec : Codes<255> {
  static constexpr size_t kChannels = kCount, kSize = kCount;
  static void load(const uint8_t* texel, double* value) {
    for (size_t c = 0; c < kChannels; ++c) value[c] = texel[c];
  }
  static void add(const uint8_t* texel, size_t count, double* sum) {
    uint32_t total[kChannels] = {};  // cannot overflow: at most 2^16 texels of 255
    for (size_t i = 0; i < count; ++i) {
      for (size_t c = 0; c < kChannels; ++c) total[c] += texel[kChannels * i + c];
    }
    for (size_t c = 0; c < kChannels; ++c) sum[c] += total[c];
  }
  static void store(const double* average, uint8_t* texel) {
    for (size_t c = 0; c < kChannels; ++c) texel[c] = round_to_code<uint8_t>(average[c]);
  }
};

}  // namespace shd::texture

#endif  // SHD_TEXTURE_UNORM8_CODEC_

#ifdef SHD_FORMAT_KERNELS

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
  static constexpr bool kCodes8 = true;
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

#endif  // SHD_FORMAT_KERNELS
