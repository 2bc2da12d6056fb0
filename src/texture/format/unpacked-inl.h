// SPDX-License-Identifier: MIT
// Texels as floats. Consumers of border colours, comparisons and derivatives blend values after they have left the lerp
// domain of the format, and they are rarely used. So these consumers are compiled once for all formats, and each
// format has one small function, which decodes a vector of texels into memory.

#if defined(SHD_TEXTURE_UNPACKED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_UNPACKED_INL_H_
#undef SHD_TEXTURE_UNPACKED_INL_H_
#else
#define SHD_TEXTURE_UNPACKED_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/consume-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Values of the channels of one texel per lane.
struct UnpackedTexels {
  alignas(64) float channel[4][kMaxLanes];
};

/// Reads the wanted channels of the texels of an element. Border lanes have the value of some texel.
struct Unpack {
  void (*one)(const TexelSource& source, WantedChannels wanted, const int32_t* index, UnpackedTexels* out);
  void (*four)(const TexelSource& source, WantedChannels wanted, const Stream& stream, uint32_t op, size_t at,
               UnpackedTexels* out);
};

template <class F>
HWY_INLINE void StoreChannels(BatchTag d, const typename F::template Texel<BatchTag>& texel, WantedChannels wanted,
                              UnpackedTexels* out) {
  wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
    hn::Store(F::template finish<c>(d, F::template decode<c>(d, texel)), d, out->channel[c]);
  });
}

/// The Unpack of the format F.
template <class F>
void UnpackOne(const TexelSource& source, WantedChannels wanted, const int32_t* index, UnpackedTexels* out) {
  const BatchTag d;
  StoreChannels<F>(d, FetchTap<F, true>(d, source, index).texel, wanted, out);
}
template <class F>
void UnpackFour(const TexelSource& source, WantedChannels wanted, const Stream& stream, uint32_t op, size_t at,
                UnpackedTexels* out) {
  const BatchTag d;
  const FourTaps<F, BatchTag> four = FetchFour<F, true>(d, source, stream, op, at);
  for (size_t k = 0; k < 4; ++k) StoreChannels<F>(d, four.tap[k].texel, wanted, out + k);
}

/// The Format of unpacked texels. FetchTap() and FetchFour() of its source take the place of its fetches.
struct Unpacked {
  static constexpr bool kFloat = true;

  /// Texels of a format, and the functions that read them.
  struct Source {
    const TexelSource& texels;
    WantedChannels wanted;
    Unpack unpack;
  };

  template <class D>
  struct Texel {
    hn::Vec<D> channel[4];
  };

  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D, const Texel<D>& texel) {
    return texel.channel[C];
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D, hn::Vec<D> value) {
    return value;
  }
};

/// Returns a tap of unpacked texels, whose lanes of negative indices are the border.
template <class D>
HWY_INLINE Tap<Unpacked, D> TapOf(D d, const UnpackedTexels& texels, const int32_t* index) {
  const hn::RebindToSigned<D> di;
  const Unpacked::Texel<D> texel = {{hn::Load(d, texels.channel[0]), hn::Load(d, texels.channel[1]),
                                     hn::Load(d, texels.channel[2]), hn::Load(d, texels.channel[3])}};
  return {texel, hn::RebindMask(d, hn::Gt(hn::Load(di, index), hn::Set(di, -1)))};
}

template <class F, bool kBorder, class D>
HWY_INLINE Tap<F, D> FetchTap(D d, const Unpacked::Source& source, const int32_t* index) {
  UnpackedTexels texels;
  source.unpack.one(source.texels, source.wanted, index, &texels);
  return TapOf(d, texels, index);
}

template <class F, bool kBorder, class D>
HWY_INLINE FourTaps<F, D> FetchFour(D d, const Unpacked::Source& source, const Stream& stream, uint32_t op, size_t at) {
  UnpackedTexels texels[4];
  source.unpack.four(source.texels, source.wanted, stream, op, at, texels);
  FourTaps<F, D> four;
  // Column 2 is set for all quads and rows, and neighbours are not the border.
  for (size_t k = 0; k < 4; ++k) four.tap[k] = TapOf(d, texels[k], stream.index[op & kNeighbours ? 2 : k] + at);
  return four;
}

/// Consumes elements with the Blend B of Unpacked.
template <class B>
HWY_NOINLINE void ConsumeUnpacked(Unpack unpack, const Stream& stream, size_t end, Consumption* consumption) {
  const Unpacked::Source source = {consumption->texels, WantedBy<B>(consumption->out), unpack};
  ConsumeFrom<B, Unpacked, true>(source, stream, end, consumption);
}

/// Consumes elements of texels of format F with the Blend B of Unpacked; a Consume.
template <class B, class F>
void ConsumeThrough(const Stream& stream, size_t end, Consumption* consumption) {
  ConsumeUnpacked<B>({UnpackOne<F>, UnpackFour<F>}, stream, end, consumption);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_UNPACKED_INL_H_
