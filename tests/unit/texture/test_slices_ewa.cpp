// SPDX-License-Identifier: MIT
// EWA in 3D textures against the oracle on every target: values, derivatives, texels read, and footprints without a
// plane.
#include "filter_cases.h"
#include "solids.h"

#include "ref/ellipsoid_ref.h"
#include "texture/oracle/explain.h"

namespace {

using namespace fixture;

SolidBatch t_batch, t_other;

shd_sampler_desc ewa_desc(uint32_t triple) {
  const float limits[] = {16, 1, 3.5f, 2, 8};
  shd_sampler_desc desc = solid_sampler(SHD_FILTER_EWA, triple);
  desc.max_anisotropy = limits[(triple + triple / 5) % 5];
  return desc;
}

/// The bound stated in sample.h.
double bound(const SolidSize& size, const shd_sampler_desc& desc, double m) {
  const double sizes = size.width + size.height + size.depth;
  return m * (3e-5 + 4e-6 * sizes + 4e-6 * static_cast<double>(desc.max_anisotropy));
}

ref::Spread spread_of(const SolidSize& size, bool lod, size_t i) {
  const double length = exp2(static_cast<double>(t_batch.lod[i]));
  return lod ? ref::Spread{length, length, {1, 0, 0}, {0, 0, 0}} : spread_at(t_batch, size, i);
}

/// Compares with the oracle, with either level where rounding decides between two.
void check_point(const SolidSize& size, const ref::Solid& solid, bool lod, size_t i) {
  const ref::Spread s = spread_of(size, lod, i);
  const double level = ref::ewa_lod(solid, s);
  const int low = static_cast<int>(fmax(floor(level - 1e-4), 0));
  const int high = static_cast<int>(fmin(floor(level + 1e-4), solid.level_count - 1));
  const double tolerance = bound(size, *solid.sampler, fmax(magnitude(solid.format), 2));
  double finer[4], coarser[4];
  ref::ewa(solid, s, high, place_of(t_batch, i), {0, 0, 0}, coarser);
  memcpy(finer, coarser, sizeof finer);
  if (low != high) ref::ewa(solid, s, low, place_of(t_batch, i), {0, 0, 0}, finer);
  for (int c = 0; c < 4; ++c) {
    const double got = static_cast<double>(t_batch.out[c][i]);
    if (shd_is_close(got, finer[c], tolerance, 0)) continue;
    shd_assert_close(size.name, i, got, coarser[c], tolerance, 0);
  }
}

void check_combination(const Texture& texture, const SolidSize& size, const shd_sampler_desc& desc, bool lod) {
  ref::SolidLevel levels[shd::texture::kMaxLevels];
  const ref::Solid solid = oracle_solid(texture, desc, levels);
  run_everywhere(texture, desc, t_batch.places(!lod, lod), &t_batch);
  for (size_t i = 0; i < kPoints; ++i) check_point(size, solid, lod, i);
}

void test_size(void** state) {
  const auto& size = *static_cast<const SolidSize*>(*state);
  make_places(&t_batch);
  uint32_t triple = 0;
  for (const shd_format format : kSolidFormats) {
    Texture* texture = random_solid(format, size);
    for (int k = 0; k < 4; ++k) check_combination(*texture, size, ewa_desc(triple++ * 7 % 25), false);
    check_combination(*texture, size, ewa_desc(triple++ * 7 % 25), true);
    free_texture(texture);
  }
}

/// Thin footprints: parallel derivatives, and derivatives that differ by little more than rounding errors.
void test_thin(void**) {
  const SolidSize size = {"thin", 32, 16, 24};
  Texture* texture = random_solid(SHD_FORMAT_RGBA32F, size);
  Random random{77};
  make_places(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    float *const x[] = {t_batch.dudx, t_batch.dvdx, t_batch.dwdx}, *const y[] = {t_batch.dudy, t_batch.dvdy,
                                                                                 t_batch.dwdy};
    const float along = random.real(-1, 1), aside = i % 4 == 0 ? 0 : ldexpf(1, -4 - static_cast<int>(i % 24));
    const int only = i % 7 < 3 ? static_cast<int>(i % 7) : -1;  // along one axis of the texture
    for (int a = 0; a < 3; ++a) {
      x[a][i] = only < 0 || only == a ? random.real(-0.3f, 0.3f) : 0;
      y[a][i] = x[a][i] * along + aside * random.real(-0.3f, 0.3f);
    }
  }
  for (uint32_t triple = 0; triple < 25; ++triple) check_combination(*texture, size, ewa_desc(triple), false);
  free_texture(texture);
}

/// Compares with the oracle's derivatives near a place, because they jump where a texel enters the ellipsoid.
bool is_slope_near(const ref::Solid& solid, const ref::Spread& s, size_t i, int axis, const float (*got)[kMaxPoints],
                   int channel, double tolerance) {
  const ref::SolidLevel& base = solid.levels[0];
  const double size = static_cast<double>(axis == 0   ? base.width
                                          : axis == 1 ? base.height
                                                      : base.depth),
               step = 1e-6 / size;
  const int level = static_cast<int>(ref::ewa_lod(solid, s));
  for (int near = 0; near < 27; ++near) {
    const auto nudge = [](int k, int64_t n) { return (k - 1) * 2e-4 / static_cast<double>(n); };
    ref::Place moved = {nudge(near % 3, base.width), nudge(near / 3 % 3, base.height), nudge(near / 9, base.depth)};
    double& along = axis == 0 ? moved.u : axis == 1 ? moved.v : moved.w;
    double before[4], after[4];
    along -= step;
    ref::ewa(solid, s, level, place_of(t_batch, i), moved, before);
    along += 2 * step;
    ref::ewa(solid, s, level, place_of(t_batch, i), moved, after);
    const double slope = (after[channel] - before[channel]) / (2 * step);
    if (shd_is_close(static_cast<double>(got[channel][i]), slope, tolerance * size, 0)) return true;
  }
  return false;
}

/// Derivatives in u, v and w include the derivatives of the weights, and do not change values.
void test_derivatives(void**) {
  static float slopes[3][4][kMaxPoints];
  const SolidSize size = {"", 32, 16, 24};
  make_places(&t_batch);
  Random random{5};
  for (size_t i = 0; i < kPoints; ++i) {
    t_batch.u[i] = random.real(-1, 2);
    t_batch.v[i] = random.real(-1, 2);
    t_batch.w[i] = random.real(-1, 2);
  }
  memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F}) {
    Texture* texture = random_solid(format, size);
    for (const uint32_t triple : {0u, 6u, 17u, 23u}) {
      const shd_sampler_desc desc = ewa_desc(triple);
      ref::SolidLevel levels[shd::texture::kMaxLevels];
      const ref::Solid solid = oracle_solid(*texture, desc, levels);
      run_everywhere(*texture, desc, t_batch.places(true, false), &t_other);
      uint64_t hash = 0;
      for_each_target([&](int64_t target) {
        Texels out = {};
        for (int c = 0; c < 4; ++c) {
          out.channel[c] = t_batch.out[c];
          out.du[c] = slopes[0][c];
          out.dv[c] = slopes[1][c];
          out.dw[c] = slopes[2][c];
        }
        shd::texture::sample(*texture, make_sampler(desc), shd::core::simd_target_from_bit(target),
                             t_batch.places(true, false), out);
        for (int c = 0; c < 4; ++c) assert_memory_equal(t_batch.out[c], t_other.out[c], kPoints * sizeof(float));
        const uint64_t of_target = shd_hash(SHD_HASH_START, slopes, sizeof slopes);
        assert_true(hash == 0 || hash == of_target);
        hash = of_target;
      });
      for (size_t i = 0; i < kPoints; ++i) {
        const ref::Spread s = spread_at(t_batch, size, i);
        const double lod = ref::ewa_lod(solid, s);
        if (floor(lod - 1e-4) != floor(lod + 1e-4)) continue;
        for (int k = 0; k < 6; ++k) {
          assert_true(is_slope_near(solid, s, i, k % 3, slopes[k % 3], k / 3 * 2, 4e-3 * fmax(magnitude(format), 1)));
        }
      }
    }
    free_texture(texture);
  }
}

/// No lookup reads more than 64 (max_anisotropy + 1) texels, or none.
void test_taps(void**) {
  Texture* texture = random_solid(SHD_FORMAT_R8, {"", 128, 128, 128});
  Random random{3};
  uint32_t maximum = 0;
  t_batch.count = 1;
  for (const float limit : {1.0f, 2.0f, 16.0f, 64.0f}) {
    for (int n = 0; n < 2000; ++n) {
      shd_sampler_desc desc = ewa_desc(0);
      desc.max_anisotropy = limit;
      const float longer = exp2f(random.real(-1, 8)) / 128, shorter = longer * random.real(0, 1.2f) / limit;
      for (float* at : {t_batch.u, t_batch.v, t_batch.w}) *at = random.real(0, 1);
      for (float* x : {t_batch.dudx, t_batch.dvdx, t_batch.dwdx}) *x = longer * random.real(-1, 1);
      for (float* y : {t_batch.dudy, t_batch.dvdy, t_batch.dwdy}) *y = shorter * random.real(-1, 1);
      shd_explanation explanation = {};
      shd::texture::explain(*context(), *texture, make_sampler(desc), t_batch.places(true, false), &explanation);
      assert_true(static_cast<float>(explanation.tap_count) <= 64 * (limit + 1));
      assert_true(explanation.tap_count >= 1);
      if (limit == 64.0f && explanation.tap_count > maximum) maximum = explanation.tap_count;
    }
  }
  assert_true(maximum > 512);
  free_texture(texture);
}

}  // namespace

int main() {
  static char names[6][32];
  CMUnitTest tests[16];
  size_t n = 0;
  for (const SolidSize& size : kSolidSizes) {
    snprintf(names[n], sizeof names[n], "oracle/%s", size.name);
    tests[n] = {names[n], test_size, nullptr, nullptr, const_cast<SolidSize*>(&size)};
    ++n;
  }
  tests[n++] = {"thin", test_thin, nullptr, nullptr, nullptr};
  tests[n++] = {"derivatives", test_derivatives, nullptr, nullptr, nullptr};
  tests[n++] = {"taps", test_taps, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.slices_ewa", tests, n, nullptr, nullptr);
}
