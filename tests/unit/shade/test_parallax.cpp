// SPDX-License-Identifier: MIT
// Intersections of lines of sight with height fields of known shape.
#include "unit/shade/slot_fixture.h"

#include "shade/parallax.h"

namespace shd::tests {
namespace {

constexpr uint32_t kWidth = 256;
constexpr double kDepth = 0.2, kScale[2] = {2.0, 0.5};  // world units per unit of u and v

/// Height of a texel in column i.
using Field = double (*)(uint32_t i);

texture::Texture* height_texture(Field field, uint32_t width) {
  static float texels[kWidth];
  for (uint32_t i = 0; i < width; ++i) texels[i] = static_cast<float>(field(i));
  return make_texture(SHD_FORMAT_R32F, width, 1, texels);
}

void set_material(texture::Texture* heights, uint32_t steps, uint32_t uv_set, const float* transform) {
  shd_material_desc desc = shd_material_desc_default();
  desc.parallax_depth = static_cast<float>(kDepth);
  desc.parallax_steps = steps;
  shd_slot slot = shd_slot_texture(SHD_SLOT_HEIGHT, nullptr, nullptr);
  slot.uv_set = uv_set;
  if (transform) std::copy_n(transform, 6, slot.uv_transform);
  material::SlotInput slots[material::kSlotCount] = {};
  slots[SHD_SLOT_HEIGHT] = {slot, 0, heights, &g->sampler, nullptr};
  material::build(desc, slots, &g->material);
}

/// Rows on the plane z = 0 with u along x and v along -y, seen at cosines of low..high, with lines of sight towards
/// `side` along u.
void make_points(Random* random, double low, double high, double side, uint32_t uv_set) {
  raster::Fragments& f = g->before;
  f.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const double cosine = random->in(low, high), sine = sqrt(1.0 - cosine * cosine), turn = random->in(-1.0, 1.0);
    f.nx[i] = f.ny[i] = 0.0f, f.nz[i] = 1.0f;
    f.ox[i] = static_cast<float>(-side * sine * cos(turn));
    f.oy[i] = static_cast<float>(sine * sin(turn)), f.oz[i] = static_cast<float>(cosine);
    f.u[i] = f.u1[i] = 0.5f, f.v[i] = f.v1[i] = random->real(0.0, 1.0);
    (uv_set ? f.u1 : f.u)[i] = random->real(0.4, 0.6);
    for (float* column : {f.dudx, f.dvdx, f.dudy, f.dvdy}) column[i] = 1e-3f;
    const double frame[6] = {kScale[0], 0, 0, 0, -kScale[1], 0};
    for (int c = 0; c < 6; ++c)
      g->columns.tangent_frame[c][i] = g->kept.tangent_frame[c][i] = static_cast<float>(frame[c]);
  }
}

void shift(const core::SimdTarget& target, raster::Fragments* points) {
  const shade::DrawShading shading = draw_shading();
  shade::shift_by_heights(target, {shading, *points, g->varyings, true}, points, &g->columns);
}

/// Runs all targets and tails, with the result in `first`.
void shift_everywhere() {
  for_each_target([&](const core::SimdTarget& target, bool first) {
    raster::Fragments& points = first ? g->first : g->points;
    copy_points(g->before, &points);
    shift(target, &points);
    assert_memory_equal(points.block.data(), g->first.block.data(), points.block.size() * sizeof(float));
    for (size_t count : {size_t{1}, size_t{7}, size_t{63}, size_t{64}, size_t{65}, size_t{129}}) {
      copy_points(g->before, &g->points);
      g->points.count = count;
      shift(target, &g->points);
      assert_memory_equal(g->points.u, g->first.u, count * sizeof(float));
      assert_memory_equal(g->points.v1, g->first.v1, count * sizeof(float));
      const size_t padded = data::padded(count);
      for (size_t i = count; i < padded; ++i) assert_true(g->points.u[i] == g->points.u[count - 1]);
      assert_memory_equal(g->points.u + padded, g->before.u + padded, (kBatch - padded) * sizeof(float));
    }
  });
}

/// Change of u and v of row i down to the full depth.
void whole_shift(size_t i, double* du, double* dv) {
  const raster::Fragments& f = g->before;
  const double steep = std::max(double{f.oz[i]}, 0.1);
  *du = -double{f.ox[i]} * kDepth / steep / kScale[0];
  *dv = double{f.oy[i]} * kDepth / steep / kScale[1];
}

struct PlaneCase {
  const char* name;
  double at, slope;  // height at u = 1/2, and slope per u
  uint32_t steps, uv_set;
  double low, high;  // cosines
};
PlaneCase g_plane;
const PlaneCase k_planes[] = {
    {"plane/surface", 1, 0, 24, 0, 0.2, 1},       {"plane/floor", 0, 0, 24, 0, 0.2, 1},
    {"plane/half", 0.5, 0, 24, 0, 0.2, 1},        {"plane/2_steps", 0.3, 0, 2, 0, 0.2, 1},
    {"plane/256_steps", 0.3, 0, 256, 0, 0.2, 1},  {"plane/above", 2, 0, 24, 0, 0.2, 1},
    {"plane/below", -1, 0, 24, 0, 0.2, 1},        {"plane/grazing", 0.5, 0, 24, 0, 0.01, 0.1},
    {"plane/straight", 0.5, 0, 24, 0, 1, 1},      {"ramp/up", 0.5, 0.4, 24, 0, 0.3, 1},
    {"ramp/down", 0.5, -0.4, 24, 0, 0.3, 1},      {"ramp/2_steps", 0.5, 0.4, 2, 0, 0.3, 1},
    {"ramp/256_steps", 0.5, 0.4, 256, 0, 0.3, 1}, {"ramp/uv1", 0.5, 0.4, 24, 1, 0.3, 1},
};

/// Solves 1 - s = h(u0 + s du) for s in 0..1: linear interpolation between steps is exact for planes.
void test_plane(void** state) {
  g_plane = *static_cast<const PlaneCase*>(*state);
  g->sampler = make_sampler(SHD_FILTER_BILINEAR, SHD_WRAP_CLAMP);
  texture::Texture* heights =
      height_texture([](uint32_t i) { return g_plane.at + g_plane.slope * ((i + 0.5) / kWidth - 0.5); }, kWidth);
  for (double side : {1.0, -1.0}) {
    Random random = {151};
    make_points(&random, g_plane.low, g_plane.high, side, g_plane.uv_set);
    set_material(heights, g_plane.steps, g_plane.uv_set, nullptr);
    shift_everywhere();
    const float *u = g_plane.uv_set ? g->before.u1 : g->before.u, *v = g_plane.uv_set ? g->before.v1 : g->before.v;
    const float *got_u = g_plane.uv_set ? g->first.u1 : g->first.u, *got_v = g_plane.uv_set ? g->first.v1 : g->first.v;
    for (size_t i = 0; i < kBatch; ++i) {
      double du, dv;
      whole_shift(i, &du, &dv);
      const double height = g_plane.at + g_plane.slope * (u[i] - 0.5);
      const double s = std::min(std::max((1.0 - height) / (1.0 + g_plane.slope * du), 0.0), 1.0);
      shd_assert_close("u", i, got_u[i], u[i] + s * du, 1e-6 + 2e-5 * fabs(du), 0.0);
      shd_assert_close("v", i, got_v[i], v[i] + s * dv, 1e-6 + 2e-5 * fabs(dv), 0.0);
      const float* other = g_plane.uv_set ? g->first.u : g->first.u1;
      assert_true(other[i] == 0.5f && g->first.dudx[i] == 1e-3f);
    }
  }
  free_texture(heights);
}

/// A wall at u = 1/2: lines that hit it end there within a step; the other lines end on the floor.
void test_wall(void**) {
  g->sampler = make_sampler(SHD_FILTER_NEAREST, SHD_WRAP_CLAMP);
  texture::Texture* heights = height_texture([](uint32_t i) { return i < kWidth / 2 ? 0.0 : 1.0; }, kWidth);
  for (uint32_t steps : {2u, 24u, 256u}) {
    Random random = {152};
    make_points(&random, 0.2, 1.0, 1.0, 0);
    set_material(heights, steps, 0, nullptr);
    shift_everywhere();
    for (size_t i = 0; i < kBatch; ++i) {
      double du, dv;
      whole_shift(i, &du, &dv);
      const double u = g->before.u[i], wall = u >= 0.5 ? 0.0 : (0.5 - u) / du, s = (g->first.u[i] - u) / du;
      const double width = 1.0 / (steps - 1.0);
      if (u >= 0.5) assert_true(s == 0.0);
      if (wall > 1.0 + 1e-5) shd_assert_close("floor", i, s, 1.0, 1e-4, 0.0);
      if (u < 0.5 && wall < 1.0 - 1e-5) assert_true(fabs(s - wall) <= width + 1e-4);
    }
  }
  free_texture(heights);
}

/// Heights are looked up through the slot's transform: the height field has one column for any width.
void test_transform(void**) {
  g->sampler = make_sampler(SHD_FILTER_BILINEAR, SHD_WRAP_CLAMP);
  texture::Texture* heights = height_texture([](uint32_t i) { return (i + 0.5) / kWidth; }, kWidth);
  const float transform[6] = {0.5f, 0, 0.125f, 0, 1, 0};  // h = u / 2 + 1 / 8
  Random random = {153};
  make_points(&random, 0.3, 1.0, 1.0, 0);
  set_material(heights, 24, 0, transform);
  shift_everywhere();
  for (size_t i = 0; i < kBatch; ++i) {
    double du, dv;
    whole_shift(i, &du, &dv);
    const double u = g->before.u[i], s = (1.0 - 0.5 * u - 0.125) / (1.0 + 0.5 * du);
    shd_assert_close("u", i, g->first.u[i], u + s * du, 1e-6 + 2e-5 * fabs(du), 0.0);
  }
  free_texture(heights);
}

struct OddCase {
  const char* name;
  float height;
  uint32_t width;
};
const OddCase k_odd[] = {
    {"odd/1x1", 0.25f, 1},
    {"odd/nan", NAN, 1},
    {"odd/infinite", INFINITY, 1},
    {"odd/-infinite", -INFINITY, 1},
    {"odd/nan_wall", NAN, kWidth},
    {"odd/infinite_wall", INFINITY, kWidth},
    {"odd/-infinite_wall", -INFINITY, kWidth},
    {"odd/3e38_wall", 3e38f, kWidth},
};
float g_odd;

/// For any heights, points end on their line of sight.
void test_odd(void** state) {
  const auto* c = static_cast<const OddCase*>(*state);
  g_odd = c->height;
  g->sampler = make_sampler(SHD_FILTER_NEAREST, SHD_WRAP_CLAMP);
  texture::Texture* heights =
      c->width == 1 ? height_texture([](uint32_t) { return double{g_odd}; }, 1)
                    : height_texture([](uint32_t i) { return i < kWidth / 2 ? 0.25 : double{g_odd}; }, kWidth);
  for (uint32_t steps : {2u, 24u, 256u}) {
    Random random = {154};
    make_points(&random, 0.2, 1.0, 1.0, 0);
    set_material(heights, steps, 0, nullptr);
    shift_everywhere();
    for (size_t i = 0; i < kBatch; ++i) {
      double du, dv;
      whole_shift(i, &du, &dv);
      const double s = (double{g->first.u[i]} - g->before.u[i]) / du;
      assert_true(s >= -1e-4 && s <= 1.0 + 1e-4);
      if (c->height == 0.25f) shd_assert_close("s", i, s, 0.75, 1e-4, 0.0);
    }
  }
  free_texture(heights);
}

/// Frames without area, lines of sight along the surface and non-finite points give finite positions.
void test_degenerate(void**) {
  g->sampler = make_sampler(SHD_FILTER_BILINEAR, SHD_WRAP_CLAMP);
  texture::Texture* heights = height_texture([](uint32_t) { return 0.5; }, 1);
  Random random = {155};
  make_points(&random, 0.2, 1.0, 1.0, 0);
  set_material(heights, 24, 0, nullptr);
  const float odd[] = {0.0f, NAN, INFINITY, 1e-30f};
  for (size_t i = 0; i < kBatch; ++i) {
    const float value = odd[i / 8 % 4];
    if (i % 8 == 1) g->columns.tangent_frame[0][i] = value;
    if (i % 8 == 3) g->columns.tangent_frame[3][i] = g->columns.tangent_frame[4][i] = value;
    if (i % 8 == 5) g->before.ox[i] = value, g->before.oz[i] = 0.0f;
    if (i % 8 == 7) g->before.nz[i] = value;
  }
  shift_everywhere();
  for (size_t i = 0; i < kBatch; ++i) assert_true(std::isfinite(g->first.u[i]) && std::isfinite(g->first.v[i]));
  free_texture(heights);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const PlaneCase& c : k_planes) tests[n++] = {c.name, test_plane, nullptr, nullptr, const_cast<PlaneCase*>(&c)};
  for (const OddCase& c : k_odd) tests[n++] = {c.name, test_odd, nullptr, nullptr, const_cast<OddCase*>(&c)};
  tests[n++] = {"wall", test_wall, nullptr, nullptr, nullptr};
  tests[n++] = {"transform", test_transform, nullptr, nullptr, nullptr};
  tests[n++] = {"degenerate", test_degenerate, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.parallax", tests, n, set_up, tear_down);
}
