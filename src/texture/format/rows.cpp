// SPDX-License-Identifier: MIT
// Consumers of rows of quads, for samplers without border colour. Formats of floats have none: most of their time goes
// into blends, and their code would be as long as that of all other formats.
#include "texture/rows.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume_rows-inl.h"
#include "texture/format/fixed-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/formats.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace {

/// Blends the quads of a block in 16 bits and writes values of 8-bit unorm texels; a ConsumeRows. kOdd: the texture has
/// channels 1 and 3.
template <bool kOdd>
void ConsumeFixedRows(const RowStream& rows, Consumption* consumption) {
  using D = BatchTag;
  const D d;
  const TexelSource source = consumption->texels;
  const Texels& out = consumption->out;
  const WantedChannels wanted = {
      {out.channel[0] != nullptr, kOdd && out.channel[1], out.channel[2] != nullptr, kOdd && out.channel[3]}};
  const size_t done = consumption->done, left = consumption->count - done;
  const auto blend = [&](const RowQuads& quads, size_t i) SHD_INLINE_LAMBDA {
    Ints<D> texel[4];
    FetchRowQuads<Unorm8>(d, source, quads, i, texel);
    return BlendQuad<kOdd>(d, texel, FixedFraction(d, hn::Load(d, quads.s + i)),
                           FixedFraction(d, hn::Load(d, quads.t + i)));
  };
  for (size_t i = 0; i < rows.count; i += hn::Lanes(d)) {
    ChannelPairs<D> value = blend(rows.quads[0], i);
    if (rows.blended) {
      const ChannelPairs<D> second = blend(rows.quads[1], i);
      const auto fraction = FixedFraction(d, hn::Load(d, rows.fraction + i));
      value.even = MixHalves(value.even, second.even, fraction);
      if constexpr (kOdd) value.odd = MixHalves(value.odd, second.odd, fraction);
    }
    if (out.rgba8) {
      hn::StoreU(PixelsOf(d, value), hn::RebindToUnsigned<D>(), out.rgba8 + done + i);
      continue;
    }
    value = {WithoutTies(value.even), WithoutTies(value.odd)};
    wanted.for_each([&](auto c)
                        SHD_INLINE_LAMBDA { StoreFirst(d, UnitOf<c>(d, value), left - i, out.channel[c] + done + i); });
  }
}

}  // namespace

ConsumeRows RowsOf(image::Component component) {
  switch (component) {
    case image::Component::kUnorm8: return ConsumeRowsOf<Unorm8>;
    case image::Component::kSrgb8: return ConsumeRowsOf<Srgb8>;
    case image::Component::kUnorm16: return ConsumeRowsOf<Unorm16>;
    default: return nullptr;
  }
}

ConsumeRows FixedRowsOf(uint32_t channels) {
  return channels == 1 ? ConsumeFixedRows<false> : ConsumeFixedRows<true>;
}

void EncodePixels(const Texels& out, size_t first, size_t count) {
  const BatchTag d;
  for (size_t i = first; i < first + count; i += hn::Lanes(d)) {
    hn::Vec<BatchTag> color[3];
    for (size_t c = 0; c < 3; ++c) color[c] = simd::HWY_NAMESPACE::LoadFirst(d, out.channel[c] + i, first + count - i);
    StorePixels(color, out.rgba8 + i);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
