// SPDX-License-Identifier: MIT
#include "texture/format/texel_codec.h"

#include "texture/format/formats.h"

namespace shd::texture {
namespace {

template <class Codec>
void load(const uint8_t* texels, size_t count, double* numbers) {
  for (size_t i = 0; i < count; ++i) Codec::load(texels + i * Codec::kSize, numbers + i * Codec::kChannels);
}

template <class Codec>
void store(const double* numbers, size_t count, uint8_t* texels) {
  for (size_t i = 0; i < count; ++i) Codec::store(numbers + i * Codec::kChannels, texels + i * Codec::kSize);
}

template <class Codec>
constexpr TexelCodec kCodec = {Codec::kChannels,
                               Codec::kSize,
                               Codec::kFloat,
                               {Codec::one(0), Codec::one(1), Codec::one(2), Codec::one(3)},
                               {Codec::largest(0), Codec::largest(1), Codec::largest(2), Codec::largest(3)},
                               load<Codec>,
                               store<Codec>};

}  // namespace

const TexelCodec& codec_of(image::Component component, size_t channels) {
  const TexelCodec* found = nullptr;
  visit_codec(component, channels, [&](auto codec) { found = &kCodec<decltype(codec)>; });
  return *found;
}

const TexelCodec& codec_of_numbers(shd_format format) {
  const image::FormatInfo info = image::format_info(format);
  const bool is_srgb = info.component == image::Component::kSrgb8;
  return codec_of(is_srgb ? image::Component::kUnorm8 : info.component, info.channels);
}

}  // namespace shd::texture
