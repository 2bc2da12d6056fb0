// SPDX-License-Identifier: MIT
// Finite texels give finite values and derivatives, up to the largest float. Blends that leave the range of float
// become the largest float of their sign. All targets give the same bits.
#include "filter_cases.h"

namespace {

using namespace fixture;

constexpr float kMax = 3.40282347e38f;
constexpr uint32_t kSide = 8;

Batch t_batch;
float t_du[4][kMaxPoints], t_dv[4][kMaxPoints];
uint8_t t_wide[65536 * 4];

struct filter_case {
  const char* name;
  shd_filter filter;
  shd_cubic cubic;
  bool has_derivatives;
};
const filter_case k_filters[] = {
    {"nearest", SHD_FILTER_NEAREST, SHD_CUBIC_CATMULL_ROM, false},
    {"bilinear", SHD_FILTER_BILINEAR, SHD_CUBIC_CATMULL_ROM, true},
    {"catmull_rom", SHD_FILTER_BICUBIC, SHD_CUBIC_CATMULL_ROM, true},
    {"mitchell", SHD_FILTER_BICUBIC, SHD_CUBIC_MITCHELL, true},
    {"b_spline", SHD_FILTER_BICUBIC, SHD_CUBIC_B_SPLINE, true},
    {"hermite", SHD_FILTER_HERMITE, SHD_CUBIC_CATMULL_ROM, true},
    {"bilinear_mip", SHD_FILTER_BILINEAR_MIP, SHD_CUBIC_CATMULL_ROM, true},
    {"trilinear", SHD_FILTER_TRILINEAR, SHD_CUBIC_CATMULL_ROM, true},
    {"ripmap", SHD_FILTER_RIPMAP, SHD_CUBIC_CATMULL_ROM, true},
    {"summed_area", SHD_FILTER_SUMMED_AREA, SHD_CUBIC_CATMULL_ROM, false},
    {"anisotropic", SHD_FILTER_ANISOTROPIC, SHD_CUBIC_CATMULL_ROM, true},
    {"ewa", SHD_FILTER_EWA, SHD_CUBIC_CATMULL_ROM, true},
    {"stochastic", SHD_FILTER_STOCHASTIC, SHD_CUBIC_CATMULL_ROM, false},
    {"exact", SHD_FILTER_EXACT, SHD_CUBIC_CATMULL_ROM, false},
};

Texture* make_tables(shd_format format, uint32_t width, uint32_t height, const void* texels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.texels = texels;
  desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}

/// Pattern 0: checks of both signs; 1: random signs and magnitudes near the largest; 2: magnitudes of +-1e38 and 0.
float pattern_texel(uint32_t pattern, size_t i, Random* random) {
  if (pattern == 0) return (i / 4 + i / 4 / kSide) % 2 ? kMax : -kMax;
  const float sign = random->next() >> 31 ? 1.0f : -1.0f;
  if (pattern == 1) return sign * kMax * random->real(0.79f, 1.0f);
  return random->next() >> 30 ? sign * 1e38f : 0.0f;
}

void make_case_points() {
  Random random{11};
  t_batch.count = kMaxPoints - 1;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = random.real(-1, 2);
    t_batch.v[i] = random.real(-1, 2);
    t_batch.dudx[i] = random.real(-0.7f, 0.7f);
    t_batch.dvdx[i] = random.real(-0.3f, 0.3f);
    t_batch.dudy[i] = random.real(-0.1f, 0.1f);
    t_batch.dvdy[i] = i % 2 ? random.real(-0.7f, 0.7f) : 0.01f;
  }
}

void check_case(const filter_case& c, const Texture& texture, const Sampler& sampler, const char* what) {
  uint64_t first_hash = 0;
  for_each_target([&](int64_t target) {
    run(texture, sampler, target, t_batch.lookups(true, false), &t_batch);
    uint64_t hash = shd_hash(SHD_HASH_START, t_batch.out, sizeof t_batch.out);
    for (size_t k = 0; k < 4; ++k) {
      for (size_t i = 0; i < t_batch.count; ++i) {
        if (!isfinite(t_batch.out[k][i])) fail_msg("%s %s: value %zu is %g", c.name, what, i, t_batch.out[k][i] + 0.0);
      }
    }
    if (c.has_derivatives) {
      const Texels out = {{}, {t_du[0], t_du[1], t_du[2], t_du[3]}, {t_dv[0], t_dv[1], t_dv[2], t_dv[3]}};
      shd::texture::sample(texture, sampler, shd::core::simd_target_from_bit(target), t_batch.lookups(true, false),
                           out);
      for (size_t k = 0; k < 4; ++k) {
        for (size_t i = 0; i < t_batch.count; ++i) {
          if (!isfinite(t_du[k][i])) fail_msg("%s %s: du %zu is %g", c.name, what, i, t_du[k][i] + 0.0);
          if (!isfinite(t_dv[k][i])) fail_msg("%s %s: dv %zu is %g", c.name, what, i, t_dv[k][i] + 0.0);
        }
        hash = shd_hash(hash, t_du[k], t_batch.count * sizeof(float));
        hash = shd_hash(hash, t_dv[k], t_batch.count * sizeof(float));
      }
    }
    if (first_hash == 0) first_hash = hash;
    assert_true(hash == first_hash);
  });
}

void test_filter(void** state) {
  const auto& c = *static_cast<const filter_case*>(*state);
  make_case_points();
  for (uint32_t pattern = 0; pattern < 3; ++pattern) {
    static float texels[kSide * kSide * 4];
    Random random{pattern + 5};
    for (size_t i = 0; i < kSide * kSide * 4; ++i) texels[i] = pattern_texel(pattern, i, &random);
    Texture* texture = make_tables(SHD_FORMAT_RGBA32F, kSide, kSide, texels);
    for (uint32_t wrap = 0; wrap < 5; ++wrap) {
      char what[64];
      snprintf(what, sizeof what, "pattern %u wrap %u", pattern, wrap);
      shd_sampler_desc desc = wrap_desc(c.filter, wrap);
      desc.cubic = c.cubic;
      for (size_t k = 0; k < 4; ++k) desc.border[k] = k % 2 ? kMax : -kMax;
      check_case(c, *texture, make_sampler(desc), what);
    }
    free_texture(texture);
  }
}

/// A border of the largest float around 8-bit texels.
void test_border(void** state) {
  const auto& c = *static_cast<const filter_case*>(*state);
  uint8_t texels[kSide * kSide * 4];
  random_texels(SHD_FORMAT_RGBA8, kSide * kSide, 3, texels);
  Texture* texture = make_tables(SHD_FORMAT_RGBA8, kSide, kSide, texels);
  make_case_points();
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = c.filter;
  desc.cubic = c.cubic;
  desc.wrap_u = desc.wrap_v = SHD_WRAP_BORDER;
  for (size_t k = 0; k < 4; ++k) desc.border[k] = k % 2 ? kMax : -kMax;
  check_case(c, *texture, make_sampler(desc), "largest border");
  free_texture(texture);
  if (!c.has_derivatives) return;
  texture = make_texture(SHD_FORMAT_RGBA8, 65536, 1, t_wide, false);  // the steepest: a texel is 1 / 65536
  desc.wrap_v = SHD_WRAP_CLAMP;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = (i % 2 ? 65536.0f : 0.0f) / 65536 + static_cast<float>(i % 31) * 0x1p-20f - 15 * 0x1p-20f;
    t_batch.dudx[i] = t_batch.dudy[i] = t_batch.dvdx[i] = t_batch.dvdy[i] = 0;
  }
  if (c.filter != SHD_FILTER_RIPMAP) check_case(c, *texture, make_sampler(desc), "wide border");
  free_texture(texture);
}

struct saturation_case {
  const char* name;
  float texels[4];
  shd_cubic cubic;
  float u, value, du;  // du NAN: any finite slope
};
const saturation_case k_saturations[] = {
    // Halfway between two texels Catmull-Rom is (9 (b + c) - (a + d)) / 16, and its slope (11 (c - b) - (d - a)) / 8.
    {"saturated/overshoot", {-kMax, kMax, kMax, -kMax}, SHD_CUBIC_CATMULL_ROM, 0.5f, kMax, NAN},
    {"saturated/undershoot", {kMax, -kMax, -kMax, kMax}, SHD_CUBIC_CATMULL_ROM, 0.5f, -kMax, NAN},
    {"saturated/slope", {0, -1e38f, 1e38f, 0}, SHD_CUBIC_CATMULL_ROM, 0.5f, 0, kMax},
    {"saturated/falling_slope", {0, 1e38f, -1e38f, 0}, SHD_CUBIC_CATMULL_ROM, 0.5f, 0, -kMax},
    {"saturated/mitchell", {-kMax, kMax, kMax, -kMax}, SHD_CUBIC_MITCHELL, 0.5f, kMax, NAN},
    {"saturated/constant", {kMax, kMax, kMax, kMax}, SHD_CUBIC_CATMULL_ROM, 0.3f, kMax, 0},
    {"saturated/small_constant", {-1e38f, -1e38f, -1e38f, -1e38f}, SHD_CUBIC_MITCHELL, 0.7f, -1e38f, 0},
};

void test_saturation(void** state) {
  const auto& c = *static_cast<const saturation_case*>(*state);
  Texture* texture = make_texture(SHD_FORMAT_R32F, 4, 1, reinterpret_cast<const uint8_t*>(c.texels), false);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_BICUBIC;
  desc.cubic = c.cubic;
  t_batch.count = 17;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = c.u;
    t_batch.v[i] = 0.5f;
  }
  for_each_target([&](int64_t target) {
    const Texels out = {{t_batch.out[0]}, {t_du[0]}, {}};
    shd::texture::sample(*texture, make_sampler(desc), shd::core::simd_target_from_bit(target),
                         t_batch.lookups(false, false), out);
    for (size_t i = 0; i < t_batch.count; ++i) {
      const bool slope_is_right = isnan(c.du) ? isfinite(t_du[0][i]) : t_du[0][i] == c.du;
      if (t_batch.out[0][i] != c.value || !slope_is_right) {
        fail_msg("%g, slope %g; want %g, slope %g", t_batch.out[0][i] + 0.0, t_du[0][i] + 0.0, c.value + 0.0,
                 c.du + 0.0);
      }
    }
  });
  free_texture(texture);
}

/// Texels that are not finite still propagate: they are not clamped.
void test_nonfinite_propagate(void**) {
  const float texels[4] = {0, INFINITY, 0, 0};
  Texture* texture = make_texture(SHD_FORMAT_R32F, 4, 1, reinterpret_cast<const uint8_t*>(texels), false);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_BILINEAR;
  t_batch.count = 1;
  t_batch.u[0] = 0.5f;
  t_batch.v[0] = 0.5f;
  for_each_target([&](int64_t target) {
    const Texels out = {{t_batch.out[0]}, {t_du[0]}, {}};
    shd::texture::sample(*texture, make_sampler(desc), shd::core::simd_target_from_bit(target),
                         t_batch.lookups(false, false), out);
    assert_true(isinf(t_batch.out[0][0]) && t_batch.out[0][0] > 0);
    assert_true(isinf(t_du[0][0]) && t_du[0][0] < 0);
  });
  free_texture(texture);
}

}  // namespace

int main() {
  static CMUnitTest tests[64];
  static char names[sizeof k_filters / sizeof k_filters[0]][48];
  size_t n = 0, i = 0;
  for (const filter_case& c : k_filters) {
    auto* given = const_cast<filter_case*>(&c);
    tests[n++] = {c.name, test_filter, nullptr, nullptr, given};
    snprintf(names[i], sizeof names[i], "border/%s", c.name);
    tests[n++] = {names[i++], test_border, nullptr, nullptr, given};
  }
  for (const saturation_case& c : k_saturations) {
    tests[n++] = {c.name, test_saturation, nullptr, nullptr, const_cast<saturation_case*>(&c)};
  }
  tests[n++] = {"nonfinite", test_nonfinite_propagate, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.finite", tests, n, nullptr, nullptr);
}
