// SPDX-License-Identifier: MIT
// Normals bumped by gradients against surfaces that are really displaced, in long double; and lobes shaped by slots and
// by the variance of normal maps.
#include "unit/shade/normals_fixture.h"

#include "shade/illuminate.h"

namespace shd::tests {
namespace {

/// A torus around the z axis.
struct Torus {
  long double radius, tube;
  Vector at(long double u, long double v, long double height) const {
    const long double r = radius + (tube + height) * cosl(v);
    return {r * cosl(u), r * sinl(u), (tube + height) * sinl(v)};
  }
};

/// The normal of a torus displaced by h(u, v) = a u + b v + c u v around (u0, v0), where h is 0, by differences.
Vector displaced_normal(const Torus& torus, long double u0, long double v0, long double a, long double b,
                        long double c) {
  const long double e = 1e-6L;
  const auto p = [&](long double u, long double v) { return torus.at(u0 + u, v0 + v, a * u + b * v + c * u * v); };
  return ref::unit(ref::cross(p(e, 0) - p(-e, 0), p(0, e) - p(0, -e)));
}

struct BumpCase {
  const char* name;
  double low_u, high_u, low_v, high_v;  // log2 of the scale of u and v
  bool swapped;                         // v before u: mirrored
};
const BumpCase k_bumps[] = {
    {"bump/surface", 0, 1, 0, 1, false},         {"bump/mirrored", 0, 1, 0, 1, true},
    {"bump/stretched", -8, 8, -8, 8, false},     {"bump/tiny_frames", -40, -36, -40, -36, false},
    {"bump/huge_frames", 36, 40, 36, 40, false}, {"bump/huge_and_tiny", 36, 40, -40, -36, true},
};

void run_bumps(const core::SimdTarget& target, raster::Fragments* points) {
  shade::bump_normals(target, g->given.tilt, g->given.tangent_frame, points);
}

void test_bump(void** state) {
  const auto* c = static_cast<const BumpCase*>(*state);
  Random random = {111};
  static Vector want[kBatch];
  g->before.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const Torus torus = {random.in(2.0, 4.0), random.in(0.2, 1.0)};
    const double u = random.in(0.0, 6.0), v = random.in(0.0, 6.0), a = random.in(-3.0, 3.0), b = random.in(-3.0, 3.0);
    const double su = std::exp2(random.in(c->low_u, c->high_u)), sv = std::exp2(random.in(c->low_v, c->high_v));
    want[i] = displaced_normal(torus, u, v, a, b, random.in(-3.0, 3.0));
    const long double e = 1e-6L;
    const Vector dpdu = 0.5L / e * su * (torus.at(u + e, v, 0) - torus.at(u - e, v, 0));
    const Vector dpdv = 0.5L / e * sv * (torus.at(u, v + e, 0) - torus.at(u, v - e, 0));
    const int first = c->swapped ? 3 : 0;
    float* const* frame = g->given.tangent_frame;
    store(dpdu, frame[first], frame[first + 1], frame[first + 2], i);
    store(dpdv, frame[3 - first], frame[4 - first], frame[5 - first], i);
    g->given.tilt[c->swapped][i] = static_cast<float>(a * su);
    g->given.tilt[!c->swapped][i] = static_cast<float>(b * sv);
    const Vector n = ref::unit(ref::cross(dpdu, dpdv));
    store(n, g->before.nx, g->before.ny, g->before.nz, i);
  }
  turn_tails(run_bumps);
  turn_everywhere(run_bumps);
  for (size_t i = 0; i < kBatch; ++i) check_normal("n", i, want[i], 2e-6);
}

/// Compares any normal and frame with n - grad h.
void test_bump_formula(void**) {
  Random random = {112};
  random_points(&random);
  for (size_t i = 0; i < kBatch; ++i) {
    for (int c = 0; c < 6; ++c) g->given.tangent_frame[c][i] = random.real(-2.0, 2.0);
    for (int c = 0; c < 2; ++c) g->given.tilt[c][i] = random.real(-2.0, 2.0);
  }
  turn_everywhere(run_bumps);
  for (size_t i = 0; i < kBatch; ++i) {
    float* const* f = g->given.tangent_frame;
    const Vector n = normal_of(g->before, i), dpdu = load(f[0], f[1], f[2], i), dpdv = load(f[3], f[4], f[5], i);
    const long double area = fabsl(ref::dot(n, ref::cross(dpdu, dpdv)));
    const long double cosine = area / (ref::length(dpdu) * ref::length(dpdv));
    const Vector turned = ref::bumped(n, dpdu, dpdv, g->given.tilt[0][i], g->given.tilt[1][i]);
    if (cosine > 1e-4L) check_normal("n", i, ref::unit(turned), static_cast<double>(1e-6L / cosine));
  }
}

/// With frames without area or non-finite gradients, normals do not change.
void test_bump_degenerate(void**) {
  const float frames[][6] = {{0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0}, {1, 0, 0, 2, 0, 0}, {0, 0, 1, 0, 1, 0},
                             {1, 0, 0, 0, 1, 0}, {1, 0, 0, 0, 1, 0}, {1, 0, 0, 0, 1, 0}};
  const float tilts[][2] = {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {NAN, 0}, {0, INFINITY}, {3e38f, -3e38f}};
  g->before.count = 7;
  for (size_t i = 0; i < 64; ++i) {
    const size_t row = std::min(i, size_t{6});
    store({0, 0, 1}, g->before.nx, g->before.ny, g->before.nz, i);
    for (int c = 0; c < 6; ++c) g->given.tangent_frame[c][i] = frames[row][c];
    for (int c = 0; c < 2; ++c) g->given.tilt[c][i] = tilts[row][c];
  }
  turn_everywhere(run_bumps);
  for (size_t i = 0; i < 7; ++i) check_normal("n", i, {0, 0, 1}, 0.0);
}

struct ShapeCase {
  const char* name;
  shd_model model;
  bool has_column, has_variance;
  bool has_exponent, has_alpha;  // the resulting shape
};
const ShapeCase k_shapes[] = {
    {"shape/lambert", SHD_MODEL_LAMBERT, true, true, false, false},
    {"shape/blinn_phong/constant", SHD_MODEL_BLINN_PHONG, false, false, false, false},
    {"shape/blinn_phong/column", SHD_MODEL_BLINN_PHONG, true, false, true, false},
    {"shape/blinn_phong/variance", SHD_MODEL_BLINN_PHONG, false, true, true, false},
    {"shape/phong/both", SHD_MODEL_PHONG, true, true, true, false},
    {"shape/combined/both", SHD_MODEL_COMBINED, true, true, true, false},
    {"shape/normalized/both", SHD_MODEL_BLINN_PHONG_NORMALIZED, true, true, true, false},
    {"shape/toon/both", SHD_MODEL_TOON, true, true, true, false},
    {"shape/metallic_roughness/constant", SHD_MODEL_METALLIC_ROUGHNESS, false, false, false, false},
    {"shape/metallic_roughness/column", SHD_MODEL_METALLIC_ROUGHNESS, true, false, false, true},
    {"shape/metallic_roughness/variance", SHD_MODEL_METALLIC_ROUGHNESS, false, true, false, true},
    {"shape/metallic_roughness/both", SHD_MODEL_METALLIC_ROUGHNESS, true, true, false, true},
};

long double held(long double x, long double maximum, long double for_nan) {
  return std::isnan(x) ? for_nan : x < 0 ? 0 : x > maximum ? maximum : x;
}

/// Columns of any value, in and out of range, and the resulting shapes.
void fill_shapes(Random* random) {
  const float odd[] = {NAN, INFINITY, -INFINITY, -1.0f, 0.0f, 1e30f, 1e-30f};
  for (size_t i = 0; i < kBatch; ++i) {
    const float p = random->real(0.0, 4.0), r = random->real(0.0, 1.2), odd_value = odd[i / 4 % 7];
    g->given.slot[SHD_SLOT_EXPONENT][0][i] = i % 4 ? p : odd_value;
    g->given.slot[SHD_SLOT_ROUGHNESS][0][i] = i % 4 ? r : odd_value;
    g->given.variance[i] = i % 3 ? static_cast<float>(std::exp2(random->in(-20.0, 8.0))) : i % 2 ? 0.0f : 1e30f;
  }
}

void check_shape(const ShapeCase& c, size_t i, const shade::LobeShape& shape) {
  const material::Material& m = g->material;
  const long double variance = c.has_variance ? g->given.variance[i] : 0;
  if (c.has_exponent) {
    const long double column = c.has_column ? g->given.slot[SHD_SLOT_EXPONENT][0][i] : 1;
    const long double p = held(m.exponent * column, 1e6L, 0), widened = p / (1 + p * variance);
    shd_assert_close("exponent", i, shape.column[0][i], static_cast<double>(widened), 1e-37, 4e-7);
    shd_assert_close("gain", i, shape.column[1][i], static_cast<double>((1 + widened) / (1 + p)), 0, 6e-7);
  }
  if (c.has_alpha) {
    const long double column = c.has_column ? g->given.slot[SHD_SLOT_ROUGHNESS][0][i] : 1;
    const long double r = held(m.roughness * column, 1, 1), alpha = std::max(r * r, 1e-3L);
    const long double widened = std::min(1.0L, alpha * alpha + 2 * variance);
    shd_assert_close("alpha^2", i, shape.column[0][i], static_cast<double>(widened), 0, 4e-7);
  }
}

void test_shape(void** state) {
  const auto* c = static_cast<const ShapeCase*>(*state);
  Random random = {113};
  shd_material_desc desc = shd_material_desc_default();
  desc.model = c->model;
  desc.exponent = 50.0f;
  desc.roughness = 0.7f;
  const material::SlotInput slots[material::kSlotCount] = {};
  material::build(desc, slots, &g->material);
  fill_shapes(&random);
  material::Parameters p = {};
  if (c->has_column) {
    p.value[SHD_SLOT_EXPONENT][0] = g->given.slot[SHD_SLOT_EXPONENT][0];
    p.value[SHD_SLOT_ROUGHNESS][0] = g->given.slot[SHD_SLOT_ROUGHNESS][0];
  }
  const float* variance = c->has_variance ? g->given.variance : nullptr;
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count : {size_t{0}, size_t{1}, size_t{63}, size_t{65}, kBatch}) {
      for (float* column : g->columns.shape) std::fill_n(column, kBatch, -77.0f);
      const shade::LobeShape shape = shade::shape_lobes(target, g->material, p, variance, count, &g->columns);
      assert_true((shape.column[0] != nullptr) == (c->has_exponent || c->has_alpha));
      assert_true((shape.column[1] != nullptr) == c->has_exponent);
      for (size_t i = 0; i < count; ++i) check_shape(*c, i, shape);
      for (const float* column : g->columns.shape) {
        for (size_t i = data::padded(count); i < kBatch; ++i) assert_true(column[i] == -77.0f);
      }
    }
  });
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const BumpCase& c : k_bumps) tests[n++] = {c.name, test_bump, nullptr, nullptr, const_cast<BumpCase*>(&c)};
  tests[n++] = {"bump/formula", test_bump_formula, nullptr, nullptr, nullptr};
  tests[n++] = {"bump/degenerate", test_bump_degenerate, nullptr, nullptr, nullptr};
  for (const ShapeCase& c : k_shapes) tests[n++] = {c.name, test_shape, nullptr, nullptr, const_cast<ShapeCase*>(&c)};
  return _cmocka_run_group_tests("unit.shade.bumps", tests, n, set_up, tear_down);
}
