// SPDX-License-Identifier: MIT
// Texels as floats. Consumers of samplers with a border colour and of derivatives are rarely used, and they blend values
// after they have left the lerp domain of the format. So these consumers are compiled once for all formats, and each
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

/// Reads the wanted channels of `count` texels per lane; texel k of the lanes is at index[k].
using Unpack = void (*)(const TexelSource& source, WantedChannels wanted, const int32_t* const* index, size_t count,
                        UnpackedTexels* out);

/// The Unpack of the format F.
template <class F>
HWY_NOINLINE void UnpackTexels(const TexelSource& source, WantedChannels wanted, const int32_t* const* index,
                               size_t count, UnpackedTexels* out) {
  const BatchTag d;
  for (size_t k = 0; k < count; ++k) {
    const auto texel = F::fetch(d, source, index[k]);
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
      hn::Store(F::template finish<c>(d, F::template decode<c>(d, texel)), d, out[k].channel[c]);
    });
  }
}

/// The Format of unpacked texels.
struct Unpacked {
  static constexpr bool kFloat = true;

  /// Texels of a format, and the function that reads them.
  struct Source {
    const TexelSource& texels;
    WantedChannels wanted;
    Unpack unpack;
  };

  template <class D>
  struct Texel {
    hn::Vec<D> channel[4];
  };

  template <class D>
  static HWY_INLINE Texel<D> fetch(D d, const Source& source, const int32_t* index) {
    UnpackedTexels texels;
    source.unpack(source.texels, source.wanted, &index, 1, &texels);
    return load(d, texels);
  }
  template <class D>
  static HWY_INLINE void fetch_quad(D d, const Source& source, const int32_t* upper, const int32_t* lower,
                                    Texel<D> (&quad)[4]) {
    alignas(64) int32_t right[2][kMaxLanes];
    store_next(d, upper, 1, right[0]);
    store_next(d, lower, 1, right[1]);
    const int32_t* const index[4] = {upper, right[0], lower, right[1]};
    fetch_four(d, source, index, quad);
  }
  template <class D>
  static HWY_INLINE void fetch_row(D d, const Source& source, const int32_t* at, Texel<D> (&row)[4]) {
    alignas(64) int32_t next[3][kMaxLanes];
    for (int k = 0; k < 3; ++k) store_next(d, at, k + 1, next[k]);
    const int32_t* const index[4] = {at, next[0], next[1], next[2]};
    fetch_four(d, source, index, row);
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D, const Texel<D>& texel) {
    return texel.channel[C];
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D, hn::Vec<D> value) {
    return value;
  }

 private:
  template <class D>
  static HWY_INLINE void store_next(D, const int32_t* index, int distance, int32_t* to) {
    const hn::RebindToSigned<D> di;
    hn::Store(hn::Load(di, index) + hn::Set(di, distance), di, to);
  }
  template <class D>
  static HWY_INLINE Texel<D> load(D d, const UnpackedTexels& texels) {
    return {{hn::Load(d, texels.channel[0]), hn::Load(d, texels.channel[1]), hn::Load(d, texels.channel[2]),
             hn::Load(d, texels.channel[3])}};
  }
  template <class D>
  static HWY_INLINE void fetch_four(D d, const Source& source, const int32_t* const (&index)[4], Texel<D> (&texel)[4]) {
    UnpackedTexels texels[4];
    source.unpack(source.texels, source.wanted, index, 4, texels);
    for (size_t k = 0; k < 4; ++k) texel[k] = load(d, texels[k]);
  }
};

/// Consumes elements with the Blend B of Unpacked.
template <class B>
HWY_NOINLINE void ConsumeUnpacked(Unpack unpack, const Stream& stream, size_t end, Consumption* consumption) {
  const Unpacked::Source source = {consumption->texels, WantedBy<B>(consumption->out), unpack};
  ConsumeFrom<B, Unpacked, true>(source, stream, end, consumption);
}

/// Consumes elements of texels of format F with the Blend B of Unpacked; a Consume.
template <class B, class F>
void ConsumeThrough(const Stream& stream, size_t end, Consumption* consumption) {
  ConsumeUnpacked<B>(UnpackTexels<F>, stream, end, consumption);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_UNPACKED_INL_H_
