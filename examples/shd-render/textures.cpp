// SPDX-License-Identifier: MIT
#include "textures.h"

#include <algorithm>
#include <cmath>

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

/// Rounds 16-bit channels to 8 bits, because textures have no 16-bit integer format. The sRGB curve is kept.
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

shd_load_desc load_desc_of(const TextureSource& source) {
  shd_load_desc desc = shd_load_desc_default();
  if (source.data) desc.color_space = SHD_COLOR_ENCODING_DATA;
  return desc;
}

/// Loads a whole image file that is embedded in the model.
shd_result load_embedded(shd_context* context, const TextureSource& source, Texture& out) {
  Bitmap bitmap;
  shd_image image = shd_image_default();
  const shd_load_desc desc = load_desc_of(source);
  shd_result result = shd_bitmap_load_memory(context, source.file.data(), source.file.size(), &desc, bitmap.out());
  if (result == SHD_OK) result = shd_bitmap_image(bitmap.get(), &image);
  if (result != SHD_OK) return result;
  if (image.format == SHD_FORMAT_RGBA16) {
    const std::vector<unsigned char> texels = narrow(image);
    return create_texture(context, source.data ? SHD_FORMAT_RGBA8 : SHD_FORMAT_RGBA8_SRGB, image.width, image.height,
                          texels.data(), 0, out);
  }
  return create_texture(context, image.format, image.width, image.height, image.pixels, image.row_stride, out);
}

}  // namespace

bool load_texture(shd_context* context, const TextureSource& source, Texture& out) {
  if (!source.file.empty()) return load_embedded(context, source, out) == SHD_OK;
  if (!source.rgba.empty()) {
    const shd_format format = source.data ? SHD_FORMAT_RGBA8 : SHD_FORMAT_RGBA8_SRGB;
    return create_texture(context, format, source.width, source.height, source.rgba.data(), 0, out) == SHD_OK;
  }
  const shd_load_desc desc = load_desc_of(source);
  return shd_texture_load(context, source.path.c_str(), &desc, out.out()) == SHD_OK;
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

Texture make_window(shd_context* context) {
  constexpr uint32_t kSize = 256;
  std::vector<unsigned char> texels;
  for (uint32_t y = 0; y < kSize; ++y) {
    for (uint32_t x = 0; x < kSize; ++x) {
      const auto bar = [](uint32_t c) { return c < 40 || c >= 216 || (c >= 122 && c < 134); };
      const unsigned char warm[4] = {255, 236, 200, 255}, cool[4] = {190, 215, 255, 255}, dark[4] = {8, 8, 10, 255};
      const unsigned char* texel = bar(x) || bar(y) ? dark : (x < 128) == (y < 128) ? warm : cool;
      texels.insert(texels.end(), texel, texel + 4);
    }
  }
  Texture texture;
  check(create_texture(context, SHD_FORMAT_RGBA8_SRGB, kSize, kSize, texels.data(), 0, texture), "window");
  return texture;
}

Texture make_matcap(shd_context* context) {
  constexpr uint32_t kSize = 256;
  std::vector<float> texels;
  for (uint32_t y = 0; y < kSize; ++y) {
    for (uint32_t x = 0; x < kSize; ++x) {
      float nx = (static_cast<float>(x) + 0.5f) / (0.5f * kSize) - 1.0f;
      float ny = 1.0f - (static_cast<float>(y) + 0.5f) / (0.5f * kSize);
      const float outside = std::max(1.0f, std::sqrt(nx * nx + ny * ny));
      nx /= outside, ny /= outside;
      const float nz = std::sqrt(std::max(0.0f, 1.0f - nx * nx - ny * ny));
      const float key = std::max(0.0f, -0.45f * nx + 0.6f * ny + 0.66f * nz);
      const float rim = std::pow(1.0f - nz, 3.0f) * std::max(0.0f, 0.6f + 0.8f * nx);
      const float glow = std::pow(key, 40.0f), ground = 0.5f - 0.5f * ny;
      texels.push_back(0.55f * key + 0.30f * ground * ground + 0.2f * rim + 1.2f * glow);
      texels.push_back(0.24f * key + 0.10f * ground * ground + 0.4f * rim + 1.1f * glow);
      texels.push_back(0.13f * key + 0.05f * ground * ground + 0.8f * rim + 1.0f * glow);
      texels.push_back(1.0f);
    }
  }
  Texture texture;
  check(create_texture(context, SHD_FORMAT_RGBA32F, kSize, kSize, texels.data(), 0, texture), "matcap");
  return texture;
}
