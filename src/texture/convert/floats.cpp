// SPDX-License-Identifier: MIT
#include "texture/convert/floats.h"

#include <algorithm>

#include "projection/projection.h"

namespace shd::texture {

void allocate(const core::Allocator& allocator, DirectionFloats* out) {
  const size_t texels = size_t{out->width} * out->height * projection::face_count(out->projection);
  out->texels = core::Array<float>(allocator, core::checked_mul(texels, 4) + kFloatPadding);
  std::fill_n(out->texels.data() + 4 * texels, kFloatPadding, 0.0f);
}

void borrow(const core::Context& context, const DirectionFloats& image, Texture* out) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGBA32F;
  desc.width = image.width, desc.height = image.height, desc.layer_count = projection::face_count(image.projection);
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
