// SPDX-License-Identifier: MIT
#ifndef SHD_TEXTURE_UNORM16_CODEC_
#define SHD_TEXTURE_UNORM16_CODEC_

#include "texture/format/codec.h"

namespace shd::texture {

template <size_t kCount>
struct Unorm16Codec : Codes<65535> {
  static constexpr size_t kChannels = kCount, kSize = 2 * kCount;
  static void load(const uint8_t* texel, double* value) {
    uint16_t codes[kChannels];
    std::memcpy(codes, texel, sizeof codes);
    for (size_t c = 0; c < kChannels; ++c) value[c] = codes[c];
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Unorm16Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    uint16_t codes[kChannels];
    for (size_t c = 0; c < kChannels; ++c) codes[c] = round_to_code<uint16_t>(average[c]);
    std::memcpy(texel, codes, sizeof codes);
  }
};

}  // namespace shd::texture

#endif  // SHD_TEXTURE_UNORM16_CODEC_

#ifdef SHD_FORMAT_KERNELS

#if defined(SHD_TEXTURE_UNORM16_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_UNORM16_INL_H_
#undef SHD_TEXTURE_UNORM16_INL_H_
#else
#define SHD_TEXTURE_UNORM16_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Unorm16 : TwoWords {
  static constexpr bool kFloat = false;
  static constexpr bool kCodes8 = false;

  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, const Texel<D>& texel) {
    return hn::ConvertTo(d, half<C, D>(texel) & hn::Set(hn::RebindToSigned<D>(), 0xffff));
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    return CodeToUnit(d, kScale16, value);
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_UNORM16_INL_H_

#endif  // SHD_FORMAT_KERNELS
