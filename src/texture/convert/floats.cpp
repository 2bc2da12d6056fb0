// SPDX-License-Identifier: MIT
#include "texture/convert/floats.h"

#include <algorithm>

#include "image/format.h"
#include "projection/projection.h"
#include "texture/format/texel_codec.h"

namespace shd::texture {

void decode_pixels(shd_format format, const uint8_t* pixel, ptrdiff_t step, uint32_t count, float* rgba) {
  const image::FormatInfo info = image::format_info(format);
  const TexelCodec& codec = codec_of(info.component, info.channels);
  for (uint32_t x = 0; x < count; ++x, rgba += 4) {
    double value[4];
    codec.load(pixel + static_cast<ptrdiff_t>(x) * step, 1, value);
    rgba[0] = rgba[1] = rgba[2] = 0.0f, rgba[3] = 1.0f;
    for (size_t c = 0; c < codec.channels; ++c) rgba[c] = static_cast<float>(value[c] / codec.one[c]);
  }
}

void allocate(const core::Allocator& allocator, DirectionFloats* out) {
  const size_t texels = size_t{out->width} * out->height * projection::face_count(out->projection);
  out->texels = core::Array<float>(allocator, core::checked_mul(texels, 4) + kFloatPadding);
  std::fill_n(out->texels.data() + 4 * texels, kFloatPadding, 0.0f);
}

void borrow(const core::Context& context, const DirectionFloats& image, Texture* out) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGBA32F;
  desc.width = image.width, desc.height = image.height, desc.layers = projection::face_count(image.projection);
  desc.projection = image.projection;
  desc.texels = image.texels.data();
  desc.flags = SHD_TEXTURE_BORROW;
  build(context, desc, out);
}

Sampler sampler_of(shd_filter filter) {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  return make_sampler(desc);
}

}  // namespace shd::texture
