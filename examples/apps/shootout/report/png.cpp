// SPDX-License-Identifier: MIT
#include "png.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace shootout {
namespace {

std::string big_endian(uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const uLong crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<uint32_t>(data.size())) + body + big_endian(static_cast<uint32_t>(crc));
}

uint8_t paeth(int left, int above, int corner) {
  const int a = std::abs(above - corner), b = std::abs(left - corner), c = std::abs(left + above - 2 * corner);
  return static_cast<uint8_t>(a <= b && a <= c ? left : b <= c ? above : corner);
}

/// The rows with one filter for all: 0 none, 1 left, 2 above, 4 Paeth.
std::string filtered(const std::vector<uint8_t>& bytes, size_t row, size_t rows, size_t step, int filter) {
  std::string out;
  for (size_t y = 0; y < rows; ++y) {
    out += static_cast<char>(filter);
    for (size_t x = 0; x < row; ++x) {
      const uint8_t* at = &bytes[y * row + x];
      const int left = x >= step ? at[-static_cast<ptrdiff_t>(step)] : 0;
      const int above = y > 0 ? at[-static_cast<ptrdiff_t>(row)] : 0;
      const int corner = x >= step && y > 0 ? at[-static_cast<ptrdiff_t>(row + step)] : 0;
      const int guess = filter == 1 ? left : filter == 2 ? above : filter == 4 ? paeth(left, above, corner) : 0;
      out += static_cast<char>(*at - guess);
    }
  }
  return out;
}

std::string compressed(const std::string& data) {
  uLongf size = compressBound(static_cast<uLong>(data.size()));
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
                static_cast<uLong>(data.size()), 9) != Z_OK) {
    throw std::runtime_error("zlib: compression failed");
  }
  out.resize(size);
  return out;
}

std::string encode(const std::vector<uint8_t>& bytes, uint32_t width, uint32_t height, size_t channels) {
  std::string best;
  for (const int filter : {0, 1, 2, 4}) {
    const std::string data = compressed(filtered(bytes, width * channels, height, channels, filter));
    if (best.empty() || data.size() < best.size()) best = data;
  }
  const std::string header =
      big_endian(width) + big_endian(height) + '\x08' + (channels == 3 ? '\x02' : '\0') + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", best) + chunk("IEND", "");
}

uint8_t byte_of(float value) {
  return static_cast<uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

}  // namespace

std::string png_of(const Picture& picture) {
  std::vector<uint8_t> rgb, grey;
  bool is_grey = true;
  for (size_t i = 0; i < picture.pixels(); ++i) {
    for (size_t c = 0; c < 3; ++c) rgb.push_back(byte_of(picture.rgb[3 * i + c]));
    is_grey = is_grey && rgb[3 * i] == rgb[3 * i + 1] && rgb[3 * i] == rgb[3 * i + 2];
    grey.push_back(rgb[3 * i]);
  }
  return encode(is_grey ? grey : rgb, picture.width, picture.height, is_grey ? 1 : 3);
}

std::string half_png_of(const std::vector<float>& map, uint32_t edge) {
  const uint32_t half = edge / 2;
  std::vector<uint8_t> grey;
  for (uint32_t y = 0; y < half; ++y) {
    for (uint32_t x = 0; x < half; ++x) {
      const float* at = &map[size_t{2 * y} * edge + 2 * x];
      // 32 steps are enough for a map, and halve the file.
      grey.push_back(byte_of(std::round(31.0f * 0.25f * (at[0] + at[1] + at[edge] + at[edge + 1])) / 31.0f));
    }
  }
  return encode(grey, half, half, 1);
}

std::string data_uri(const std::string& png) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:image/png;base64,";
  for (size_t i = 0; i < png.size(); i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < png.size() ? static_cast<uint8_t>(png[i + k]) : 0);
    for (size_t k = 0; k < 4; ++k) text += i + k > png.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

}  // namespace shootout
