// SPDX-License-Identifier: MIT
#include "film/readback.h"

#include <cstring>

#include "data/column.h"
#include "image/pixels.h"

namespace shd::film {
namespace {

template <class T, class Column>
void read_rows(const Framebuffer& framebuffer, const T* plane, const Column& out) {
  const size_t width = framebuffer.width;
  for (size_t y = 0; y < framebuffer.height; ++y) {
    const T* row = plane + y * framebuffer.stride;
    if (data::is_packed(out.stride)) {
      std::memcpy(out.data + y * width, row, width * sizeof(T));
    } else {
      for (size_t x = 0; x < width; ++x) data::store(out, y * width + x, row[x]);
    }
  }
}

/// Calls body(x, y, count, planes) for runs of decoded pixels of a framebuffer with interleaved pixels.
template <class Body>
void for_each_decoded(const Framebuffer& framebuffer, const Body& body) {
  constexpr size_t kRun = 256;
  float decoded[4][kRun];
  float* const planes[4] = {decoded[0], decoded[1], decoded[2], decoded[3]};
  for (size_t y = 0; y < framebuffer.height; ++y) {
    for (size_t x = 0; x < framebuffer.width; x += kRun) {
      const size_t count = framebuffer.width - x < kRun ? framebuffer.width - x : kRun;
      image::decode_pixels(framebuffer.color_format, pixel_at(framebuffer, x, y), count, planes);
      body(x, y, count, planes);
    }
  }
}

}  // namespace

void read_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_f32_out& out) {
  if (plane >= SHD_PLANE_DEPTH || has_color_planes(framebuffer)) {
    return read_rows(framebuffer, framebuffer.plane[plane].data(), out);
  }
  for_each_decoded(framebuffer, [&](size_t x, size_t y, size_t count, float* const* planes) {
    const size_t first = y * framebuffer.width + x;
    for (size_t i = 0; i < count; ++i) data::store(out, first + i, planes[plane][i]);
  });
}

void read_u32_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_u32_out& out) {
  read_rows(framebuffer, framebuffer.u32_plane[plane].data(), out);
}

void read_color(const core::SimdTarget& simd, const Framebuffer& framebuffer, const shd_image& out) {
  const size_t pixel = shd_format_size(out.format);
  const auto at = [&](size_t x, size_t y) {
    return static_cast<unsigned char*>(out.pixels) + y * out.row_stride + x * pixel;
  };
  if (out.format == framebuffer.color_format && !has_color_planes(framebuffer)) {
    for (size_t y = 0; y < framebuffer.height; ++y) {
      std::memcpy(at(0, y), pixel_at(framebuffer, 0, y), framebuffer.width * pixel);
    }
  } else if (has_color_planes(framebuffer)) {
    for (size_t y = 0; y < framebuffer.height; ++y) {
      const float* row[4];
      for (size_t c = 0; c < 4; ++c) row[c] = framebuffer.plane[c].data() + y * framebuffer.stride;
      image::encode_pixels(simd, out.format, row, framebuffer.width, at(0, y));
    }
  } else {
    for_each_decoded(framebuffer, [&](size_t x, size_t y, size_t count, float* const* planes) {
      image::encode_pixels(simd, out.format, planes, count, at(x, y));
    });
  }
}

}  // namespace shd::film
