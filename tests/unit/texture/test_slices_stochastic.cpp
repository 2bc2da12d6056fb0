// SPDX-License-Identifier: MIT
// Stochastic filtering of 3D textures: the share of the samples that pick a texel is its weight in the filter that
// they estimate, by Hoeffding's inequality; means on several levels; bits of all targets and tails.
#include "filter_cases.h"
#include "solids.h"
#include "support/statistics.h"

namespace {

using namespace fixture;
using shd::tests::hoeffding;

SolidBatch t_batch, t_other;
uint32_t t_random[kMaxPoints];

constexpr struct {
  shd_filter filter;
  shd_stochastic stochastic;
} kDraws[] = {{SHD_FILTER_BILINEAR, SHD_STOCHASTIC_TEXEL},  {SHD_FILTER_BICUBIC, SHD_STOCHASTIC_TEXEL},
              {SHD_FILTER_TRILINEAR, SHD_STOCHASTIC_TEXEL}, {SHD_FILTER_ANISOTROPIC, SHD_STOCHASTIC_TEXEL},
              {SHD_FILTER_EWA, SHD_STOCHASTIC_TEXEL},       {SHD_FILTER_TRILINEAR, SHD_STOCHASTIC_QUAD},
              {SHD_FILTER_ANISOTROPIC, SHD_STOCHASTIC_QUAD}};

shd_sampler_desc stochastic_desc(size_t draw, uint32_t triple) {
  shd_sampler_desc desc = solid_sampler(SHD_FILTER_STOCHASTIC, triple);
  desc.stochastic_filter = kDraws[draw].filter;
  desc.stochastic = kDraws[draw].stochastic;
  desc.cubic = SHD_CUBIC_B_SPLINE;
  return desc;
}

Lookups randomized() {
  Lookups lookups = t_batch.places(true, false);
  lookups.random = t_random;
  return lookups;
}

/// Samples of one lookup with the random words first, first + 1, ...
void make_samples(const float (&place)[3], const float (&x)[3], const float (&y)[3], uint32_t first) {
  float* const columns[9] = {t_batch.u,    t_batch.v,    t_batch.w,    t_batch.dudx, t_batch.dvdx,
                             t_batch.dwdx, t_batch.dudy, t_batch.dvdy, t_batch.dwdy};
  t_batch.count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    for (size_t a = 0; a < 3; ++a) {
      columns[a][i] = place[a];
      columns[3 + a][i] = x[a];
      columns[6 + a][i] = y[a];
    }
    t_random[i] = first + static_cast<uint32_t>(i);
  }
}

/// Each texel separately; its weight is the value of the filter where only this texel is not 0.
void test_weights(void**) {
  constexpr uint32_t kSamples = 1u << 18, kEdge = 6, kTexels = kEdge * kEdge * kEdge;
  const float place[] = {0.45f, 0.62f, 0.53f}, x[] = {0.3f, 0.05f, -0.2f}, y[] = {-0.02f, 0.15f, 0.1f};
  uint8_t* texels = solid_texels(SHD_FORMAT_R8, {"", kEdge, kEdge, kEdge}, 1);
  shd_texture_desc made = solid_desc(SHD_FORMAT_R8, {"", kEdge, kEdge, kEdge}, texels);
  made.tables = SHD_TABLE_NONE;
  for (size_t draw = 0; draw < 5; ++draw) {
    for (uint32_t i = 0; i < kTexels; ++i) texels[i] = static_cast<uint8_t>(i);
    Texture* texture = build_solid(made);
    static uint32_t hits[256];
    memset(hits, 0, sizeof hits);
    shd_sampler_desc desc = stochastic_desc(draw, 0);
    for (uint32_t first = 0; first < kSamples; first += kMaxPoints) {
      make_samples(place, x, y, first);
      run(*texture, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], randomized(), &t_batch);
      for (size_t i = 0; i < kMaxPoints; ++i) ++hits[lroundf(t_batch.out[0][i] * 255)];
    }
    free_texture(texture);
    desc.filter = desc.stochastic_filter;
    t_batch.count = 1;
    double total = 0;
    for (uint32_t i = 0; i < kTexels; ++i) {
      memset(texels, 0, kTexels);
      texels[i] = 255;
      texture = build_solid(made);
      run(*texture, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], t_batch.places(true, false), &t_batch);
      const auto want = static_cast<double>(t_batch.out[0][0]);
      shd_assert_close("share", i, hits[i] / static_cast<double>(kSamples), want, hoeffding(1, kSamples) + 1e-4, 0);
      if (want == 0) assert_int_equal(hits[i], 0);
      total += want;
      free_texture(texture);
    }
    shd_assert_close("weights", draw, total, 1, 1e-5, 0);
  }
  free(texels);
}

/// Means on all levels, for texels, and for the two quads of a level.
void test_mean(void** state) {
  const auto& size = *static_cast<const SolidSize*>(*state);
  constexpr uint32_t kRounds = 8;
  Random random{99};
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F}) {
    Texture* texture = random_solid(format, size);
    for (size_t draw = 0; draw < sizeof kDraws / sizeof kDraws[0]; ++draw) {
      for (uint32_t triple = 0; triple < 25; triple += 2) {
        float lookup[3][3];
        const float scale = ldexpf(1, -static_cast<int>(random.next() >> 29));
        for (size_t k = 0; k < 9; ++k)
          lookup[k / 3][k % 3] = k < 3 ? random.real(-1.5f, 2.5f) : scale * random.real(-1, 1);
        shd_sampler_desc desc = stochastic_desc(draw, triple);
        double sum[4] = {0, 0, 0, 0};
        for (uint32_t round = 0; round < kRounds; ++round) {
          make_samples(lookup[0], lookup[1], lookup[2], round * kMaxPoints);
          run(*texture, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], randomized(), &t_batch);
          for (int c = 0; c < 4; ++c) {
            for (size_t i = 0; i < kMaxPoints; ++i) sum[c] += static_cast<double>(t_batch.out[c][i]);
          }
        }
        desc.filter = desc.stochastic_filter;
        t_batch.count = 1;
        run(*texture, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], t_batch.places(true, false),
            &t_batch);
        constexpr double kCount = kRounds * kMaxPoints;
        const double m = fmax(magnitude(format), 2);
        for (int c = 0; c < 4; ++c) {
          shd_assert_close(size.name, draw, sum[c] / kCount, static_cast<double>(t_batch.out[c][0]),
                           hoeffding(2 * m, kCount) + 1e-4 * m, 0);
        }
      }
    }
    free_texture(texture);
  }
}

/// Quads of the finest level have no variance.
void test_quads(void**) {
  const float place[] = {0.45f, 0.62f, 0.53f}, none[] = {0, 0, 0};
  Texture* texture = random_solid(SHD_FORMAT_RGBA32F, {"", 16, 16, 16});
  make_samples(place, none, none, 0);
  shd_sampler_desc desc = stochastic_desc(5, 0);
  run_everywhere(*texture, desc, randomized(), &t_batch);
  desc.filter = SHD_FILTER_BILINEAR;
  memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
  run_everywhere(*texture, desc, t_batch.places(true, false), &t_other);
  assert_memory_equal(t_batch.out, t_other.out, sizeof t_batch.out);
  free_texture(texture);
}

/// The bits are equal on every target and for every tail, with random words and with those of the place.
void test_targets_and_tails(void**) {
  Texture* texture = random_solid(SHD_FORMAT_RGBA16F, {"", 20, 12, 9});
  for (size_t i = 0; i < kMaxPoints; ++i) t_random[i] = static_cast<uint32_t>(i * 7);
  for (size_t draw = 0; draw < sizeof kDraws / sizeof kDraws[0]; ++draw) {
    for (const bool given : {false, true}) {
      const shd_sampler_desc desc = stochastic_desc(draw, 7);
      const auto lookups = [&] { return given ? randomized() : t_batch.places(true, false); };
      make_places(&t_batch);
      run_everywhere(*texture, desc, lookups(), &t_batch);
      memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
      for (size_t i = 0; i < kPoints; ++i) assert_true(isfinite(t_batch.out[0][i]));
      for (size_t count = 1; count <= 35; ++count) {
        t_batch.count = count;
        run_everywhere(*texture, desc, lookups(), &t_batch);
        for (size_t c = 0; c < 4; ++c) assert_memory_equal(t_batch.out[c], t_other.out[c], count * sizeof(float));
      }
    }
  }
  free_texture(texture);
}

/// Places that differ in w alone have different random numbers.
void test_hash_of_w(void**) {
  static float texels[64];
  for (size_t i = 0; i < 64; ++i) texels[i] = static_cast<float>(i % 2);
  Texture* texture = build_solid(solid_desc(SHD_FORMAT_R32F, {"", 4, 4, 4}, reinterpret_cast<uint8_t*>(texels)));
  make_places(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.25f;
    t_batch.w[i] = static_cast<float>(i) / kPoints;
  }
  run_everywhere(*texture, stochastic_desc(0, 0), t_batch.places(true, false), &t_batch);
  size_t odd = 0;
  for (size_t i = 0; i < kPoints; ++i) odd += t_batch.out[0][i] == 1.0f;
  assert_true(odd > kPoints / 4 && odd < kPoints * 3 / 4);
  free_texture(texture);
}

}  // namespace

int main() {
  static char names[6][32];
  CMUnitTest tests[16];
  size_t n = 0;
  for (const SolidSize& size : kSolidSizes) {
    snprintf(names[n], sizeof names[n], "mean/%s", size.name);
    tests[n] = {names[n], test_mean, nullptr, nullptr, const_cast<SolidSize*>(&size)};
    ++n;
  }
  tests[n++] = {"weights", test_weights, nullptr, nullptr, nullptr};
  tests[n++] = {"quads", test_quads, nullptr, nullptr, nullptr};
  tests[n++] = {"targets_and_tails", test_targets_and_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"hash_of_w", test_hash_of_w, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.slices_stochastic", tests, n, nullptr, nullptr);
}
