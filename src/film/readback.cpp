// SPDX-License-Identifier: MIT
#include "film/readback.h"

#include <cstring>

#include "core/status.h"
#include "data/column.h"
#include "image/half.h"
#include "image/srgb.h"

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

/// Clamps `value` to 0..1 and rounds it to the nearest multiple of 1 / maximum; NaN gives 0. The product is exact in
/// double.
template <class T>
T to_unorm(float value) {
  constexpr double kMaximum = static_cast<T>(-1);
  const double clamped = value > 0.0f ? (value < 1.0f ? static_cast<double>(value) : 1.0) : 0.0;
  return static_cast<T>(clamped * kMaximum + 0.5);
}

/// Conversion of one pixel's channels to a format.
struct Unorm8 {
  using Channel = uint8_t;
  static Channel color(float value) { return to_unorm<uint8_t>(value); }
  static Channel alpha(float value) { return to_unorm<uint8_t>(value); }
};
struct Srgb8 {
  using Channel = uint8_t;
  static Channel color(float value) { return image::linear_to_srgb8(value); }
  static Channel alpha(float value) { return to_unorm<uint8_t>(value); }
};
struct Unorm16 {
  using Channel = uint16_t;
  static Channel color(float value) { return to_unorm<uint16_t>(value); }
  static Channel alpha(float value) { return to_unorm<uint16_t>(value); }
};
struct Half {
  using Channel = uint16_t;
  static Channel color(float value) { return image::float_to_half(value); }
  static Channel alpha(float value) { return image::float_to_half(value); }
};
struct Float {
  using Channel = float;
  static Channel color(float value) { return value; }
  static Channel alpha(float value) { return value; }
};

template <class Pixel>
void read_pixels(const Framebuffer& framebuffer, const shd_image& out) {
  const size_t width = framebuffer.width;
  for (size_t y = 0; y < framebuffer.height; ++y) {
    const size_t first = y * framebuffer.stride;
    const float* r = framebuffer.plane[SHD_PLANE_R].data() + first;
    const float* g = framebuffer.plane[SHD_PLANE_G].data() + first;
    const float* b = framebuffer.plane[SHD_PLANE_B].data() + first;
    const float* a = framebuffer.plane[SHD_PLANE_A].data() + first;
    auto* pixel = reinterpret_cast<typename Pixel::Channel*>(static_cast<char*>(out.pixels) + y * out.row_stride);
    for (size_t x = 0; x < width; ++x, pixel += 4) {
      pixel[0] = Pixel::color(r[x]);
      pixel[1] = Pixel::color(g[x]);
      pixel[2] = Pixel::color(b[x]);
      pixel[3] = Pixel::alpha(a[x]);
    }
  }
}

}  // namespace

void read_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_f32_out& out) {
  read_rows(framebuffer, framebuffer.plane[plane].data(), out);
}

void read_u32_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_u32_out& out) {
  read_rows(framebuffer, framebuffer.u32_plane[plane].data(), out);
}

bool can_read_color(shd_format format) {
  switch (format) {
    case SHD_FORMAT_RGBA8:
    case SHD_FORMAT_RGBA8_SRGB:
    case SHD_FORMAT_RGBA16:
    case SHD_FORMAT_RGBA16F:
    case SHD_FORMAT_RGBA32F: return true;
    default: return false;
  }
}

void read_color(const Framebuffer& framebuffer, const shd_image& out) {
  switch (out.format) {
    case SHD_FORMAT_RGBA8: return read_pixels<Unorm8>(framebuffer, out);
    case SHD_FORMAT_RGBA8_SRGB: return read_pixels<Srgb8>(framebuffer, out);
    case SHD_FORMAT_RGBA16: return read_pixels<Unorm16>(framebuffer, out);
    case SHD_FORMAT_RGBA16F: return read_pixels<Half>(framebuffer, out);
    case SHD_FORMAT_RGBA32F: return read_pixels<Float>(framebuffer, out);
    default: SHD_ASSERT(false);
  }
}

}  // namespace shd::film
