// SPDX-License-Identifier: MIT
// Lights that reach a batch against brute force; culling changes no bit; tables of lights.
#include "unit/shade/lobe_fixture.h"

#include "shade/cull.h"
#include "shade/light_table.h"

namespace shd::tests {
namespace {

constexpr size_t kLights = 150;

struct Lights {
  light::Light light[kLights];
  const light::Light* pointer[kLights];
  shade::LightTable table;
  shade::ActiveLight active[kLights];
  uint32_t index[256];
};
Lights* g_lights;

void make_table(size_t count) {
  for (size_t i = 0; i < count; ++i) g_lights->pointer[i] = &g_lights->light[i];
  g_lights->table = shade::make_light_table(g_allocator, g_lights->pointer, count);
}

struct CullCase {
  const char* name;
  double low, high;  // log2 of ranges
  double spread;     // spread of the lights around the points
  double offset;     // offset of everything from the origin
  int unlimited;     // every `unlimited`-th light has no range; 0 = all lights have one
};
const CullCase k_culls[] = {
    {"cull/some", 0, 2, 6, 0, 0},
    {"cull/all_reach", 6, 7, 1, 0, 0},
    {"cull/none_reach", -6, -4, 100, 0, 0},
    {"cull/without_range", 0, 2, 6, 0, 3},
    {"cull/far_from_origin", 0, 2, 6, 1e5, 0},
    {"cull/tiny", -70, -60, 1e-19, 0, 0},
    {"cull/huge", 60, 66, 3e19, 0, 0},
};

void random_case(Random* random, const CullCase& c, size_t count, size_t points) {
  for (size_t i = 0; i < count; ++i) {
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = i % 4 == 1 ? SHD_LIGHT_KIND_SPOT : i % 16 == 7 ? SHD_LIGHT_KIND_DIRECTIONAL : SHD_LIGHT_KIND_POINT;
    desc.outer_angle = 1.5f;
    for (float& x : desc.position) x = static_cast<float>(c.offset + random->in(-c.spread, c.spread));
    for (float& x : desc.direction) x = random->real(-1, 1);
    const bool is_unlimited = c.unlimited && static_cast<int>(i) % c.unlimited == 0;
    desc.range = is_unlimited ? 0.0f : static_cast<float>(std::exp2(random->in(c.low, c.high)));
    g_lights->light[i] = light::make_light(desc, nullptr, nullptr);
  }
  make_table(count);
  const double size = std::exp2(c.low);
  g->points.count = points;
  for (size_t i = 0; i < data::padded(points); ++i) {
    const size_t row = std::min(i, points - 1);
    Random own = {1000 + row};
    set_point(i, {c.offset + own.in(-size, size), c.offset + own.in(-size, size), c.offset + own.in(-size, size)},
              random_unit(&own), random_unit(&own));
  }
}

void illuminate(const core::SimdTarget& target, const uint32_t* index, size_t count, material::Lobes* out) {
  for (size_t k = 0; k < count; ++k) {
    g_lights->active[k] = {&g_lights->table.lights[index ? index[k] : k], {nullptr, nullptr, nullptr}};
  }
  shade::illuminate(target, g->material, {}, g_lights->active, count, g->points, {false, true}, out);
}

/// Indices are in order and unique, every light that reaches a row is kept, and culling does not change the bits.
void test_cull(void** state) {
  const auto* c = static_cast<const CullCase*>(*state);
  Random random = {141};
  set_material({"", SHD_MODEL_BLINN_PHONG, 0, 8, 0.5f});
  for (size_t count : {size_t{1}, size_t{3}, size_t{17}, size_t{64}, kLights}) {
    for (size_t points : {size_t{1}, size_t{5}, size_t{65}, size_t{500}}) {
      random_case(&random, *c, count, points);
      for_each_target([&](const core::SimdTarget& target, bool) {
        const size_t kept = shade::cull_lights(target, g_lights->table, g->points, g_lights->index);
        assert_true(kept <= count);
        for (size_t k = 1; k < kept; ++k) assert_true(g_lights->index[k] > g_lights->index[k - 1]);
        illuminate(target, nullptr, count, &g->first.lobes);
        illuminate(target, g_lights->index, kept, &g->columns.lobes);
        for (int k = 0; k < 6; ++k) {
          assert_memory_equal(g->columns.lobes.lobe[k / 3][k % 3], g->first.lobes.lobe[k / 3][k % 3],
                              points * sizeof(float));
        }
        for (size_t i = 0, k = 0; i < count; ++i) {
          if (k < kept && g_lights->index[k] == i) {
            ++k;
            continue;
          }
          const light::Light& light = g_lights->table.lights[i];
          assert_true(light.range > 0.0f);
          for (size_t row = 0; row < points; ++row) {
            const Vector p = row_vector(g->points.px, g->points.py, g->points.pz, row);
            assert_true(ref::length(ref::vector(light.position) - p) >= static_cast<long double>(light.range));
          }
        }
      });
    }
  }
}

/// For single rows, all kept lights reach the row, or nearly: culling is worth its time.
void test_sharpness(void**) {
  Random random = {142};
  for (int n = 0; n < 200; ++n) {
    random_case(&random, k_culls[0], kLights, 1);
    const size_t kept = shade::cull_lights(best_target(), g_lights->table, g->points, g_lights->index);
    for (size_t k = 0; k < kept; ++k) {
      const light::Light& light = g_lights->table.lights[g_lights->index[k]];
      if (light.range == 0.0f) continue;
      const Vector p = row_vector(g->points.px, g->points.py, g->points.pz, 0);
      assert_true(ref::length(ref::vector(light.position) - p) <= 1.001L * static_cast<long double>(light.range));
    }
  }
}

/// Non-finite rows are ignored; without finite rows only lights without a range are kept.
void test_nonfinite(void**) {
  Random random = {143};
  const float bad[] = {NAN, INFINITY, -INFINITY};
  for (size_t finite : {size_t{0}, size_t{1}, size_t{40}}) {
    random_case(&random, k_culls[3], kLights, 64);
    for (size_t i = finite; i < 64; ++i) {
      g->points.px[i] = bad[i % 3], g->points.py[i] = bad[i / 3 % 3], g->points.pz[i] = bad[i % 3];
    }
    set_material({"", SHD_MODEL_LAMBERT, 0, 8, 0.5f});
    for_each_target([&](const core::SimdTarget& target, bool) {
      const size_t kept = shade::cull_lights(target, g_lights->table, g->points, g_lights->index);
      illuminate(target, nullptr, kLights, &g->first.lobes);
      illuminate(target, g_lights->index, kept, &g->columns.lobes);
      assert_memory_equal(g->columns.lobes.lobe[0][0], g->first.lobes.lobe[0][0], 64 * sizeof(float));
      if (finite == 0) {
        for (size_t k = 0; k < kept; ++k) assert_true(g_lights->table.lights[g_lights->index[k]].range == 0.0f);
      }
    });
  }
}

/// Ambient lights are summed separately, the other lights keep their order; positions and squared ranges are correct.
void test_table(void**) {
  for (size_t count : {size_t{0}, size_t{1}, size_t{65}, kLights}) {
    size_t others = 0;
    double ambient = 0.0;
    bool any = false;
    for (size_t i = 0; i < count; ++i) {
      shd_light_desc desc = shd_light_desc_default();
      desc.kind = static_cast<shd_light_kind>(i % 4);
      desc.intensity[0] = static_cast<float>(i);
      desc.position[1] = static_cast<float>(2 * i);
      desc.range = i % 3 ? static_cast<float>(i) : 0.0f;
      g_lights->light[i] = light::make_light(desc, nullptr, nullptr);
      any |= g_lights->light[i].range > 0.0f;
      desc.kind == SHD_LIGHT_KIND_AMBIENT ? ambient += static_cast<double>(i) : ++others;
    }
    make_table(count);
    const shade::LightTable& table = g_lights->table;
    assert_int_equal(table.count, others);
    assert_true(double{table.ambient[0]} == ambient && table.any_range == any);
    for (size_t i = 0, k = 0; i < count; ++i) {
      if (g_lights->light[i].kind == SHD_LIGHT_KIND_AMBIENT) continue;
      assert_true(table.lights[k].intensity[0] == static_cast<float>(i));
      assert_true(table.y[k] == g_lights->light[i].position[1]);
      const double range = g_lights->light[i].range;
      assert_true(range > 0.0 ? table.max_squared_distance[k] > range * range &&
                                    table.max_squared_distance[k] < 1.001 * range * range
                              : std::isinf(table.max_squared_distance[k]));
      ++k;
    }
  }
}

int set_up_lights(void** state) {
  g_lights = new Lights;
  return set_up(state);
}
int tear_down_lights(void** state) {
  delete g_lights;
  return tear_down(state);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[16];
  size_t n = 0;
  for (const CullCase& c : k_culls) tests[n++] = {c.name, test_cull, nullptr, nullptr, const_cast<CullCase*>(&c)};
  tests[n++] = {"sharpness", test_sharpness, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite", test_nonfinite, nullptr, nullptr, nullptr};
  tests[n++] = {"table", test_table, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.cull", tests, n, set_up_lights, tear_down_lights);
}
