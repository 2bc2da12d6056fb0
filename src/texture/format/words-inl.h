// SPDX-License-Identifier: MIT
// Fetches of formats whose texels of four channels are one or two 32-bit words.

#if defined(SHD_TEXTURE_WORDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_WORDS_INL_H_
#undef SHD_TEXTURE_WORDS_INL_H_
#else
#define SHD_TEXTURE_WORDS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/codec.h"
#include "texture/format/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns code times scale. For whole codes the result is the correctly rounded quotient by 255 or 65535; for other
/// values its relative error is at most 1.2e-7. A division would take three times as long.
template <class D, class V>
HWY_INLINE V CodeToUnit(D d, CodeScale scale, V code) {
  return code * hn::Set(d, scale.high) + code * hn::Set(d, scale.low);
}

/// Returns byte C of every word. A shuffle takes one operation where a shift and a mask take two.
template <size_t C, class DI, class VI>
HWY_INLINE VI Byte(DI di, VI words) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4
  if constexpr (C == 1 || C == 2) {
    constexpr uint8_t kNone = 0x80;
    alignas(16) static constexpr uint8_t kFrom[16] = {C,     kNone, kNone, kNone, C + 4,  kNone, kNone, kNone,
                                                      C + 8, kNone, kNone, kNone, C + 12, kNone, kNone, kNone};
    const hn::Repartition<uint8_t, DI> bytes;
    return hn::BitCast(di, hn::TableLookupBytesOr0(hn::BitCast(bytes, words), hn::LoadDup128(bytes, kFrom)));
  }
#endif
  const hn::RebindToUnsigned<DI> du;
  const auto shifted = hn::BitCast(di, hn::ShiftRight<static_cast<int>(8 * C)>(hn::BitCast(du, words)));
  return C == 3 ? shifted : shifted & hn::Set(di, 255);
}

/// Fetches of four 8-bit codes in one word. fetch branches on the number of channels, which is constant over a batch.
struct OneWord : QuadsOfPairs<OneWord> {
  static constexpr bool kFloat = false;
  static constexpr bool kCodes8 = false;  // blends are codes of 8 bits
  template <class D>
  using Texel = Ints<D>;

  template <class D>
  static HWY_INLINE Texel<D> fetch(D d, const TexelSource& source, const int32_t* at) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    const uint8_t* texels = TexelsOf(d, source, index);
    if (HWY_UNLIKELY(!texels)) return GatherApart(d, source, index, 0);
    switch (source.channels) {
      case 1: return GatherBytes(d, texels, index);
      case 2: return GatherBytes(d, texels, hn::ShiftLeft<1>(index));
      default: return GatherWords(d, texels, index);
    }
  }
  /// Fetches the texels at the indices and the next texels. With one or two channels, both texels lie in one word.
  template <class D>
  static HWY_INLINE void fetch_pair(D d, const TexelSource& source, const int32_t* at, Texel<D>* left,
                                    Texel<D>* right) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    const uint8_t* texels = TexelsOf(d, source, index);
    if (HWY_UNLIKELY(!texels)) {
      *left = GatherApart(d, source, index, 0);
      *right = GatherApart(d, source, index, source.texel_size);
    } else if (source.channels == 1) {
      *left = GatherBytes(d, texels, index);
      *right = hn::ShiftRight<8>(*left);
    } else if (source.channels == 2) {
      *left = GatherBytes(d, texels, hn::ShiftLeft<1>(index));
      *right = hn::ShiftRight<16>(*left);
    } else {
      LoadWordPairs<4>(d, texels, at, left, right);
    }
  }
  template <class D>
  static HWY_INLINE void fetch_quad(D d, const TexelSource& source, const int32_t* upper, const int32_t* lower,
                                    Texel<D> (&quad)[4]) {
    if (HWY_LIKELY(source.channels == 4)) {
      const uint8_t* texels = TexelsOf(d, source, hn::Load(hn::RebindToSigned<D>(), upper));
      if (HWY_LIKELY(texels)) return LoadWordQuads(d, texels, upper, lower, quad);
    }
    QuadsOfPairs::fetch_quad(d, source, upper, lower, quad);
  }
  template <class D>
  static HWY_INLINE void fetch_rows(D d, const TexelSource& source, const int32_t* upper, int32_t down,
                                    Texel<D> (&quad)[4]) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), upper);
    const uint8_t* const texels = TexelsOf(d, source, index);
    if (HWY_UNLIKELY(!texels)) {
      Texel<D> apart[4];  // a copy, so that the usual quads stay in registers
      QuadsOfPairs::fetch_rows(d, source, upper, down, apart);
      for (size_t k = 0; k < 4; ++k) quad[k] = apart[k];
      return;
    }
    if (HWY_LIKELY(source.channels == 4)) return LoadRowQuads(d, texels, upper, down, quad);
    const uint8_t* const below = texels + ptrdiff_t{down} * source.texel_size;
    const bool one = source.channels == 1;
    const auto offset = one ? index : hn::ShiftLeft<1>(index);
    quad[0] = GatherBytes(d, texels, offset);
    quad[1] = one ? hn::ShiftRight<8>(quad[0]) : hn::ShiftRight<16>(quad[0]);
    quad[2] = GatherBytes(d, below, offset);
    quad[3] = one ? hn::ShiftRight<8>(quad[2]) : hn::ShiftRight<16>(quad[2]);
  }
  template <class D>
  static HWY_INLINE void fetch_row(D d, const TexelSource& source, const int32_t* at, Texel<D> (&row)[4]) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    const uint8_t* texels = TexelsOf(d, source, index);
    if (HWY_LIKELY(texels && source.channels == 4)) return LoadFourWords<4>(d, texels, at, row);
    for (size_t k = 0; k < 4; ++k) {
      row[k] = texels ? GatherBytes(d, texels + k * source.texel_size, source.channels == 1 ? index : index + index)
                      : GatherApart(d, source, index, k * source.texel_size);
    }
  }
};

/// Fetches of four 16-bit channels in two words.
struct TwoWords : QuadsOfPairs<TwoWords> {
  template <class D>
  struct Texel {
    Ints<D> rg, ba;
  };

  template <class D>
  static HWY_INLINE Texel<D> fetch(D d, const TexelSource& source, const int32_t* at) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    return load(d, source, TexelsOf(d, source, index), at, 0);
  }
  template <class D>
  static HWY_INLINE void fetch_pair(D d, const TexelSource& source, const int32_t* at, Texel<D>* left,
                                    Texel<D>* right) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    const uint8_t* texels = TexelsOf(d, source, index);
    if (HWY_UNLIKELY(!texels)) {
      *left = load(d, source, texels, at, 0);
      *right = load(d, source, texels, at, source.texel_size);
    } else if (source.channels == 1) {
      left->rg = left->ba = GatherBytes(d, texels, hn::ShiftLeft<1>(index));
      right->rg = right->ba = hn::ShiftRight<16>(left->rg);
    } else if (source.channels == 2) {
      LoadWordPairs<4>(d, texels, at, &left->rg, &right->rg);
      left->ba = left->rg;
      right->ba = right->rg;
    } else {
      Ints<D> word[4];
      LoadFourWords<8>(d, texels, at, word);
      *left = {word[0], word[1]};
      *right = {word[2], word[3]};
    }
  }
  template <class D>
  static HWY_INLINE void fetch_row(D d, const TexelSource& source, const int32_t* at, Texel<D> (&row)[4]) {
    const uint8_t* texels = TexelsOf(d, source, hn::Load(hn::RebindToSigned<D>(), at));
    for (size_t k = 0; k < 4; ++k) row[k] = load(d, source, texels, at, k * source.texel_size);
  }

  /// Returns channel C in the lower half of every lane. The upper half is not defined if C is 0 or 2.
  template <size_t C, class D>
  static HWY_INLINE Ints<D> half(const Texel<D>& texel) {
    const auto pair = C < 2 ? texel.rg : texel.ba;
    return C % 2 ? hn::ShiftRight<16>(pair) : pair;
  }

 private:
  /// Loads the texels `byte` bytes after those at the indices. `texels` is null if they are not all in one block.
  template <class D>
  static HWY_INLINE Texel<D> load(D d, const TexelSource& source, const uint8_t* texels, const int32_t* at,
                                  size_t byte) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    if (HWY_UNLIKELY(!texels)) {
      const auto rg = GatherApart(d, source, index, byte);
      return {rg, source.channels == 4 ? GatherApart(d, source, index, byte + 4) : rg};
    }
    if (source.channels == 4) {
      Texel<D> texel;
      LoadWordPairs<8>(d, texels + byte, at, &texel.rg, &texel.ba);
      return texel;
    }
    const auto word = source.channels == 1 ? GatherBytes(d, texels + byte, hn::ShiftLeft<1>(index))
                                           : GatherWords(d, texels + byte, index);
    return {word, word};
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_WORDS_INL_H_
