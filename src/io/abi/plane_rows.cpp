// SPDX-License-Identifier: MIT
#include "io/abi/plane_rows.h"

#include <algorithm>
#include <cstring>

#include "image/channel.h"
#include "image/dither.h"
#include "image/pixels.h"

namespace shd::io {

namespace {

const float* row_of(const shd_plane_view& view, uint32_t y) {
  return reinterpret_cast<const float*>(reinterpret_cast<const char*>(view.f32) + y * view.row_stride);
}

/// Straight colour of a pixel, in any range.
void straight_color(const CodeRows& rows, uint32_t x, uint32_t y, double out[4]) {
  for (int c = 0; c < 4; ++c) {
    out[c] = static_cast<double>(rows.display ? rows.display[4 * (size_t{y} * rows.width + x) + static_cast<size_t>(c)]
                                              : row_of(rows.plane[c], y)[x]);
  }
  for (int c = 0; c < 3; ++c) {
    if (!rows.display && out[3] > 0) out[c] /= out[3];
    if (!rows.display && rows.curve) out[c] = image::linear_to_srgb(out[c]);
  }
}

template <class Code>
void encode_pixel(const CodeRows& rows, uint32_t x, uint32_t y, unsigned char* out) {
  const double threshold = rows.dither ? image::dither_threshold(x, y) : 0.5;
  double color[4];
  straight_color(rows, x, y, color);
  if (rows.over_black) {
    const double alpha = color[3] > 0 ? std::min(color[3], 1.0) : 0;
    for (int c = 0; c < 3; ++c) color[c] = color[c] > 0 ? std::min(color[c], 1.0) * alpha : 0;
  }
  Code code[4];
  for (int c = 0; c < 4; ++c) code[c] = image::unorm_code<Code>(color[c], c < 3 ? threshold : 0.5);
  std::memcpy(out, code, (rows.over_black ? 3 : 4) * sizeof(Code));
}

/// Encodes a row by vectors, if no pixel needs doubles for more than a division by alpha. Returns whether it did.
bool encode_row(const CodeRows& rows, uint32_t y, unsigned char* out) {
  if (rows.display || rows.dither || rows.over_black || (rows.curve && rows.bits == 16)) return false;
  const float* plane[4];
  for (int c = 0; c < 4; ++c) plane[c] = row_of(rows.plane[c], y);
  const shd_format format = rows.bits == 16 ? SHD_FORMAT_RGBA16 : rows.curve ? SHD_FORMAT_RGBA8_SRGB : SHD_FORMAT_RGBA8;
  image::encode_pixels(rows.simd, format, plane, rows.width, out);
  return true;
}

}  // namespace

void plane_row(const void* plane_rows, uint32_t y, unsigned char* out) {
  const auto& rows = *static_cast<const PlaneRows*>(plane_rows);
  const auto size_of = [](const PlaneChannel& channel) { return channel.sample == Sample::kHalf ? 2u : 4u; };
  size_t pixel = 0;
  for (const PlaneChannel& channel : rows.channels) pixel += size_of(channel);
  for (const PlaneChannel& channel : rows.channels) {
    const void* const first = channel.view.u32 ? static_cast<const void*>(channel.view.u32) : channel.view.f32;
    const char* const row = static_cast<const char*>(first) + y * channel.view.row_stride;
    for (size_t x = 0; x < rows.width; ++x) {
      if (channel.sample == Sample::kHalf) {
        const uint16_t half = image::float_to_half(image::load_as<float>(row + channel.step * x));
        std::memcpy(out + x * pixel, &half, sizeof half);
      } else {
        std::memcpy(out + x * pixel, row + channel.step * x, 4);
      }
    }
    out += size_of(channel);
  }
}

void code_row(const void* code_rows, uint32_t y, unsigned char* out) {
  const auto& rows = *static_cast<const CodeRows*>(code_rows);
  const bool done = encode_row(rows, y, out);
  const uint32_t pixel = (rows.over_black ? 3 : 4) * rows.bits / 8;
  for (uint32_t x = 0; x < rows.width; ++x, out += pixel) {
    const float alpha = done ? row_of(rows.plane[3], y)[x] : 0.0f;
    if (done && !(alpha > 0.0f && alpha != 1.0f)) continue;
    rows.bits == 8 ? encode_pixel<uint8_t>(rows, x, y, out) : encode_pixel<uint16_t>(rows, x, y, out);
  }
}

}  // namespace shd::io
