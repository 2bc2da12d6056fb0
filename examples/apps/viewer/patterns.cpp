// SPDX-License-Identifier: MIT
#include "patterns.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <shd/io.h>

namespace viewer {
namespace {

struct Rgb {
  float r, g, b;
};

Rgb mix(Rgb a, Rgb b, float s) {
  return {a.r + s * (b.r - a.r), a.g + s * (b.g - a.g), a.b + s * (b.b - a.b)};
}

/// 1 inside, 0 outside of an edge at 0, over one unit.
float inside(float distance) {
  return std::clamp(0.5f - distance, 0.0f, 1.0f);
}

template <class Pattern>
shd::texture make_texture(shd_context* context, uint32_t size, shd_table_flags tables, Pattern pattern) {
  std::vector<unsigned char> texels(size_t{4} * size * size, 255);
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const Rgb color = pattern((float(x) + 0.5f) / float(size), (float(y) + 0.5f) / float(size));
      const float channel[3] = {color.r, color.g, color.b};
      for (size_t c = 0; c < 3; ++c) {
        texels[4 * (size_t{y} * size + x) + c] = static_cast<unsigned char>(std::lround(255.0f * channel[c]));
      }
    }
  }
  shd::texture_desc desc;
  desc.format = SHD_FORMAT_RGBA8_SRGB;
  desc.width = desc.height = size;
  desc.texels = texels.data();
  desc.tables = tables;
  return shd::texture_create(context, &desc);
}

float fraction(float x) {
  return x - std::floor(x);
}

/// Radiance of the studio in a direction.
Rgb studio(float x, float y, float z) {
  const float up = 0.5f + 0.5f * y;
  Rgb light = mix({0.15f, 0.14f, 0.135f}, {0.44f, 0.47f, 0.52f}, up * up * (3.0f - 2.0f * up));
  struct Panel {
    float x, y, z, half, power;
    Rgb color;
  };
  constexpr Panel kPanels[] = {{-0.62f, 0.62f, 0.48f, 0.34f, 16.0f, {1.0f, 0.96f, 0.90f}},
                               {0.86f, 0.35f, 0.37f, 0.26f, 6.0f, {0.86f, 0.93f, 1.0f}},
                               {0.10f, 0.55f, -0.83f, 0.30f, 4.0f, {1.0f, 1.0f, 1.0f}}};
  for (const Panel& panel : kPanels) {
    const float facing = x * panel.x + y * panel.y + z * panel.z;
    if (facing <= 0.1f) continue;
    // Coordinates on the plane of the panel: across is horizontal, along is the rest of the way.
    const float across = (x * panel.z - z * panel.x) / facing / std::hypot(panel.x, panel.z);
    const float along = y / facing - panel.y;
    const float edge = std::max(std::abs(across), std::abs(along) / 1.3f) - panel.half;
    const float share = panel.power * inside(14.0f * edge);
    light = {light.r + share * panel.color.r, light.g + share * panel.color.g, light.b + share * panel.color.b};
  }
  return light;
}

}  // namespace

shd::texture make_porcelain(shd_context* context, shd_table_flags tables) {
  return make_texture(context, 512, tables, [](float u, float v) {
    constexpr float kCells = 4.0f;
    const Rgb white = {0.955f, 0.945f, 0.915f}, blue = {0.085f, 0.20f, 0.50f}, pale = {0.46f, 0.60f, 0.80f};
    const float x = fraction(kCells * u) - 0.5f, y = fraction(kCells * v) - 0.5f;
    const float r = std::hypot(x, y), angle = std::atan2(y, x);
    const float scale = 512.0f / kCells;
    const float petal = r - (0.16f + 0.10f * std::cos(4.0f * angle));
    const float ring = std::abs(r - 0.36f) - 0.012f;
    const float corner = std::hypot(0.5f - std::abs(x), 0.5f - std::abs(y)) - 0.085f;
    const float lattice = std::abs(std::abs(x) + std::abs(y) - 0.5f) - 0.010f;
    Rgb color = mix(white, pale, 0.55f * inside(scale * (r - 0.36f)));
    color = mix(color, blue, inside(scale * std::min({petal, ring, corner, lattice})));
    return mix(color, white, inside(scale * (r - 0.05f)));
  });
}

shd::texture make_tiles(shd_context* context, shd_table_flags tables) {
  return make_texture(context, 512, tables, [](float u, float v) {
    const int column = static_cast<int>(4.0f * u), row = static_cast<int>(4.0f * v);
    const bool dark = (column + row) % 2 != 0;
    const float x = fraction(4.0f * u) - 0.5f, y = fraction(4.0f * v) - 0.5f;
    const float to_edge = 0.5f - std::max(std::abs(x), std::abs(y));
    const float shade = 0.03f * std::sin(12.9898f * float(column) + 78.233f * float(row));
    const Rgb tile =
        dark ? Rgb{0.20f + shade, 0.25f + shade, 0.31f + shade} : Rgb{0.86f + shade, 0.82f + shade, 0.75f + shade};
    const Rgb joint = {0.50f, 0.47f, 0.43f};
    const Rgb inlay = dark ? Rgb{0.78f, 0.66f, 0.44f} : Rgb{0.58f, 0.30f, 0.24f};
    const float diamond = std::abs(x) + std::abs(y) - 0.11f;
    return mix(mix(tile, joint, inside(128.0f * (to_edge - 0.02f))), inlay, inside(90.0f * diamond));
  });
}

shd::environment make_studio(shd_context* context) {
  constexpr uint32_t kWidth = 256, kHeight = 128;
  constexpr float kPi = 3.14159265f;
  std::vector<float> pixels;
  for (uint32_t row = 0; row < kHeight; ++row) {
    for (uint32_t column = 0; column < kWidth; ++column) {
      const float u = (float(column) + 0.5f) / kWidth, v = (float(row) + 0.5f) / kHeight;
      const float longitude = 2.0f * kPi * (u - 0.5f),
                  sine = std::sin(kPi * v);  // the middle is +Z, the right is -X
      const Rgb light = studio(-sine * std::sin(longitude), std::cos(kPi * v), sine * std::cos(longitude));
      pixels.insert(pixels.end(), {light.r, light.g, light.b});
    }
  }
  shd::image image;
  image.format = SHD_FORMAT_RGB32F;
  image.width = kWidth, image.height = kHeight;
  image.pixels = pixels.data();
  shd::environment_desc desc;
  desc.image = &image;
  return shd::environment_create(context, &desc);
}

shd::environment load_environment(shd_context* context, const std::string& path) {
  const shd::load_desc load;
  const shd::bitmap bitmap = shd::bitmap_load(context, path.c_str(), &load);
  const shd_image image = shd::bitmap_get_image(bitmap);
  shd::environment_desc desc;
  desc.image = &image;
  return shd::environment_create(context, &desc);
}

}  // namespace viewer
