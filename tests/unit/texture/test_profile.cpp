// SPDX-License-Identifier: MIT
// Sampler profiles against the oracle: levels of detail and probes on every target, then the results of the filters.
#include "profiles.h"

#include "ref/profile_ref.h"
#include "texture/domain/probes.h"

namespace {

using namespace fixture;
using shd::texture::LodAxis;
using shd::texture::ProbeBlock;

const SizeCase k_sizes[] = {
    {"1x1", 1, 1}, {"1x7", 1, 7}, {"5x3", 5, 3}, {"64x64", 64, 64}, {"128x32", 128, 32}, {"1023x511", 1023, 511},
};

Batch t_batch;
ProbeBlock t_block;

ref::Jacobian jacobian(const Batch& batch, size_t i) {
  return {static_cast<double>(batch.dudx[i]), static_cast<double>(batch.dvdx[i]), static_cast<double>(batch.dudy[i]),
          static_cast<double>(batch.dvdy[i])};
}

/// Clamps lambda to the range of footprints that matter for any level.
double bounded(double lambda) {
  return fmin(fmax(lambda, -15), 17);
}

/// The oracle's line with this number of probes, if one exists within rounding.
bool find_line(const ref::Image& image, const ref::Jacobian& j, int count, ref::Line* out) {
  for (const double slack : {0.0, -2e-4, 2e-4}) {
    *out = ref::profile_line(image, j, slack);
    if (out->count == count) return true;
  }
  return false;
}

/// Compares lookup i of the batch, which is lookup k of the block.
void check_line(const char* name, const ref::Image& image, size_t i, size_t k) {
  const double limit = static_cast<double>(image.sampler->max_anisotropy);
  ref::Line want;
  if (!find_line(image, jacobian(t_batch, i), static_cast<int>(t_block.probes[k]), &want)) {
    fail_msg("%s: point %zu: %g probes, want %d", name, i, static_cast<double>(t_block.probes[k]), want.count);
  }
  const double reach = fmax(hypot(want.du, want.dv), 1e-12) / 2;
  shd_assert_close(name, i, static_cast<double>(t_block.lod[k]), ref::profile_lod(image, want.lambda),
                   3e-6 * limit + (image.sampler->profile == SHD_PROFILE_OIIO ? 0 : 1.001 / 256), 0);
  if (want.count == 1) return;
  // For a round footprint the axis has no direction; then there is one probe.
  const double turn = 1e-5 * limit / (limit > 1 ? fmin(want.count, limit) - 0.99 : 1) + 1e-5 * limit;
  const double got_u = static_cast<double>(t_block.step_u[k]), got_v = static_cast<double>(t_block.step_v[k]);
  const double sign = got_u * want.du + got_v * want.dv < 0 ? -1 : 1;
  shd_assert_close(name, i, sign * got_u, want.du / 2, turn * reach, 0);
  shd_assert_close(name, i, sign * got_v, want.dv / 2, turn * reach, 0);
  if (want.scale > 0) {
    shd_assert_close(name, i, static_cast<double>(t_block.reach[k]), 2 / want.scale, 0, 1e-5 * limit);
  }
}

/// Levels of detail and probes, with width, bias, clamps and the blur of OpenImageIO.
void test_lines(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  Texture* texture = random_texture(SHD_FORMAT_R8, c.width, c.height, true);
  make_points(&t_batch);
  for (const shd_profile profile : kProfiles) {
    for (uint32_t round = 0; round < 20; ++round) {
      shd_sampler_desc desc = make_desc(profile, SHD_FILTER_ANISOTROPIC, round);
      if (round % 3 == 1) desc.width_x = 2.5f;
      if (round % 3 == 2) desc.lod_bias = -1.75f;
      if (round % 4 == 3) desc.lod_max = 2.3f;
      if (profile == SHD_PROFILE_OIIO && round % 5 == 2) desc.blur_u = 0.0625f, desc.blur_v = 0.25f;
      ref::Level levels[shd::texture::kMaxLevels];
      const ref::Image image = oracle_image(*texture, desc, levels);
      const Sampler sampler = make_sampler(desc);
      for_each_target([&](int64_t target) {
        const auto simd = shd::core::simd_target_from_bit(target);
        size_t nonfinite = 0;
        for (size_t first = 0; first < kPoints; first += 32) {
          const Lookups part = shd::texture::part_of(t_batch.lookups(true, false), first, 32);
          nonfinite += shd::texture::find_probes(*texture, sampler, simd, part, &t_block);
          for (size_t k = 0; k < 32; ++k) check_line(c.name, image, first + k, k);
        }
        assert_int_equal(nonfinite, kNonfinitePoints);
        float lod[kMaxPoints];
        shd::texture::find_lods(*texture, sampler, {-15, 17}, LodAxis::kLonger, simd, t_batch.lookups(true, false),
                                lod);
        for (size_t i = 0; i < t_batch.count; ++i) {
          const double lambda = ref::profile_lambda(image, jacobian(t_batch, i), false);
          const double want = bounded(bounded(lambda) + static_cast<double>(desc.lod_bias));
          if (lambda > -14 && lambda < 16) shd_assert_close(c.name, i, static_cast<double>(lod[i]), want, 4e-6, 0);
        }
      });
    }
  }
  free_texture(texture);
}

bool matches(const ref::Image& image, shd_filter filter, size_t i, int channel, double got) {
  const double u = static_cast<double>(t_batch.u[i]), v = static_cast<double>(t_batch.v[i]);
  const double w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  const double m = fmax(magnitude(image.format), 2), limit = static_cast<double>(image.sampler->max_anisotropy);
  const double exact = m * (3e-7 + 8e-7 * (w + h) + 8e-6 + 8e-6 * limit);
  const double rounded = image.sampler->profile == SHD_PROFILE_OIIO ? 0 : 2 * m * (2.0 / 512 + 1.0 / 256);
  const ref::Jacobian j = jacobian(t_batch, i);
  for (const double slack : {0.0, -4e-6, 4e-6}) {
    double want = 0;
    const bool blends = filter == SHD_FILTER_TRILINEAR || filter == SHD_FILTER_NEAREST_MIP_LINEAR;
    const double lambda = ref::profile_lambda(image, j, !blends) + slack;
    const int level = ref::profile_level(image, lambda);
    if (filter == SHD_FILTER_NEAREST_MIP) {
      const double lw = static_cast<double>(image.levels[level].width);
      const double lh = static_cast<double>(image.levels[level].height);
      for (const double dx : {0.0, -4e-7 * lw, 4e-7 * lw}) {
        for (const double dy : {0.0, -4e-7 * lh, 4e-7 * lh}) {
          if (shd_is_close(got, ref::nearest_on(image, level, u, v, dx, dy, channel), 1.2e-7, 1.2e-7)) return true;
        }
      }
      continue;
    }
    if (filter == SHD_FILTER_NEAREST_MIP_LINEAR) {
      const double lod = ref::profile_lod(image, lambda), bound = rounded > 0 ? 2 * m / 256 : 2e-5 * m;
      if (ref::is_nearest_blend(image, lod, u, v, channel, got, bound)) return true;
      continue;
    }
    if (filter == SHD_FILTER_BILINEAR_MIP) want = ref::bilinear(image, level, u, v, channel);
    if (filter == SHD_FILTER_TRILINEAR) want = ref::trilinear_at(image, u, v, ref::profile_lod(image, lambda), channel);
    if (filter == SHD_FILTER_ANISOTROPIC) {
      want = ref::profile_anisotropic(image, ref::profile_line(image, j, slack * 50), u, v, channel);
    }
    if (shd_is_close(got, want, exact + rounded, 0)) return true;
  }
  return false;
}

/// Fails unless the lookup has the oracle's value in every channel.
void check_values(const SizeCase& c, const ref::Image& image, size_t i) {
  const shd_sampler_desc& desc = *image.sampler;
  for (int channel = 0; channel < 4; ++channel) {
    const auto got = static_cast<double>(t_batch.out[channel][i]);
    if (matches(image, desc.filter, i, channel, got)) continue;
    fail_msg("%s: profile %d filter %d format %d wraps %d %d: point %zu channel %d: %.9g", c.name, desc.profile,
             desc.filter, image.format, desc.wrap_u, desc.wrap_v, i, channel, got);
  }
}

void test_values(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  const shd_format formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RG8_SRGB, SHD_FORMAT_R16, SHD_FORMAT_RGBA32F};
  make_points(&t_batch);
  for (const shd_format format : formats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (uint32_t k = 0; k < 7 * kProfiledCount; ++k) {
      check_against_oracle(*texture,
                           make_desc(kProfiles[k % 3], kFilters[k / 3 % kFilterCount], k / kProfiledCount * 4),
                           t_batch.lookups(true, false), &t_batch,
                           [&](const ref::Image& image, size_t i) { check_values(c, image, i); });
    }
    free_texture(texture);
  }
}

/// dX = (8, 0), dY = (8, 1) in texels: the axes are 11.34 and 0.706 long, the derivatives 8 and 8.06.
void test_sheared(void**) {
  uint8_t texels[1] = {0};
  Texture* texture = make_texture(SHD_FORMAT_R8, 1, 1, texels, true);
  t_batch.count = 1;
  t_batch.u[0] = t_batch.v[0] = 0.5f;
  t_batch.dudx[0] = 8;
  t_batch.dvdx[0] = 0;
  t_batch.dudy[0] = 8;
  t_batch.dvdy[0] = 1;
  const double want[] = {3.0, -0.4968, -0.4999};  // 11.34 / 16; for OpenImageIO the mean of this and 0.7056
  const double want_lambda[] = {3.011, 3.503, 7};
  const double want_count[] = {2, 12, 31};
  for (int k = 0; k < 3; ++k) {
    const Sampler sampler = make_sampler(make_desc(kProfiles[k], SHD_FILTER_ANISOTROPIC, 0));
    for_each_target([&](int64_t target) {
      const auto simd = shd::core::simd_target_from_bit(target);
      float lod;
      shd::texture::find_lods(*texture, sampler, {-32, 32}, LodAxis::kProbes, simd, t_batch.lookups(true, false), &lod);
      shd_assert_close("sheared", static_cast<size_t>(k), static_cast<double>(lod), want[k], 1e-3, 0);
      shd::texture::find_probes(*texture, sampler, simd, t_batch.lookups(true, false), &t_block);
      assert_true(t_block.probes[0] == static_cast<float>(want_count[k]));
      if (k == 2) return;
      shd::texture::find_lods(*texture, sampler, {-32, 32}, LodAxis::kLonger, simd, t_batch.lookups(true, false), &lod);
      shd_assert_close("sheared", static_cast<size_t>(k), static_cast<double>(lod), want_lambda[k], 1e-3, 0);
    });
  }
  free_texture(texture);
}

/// For parallel derivatives Direct3D uses the longer one, while the ellipse is as long as both together.
void test_parallel(void**) {
  uint8_t texels[1] = {0};
  Texture* texture = make_texture(SHD_FORMAT_R8, 1, 1, texels, true);
  t_batch.count = 1;
  t_batch.u[0] = t_batch.v[0] = 0.5f;
  t_batch.dudx[0] = t_batch.dvdx[0] = 3;
  t_batch.dudy[0] = t_batch.dvdy[0] = -4;
  const Sampler sampler = make_sampler(make_desc(SHD_PROFILE_D3D11, SHD_FILTER_ANISOTROPIC, 0));
  for_each_target([&](int64_t target) {
    float lod;
    shd::texture::find_lods(*texture, sampler, {-32, 32}, LodAxis::kProbes, shd::core::simd_target_from_bit(target),
                            t_batch.lookups(true, false), &lod);
    shd_assert_close("parallel", 0, static_cast<double>(lod), log2(sqrt(32) / 16), 1e-5, 0);
  });
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[48];
  static char names[2][8][32];
  size_t n = 0, k = 0;
  for (const SizeCase& c : k_sizes) {
    snprintf(names[0][k], sizeof names[0][k], "lines/%s", c.name);
    snprintf(names[1][k], sizeof names[1][k], "values/%s", c.name);
    tests[n++] = {names[0][k], test_lines, nullptr, nullptr, const_cast<SizeCase*>(&c)};
    tests[n++] = {names[1][k++], test_values, nullptr, nullptr, const_cast<SizeCase*>(&c)};
  }
  tests[n++] = {"sheared", test_sheared, nullptr, nullptr, nullptr};
  tests[n++] = {"parallel", test_parallel, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.profile", tests, n, nullptr, nullptr);
}
