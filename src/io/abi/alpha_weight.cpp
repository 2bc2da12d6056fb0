// SPDX-License-Identifier: MIT
// Textures without fringes of invisible texels.
#include <shd/mip.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "io/abi/common.h"
#include "io/abi/linear_texels.h"
#include "io/abi/loads.h"
#include "io/bitmap/levels.h"

namespace shd::extension {

namespace {

/// A mip level in memory.
struct Level {
  uint32_t width, height;
  unsigned char* pixels;
};

/// Mean colour of the visible texels around (x, y), weighted by alpha. Returns false if there is none.
bool visible_around(shd_format format, const Level& level, size_t pixel, uint32_t x, uint32_t y, Rgba* out) {
  Rgba sum = {};
  double weight = 0;
  for (uint32_t v = y - (y > 0); v <= std::min(y + 1, level.height - 1); ++v) {
    for (uint32_t u = x - (x > 0); u <= std::min(x + 1, level.width - 1); ++u) {
      const Rgba texel = load_texel(format, level.pixels + (size_t{v} * level.width + u) * pixel);
      if (!(texel.value[3] > 0)) continue;
      for (size_t c = 0; c < 3; ++c) sum.value[c] += texel.value[c] * texel.value[3];
      weight += texel.value[3];
    }
  }
  for (size_t c = 0; c < 3; ++c) out->value[c] = sum.value[c] / weight;
  return weight > 0;
}

/// Gives texels of alpha 0 a colour; `coarser` may be null.
void fill_invisible(shd_format format, const Level& level, const Level* coarser, size_t pixel) {
  for (uint32_t y = 0; y < level.height; ++y) {
    for (uint32_t x = 0; x < level.width; ++x) {
      unsigned char* const to = level.pixels + (size_t{y} * level.width + x) * pixel;
      if (load_texel(format, to).value[3] > 0) continue;
      Rgba color;
      if (!visible_around(format, level, pixel, x, y, &color)) {
        if (!coarser) continue;
        const uint32_t u = std::min(x / 2, coarser->width - 1), v = std::min(y / 2, coarser->height - 1);
        color = load_texel(format, coarser->pixels + (size_t{v} * coarser->width + u) * pixel);
      }
      store_texel(format, color, 3, to);
    }
  }
}

}  // namespace

void weight_by_alpha(shd_context* context, bool keep_levels, io::Bitmap* bitmap) {
  const size_t pixel = io::bitmap_pixel_size(bitmap->format);
  if (is_opaque(*bitmap)) return;
  const uint32_t count = io::full_level_count(bitmap->width, bitmap->height);
  const auto all = static_cast<size_t>(io::level_pixels(bitmap->width, bitmap->height, count));
  io::Buffer pixels(memory_of(context), all * pixel);
  std::memcpy(pixels.data(), bitmap->pixels.data(), size_t{bitmap->width} * bitmap->height * pixel);
  std::vector<Level> levels;
  std::vector<shd_image> images;
  unsigned char* next = pixels.data();
  for (uint32_t l = 0; l < count; ++l) {
    const Level level = {io::level_side(bitmap->width, l), io::level_side(bitmap->height, l), next};
    levels.push_back(level);
    shd_image image = shd_image_default();
    image.format = bitmap->format;
    image.width = level.width;
    image.height = level.height;
    image.pixels = level.pixels;
    images.push_back(image);
    next += size_t{level.width} * level.height * pixel;
  }
  shd_mip_desc desc = shd_mip_desc_default();
  desc.content = SHD_TEXEL_CONTENT_ALPHA_WEIGHTED;
  require(shd_mip_build(context, &images[0], &desc, count - 1, images.data() + 1));
  for (uint32_t l = count; l-- > 0;) {
    fill_invisible(bitmap->format, levels[l], l + 1 < count ? &levels[l + 1] : nullptr, pixel);
  }
  bitmap->pixels = std::move(pixels);
  bitmap->level_count = keep_levels ? count : 1;
}

}  // namespace shd::extension
