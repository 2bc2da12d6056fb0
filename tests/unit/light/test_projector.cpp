// SPDX-License-Identifier: MIT
// Axes and cones of lights, and the coordinates of points in cookies, against geometry in long double.
#include "support/check.h"

#include <algorithm>

#include "data/data.h"
#include "light/projector.h"
#include "ref/shade_ref.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using ref::Vector;

constexpr size_t kPoints = 512;
constexpr float kPi = 3.14159265f;

texture::Texture g_texture = {};
texture::Sampler g_sampler = {};
alignas(64) float g_p[3][kPoints], g_u[kPoints], g_v[kPoints], g_first[2][kPoints];

struct AxesCase {
  const char* name;
  float direction[3], up[3];
};
const AxesCase k_axes[] = {
    {"axes/default", {0, -1, 0}, {0, 1, 0}},
    {"axes/forward", {0, 0, -1}, {0, 1, 0}},
    {"axes/oblique", {1, -2, 0.5f}, {0.1f, 1, 0.3f}},
    {"axes/up_along_x", {1, 0, 0}, {1, 0, 0}},
    {"axes/up_against", {0, 0, 3}, {0, 0, -2}},
    {"axes/nearly_along", {0, -1, 0}, {1e-3f, 1, 0}},
    {"axes/as_good_as_along", {0, -1, 0}, {1e-6f, 1, 0}},
    {"axes/huge", {3e38f, 3e38f, 3e38f}, {0, 3e38f, 0}},
    {"axes/denormal", {1e-44f, 0, 0}, {0, 1e-44f, 0}},
};

void check_dot(const char* what, const float* a, const float* b, double want) {
  shd_assert_close(what, 0, static_cast<double>(ref::dot(ref::vector(a), ref::vector(b))), want, 4e-7, 0);
}

/// Axes are unit, perpendicular, right-handed; up is the requested vector orthogonalised against the direction.
void test_axes(void** state) {
  const auto* c = static_cast<const AxesCase*>(*state);
  for (shd_light_kind kind : {SHD_LIGHT_KIND_DIRECTIONAL, SHD_LIGHT_KIND_SPOT}) {
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = kind;
    std::copy_n(c->direction, 3, desc.direction);
    std::copy_n(c->up, 3, desc.up);
    const light::Light light = light::make_light(desc, nullptr, nullptr);
    check_dot("length", light.to_light, light.to_light, 1);
    check_dot("length", light.right, light.right, 1);
    check_dot("length", light.up, light.up, 1);
    check_dot("right angle", light.to_light, light.right, 0);
    check_dot("right angle", light.to_light, light.up, 0);
    check_dot("right angle", light.right, light.up, 0);
    const Vector back = ref::vector(light.to_light), right = ref::cross(ref::vector(light.up), back);
    assert_true(ref::length(right - ref::vector(light.right)) < 1e-6L);
    const Vector way = ref::unit(ref::vector(c->direction)), wanted = ref::unit(ref::vector(c->up));
    assert_true(ref::length(way + back) < 1e-6L);
    const Vector across = wanted - ref::dot(wanted, way) * way;
    const long double size = ref::length(across);
    if (size > 2e-4L) assert_true(ref::length(1 / size * across - ref::vector(light.up)) < 1e-6L / size);
  }
}

struct CookieCase {
  const char* name;
  shd_light_kind kind;
  float angle;      // spots
  float extent[2];  // directional lights
};
const CookieCase k_cookies[] = {
    {"cookie/spot/45", SHD_LIGHT_KIND_SPOT, kPi / 4, {1, 1}},
    {"cookie/spot/1", SHD_LIGHT_KIND_SPOT, kPi / 180, {1, 1}},
    {"cookie/spot/0.001", SHD_LIGHT_KIND_SPOT, 0.001f, {1, 1}},
    {"cookie/spot/1.55", SHD_LIGHT_KIND_SPOT, 1.55f, {1, 1}},
    {"cookie/directional", SHD_LIGHT_KIND_DIRECTIONAL, 1, {1, 1}},
    {"cookie/directional/4x3", SHD_LIGHT_KIND_DIRECTIONAL, 1, {4, 3}},
    {"cookie/directional/1e3x1e-3", SHD_LIGHT_KIND_DIRECTIONAL, 1, {1e3f, 1e-3f}},
};

light::Light cookie_light(const CookieCase& c, const float position[3], const float direction[3]) {
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = c.kind;
  desc.outer_angle = c.angle;
  std::copy_n(c.extent, 2, desc.extent);
  std::copy_n(position, 3, desc.position);
  std::copy_n(direction, 3, desc.direction);
  return light::make_light(desc, &g_texture, &g_sampler);
}

/// Projects on every target, for any number of points; the bits agree, and nothing past the last whole vector is
/// written.
void project_everywhere(const light::Light& light) {
  const float* const p[3] = {g_p[0], g_p[1], g_p[2]};
  for_each_target([&](const core::SimdTarget& target, bool first) {
    light::project(target, light, kPoints, p, g_u, g_v);
    if (first) std::copy_n(g_u, kPoints, g_first[0]), std::copy_n(g_v, kPoints, g_first[1]);
    assert_memory_equal(g_u, g_first[0], sizeof g_u);
    assert_memory_equal(g_v, g_first[1], sizeof g_v);
    for (size_t count = 0; count <= 2 * 64 + 3; count += count < 70 ? 1 : 20) {
      std::fill_n(g_u, kPoints, -77.0f);
      light::project(target, light, count, p, g_u, g_v);
      assert_memory_equal(g_u, g_first[0], count * sizeof(float));
      for (size_t i = data::padded(count); i < kPoints; ++i) assert_true(g_u[i] == -77.0f);
    }
  });
}

void set_point(size_t i, const Vector& p) {
  g_p[0][i] = static_cast<float>(p.x), g_p[1][i] = static_cast<float>(p.y), g_p[2][i] = static_cast<float>(p.z);
}

Vector row_point(size_t i) {
  const float p[3] = {g_p[0][i], g_p[1][i], g_p[2][i]};
  return ref::vector(p);
}

/// Points at known positions in the cookie; the first four are its corners, from the top left on; every eighth point is
/// behind it.
void test_cookie(void** state) {
  const auto* c = static_cast<const CookieCase*>(*state);
  Random random = {131};
  const float position[3] = {0.5f, -1.25f, 2.0f}, direction[3] = {1.0f, -2.0f, 0.5f};
  const light::Light light = cookie_light(*c, position, direction);
  const bool spot = c->kind == SHD_LIGHT_KIND_SPOT;
  const Vector back = ref::vector(light.to_light), right = ref::vector(light.right), up = ref::vector(light.up);
  static double want[2][kPoints];
  for (size_t i = 0; i < kPoints; ++i) {
    const double u = i < 4 ? static_cast<double>(i % 2) : random.in(-0.5, 1.5);
    const double v = i < 4 ? static_cast<double>(i / 2) : random.in(-0.5, 1.5);
    const bool is_behind = i % 8 == 7;
    const double distance = (is_behind ? -1.0 : 1.0) * std::exp2(random.in(-1.0, 6.0));
    const long double half_x = spot ? distance * tanl(c->angle) : 0.5L * c->extent[0];
    const long double half_y = spot ? distance * tanl(c->angle) : 0.5L * c->extent[1];
    const Vector in_cookie =
        half_x * static_cast<long double>(2 * u - 1) * right + half_y * static_cast<long double>(1 - 2 * v) * up;
    set_point(i, ref::vector(position) - static_cast<long double>(distance) * back + in_cookie);
    want[0][i] = is_behind && spot ? -1.0 : u;
    want[1][i] = is_behind && spot ? -1.0 : v;
  }
  project_everywhere(light);
  for (size_t i = 0; i < kPoints; ++i) {
    // The points themselves are rounded to float; the error is in units of the cookie.
    const double size = fabs(double{g_p[0][i]}) + fabs(double{g_p[1][i]}) + fabs(double{g_p[2][i]}) + 4.0;
    const double along = static_cast<double>(fabsl(ref::dot(row_point(i) - ref::vector(position), back)));
    const double scale_x = spot ? double{light.cookie_scale[0]} / along : double{light.cookie_scale[0]};
    const double scale_y = spot ? double{light.cookie_scale[1]} / along : double{light.cookie_scale[1]};
    const double aside_u = spot ? fabs(want[0][i] - 0.5) / along : 0.0,
                 aside_v = spot ? fabs(want[1][i] - 0.5) / along : 0.0;
    shd_assert_close("u", i, g_first[0][i], want[0][i], 1e-6 + 2e-7 * size * (scale_x + aside_u), 0.0);
    shd_assert_close("v", i, g_first[1][i], want[1][i], 1e-6 + 2e-7 * size * (scale_y + aside_v), 0.0);
  }
}

/// Points that are non-finite, at the light, or out of range have coordinates (-1, -1), or finite ones.
void test_nonfinite(void** state) {
  const auto* c = static_cast<const CookieCase*>(*state);
  const float odd[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 0.0f};
  const float position[3] = {0, 0, 0}, direction[3] = {0, 0, -1};
  const light::Light light = cookie_light(*c, position, direction);
  for (size_t i = 0; i < kPoints; ++i) set_point(i, {odd[i % 6], odd[i / 6 % 6], odd[i / 36 % 6]});
  project_everywhere(light);
  for (size_t i = 0; i < kPoints; ++i) {
    assert_true(std::isfinite(g_first[0][i]) && std::isfinite(g_first[1][i]));
    const bool nan = std::isnan(g_p[0][i]) || std::isnan(g_p[1][i]) || std::isnan(g_p[2][i]);
    if (nan) assert_true(g_first[0][i] == -1.0f && g_first[1][i] == -1.0f);
  }
}

struct ConeCase {
  const char* name;
  float inner, outer;
};
const ConeCase k_cones[] = {
    {"cone/default", 0, kPi / 4},    {"cone/narrow", 0.1f, 0.11f}, {"cone/narrowest", 0, 0.001f},
    {"cone/hard", kPi / 4, kPi / 4}, {"cone/half", 0.2f, kPi / 2}, {"cone/hard_half", kPi / 2, kPi / 2},
};

/// t = scale (cos a - start) is 0 at the outer and 1 at the inner angle.
void test_cone(void** state) {
  const auto* c = static_cast<const ConeCase*>(*state);
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_KIND_SPOT;
  desc.inner_angle = c->inner;
  desc.outer_angle = c->outer;
  desc.range = 5.0f;
  const light::Light light = light::make_light(desc, nullptr, nullptr);
  const double scale = light.cone_scale, start = light.cone_start;
  assert_true(std::isfinite(scale) && scale > 0.0);
  shd_assert_close("outer", 0, start, cos(double{c->outer}), 6e-8, 0.0);
  if (c->inner < c->outer) shd_assert_close("inner", 0, scale * (cos(double{c->inner}) - start), 1.0, 1e-6, 0.0);
  shd_assert_close("tangent", 0, light.outer_tangent, tan(std::min(double{c->outer}, 1.57)), 0.0, 1e-6);
  shd_assert_close("range", 0, light.inverse_range_squared, 0.04, 0.0, 1e-7);
  assert_true(light.range == 5.0f && light.cookie == nullptr);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static char names[32][64];
  CMUnitTest tests[64];
  size_t n = 0, m = 0;
  for (const AxesCase& c : k_axes) tests[n++] = {c.name, test_axes, nullptr, nullptr, const_cast<AxesCase*>(&c)};
  for (const CookieCase& c : k_cookies) {
    tests[n++] = {c.name, test_cookie, nullptr, nullptr, const_cast<CookieCase*>(&c)};
    snprintf(names[m], sizeof names[0], "nonfinite/%s", c.name);
    tests[n++] = {names[m++], test_nonfinite, nullptr, nullptr, const_cast<CookieCase*>(&c)};
  }
  for (const ConeCase& c : k_cones) tests[n++] = {c.name, test_cone, nullptr, nullptr, const_cast<ConeCase*>(&c)};
  return _cmocka_run_group_tests("unit.light.projector", tests, n, nullptr, nullptr);
}
