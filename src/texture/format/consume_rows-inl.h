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
    quad[0] = F::fetch(d, source, rows.upper + i);
    for (size_t k = 0; k < 3; ++k) quad[k + 1] = F::fetch(d, source, rows.other[k] + i);
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

/// Writes a vector of opaque pixels, as image::encode_pixels() does.
template <class V>
HWY_INLINE void StorePixels(const V (&color)[3], uint32_t* pixels) {
  const hn::RebindToUnsigned<BatchTag> du;
  hn::StoreU(hn::Or(image::HWY_NAMESPACE::Unorm8Codes<3>(color), hn::Set(du, 0xff000000u)), du, pixels);
}

/// Blends the quads of a block and writes values of the Format F; a ConsumeRows.
template <class F>
void ConsumeRowsOf(const RowStream& rows, Consumption* consumption) {
  using D = BatchTag;
  const D d;
  const TexelSource source = consumption->texels;
  const Blend<F, false> b(*consumption);
  const WantedChannels wanted = WantedBy<Blend<F, false>>(consumption->out);
  const Texels& out = consumption->out;
  const size_t done = consumption->done, left = consumption->count - done;
  for (size_t i = 0; i < rows.count; i += hn::Lanes(d)) {
    typename F::template Texel<D> quad[4];
    hn::Vec<D> value[4] = {};
    FetchRowQuads<F>(d, source, rows.quads[0], i, quad);
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { value[c] = BlendRowQuads<c>(d, b, rows.quads[0], i, quad); });
    if (rows.blended) {
      FetchRowQuads<F>(d, source, rows.quads[1], i, quad);
      const auto fraction = hn::Load(d, rows.fraction + i);
      wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
        value[c] = b.blend(d, value[c], BlendRowQuads<c>(d, b, rows.quads[1], i, quad), fraction);
      });
    }
    if (out.rgba8) {
      const hn::Vec<D> color[3] = {b.template finish<0>(d, value[0]), b.template finish<1>(d, value[1]),
                                   b.template finish<2>(d, value[2])};
      StorePixels(color, out.rgba8 + done + i);
      continue;
    }
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
      StoreFirst(d, b.template finish<c>(d, value[c]), left - i, out.channel[c] + done + i);
    });
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_CONSUME_ROWS_INL_H_
