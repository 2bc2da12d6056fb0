// SPDX-License-Identifier: MIT
// The filters of the nearest mip level, nearest texels of two levels, and magnification: every format x wrap pair x
// size x target against the oracle.
#include "filter_cases.h"

namespace {

using namespace fixture;

struct mip_case {
  const char* name;
  shd_filter filter;
  uint32_t width, height;
};
const mip_case k_cases[] = {
    {"nearest_mip/1x1", SHD_FILTER_NEAREST_MIP, 1, 1},
    {"nearest_mip/1x7", SHD_FILTER_NEAREST_MIP, 1, 7},
    {"nearest_mip/5x3", SHD_FILTER_NEAREST_MIP, 5, 3},
    {"nearest_mip/128x32", SHD_FILTER_NEAREST_MIP, 128, 32},
    {"nearest_mip/1023x511", SHD_FILTER_NEAREST_MIP, 1023, 511},
    {"nearest_mip/4096x1", SHD_FILTER_NEAREST_MIP, 4096, 1},
    {"nearest_mip_linear/1x1", SHD_FILTER_NEAREST_MIP_LINEAR, 1, 1},
    {"nearest_mip_linear/1x7", SHD_FILTER_NEAREST_MIP_LINEAR, 1, 7},
    {"nearest_mip_linear/5x3", SHD_FILTER_NEAREST_MIP_LINEAR, 5, 3},
    {"nearest_mip_linear/128x32", SHD_FILTER_NEAREST_MIP_LINEAR, 128, 32},
    {"nearest_mip_linear/1023x511", SHD_FILTER_NEAREST_MIP_LINEAR, 1023, 511},
    {"nearest_mip_linear/4096x1", SHD_FILTER_NEAREST_MIP_LINEAR, 4096, 1},
    {"bilinear_mip/1x1", SHD_FILTER_BILINEAR_MIP, 1, 1},
    {"bilinear_mip/1x7", SHD_FILTER_BILINEAR_MIP, 1, 7},
    {"bilinear_mip/5x3", SHD_FILTER_BILINEAR_MIP, 5, 3},
    {"bilinear_mip/128x32", SHD_FILTER_BILINEAR_MIP, 128, 32},
    {"bilinear_mip/1023x511", SHD_FILTER_BILINEAR_MIP, 1023, 511},
    {"bilinear_mip/4096x1", SHD_FILTER_BILINEAR_MIP, 4096, 1},
};

Batch t_batch, t_near, t_far;

double lambda_of(const mip_case& c, const Batch& batch, size_t i) {
  return ref::lambda(static_cast<double>(batch.dudx[i]), static_cast<double>(batch.dvdx[i]),
                     static_cast<double>(batch.dudy[i]), static_cast<double>(batch.dvdy[i]), c.width, c.height);
}

/// Whether a value is possible for the filter on a level.
bool matches(const mip_case& c, const ref::Image& image, int level, double u, double v, int channel, double got) {
  const double w = static_cast<double>(image.levels[level].width), h = static_cast<double>(image.levels[level].height);
  if (c.filter == SHD_FILTER_BILINEAR_MIP) {
    const double m = fmax(magnitude(image.format), 2);
    return shd_is_close(got, ref::bilinear(image, level, u, v, channel), m * (3e-7 + 8e-7 * (w + h)), 0);
  }
  for (const double dx : {0.0, -4e-7 * w, 4e-7 * w}) {
    for (const double dy : {0.0, -4e-7 * h, 4e-7 * h}) {
      if (shd_is_close(got, ref::nearest_on(image, level, u, v, dx, dy, channel), 1.2e-7, 1.2e-7)) return true;
    }
  }
  return false;
}

void check_point(const mip_case& c, const ref::Image& image, const Batch& batch, size_t i) {
  const double u = static_cast<double>(batch.u[i]), v = static_cast<double>(batch.v[i]);
  for (int channel = 0; channel < 4; ++channel) {
    const double got = static_cast<double>(batch.out[channel][i]);
    bool found = false;
    for (const double slack : {0.0, -2e-6, 2e-6}) {
      const double lod = ref::clamp_lod(image, lambda_of(c, batch, i) + slack);
      if (c.filter == SHD_FILTER_NEAREST_MIP_LINEAR) {
        const double bound = 4e-6 * fmax(magnitude(image.format), 2);
        found = found || ref::is_nearest_blend(image, lod, u, v, channel, got, bound);
        continue;
      }
      const int level = static_cast<int>(fmax(ceil(lod + 0.5) - 1, 0));
      found = found || matches(c, image, level, u, v, channel, got);
    }
    if (!found) fail_msg("%s: point %zu channel %d: got %.9g", c.name, i, channel, got);
  }
}

void test_against_oracle(void** state) {
  const auto& c = *static_cast<const mip_case*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      check_against_oracle(*texture, wrap_desc(c.filter, pair), t_batch.lookups(true, false), &t_batch,
                           [&](const ref::Image& image, size_t i) { check_point(c, image, t_batch, i); });
    }
    free_texture(texture);
  }
}

/// Half way between two levels the finer one is used; the level equals the level of shd_texture_query_levels.
void test_halfway(void**) {
  uint8_t texels[16 * 16];
  for (size_t i = 0; i < sizeof texels; ++i) texels[i] = 0;
  Texture* texture = make_texture(SHD_FORMAT_R8, 16, 16, texels, true);
  for (uint32_t l = 0; l < texture->level_count; ++l) *shd::texture::row_of(*texture, 0, l, 0) = 51;
  t_batch.count = 5;
  const float lods[] = {0.5f, 0.50001f, 1.5f, 3.5f, 3.50001f};
  const float want[] = {0, 1, 1, 3, 4};
  for (size_t i = 0; i < 5; ++i) {
    const float size = static_cast<float>(16 >> static_cast<int>(want[i]));
    t_batch.u[i] = t_batch.v[i] = 0.9f / size;  // inside the first texel of this level and of coarser ones only
    t_batch.lod[i] = lods[i];
  }
  for_each_target([&](int64_t target) {
    const Sampler sampler = make_sampler(wrap_desc(SHD_FILTER_NEAREST_MIP, 6));
    run(*texture, sampler, target, t_batch.lookups(false, true), &t_batch);
    for (size_t i = 0; i < 5; ++i) assert_true(t_batch.out[0][i] == 0.2f);
  });
  free_texture(texture);
}

/// A whole level of detail has the bits of the texel of its level, and tails the bits of the whole batch; a texel of
/// share 0 has no effect even if it is NaN.
void test_blend(void**) {
  make_points(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) t_batch.lod[i] = static_cast<float>(i % 7);
  memcpy(&t_near, &t_batch, sizeof t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 37, 24, true);
    check_same_bits(*texture, wrap_desc(SHD_FILTER_NEAREST_MIP_LINEAR, 8), wrap_desc(SHD_FILTER_NEAREST_MIP, 8), true,
                    &t_batch, &t_near);
    free_texture(texture);
  }
  check_tails_of_formats(wrap_desc(SHD_FILTER_NEAREST_MIP_LINEAR, 3), true);
  const float texels[] = {1, 1, 1, NAN};
  Texture* texture = make_texture(SHD_FORMAT_R32F, 2, 2, reinterpret_cast<const uint8_t*>(texels), true);
  t_batch.count = 3;
  for (size_t i = 0; i < 3; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.25f;
    t_batch.lod[i] = 0.5f * static_cast<float>(i);
  }
  for_each_target([&](int64_t target) {
    const Sampler sampler = make_sampler(wrap_desc(SHD_FILTER_NEAREST_MIP_LINEAR, 6));
    run(*texture, sampler, target, t_batch.lookups(false, true), &t_batch);
    assert_true(t_batch.out[0][0] == 1 && isnan(t_batch.out[0][1]) && isnan(t_batch.out[0][2]));
  });
  free_texture(texture);
}

struct magnification_case {
  const char* name;
  shd_filter filter;
  shd_magnification magnification;
  shd_filter near;
  float lod_min;
};
const magnification_case k_magnifications[] = {
    {"magnification/trilinear_nearest", SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_NEAREST, SHD_FILTER_NEAREST, 0},
    {"magnification/trilinear_bilinear", SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_BILINEAR, SHD_FILTER_BILINEAR, 0},
    {"magnification/trilinear_bicubic", SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_BICUBIC, SHD_FILTER_BICUBIC, 0},
    {"magnification/nearest_bilinear", SHD_FILTER_NEAREST, SHD_MAGNIFICATION_BILINEAR, SHD_FILTER_BILINEAR, 0},
    {"magnification/nearest_mip_bicubic", SHD_FILTER_NEAREST_MIP, SHD_MAGNIFICATION_BICUBIC, SHD_FILTER_BICUBIC, 0},
    {"magnification/nearest_mip_linear", SHD_FILTER_NEAREST_MIP_LINEAR, SHD_MAGNIFICATION_BILINEAR, SHD_FILTER_BILINEAR,
     0},
    {"magnification/trilinear_hermite", SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_HERMITE, SHD_FILTER_HERMITE, 0},
    {"magnification/nearest_hermite", SHD_FILTER_NEAREST, SHD_MAGNIFICATION_HERMITE, SHD_FILTER_HERMITE, 0},
    {"magnification/hermite_bilinear", SHD_FILTER_HERMITE, SHD_MAGNIFICATION_BILINEAR, SHD_FILTER_BILINEAR, 0},
    {"magnification/never_above_lod_min", SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_NEAREST, SHD_FILTER_NEAREST, 0.5f},
};

/// Every lookup has the bits of the filter selected by its level of detail, in blocks of both kinds and of one kind.
void test_magnification(void** state) {
  const auto& c = *static_cast<const magnification_case*>(*state);
  const mip_case size = {c.name, c.filter, 64, 32};
  Texture* texture = random_texture(SHD_FORMAT_RGBA8, 64, 32, true);
  make_points(&t_batch);
  for (size_t i = kPoints; i < kMaxPoints; ++i) {
    t_batch.u[i] = t_batch.u[i % kPoints];
    t_batch.v[i] = t_batch.v[i % kPoints];
    const float scale = i < 2 * kPoints ? 1.0f : 0x1p-12f;  // magnified only
    t_batch.dudx[i] = scale * t_batch.dudx[i % kPoints];
    t_batch.dvdx[i] = scale * t_batch.dvdx[i % kPoints];
    t_batch.dudy[i] = scale * t_batch.dudy[i % kPoints];
    t_batch.dvdy[i] = scale * t_batch.dvdy[i % kPoints];
  }
  t_batch.count = kMaxPoints;
  memcpy(&t_near, &t_batch, sizeof t_batch);
  memcpy(&t_far, &t_batch, sizeof t_batch);
  shd_sampler_desc desc = wrap_desc(c.filter, 2);
  desc.lod_min = c.lod_min;
  shd_sampler_desc near = desc;
  near.filter = c.near;
  shd_sampler_desc both = desc;
  both.magnification = c.magnification;
  for_each_target([&](int64_t target) {
    run(*texture, make_sampler(desc), target, t_far.lookups(true, false), &t_far);
    run(*texture, make_sampler(near), target, t_near.lookups(true, false), &t_near);
    const size_t nonfinite = run(*texture, make_sampler(both), target, t_batch.lookups(true, false), &t_batch);
    assert_true(nonfinite >= 2 * kNonfinitePoints);
    size_t magnified = 0;
    for (size_t i = 0; i < kMaxPoints; ++i) {
      const double lambda = lambda_of(size, t_batch, i);
      if (fabs(lambda) < 4e-6) continue;
      const bool is_near = fmax(lambda, static_cast<double>(c.lod_min)) <= 0;
      magnified += is_near;
      for (size_t k = 0; k < 4; ++k) {
        assert_memory_equal(&t_batch.out[k][i], is_near ? &t_near.out[k][i] : &t_far.out[k][i], sizeof(float));
      }
    }
    if (c.lod_min > 0) {
      assert_int_equal(magnified, 0);
    } else {
      assert_in_range(magnified, 32, kMaxPoints - 32);
    }
  });
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = 0;
  for (const mip_case& c : k_cases) {
    tests[n++] = {c.name, test_against_oracle, nullptr, nullptr, const_cast<mip_case*>(&c)};
  }
  for (const magnification_case& c : k_magnifications) {
    tests[n++] = {c.name, test_magnification, nullptr, nullptr, const_cast<magnification_case*>(&c)};
  }
  tests[n++] = {"blend", test_blend, nullptr, nullptr, nullptr};
  tests[n++] = {"halfway", test_halfway, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.mip_nearest", tests, n, nullptr, nullptr);
}
