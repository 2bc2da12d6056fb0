// SPDX-License-Identifier: MIT
// Consumers of rows of quads (rows.h): the operations of ConsumeStream() without its tests of each element.

#if defined(SHD_TEXTURE_CONSUME_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_CONSUME_ROWS_INL_H_
#undef SHD_TEXTURE_CONSUME_ROWS_INL_H_
#else
#define SHD_TEXTURE_CONSUME_ROWS_INL_H_
#endif

#include <hwy/highway.h>

#include "image/encode-inl.h"
#include "texture/format/consume-inl.h"
#include "texture/rows.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Fetches the quads of the vector of lookups at i, split or not.
template <class F, class D>
HWY_INLINE void FetchRowQuads(D d, const TexelSource& source, const RowQuads& rows, size_t i,
                              typename F::template Texel<D> (&quad)[4]) {
  if (HWY_UNLIKELY(rows.split[i / hn::Lanes(d)])) {
    typename F::template Texel<D> apart[4];  // a copy, so that the usual quads stay in registers
    F::fetch_split(d, source, rows.upper, rows.other, i, apart);
    for (size_t k = 0; k < 4; ++k) quad[k] = apart[k];
    return;
  }
  F::fetch_rows(d, source, rows.upper + i, rows.down, quad);
}

/// Returns the bilinear value of channel C of the vector of lookups at i.
template <size_t C, class F, class D>
HWY_INLINE hn::Vec<D> BlendRowQuads(D d, const Blend<F, false>& b, const RowQuads& rows, size_t i,
                                    const typename F::template Texel<D> (&quad)[4]) {
  const auto s = hn::Load(d, rows.s + i), t = hn::Load(d, rows.t + i);
  const auto top = b.blend(d, F::template decode<C>(d, quad[0]), F::template decode<C>(d, quad[1]), s);
  const auto bottom = b.blend(d, F::template decode<C>(d, quad[2]), F::template decode<C>(d, quad[3]), s);
  return b.blend(d, top, bottom, t);
}

/// Writes a vector of opaque pixels from their codes.
template <class V>
HWY_INLINE void StoreOpaque(V codes, uint32_t* pixels) {
  const hn::RebindToUnsigned<BatchTag> du;
  hn::StoreU(hn::Or(codes, hn::Set(du, 0xff000000u)), du, pixels);
}

/// Writes a vector of opaque pixels, as image::encode_pixels() does.
template <class V>
HWY_INLINE void StorePixels(const V (&color)[3], uint32_t* pixels) {
  StoreOpaque(image::HWY_NAMESPACE::Unorm8Codes<3>(color), pixels);
}

/// Writes a vector of opaque pixels from blends of the Format F.
template <class F, class V>
HWY_INLINE void StoreFinished(V r, V g, V b, uint32_t* pixels) {
  const BatchTag d;
  StorePixels({F::template finish<0>(d, r), F::template finish<1>(d, g), F::template finish<2>(d, b)}, pixels);
}
template <class F, class V>
HWY_NOINLINE void StoreNearTie(V r, V g, V b, uint32_t* pixels) {
  StoreFinished<F>(r, g, b, pixels);
}

/// Writes opaque pixels whose channels are codes of 8 bits before rounding, with the bits of StorePixels(). A value in
/// 0..1 is the code over 255 with an error below 2^-15 codes, so the nearest code is that of the blend itself unless it
/// lies within 2^-13 of a tie. The sum is a multiple of 2^-15, with the code in the bits 15..22.
template <class F, class V>
HWY_INLINE void StoreCodes(const V (&code)[3], uint32_t* pixels) {
  using image::HWY_NAMESPACE::CodeAtByte;
  const BatchTag d;
  const hn::RebindToUnsigned<BatchTag> du;
  const auto below = hn::Set(du, 0x7ff8u);
  hn::Vec<decltype(du)> bits[3];
  for (size_t c = 0; c < 3; ++c) bits[c] = hn::BitCast(du, code[c] + hn::Set(d, 256.5f + 0x1p-13f));
  const auto least = hn::Min(hn::Min(hn::And(bits[0], below), hn::And(bits[1], below)), hn::And(bits[2], below));
  if (HWY_UNLIKELY(!hn::AllFalse(du, hn::Eq(least, hn::Zero(du)))))
    return StoreNearTie<F>(code[0], code[1], code[2], pixels);
  StoreOpaque(hn::Or(hn::Or(CodeAtByte<0>(bits[0]), CodeAtByte<1>(bits[1])), CodeAtByte<2>(bits[2])), pixels);
}

/// Blends the quads of both levels of vectors of lookups.
template <class F>
struct RowBlend {
  using D = BatchTag;
  using V = hn::Vec<D>;

  const RowStream& rows;
  const TexelSource source;
  const Blend<F, false> blend;

  /// Sets the channels of `wanted` of the vector of lookups at i.
  template <class Wanted>
  HWY_INLINE void At(size_t i, const Wanted& wanted, V (&value)[4]) const {
    const D d;
    typename F::template Texel<D> quad[4];
    FetchRowQuads<F>(d, source, rows.quads[0], i, quad);
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { value[c] = BlendRowQuads<c>(d, blend, rows.quads[0], i, quad); });
    if (!rows.blended) return;
    FetchRowQuads<F>(d, source, rows.quads[1], i, quad);
    const auto fraction = hn::Load(d, rows.fraction + i);
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
      value[c] = blend.blend(d, value[c], BlendRowQuads<c>(d, blend, rows.quads[1], i, quad), fraction);
    });
  }
};

/// The channels of opaque pixels.
struct ColorChannels {
  template <class Body>
  HWY_INLINE void for_each(const Body& body) const {
    body(std::integral_constant<size_t, 0>());
    body(std::integral_constant<size_t, 1>());
    body(std::integral_constant<size_t, 2>());
  }
};

/// Where the colours of a block go: opaque pixels, or three columns, of which `left` elements may be written.
struct ColorOutput {
  uint32_t* pixels;
  float* channel[3];
  size_t left;
};

/// Blends the quads of a block and writes colours without alpha.
template <class F>
HWY_NOINLINE void WriteColors(const RowBlend<F>& blend, const ColorOutput& to) {
  const BatchTag d;
  uint32_t* const pixels = to.pixels;
  for (size_t i = 0; i < blend.rows.count; i += hn::Lanes(d)) {
    hn::Vec<BatchTag> value[4];
    blend.At(i, ColorChannels(), value);
    if (!pixels) {
      ColorChannels().for_each([&](auto c) SHD_INLINE_LAMBDA {
        StoreFirst(d, Blend<F, false>::template finish<c>(d, value[c]), to.left - i, to.channel[c] + i);
      });
    } else if constexpr (F::kCodes8) {
      StoreCodes<F>({value[0], value[1], value[2]}, pixels + i);
    } else {
      StoreFinished<F>(value[0], value[1], value[2], pixels + i);
    }
  }
}

/// Blends the quads of a block and writes values of the Format F; a ConsumeRows.
template <class F>
void ConsumeRowsOf(const RowStream& rows, Consumption* consumption) {
  const BatchTag d;
  const RowBlend<F> blend = {rows, consumption->texels, Blend<F, false>(*consumption)};
  const Texels& out = consumption->out;
  const size_t done = consumption->done, left = consumption->count - done;
  if (out.rgba8) return WriteColors(blend, {out.rgba8 + done, {}, left});
  const WantedChannels wanted = WantedBy<Blend<F, false>>(out);
  if (out.channel[0] && out.channel[1] && out.channel[2] && !out.channel[3]) {
    return WriteColors(blend, {nullptr, {out.channel[0] + done, out.channel[1] + done, out.channel[2] + done}, left});
  }
  for (size_t i = 0; i < rows.count; i += hn::Lanes(d)) {
    hn::Vec<BatchTag> value[4] = {};
    blend.At(i, wanted, value);
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
      StoreFirst(d, Blend<F, false>::template finish<c>(d, value[c]), left - i, out.channel[c] + done + i);
    });
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_CONSUME_ROWS_INL_H_
