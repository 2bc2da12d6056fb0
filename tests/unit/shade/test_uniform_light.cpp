// SPDX-License-Identifier: MIT
// Models in an environment of radiance 1 reflect the integrals of their lobes, within 0.004, for every roughness,
// exponent and n.v.
#include "unit/shade/lobe_fixture.h"

#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <vector>

#include "ref/reflection_ref.h"
#include "shade/surround.h"

namespace shd::tests {
namespace {

constexpr double kBound = 0.004;
constexpr size_t kCosines = 64, kWidths = 97;

/// Reflections of models with coefficients of 1.
enum Reflection { kMetal, kBlackMetal, kDielectric, kDiffuse, kCoat, kPhong, kBlinnPhong, kNormalized, kReflections };
constexpr const char* kNames[kReflections] = {
    "metal of F0 = 1", "metal of F0 = 0", "white dielectric", "diffuse part",
    "clear coat",      "Phong",           "Blinn-Phong",      "normalised Blinn-Phong"};

/// n.v from 1e-4, the least of the models, to 1, denser at both ends.
double cosine_at(size_t i) {
  const double t = static_cast<double>(i) / (kCosines - 1);
  return std::max(1e-4, i % 2 ? t * t * t * t : 1.0 - (1.0 - t) * (1.0 - t));
}
/// Roughness or (p + 1)^(-1/4), from 1 to the least of the models; exponents up to 1e6.
double width_at(size_t k) {
  return 1.0 - 0.9684 * static_cast<double>(k) / (kWidths - 1);
}

/// An environment of radiance 1: one map of 4 x 4 texels for all lobes.
struct Uniform {
  environment::Environment map = {};
  shade::EnvironmentLight light = {&map, 1.0f, {1, 0, 0, 0, 1, 0, 0, 0, 1}};

  Uniform() {
    constexpr float kWhite[3] = {1.0f, 1.0f, 1.0f};
    map.texels = core::Array<environment::PackedTexel>(g_allocator, environment::texel_count(4));
    for (environment::PackedTexel& texel : map.texels) texel = environment::pack(kWhite);
    map.ggx.count = map.ggx.lobes = map.phong.count = map.phong.lobes = 1;
    map.ggx.level[0] = map.phong.level[0] = {4, 0};
    for (auto& channel : map.harmonics) channel[0] = static_cast<float>(ref::kReflectionPi);
  }
};
std::unique_ptr<Uniform> g_uniform;

int open_uniform(void** state) {
  g_uniform = std::make_unique<Uniform>();
  return set_up(state);
}
int close_uniform(void** state) {
  g_uniform.reset();
  return tear_down(state);
}

/// The largest error, and where it is.
struct Worst {
  double error = 0.0, width = 0.0, n_dot_v = 0.0;
  void add(double got, double want, double at_width, double at_cosine) {
    const double e = std::fabs(got - want);
    if (!(e <= error)) error = e, width = at_width, n_dot_v = at_cosine;
  }
};

/// Sets kCosines points seen at all n.v.
void set_points() {
  g->points.count = kCosines;
  for (size_t i = 0; i < kCosines; ++i) {
    const long double c = cosine_at(i);
    set_point(i, {0, 0, 0}, {0, 0, 1}, {sqrtl(1 - c * c), 0, c});
  }
}

void surround_by(const core::SimdTarget& target, shd_model model, double roughness, double exponent,
                 bool is_coated = false) {
  set_material({"", model, 0, static_cast<float>(exponent), static_cast<float>(roughness)});
  if (is_coated) g->material.model = material::ModelKey::kClearCoat;
  g->material.coat = 1.0f;
  g->material.coat_roughness = g->material.roughness;
  shade::surround(target, g->material, g->shape, g_uniform->light, g->points, nullptr, nullptr, &g->columns.lobes);
}
double lobe(int k, size_t i) {
  return static_cast<double>(g->columns.lobes.lobe[k][1][i]);
}

void check_ggx(const core::SimdTarget& target, double roughness, const std::vector<ref::GgxReflection>& exact,
               const std::vector<double>& diffuse, Worst* worst) {
  constexpr double kPi = ref::kReflectionPi;
  for (const bool coat : {false, true}) {
    surround_by(target, SHD_MODEL_METALLIC_ROUGHNESS, roughness, 1.0, coat);
    for (size_t i = 0; i < kCosines; ++i) {
      const double n_dot_v = cosine_at(i), white = exact[i].white, black = exact[i].black;
      const auto add = [&](Reflection r, double got, double want) { worst[r].add(got, want, roughness, n_dot_v); };
      if (coat) {
        const double f = 0.04 + 0.96 * std::pow(1.0 - n_dot_v, 5);
        add(kCoat, lobe(1, i) + lobe(2, i) + lobe(3, i), (1.0 - f) * white + f * white);
        continue;
      }
      add(kMetal, lobe(1, i) + lobe(2, i), white);
      add(kBlackMetal, lobe(2, i), black);
      add(kDiffuse, lobe(0, i) / kPi, diffuse[i]);
      add(kDielectric, 0.96 / kPi * lobe(0, i) + 0.04 * lobe(1, i) + lobe(2, i),
          0.96 * diffuse[i] + 0.04 * (white - black) + black);
    }
  }
}

void check_exponent(const core::SimdTarget& target, double width, const std::vector<double>* exact, Worst* worst) {
  constexpr shd_model kModels[] = {SHD_MODEL_PHONG, SHD_MODEL_BLINN_PHONG, SHD_MODEL_BLINN_PHONG_NORMALIZED};
  for (int m = 0; m < 3; ++m) {
    surround_by(target, kModels[m], 1.0, std::pow(width, -4.0) - 1.0);
    for (size_t i = 0; i < kCosines; ++i) worst[kPhong + m].add(lobe(1, i), exact[m][i], width, cosine_at(i));
  }
}

void test_reflections(void**) {
  Worst worst[kReflections];
  set_points();
  std::vector<double> diffuse;
  for (size_t i = 0; i < kCosines; ++i) diffuse.push_back(ref::diffuse_reflection(cosine_at(i)));
  for (size_t k = 0; k < kWidths; k += SHD_ORACLE_STRIDE) {
    const double width = width_at(k), p = std::pow(width, -4.0) - 1.0;
    std::vector<ref::GgxReflection> ggx;
    std::vector<double> sums[3];
    for (size_t i = 0; i < kCosines; ++i) {
      const double c = cosine_at(i);
      ggx.push_back(ref::ggx_reflection(std::max(width * width, 1e-3), c));
      sums[0].push_back(ref::phong_reflection(p, c));
      sums[1].push_back(ref::blinn_phong_reflection(p, c, false));
      sums[2].push_back(ref::blinn_phong_reflection(p, c, true) * static_cast<double>(ref::normalization(p)));
    }
    for_each_target([&](const core::SimdTarget& target, bool) {
      check_ggx(target, width, ggx, diffuse, worst);
      check_exponent(target, width, sums, worst);
    });
  }
  bool failed = false;
  for (int r = 0; r < kReflections; ++r) {
    failed |= !(worst[r].error <= kBound);
    if (getenv("SHD_TEST_VERBOSE") || worst[r].error > kBound) {
      printf("%s: %.5f at width %g, n.v %g\n", kNames[r], worst[r].error, worst[r].width, worst[r].n_dot_v);
    }
  }
  if (failed) fail_msg("errors above %g", kBound);
}

/// Normals that face away from the eye, as interpolated ones may, reflect what those with the least n.v do.
void test_facing_away(void**) {
  constexpr double kAway[] = {1e-4, 1e-5, 0.0, -1e-3, -0.3, -1.0};
  g->points.count = std::size(kAway);
  for (size_t i = 0; i < std::size(kAway); ++i) {
    const long double c = kAway[i];
    set_point(i, {0, 0, 0}, {0, 0, 1}, {sqrtl(1 - c * c), 0, c});
  }
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (const double roughness : {0.0, 0.3, 1.0}) {
      surround_by(target, SHD_MODEL_METALLIC_ROUGHNESS, roughness, 1.0);
      for (size_t i = 1; i < std::size(kAway); ++i) {
        for (int k = 0; k < 3; ++k) shd_assert_close("lobe", i, lobe(k, i), lobe(k, 0), 2e-6, 0.0);
      }
    }
  });
}

/// Sums of the lobes of one light over many directions give the integrals of the oracle.
void test_oracle(void**) {
  constexpr int kRows = 160, kColumns = 320;
  struct Case {
    shd_model model;
    double parameter, n_dot_v;
  };
  constexpr Case kCases[] = {{SHD_MODEL_METALLIC_ROUGHNESS, 0.6, 0.5},
                             {SHD_MODEL_METALLIC_ROUGHNESS, 1.0, 0.05},
                             {SHD_MODEL_PHONG, 3.0, 0.3},
                             {SHD_MODEL_BLINN_PHONG, 0.5, 0.1},
                             {SHD_MODEL_BLINN_PHONG_NORMALIZED, 9.0, 0.7}};
  for (const Case& c : kCases) {
    set_material({"", c.model, 0, 1.0f, 1.0f});
    const Vector v = {sqrtl(1 - static_cast<long double>(c.n_dot_v) * c.n_dot_v), 0, c.n_dot_v};
    double sum[3] = {};
    for (int i = 0; i < kRows * kColumns; ++i) {
      const long double z = (i / kColumns + 0.5L) / kRows, s = sqrtl(1 - z * z);
      const long double turn = 2 * acosl(-1.0L) * (i % kColumns + 0.5L) / kColumns;
      const ref::LobeTerms t =
          ref::lobes_of(g->material, c.parameter, c.parameter, {0, 0, 1}, v, {s * cosl(turn), s * sinl(turn), z});
      for (int k = 0; k < 3; ++k) sum[k] += static_cast<double>(t.lobe[k]);
    }
    for (double& lobes : sum) lobes *= 2.0 * ref::kReflectionPi / (kRows * kColumns);
    if (c.model == SHD_MODEL_METALLIC_ROUGHNESS) {
      const ref::GgxReflection exact = ref::ggx_reflection(c.parameter, c.n_dot_v);
      shd_assert_close("white", 0, sum[1] + sum[2], exact.white, 3e-4, 0.0);
      shd_assert_close("black", 0, sum[2], exact.black, 3e-4, 0.0);
      shd_assert_close("diffuse", 0, sum[0], ref::kReflectionPi * ref::diffuse_reflection(c.n_dot_v), 3e-4, 0.0);
      continue;
    }
    const double norm = static_cast<double>(ref::normalization(c.parameter));
    const double exact = c.model == SHD_MODEL_PHONG ? ref::phong_reflection(c.parameter, c.n_dot_v)
                         : c.model == SHD_MODEL_BLINN_PHONG
                             ? ref::blinn_phong_reflection(c.parameter, c.n_dot_v, false)
                             : norm * ref::blinn_phong_reflection(c.parameter, c.n_dot_v, true);
    shd_assert_close("lobe", 0, sum[1], exact, 1e-3, 0.0);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {cmocka_unit_test(test_oracle), cmocka_unit_test(test_reflections),
                              cmocka_unit_test(test_facing_away)};
  return _cmocka_run_group_tests("unit.shade.uniform_light", tests, std::size(tests), open_uniform, close_uniform);
}
