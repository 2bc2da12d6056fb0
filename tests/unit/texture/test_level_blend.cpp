// SPDX-License-Identifier: MIT
// Samplers that read fewer texels: level_blend and probe_slack against the oracle, and the limit max_texels.
#include "filter_cases.h"

#include "ref/footprint_ref.h"
#include "texture/oracle/explain.h"

namespace {

using namespace fixture;

Batch t_batch, t_first;

shd_sampler_desc blend_desc(shd_filter filter, uint32_t pair) {
  const float blends[] = {0.5f, 0.25f, 0.0625f, 0.75f}, slacks[] = {0.4f, 0, 1, 0.125f, 0.75f};
  shd_sampler_desc desc = wrap_desc(filter, pair);
  desc.level_blend = blends[pair % 4];
  desc.probe_slack = slacks[(pair + pair / 5) % 5];
  desc.probe_weights = pair % 3 ? SHD_PROBE_WEIGHTS_EQUAL : SHD_PROBE_WEIGHTS_GAUSSIAN;
  desc.lod_bias = pair % 7 ? 0.0f : 0.5f;
  return desc;
}

/// Compares with the oracle, with either number of probes where rounding decides between two. The share of a level is
/// as many times steeper than the level of detail as level_blend is less than 1.
void check_point(const SizeCase& c, const ref::Image& image, const Batch& batch, size_t i) {
  const shd_sampler_desc& s = *image.sampler;
  const double u = static_cast<double>(batch.u[i]), v = static_cast<double>(batch.v[i]);
  const double w = c.width, h = c.height, limit = static_cast<double>(s.max_anisotropy);
  const ref::Jacobian j = {static_cast<double>(batch.dudx[i]) * w, static_cast<double>(batch.dvdx[i]) * h,
                           static_cast<double>(batch.dudy[i]) * w, static_cast<double>(batch.dvdy[i]) * h};
  const ref::Ellipse e = ref::ellipse(j);
  const bool probes = s.filter == SHD_FILTER_ANISOTROPIC;
  const double ratio = probes ? ref::aspect(e, limit) : 1;
  const double lod = ref::clamp_lod(image, log2(e.a / ratio)), steepness = 1 / static_cast<double>(s.level_blend);
  const double widths = ratio * exp2(lod - ref::blend_levels(s, lod)) - static_cast<double>(s.probe_slack);
  const double m = fmax(magnitude(image.format), 2), range = 2 * m;
  const double tolerance = 3e-7 * m + 4e-7 * (w + h) * range + 2e-6 * steepness * range + 2e-6 * limit * range;
  const int low = probes ? static_cast<int>(fmax(ceil(widths - 1e-4 * steepness), 1)) : 1;
  const int high = probes ? static_cast<int>(fmax(ceil(widths + 1e-4 * steepness), 1)) : 1;
  for (int channel = 0; channel < 4; ++channel) {
    const double got = static_cast<double>(batch.out[channel][i]);
    const auto want = [&](int count) {
      return probes ? ref::anisotropic(image, e, count, u, v, channel)
                    : ref::trilinear(image, u, v, log2(e.a), channel);
    };
    if (low != high && shd_is_close(got, want(low), tolerance, 0)) continue;
    shd_assert_close(c.name, i, got, want(high), tolerance, 0);
  }
}

void test_size(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      const shd_filter filter = pair % 6 ? SHD_FILTER_ANISOTROPIC : SHD_FILTER_TRILINEAR;
      check_against_oracle(*texture, blend_desc(filter, pair), t_batch.lookups(true, false), &t_batch,
                           [&](const ref::Image& image, size_t i) { check_point(c, image, t_batch, i); });
    }
    free_texture(texture);
  }
}

/// Without a blend, trilinear lookups, and probes of round footprints, have the bits of the nearest level.
void test_nearest_level(void**) {
  make_points(&t_batch);
  memcpy(&t_first, &t_batch, sizeof t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 128, 128, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      shd_sampler_desc desc = blend_desc(pair % 2 ? SHD_FILTER_TRILINEAR : SHD_FILTER_ANISOTROPIC, pair);
      desc.level_blend = 0;
      desc.max_anisotropy = 1;
      desc.probe_slack = 0.5f;
      const bool lod = pair % 3 == 0;
      shd_sampler_desc nearest = desc;
      nearest.filter = SHD_FILTER_BILINEAR_MIP;
      check_same_bits(*texture, desc, nearest, lod, &t_batch, &t_first);
    }
    free_texture(texture);
  }
}

/// The blend of the whole way is the blend of the default, and a level is not read where its share is 0.
void test_texels_of_levels(void**) {
  Texture* texture = random_texture(SHD_FORMAT_R8, 64, 64, true);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.level_blend = 0.5f;
  const float zero = 0, u = 0.3f;
  for (int k = 0; k <= 64; ++k) {
    const float lod = 1 + static_cast<float>(k) / 64;
    const Lookups lookup = {1, &u, &u, &zero, &zero, &zero, &zero, &lod, nullptr, nullptr};
    shd_explanation explanation = {};
    shd::texture::explain(*context(), *texture, make_sampler(desc), lookup, &explanation);
    assert_int_equal(explanation.tap_count, k <= 16 || k >= 48 ? 4 : 8);
  }
  free_texture(texture);
}

/// No lookup reads more than max_texels texels, and long footprints read more than a third of them.
void check_limit(const shd_sampler_desc& desc, const Texture& texture) {
  Random random{7};
  uint32_t most = 0;
  for (int n = 0; n < 1500; ++n) {
    const float angle = random.real(0, 7), longer = exp2f(random.real(-1, 8)), shorter = longer * random.real(0, 0.1f);
    const float u = random.real(0, 1), v = random.real(0, 1);
    const float dudx = longer * cosf(angle) / 256, dvdx = longer * sinf(angle) / 128;
    const float dudy = -shorter * sinf(angle) / 256, dvdy = shorter * cosf(angle) / 128;
    const Lookups lookup = {1, &u, &v, &dudx, &dvdx, &dudy, &dvdy, nullptr, nullptr, nullptr};
    shd_explanation explanation = {};
    shd::texture::explain(*context(), texture, make_sampler(desc), lookup, &explanation);
    if (explanation.tap_count > desc.max_texels) {
      fail_msg("filter %d, profile %d, limit %u: %u texels", desc.filter, desc.profile, desc.max_texels,
               explanation.tap_count);
    }
    if (explanation.tap_count > most) most = explanation.tap_count;
  }
  assert_true(3 * most > desc.max_texels);
}

void test_max_texels(void**) {
  Texture* texture = random_texture(SHD_FORMAT_R8, 256, 128, true);
  const float blends[] = {1, 0.25f, 0};
  for (const uint32_t limit : {32u, 50u, 128u}) {
    for (int k = 0; k < 10; ++k) {
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = k == 6 ? SHD_FILTER_EWA : SHD_FILTER_ANISOTROPIC;
      desc.profile = k < 3 || k == 6 ? SHD_PROFILE_EXACT : static_cast<shd_profile>(k - 2);
      if (k < 3) desc.level_blend = blends[k];
      if (k > 6) desc.profile = SHD_PROFILE_LEAST_ERROR, desc.level_blend = blends[k - 7];
      desc.max_anisotropy = 64;
      desc.max_texels = limit;
      check_limit(desc, *texture);
    }
  }
  free_texture(texture);
}

void test_constant(void**) {
  check_constant_mipmap(25, [](uint32_t pair) { return blend_desc(SHD_FILTER_ANISOTROPIC, pair); });
}

void test_tails(void**) {
  check_tails_of_formats(blend_desc(SHD_FILTER_ANISOTROPIC, 1), true);
}

void test_hostile_derivatives(void**) {
  check_hostile_footprints([](uint32_t pair) { return blend_desc(SHD_FILTER_ANISOTROPIC, pair); });
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = add_sizes("level_blend", test_size, tests);
  tests[n++] = {"nearest_level", test_nearest_level, nullptr, nullptr, nullptr};
  tests[n++] = {"texels_of_levels", test_texels_of_levels, nullptr, nullptr, nullptr};
  tests[n++] = {"max_texels", test_max_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile_derivatives", test_hostile_derivatives, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.level_blend", tests, n, nullptr, nullptr);
}
