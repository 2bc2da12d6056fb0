// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/float32.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Channels are gathered when they are wanted.
struct Float32 {
  static constexpr bool kFloat = true;
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
  template <class D>
  static HWY_INLINE void fetch_pair(D d, const Texture& texture, const int32_t* at, Texel<D>* left, Texel<D>* right) {
    const auto index = hn::Load(hn::RebindToSigned<D>(), at);
    *left = fetch(d, texture, index);
    *right = fetch(d, texture, index + hn::Set(hn::RebindToSigned<D>(), 1));
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

}  // namespace

FormatKernels Float32Kernels() {
  return KernelsOf<Float32>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
