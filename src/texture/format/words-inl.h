// SPDX-License-Identifier: MIT
// Texels that are one or two 32-bit words where they have four channels.

#if defined(SHD_TEXTURE_WORDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_WORDS_INL_H_
#undef SHD_TEXTURE_WORDS_INL_H_
#else
#define SHD_TEXTURE_WORDS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/gather-inl.h"
#include "texture/store/texel_codec.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// code times a scale: the correctly rounded quotient by 255 or 65535 for whole codes, else within 1.2e-7 of it,
/// relative; a division would take three times as long.
template <class D, class V>
HWY_INLINE V CodeToUnit(D d, CodeScale scale, V code) {
  return code * hn::Set(d, scale.high) + code * hn::Set(d, scale.low);
}

/// Byte C of every word.
template <size_t C, class DI, class VI>
HWY_INLINE VI Byte(DI di, VI words) {
  const hn::RebindToUnsigned<DI> du;
  const auto shifted = hn::BitCast(di, hn::ShiftRight<static_cast<int>(8 * C)>(hn::BitCast(du, words)));
  return C == 3 ? shifted : shifted & hn::Set(di, 255);
}

/// Four 8-bit codes in a word. The number of channels is the same for a whole batch: fetch branches on it.
struct OneWord {
  static constexpr bool kFloat = false;
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
  /// Of one or two channels, both texels lie in one word.
  template <class D>
  static HWY_INLINE void fetch_pair(D d, const Texture& texture, const int32_t* at, Texel<D>* left, Texel<D>* right) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    const uint8_t* texels = TexelsOf(d, texture, index);
    if (HWY_UNLIKELY(!texels)) {
      *left = GatherApart(d, texture, index, 0);
      *right = GatherApart(d, texture, index + hn::Set(hn::RebindToSigned<D>(), 1), 0);
    } else if (texture.channels == 1) {
      *left = GatherBytes(d, texels, index);
      *right = hn::ShiftRight<8>(*left);
    } else if (texture.channels == 2) {
      *left = GatherBytes(d, texels, hn::ShiftLeft<1>(index));
      *right = hn::ShiftRight<16>(*left);
    } else {
      LoadWordPairs(d, texels, at, left, right);
    }
  }
};

/// Four 16-bit channels in two words.
struct TwoWords {
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
    if (texture.channels == 4) {
      alignas(64) int32_t words[hn::MaxLanes(D())];
      hn::Store(index + index, hn::RebindToSigned<D>(), words);
      Texel<D> texel;
      LoadWordPairs(d, texels, words, &texel.rg, &texel.ba);
      return texel;
    }
    const auto word = texture.channels == 1 ? GatherBytes(d, texels, hn::ShiftLeft<1>(index))
                                            : GatherWords(d, texels, index);
    return {word, word};
  }
  template <class D>
  static HWY_INLINE void fetch_pair(D d, const Texture& texture, const int32_t* at, Texel<D>* left, Texel<D>* right) {
    const hn::RebindToSigned<D> di;
    const auto index = hn::Load(di, at);
    const uint8_t* texels = texture.channels < 4 ? TexelsOf(d, texture, index) : nullptr;
    if (HWY_UNLIKELY(!texels)) {
      *left = fetch(d, texture, index);
      *right = fetch(d, texture, index + hn::Set(di, 1));
    } else if (texture.channels == 1) {
      left->rg = left->ba = GatherBytes(d, texels, hn::ShiftLeft<1>(index));
      right->rg = right->ba = hn::ShiftRight<16>(left->rg);
    } else {
      LoadWordPairs(d, texels, at, &left->rg, &right->rg);
      left->ba = left->rg;
      right->ba = right->rg;
    }
  }

  /// Channel C in the lower half of every lane; the upper half is not defined where C is 0 or 2.
  template <size_t C, class D>
  static HWY_INLINE Ints<D> half(const Texel<D>& texel) {
    const auto pair = C < 2 ? texel.rg : texel.ba;
    return C % 2 ? hn::ShiftRight<16>(pair) : pair;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_WORDS_INL_H_
