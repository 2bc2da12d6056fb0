// SPDX-License-Identifier: MIT
// Shadow lookups on maps of known depths: every filter and projection against the oracle, equal bits on every target
// and for any split, tails, and points that are non-finite or off the map.
#include "support/check.h"

#include <algorithm>
#include <cfloat>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/context.h"
#include "light/shadow.h"
#include "ref/shadow_ref.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using light::ShadowProjection;

constexpr size_t kPoints = 1500;
constexpr double kPi = 3.14159265358979323846;

struct Case {
  const char* name;
  shd_shadow_filter filter;
  ShadowProjection projection;
  uint32_t size, taps;
  float filter_size, light_size, bleed, min_variance;
};
const Case k_cases[] = {
    {"hard/orthographic", SHD_SHADOW_FILTER_HARD, ShadowProjection::kOrthographic, 64, 3, 0, 0, 0, 0},
    {"hard/perspective", SHD_SHADOW_FILTER_HARD, ShadowProjection::kPerspective, 16, 1, 0, 0, 0, 0},
    {"hard/cube", SHD_SHADOW_FILTER_HARD, ShadowProjection::kCube, 33, 1, 0, 0, 0, 0},
    {"pcf/1x1", SHD_SHADOW_FILTER_PCF, ShadowProjection::kOrthographic, 64, 1, 0, 0, 0, 0},
    {"pcf/2x2", SHD_SHADOW_FILTER_PCF, ShadowProjection::kPerspective, 40, 2, 0, 0, 0, 0},
    {"pcf/3x3", SHD_SHADOW_FILTER_PCF, ShadowProjection::kOrthographic, 64, 3, 0, 0, 0, 0},
    {"pcf/3x3/cube", SHD_SHADOW_FILTER_PCF, ShadowProjection::kCube, 32, 3, 0, 0, 0, 0},
    {"pcf/15x15/of_16", SHD_SHADOW_FILTER_PCF, ShadowProjection::kPerspective, 16, 15, 0, 0, 0, 0},
    {"variance/1x1", SHD_SHADOW_FILTER_VARIANCE, ShadowProjection::kOrthographic, 64, 1, 0, 0, 0, 0.01f},
    {"variance/4x4", SHD_SHADOW_FILTER_VARIANCE, ShadowProjection::kCube, 32, 4, 0, 0, 0, 0},
    {"variance/5x5/bleed", SHD_SHADOW_FILTER_VARIANCE, ShadowProjection::kPerspective, 64, 5, 0, 0, 0.3f, 0.001f},
    {"summed_area/0", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, ShadowProjection::kOrthographic, 64, 3, 0, 0, 0, 0.01f},
    {"summed_area/wide", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, ShadowProjection::kPerspective, 64, 3, 0.7f, 0, 0.2f,
     0},
    {"summed_area/cube", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, ShadowProjection::kCube, 48, 3, 1.0f, 0, 0, 0},
    {"summed_area/huge", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, ShadowProjection::kOrthographic, 50, 3, 1e9f, 0, 0, 0},
    {"pcss/0", SHD_SHADOW_FILTER_PCSS, ShadowProjection::kOrthographic, 64, 3, 0, 0, 0, 0},
    {"pcss/perspective", SHD_SHADOW_FILTER_PCSS, ShadowProjection::kPerspective, 64, 4, 0, 0.5f, 0, 0},
    {"pcss/cube", SHD_SHADOW_FILTER_PCSS, ShadowProjection::kCube, 40, 3, 0, 1.0f, 0, 0},
    {"pcss/huge", SHD_SHADOW_FILTER_PCSS, ShadowProjection::kOrthographic, 64, 5, 0, 1e9f, 0, 0},
};

struct Fixture {
  core::Context* context;
  light::Shadow shadow;
  std::vector<float> depths;     // [face][size][size]
  std::vector<float> points[6];  // position and normal
  std::vector<float> first, got;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  const shd_context_desc desc = shd_context_desc_default();
  g->context = core::create_context(desc);
  return 0;
}
int tear_down(void**) {
  g->shadow = {};
  core::release(*g->context);
  delete g;
  return 0;
}

light::ShadowPlacement make_placement(const Case& c) {
  light::ShadowPlacement placement = {};
  placement.projection = c.projection;
  placement.face_count = c.projection == ShadowProjection::kCube ? 6 : 1;
  // Right-handed axes that are not aligned with the world.
  placement.axes = {{0.8f, 0, -0.6f}, {-0.36f, 0.8f, -0.48f}, {0.48f, 0.6f, 0.64f}};
  placement.origin[0] = 0.3f;
  placement.origin[1] = -0.2f;
  placement.origin[2] = 0.7f;
  placement.near = c.projection == ShadowProjection::kOrthographic ? -3.0f : 0.5f;
  placement.far = c.projection == ShadowProjection::kOrthographic ? 3.0f : 6.0f;
  const float part = c.projection == ShadowProjection::kOrthographic ? 0.125f : 0.375f;
  placement.scale = part * static_cast<float>(c.size);
  placement.guard = 1e-5f;
  placement.guard_square = c.projection == ShadowProjection::kOrthographic ? 0.0f : 2e-6f;
  return placement;
}

/// Makes a map with depths in steps, and holes.
void make_shadow(const Case& c) {
  light::Shadow& shadow = g->shadow;
  shadow.options = {c.size, c.filter, c.taps, SHD_CULL_NONE, c.filter_size, c.light_size,
                    0.01f,  0.1f,     0.02f,  c.bleed,       c.min_variance};
  const light::ShadowPlacement placement = make_placement(c);
  allocate(g->context->allocator, shadow.options, placement, &shadow.map);
  const size_t size = c.size;
  g->depths.assign(size * size * placement.face_count, 0.0f);
  Random random = {7};
  for (size_t i = 0; i < g->depths.size(); ++i) {
    const size_t face = i / (size * size), y = i / size % size, x = i % size;
    const bool is_step = (x / 5 + y / 7) % 2 != 0;
    float depth = is_step ? random.real(0.2, 0.5) : random.real(0.6, 0.7);
    depth = placement.near + depth * (placement.far - placement.near);
    if ((x / 9 + y / 4) % 5 == 0) depth = INFINITY;
    g->depths[i] = depth;
    shadow.map.depth[face * shadow.map.face_stride + (y + shadow.map.pad) * shadow.map.pitch + x + shadow.map.pad] =
        depth;
  }
  build_tables(*g->context, g->context->allocator, shadow.options, &shadow.map);
  shadow.is_rendered = true;
}

/// Makes points on the map and around it, most at depths of the map.
void make_points() {
  Random random = {42};
  const light::ShadowPlacement& placement = g->shadow.map.placement;
  for (std::vector<float>& column : g->points) column.assign(kPoints, 0.0f);
  for (size_t i = 0; i < kPoints; ++i) {
    const double size = g->shadow.options.size;
    light::ShadowAxes axes = placement.axes;
    if (placement.projection == ShadowProjection::kCube) axes = light::cube_axes(static_cast<uint32_t>(i % 6));
    const double z =
        random.in(i % 9 ? static_cast<double>(placement.near) : -7.0, 1.2 * static_cast<double>(placement.far));
    const double w = placement.projection == ShadowProjection::kOrthographic ? 1.0 : z;
    const double a = w * random.in(-0.55, 0.55) * size / static_cast<double>(placement.scale);
    const double b = w * random.in(-0.55, 0.55) * size / static_cast<double>(placement.scale);
    double n[3] = {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)}, length = 0;
    for (int k = 0; k < 3; ++k) length += n[k] * n[k];
    for (size_t k = 0; k < 3; ++k) {
      g->points[k][i] =
          static_cast<float>(static_cast<double>(placement.origin[k]) + a * static_cast<double>(axes.right[k]) +
                             b * static_cast<double>(axes.down[k]) + z * static_cast<double>(axes.forward[k]));
      g->points[3 + k][i] = static_cast<float>(n[k] / std::sqrt(length));
    }
  }
}

light::ShadowLookups lookups(size_t first, size_t count, bool has_normals) {
  light::ShadowLookups in = {count, {}, {}};
  for (size_t k = 0; k < 3; ++k) {
    in.position[k] = g->points[k].data() + first;
    if (has_normals) in.normal[k] = g->points[3 + k].data() + first;
  }
  return in;
}

/// Whether `got` lies within the range of the oracle for positions and depths within their rounding.
bool is_near(const ref::ShadowRef& oracle, ref::ShadowPoint p, double got) {
  double low = INFINITY, high = -INFINITY;
  const double shift = 4e-6 * oracle.options.size, rise = 2e-5;
  for (int i = 0; i < 27; ++i) {
    ref::ShadowPoint q = p;
    q.x = std::min(std::max(p.x + (i % 3 - 1) * shift, 0.0), double(oracle.options.size));
    q.y = std::min(std::max(p.y + (i / 3 % 3 - 1) * shift, 0.0), double(oracle.options.size));
    q.z += (i / 9 - 1) * (rise + 4e-6 * (std::fabs(p.dx) + std::fabs(p.dy)) * oracle.options.size);
    const double value = oracle.visibility(q);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return got >= low - 1e-3 && got <= high + 1e-3;
}

void test_oracle(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  make_shadow(c);
  make_points();
  const ref::ShadowRef oracle = {g->shadow.options, g->shadow.map.placement, g->depths};
  for (const bool has_normals : {false, true}) {
    size_t shadowed = 0, partial = 0;
    g->got.assign(kPoints, -1.0f);
    light::sample_shadow(best_target(), g->shadow, lookups(0, kPoints, has_normals), g->got.data());
    for (size_t i = 0; i < kPoints; ++i) {
      const float p[3] = {g->points[0][i], g->points[1][i], g->points[2][i]};
      const float n[3] = {g->points[3][i], g->points[4][i], g->points[5][i]};
      const ref::ShadowPoint point = oracle.locate(p, has_normals ? n : nullptr);
      const auto got = static_cast<double>(g->got[i]);
      if (!(got >= 0.0 && got <= 1.0)) fail_msg("%s[%zu]: %g is not in 0..1", c.name, i, got);
      shadowed += got < 0.5;
      partial += got > 0.0 && got < 1.0;
      if (!is_near(oracle, point, got)) {
        fail_msg("%s[%zu]: got %g, want %g", c.name, i, got, oracle.visibility(point));
      }
    }
    if (shadowed < kPoints / 20) fail_msg("%s: only %zu points in shadow", c.name, shadowed);
    if (c.filter == SHD_SHADOW_FILTER_HARD) assert_int_equal(partial, 0);
  }
}

void test_targets(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  make_shadow(c);
  make_points();
  for (const bool has_normals : {false, true}) {
    for_each_target([&](const core::SimdTarget& target, bool first) {
      g->got.assign(kPoints, -1.0f);
      light::sample_shadow(target, g->shadow, lookups(0, kPoints, has_normals), g->got.data());
      if (first) g->first = g->got;
      if (std::memcmp(g->first.data(), g->got.data(), kPoints * sizeof(float))) {
        fail_msg("%s: other bits on %s", c.name, target.name);
      }
      // Pieces of every length; the values after each piece must not change.
      for (size_t begin = 0, count = 0; count < 36; begin += count++) {
        g->got.assign(kPoints, -7.0f);
        light::sample_shadow(target, g->shadow, lookups(begin, count, has_normals), g->got.data());
        if (std::memcmp(g->first.data() + begin, g->got.data(), count * sizeof(float)) || g->got[count] != -7.0f) {
          fail_msg("%s: %zu points differ on %s", c.name, count, target.name);
        }
      }
    });
  }
}

/// Non-finite and large numbers in every column: the result is lit or a number in 0..1, and other points keep their
/// bits.
void test_bad_points(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  const float k_bad[] = {NAN, -NAN, INFINITY, -INFINITY, FLT_MAX, -FLT_MAX, 1e30f, FLT_TRUE_MIN, 0.0f};
  make_shadow(c);
  make_points();
  for_each_target([&](const core::SimdTarget& target, bool) {
    make_points();
    g->first.assign(kPoints, -1.0f);
    light::sample_shadow(target, g->shadow, lookups(0, kPoints, true), g->first.data());
    for (size_t column = 0; column < 6; ++column) {
      for (const float bad : k_bad) {
        make_points();
        for (size_t i = 3; i < 100; i += 7) g->points[column][i] = bad;
        g->got.assign(kPoints, -1.0f);
        light::sample_shadow(target, g->shadow, lookups(0, 100, true), g->got.data());
        for (size_t i = 0; i < 100; ++i) {
          const float got = g->got[i];
          const bool is_bad = i % 7 == 3;
          const bool is_fine = is_bad ? (got >= 0.0f && got <= 1.0f) : got == g->first[i];
          if (!is_fine || (is_bad && column < 3 && !std::isfinite(bad) && got != 1.0f)) {
            fail_msg("%s: %g in column %zu, row %zu: %g on %s", c.name, static_cast<double>(bad), column, i,
                     static_cast<double>(got), target.name);
          }
        }
      }
    }
  });
}

/// With an empty map all points are lit, exactly. With a map in front of everything all values are those of the oracle;
/// away from the edges of the map, HARD and PCF are 0 exactly.
void test_uniform(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  for (const bool is_full : {false, true}) {
    make_shadow(c);
    light::ShadowMap& map = g->shadow.map;
    allocate(g->context->allocator, g->shadow.options, make_placement(c), &map);
    for (uint32_t row = 0; is_full && row < map.placement.face_count * c.size; ++row) {
      const size_t first = row / c.size * map.face_stride + (row % c.size + map.pad) * map.pitch + map.pad;
      std::fill_n(map.depth.begin() + first, c.size, map.placement.near);
    }
    build_tables(*g->context, g->context->allocator, g->shadow.options, &map);
    make_points();
    g->depths.assign(g->depths.size(), is_full ? map.placement.near : INFINITY);
    const ref::ShadowRef oracle = {g->shadow.options, map.placement, g->depths};
    g->got.assign(kPoints, -1.0f);
    light::sample_shadow(best_target(), g->shadow, lookups(0, kPoints, true), g->got.data());
    const double size = c.size, reach = c.taps / 2 + 2.0;
    for (size_t i = 0; i < kPoints; ++i) {
      const float p[3] = {g->points[0][i], g->points[1][i], g->points[2][i]};
      const float n[3] = {g->points[3][i], g->points[4][i], g->points[5][i]};
      const ref::ShadowPoint at = oracle.locate(p, n);
      if (!is_full) {
        if (g->got[i] != 1.0f) fail_msg("%s[%zu]: %g", c.name, i, static_cast<double>(g->got[i]));
        continue;
      }
      if (!is_near(oracle, at, static_cast<double>(g->got[i]))) {
        fail_msg("%s[%zu]: %g, want %g", c.name, i, static_cast<double>(g->got[i]), oracle.visibility(at));
      }
      if (c.filter != SHD_SHADOW_FILTER_HARD && c.filter != SHD_SHADOW_FILTER_PCF) continue;
      if (!at.inside || at.x < reach || at.y < reach || at.x > size - reach || at.y > size - reach) continue;
      const double slope = std::fabs(at.dx) + std::fabs(at.dy);
      if (at.z - slope * reach < static_cast<double>(map.placement.near) + 0.01) continue;
      if (g->got[i] != 0.0f) fail_msg("%s[%zu]: %g", c.name, i, static_cast<double>(g->got[i]));
    }
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static CMUnitTest tests[4 * sizeof k_cases / sizeof k_cases[0]];
  static char names[4 * sizeof k_cases / sizeof k_cases[0]][64];
  const struct {
    const char* name;
    void (*run)(void**);
  } k_tests[] = {
      {"oracle", test_oracle}, {"targets", test_targets}, {"bad_points", test_bad_points}, {"uniform", test_uniform}};
  size_t n = 0;
  for (const auto& test : k_tests) {
    for (const Case& c : k_cases) {
      std::snprintf(names[n], sizeof names[n], "%s/%s", test.name, c.name);
      tests[n] = {names[n], test.run, nullptr, nullptr, const_cast<Case*>(&c)};
      ++n;
    }
  }
  return _cmocka_run_group_tests("unit.light.shadow", tests, n, set_up, tear_down);
}
