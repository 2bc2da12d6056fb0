// SPDX-License-Identifier: MIT
// Vertex programs below the ABI: the bits are equal on every target and for every division into parts, and a program
// without changes gives the bits of the fixed transform.
#include "support/check.h"

#include <algorithm>

#include "data/data.h"
#include "geometry/vertex_program.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

const core::Allocator g_allocator = {core::default_allocator()};
constexpr uint32_t kVertices = 1500;
constexpr uint32_t kVaryings = 5;

struct Fixture {
  geometry::Mesh mesh = {};
  geometry::Vertices got, want;
  geometry::VertexColumns columns;
  shd_view view = {};
  float world[16];
  geometry::Transform transform;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  Random random = {3};
  geometry::Mesh& m = g->mesh;
  m.vertex_count = kVertices;
  for (core::Array<float>* column : {&m.px, &m.py, &m.pz, &m.nx, &m.ny, &m.nz, &m.u, &m.v}) {
    *column = core::Array<float>(g_allocator, data::padded(kVertices));
    column->fill_zero();
    for (size_t i = 0; i < kVertices; ++i) (*column)[i] = random.real(-1.0, 1.0);
  }
  geometry::allocate(g_allocator, m, kVaryings, &g->got);
  geometry::allocate(g_allocator, m, kVaryings, &g->want);
  geometry::allocate(g_allocator, &g->columns);
  for (int i = 0; i < 16; ++i) {
    const bool last_row = i % 4 == 3;
    g->world[i] = last_row ? (i == 15 ? 1.0f : 0.0f) : random.real(-2.0, 2.0);
    g->view.world_to_view[i] = last_row ? (i == 15 ? 1.0f : 0.0f) : random.real(-2.0, 2.0);
    g->view.view_to_clip[i] = random.real(-2.0, 2.0);
  }
  const geometry::PixelBox all = geometry::pixel_rectangle(0, 0, 333, 217);
  g->transform = geometry::make_transform(g->view, g->world, {3, 5, 301, 200}, all);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

void nothing(const shd_vertices*, shd_vertex_outputs*, void*) {}
void everything(const shd_vertices* in, shd_vertex_outputs* out, void*) {
  float* const columns[] = {out->x,  out->y,  out->z,  out->w,  out->px, out->py,
                            out->pz, out->nx, out->ny, out->nz, out->u,  out->v};
  for (size_t i = 0; i < in->count; ++i) {
    for (size_t c = 0; c < 12; ++c) {
      if ((in->first + i + c) % 3) columns[c][i] += 0.25f * in->px[i] * static_cast<float>(c);
    }
    for (uint32_t c = 0; c < out->varying_count; ++c) {
      out->varying[c][i] += in->py[i] + static_cast<float>(in->first + i + 1000 * c);
    }
    if ((in->first + i) % 97 == 0) out->w[i] = __builtin_nanf("");
  }
}

void run(const core::SimdTarget& target, shd_vertex_fn function, size_t part, geometry::Vertices* out) {
  const geometry::VertexProgram program = {function, nullptr, nullptr, &g->view, g->world, 0, 0, kVaryings};
  const size_t rows = data::padded(kVertices);
  for (size_t begin = 0; begin < rows; begin += part) {
    geometry::run_vertex_program(target, {g->mesh, nullptr}, g->transform, program,
                                 {begin, std::min(rows, begin + part), begin}, &g->columns, out);
  }
}

void compare(const char* name, const geometry::Vertices& a, const geometry::Vertices& b, bool varyings) {
  if (memcmp(a.screen.data(), b.screen.data(), kVertices * sizeof a.screen[0]) != 0) fail_msg("%s: screen", name);
  if (memcmp(a.raster.data(), b.raster.data(), 16 * kVertices) != 0) fail_msg("%s: raster", name);
  if (memcmp(a.world.data(), b.world.data(), 16 * kVertices) != 0) fail_msg("%s: world", name);
  if (memcmp(a.normal.data(), b.normal.data(), 16 * kVertices) != 0) fail_msg("%s: normal", name);
  if (varyings && memcmp(a.varying.data(), b.varying.data(), 4 * kVaryings * kVertices) != 0)
    fail_msg("%s: varyings", name);
}

void test_nothing(void**) {
  for_each_target([&](const core::SimdTarget& target, bool) {
    geometry::transform_vertices(target, g->mesh, g->transform, {0, data::padded(kVertices), 0}, &g->want);
    run(target, nothing, data::padded(kVertices), &g->got);
    compare(target.name, g->got, g->want, false);
    for (size_t i = 0; i < kVaryings * size_t{kVertices}; ++i) assert_true(g->got.varying[i] == 0.0f);
  });
}

void test_everything(void**) {
  run(best_target(), everything, data::padded(kVertices), &g->want);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t part : {size_t{64}, size_t{192}, size_t{576}, size_t{1536}}) {
      run(target, everything, part, &g->got);
      compare(target.name, g->got, g->want, true);
    }
  });
  for (uint32_t i = 0; i < kVertices; ++i) {
    const bool dropped = (g->want.screen[i].outcode & geometry::kOutNonfinite) != 0;
    assert_true(dropped == (i % 97 == 0));
    for (uint32_t c = 0; c < kVaryings; ++c) {
      const float want = g->mesh.py[i] + static_cast<float>(i + 1000 * c);
      assert_true(g->want.varying[size_t{kVaryings} * i + c] == want);
    }
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {
      {"nothing_changed", test_nothing, nullptr, nullptr, nullptr},
      {"everything_changed", test_everything, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.geometry.vertex_program", tests, 2, set_up, tear_down);
}
