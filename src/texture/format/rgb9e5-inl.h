// SPDX-License-Identifier: MIT
#ifndef SHD_TEXTURE_RGB9E5_CODEC_
#define SHD_TEXTURE_RGB9E5_CODEC_

#include "texture/format/codec.h"

namespace shd::texture {

/// A colour as three numbers with one exponent: a channel is its number times 2^(exponent - bits).
struct SharedExponent {
  uint32_t number[3];
  int exponent;
};

/// Returns the nearest numbers of kBits bits to finite channels that are not negative, half up. Their exponent is the
/// least one, from `least` on, at which the largest number fits after it is rounded.
template <int kBits>
SharedExponent share_exponent(const double (&color)[3], int least) {
  const auto nearest = [](double value, int exponent) {
    const double numbers = std::ldexp(value, kBits - exponent);
    const auto whole = static_cast<uint32_t>(numbers);
    return whole + (numbers - whole >= 0.5);
  };
  const double first = color[0] > color[1] ? color[0] : color[1], most = first > color[2] ? first : color[2];
  int exponent = 0;
  std::frexp(most, &exponent);  // most < 2^exponent
  exponent = exponent > least && most > 0 ? exponent : least;
  exponent += nearest(most, exponent) >> kBits;
  return {{nearest(color[0], exponent), nearest(color[1], exponent), nearest(color[2], exponent)}, exponent};
}

/// Codec of three numbers of 9 bits with one exponent e, which has the bias 15. Channel 3 is 1. Averages are encoded as
/// in the OpenGL extension EXT_texture_shared_exponent, "Shared Exponent Texture Color Conversion".
template <size_t kCount>
struct Rgb9e5Codec {
  static constexpr size_t kChannels = kCount, kSize = 4;
  static constexpr bool kFloat = false;
  static constexpr CodeScale scale(size_t) { return {1.0f, 0.0f}; }
  static constexpr double one(size_t) { return 1; }
  static constexpr double largest(size_t c) { return c == 3 ? 1 : 65408; }
  static void load(const uint8_t* texel, double* value) {
    uint32_t word;
    std::memcpy(&word, texel, sizeof word);
    const double unit = std::ldexp(1.0, static_cast<int>(word >> 27) - 24);
    for (size_t c = 0; c < kChannels; ++c) value[c] = c == 3 ? 1 : (word >> 9 * c & 511) * unit;
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Rgb9e5Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    double color[3] = {};
    for (size_t c = 0; c < kChannels && c < 3; ++c) color[c] = clamp_stored<Rgb9e5Codec>(c, average[c]);
    const SharedExponent shared = share_exponent<9>(color, -15);
    auto word = static_cast<uint32_t>(shared.exponent + 15) << 27;
    for (size_t c = 0; c < 3; ++c) word |= shared.number[c] << 9 * c;
    std::memcpy(texel, &word, sizeof word);
  }
};

}  // namespace shd::texture

#endif  // SHD_TEXTURE_RGB9E5_CODEC_

#ifdef SHD_FORMAT_KERNELS

#if defined(SHD_TEXTURE_RGB9E5_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RGB9E5_INL_H_
#undef SHD_TEXTURE_RGB9E5_INL_H_
#else
#define SHD_TEXTURE_RGB9E5_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Decodes r, g and b, exactly. Channel 3 is 1.
struct Rgb9e5 : OneWord {
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, Texel<D> texel) {
    if constexpr (C == 3) return hn::Set(d, 1.0f);
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    constexpr int32_t kBias = 127 - 24;
    const auto exponent = hn::BitCast(di, hn::ShiftRight<27>(hn::BitCast(du, texel)));
    const auto unit = hn::BitCast(d, hn::ShiftLeft<23>(exponent + hn::Set(di, kBias)));
    const auto number = hn::ShiftRight<static_cast<int>(9 * (C % 3))>(texel) & hn::Set(di, 511);
    return hn::ConvertTo(d, number) * unit;
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D, hn::Vec<D> value) {
    return value;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RGB9E5_INL_H_

#endif  // SHD_FORMAT_KERNELS
