// SPDX-License-Identifier: MIT
// White furnaces: the fraction of light from one direction that models reflect, integrated numerically over the kernel
// and over the formulas in long double; and reciprocity.
#include "unit/shade/lobe_fixture.h"

#include <vector>

namespace shd::tests {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSteps = 96;  // steps of each angle

/// A direction of light and its weight: the integral of g over directions is the sum of weight g.
struct Direction {
  Vector l;
  double weight;
};
std::vector<Direction>* g_directions;

Vector eye(double degrees) {
  const double angle = degrees * kPi / 180.0;
  return {sin(angle), 0, cos(angle)};
}

/// Directions of light for half vectors. A half vector is given by place(u), the cosine of its angle, and by the
/// inverse of its density. Only half of the circle is used, because both sides of the plane of n and v are symmetric.
template <class Place>
void mirrored_directions(const Vector& v, const Place& place) {
  g_directions->clear();
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      double inverse_density;
      const double cosine = place((i + 0.5) / kSteps, &inverse_density);
      const double sine = sqrt(std::max(0.0, 1.0 - cosine * cosine)), phi = kPi * (j + 0.5) / kSteps;
      const Vector h = {sine * cos(phi), sine * sin(phi), cosine};
      const auto facing = static_cast<double>(ref::dot(v, h));
      const Vector l = 2 * ref::dot(v, h) * h - v;
      if (facing <= 0.0 || l.z <= 0) continue;
      g_directions->push_back({l, 4.0 * facing * inverse_density / (kSteps * kSteps)});
    }
  }
}

/// Directions with the density D cos of GGX.
void ggx_directions(const Vector& v, double alpha) {
  mirrored_directions(v, [&](double u, double* inverse_density) {
    const double tangent2 = alpha * alpha * u / (1.0 - u), cosine = 1.0 / sqrt(1.0 + tangent2);
    const double spread = cosine * cosine * (alpha * alpha - 1.0) + 1.0;
    *inverse_density = kPi * spread * spread / (alpha * alpha * cosine);
    return cosine;
  });
}

/// Directions with the density (p + 1) / (2 pi) cos^p.
void blinn_directions(const Vector& v, double p) {
  mirrored_directions(v, [&](double u, double* inverse_density) {
    const double cosine = pow(u, 1.0 / (p + 1.0));
    *inverse_density = 2.0 * kPi / ((p + 1.0) * pow(cosine, p));
    return cosine;
  });
}

/// Directions with the density cos / pi around n.
void cosine_directions() {
  g_directions->clear();
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double u = (i + 0.5) / kSteps, phi = kPi * (j + 0.5) / kSteps, cosine = sqrt(1.0 - u);
      g_directions->push_back({{sqrt(u) * cos(phi), sqrt(u) * sin(phi), cosine}, kPi / cosine / (kSteps * kSteps)});
    }
  }
}

struct Albedo {
  double lobe[3];
};

/// Integrals of the kernel's lobes over the directions: the points around one light see it from every side.
Albedo kernel_albedo(const core::SimdTarget& target, const Vector& v) {
  g->count = 1;
  set_light(0, shd_light_desc_default());
  const uint32_t lobes = material::info_of(g->material.model).lobes;
  Albedo sum = {};
  const std::vector<Direction>& all = *g_directions;
  for (size_t begin = 0; begin < all.size(); begin += kBatch) {
    g->points.count = std::min(kBatch, all.size() - begin);
    for (size_t i = 0; i < g->points.count; ++i) set_point(i, -1.0L * all[begin + i].l, {0, 0, 1}, v);
    for (size_t i = g->points.count; i < data::padded(g->points.count); ++i) set_point(i, {1, 0, 0}, {0, 0, 1}, v);
    shade::illuminate(target, g->material, {}, g->active, 1, g->points, {false, true}, &g->columns.lobes);
    for (uint32_t k = 0; k < lobes; ++k) {
      for (size_t i = 0; i < g->points.count; ++i)
        sum.lobe[k] += all[begin + i].weight * g->columns.lobes.lobe[k][0][i];
    }
  }
  return sum;
}

/// Integrals of the formulas.
Albedo exact_albedo(const Vector& v) {
  const material::Material& m = g->material;
  const long double alpha = std::max(static_cast<long double>(m.roughness) * m.roughness, 1e-3L);
  Albedo sum = {};
  for (const Direction& direction : *g_directions) {
    const ref::LobeTerms t = ref::lobes_of(m, m.exponent, alpha, {0, 0, 1}, v, direction.l);
    for (int k = 0; k < 3; ++k) sum.lobe[k] += direction.weight * static_cast<double>(t.lobe[k]);
  }
  return sum;
}

/// Integrals of kernel and formulas, which must agree.
Albedo albedo(const Vector& v, double tolerance) {
  const Albedo got = kernel_albedo(best_target(), v), want = exact_albedo(v);
  for (size_t k = 0; k < 3; ++k) shd_assert_close("albedo", k, got.lobe[k], want.lobe[k], tolerance, 0.0);
  return got;
}

constexpr double kAngles[] = {0, 30, 45, 60, 75, 85, 89};
constexpr float kRoughness[] = {0, 0.03f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1};
constexpr double kQuadrature = 1e-3;

Albedo metallic_roughness(const Vector& v, float roughness) {
  set_material({"", SHD_MODEL_METALLIC_ROUGHNESS, 0, 1, roughness});
  ggx_directions(v, std::max(double{roughness} * double{roughness}, 1e-3));
  return albedo(v, 5e-4);
}

/// Metal of base colour 1: smooth metals reflect all light, rough metals lose the light that would be reflected twice.
/// The loss grows with the roughness, except at angles near 90 degrees, where it decreases again from 0.3 on.
void test_metal(void**) {
  for (double angle : kAngles) {
    double before = 1.0;
    for (float roughness : kRoughness) {
      const Albedo a = metallic_roughness(eye(angle), roughness);
      const double sent = a.lobe[1] + a.lobe[2];
      assert_true(sent <= 1.0 + kQuadrature && sent >= 0.3);
      if (roughness <= 0.1f) assert_true(sent >= (angle <= 85.0 ? 0.98 : 0.89));
      if (roughness <= 0.3f && angle <= 60.0) assert_true(sent >= 0.97);
      if (angle <= 75.0) assert_true(sent <= before + kQuadrature);
      before = sent;
    }
  }
}

/// Dielectric of base colour 1: the diffuse term of glTF's formula does not account for the specular reflection at
/// grazing angles, where the sum of both exceeds 1.
void test_dielectric(void**) {
  const double most[] = {1.0, 1.0, 1.003, 1.027, 1.21, 1.6, 1.86};
  for (size_t k = 0; k < sizeof kAngles / sizeof kAngles[0]; ++k) {
    double largest = 0.0;
    for (float roughness : kRoughness) {
      const Vector v = eye(kAngles[k]);
      const Albedo mirrored = metallic_roughness(v, roughness);
      cosine_directions();
      const double scattered = kernel_albedo(best_target(), v).lobe[0] / kPi, f = double{g->material.dielectric_f0};
      const double sent = (1.0 - f) * scattered + f * mirrored.lobe[1] + mirrored.lobe[2];
      assert_true(sent >= 0.97);
      largest = std::max(largest, sent);
    }
    print_message("  %g degrees: %.4f\n", kAngles[k], largest);
    assert_true(largest <= most[k] + kQuadrature);
  }
}

/// The specular lobe of the normalised model with k_s = 1: 1 at normal incidence, never more.
void test_normalized(void**) {
  for (double angle : kAngles) {
    for (float p : {0.0f, 0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f, 64.0f, 256.0f, 1e3f, 1e4f}) {
      set_material({"", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, p, 0.5f});
      blinn_directions(eye(angle), double{p});
      const double sent = albedo(eye(angle), 1e-3).lobe[1];
      assert_true(sent <= 1.0 + kQuadrature);
      if (angle == 0.0) shd_assert_close("normal incidence", static_cast<size_t>(p), sent, 1.0, 1e-3, 0.0);
    }
  }
}

/// Light and eye can be exchanged: lobes over n.l do not change.
void test_reciprocity(void**) {
  Random random = {91};
  for (float roughness : {0.3f, 0.5f, 1.0f}) {
    set_material({"", SHD_MODEL_METALLIC_ROUGHNESS, 0, 1, roughness});
    g->count = 1;
    set_light(0, shd_light_desc_default());
    g->points.count = kBatch;
    double cosine[kBatch];
    for (size_t i = 0; i < kBatch; i += 2) {
      Vector a = random_unit(&random), b = random_unit(&random);
      a.z = fabsl(a.z) + 0.1L, b.z = fabsl(b.z) + 0.1L;
      a = ref::unit(a), b = ref::unit(b);
      set_point(i, -1.0L * a, {0, 0, 1}, b);
      set_point(i + 1, -1.0L * b, {0, 0, 1}, a);
      cosine[i] = static_cast<double>(a.z), cosine[i + 1] = static_cast<double>(b.z);
    }
    illuminate_everywhere();
    for (size_t i = 0; i < kBatch; i += 2) {
      for (int k = 0; k < 3; ++k) {
        const float* lobe = g->first.lobes.lobe[k][0];
        shd_assert_close("lobe", i, lobe[i] / cosine[i], lobe[i + 1] / cosine[i + 1], 1e-6, 1e-4);
      }
    }
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  g_directions = new std::vector<Direction>;
  const CMUnitTest tests[] = {
      {"metal", test_metal, nullptr, nullptr, nullptr},
      {"dielectric", test_dielectric, nullptr, nullptr, nullptr},
      {"normalized", test_normalized, nullptr, nullptr, nullptr},
      {"reciprocity", test_reciprocity, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.material.energy", tests, sizeof tests / sizeof tests[0], set_up, tear_down);
}
