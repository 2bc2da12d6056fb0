// SPDX-License-Identifier: MIT
// Stochastic filtering: means of many samples against their expectation, by Hoeffding's inequality, and
// properties of single samples.
#include "points.h"

#include "ref/ewa_ref.h"
#include "support/statistics.h"

namespace {

using namespace fixture;
using shd::tests::hoeffding;

struct stochastic_case {
  const char* name;
  shd_filter stochastic_filter;
  uint32_t width, height;
  shd_stochastic stochastic = SHD_STOCHASTIC_TEXEL;
};
const stochastic_case k_cases[] = {
    {"bilinear/1x7", SHD_FILTER_BILINEAR, 1, 7},
    {"bilinear/5x3", SHD_FILTER_BILINEAR, 5, 3},
    {"bilinear/128x32", SHD_FILTER_BILINEAR, 128, 32},
    {"bicubic/1x1", SHD_FILTER_BICUBIC, 1, 1},
    {"bicubic/5x3", SHD_FILTER_BICUBIC, 5, 3},
    {"bicubic/64x64", SHD_FILTER_BICUBIC, 64, 64},
    {"trilinear/1x1", SHD_FILTER_TRILINEAR, 1, 1},
    {"trilinear/5x3", SHD_FILTER_TRILINEAR, 5, 3},
    {"trilinear/128x32", SHD_FILTER_TRILINEAR, 128, 32},
    {"trilinear/1023x511", SHD_FILTER_TRILINEAR, 1023, 511},
    {"trilinear/4096x1", SHD_FILTER_TRILINEAR, 4096, 1},
    {"anisotropic/1x1", SHD_FILTER_ANISOTROPIC, 1, 1},
    {"anisotropic/5x3", SHD_FILTER_ANISOTROPIC, 5, 3},
    {"anisotropic/64x64", SHD_FILTER_ANISOTROPIC, 64, 64},
    {"anisotropic/1023x511", SHD_FILTER_ANISOTROPIC, 1023, 511},
    {"anisotropic/4096x1", SHD_FILTER_ANISOTROPIC, 4096, 1},
    {"quad_trilinear/1x1", SHD_FILTER_TRILINEAR, 1, 1, SHD_STOCHASTIC_QUAD},
    {"quad_trilinear/5x3", SHD_FILTER_TRILINEAR, 5, 3, SHD_STOCHASTIC_QUAD},
    {"quad_trilinear/1023x511", SHD_FILTER_TRILINEAR, 1023, 511, SHD_STOCHASTIC_QUAD},
    {"quad_anisotropic/5x3", SHD_FILTER_ANISOTROPIC, 5, 3, SHD_STOCHASTIC_QUAD},
    {"quad_anisotropic/64x64", SHD_FILTER_ANISOTROPIC, 64, 64, SHD_STOCHASTIC_QUAD},
    {"quad_anisotropic/4096x1", SHD_FILTER_ANISOTROPIC, 4096, 1, SHD_STOCHASTIC_QUAD},
    {"ewa/1x1", SHD_FILTER_EWA, 1, 1},
    {"ewa/1x7", SHD_FILTER_EWA, 1, 7},
    {"ewa/5x3", SHD_FILTER_EWA, 5, 3},
    {"ewa/64x64", SHD_FILTER_EWA, 64, 64},
    {"ewa/1023x511", SHD_FILTER_EWA, 1023, 511},
    {"ewa/4096x1", SHD_FILTER_EWA, 4096, 1},
};
constexpr shd_filter kStochasticFilters[] = {SHD_FILTER_BILINEAR, SHD_FILTER_BICUBIC, SHD_FILTER_TRILINEAR,
                                             SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA};
constexpr struct {
  shd_filter filter;
  shd_stochastic stochastic;
} kDraws[] = {{SHD_FILTER_BILINEAR, SHD_STOCHASTIC_TEXEL},  {SHD_FILTER_BICUBIC, SHD_STOCHASTIC_TEXEL},
              {SHD_FILTER_TRILINEAR, SHD_STOCHASTIC_TEXEL}, {SHD_FILTER_ANISOTROPIC, SHD_STOCHASTIC_TEXEL},
              {SHD_FILTER_EWA, SHD_STOCHASTIC_TEXEL},       {SHD_FILTER_TRILINEAR, SHD_STOCHASTIC_QUAD},
              {SHD_FILTER_ANISOTROPIC, SHD_STOCHASTIC_QUAD}};
constexpr size_t kRounds = 8;  // rounds of kMaxPoints samples

Batch t_batch, t_first;
uint32_t t_random[kMaxPoints];

shd_sampler_desc make_desc(shd_filter stochastic_filter, uint32_t pair) {
  const float border[] = {0.25f, -1.5f, 2.0f, 0.75f};
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_STOCHASTIC;
  desc.profile = SHD_PROFILE_EXACT;
  desc.stochastic_filter = stochastic_filter;
  desc.cubic = SHD_CUBIC_B_SPLINE;
  desc.wrap_u = static_cast<shd_wrap>(pair % 5);
  desc.wrap_v = static_cast<shd_wrap>(pair / 5);
  const float limits[] = {16, 1, 3.5f, 64, 2};
  if (stochastic_filter == SHD_FILTER_EWA) desc.max_anisotropy = limits[(pair + pair / 5) % 5];
  desc.probe_weights = pair % 2 ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
  memcpy(desc.border, border, sizeof border);
  return desc;
}

/// Position of samples: a level of detail, or for anisotropic filters a footprint with this longer axis.
struct Place {
  float u, v, lod;
  float aspect, angle;
};

Lookups randomized(const Batch& batch, bool footprints) {
  Lookups lookups = batch.lookups(footprints, !footprints);
  lookups.random = t_random;
  return lookups;
}

/// Derivatives of (u, v) for a texture of w x h.
ref::Jacobian jacobian(const Place& at, float w, float h) {
  const double length = exp2(static_cast<double>(at.lod)), angle = static_cast<double>(at.angle);
  const double other = length / static_cast<double>(at.aspect);
  return {length * cos(angle) / static_cast<double>(w), length * sin(angle) / static_cast<double>(h),
          -other * sin(angle) / static_cast<double>(w), other * cos(angle) / static_cast<double>(h)};
}

/// Samples at one position with the random words first, first + 1, ...
void make_samples(const Place& at, const ref::Jacobian& j, uint32_t first) {
  t_batch.count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    t_batch.u[i] = at.u;
    t_batch.v[i] = at.v;
    t_batch.lod[i] = at.lod;
    t_batch.dudx[i] = static_cast<float>(j.ux);
    t_batch.dvdx[i] = static_cast<float>(j.vx);
    t_batch.dudy[i] = static_cast<float>(j.uy);
    t_batch.dvdy[i] = static_cast<float>(j.vy);
    t_random[i] = first + static_cast<uint32_t>(i);
  }
}
void make_samples(float u, float v, float lod, uint32_t first) {
  make_samples({u, v, lod, 1, 0}, {0, 0, 0, 0}, first);
}

/// The footprint in base texels.
ref::Ellipse ellipse_of(const ref::Image& image, const ref::Jacobian& j) {
  const double w = image.levels[0].width, h = image.levels[0].height;
  return ref::ellipse(ref::Jacobian{j.ux * w, j.vx * h, j.uy * w, j.vy * h});
}

/// Whether rounding decides between two levels.
bool is_between_levels(const ref::Image& image, const ref::Jacobian& j) {
  const double lod = ref::ewa_lod(image, ellipse_of(image, j));
  return lod > 1e-3 && lod < image.level_count - 1 && floor(lod - 1e-4) != floor(lod + 1e-4);
}

double expected(const ref::Image& image, const Place& at, const ref::Jacobian& j, int channel) {
  const double u = static_cast<double>(at.u), v = static_cast<double>(at.v);
  switch (image.sampler->stochastic_filter) {
    case SHD_FILTER_BILINEAR: return ref::bilinear(image, 0, u, v, channel);
    case SHD_FILTER_BICUBIC: return ref::bicubic(image, u, v, channel);
    case SHD_FILTER_TRILINEAR: return ref::trilinear(image, u, v, static_cast<double>(at.lod), channel);
    default: break;
  }
  const ref::Ellipse e = ellipse_of(image, j);
  if (image.sampler->stochastic_filter == SHD_FILTER_EWA) {
    double texel[4];
    ref::ewa(image, e, static_cast<int>(ref::ewa_lod(image, e)), u, v, 0, 0, texel);
    return texel[channel];
  }
  const double ratio = ref::aspect(e, static_cast<double>(image.sampler->max_anisotropy));
  return ref::anisotropic(image, e, static_cast<int>(ceil(ratio - 0.125)), u, v, channel);
}

void check_mean(const stochastic_case& c, const Texture& texture, const shd_sampler_desc& desc, const Place& at) {
  ref::Level levels[shd::texture::kMaxLevels];
  const ref::Image image = oracle_image(texture, desc, levels);
  const Sampler sampler = make_sampler(desc);
  const ref::Jacobian j = jacobian(at, static_cast<float>(c.width), static_cast<float>(c.height));
  const bool ellipses = desc.stochastic_filter == SHD_FILTER_EWA;
  const bool footprints = desc.stochastic_filter == SHD_FILTER_ANISOTROPIC || (ellipses && at.aspect > 1);
  if (ellipses && is_between_levels(image, j)) return;
  double sum[4] = {0, 0, 0, 0};
  for (size_t round = 0; round < kRounds; ++round) {
    make_samples(at, j, static_cast<uint32_t>(round * kMaxPoints));
    run(texture, sampler, hwy::SupportedAndGeneratedTargets()[0], randomized(t_batch, footprints), &t_batch);
    for (int k = 0; k < 4; ++k) {
      for (size_t i = 0; i < kMaxPoints; ++i) sum[k] += static_cast<double>(t_batch.out[k][i]);
    }
  }
  constexpr double kCount = kRounds * kMaxPoints;
  const double m = fmax(magnitude(texture.format), 2);
  const double bound = hoeffding(2 * m, kCount) + m * (2e-6 + 8e-7 * (c.width + c.height));
  for (int k = 0; k < 4; ++k) {
    const double want = expected(image, at, j, k);
    shd_assert_close(c.name, static_cast<size_t>(k), sum[k] / kCount, want, bound, 0);
  }
}

void test_mean(void** state) {
  const auto& c = *static_cast<const stochastic_case*>(*state);
  Random random{99};
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      for (int point = 0; point < 3; ++point) {
        Place at;
        at.u = random.real(-1.5f, 2.5f);
        at.v = random.real(-1.5f, 2.5f);
        at.lod = random.real(-1, 8);
        at.angle = random.real(-3, 3);
        at.aspect = floorf(random.real(1, 20)) + 0.5f;  // far from a change of the number of probes
        if (c.stochastic_filter == SHD_FILTER_EWA && pair % 6 == 0) at.aspect = 1;  // by level of detail
        shd_sampler_desc desc = make_desc(c.stochastic_filter, pair);
        desc.stochastic = c.stochastic;
        check_mean(c, *texture, desc, at);
      }
    }
    free_texture(texture);
  }
}

/// Each tap separately: the fraction of 2^20 samples that pick a texel equals its weight.
void test_weights(void**) {
  constexpr uint32_t kSamples = 1u << 20;
  for (const shd_filter stochastic_filter : kStochasticFilters) {
    uint8_t texels[36];
    for (uint8_t i = 0; i < 36; ++i) texels[i] = i;
    Texture* texture = make_texture(SHD_FORMAT_R8, 6, 6, texels, false);
    static uint32_t hits[36];
    memset(hits, 0, sizeof hits);
    const Sampler sampler = make_sampler(make_desc(stochastic_filter, 0));
    for (uint32_t first = 0; first < kSamples; first += kMaxPoints) {
      make_samples(0.45f, 0.62f, 0, first);
      run(*texture, sampler, hwy::SupportedAndGeneratedTargets()[0], randomized(t_batch, false), &t_batch);
      for (size_t i = 0; i < kMaxPoints; ++i) ++hits[lroundf(t_batch.out[0][i] * 255)];
    }
    const auto weight = [&](double x, int i) {
      const double distance = x * 6 - 0.5 - i;
      return stochastic_filter == SHD_FILTER_BICUBIC ? ref::cubic_weight(SHD_CUBIC_B_SPLINE, distance)
                                                     : fmax(0, 1 - fabs(distance));
    };
    for (int i = 0; i < 36; ++i) {
      const double want = weight(static_cast<double>(0.45f), i % 6) * weight(static_cast<double>(0.62f), i / 6);
      shd_assert_close("share", static_cast<size_t>(i), hits[i] / static_cast<double>(kSamples), want,
                       hoeffding(1, kSamples) + 1e-5, 0);
      if (want == 0) assert_int_equal(hits[i], 0);
    }
    free_texture(texture);
  }
}

struct ellipse_case {
  const char* name;
  Place at;
};
const ellipse_case k_ellipses[] = {
    {"ellipse/round", {0.47f, 0.53f, 1.3f, 1, 0}},           {"ellipse/wide", {0.47f, 0.53f, 2.5f, 3, 0.2f}},
    {"ellipse/high", {0.4f, 0.6f, 2.5f, 3, 1.5f}},           {"ellipse/slanted", {0.5f, 0.5f, 2.7f, 4, 2.2f}},
    {"ellipse/beside_bilinear", {0.47f, 0.53f, 0.4f, 2, 1}},
};

/// Each texel of an ellipse separately: the fraction of 2^20 samples against the oracle on a picture of this single
/// texel.
void test_ellipse(void** state) {
  const auto& c = *static_cast<const ellipse_case*>(*state);
  constexpr uint32_t kSamples = 1u << 20, kEdge = 16, kCount = kEdge * kEdge;
  uint8_t texels[kCount];
  for (uint32_t i = 0; i < kCount; ++i) texels[i] = static_cast<uint8_t>(i);
  Texture* texture = make_texture(SHD_FORMAT_R8, kEdge, kEdge, texels, false);
  const shd_sampler_desc desc = make_desc(SHD_FILTER_EWA, 0);
  const ref::Jacobian j = jacobian(c.at, kEdge, kEdge);
  static uint32_t hits[kCount];
  memset(hits, 0, sizeof hits);
  for (uint32_t first = 0; first < kSamples; first += kMaxPoints) {
    make_samples(c.at, j, first);
    run(*texture, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], randomized(t_batch, true), &t_batch);
    for (size_t i = 0; i < kMaxPoints; ++i) ++hits[lroundf(t_batch.out[0][i] * 255)];
  }
  ref::Level levels[shd::texture::kMaxLevels];
  const ref::Image image = oracle_image(*texture, desc, levels);
  for (uint32_t i = 0; i < kCount; ++i) {
    memset(shd::texture::row_of(*texture, 0, 0, 0), 0, kCount);
    shd::texture::row_of(*texture, 0, 0, 0)[i] = 255;
    const double want = expected(image, c.at, j, 0);
    shd_assert_close(c.name, i, hits[i] / static_cast<double>(kSamples), want, hoeffding(1, kSamples) + 1e-4, 0);
    if (want == 0) assert_int_equal(hits[i], 0);
  }
  free_texture(texture);
}

/// A texel beside the ellipse is never picked, even if the lanes of a vector differ.
void test_outside(void**) {
  float texels[256];
  for (size_t i = 0; i < 256; ++i) texels[i] = i % 16 >= 6 && i % 16 <= 8 ? 1.0f : NAN;
  Texture* texture = make_texture(SHD_FORMAT_R32F, 16, 16, reinterpret_cast<uint8_t*>(texels), false);
  for_each_target([&](int64_t target) {
    make_samples({7.5f / 16, 0.5f, 0, 1, 0}, {1.0 / 16, 0, 0, 8.0 / 16}, 0);  // 2.6 texels wide
    for (size_t i = 0; i < kMaxPoints; ++i) {
      t_batch.dvdy[i] = static_cast<float>(i % 13) / 16;
      if (i % 5 == 0) t_batch.dudx[i] = 0;
    }
    run(*texture, make_sampler(make_desc(SHD_FILTER_EWA, 0)), target, randomized(t_batch, true), &t_batch);
    for (size_t i = 0; i < kMaxPoints; ++i) assert_true(t_batch.out[0][i] == 1.0f);
  });
  free_texture(texture);
}

/// The bits are equal on every target, for every tail, with and without random words; results are finite for any
/// coordinates.
void test_targets_and_tails(void**) {
  make_points(&t_batch);
  memcpy(&t_first, &t_batch, sizeof t_batch);
  for (size_t i = 0; i < kMaxPoints; ++i) t_random[i] = static_cast<uint32_t>(i * 7);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 64, 32, true);
    for (const auto& draw : kDraws) {
      for (const bool given : {false, true}) {
        shd_sampler_desc desc = make_desc(draw.filter, 7);
        desc.stochastic = draw.stochastic;
        const Sampler sampler = make_sampler(desc);
        const auto lookups = [&](const Batch& batch) {
          Lookups in = batch.lookups(true, false);
          if (given) in.random = t_random;
          return in;
        };
        bool first = true;
        for_each_target([&](int64_t target) {
          t_batch.count = kPoints;
          assert_int_equal(run(*texture, sampler, target, lookups(t_batch), &t_batch), kNonfinitePoints);
          if (first) memcpy(t_first.out, t_batch.out, sizeof t_batch.out);
          first = false;
          assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
          for (size_t i = 0; i < kPoints; ++i) assert_true(isfinite(t_batch.out[0][i]));
          for (size_t count = 0; count <= 35; ++count) {
            t_batch.count = count;
            run(*texture, sampler, target, lookups(t_batch), &t_batch);
            for (size_t k = 0; k < 4; ++k) assert_memory_equal(t_batch.out[k], t_first.out[k], count * sizeof(float));
          }
        });
      }
    }
    free_texture(texture);
  }
}

/// Each quad is the bilinear lookup of one of the two levels, as often as the fraction between them requires. The
/// variance is that of two values, and below the variance of texels. At whole levels, and below 0, there is none.
void test_quads(void**) {
  constexpr double kSamples = kRounds * kMaxPoints;
  Texture* texture = random_texture(SHD_FORMAT_R32F, 64, 64, true);
  shd_sampler_desc desc = make_desc(SHD_FILTER_TRILINEAR, 0);
  ref::Level levels[shd::texture::kMaxLevels];
  const ref::Image image = oracle_image(*texture, desc, levels);
  for (const float lod : {-2.0f, 0.3f, 1.75f, 3.0f}) {
    const int fine = static_cast<int>(floorf(fmaxf(lod, 0)));
    const double part = static_cast<double>(fmaxf(lod, 0)) - fine;
    const double u = static_cast<double>(0.37f), v = static_cast<double>(0.61f);
    const double value[2] = {ref::bilinear(image, fine, u, v, 0), ref::bilinear(image, fine + 1, u, v, 0)};
    const double mean = ref::mix(value[0], value[1], part);
    double variance[2] = {0, 0};
    for (const shd_stochastic choice : {SHD_STOCHASTIC_TEXEL, SHD_STOCHASTIC_QUAD}) {
      desc.stochastic = choice;
      size_t coarse = 0;
      for (size_t round = 0; round < kRounds; ++round) {
        make_samples(0.37f, 0.61f, lod, static_cast<uint32_t>(round * kMaxPoints));
        run(*texture, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], randomized(t_batch, false), &t_batch);
        for (size_t i = 0; i < kMaxPoints; ++i) {
          const double got = static_cast<double>(t_batch.out[0][i]);
          variance[choice] += (got - mean) * (got - mean) / kSamples;
          if (choice == SHD_STOCHASTIC_TEXEL) continue;
          const bool second = fabs(got - value[1]) < fabs(got - value[0]);
          coarse += second;
          shd_assert_close("quad", i, got, value[second], 8 * (3e-7 + 8e-7 * 128), 0);
        }
      }
      if (choice == SHD_STOCHASTIC_TEXEL) continue;
      shd_assert_close("share", fine, static_cast<double>(coarse) / kSamples, part, hoeffding(1, kSamples), 0);
    }
    const double step = value[1] - value[0], want = part * (1 - part) * step * step;
    shd_assert_close("variance", fine, variance[1], want, step * step * hoeffding(1, kSamples) + 1e-3, 0);
    assert_true(variance[1] < variance[0]);
  }
  free_texture(texture);
}

/// Another seed picks other texels; without random words, other coordinates do.
void test_seeds(void**) {
  Texture* texture = random_texture(SHD_FORMAT_R16, 64, 64, true);
  for (const shd_filter stochastic_filter : kStochasticFilters) {
    shd_sampler_desc desc = make_desc(stochastic_filter, 0);
    make_samples(0.503f, 0.503f, 0.5f, 0);
    t_first.count = kMaxPoints;
    for_each_target([&](int64_t target) {
      run(*texture, make_sampler(desc), target, randomized(t_batch, false), &t_first);
      desc.seed = 1;
      run(*texture, make_sampler(desc), target, randomized(t_batch, false), &t_batch);
      desc.seed = 0;
      size_t different = 0, changes = 0;
      for (size_t i = 0; i < kMaxPoints; ++i) different += t_batch.out[0][i] != t_first.out[0][i];
      assert_in_range(different, kMaxPoints / 4, kMaxPoints);
      Batch& moved = t_batch;
      for (size_t i = 0; i < kMaxPoints; ++i) moved.u[i] = 0.503f + 0x1p-24f * static_cast<float>(i);
      run(*texture, make_sampler(desc), target, moved.lookups(false, true), &moved);
      for (size_t i = 1; i < kMaxPoints; ++i) changes += moved.out[0][i] != moved.out[0][i - 1];
      assert_in_range(changes, kMaxPoints / 4, kMaxPoints);
      for (size_t i = 0; i < kMaxPoints; ++i) moved.u[i] = 0.503f;
    });
  }
  free_texture(texture);
}

/// A texel of weight 0 is never picked: at texel centres an adjacent NaN has no effect.
void test_weight_zero(void**) {
  float texels[64];
  for (size_t i = 0; i < 64; ++i) texels[i] = i == 20 ? 5.0f : NAN;
  Texture* texture = make_texture(SHD_FORMAT_R32F, 64, 1, reinterpret_cast<uint8_t*>(texels), false);
  for (const shd_filter stochastic_filter : {SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_FILTER_EWA}) {
    for_each_target([&](int64_t target) {
      make_samples(20.5f / 64, 0.5f, 0, 0);
      run(*texture, make_sampler(make_desc(stochastic_filter, 0)), target, randomized(t_batch, false), &t_batch);
      for (size_t i = 0; i < kMaxPoints; ++i) assert_true(t_batch.out[0][i] == 5.0f);
    });
  }
  free_texture(texture);
}

/// A constant texture gives its value, on every target.
void test_constant(void**) {
  uint8_t texels[33 * 9];
  memset(texels, 77, sizeof texels);
  Texture* texture = make_texture(SHD_FORMAT_R8, 33, 9, texels, true);
  make_points(&t_batch);
  for (const shd_filter stochastic_filter : kStochasticFilters) {
    for (uint32_t pair = 0; pair < 25; ++pair) {
      shd_sampler_desc desc = make_desc(stochastic_filter, pair);
      if (desc.wrap_u == SHD_WRAP_BORDER || desc.wrap_v == SHD_WRAP_BORDER) continue;
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
        for (size_t i = 0; i < t_batch.count; ++i) assert_true(t_batch.out[0][i] == t_batch.out[0][0]);
        shd_assert_close("constant", pair, static_cast<double>(t_batch.out[0][0]), 77 / 255.0, 0, 1.2e-7);
      });
    }
  }
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[48];
  size_t n = 0;
  for (const stochastic_case& c : k_cases) {
    tests[n++] = {c.name, test_mean, nullptr, nullptr, const_cast<stochastic_case*>(&c)};
  }
  tests[n++] = {"weights", test_weights, nullptr, nullptr, nullptr};
  for (const ellipse_case& c : k_ellipses) {
    tests[n++] = {c.name, test_ellipse, nullptr, nullptr, const_cast<ellipse_case*>(&c)};
  }
  tests[n++] = {"quads", test_quads, nullptr, nullptr, nullptr};
  tests[n++] = {"outside", test_outside, nullptr, nullptr, nullptr};
  tests[n++] = {"targets_and_tails", test_targets_and_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"seeds", test_seeds, nullptr, nullptr, nullptr};
  tests[n++] = {"weight_zero", test_weight_zero, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.stochastic", tests, n, nullptr, nullptr);
}
