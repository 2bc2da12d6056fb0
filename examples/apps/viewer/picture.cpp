// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>

#include <shd/io.h>

namespace viewer {

std::vector<uint8_t> compose(const Picture& picture, uint32_t divider) {
  if (!picture.side[0]) return {};
  const Image& a = *picture.side[0];
  std::vector<uint8_t> pixels = a.display;
  if (!picture.side[1]) return pixels;
  const size_t row = size_t{4} * a.width, first = size_t{4} * std::min(divider, a.width);
  for (uint32_t y = 0; y < a.height; ++y) {
    const auto from = picture.side[1]->display.begin() + static_cast<std::ptrdiff_t>(y * row);
    std::copy(from + static_cast<std::ptrdiff_t>(first), from + static_cast<std::ptrdiff_t>(row),
              pixels.begin() + static_cast<std::ptrdiff_t>(y * row + first));
  }
  return pixels;
}

Pixel first_magnified(Pixel middle, uint32_t width, uint32_t height) {
  const auto first = [](uint32_t at, uint32_t count, uint32_t size) {
    const uint32_t last = size > count ? size - count : 0;
    return std::min(at > count / 2 ? at - count / 2 : 0, last);
  };
  return {first(middle.x, kMagnifiedColumns, width), first(middle.y, kMagnifiedRows, height)};
}

MagnifierLayout magnifier_layout(const Rect& viewport, float scale) {
  MagnifierLayout layout = {};
  layout.cell = static_cast<int>(46.0f * scale);
  layout.margin = static_cast<int>(10.0f * scale);
  layout.line = static_cast<int>(24.0f * scale);
  layout.x = viewport.x + 2 * layout.margin;
  layout.y = viewport.y + viewport.height - layout.cell * kMagnifiedRows - layout.line - 2 * layout.margin;
  return layout;
}

std::string save_pixels(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height, const std::string& path) {
  std::vector<uint8_t> copy = pixels;  // shd_image has no read-only pixels
  shd::image image;
  image.format = SHD_FORMAT_RGBA8_SRGB;
  image.width = width, image.height = height;
  image.pixels = copy.data();
  const shd::save_desc desc;
  return shd_image_save(&image, path.c_str(), &desc) == SHD_OK ? "" : path + ": " + shd_last_error();
}

std::string save_viewport(const Picture& picture, uint32_t divider, const std::string& path) {
  if (!picture.side[0]) return path + ": there is no picture";
  return save_pixels(compose(picture, divider), picture.side[0]->width, picture.side[0]->height, path);
}

uint64_t hash_of(const std::vector<uint8_t>& bytes) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  return hash;
}

}  // namespace viewer
