// SPDX-License-Identifier: MIT
// Bicubic: every kernel x format x wrap pair x size x target against the oracle, all tails, and properties of the
// kernels.
#include "filter_cases.h"

namespace {

using namespace fixture;

struct bicubic_case {
  const char* name;
  shd_cubic cubic;
  uint32_t width, height;
};
const bicubic_case k_cases[] = {
    {"catmull_rom/1x1", SHD_CUBIC_CATMULL_ROM, 1, 1},
    {"catmull_rom/1x7", SHD_CUBIC_CATMULL_ROM, 1, 7},
    {"catmull_rom/5x3", SHD_CUBIC_CATMULL_ROM, 5, 3},
    {"catmull_rom/64x64", SHD_CUBIC_CATMULL_ROM, 64, 64},
    {"catmull_rom/1023x511", SHD_CUBIC_CATMULL_ROM, 1023, 511},
    {"b_spline/1x1", SHD_CUBIC_B_SPLINE, 1, 1},
    {"b_spline/5x3", SHD_CUBIC_B_SPLINE, 5, 3},
    {"b_spline/128x32", SHD_CUBIC_B_SPLINE, 128, 32},
    {"b_spline/4096x1", SHD_CUBIC_B_SPLINE, 4096, 1},
    {"mitchell/2x2", SHD_CUBIC_MITCHELL, 2, 2},
    {"mitchell/5x3", SHD_CUBIC_MITCHELL, 5, 3},
    {"mitchell/64x64", SHD_CUBIC_MITCHELL, 64, 64},
};
constexpr shd_cubic kCubics[] = {SHD_CUBIC_CATMULL_ROM, SHD_CUBIC_B_SPLINE, SHD_CUBIC_MITCHELL};

Batch t_batch;

shd_sampler_desc make_desc(shd_cubic cubic, uint32_t pair) {
  shd_sampler_desc desc = wrap_desc(SHD_FILTER_BICUBIC, pair);
  desc.cubic = cubic;
  return desc;
}

/// The bound stated in sample.h.
double bound(const bicubic_case& c, shd_format format) {
  return fmax(magnitude(format), 2) * (3e-6 + 4e-6 * (c.width + c.height));
}

void check_point(const bicubic_case& c, const ref::Image& image, size_t i) {
  const double u = static_cast<double>(t_batch.u[i]), v = static_cast<double>(t_batch.v[i]);
  for (int channel = 0; channel < 4; ++channel) {
    shd_assert_close(c.name, i, static_cast<double>(t_batch.out[channel][i]), ref::bicubic(image, u, v, channel),
                     bound(c, image.format), 0);
  }
}

void test_against_oracle(void** state) {
  const auto& c = *static_cast<const bicubic_case*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, false);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      check_against_oracle(*texture, make_desc(c.cubic, pair), t_batch.lookups(false, false), &t_batch,
                           [&](const ref::Image& image, size_t i) { check_point(c, image, i); });
    }
    free_texture(texture);
  }
}

void test_tails(void**) {
  check_tails_of_formats(make_desc(SHD_CUBIC_MITCHELL, 3), false);
}

void test_constant(void**) {
  for (const shd_format format : kFormats) {
    uint8_t texels[8 * 8 * 16];
    constant_texels(format, 8 * 8, texels);
    Texture* texture = make_texture(format, 8, 8, texels, false);
    for (const shd_cubic cubic : kCubics) {
      for (const shd_wrap wrap : {SHD_WRAP_REPEAT, SHD_WRAP_CLAMP, SHD_WRAP_MIRROR, SHD_WRAP_MIRROR_ONCE}) {
        check_constant(*texture, make_desc(cubic, 6 * static_cast<uint32_t>(wrap)), false);
      }
    }
    free_texture(texture);
  }
}

/// Catmull-Rom interpolates: at texel centres other texels have no effect, not even NaN and infinity.
void test_interpolates(void**) {
  float texels[64];
  for (size_t i = 0; i < 64; ++i) texels[i] = i % 5 == 0 ? NAN : i % 5 == 1 ? INFINITY : static_cast<float>(i);
  Texture* texture = make_texture(SHD_FORMAT_R32F, 64, 1, reinterpret_cast<uint8_t*>(texels), false);
  t_batch.count = 64;
  for (size_t i = 0; i < 64; ++i) {
    t_batch.u[i] = (static_cast<float>(i) + 0.5f) / 64;
    t_batch.v[i] = 0.5f;
  }
  for_each_target([&](int64_t target) {
    const Sampler sampler = make_sampler(make_desc(SHD_CUBIC_CATMULL_ROM, 0));
    run(*texture, sampler, target, t_batch.lookups(false, false), &t_batch);
    for (size_t i = 0; i < 64; ++i) {
      assert_true(isnan(texels[i]) ? isnan(t_batch.out[0][i]) : t_batch.out[0][i] == texels[i]);
    }
  });
  free_texture(texture);
}

/// Finite texels of any size give finite values; if differences overflow, another blend is used.
void test_huge_texels(void**) {
  float texels[16];
  for (size_t i = 0; i < 16; ++i) texels[i] = i % 2 ? 3e38f : -3e38f;
  Texture* texture = make_texture(SHD_FORMAT_R32F, 4, 4, reinterpret_cast<uint8_t*>(texels), false);
  make_points(&t_batch);
  for_each_target([&](int64_t target) {
    const Sampler sampler = make_sampler(make_desc(SHD_CUBIC_B_SPLINE, 0));
    run(*texture, sampler, target, t_batch.lookups(false, false), &t_batch);
    for (size_t i = 0; i < t_batch.count; ++i) assert_true(isfinite(t_batch.out[0][i]));
  });
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[24];
  size_t n = 0;
  for (const bicubic_case& c : k_cases) {
    tests[n++] = {c.name, test_against_oracle, nullptr, nullptr, const_cast<bicubic_case*>(&c)};
  }
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"interpolates", test_interpolates, nullptr, nullptr, nullptr};
  tests[n++] = {"huge_texels", test_huge_texels, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.bicubic", tests, n, nullptr, nullptr);
}
