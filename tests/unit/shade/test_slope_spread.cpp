// SPDX-License-Identifier: MIT
// Lobes averaged over the normals of a filtered map against the formulas in long double and against sums over normals,
// on every target. Without a covariance, all bits are those of the lobes of the mean normal.
#include "ref/slope_spread_ref.h"
#include "unit/shade/lobe_fixture.h"

namespace shd::tests {
namespace {

const ModelCase k_models[] = {
    {"lambert", SHD_MODEL_LAMBERT, 0, 64, 0.5f},
    {"phong/64", SHD_MODEL_PHONG, 0, 64, 0.5f},
    {"blinn_phong/0", SHD_MODEL_BLINN_PHONG, 0, 0, 0.5f},
    {"blinn_phong/8", SHD_MODEL_BLINN_PHONG, 0, 8, 0.5f},
    {"blinn_phong/200", SHD_MODEL_BLINN_PHONG, 0, 200, 0.5f},
    {"blinn_phong/ungated/200", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 200, 0.5f},
    {"combined/64", SHD_MODEL_COMBINED, 0, 64, 0.5f},
    {"normalized/64", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, 64, 0.5f},
    {"metallic_roughness/0.2", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 0.2f},
    {"metallic_roughness/0.4", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 0.4f},
    {"metallic_roughness/1", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 1},
};

void use_spread(bool is_used) {
  for (int k = 0; k < 6; ++k) g->shape.spread[k] = is_used ? g->columns.spread[k] : nullptr;
}

/// Vectors a and b of lengths 2^-6..2 across the normals or, in every third row, tilted; some of them 0 or parallel.
void random_spread(Random* random) {
  float* const* s = g->columns.spread;
  for (size_t i = 0; i < kBatch; ++i) {
    const Vector n = row_vector(g->points.nx, g->points.ny, g->points.nz, i);
    Vector of[2];
    for (Vector& v : of) {
      const Vector any = random_unit(random);
      const long double part = i % 3 ? 1 : 0.8L;  // share of the component along the normal that is removed
      v = (i % 7 ? std::exp2(random->in(-6.0, 1.0)) : 0.0) * (any - part * ref::dot(any, n) * n);
    }
    if (i % 5 == 0) of[1] = 0.5L * of[0];
    for (int k = 0; k < 2; ++k) {
      s[3 * k][i] = static_cast<float>(of[k].x);
      s[3 * k + 1][i] = static_cast<float>(of[k].y);
      s[3 * k + 2][i] = static_cast<float>(of[k].z);
    }
  }
}

ref::Normals normals_at(size_t i) {
  const raster::Fragments& f = g->points;
  float* const* s = g->columns.spread;
  return ref::normals_of(ref::unit(row_vector(f.nx, f.ny, f.nz, i)), row_vector(s[0], s[1], s[2], i),
                         row_vector(s[3], s[4], s[5], i));
}

void test_formula(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {191};
  set_material(*c);
  const uint32_t lobes = material::info_of(g->material.model).lobes;
  const double largest_slope_precision =
      c->model == SHD_MODEL_METALLIC_ROUGHNESS ? 2.0 / std::pow(double{c->roughness}, 4.0) : double{c->exponent};
  random_lights(&random, 1, kDirections);
  random_points(&random, largest_slope_precision);
  random_spread(&random);
  use_spread(true);
  illuminate_everywhere();
  const long double alpha = static_cast<long double>(c->roughness) * c->roughness;
  double largest[3] = {0, 0, 0};
  size_t ambiguous = 0;
  for (size_t i = 0; i < kBatch; ++i) {
    const raster::Fragments& f = g->points;
    const Vector v = row_vector(f.ox, f.oy, f.oz, i), l = ref::vector(g->light[0].to_light);
    const ref::LobeTerms want = ref::mean_lobes(g->material, c->exponent, alpha, normals_at(i), v, l);
    const double power = double{g->desc[0].intensity[0]};
    ambiguous += want.ambiguous;
    for (uint32_t k = 0; k < (want.ambiguous ? 1 : lobes); ++k) {
      const double got = double{g->first.lobes.lobe[k][0][i]} / power, wanted = static_cast<double>(want.lobe[k]);
      // The cosine of the reflecting normal is rounded by some 1e-6, which the exponent multiplies.
      const double relative = k ? 2e-5 + 4e-6 * std::sqrt(largest_slope_precision) : 0.0;
      largest[k] = std::max(largest[k], std::fabs(got - wanted) / (2e-6 + relative * wanted));
      shd_assert_close(c->name, i, got, wanted, 2e-6, relative);
    }
  }
  assert_true(ambiguous < kBatch / 4);
  print_message("  of the bounds: %.2f, %.2f, %.2f\n", largest[0], largest[1], largest[2]);
}

/// A covariance of 0 gives the bits of the mean normal.
void test_no_spread(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {192};
  set_material(*c);
  const uint32_t lobes = material::info_of(g->material.model).lobes;
  random_lights(&random, 6, kMixed);
  random_points(&random, 64.0);
  for (float* column : g->columns.spread) std::fill_n(column, kBatch, 0.0f);
  for_each_target([&](const core::SimdTarget& target, bool) {
    use_spread(false);
    shade::illuminate(target, g->material, g->shape, g->active, g->count, g->points, {false, true}, &g->first.lobes);
    use_spread(true);
    shade::illuminate(target, g->material, g->shape, g->active, g->count, g->points, {false, true}, &g->columns.lobes);
    for (uint32_t k = 0; k < 3 * lobes; ++k) {
      for (size_t i = 0; i < kBatch; ++i)
        assert_true(g->columns.lobes.lobe[k / 3][k % 3][i] == g->first.lobes.lobe[k / 3][k % 3][i]);
    }
  });
}

/// Huge, tiny and degenerate covariances give finite lobes.
void test_extremes(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {193};
  set_material(*c);
  const uint32_t lobes = material::info_of(g->material.model).lobes;
  random_lights(&random, 4, kDirections);
  random_points(&random, 64.0);
  random_spread(&random);
  const float scales[] = {1e-30f, 1e-18f, 1e-6f, 1.0f, 1e3f, 3e4f};
  for (size_t i = 0; i < kBatch; ++i) {
    for (float* column : g->columns.spread) column[i] *= scales[i / 2 % 6];
  }
  use_spread(true);
  illuminate_everywhere();
  for (uint32_t k = 0; k < 3 * lobes; ++k) {
    for (size_t i = 0; i < kBatch; ++i) {
      const float got = g->first.lobes.lobe[k / 3][k % 3][i];
      if (!(std::isfinite(got) && got >= 0.0f)) fail_msg("lobe %u of point %zu: %g", k / 3, i, double{got});
    }
  }
}

/// The mean of a lobe over 201 x 201 normals of a Gaussian of slopes.
template <class Lobe>
long double mean_over_normals(const ref::Normals& g, const Lobe& lobe_of) {
  const ref::Symmetric inverse = ref::inverse(g.covariance);
  const long double sx = sqrtl(g.covariance.xx), sy = sqrtl(g.covariance.yy);
  long double sum = 0, weights = 0;
  for (int i = -100; i <= 100; ++i) {
    for (int j = -100; j <= 100; ++j) {
      const long double x = 0.05L * i * sx, y = 0.05L * j * sy, w = expl(-ref::quadratic(inverse, x, y) / 2);
      sum += w * lobe_of(ref::unit(x * g.t + y * g.s + g.n));
      weights += w;
    }
  }
  return sum / weights;
}

void expect_close(const char* what, int i, long double got, long double want, double absolute, double relative) {
  shd_assert_close(what, static_cast<size_t>(i), static_cast<double>(got), static_cast<double>(want), absolute,
                   relative);
}

/// The formulas are close to the integral that they approximate, for slopes of deviation 0.3 and 0.1. GGX has tails
/// that four normals sample sparsely.
void test_integral(void**) {
  const Vector n = {0, 0, 1}, a = {0.3L, 0, 0}, b = {0.05L, 0.1L, 0};
  const ref::Normals normals = ref::normals_of(n, a, b);
  material::Material& m = g->material;
  const Vector v = ref::unit({0.3L, 0.2L, 1});
  for (int i = 0; i <= 16; ++i) {
    const long double angle = 0.1L * (i - 8);
    const Vector l = ref::unit({-0.3L + sinl(angle), -0.1L, cosl(angle)}), h = ref::unit(v + l);
    m.model = material::key_of(SHD_MODEL_BLINN_PHONG);
    const ref::LobeTerms got = ref::mean_lobes(m, 100, 1, normals, v, l);
    const auto cosine = [&](const Vector& at) { return std::max(0.0L, ref::dot(at, l)); };
    const auto shine = [&](const Vector& at) { return powl(std::max(0.0L, ref::dot(at, h)), 100); };
    expect_close("diffuse", i, got.lobe[0], mean_over_normals(normals, cosine), 0.012, 0.0);
    expect_close("specular", i, got.lobe[1], mean_over_normals(normals, shine), 0.003, 0.05);
    m.model = material::key_of(SHD_MODEL_METALLIC_ROUGHNESS);
    static const double k_roughness[3] = {0.8, 0.6, 0.4}, k_relative[3] = {0.02, 0.11, 0.2};
    for (size_t k = 0; k < 3; ++k) {
      const long double alpha = static_cast<long double>(k_roughness[k]) * k_roughness[k];
      const auto ggx = [&](const Vector& at) { return ref::metallic_lobes(at, v, l, alpha).lobe[1]; };
      expect_close("ggx", i, ref::mean_lobes(m, 0, alpha, normals, v, l).lobe[1], mean_over_normals(normals, ggx),
                   0.003, k_relative[k]);
    }
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  constexpr size_t kModels = sizeof k_models / sizeof k_models[0];
  static char names[3 * kModels][64];
  CMUnitTest tests[3 * kModels + 1];
  size_t n = 0;
  const auto add = [&](const char* kind, const ModelCase& c, CMUnitTestFunction body) {
    snprintf(names[n], sizeof names[0], "%s/%s", kind, c.name);
    tests[n] = {names[n], body, nullptr, nullptr, const_cast<ModelCase*>(&c)};
    ++n;
  };
  for (const ModelCase& c : k_models) {
    add("formula", c, test_formula);
    add("no_spread", c, test_no_spread);
    add("extremes", c, test_extremes);
  }
  tests[n] = {"integral", test_integral, nullptr, nullptr, nullptr};
  ++n;
  return _cmocka_run_group_tests("unit.shade.slope_spread", tests, n, set_up, tear_down);
}
