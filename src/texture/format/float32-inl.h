// SPDX-License-Identifier: MIT
#ifndef SHD_TEXTURE_FLOAT32_CODEC_
#define SHD_TEXTURE_FLOAT32_CODEC_

#include "texture/format/codec.h"

namespace shd::texture {

template <size_t kCount>
struct Float32Codec : Floats {
  static constexpr size_t kChannels = kCount, kSize = 4 * kCount;
  static constexpr double largest(size_t) { return static_cast<double>(std::numeric_limits<float>::max()); }
  static void load(const uint8_t* texel, double* value) {
    float floats[kChannels];
    std::memcpy(floats, texel, sizeof floats);
    for (size_t c = 0; c < kChannels; ++c) value[c] = static_cast<double>(floats[c]);
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Float32Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    float floats[kChannels];
    for (size_t c = 0; c < kChannels; ++c) floats[c] = static_cast<float>(canonical(average[c]));
    std::memcpy(texel, floats, sizeof floats);
  }
};

}  // namespace shd::texture

#endif  // SHD_TEXTURE_FLOAT32_CODEC_

#ifdef SHD_FORMAT_KERNELS

#if defined(SHD_TEXTURE_FLOAT32_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FLOAT32_INL_H_
#undef SHD_TEXTURE_FLOAT32_INL_H_
#else
#define SHD_TEXTURE_FLOAT32_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Loads all channels of a texel at once. Channels beyond those of the texture are 0. Speed relative to gathers
/// (trilinear floor, 2048 x 2048, Sapphire Rapids): 1.2 on SSE4; 1.0 on AVX2 and AVX-512, where gathers are fast. The
/// gain is larger on machines whose microcode slows gathers.
struct Float32 : QuadsOfPairs<Float32> {
  static constexpr bool kFloat = true;
  template <class D>
  struct Texel {
    Ints<D> word[4];
  };

  template <class D>
  static HWY_INLINE Texel<D> fetch(D d, const TexelSource& source, const int32_t* at) {
    return load(d, source, TexelsOf(d, source, hn::Load(hn::RebindToSigned<D>(), at)), at, 0);
  }
  template <class D>
  static HWY_INLINE void fetch_pair(D d, const TexelSource& source, const int32_t* at, Texel<D>* left,
                                    Texel<D>* right) {
    const uint8_t* texels = TexelsOf(d, source, hn::Load(hn::RebindToSigned<D>(), at));
    if (HWY_LIKELY(texels && source.channels == 1)) {
      return LoadWordPairs<4>(d, texels, at, &left->word[0], &right->word[0]);
    }
    *left = load(d, source, texels, at, 0);
    *right = load(d, source, texels, at, source.texel_size);
  }
  template <class D>
  static HWY_INLINE void fetch_row(D d, const TexelSource& source, const int32_t* at, Texel<D> (&row)[4]) {
    const uint8_t* texels = TexelsOf(d, source, hn::Load(hn::RebindToSigned<D>(), at));
    for (size_t k = 0; k < 4; ++k) row[k] = load(d, source, texels, at, k * source.texel_size);
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, const Texel<D>& texel) {
    return hn::BitCast(d, texel.word[C]);
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D, hn::Vec<D> value) {
    return value;
  }

 private:
  /// Loads the texels `byte` bytes after those at the indices. `texels` is null if they are not all in one block.
  template <class D>
  static HWY_INLINE Texel<D> load(D d, const TexelSource& source, const uint8_t* texels, const int32_t* at,
                                  size_t byte) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    Texel<D> texel;
    texel.word[0] = texel.word[1] = texel.word[2] = texel.word[3] = hn::Zero(hn::RebindToSigned<D>());
    if (HWY_UNLIKELY(!texels)) {
      for (size_t c = 0; c < source.channels; ++c) texel.word[c] = GatherApart(d, source, index, byte + 4 * c);
    } else if (source.channels == 1) {
      texel.word[0] = GatherWords(d, texels + byte, index);
    } else if (source.channels == 2) {
      LoadWordPairs<8>(d, texels + byte, at, &texel.word[0], &texel.word[1]);
    } else {
      LoadFourWords<16>(d, texels + byte, at, texel.word);
    }
    return texel;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FLOAT32_INL_H_

#endif  // SHD_FORMAT_KERNELS
