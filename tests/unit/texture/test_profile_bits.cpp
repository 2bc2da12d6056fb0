// SPDX-License-Identifier: MIT
// Bits of sampler profiles: rounded weights and levels, unaffected filters, hostile derivatives and texels.
#include "profiles.h"

#include "texture/domain/lod.h"

namespace {

using namespace fixture;

Batch t_batch, t_first;

/// Bilinear weights and fractions of levels are rounded to multiples of 1/256; in the other profiles they are exact.
void test_rounding(void**) {
  const float texels[] = {0, 256, 0, 256};
  Texture* texture = make_texture(SHD_FORMAT_R32F, 4, 1, reinterpret_cast<const uint8_t*>(texels), true);
  for (const shd_filter filter : {SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR}) {
    for (const shd_profile profile : {SHD_PROFILE_EXACT, SHD_PROFILE_VULKAN, SHD_PROFILE_D3D11, SHD_PROFILE_OIIO}) {
      const bool rounds = profile == SHD_PROFILE_VULKAN || profile == SHD_PROFILE_D3D11;
      t_batch.count = 400;
      for (size_t i = 0; i < t_batch.count; ++i) {
        t_batch.u[i] = 0.125f + static_cast<float>(i) / 2048;  // s = i / 512
        t_batch.v[i] = 0.5f;
        t_batch.lod[i] = -1;
      }
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(make_desc(profile, filter, 0)), target, t_batch.lookups(false, true), &t_batch);
        for (size_t i = 0; i < t_batch.count; ++i) {
          const float s = static_cast<float>(i) / 2;
          assert_true(t_batch.out[0][i] == (rounds ? floorf(s + 0.5f) : s));
        }
      });
    }
  }
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = 0.125f;  // a texel of 0, and on the next level the middle between 0 and 256
    t_batch.lod[i] = static_cast<float>(i) / 512;
  }
  for (const shd_profile profile : {SHD_PROFILE_EXACT, SHD_PROFILE_VULKAN, SHD_PROFILE_D3D11, SHD_PROFILE_OIIO}) {
    const bool rounds = profile == SHD_PROFILE_VULKAN || profile == SHD_PROFILE_D3D11;
    for (const shd_filter filter : {SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_NEAREST_MIP_LINEAR}) {
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(make_desc(profile, filter, 0)), target, t_batch.lookups(false, true), &t_batch);
        for (size_t i = 0; i < t_batch.count; ++i) {
          const float s = static_cast<float>(i) / 2;
          assert_true(t_batch.out[0][i] == (rounds ? floorf(s + 0.5f) : s) / 2);
        }
      });
    }
  }
  free_texture(texture);
}

/// With a weight that rounds to 1, the other texel has no effect, even if it is NaN.
void test_rounding_up(void**) {
  const float texels[] = {NAN, 3, INFINITY, 3};
  Texture* texture = make_texture(SHD_FORMAT_R32F, 4, 1, reinterpret_cast<const uint8_t*>(texels), false);
  t_batch.count = 2;
  for (size_t i = 0; i < 2; ++i) {
    t_batch.u[i] = (static_cast<float>(2 * i) + 1.499f) / 4;
    t_batch.v[i] = 0.5f;
  }
  for_each_target([&](int64_t target) {
    for (const shd_wrap wrap : {SHD_WRAP_REPEAT, SHD_WRAP_CLAMP, SHD_WRAP_BORDER}) {
      shd_sampler_desc desc = make_desc(SHD_PROFILE_VULKAN, SHD_FILTER_BILINEAR, 0);
      desc.wrap_u = wrap;
      desc.wrap_v = SHD_WRAP_CLAMP;
      run(*texture, make_sampler(desc), target, t_batch.lookups(false, false), &t_batch);
      assert_true(t_batch.out[0][0] == 3 && t_batch.out[0][1] == 3);
    }
  });
  free_texture(texture);
}

/// Filters without profiles keep their bits.
void test_others(void**) {
  make_points(&t_batch);
  memcpy(&t_first, &t_batch, sizeof t_batch);
  Texture* texture = random_texture(SHD_FORMAT_RGBA16, 64, 32, true);
  for (const shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_BICUBIC, SHD_FILTER_STOCHASTIC}) {
    for (const shd_profile profile : kProfiles) {
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(make_desc(profile, filter, 6)), target, t_batch.lookups(true, false), &t_batch);
        run(*texture, make_sampler(make_desc(SHD_PROFILE_EXACT, filter, 6)), target, t_first.lookups(true, false),
            &t_first);
        assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
      });
    }
  }
  free_texture(texture);
}

/// Trilinear of OpenImageIO equals trilinear at its level of detail, in values and derivatives.
void test_gradient(void**) {
  make_points(&t_batch);
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 61, 37, true);
  for (uint32_t pair = 0; pair < 25; ++pair) {
    const shd_sampler_desc desc = make_desc(SHD_PROFILE_OIIO, SHD_FILTER_TRILINEAR, pair);
    shd_sampler_desc exact = desc;
    exact.profile = SHD_PROFILE_EXACT;
    for_each_target([&](int64_t target) {
      static float got[3][kPoints], want[3][kPoints];
      const auto simd = shd::core::simd_target_from_bit(target);
      const Lookups lookups = t_batch.lookups(true, false);
      shd::texture::sample(*texture, make_sampler(desc), simd, lookups,
                           {{nullptr, got[0]}, {nullptr, got[1]}, {nullptr, got[2]}});
      shd::texture::find_lods(*texture, make_sampler(desc), {-15, 17}, shd::texture::LodAxis::kLonger, simd, lookups,
                              t_batch.lod);
      shd::texture::sample(*texture, make_sampler(exact), simd, t_batch.lookups(false, true),
                           {{nullptr, want[0]}, {nullptr, want[1]}, {nullptr, want[2]}});
      assert_memory_equal(got, want, sizeof got);
    });
  }
  free_texture(texture);
}

void test_constant(void**) {
  uint8_t texels[16 * 16 * 4];
  constant_texels(SHD_FORMAT_RGBA8, 16 * 16, texels);
  Texture* texture = make_texture(SHD_FORMAT_RGBA8, 16, 16, texels, true);
  for (uint32_t k = 0; k < 5 * kProfiledCount; ++k) {
    const shd_sampler_desc desc = make_desc(kProfiles[k % 3], kFilters[k / 3 % kFilterCount], k / kProfiledCount * 6);
    if (desc.wrap_u != SHD_WRAP_BORDER) check_constant(*texture, desc, true);
  }
  free_texture(texture);
}

void test_tails(void**) {
  Texture* texture = random_texture(SHD_FORMAT_RGBA8, 64, 32, true);
  for (uint32_t k = 0; k < kProfiledCount; ++k) {
    check_tails(*texture, make_desc(kProfiles[k % 3], kFilters[k / 3], 1), true);
  }
  free_texture(texture);
}

void test_hostile(void**) {
  const float values[] = {0, -1e-45f, 1e-30f, -1e-8f, -1e-3f, 0.3f, 1e10f, -1e19f, -1e30f, 3.4e38f, INFINITY, NAN};
  check_hostile_derivatives(values, 120, [](uint32_t round) {
    shd_sampler_desc desc = make_desc(kProfiles[round % 3], kFilters[round / 3 % kFilterCount], round);
    desc.lod_bias = round % 5 == 0 ? -15.0f : 0.0f;
    desc.width_x = round % 4 == 0 ? 64.0f : round % 7 == 0 ? 0.0f : 1.0f;
    desc.blur_v = round % 5 == 0 ? 0.5f : 0.0f;
    if (round % 2) desc.magnification = SHD_MAGNIFICATION_NEAREST;
    return desc;
  });
}

void test_infinite(void**) {
  for (uint32_t k = 0; k < kProfiledCount; ++k) check_infinite(make_desc(kProfiles[k % 3], kFilters[k / 3], 0));
}

}  // namespace

int main() {
  CMUnitTest tests[16];
  size_t n = 0;
  tests[n++] = {"rounding", test_rounding, nullptr, nullptr, nullptr};
  tests[n++] = {"rounding_up", test_rounding_up, nullptr, nullptr, nullptr};
  tests[n++] = {"others", test_others, nullptr, nullptr, nullptr};
  tests[n++] = {"gradient", test_gradient, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile", test_hostile, nullptr, nullptr, nullptr};
  tests[n++] = {"infinite", test_infinite, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.profile_bits", tests, n, nullptr, nullptr);
}
