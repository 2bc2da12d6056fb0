// SPDX-License-Identifier: MIT
// What the kernels know of each texture format: how to fetch a texel and how to unpack one channel of it.
//
//   Texel<D>     raw bits of one texel per lane
//   fetch        texels at indices; what lies behind the channels that the texture has is not defined
//   decode<C>    channel C as a float in the format's lerp domain: unorm channels stay codes
//   finish<C>    from the lerp domain to the result
//   kWords       a texel of four channels is one 32-bit word
//   kFloat       texels may be infinite, NaN or so far apart that their difference overflows
//
// The number of channels is the same for a whole batch: fetch branches on it.

#if defined(SHD_TEXTURE_FORMAT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FORMAT_INL_H_
#undef SHD_TEXTURE_FORMAT_INL_H_
#else
#define SHD_TEXTURE_FORMAT_INL_H_
#endif

#include <hwy/highway.h>

#include "image/srgb.h"
#include "texture/codes.h"
#include "texture/gather-inl.h"
#include "texture/texture.h"
#include "texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// code times a scale: the correctly rounded quotient by 255 or 65535 for whole codes, else within 1.2e-7 of it,
/// relative; a division would take three times as long.
template <class D, class V>
HWY_INLINE V CodeToUnit(D d, CodeScale scale, V code) {
  return hn::Add(hn::Mul(code, hn::Set(d, scale.high)), hn::Mul(code, hn::Set(d, scale.low)));
}

/// Byte C of every word.
template <size_t C, class DI, class VI>
HWY_INLINE VI Byte(DI di, VI words) {
  const hn::RebindToUnsigned<DI> du;
  const auto shifted = hn::BitCast(di, hn::ShiftRight<static_cast<int>(8 * C)>(hn::BitCast(du, words)));
  return C == 3 ? shifted : hn::And(shifted, hn::Set(di, 255));
}

/// Four 8-bit codes in a word.
struct Word {
  static constexpr bool kFloat = false;
  static constexpr bool kWords = true;
  template <class D>
  using Texel = Ints<D>;

  template <class D>
  static HWY_INLINE Texel<D> fetch(D d, const Texture& texture, Ints<D> index) {
    const uint8_t* texels = TexelsOf(d, texture, index);
    if (HWY_UNLIKELY(!texels)) return GatherApart(d, texture, index, 0);
    switch (texture.channels) {
      case 1: return GatherBytes(d, texels, index);
      case 2: return GatherBytes(d, texels, hn::ShiftLeft<1>(index));
      default: return GatherWords(d, texels, index);
    }
  }
};

struct Unorm8 : Word {
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, Texel<D> texel) {
    const hn::RebindToSigned<D> di;
    return hn::ConvertTo(d, Byte<C>(di, texel));
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    return CodeToUnit(d, kScale8, value);
  }
};

/// r, g and b go through the table of correctly rounded linear values; alpha is a code.
struct Srgb8 : Word {
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, Texel<D> texel) {
    const hn::RebindToSigned<D> di;
    const auto code = Byte<C>(di, texel);
    if constexpr (C == 3) return hn::ConvertTo(d, code);
    return hn::GatherIndex(d, image::kSrgb8ToLinear, code);
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    if constexpr (C == 3) return CodeToUnit(d, kScale8, value);
    return value;
  }
};

/// Four 16-bit channels in two words.
struct Words2 {
  static constexpr bool kWords = false;
  template <class D>
  struct Texel {
    Ints<D> rg, ba;
  };

  template <class D>
  static HWY_INLINE Texel<D> fetch(D d, const Texture& texture, Ints<D> index) {
    const uint8_t* texels = TexelsOf(d, texture, index);
    if (HWY_UNLIKELY(!texels)) {
      const auto rg = GatherApart(d, texture, index, 0);
      return {rg, texture.channels == 4 ? GatherApart(d, texture, index, 4) : rg};
    }
    if (texture.channels == 1) {
      const auto word = GatherBytes(d, texels, hn::ShiftLeft<1>(index));
      return {word, word};
    }
    if (texture.channels == 2) {
      const auto word = GatherWords(d, texels, index);
      return {word, word};
    }
    const auto first = hn::Add(index, index);
    return {GatherWords(d, texels, first), GatherWords(d, texels + 4, first)};
  }

  /// Channel C in the lower half of every lane; the upper half is not defined where C is 0 or 2.
  template <size_t C, class D>
  static HWY_INLINE Ints<D> half(const Texel<D>& texel) {
    const auto pair = C < 2 ? texel.rg : texel.ba;
    return C % 2 ? hn::ShiftRight<16>(pair) : pair;
  }
};

struct Unorm16 : Words2 {
  static constexpr bool kFloat = false;

  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, const Texel<D>& texel) {
    const hn::RebindToSigned<D> di;
    return hn::ConvertTo(d, hn::And(half<C, D>(texel), hn::Set(di, 0xffff)));
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    return CodeToUnit(d, kScale16, value);
  }
};

/// binary32 of the binary16 in the lower half of every lane, exact.
template <class D, class VI>
HWY_INLINE hn::Vec<D> HalfToFloat(D d, VI half) {
  const hn::RebindToSigned<D> di;
  const auto magnitude = hn::And(half, hn::Set(di, 0x7fff));
  const auto sign = hn::ShiftLeft<16>(hn::And(half, hn::Set(di, 0x8000)));
  const auto shifted = hn::ShiftLeft<13>(magnitude);
  const auto normal = hn::Add(shifted, hn::Set(di, 112 << 23));
  const auto special = hn::Or(shifted, hn::Set(di, 0x7f800000));
  const auto subnormal = hn::BitCast(di, hn::Mul(hn::ConvertTo(d, magnitude), hn::Set(d, 0x1p-24f)));
  const auto finite = hn::IfThenElse(hn::Lt(magnitude, hn::Set(di, 0x400)), subnormal, normal);
  const auto bits = hn::IfThenElse(hn::Gt(magnitude, hn::Set(di, 0x7bff)), special, finite);
  return hn::BitCast(d, hn::Or(bits, sign));
}

struct Float16 : Words2 {
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

/// Channels are gathered when they are wanted.
struct Float32 {
  static constexpr bool kFloat = true;
  static constexpr bool kWords = false;
  template <class D>
  struct Texel {
    const float* first;
    Ints<D> index;         // of floats
    const Texture* apart;  // null, or the texture where the texels lie in two places; the index is then one of texels
  };

  template <class D>
  static HWY_INLINE Texel<D> fetch(D d, const Texture& texture, Ints<D> index) {
    const auto* first = reinterpret_cast<const float*>(TexelsOf(d, texture, index));
    if (HWY_UNLIKELY(!first)) return {first, index, &texture};
    switch (texture.channels) {
      case 1: return {first, index, nullptr};
      case 2: return {first, hn::ShiftLeft<1>(index), nullptr};
      default: return {first, hn::ShiftLeft<2>(index), nullptr};
    }
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, const Texel<D>& texel) {
    if (HWY_UNLIKELY(texel.apart)) return hn::BitCast(d, GatherApart(d, *texel.apart, texel.index, 4 * C));
    return hn::GatherIndex(d, texel.first + C, texel.index);
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D, hn::Vec<D> value) {
    return value;
  }
};

/// body.run<F>() for the format class F of a texture.
template <class Body>
HWY_INLINE size_t ForFormat(const Texture& texture, const Body& body) {
  switch (texture.component) {
    case image::Component::kUnorm8: return body.template run<Unorm8>();
    case image::Component::kSrgb8: return body.template run<Srgb8>();
    case image::Component::kUnorm16: return body.template run<Unorm16>();
    case image::Component::kFloat16: return body.template run<Float16>();
    default: return body.template run<Float32>();
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FORMAT_INL_H_
