// SPDX-License-Identifier: MIT
// Framebuffer colour in every format against arithmetic on doubles.
#include "support/check.h"

#include "core/context.h"
#include "film/framebuffer.h"
#include "film/readback.h"

namespace {

using shd::film::Framebuffer;

shd::core::Context* g_context;
constexpr uint32_t kWidth = 1021;  // prime: only padded rows start on a cache line
constexpr uint32_t kHeight = 7;
constexpr uint32_t kPixels = kWidth * kHeight;

const float kEdges[] = {0.0f,
                        -0.0f,
                        1.0f,
                        -1.0f,
                        0.5f,
                        1e-45f,
                        -1e-45f,
                        1e-30f,
                        0.9999999f,
                        1.0000001f,
                        1e30f,
                        -1e30f,
                        INFINITY,
                        -INFINITY,
                        NAN,
                        -NAN,
                        0.0031308f,
                        0.04045f,
                        65504,
                        65519.99f,
                        65520.0f,
                        6.0e-8f,
                        2.98e-8f,
                        6.1e-5f,
                        1.0f / 255,
                        0.5f / 255,
                        254.5f / 255,
                        0.5f / 65535,
                        65534.5f / 65535,
                        2.0f,
                        0.25f,
                        0.75f};
constexpr size_t kEdgeCount = sizeof kEdges / sizeof kEdges[0];

/// Pixel i of channel c: the edges first, then steps over 0..1 and beyond.
float input(uint32_t c, uint32_t i) {
  const uint32_t k = i * 4 + c;
  if (k < 4 * kEdgeCount) return kEdges[(k / 4 + 3 * c) % kEdgeCount];
  return (static_cast<float>((k * 2654435761u) >> 8) / 16777216.0f) * 1.2f - 0.1f;
}

Framebuffer* make_framebuffer() {
  shd_framebuffer_desc desc = shd_framebuffer_desc_default();
  desc.width = kWidth;
  desc.height = kHeight;
  desc.aovs = SHD_AOV_TRIANGLE;
  Framebuffer* framebuffer = shd::core::create<Framebuffer>(g_context->allocator);
  shd::film::build(*g_context, desc, framebuffer);
  for (uint32_t i = 0; i < kPixels; ++i) {
    const size_t at = i / kWidth * framebuffer->stride + i % kWidth;
    for (uint32_t c = 0; c < 4; ++c) framebuffer->plane[c][at] = input(c, i);
    framebuffer->u32_plane[SHD_PLANE_TRIANGLE][at] = i * 7919u;
  }
  return framebuffer;
}

double clamp01(float value) {
  if (isnan(value) || value <= 0.0f) return 0.0;
  return value >= 1.0f ? 1.0 : static_cast<double>(value);
}

double unorm(float value, double maximum) {
  return floor(clamp01(value) * maximum + 0.5);
}

/// IEC 61966-2-1 on a double, rounded to the nearest of 256 codes.
double srgb8(float value) {
  const double linear = clamp01(value);
  const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
  return floor(encoded * 255.0 + 0.5);
}

/// Value of a binary16 from its parts.
double half_value(uint16_t half) {
  const int exponent = half >> 10 & 31;
  const double mantissa = half & 1023;
  if (exponent == 31) return mantissa != 0 ? static_cast<double>(NAN) : half & 0x8000 ? -HUGE_VAL : HUGE_VAL;
  const double magnitude = exponent == 0 ? ldexp(mantissa, -24) : ldexp(1024 + mantissa, exponent - 25);
  return half & 0x8000 ? -magnitude : magnitude;
}

/// Whether `half` is the binary16 nearest to the value, the even one of two.
bool is_nearest_half(uint16_t half, float value) {
  const double got = half_value(half);
  if (isnan(value)) return isnan(got);
  if (fabsf(value) >= 65520.0f) return isinf(got) && signbit(got) == signbit(value);
  const double error = fabs(got - static_cast<double>(value));
  const double spacing = ldexp(1.0, fabs(got) < 6.103515625e-05 ? -24 : ilogb(got) - 10);
  const bool tie = error == 0.5 * spacing;
  return (error < 0.5 * spacing || (tie && half % 2 == 0)) && signbit(got) == signbit(value);
}

bool matches(shd_format format, const unsigned char* channel, uint32_t c, float value) {
  switch (format) {
    case SHD_FORMAT_RGBA8: return *channel == unorm(value, 255.0);
    case SHD_FORMAT_RGBA8_SRGB: return *channel == (c == 3 ? unorm(value, 255.0) : srgb8(value));
    case SHD_FORMAT_RGBA16: {
      uint16_t got;
      memcpy(&got, channel, sizeof got);
      return got == unorm(value, 65535.0);
    }
    case SHD_FORMAT_RGBA16F: {
      uint16_t got;
      memcpy(&got, channel, sizeof got);
      return is_nearest_half(got, value);
    }
    default: return memcmp(channel, &value, sizeof value) == 0;
  }
}

struct Case {
  const char* name;
  shd_format format;
  size_t channel_size;
  size_t row_padding;
};
const Case kCases[] = {
    {"color/rgba8", SHD_FORMAT_RGBA8, 1, 0},           {"color/rgba8_padded", SHD_FORMAT_RGBA8, 1, 3},
    {"color/rgba8_srgb", SHD_FORMAT_RGBA8_SRGB, 1, 0}, {"color/rgba8_srgb_padded", SHD_FORMAT_RGBA8_SRGB, 1, 5},
    {"color/rgba16", SHD_FORMAT_RGBA16, 2, 0},         {"color/rgba16_padded", SHD_FORMAT_RGBA16, 2, 6},
    {"color/rgba16f", SHD_FORMAT_RGBA16F, 2, 0},       {"color/rgba16f_padded", SHD_FORMAT_RGBA16F, 2, 2},
    {"color/rgba32f", SHD_FORMAT_RGBA32F, 4, 0},       {"color/rgba32f_padded", SHD_FORMAT_RGBA32F, 4, 8},
};

alignas(64) unsigned char g_image[kHeight * (kWidth * 16 + 8) + 16];

void test_color(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  Framebuffer* framebuffer = make_framebuffer();
  shd_image image = shd_image_default();
  image.format = c.format;
  image.width = kWidth;
  image.height = kHeight;
  image.row_stride = kWidth * 4 * c.channel_size + c.row_padding;
  image.pixels = g_image;
  memset(g_image, 0xa5, sizeof g_image);
  shd::film::read_color(g_context->simd, *framebuffer, image);
  for (uint32_t y = 0; y < kHeight; ++y) {
    const unsigned char* row = g_image + y * image.row_stride;
    for (uint32_t x = 0; x < kWidth; ++x) {
      for (uint32_t k = 0; k < 4; ++k) {
        const float value = input(k, y * kWidth + x);
        if (!matches(c.format, row + (4 * x + k) * c.channel_size, k, value)) {
          fail_msg("%s: pixel (%u, %u) channel %u is wrong for %.9g", c.name, x, y, k, static_cast<double>(value));
        }
      }
    }
    for (size_t i = 0; i < c.row_padding; ++i) assert_int_equal(row[kWidth * 4 * c.channel_size + i], 0xa5);
  }
  assert_int_equal(g_image[kHeight * image.row_stride], 0xa5);
  shd::core::destroy(g_context->allocator, framebuffer);
}

void test_planes(void**) {
  static float floats[3 * kPixels];
  static uint32_t ids[3 * kPixels];
  Framebuffer* framebuffer = make_framebuffer();
  for (size_t step = 1; step <= 3; ++step) {
    memset(floats, 0, sizeof floats);
    memset(ids, 0, sizeof ids);
    shd::film::read_plane(*framebuffer, SHD_PLANE_G, {floats, step * sizeof(float)});
    shd::film::read_u32_plane(*framebuffer, SHD_PLANE_TRIANGLE, {ids, step * sizeof(uint32_t)});
    for (uint32_t i = 0; i < kPixels; ++i) {
      const float want = input(1, i);
      assert_memory_equal(&floats[step * i], &want, sizeof want);
      assert_int_equal(ids[step * i], i * 7919u);
      if (step > 1) assert_true(floats[step * i + 1] == 0.0f && ids[step * i + 1] == 0);
    }
  }
  shd::core::destroy(g_context->allocator, framebuffer);
}

/// Code of a linear value in long double, correctly rounded (IEC 61966-2-1).
int srgb8_code(float value) {
  if (!(value > 0)) return 0;
  if (value >= 1) return 255;
  const auto linear = static_cast<long double>(value);
  const long double encoded = linear <= 0.0031308L ? linear * 12.92L : 1.055L * powl(linear, 1 / 2.4L) - 0.055L;
  return static_cast<int>(floorl(255 * encoded + 0.5L));
}

/// Linear value at which the code changes from k - 1 to k.
long double srgb8_threshold(int k) {
  const long double encoded = (k - 0.5L) / 255;
  return encoded <= 0.04045L ? encoded / 12.92L : powl((encoded + 0.055L) / 1.055L, 2.4L);
}

constexpr uint32_t kSide = 512;  // 2^18 pixels

/// Values of three channels: uniform ones, ones of every exponent, and the floats around each threshold.
float srgb_input(uint32_t c, uint32_t i, uint32_t random) {
  if (c == 0) return static_cast<float>(random >> 8) * 0x1p-24f;
  if (c == 1) {
    const uint32_t bits = random % 0x3f800000u;  // below 1
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
  }
  auto value = static_cast<float>(srgb8_threshold(static_cast<int>(i % 255) + 1));
  for (uint32_t step = 0; step < i / 255 % 9; ++step) value = nextafterf(value, step % 2 ? 2.0f : 0.0f);
  for (uint32_t step = 0; step < i / (255 * 9) % 9; ++step) value = nextafterf(value, 2.0f);
  return value;
}

/// Read-outs in sRGB are the correctly rounded codes, for 2^18 random values and the floats around all thresholds.
void test_srgb_rounding(void**) {
  shd_framebuffer_desc desc = shd_framebuffer_desc_default();
  desc.width = desc.height = kSide;
  Framebuffer* framebuffer = shd::core::create<Framebuffer>(g_context->allocator);
  shd::film::build(*g_context, desc, framebuffer);
  static float values[3][kSide * kSide];
  static uint8_t pixels[kSide * kSide][4];
  uint32_t random = 1;
  for (uint32_t i = 0; i < kSide * kSide; ++i) {
    for (uint32_t c = 0; c < 3; ++c) {
      random = random * 1664525u + 1013904223u;  // Numerical Recipes
      values[c][i] = srgb_input(c, i, random ^ random >> 16);
      framebuffer->plane[c][i / kSide * framebuffer->stride + i % kSide] = values[c][i];
    }
  }
  shd_image image = shd_image_default();
  image.format = SHD_FORMAT_RGBA8_SRGB;
  image.width = image.height = kSide;
  image.pixels = pixels;
  image.row_stride = sizeof pixels[0] * kSide;
  shd::film::read_color(g_context->simd, *framebuffer, image);
  bool below[256] = {}, at[256] = {};  // codes seen on either side of their threshold
  for (uint32_t i = 0; i < kSide * kSide; ++i) {
    for (uint32_t c = 0; c < 3; ++c) {
      const int want = srgb8_code(values[c][i]);
      if (pixels[i][c] != want) {
        fail_msg("%.9g is %d, want %d", static_cast<double>(values[c][i]), pixels[i][c], want);
      }
    }
    const uint32_t code = i % 255;
    (pixels[i][2] == code ? below : at)[code + 1] = true;
  }
  for (int k = 1; k < 256; ++k) assert_true(below[k] && at[k]);
  shd::core::destroy(g_context->allocator, framebuffer);
}

}  // namespace

int main() {
  static CMUnitTest tests[sizeof kCases / sizeof kCases[0] + 2];
  size_t n = 0;
  for (const Case& c : kCases) tests[n++] = {c.name, test_color, nullptr, nullptr, const_cast<Case*>(&c)};
  tests[n++] = {"srgb_rounding", test_srgb_rounding, nullptr, nullptr, nullptr};
  tests[n++] = {"planes", test_planes, nullptr, nullptr, nullptr};
  g_context = shd::core::create_context(shd_context_desc_default());
  const int failed = _cmocka_run_group_tests("unit.film.readback", tests, n, nullptr, nullptr);
  shd::core::release(*g_context);
  return failed;
}
