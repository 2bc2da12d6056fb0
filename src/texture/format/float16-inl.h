// SPDX-License-Identifier: MIT
#ifndef SHD_TEXTURE_FLOAT16_CODEC_
#define SHD_TEXTURE_FLOAT16_CODEC_

#include "image/half.h"
#include "texture/format/codec.h"

namespace shd::texture {

template <size_t kCount>
struct Float16Codec : Floats {
  static constexpr size_t kChannels = kCount, kSize = 2 * kCount;
  static constexpr double largest(size_t) { return 65504; }
  static void load(const uint8_t* texel, double* value) {
    uint16_t halves[kChannels];
    std::memcpy(halves, texel, sizeof halves);
    for (size_t c = 0; c < kChannels; ++c) value[c] = static_cast<double>(image::half_to_float(halves[c]));
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Float16Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    uint16_t halves[kChannels];
    for (size_t c = 0; c < kChannels; ++c) halves[c] = image::float_to_half(round_to_odd(canonical(average[c])));
    std::memcpy(texel, halves, sizeof halves);
  }
};

}  // namespace shd::texture

#endif  // SHD_TEXTURE_FLOAT16_CODEC_

#ifdef SHD_FORMAT_KERNELS

#if defined(SHD_TEXTURE_FLOAT16_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FLOAT16_INL_H_
#undef SHD_TEXTURE_FLOAT16_INL_H_
#else
#define SHD_TEXTURE_FLOAT16_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Converts the binary16 in the lower half of every lane to binary32. The conversion is exact.
template <class D, class VI>
HWY_INLINE hn::Vec<D> HalfToFloat(D d, VI half) {
  const hn::RebindToSigned<D> di;
  const auto magnitude = half & hn::Set(di, 0x7fff);
  const auto sign = hn::ShiftLeft<16>(half & hn::Set(di, 0x8000));
  const auto shifted = hn::ShiftLeft<13>(magnitude);
  const auto normal = shifted + hn::Set(di, 112 << 23);
  const auto special = shifted | hn::Set(di, 0x7f800000);
  const auto subnormal = hn::BitCast(di, hn::ConvertTo(d, magnitude) * hn::Set(d, 0x1p-24f));
  const auto finite = hn::IfThenElse(hn::Lt(magnitude, hn::Set(di, 0x400)), subnormal, normal);
  const auto bits = hn::IfThenElse(hn::Gt(magnitude, hn::Set(di, 0x7bff)), special, finite);
  return hn::BitCast(d, bits | sign);
}

struct Float16 : TwoWords {
  static constexpr bool kFloat = true;

  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, const Texel<D>& texel) {
    return HalfToFloat(d, half<C, D>(texel));
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D, hn::Vec<D> value) {
    return value;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FLOAT16_INL_H_

#endif  // SHD_FORMAT_KERNELS
