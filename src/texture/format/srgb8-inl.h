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

/// Looks codes up in the table of correctly rounded linear values.
template <class D>
HWY_INLINE hn::Vec<D> LinearOf(D d, Ints<D> code) {
#if HWY_TARGET == HWY_AVX3
  if constexpr (hn::MaxLanes(D()) == 16) {
    // Eight permutations of 32 table entries each, and a selection by the upper three bits. A gather of 16 lanes is
    // slower, because it reads the elements one by one.
    const auto eighth = [&](int k) SHD_INLINE_LAMBDA {
      const float* entries = image::kSrgb8ToLinear + 32 * k;
      return _mm512_permutex2var_ps(_mm512_loadu_ps(entries), code.raw, _mm512_loadu_ps(entries + 16));
    };
    const __mmask16 bit5 = _mm512_test_epi32_mask(code.raw, _mm512_set1_epi32(32));
    const __mmask16 bit6 = _mm512_test_epi32_mask(code.raw, _mm512_set1_epi32(64));
    const __mmask16 bit7 = _mm512_test_epi32_mask(code.raw, _mm512_set1_epi32(128));
    const auto half = [&](int k) SHD_INLINE_LAMBDA {
      return _mm512_mask_blend_ps(bit6, _mm512_mask_blend_ps(bit5, eighth(k), eighth(k + 1)),
                                  _mm512_mask_blend_ps(bit5, eighth(k + 2), eighth(k + 3)));
    };
    return hn::Vec<D>{_mm512_mask_blend_ps(bit7, half(0), half(4))};
  }
#endif
  return hn::GatherIndex(d, image::kSrgb8ToLinear, code);
}

/// Decodes r, g and b. Alpha is a code.
struct Srgb8 : OneWord {
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, Texel<D> texel) {
    const auto code = Byte<C>(hn::RebindToSigned<D>(), texel);
    if constexpr (C == 3) return hn::ConvertTo(d, code);
    return LinearOf(d, code);
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
