// SPDX-License-Identifier: MIT
// The elliptical weighted average against the oracle: every format x wrap pair x size x target, values and derivatives;
// hostile derivatives and texels; the number of taps.
#include "filter_cases.h"

#include "ref/ewa_ref.h"
#include "texture/oracle/explain.h"

namespace {

using namespace fixture;

Batch t_batch, t_first;

shd_sampler_desc ewa_desc(uint32_t pair) {
  const float limits[] = {16, 1, 3.5f, 64, 2};
  shd_sampler_desc desc = wrap_desc(SHD_FILTER_EWA, pair);
  desc.max_anisotropy = limits[(pair + pair / 5) % 5];
  return desc;
}

/// The footprint of a point in base texels.
ref::Ellipse ellipse_of(const Batch& batch, const ref::Image& image, bool lod, size_t i) {
  const auto w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  const double length = exp2(static_cast<double>(batch.lod[i]));
  if (lod) return {length, length, 1, 0};
  return ref::ellipse(ref::Jacobian{static_cast<double>(batch.dudx[i]) * w, static_cast<double>(batch.dvdx[i]) * h,
                                    static_cast<double>(batch.dudy[i]) * w, static_cast<double>(batch.dvdy[i]) * h});
}

/// Compares with the oracle, with either level where rounding decides between two.
void check_point(const SizeCase& c, const ref::Image& image, const Batch& batch, bool lod, size_t i) {
  const double u = static_cast<double>(batch.u[i]), v = static_cast<double>(batch.v[i]);
  const double limit = static_cast<double>(image.sampler->max_anisotropy);
  const ref::Ellipse e = ellipse_of(batch, image, lod, i);
  const double m = fmax(magnitude(image.format), 2);
  const double tolerance = m * (3e-6 + 4e-6 * (c.width + c.height) + 4e-6 * limit);
  const double level = ref::ewa_lod(image, e);
  const int low = static_cast<int>(fmax(floor(level - 1e-4), 0));
  const int high = static_cast<int>(fmin(floor(level + 1e-4), image.level_count - 1));
  double finer[4], coarser[4];
  ref::ewa(image, e, high, u, v, 0, 0, coarser);
  memcpy(finer, coarser, sizeof finer);
  if (low != high) ref::ewa(image, e, low, u, v, 0, 0, finer);
  for (int channel = 0; channel < 4; ++channel) {
    const double got = static_cast<double>(batch.out[channel][i]);
    if (shd_is_close(got, finer[channel], tolerance, 0)) continue;
    shd_assert_close(c.name, i, got, coarser[channel], tolerance, 0);
  }
}

void check_combination(const SizeCase& c, const Texture& texture, const shd_sampler_desc& desc, bool lod) {
  check_against_oracle(texture, desc, t_batch.lookups(!lod, lod), &t_batch,
                       [&](const ref::Image& image, size_t i) { check_point(c, image, t_batch, lod, i); });
}

void test_size(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      check_combination(c, *texture, ewa_desc(pair), false);
      if (pair % 6 == 0) check_combination(c, *texture, ewa_desc(pair), true);
    }
    free_texture(texture);
  }
}

void test_constant(void**) {
  check_constant_mipmap(25, ewa_desc);
}

void test_tails(void**) {
  check_tails_of_formats(ewa_desc(1), true);
}

void test_hostile_derivatives(void**) {
  check_hostile_footprints(ewa_desc);
}

void test_infinite(void**) {
  check_infinite(ewa_desc(0));
}

void test_nonfinite_texels(void**) {
  check_nonfinite_column(ewa_desc(0), 9, 7.5f);  // the ellipse is 2.7 texels wide, or bilinear without weight
}

/// For a circle, derivatives and level of detail give equal results.
void test_isotropic(void**) {
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 64, 32, true);
  make_points(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    t_batch.lod[i] = static_cast<float>(i) * 0.0371f - 0.5f;
    const float cosine = cosf(static_cast<float>(i)), sine = sinf(static_cast<float>(i)), s = exp2f(t_batch.lod[i]);
    t_batch.dudx[i] = s * cosine / 64;
    t_batch.dvdx[i] = s * sine / 32;
    t_batch.dudy[i] = -s * sine / 64;
    t_batch.dvdy[i] = s * cosine / 32;
  }
  for_each_target([&](int64_t target) {
    const Sampler sampler = make_sampler(ewa_desc(0));
    run(*texture, sampler, target, t_batch.lookups(true, false), &t_batch);
    memcpy(t_first.out, t_batch.out, sizeof t_batch.out);
    run(*texture, sampler, target, t_batch.lookups(false, true), &t_batch);
    for (int c = 0; c < 4; ++c) {
      for (size_t i = 0; i < kPoints; ++i) {
        shd_assert_close("isotropic", i, static_cast<double>(t_batch.out[c][i]), static_cast<double>(t_first.out[c][i]),
                         1e-4, 0);
      }
    }
  });
  free_texture(texture);
}

/// Compares with the oracle's derivatives near a point, because they jump where a texel enters the ellipse.
bool is_slope_near(const ref::Image& image, const ref::Ellipse& e, int level, size_t i, const float (*got)[kMaxPoints],
                   bool along_u, int channel, double tolerance) {
  const double size = static_cast<double>(along_u ? image.levels[0].width : image.levels[0].height);
  const double step = 1e-6 / size;
  for (int near = 0; near < 9; ++near) {
    const double du = (near % 3 - 1) * 2e-4 / static_cast<double>(image.levels[0].width);
    const double dv = (near / 3 - 1) * 2e-4 / static_cast<double>(image.levels[0].height);
    double before[4], after[4];
    const double u = static_cast<double>(t_batch.u[i]), v = static_cast<double>(t_batch.v[i]);
    ref::ewa(image, e, level, u, v, along_u ? du - step : du, along_u ? dv : dv - step, before);
    ref::ewa(image, e, level, u, v, along_u ? du + step : du, along_u ? dv : dv + step, after);
    const double slope = (after[channel] - before[channel]) / (2 * step);
    if (shd_is_close(static_cast<double>(got[channel][i]), slope, tolerance * size, 0)) return true;
  }
  return false;
}

/// Derivatives in u and v include the derivatives of the weights.
void test_derivatives(void**) {
  static float du[4][kMaxPoints], dv[4][kMaxPoints];
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F}) {
    Texture* texture = random_texture(format, 64, 32, true);
    for (uint32_t pair = 0; pair < 25; pair += 6) {
      const shd_sampler_desc desc = ewa_desc(pair);
      ref::Level levels[shd::texture::kMaxLevels];
      const ref::Image image = oracle_image(*texture, desc, levels);
      make_points(&t_batch);
      Random random{pair + 5};
      for (size_t i = 0; i < kPoints; ++i) {
        t_batch.u[i] = random.real(-1, 2);
        t_batch.v[i] = random.real(-1, 2);
      }
      uint64_t hash = 0;
      for_each_target([&](int64_t target) {
        const Texels out = {{}, {du[0], du[1], du[2], du[3]}, {dv[0], dv[1], dv[2], dv[3]}};
        shd::texture::sample(*texture, make_sampler(desc), shd::core::simd_target_from_bit(target),
                             t_batch.lookups(true, false), out);
        const uint64_t of_target = shd_hash(shd_hash(SHD_HASH_START, du, sizeof du), dv, sizeof dv);
        assert_true(hash == 0 || hash == of_target);
        hash = of_target;
      });
      for (size_t i = 0; i < kPoints; ++i) {
        const ref::Ellipse e = ellipse_of(t_batch, image, false, i);
        const double lod = ref::ewa_lod(image, e);
        if (floor(lod - 1e-4) != floor(lod + 1e-4)) continue;
        for (int c = 0; c < 4; ++c) {
          const double tolerance = 2e-3 * fmax(magnitude(format), 1);
          assert_true(is_slope_near(image, e, static_cast<int>(lod), i, du, true, c, tolerance));
          assert_true(is_slope_near(image, e, static_cast<int>(lod), i, dv, false, c, tolerance));
        }
      }
    }
    free_texture(texture);
  }
}

/// No lookup reads more than 16 (max_anisotropy + 1) texels, or fewer than two where the ellipse is used.
void test_taps(void**) {
  Texture* texture = random_texture(SHD_FORMAT_R8, 256, 128, true);
  Random random{3};
  uint32_t maximum = 0;
  for (const float limit : {1.0f, 2.0f, 16.0f, 64.0f}) {
    for (int n = 0; n < 4000; ++n) {
      shd_sampler_desc desc = ewa_desc(0);
      desc.max_anisotropy = limit;
      const Sampler sampler = make_sampler(desc);
      const float angle = random.real(0, 7), longer = exp2f(random.real(-1, 9)),
                  shorter = longer * random.real(0, 1.2f) / limit;
      const float u = random.real(0, 1), v = random.real(0, 1);
      const float dudx = longer * cosf(angle) / 256, dvdx = longer * sinf(angle) / 128;
      const float dudy = -shorter * sinf(angle) / 256, dvdy = shorter * cosf(angle) / 128;
      const Lookups lookup = {1, &u, &v, &dudx, &dvdx, &dudy, &dvdy, nullptr, nullptr, nullptr};
      shd_explanation explanation = {};
      shd::texture::explain(*context(), *texture, sampler, lookup, &explanation);
      assert_true(static_cast<float>(explanation.tap_count) <= 16 * (limit + 1));
      assert_true(explanation.tap_count >= 2);
      if (limit == 64.0f && explanation.tap_count > maximum) maximum = explanation.tap_count;
    }
  }
  assert_true(maximum > 512);
  free_texture(texture);
}

void test_layers(void**) {
  check_layers(ewa_desc(0));
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = add_sizes("ewa", test_size, tests);
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"isotropic", test_isotropic, nullptr, nullptr, nullptr};
  tests[n++] = {"derivatives", test_derivatives, nullptr, nullptr, nullptr};
  tests[n++] = {"taps", test_taps, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile_derivatives", test_hostile_derivatives, nullptr, nullptr, nullptr};
  tests[n++] = {"infinite", test_infinite, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite_texels", test_nonfinite_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"layers", test_layers, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.ewa", tests, n, nullptr, nullptr);
}
