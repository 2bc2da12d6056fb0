// SPDX-License-Identifier: MIT
#ifndef SHD_TEXTURE_SRGB8_CODEC_
#define SHD_TEXTURE_SRGB8_CODEC_

#include "image/srgb.h"
#include "texture/format/codec.h"

namespace shd::texture {

/// Codec of 8-bit sRGB. Channel 3 is alpha, a linear code.
template <size_t kCount>
struct Srgb8Codec {
  static constexpr size_t kChannels = kCount, kSize = kCount;
  static constexpr bool kFloat = false;
  static constexpr CodeScale scale(size_t c) { return c == 3 ? kScale8 : CodeScale{1.0f, 0.0f}; }
  static constexpr double one(size_t c) { return c == 3 ? 255 : 1; }
  static constexpr double largest(size_t c) { return one(c); }
  static void load(const uint8_t* texel, double* value) {
    for (size_t c = 0; c < kChannels; ++c) {
      value[c] = c == 3 ? texel[c] : static_cast<double>(image::kSrgb8ToLinear[texel[c]]);
    }
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Srgb8Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    for (size_t c = 0; c < kChannels; ++c) {
      texel[c] = c == 3 ? round_to_code<uint8_t>(average[c]) : image::linear_to_srgb8(static_cast<float>(average[c]));
    }
  }
};

}  // namespace shd::texture

#endif  // SHD_TEXTURE_SRGB8_CODEC_

#ifdef SHD_FORMAT_KERNELS

#if defined(SHD_TEXTURE_SRGB8_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_SRGB8_INL_H_
#undef SHD_TEXTURE_SRGB8_INL_H_
#else
#define SHD_TEXTURE_SRGB8_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Decodes r, g and b by the table of correctly rounded linear values. Alpha is a code.
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

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SRGB8_INL_H_

#endif  // SHD_FORMAT_KERNELS
