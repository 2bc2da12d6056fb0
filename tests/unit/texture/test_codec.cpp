// SPDX-License-Identifier: MIT
// The numbers that formats state of themselves, and their texels from and to doubles.
#include "fixture.h"

#include <cmath>

#include "texture/format/formats.h"

namespace {

using namespace fixture;
using shd::image::Component;

constexpr Component kComponents[] = {Component::kUnorm8,  Component::kSrgb8,   Component::kUnorm16,
                                     Component::kFloat16, Component::kFloat32, Component::kRgb9e5};

/// Calls body(codec) with the codec of every component for 1 to 4 channels.
template <class Body>
void for_each_codec(const Body& body) {
  for (const Component component : kComponents) {
    for (size_t channels = 1; channels <= 4; ++channels) shd::texture::visit_codec(component, channels, body);
  }
}

/// The scale turns one() into exactly 1 and 0 into 0. Numbers between them stay below 1; codes become their quotient.
void test_scale(void**) {
  for_each_codec([](auto codec) {
    for (size_t c = 0; c < codec.kChannels; ++c) {
      const shd::texture::CodeScale scale = codec.scale(c);
      const auto value = [&](float number) { return number * scale.high + number * scale.low; };
      const auto one = static_cast<float>(codec.one(c));
      assert_true(value(one) == 1.0f);
      assert_true(value(0.0f) == 0.0f);
      for (float number = 0.0f; number < one; ++number) {
        assert_true(value(number) < 1.0f);
        if (!codec.kFloat) assert_true(value(number) == number / one);
      }
    }
  });
}

/// Stores numbers and loads them again; returns the first one.
template <class Codec>
double stored(const Codec&, double number) {
  double in[Codec::kChannels], out[Codec::kChannels], sum[Codec::kChannels] = {};
  for (double& value : in) value = number;
  uint8_t texel[Codec::kSize];
  Codec::store(in, texel);
  Codec::load(texel, out);
  Codec::add(texel, 1, sum);
  for (size_t c = 0; c < Codec::kChannels; ++c) assert_true(out[c] == sum[c] || std::isnan(out[c]));
  return out[0];
}

/// 0, 1 and the largest number survive; numbers of floats keep their sign.
void test_round_trip(void**) {
  for_each_codec([](auto codec) {
    assert_true(stored(codec, 0.0) == 0.0);
    assert_true(stored(codec, codec.one(0)) == codec.one(0));
    assert_true(stored(codec, codec.largest(0)) == codec.largest(0));
    if (codec.kFloat) {
      assert_true(stored(codec, -codec.largest(0)) == -codec.largest(0));
      assert_true(std::isnan(stored(codec, std::nan(""))));
      assert_true(std::isinf(stored(codec, HUGE_VAL)));
    }
  });
}

/// Codes are rounded to nearest, ties to even.
void test_rounding(void**) {
  for (const Component component : {Component::kUnorm8, Component::kUnorm16}) {
    shd::texture::visit_codec(component, 1, [](auto codec) {
      assert_true(stored(codec, 0.5) == 0.0);
      assert_true(stored(codec, 1.5) == 2.0);
      assert_true(stored(codec, 2.5) == 2.0);
      assert_true(stored(codec, 2.500001) == 3.0);
    });
  }
}

/// Texels of shared exponents are those of the specification; the decoded ones are encoded as themselves.
void test_shared_exponents(void**) {
  const shd::texture::Rgb9e5Codec<3> codec;
  const auto expect = [&](const double(&rgb)[3]) {
    uint32_t word;
    uint8_t texel[4];
    codec.store(rgb, texel);
    memcpy(&word, texel, sizeof word);
    if (word != ref::rgb9e5_word(rgb)) fail_msg("%g %g %g: %08x", rgb[0], rgb[1], rgb[2], word);
    double value[4], again[3];
    shd::texture::Rgb9e5Codec<4>::load(texel, value);
    assert_true(value[3] == 1.0);
    for (int c = 0; c < 3; ++c) assert_true(value[c] == ref::rgb9e5_value(word, c));
    uint8_t twice[4];
    codec.store(value, twice);
    codec.load(twice, again);
    for (int c = 0; c < 3; ++c) assert_true(again[c] == value[c]);
  };
  const double edges[] = {0,     -1,    0x1p-24,  0x1p-25,   0x1.fp-26, 0x1p-60, 0x1.ff0p-1, 0x1.ff7p-1, 0x1.ff8p-1, 1,
                          65408, 65440, HUGE_VAL, -HUGE_VAL, 1e300,     5e-324,  NAN,        0x1.01p-16, 0x1.ffp-16};
  for (const double r : edges) {
    for (const double g : edges) {
      for (const double b : edges) expect({r, g, b});
    }
  }
  Random random{9};
  for (int i = 0; i < 100000; ++i) {
    double rgb[3];
    for (double& c : rgb) {
      c = ldexp(static_cast<double>(random.real(-0.1f, 1)), static_cast<int>(random.next() >> 16) % 44 - 26);
    }
    expect(rgb);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(test_scale),
      cmocka_unit_test(test_round_trip),
      cmocka_unit_test(test_rounding),
      cmocka_unit_test(test_shared_exponents),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
