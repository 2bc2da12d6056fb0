// SPDX-License-Identifier: MIT
// Interleaved pixels on every SIMD target: the codes of arithmetic in doubles around every tie, every length of a tail,
// the round trip of decoded pixels, pixels of every format and step, and single channels.
#include "support/check.h"

#include <vector>

#include "film/framebuffer.h"
#include "image/channel.h"
#include "image/half.h"
#include "image/pixels.h"
#include "support/targets.h"

namespace {

using shd::image::decode_pixels;
using shd::image::encode_pixels;

constexpr shd_format kFormats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16F,
                                   SHD_FORMAT_RGBA32F};
constexpr shd_format kDrawn[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F};

/// The nearest of `maximum` + 1 codes; the product is exact in double.
uint32_t unorm(float value, double maximum) {
  const double clamped = value > 0.0f ? (value < 1.0f ? static_cast<double>(value) : 1.0) : 0.0;
  return static_cast<uint32_t>(clamped * maximum + 0.5);
}

/// Writes the pixel that `color` has in a format.
void encode_one(shd_format format, const float (&color)[4], unsigned char* out) {
  for (size_t c = 0; c < 4; ++c) {
    const float value = color[c];
    const auto code16 = static_cast<uint16_t>(unorm(value, 65535.0));
    const uint16_t half = shd::image::float_to_half(value);
    switch (format) {
      case SHD_FORMAT_RGBA8: out[c] = static_cast<unsigned char>(unorm(value, 255.0)); break;
      case SHD_FORMAT_RGBA8_SRGB:
        out[c] = c == 3 ? static_cast<unsigned char>(unorm(value, 255.0)) : shd::image::linear_to_srgb8(value);
        break;
      case SHD_FORMAT_RGBA16: memcpy(out + 2 * c, &code16, 2); break;
      case SHD_FORMAT_RGBA16F: memcpy(out + 2 * c, &half, 2); break;
      default: memcpy(out + 4 * c, &value, 4);
    }
  }
}

/// Adds the floats around a tie, and its mirror image below 0.
void add_around(double tie, std::vector<float>* out) {
  float value = static_cast<float>(tie);
  for (int i = 0; i < 3; ++i) value = nextafterf(value, -1.0f);
  for (int i = 0; i < 7; ++i, value = nextafterf(value, 1e30f)) out->push_back(value);
  out->push_back(-value);
}

/// Values at which a code changes, and special values.
std::vector<float> make_values() {
  std::vector<float> values = {0.0f,     -0.0f,    1.0f,      -1.0f,    2.0f,     1e-45f,   1e30f,
                               -1e30f,   INFINITY, -INFINITY, NAN,      -NAN,     65504.0f, 65519.996f,
                               65520.0f, 65536.0f, 6.1e-5f,   5.97e-8f, 2.98e-8f, 2.99e-8f};
  for (int k = 0; k < 256; ++k) add_around((k + 0.5) / 255, &values);
  for (int k = 0; k < 65536; k += 7) add_around((k + 0.5) / 65535, &values);
  for (int k = 1; k < 256; ++k) {
    add_around(static_cast<double>(shd::image::kLinearToSrgb8Threshold[k]), &values);
  }
  for (uint32_t half = 0; half < 0x7c00; half += 37) {
    const double low = static_cast<double>(shd::image::half_to_float(static_cast<uint16_t>(half)));
    const double high = static_cast<double>(shd::image::half_to_float(static_cast<uint16_t>(half + 1)));
    if (half + 1 < 0x7c00) add_around(0.5 * (low + high), &values);
  }
  while (values.size() % 4) values.push_back(0.25f);
  return values;
}

/// Encodes `count` pixels and compares each with encode_one().
void check(const shd::core::SimdTarget& simd, shd_format format, const float* const plane[4], size_t count) {
  const size_t size = shd_format_size(format);
  std::vector<unsigned char> got(count * size + 1, 0xa5);
  encode_pixels(simd, format, plane, count, got.data());
  for (size_t i = 0; i < count; ++i) {
    const float color[4] = {plane[0][i], plane[1][i], plane[2][i], plane[3][i]};
    unsigned char want[16];
    encode_one(format, color, want);
    if (memcmp(&got[i * size], want, size)) {
      fail_msg("format %d on %s, pixel %zu of %zu: %.9g %.9g %.9g %.9g", static_cast<int>(format), simd.name, i, count,
               static_cast<double>(color[0]), static_cast<double>(color[1]), static_cast<double>(color[2]),
               static_cast<double>(color[3]));
    }
  }
  assert_int_equal(got[count * size], 0xa5);
}

void test_ties(void**) {
  const std::vector<float> values = make_values();
  const size_t quarter = values.size() / 4;
  shd::tests::for_each_target([&](const shd::core::SimdTarget& simd, bool) {
    for (shd_format format : kFormats) {
      for (size_t turn = 0; turn < 4; ++turn) {  // every value in every channel
        const float* plane[4];
        for (size_t c = 0; c < 4; ++c) plane[c] = values.data() + (c + turn) % 4 * quarter;
        check(simd, format, plane, quarter);
      }
    }
  });
}

void test_tails(void**) {
  float column[4][80];
  for (size_t c = 0; c < 4; ++c) {
    for (size_t i = 0; i < 80; ++i) column[c][i] = static_cast<float>((7 * i + 13 * c) % 97) / 96.0f;
  }
  shd::tests::for_each_target([&](const shd::core::SimdTarget& simd, bool) {
    for (shd_format format : kFormats) {
      for (size_t count = 0; count < 40; ++count) {
        const float* const plane[4] = {column[0] + count, column[1] + 1, column[2] + 3, column[3]};
        check(simd, format, plane, count);
      }
    }
  });
}

/// Decoded pixels are encoded to the same bits, for every code and every half that is not NaN.
void test_round_trip(void**) {
  for (shd_format format : kDrawn) {
    const bool is_half = format == SHD_FORMAT_RGBA16F;
    const size_t size = shd_format_size(format), count = is_half ? 65536 : 256;
    std::vector<unsigned char> in(count * size), out(count * size);
    for (size_t i = 0; i < count; ++i) {
      for (size_t c = 0; c < 4; ++c) {
        auto half = static_cast<uint16_t>(i + 16384 * c);
        if ((half & 0x7c00) == 0x7c00) half &= 0xfc00;
        if (is_half) memcpy(&in[i * size + 2 * c], &half, 2);
        if (!is_half) in[i * size + c] = static_cast<unsigned char>(i + 64 * c);
      }
    }
    std::vector<float> columns[4];
    for (auto& column : columns) column.resize(count);
    float* const decoded[4] = {columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()};
    decode_pixels(format, in.data(), count, decoded);
    const float* const planes[4] = {decoded[0], decoded[1], decoded[2], decoded[3]};
    shd::tests::for_each_target([&](const shd::core::SimdTarget& simd, bool) {
      encode_pixels(simd, format, planes, count, out.data());
      assert_memory_equal(in.data(), out.data(), in.size());
    });
    if (is_half) continue;
    for (size_t i = 0; i < count; ++i) {
      const auto code = static_cast<uint8_t>(i), alpha = static_cast<uint8_t>(i + 192);
      const float linear = static_cast<float>(code / 255.0);
      assert_true(decoded[0][i] == (format == SHD_FORMAT_RGBA8 ? linear : shd::image::srgb8_to_linear(code)));
      assert_true(decoded[3][i] == static_cast<float>(alpha / 255.0));
    }
  }
}

/// The linear value of a channel, from its definition.
float decode_one(const shd::image::FormatInfo& format, size_t c, const unsigned char* channel) {
  uint16_t wide;
  float number;
  memcpy(&wide, channel, format.channel_size >= 2 ? 2 : 1);
  memcpy(&number, channel, format.channel_size);
  switch (format.component) {
    case shd::image::Component::kUnorm8: return static_cast<float>(*channel / 255.0);
    case shd::image::Component::kSrgb8:
      return c == 3 ? static_cast<float>(*channel / 255.0) : shd::image::srgb8_to_linear(*channel);
    case shd::image::Component::kUnorm16: return static_cast<float>(wide / 65535.0);
    case shd::image::Component::kFloat16: return shd::image::half_to_float(wide);
    default: return number;
  }
}

/// Every format, in both directions of a row, to planes and to RGBA: every code of 16 bits, and the bits of NaN.
void test_decode(void**) {
  constexpr size_t kCount = 16384;
  std::vector<unsigned char> in(kCount * 19 + 64);
  for (size_t i = 0; i < kCount * 8; ++i) memcpy(&in[2 * i], &i, 2);
  std::vector<float> rgba(4 * kCount), columns[4];
  for (auto& column : columns) column.resize(kCount);
  float* const planes[4] = {columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()};
  for (int f = 1; f <= SHD_FORMAT_RGB32F; ++f) {
    const auto format = static_cast<shd_format>(f);
    const shd::image::FormatInfo info = shd::image::format_info(format);
    if (info.channels == 0) continue;
    const auto size = static_cast<ptrdiff_t>(info.pixel_size);
    for (const ptrdiff_t step : {size, size + 3, -size}) {
      const unsigned char* const first = in.data() + (step < 0 ? (kCount - 1) * info.pixel_size : 0);
      decode_pixels(format, first, step, kCount, rgba.data());
      if (step == size) decode_pixels(format, first, kCount, planes);
      for (size_t i = 0; i < kCount; ++i) {
        for (size_t c = 0; c < 4; ++c) {
          const unsigned char* const channel = first + static_cast<ptrdiff_t>(i) * step + c * info.channel_size;
          const float want = c < info.channels ? decode_one(info, c, channel) : c == 3 ? 1.0f : 0.0f;
          if (memcmp(&want, &rgba[4 * i + c], 4)) fail_msg("format %d, pixel %zu, channel %zu", f, i, c);
          if (step == size && memcmp(&want, &columns[c][i], 4)) fail_msg("plane %zu, format %d, pixel %zu", c, f, i);
          if (c >= info.channels || isnan(want)) continue;
          const double value = shd::image::load_channel(shd::image::channel_component(info, c), channel);
          assert_true(static_cast<float>(value) == want);
        }
      }
    }
  }
}

/// Single channels have the codes of pixels, and a dither moves the threshold.
void test_channels(void**) {
  const std::vector<float> values = make_values();
  for (const shd_format format : kFormats) {
    const shd::image::FormatInfo info = shd::image::format_info(format);
    for (const float value : values) {
      const float color[4] = {value, value, value, value};
      unsigned char want[16], got[16];
      encode_one(format, color, want);
      for (size_t c = 0; c < 4; ++c) {
        shd::image::store_channel(shd::image::channel_component(info, c), static_cast<double>(value),
                                  got + c * info.channel_size);
      }
      if (!isnan(value)) assert_memory_equal(got, want, info.pixel_size);
    }
  }
  for (int code = 0; code < 256; ++code) {
    const double value = (code + 0.25) / 255;
    assert_int_equal(shd::image::unorm_code<uint8_t>(value, 0.74), code);
    assert_int_equal(shd::image::unorm_code<uint8_t>(value, 0.76), code < 255 ? code + 1 : 255);
  }
}

void test_formats(void**) {
  for (int f = 0; f <= SHD_FORMAT_RGB32F; ++f) {
    const auto format = static_cast<shd_format>(f);
    bool encodes = false, draws = format == SHD_FORMAT_RGBA32F;
    for (shd_format known : kFormats) encodes = encodes || known == format;
    for (shd_format known : kDrawn) draws = draws || known == format;
    assert_int_equal(shd::image::can_encode(format), encodes);
    assert_int_equal(shd::film::can_draw(format), draws);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      {"ties", test_ties, nullptr, nullptr, nullptr},
      {"tails", test_tails, nullptr, nullptr, nullptr},
      {"round_trip", test_round_trip, nullptr, nullptr, nullptr},
      {"decode", test_decode, nullptr, nullptr, nullptr},
      {"channels", test_channels, nullptr, nullptr, nullptr},
      {"formats", test_formats, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.image.pixels", tests, sizeof tests / sizeof tests[0], nullptr, nullptr);
}
