// SPDX-License-Identifier: MIT
// Dilation against a search of all texels.
#include "film/dilate.h"

#include "support/check.h"

#include "core/context.h"
#include "ref/bake_ref.h"
#include "support/random.h"

namespace shd::tests {
namespace {

core::Context* g_context;

int set_up(void**) {
  g_context = core::create_context(shd_context_desc_default());
  return 0;
}
int tear_down(void**) {
  core::release(*g_context);
  return 0;
}

struct dilate_case {
  const char* name;
  uint32_t width, height, radius;
  double density;  // part of the texels that are filled
};

constexpr dilate_case k_cases[] = {
    {"sparse", 41, 29, 6, 0.01},
    {"dense", 37, 23, 3, 0.4},
    {"empty", 9, 7, 5, 0.0},
    {"full", 9, 7, 5, 1.0},
    {"one_texel_radius", 31, 17, 1, 0.1},
    {"large_radius", 43, 19, 1000, 0.004},
    {"one_row", 83, 1, 9, 0.05},
    {"one_column", 1, 71, 9, 0.05},
    {"wide", 401, 5, 40, 0.01},
};

void test_dilate(void** state) {
  const auto& c = *static_cast<const dilate_case*>(*state);
  const size_t count = size_t{c.width} * c.height;
  Random random = {5};
  std::vector<uint8_t> texels(count);
  for (uint8_t& texel : texels) texel = random.unit() < c.density ? 1 + uint8_t(random.bits() % 2) : 0;
  const std::vector<uint8_t> before = texels;
  film::Framebuffer framebuffer{};
  shd_framebuffer_desc desc = shd_framebuffer_desc_default();
  desc.width = c.width;
  desc.height = c.height;
  desc.aovs = SHD_AOV_TRIANGLE;
  film::build(*g_context, desc, &framebuffer);
  for (size_t i = 0; i < count; ++i) {
    const size_t at = i / c.width * framebuffer.stride + i % c.width;
    framebuffer.plane[SHD_PLANE_G][at] = static_cast<float>(i);
    framebuffer.u32_plane[SHD_PLANE_TRIANGLE][at] = static_cast<uint32_t>(i);
  }
  film::dilate(*g_context, c.radius, texels.data(), &framebuffer);
  for (size_t i = 0; i < count; ++i) {
    const auto x = static_cast<int64_t>(i % c.width), y = static_cast<int64_t>(i / c.width);
    const int64_t from = before[i] ? -1 : ref::nearest_texel(before, c.width, x, y, c.radius);
    const size_t want = from < 0 ? i : static_cast<size_t>(from), at = i / c.width * framebuffer.stride + i % c.width;
    assert_int_equal(framebuffer.plane[SHD_PLANE_G][at], want);
    assert_int_equal(framebuffer.u32_plane[SHD_PLANE_TRIANGLE][at], want);
    assert_int_equal(texels[i], from < 0 ? before[i] : film::kTexelDilated);
  }
}

/// Interleaved pixels are copied whole.
void test_pixels(void**) {
  film::Framebuffer framebuffer{};
  shd_framebuffer_desc desc = shd_framebuffer_desc_default();
  desc.width = 5;
  desc.height = 1;
  desc.color_format = SHD_FORMAT_RGBA16F;
  film::build(*g_context, desc, &framebuffer);
  uint8_t texels[5] = {0, 1, 0, 0, 0};
  for (uint8_t i = 0; i < 8; ++i) film::pixel_at(&framebuffer, 1, 0)[i] = uint8_t(i + 1);
  film::dilate(*g_context, 2, texels, &framebuffer);
  const uint8_t states[5] = {3, 1, 3, 3, 0};
  assert_memory_equal(texels, states, 5);
  for (size_t x = 0; x < 5; ++x) {
    for (uint8_t i = 0; i < 8; ++i) assert_int_equal(film::pixel_at(&framebuffer, x, 0)[i], x < 4 ? i + 1 : 0);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[16];
  size_t n = 0;
  for (const dilate_case& c : k_cases)
    tests[n++] = {c.name, test_dilate, nullptr, nullptr, const_cast<dilate_case*>(&c)};
  tests[n++] = {"pixels", test_pixels, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.film.dilate", tests, n, set_up, tear_down);
}
