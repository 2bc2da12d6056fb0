// SPDX-License-Identifier: MIT
// Non-finite inputs and texels, and footprints of any size: every lookup has a defined, finite result.
#include "fixture.h"

namespace {

using namespace fixture;

Batch t_batch, t_other;

const shd_filter k_filters[] = {SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR};
const float k_bad[] = {NAN, -NAN, INFINITY, -INFINITY};

/// A NaN or infinite coordinate, in each lane, with each wrap and filter, counts as the coordinate 0.
void test_coordinates(void**) {
  Texture* texture = random_texture(SHD_FORMAT_RGBA8, 13, 9, true);
  for (const shd_filter filter : k_filters) {
    for (uint32_t wrap = 0; wrap < 4; ++wrap) {
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = filter;
      desc.wrap_u = desc.wrap_v = static_cast<shd_wrap>(wrap);
      for_each_target([&](int64_t target) {
        for (size_t lane = 0; lane < 35; ++lane) {
          for (const float bad : k_bad) {
            t_batch.count = t_other.count = 35;
            for (size_t i = 0; i < 35; ++i) {
              t_batch.u[i] = t_other.u[i] = 0.03f * static_cast<float>(i);
              t_batch.v[i] = t_other.v[i] = 0.7f;
            }
            float* bad_column = lane % 2 ? t_batch.u : t_batch.v;
            float* zero_column = lane % 2 ? t_other.u : t_other.v;
            bad_column[lane] = bad;
            zero_column[lane] = 0;
            const Sampler sampler = make_sampler(desc);
            assert_int_equal(run(*texture, sampler, target, t_batch.lookups(false, false), &t_batch), 1);
            assert_int_equal(run(*texture, sampler, target, t_other.lookups(false, false), &t_other), 0);
            assert_memory_equal(t_batch.out, t_other.out, sizeof t_batch.out);
          }
        }
      });
    }
  }
  free_texture(texture);
}

/// A texture whose level l has the value l everywhere, so that trilinear returns the level of detail.
Texture* make_ruler(uint32_t width, uint32_t height) {
  auto* texels = static_cast<uint8_t*>(calloc(size_t{width} * height, 16));
  Texture* texture = make_texture(SHD_FORMAT_RGBA32F, width, height, texels, true);
  free(texels);
  for (uint32_t l = 0; l < texture->level_count; ++l) {
    const size_t floats = size_t{4} * shd::texture::level_size(width, l) * shd::texture::level_size(height, l);
    auto* values = reinterpret_cast<float*>(shd::texture::row_of(*texture, 0, l, 0));
    for (size_t i = 0; i < floats; ++i) values[i] = static_cast<float>(l);
  }
  return texture;
}

struct lod_case {
  const char* name;
  float j[4];  // dudx, dvdx, dudy, dvdy in base texels of 1024 x 1024
  double lod;
};
const float k_inf = INFINITY;
const lod_case k_lods[] = {
    {"lod/zero", {0, 0, 0, 0}, 0},
    {"lod/denormal", {1e-42f, -1e-42f, 1e-42f, 0}, 0},
    {"lod/unit", {1, 0, 0, 1}, 0},
    {"lod/magnified", {0.25f, 0, 0, 0.125f}, 0},
    {"lod/isotropic_4", {4, 0, 0, 4}, 2},
    {"lod/rotated_4", {2.828427125f, 2.828427125f, -2.828427125f, 2.828427125f}, 2},
    {"lod/mirrored", {0, 8, 8, 0}, 3},
    {"lod/equal_columns", {8, 0, 8, 0}, 3.5},
    {"lod/skewed", {8, 0, 8, 1}, 3.5028232},  // sigma 11.3359; the longer column alone would give 3.01
    {"lod/one_axis_x", {16, 0, 0, 0}, 4},
    {"lod/one_axis_y", {0, 0, 0, 32}, 5},
    {"lod/long_and_thin", {512, 0, 0, 1e-20f}, 9},
    {"lod/whole_texture", {1024, 0, 0, 1024}, 10},
    {"lod/larger_than_texture", {1e6f, 0, 0, 1e6f}, 10},
    {"lod/huge", {1e30f, 1e30f, -1e30f, 1e30f}, 10},
    {"lod/huge_one_entry", {0, 0, 1e38f, 0}, 10},
    {"lod/flt_max", {3.4e38f, 3.4e38f, 3.4e38f, -3.4e38f}, 10},
    {"lod/infinite", {k_inf, 0, 0, 0}, 10},
    {"lod/minus_infinite", {0, -k_inf, 0, 0}, 10},
    {"lod/two_infinite", {k_inf, -k_inf, k_inf, k_inf}, 10},
    {"lod/infinite_and_nan", {k_inf, NAN, 0, 0}, 10},
    {"lod/nan_x", {NAN, 0, 0, 4}, 2},
    {"lod/all_nan", {NAN, NAN, NAN, NAN}, 0},
    {"lod/nan_and_number", {2, NAN, NAN, 0}, 1},
};

/// Trilinear on the level of the longer axis.
shd_sampler_desc longer_axis_desc() {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.profile = SHD_PROFILE_EXACT;
  return desc;
}

void test_lod(void** state) {
  const auto* c = static_cast<const lod_case*>(*state);
  Texture* texture = make_ruler(1024, 1024);
  t_batch.count = 19;
  bool finite = true;
  for (const float entry : c->j) finite = finite && isfinite(entry);
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.3f;
    t_batch.dudx[i] = c->j[0] / 1024;
    t_batch.dvdx[i] = c->j[1] / 1024;
    t_batch.dudy[i] = c->j[2] / 1024;
    t_batch.dvdy[i] = c->j[3] / 1024;
  }
  const Sampler sampler = make_sampler(longer_axis_desc());
  for_each_target([&](int64_t target) {
    const size_t nonfinite = run(*texture, sampler, target, t_batch.lookups(true, false), &t_batch);
    assert_int_equal(nonfinite, finite ? 0 : t_batch.count);
    for (size_t i = 0; i < t_batch.count; ++i) {
      shd_assert_close(c->name, i, static_cast<double>(t_batch.out[0][i]), c->lod, 2e-6, 0);
    }
  });
  free_texture(texture);
}

/// The stated error of the level of detail, over random footprints of every size and aspect.
void test_lod_error(void**) {
  Texture* texture = make_ruler(65536, 16);
  const Sampler sampler = make_sampler(longer_axis_desc());
  Random random{99};
  double worst = 0;
  for (int round = 0; round < 200; ++round) {
    t_batch.count = kMaxPoints;
    for (size_t i = 0; i < kMaxPoints; ++i) {
      t_batch.u[i] = t_batch.v[i] = 0.5f;
      const float x = ldexpf(1, static_cast<int>(random.next() >> 27) - 24);
      const float y = ldexpf(1, static_cast<int>(random.next() >> 27) - 24);
      t_batch.dudx[i] = x * random.real(-1, 1);
      t_batch.dvdx[i] = x * random.real(-1, 1);
      t_batch.dudy[i] = y * random.real(-1, 1);
      t_batch.dvdy[i] = y * random.real(-1, 1);
    }
    for_each_target([&](int64_t target) {
      run(*texture, sampler, target, t_batch.lookups(true, false), &t_batch);
      for (size_t i = 0; i < kMaxPoints; ++i) {
        const double want =
            ref::lambda(static_cast<double>(t_batch.dudx[i]), static_cast<double>(t_batch.dvdx[i]),
                        static_cast<double>(t_batch.dudy[i]), static_cast<double>(t_batch.dvdy[i]), 65536, 16);
        const double clamped = fmin(fmax(want, 0), 16);
        worst = fmax(worst, fabs(static_cast<double>(t_batch.out[0][i]) - clamped));
      }
    });
  }
  print_message("worst error of the level of detail: %.3g\n", worst);
  assert_true(worst <= 2e-6);
  free_texture(texture);
}

struct column_case {
  const char* name;
  float lod, bias, low, high;
  double want;
};
const column_case k_columns[] = {
    {"column/zero", 0, 0, 0, 32, 0},
    {"column/fraction", 2.25f, 0, 0, 32, 2.25},
    {"column/negative", -7, 0, 0, 32, 0},
    {"column/beyond", 40, 0, 0, 32, 10},
    {"column/nan", NAN, 0, 0, 32, 0},
    {"column/nan_biased", NAN, 3, 0, 32, 3},
    {"column/infinity", INFINITY, 0, 0, 32, 10},
    {"column/minus_infinity", -INFINITY, 15, 0, 32, 0},
    {"column/flt_max", 3.4e38f, -15, 0, 32, 10},
    {"column/bias", 2, 1.5f, 0, 32, 3.5},
    {"column/bias_down", 2, -15, 0, 32, 0},
    {"column/lod_min", 1, 0, 4.5f, 32, 4.5},
    {"column/lod_max", 8, 0, 0, 3.25f, 3.25},
    {"column/lod_min_wins", 8, 0, 6, 2, 6},
    {"column/lod_min_beyond_levels", 0, 0, 31, 32, 10},
};

void test_column(void** state) {
  const auto* c = static_cast<const column_case*>(*state);
  Texture* texture = make_ruler(1024, 64);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.lod_bias = c->bias;
  desc.lod_min = c->low;
  desc.lod_max = c->high;
  t_batch.count = 21;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.3f;
    t_batch.lod[i] = c->lod;
    t_batch.dudx[i] = NAN;  // replaced by the lod column, so that it is neither read nor counted
    t_batch.dvdx[i] = t_batch.dudy[i] = t_batch.dvdy[i] = 1;
  }
  for_each_target([&](int64_t target) {
    const size_t nonfinite = run(*texture, make_sampler(desc), target, t_batch.lookups(true, true), &t_batch);
    assert_int_equal(nonfinite, isfinite(c->lod) ? 0 : t_batch.count);
    for (size_t i = 0; i < t_batch.count; ++i) {
      shd_assert_close(c->name, i, static_cast<double>(t_batch.out[0][i]), c->want, 1e-6, 0);
    }
  });
  free_texture(texture);
}

/// One non-finite texel in a 4 x 4 image of ones: it has no effect with weight 0, and an effect with any other weight.
void test_texels(void**) {
  for (const shd_format format : {SHD_FORMAT_RGBA32F, SHD_FORMAT_RGBA16F}) {
    for (const float bad : {INFINITY, -INFINITY, NAN}) {
      uint8_t texels[16 * 16];
      for (size_t i = 0; i < 16 * 4; ++i) {
        const float value = i / 4 == 5 ? bad : 1.0f;  // texel (1, 1)
        const uint16_t half = i / 4 != 5 ? 0x3c00 : isnan(bad) ? 0x7e00 : bad > 0 ? 0x7c00 : 0xfc00;
        if (format == SHD_FORMAT_RGBA32F) {
          memcpy(texels + 4 * i, &value, 4);
        } else {
          memcpy(texels + 2 * i, &half, 2);
        }
      }
      Texture* texture = make_texture(format, 4, 4, texels, false);
      t_batch.count = 289;
      for (size_t i = 0; i < t_batch.count; ++i) {
        t_batch.u[i] = static_cast<float>(i % 17) / 16;
        t_batch.v[i] = static_cast<float>(i / 17) / 16;
      }
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = SHD_FILTER_BILINEAR;
      for (uint32_t wrap = 0; wrap < 4; ++wrap) {
        desc.wrap_u = desc.wrap_v = static_cast<shd_wrap>(wrap);
        desc.border[0] = 1;
        for_each_target([&](int64_t target) {
          run(*texture, make_sampler(desc), target, t_batch.lookups(false, false), &t_batch);
          for (size_t i = 0; i < t_batch.count; ++i) {
            const double x = static_cast<double>(t_batch.u[i]) * 4, y = static_cast<double>(t_batch.v[i]) * 4;
            const bool reached = fabs(x - 1.5) < 1 && fabs(y - 1.5) < 1;
            const double want = reached ? static_cast<double>(bad) : 1;
            shd_assert_close("texel", i, static_cast<double>(t_batch.out[0][i]), want, 0, 0);
          }
        });
      }
      free_texture(texture);
    }
  }
}

/// A non-finite level counts only if its weight is not 0; NaN results have a single bit pattern.
void test_levels(void**) {
  Texture* texture = make_ruler(8, 8);
  auto* values = reinterpret_cast<float*>(shd::texture::row_of(*texture, 0, 2, 0));
  for (size_t i = 0; i < 16; ++i) values[i] = i % 4 == 0 ? INFINITY : NAN;
  const float lods[] = {0, 0.5f, 1, 1.0000001f, 1.5f, 2, 2.5f, 3};
  t_batch.count = 64;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.6f;
    t_batch.lod[i] = lods[i % 8];
  }
  const Sampler sampler = make_sampler(shd_sampler_desc_default());
  for_each_target([&](int64_t target) {
    run(*texture, sampler, target, t_batch.lookups(false, true), &t_batch);
    for (size_t i = 0; i < t_batch.count; ++i) {
      const bool reached = lods[i % 8] > 1 && lods[i % 8] < 3;
      assert_true(reached ? isinf(t_batch.out[0][i]) : t_batch.out[0][i] == lods[i % 8]);
      const uint32_t nan_bits = 0x7fc00000u;
      if (reached) assert_memory_equal(&t_batch.out[1][i], &nan_bits, sizeof nan_bits);
    }
  });
  free_texture(texture);
}

/// Texels whose difference overflows still blend to finite values.
void test_largest_texels(void**) {
  float texels[4 * 4 * 4];
  for (size_t i = 0; i < 64; ++i) texels[i] = (i / 4 + i / 16) % 2 ? 3.40282347e38f : -3.40282347e38f;
  Texture* texture = make_texture(SHD_FORMAT_RGBA32F, 4, 4, reinterpret_cast<uint8_t*>(texels), true);
  Random random{3};
  t_batch.count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    t_batch.u[i] = random.real(-1, 2);
    t_batch.v[i] = random.real(-1, 2);
    t_batch.lod[i] = random.real(0, 2);
  }
  for (uint32_t wrap = 0; wrap < 4; ++wrap) {
    for (const shd_filter filter : k_filters) {
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = filter;
      desc.wrap_u = desc.wrap_v = static_cast<shd_wrap>(wrap);
      for (float& value : desc.border) value = -3.40282347e38f;
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(desc), target, t_batch.lookups(false, true), &t_batch);
        for (size_t i = 0; i < kMaxPoints; ++i) assert_true(isfinite(t_batch.out[0][i]));
      });
    }
  }
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[64];
  size_t n = 0;
  tests[n++] = {"coordinates", test_coordinates, nullptr, nullptr, nullptr};
  for (const lod_case& c : k_lods) tests[n++] = {c.name, test_lod, nullptr, nullptr, const_cast<lod_case*>(&c)};
  tests[n++] = {"lod/error_bound", test_lod_error, nullptr, nullptr, nullptr};
  for (const column_case& c : k_columns) {
    tests[n++] = {c.name, test_column, nullptr, nullptr, const_cast<column_case*>(&c)};
  }
  tests[n++] = {"texels", test_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"levels", test_levels, nullptr, nullptr, nullptr};
  tests[n++] = {"largest_texels", test_largest_texels, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.nonfinite", tests, n, nullptr, nullptr);
}
