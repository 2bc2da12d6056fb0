// SPDX-License-Identifier: MIT
#include "textures.h"

#include "failure.h"

namespace {

shd_result create_texture(shd_context* context, shd_format format, uint32_t width, uint32_t height, const void* texels,
                          size_t row_stride, Texture& out) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.texels = texels;
  desc.row_stride = row_stride;
  desc.tables = SHD_TABLE_MIPMAP;
  return shd_texture_create(context, &desc, out.out());
}

/// 16-bit channels rounded to 8: textures have no 16-bit integer format, and the sRGB curve stays as it is.
std::vector<unsigned char> narrow(const shd_image& image) {
  std::vector<unsigned char> texels;
  const size_t stride = image.row_stride ? image.row_stride : size_t{8} * image.width;
  for (uint32_t y = 0; y < image.height; ++y) {
    const auto* row = reinterpret_cast<const uint16_t*>(static_cast<const char*>(image.pixels) + y * stride);
    for (size_t i = 0; i < size_t{4} * image.width; ++i) {
      texels.push_back(static_cast<unsigned char>((row[i] * 255u + 32767u) / 65535u));
    }
  }
  return texels;
}

/// A whole image file that the model carries.
shd_result load_embedded(shd_context* context, const TextureSource& source, Texture& out) {
  Bitmap bitmap;
  shd_image image = shd_image_default();
  shd_result result = shd_bitmap_load_memory(context, source.file.data(), source.file.size(), nullptr, bitmap.out());
  if (result == SHD_OK) result = shd_bitmap_image(bitmap.get(), &image);
  if (result != SHD_OK) return result;
  if (image.format == SHD_FORMAT_RGBA16) {
    const std::vector<unsigned char> texels = narrow(image);
    return create_texture(context, SHD_FORMAT_RGBA8_SRGB, image.width, image.height, texels.data(), 0, out);
  }
  return create_texture(context, image.format, image.width, image.height, image.pixels, image.row_stride, out);
}

}  // namespace

bool load_texture(shd_context* context, const TextureSource& source, Texture& out) {
  if (!source.file.empty()) return load_embedded(context, source, out) == SHD_OK;
  if (!source.rgba.empty()) {
    return create_texture(context, SHD_FORMAT_RGBA8_SRGB, source.width, source.height, source.rgba.data(), 0, out) ==
           SHD_OK;
  }
  return shd_texture_load(context, source.path.c_str(), nullptr, out.out()) == SHD_OK;
}

Texture make_checker(shd_context* context) {
  constexpr uint32_t kSize = 256, kSquare = 32;
  std::vector<unsigned char> texels;
  for (uint32_t y = 0; y < kSize; ++y) {
    for (uint32_t x = 0; x < kSize; ++x) {
      const bool odd = (x / kSquare + y / kSquare) % 2 != 0;
      const bool mark = x < 2 * kSquare && y < kSquare;
      const unsigned char light[4] = {225, 218, 204, 255}, dark[4] = {38, 84, 124, 255}, red[4] = {214, 64, 40, 255};
      const unsigned char* texel = mark ? red : odd ? dark : light;
      texels.insert(texels.end(), texel, texel + 4);
    }
  }
  Texture texture;
  check(create_texture(context, SHD_FORMAT_RGBA8_SRGB, kSize, kSize, texels.data(), 0, texture), "checker");
  return texture;
}

std::array<float, 3> average_color(shd_context* context, const shd_texture* texture) {
  const float middle = 0.5f, coarsest = 32.0f;
  std::array<float, 3> color{};
  Sampler sampler;
  shd_lookups where = shd_lookups_default();
  shd_texels out{};
  where.count = 1;
  where.u.data = where.v.data = &middle;
  where.lod.data = &coarsest;
  for (size_t c = 0; c < 3; ++c) out.channel[c].data = &color[c];
  check(shd_sampler_create(context, nullptr, sampler.out()), "sampler");
  check(shd_texture_sample(texture, sampler.get(), &where, &out), "average of a texture");
  for (float& c : color) c = c >= 0.0f && c <= 1e6f ? c : 0.0f;
  return color;
}
