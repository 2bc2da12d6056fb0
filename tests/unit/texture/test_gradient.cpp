// SPDX-License-Identifier: MIT
// Derivatives in u and v against differences of the double oracle inside a texel, on every target; computing
// derivatives does not change values.
#include "points.h"

namespace {

using namespace fixture;

struct gradient_case {
  const char* name;
  shd_filter filter;
};
const gradient_case k_cases[] = {
    {"bilinear", SHD_FILTER_BILINEAR},         {"bicubic", SHD_FILTER_BICUBIC},
    {"hermite", SHD_FILTER_HERMITE},           {"trilinear", SHD_FILTER_TRILINEAR},
    {"bilinear_mip", SHD_FILTER_BILINEAR_MIP}, {"ripmap", SHD_FILTER_RIPMAP},
    {"anisotropic", SHD_FILTER_ANISOTROPIC},   {"ewa", SHD_FILTER_EWA},
};

constexpr uint32_t kWidth = 32, kHeight = 16;
constexpr double kStep = 1e-4;              // texels
constexpr size_t kOddPoints = kPoints - 1;  // leaves a tail on every target

Batch t_batch, t_values;
float t_du[4][kMaxPoints], t_dv[4][kMaxPoints];

/// Points off the texel boundaries of every level, where the filters are smooth.
void make_smooth_points() {
  Random random{99};
  t_batch.count = kOddPoints;
  for (size_t i = 0; i < kPoints; ++i) {
    // Odd multiples of 1/4 texel of a level are never half a texel of it or of the next levels from a boundary.
    t_batch.u[i] = (floorf(random.real(-40, 70)) + random.real(0.55f, 0.95f)) / kWidth;
    t_batch.v[i] = (floorf(random.real(-20, 34)) + random.real(0.55f, 0.95f)) / kHeight;
    t_batch.lod[i] = i % 2 ? 0.0f : 0.75f;
  }
}

/// Value of a filter in double, at a point moved by texels of the base.
double value(const gradient_case& c, const ref::Image& image, size_t i, double du, double dv, int channel) {
  const double u = static_cast<double>(t_batch.u[i]) + du / kWidth,
               v = static_cast<double>(t_batch.v[i]) + dv / kHeight;
  const double lod = static_cast<double>(t_batch.lod[i]);
  if (c.filter == SHD_FILTER_BILINEAR) return ref::bilinear(image, 0, u, v, channel);
  if (c.filter == SHD_FILTER_BICUBIC) return ref::bicubic(image, u, v, channel);
  if (c.filter == SHD_FILTER_HERMITE) return ref::hermite(image, u, v, channel);
  if (c.filter == SHD_FILTER_BILINEAR_MIP) return ref::bilinear(image, lod > 0.5 ? 1 : 0, u, v, channel);
  return ref::trilinear(image, u, v, lod, channel);
}

/// Whether the piecewise bilinear filters have a kink within a step of the point, on the levels that they read.
bool near_kink(size_t i) {
  for (const double size : {1.0, 0.5}) {
    const double x = static_cast<double>(t_batch.u[i]) * kWidth * size - 0.5;
    const double y = static_cast<double>(t_batch.v[i]) * kHeight * size - 0.5;
    if (fabs(x - round(x)) < 0.01 || fabs(y - round(y)) < 0.01) return true;
  }
  return false;
}

void check_points(const gradient_case& c, const ref::Image& image, double m) {
  for (size_t i = 0; i < kOddPoints; ++i) {
    if (near_kink(i)) continue;
    for (int channel = 0; channel < 4; ++channel) {
      const double du = (value(c, image, i, kStep, 0, channel) - value(c, image, i, -kStep, 0, channel)) / (2 * kStep);
      const double dv = (value(c, image, i, 0, kStep, channel) - value(c, image, i, 0, -kStep, channel)) / (2 * kStep);
      shd_assert_close("du", i, static_cast<double>(t_du[channel][i]), du * kWidth, m * kWidth * 2e-4, 0);
      shd_assert_close("dv", i, static_cast<double>(t_dv[channel][i]), dv * kHeight, m * kHeight * 2e-4, 0);
    }
  }
}

/// At this level of detail a ripmap blends levels (0, 0) and (1, 1) four ways, so that only its bits are compared. The
/// derivatives of an ellipse's weights are tested in test_ewa.
bool has_oracle(const gradient_case& c) {
  return c.filter != SHD_FILTER_RIPMAP && c.filter != SHD_FILTER_EWA;
}

void test_gradient(void** state) {
  const auto& c = *static_cast<const gradient_case*>(*state);
  make_smooth_points();
  memcpy(&t_values, &t_batch, sizeof t_batch);
  for (const shd_format format : kFormats) {
    uint8_t* texels = static_cast<uint8_t*>(malloc(size_t{kWidth} * kHeight * 16));
    random_texels(format, size_t{kWidth} * kHeight, 77, texels);
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = format;
    desc.width = kWidth;
    desc.height = kHeight;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP;
    auto* texture = shd::core::create<Texture>(context()->allocator);
    shd::texture::build(*context(), desc, texture);
    free(texels);
    for (uint32_t wrap = 0; wrap < 5; ++wrap) {
      shd_sampler_desc sampler_desc = shd_sampler_desc_default();
      sampler_desc.filter = c.filter;
      sampler_desc.wrap_u = static_cast<shd_wrap>(wrap);
      sampler_desc.wrap_v = static_cast<shd_wrap>((wrap + 1) % 5);
      sampler_desc.border[0] = 0.25f;
      const Sampler sampler = make_sampler(sampler_desc);
      ref::Level levels[shd::texture::kMaxLevels];
      const ref::Image image = oracle_image(*texture, sampler_desc, levels);
      uint64_t first_hash = 0;
      for_each_target([&](int64_t target) {
        run(*texture, sampler, target, t_values.lookups(false, true), &t_values);
        Texels out = {{t_batch.out[0], t_batch.out[1], t_batch.out[2], t_batch.out[3]}, {}, {}};
        for (size_t k = 0; k < 4; ++k) {
          out.du[k] = t_du[k];
          out.dv[k] = t_dv[k];
        }
        shd::texture::sample(*texture, sampler, shd::core::simd_target_from_bit(target), t_batch.lookups(false, true),
                             out);
        for (size_t k = 0; k < 4; ++k) {
          assert_memory_equal(t_batch.out[k], t_values.out[k], kOddPoints * sizeof(float));
        }
        const uint64_t hash = shd_hash(shd_hash(SHD_HASH_START, t_du, sizeof t_du), t_dv, sizeof t_dv);
        if (first_hash == 0) first_hash = hash;
        assert_true(hash == first_hash);
      });
      if (has_oracle(c)) check_points(c, image, fmax(magnitude(format), 1));
    }
    free_texture(texture);
  }
}

/// A constant texture has no slope.
void test_constant(void** state) {
  const auto& c = *static_cast<const gradient_case*>(*state);
  uint8_t texels[16 * 16 * 4];
  memset(texels, 173, sizeof texels);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGBA8_SRGB;
  desc.width = desc.height = 16;
  desc.texels = texels;
  desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  make_points(&t_batch);
  shd_sampler_desc sampler_desc = shd_sampler_desc_default();
  sampler_desc.filter = c.filter;
  for_each_target([&](int64_t target) {
    Texels out = {{}, {t_du[0], t_du[1], t_du[2], t_du[3]}, {t_dv[0], t_dv[1], t_dv[2], t_dv[3]}};
    shd::texture::sample(*texture, make_sampler(sampler_desc), shd::core::simd_target_from_bit(target),
                         t_batch.lookups(true, false), out);
    for (size_t k = 0; k < 4; ++k) {
      for (size_t i = 0; i < t_batch.count; ++i) assert_true(t_du[k][i] == 0 && t_dv[k][i] == 0);
    }
  });
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[16];
  static char names[16][40];
  size_t n = 0;
  for (const gradient_case& c : k_cases) {
    for (const bool constant : {false, true}) {
      snprintf(names[n], sizeof names[n], "%s/%s", constant ? "constant" : "oracle", c.name);
      tests[n] = {names[n], constant ? test_constant : test_gradient, nullptr, nullptr, const_cast<gradient_case*>(&c)};
      ++n;
    }
  }
  return _cmocka_run_group_tests("unit.texture.gradient", tests, n, nullptr, nullptr);
}
