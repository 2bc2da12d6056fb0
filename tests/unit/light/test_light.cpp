// SPDX-License-Identifier: MIT
// Lights in the form that the shading kernels read.
#include "support/check.h"

#include "light/light.h"

namespace {

struct Case {
  const char* name;
  float direction[3];
  double to_light[3];
};

constexpr double kThird = 0.57735026918962576;
const Case kCases[] = {
    {"directional/down", {0, -1, 0}, {0, 1, 0}},
    {"directional/any_length", {0, 3, -4}, {0, -0.6, 0.8}},
    {"directional/flt_max", {3.4e38f, 3.4e38f, -3.4e38f}, {-kThird, -kThird, kThird}},
    {"directional/denormal", {0, 0, 1e-45f}, {0, 0, -1}},
    {"directional/1e-30", {1e-30f, 1e-30f, 1e-30f}, {-kThird, -kThird, -kThird}},
};

void test_directional(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  desc.position[1] = 9.0f;
  for (int i = 0; i < 3; ++i) desc.direction[i] = c.direction[i];
  const shd::light::Light light = shd::light::make_light(desc, nullptr, nullptr);
  for (size_t i = 0; i < 3; ++i) {
    shd_assert_close(c.name, i, static_cast<double>(light.to_light[i]), c.to_light[i], 1.5e-7, 0);
    if (c.to_light[i] == 0.0) assert_true(!signbit(light.to_light[i]));
    assert_true(light.position[i] == 0.0f);
  }
}

void test_other_kinds(void**) {
  for (int kind = SHD_LIGHT_KIND_POINT; kind <= SHD_LIGHT_KIND_AMBIENT; kind += 2) {
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = static_cast<shd_light_kind>(kind);
    for (int i = 0; i < 3; ++i) {
      desc.intensity[i] = static_cast<float>(i + 1);
      desc.position[i] = static_cast<float>(i - 5);
    }
    const shd::light::Light light = shd::light::make_light(desc, nullptr, nullptr);
    assert_int_equal(light.kind, kind);
    for (int i = 0; i < 3; ++i) {
      assert_true(light.intensity[i] == static_cast<float>(i + 1));
      assert_true(light.position[i] == (kind == SHD_LIGHT_KIND_POINT ? static_cast<float>(i - 5) : 0.0f));
      assert_true(light.to_light[i] == 0.0f);
    }
  }
}

}  // namespace

int main() {
  static CMUnitTest tests[8];
  size_t n = 0;
  for (const Case& c : kCases) tests[n++] = {c.name, test_directional, nullptr, nullptr, const_cast<Case*>(&c)};
  tests[n++] = {"point_and_ambient", test_other_kinds, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.light.light", tests, n, nullptr, nullptr);
}
