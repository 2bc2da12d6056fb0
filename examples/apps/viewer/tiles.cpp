// SPDX-License-Identifier: MIT
#include "tiles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace viewer {
namespace {

constexpr int kSteps = 4095;

using Codes = std::array<uint8_t, kSteps + 1>;

Codes make_codes(bool is_light) {
  Codes codes{};
  for (int i = 0; i <= kSteps; ++i) {
    const float x = float(i) / kSteps;
    const float light = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
    codes[size_t(i)] = static_cast<uint8_t>(std::lround(255.0f * (is_light ? light : x)));
  }
  return codes;
}

uint8_t code_of(const Codes& codes, float x) {
  return codes[x > 0.0f ? static_cast<size_t>(std::min(x, 1.0f) * kSteps + 0.5f) : 0];
}

}  // namespace

void Tiles::begin(uint32_t width, uint32_t height, int side, bool is_light) {
  const std::lock_guard<std::mutex> lock(mutex_);
  image_.width = width, image_.height = height, image_.side = side;
  image_.pixels.assign(size_t{4} * width * height, 0);
  is_light_ = is_light;
  ++version_;
}

void Tiles::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (image_.width == 0) return;
  image_ = TileImage();
  ++version_;
}

bool Tiles::take(uint64_t& version, TileImage& out) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (version == version_) return false;
  version = version_;
  out = image_;
  return true;
}

shd_result Tiles::add(const shd_present_tile* tile, void* user_data) {
  static const Codes light = make_codes(true), numbers = make_codes(false);
  auto* const self = static_cast<Tiles*>(user_data);
  const std::lock_guard<std::mutex> lock(self->mutex_);
  TileImage& image = self->image_;
  const shd_region area = tile->area;
  if (area.x + area.width > image.width || area.y + area.height > image.height) return SHD_OK;
  const Codes& codes = self->is_light_ ? light : numbers;
  const size_t stride = tile->row_stride / sizeof(float);
  for (uint32_t y = 0; y < area.height; ++y) {
    uint8_t* to = &image.pixels[4 * (size_t{area.y + y} * image.width + area.x)];
    for (uint32_t x = 0; x < area.width; ++x, to += 4) {
      for (size_t c = 0; c < 3; ++c) to[c] = code_of(codes, tile->channel[c][y * stride + x]);
      to[3] = 255;
    }
  }
  ++self->version_;
  return SHD_OK;
}

}  // namespace viewer
