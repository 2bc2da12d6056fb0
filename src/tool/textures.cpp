// SPDX-License-Identifier: MIT
#include "tool/textures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "command/failure.h"

namespace {

shd_result create_texture(shd_context* context, shd_format format, uint32_t width, uint32_t height, const void* texels,
                          uint32_t tables, Texture& out) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.texels = texels;
  desc.tables = tables;
  return shd_texture_create(context, &desc, out.out());
}

}  // namespace

uint32_t tables_of(shd_filter filter) {
  if (filter == SHD_FILTER_RIPMAP) return SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP;
  if (filter == SHD_FILTER_SUMMED_AREA) return SHD_TABLE_MIPMAP | SHD_TABLE_SUMMED_AREA;
  return SHD_TABLE_MIPMAP;
}

Texture load_texture(shd_context* context, const std::string& path, bool data, uint32_t tables) {
  shd_load_desc desc = shd_load_desc_default();
  if (data) desc.encoding = SHD_COLOR_ENCODING_DATA;
  desc.tables = tables;
  Texture texture;
  if (shd_texture_load(context, path.c_str(), &desc, texture.out()) != SHD_OK) {
    throw Failure(kExitInput, path + ": " + shd_last_error());
  }
  return texture;
}

Texture make_checker(shd_context* context, uint32_t tables) {
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
  check(create_texture(context, SHD_FORMAT_RGBA8_SRGB, kSize, kSize, texels.data(), tables, texture), "checker");
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
  check(create_texture(context, SHD_FORMAT_RGBA8_SRGB, kSize, kSize, texels.data(), SHD_TABLE_MIPMAP, texture),
        "window");
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
  check(create_texture(context, SHD_FORMAT_RGBA32F, kSize, kSize, texels.data(), SHD_TABLE_MIPMAP, texture), "matcap");
  return texture;
}
