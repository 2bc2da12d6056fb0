// SPDX-License-Identifier: MIT
// Tangents against the oracle: mirrored, degenerate and missing uv, seams, fans, duplicated vertices, random meshes.
#include "support/check.h"

#include <utility>

#include "core/context.h"
#include "geometry/mesh.h"
#include "geometry/weld.h"
#include "ref/tangent_ref.h"
#include "support/random.h"

namespace {

using shd::geometry::Mesh;

shd::core::Context* g_context;

constexpr uint32_t kMaxVertices = 2000;
constexpr uint32_t kMaxCorners = 2400;

/// A mesh to be built: rows of position, normal, uv, and triangles.
struct Shape {
  float vertex[kMaxVertices][8];
  uint32_t indices[kMaxCorners];
  uint32_t vertex_count, corner_count;
};
Shape g_shape;

/// The oracle's results.
size_t g_group[kMaxCorners], g_forward[kMaxCorners], g_backward[kMaxCorners];
int g_sign[kMaxCorners], g_has_area[kMaxCorners];
double g_tangent[kMaxCorners][4], g_strength[kMaxCorners];

void clear() {
  g_shape.vertex_count = g_shape.corner_count = 0;
}
uint32_t add_vertex(float x, float y, float z, float u, float v) {
  const float row[8] = {x, y, z, 0, 0, 1, u, v};
  memcpy(g_shape.vertex[g_shape.vertex_count], row, sizeof row);
  return g_shape.vertex_count++;
}
void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
  for (const uint32_t i : {a, b, c}) g_shape.indices[g_shape.corner_count++] = i;
}

/// A square of width x height cells in the plane z = 0, u right and v down as in a picture.
void grid(uint32_t width, uint32_t height) {
  clear();
  for (uint32_t y = 0; y <= height; ++y) {
    for (uint32_t x = 0; x <= width; ++x) {
      const auto i = static_cast<float>(x), j = static_cast<float>(y);
      add_vertex(i, j, 0, i / static_cast<float>(width), 1 - j / static_cast<float>(height));
    }
  }
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const uint32_t a = y * (width + 1) + x, b = a + width + 1;
      add_triangle(a, a + 1, b + 1);
      add_triangle(a, b + 1, b);
    }
  }
}

template <class Edit>
void for_each_vertex(const Edit& edit) {
  for (uint32_t i = 0; i < g_shape.vertex_count; ++i) edit(g_shape.vertex[i], i);
}
void set_normal(float* row, double x, double y, double z) {
  const double size = std::sqrt(x * x + y * y + z * z);
  row[3] = static_cast<float>(x / size);
  row[4] = static_cast<float>(y / size);
  row[5] = static_cast<float>(z / size);
}

void quad() {
  grid(1, 1);
}
void grid_5x3() {
  grid(5, 3);
}
void turned_uv() {
  grid(4, 4);
  for_each_vertex([](float* row, uint32_t) { std::swap(row[6], row[7]); });
}
void mirrored_half() {  // u = |x - 3|: each vertex of the middle column is split into two
  grid(6, 3);
  for_each_vertex([](float* row, uint32_t) { row[6] = fabsf(row[0] - 3); });
}
void bumpy() {
  grid(12, 9);
  shd::tests::Random random{7};
  for_each_vertex([&](float* row, uint32_t) {
    row[2] = random.real(-0.6, 0.6);
    row[6] += random.real(-0.02, 0.02);
    row[7] += random.real(-0.02, 0.02);
    set_normal(row, random.in(-0.4, 0.4), random.in(-0.4, 0.4), 1);
  });
}
void bumpy_unindexed() {
  static Shape source;
  bumpy();
  source = g_shape;
  clear();
  for (uint32_t c = 0; c < source.corner_count; ++c) {
    memcpy(g_shape.vertex[c], source.vertex[source.indices[c]], sizeof source.vertex[0]);
    g_shape.indices[c] = c;
  }
  g_shape.vertex_count = g_shape.corner_count = source.corner_count;
}
void minus_zero() {  // equal values of different bits are merged
  quad();
  const uint32_t again = add_vertex(-0.0f, -0.0f, -0.0f, -0.0f, 1);
  g_shape.indices[3] = again;
  g_shape.vertex[again][3] = -0.0f;
}
void seam() {  // equal positions, different uv
  grid(3, 2);
  for (uint32_t i = 0; i < 6; ++i) {
    const uint32_t old = g_shape.indices[6 + i];
    const float* row = g_shape.vertex[old];
    g_shape.indices[6 + i] = add_vertex(row[0], row[1], row[2], 0.5f * row[7] + 0.1f * row[6], row[6]);
  }
}
void sphere() {
  grid(16, 12);
  for_each_vertex([](float* row, uint32_t) {
    const double a = 6.283185307179586 * static_cast<double>(row[6]),
                 b = 3.141592653589793 * static_cast<double>(row[7]);
    set_normal(row, std::cos(a) * std::sin(b), std::cos(b), -std::sin(a) * std::sin(b));
    for (int c = 0; c < 3; ++c) row[c] = row[3 + c];
  });
}
void degenerate_uv_island() {  // a patch of constant uv; its rim uses the neighbours' tangents
  grid(6, 6);
  for_each_vertex([](float* row, uint32_t) {
    if (fabsf(row[0] - 3) <= 1 && fabsf(row[1] - 3) <= 1) row[6] = row[7] = 0.5f;
  });
}
void degenerate_uv_between_mirrors() {  // the first neighbour determines the sign
  grid(5, 1);
  for_each_vertex([](float* row, uint32_t) { row[6] = row[0] < 3 ? row[0] : 5 - row[0]; });
}
void degenerate_uv_line() {
  grid(3, 3);
  for_each_vertex([](float* row, uint32_t) { row[7] = 2 * row[6]; });
}
void missing_uv() {
  grid(3, 3);
  for_each_vertex([](float* row, uint32_t i) {
    row[6] = row[7] = 0;
    set_normal(row, i % 3 == 0, i % 3 == 1, i % 2 == 0);
  });
}
void nan_uv() {
  grid(4, 4);
  g_shape.vertex[6][6] = NAN;
  g_shape.vertex[12][7] = INFINITY;
  g_shape.vertex[18][6] = g_shape.vertex[18][7] = -INFINITY;
}
void zero_area() {  // triangles with two equal corners, three equal corners, and collinear corners
  grid(3, 1);
  add_triangle(0, 0, 1);
  add_triangle(2, 2, 2);
  add_triangle(0, 1, 2);
  add_triangle(add_vertex(0, 0, 0, 0.7f, 0.7f), add_vertex(0, 0, 0, 0.1f, 0.3f), 1);
}
void unused_vertices() {
  quad();
  add_vertex(9, 9, 9, 0, 0);
  set_normal(g_shape.vertex[4], 1, 0, 0);
}
void flipped_winding() {  // a triangle seen from behind is mirrored
  grid(3, 2);
  std::swap(g_shape.indices[7], g_shape.indices[8]);
}
void doubled_faces() {  // every edge belongs to four triangles
  grid(2, 2);
  const uint32_t corners = g_shape.corner_count;
  for (uint32_t c = 0; c < corners; ++c) g_shape.indices[g_shape.corner_count++] = g_shape.indices[c];
}
void two_sided() {
  grid(2, 2);
  const uint32_t corners = g_shape.corner_count;
  for (uint32_t c = 0; c < corners; ++c) g_shape.indices[g_shape.corner_count++] = g_shape.indices[corners - 1 - c];
}
void bow_tie() {  // fans that share a vertex and no edge are separate groups; two of them agree
  clear();
  add_vertex(0, 0, 0, 0.5f, 0.5f);
  add_triangle(0, add_vertex(2, 0, 0, 1, 0.5f), add_vertex(2, 1, 0, 1, 0.2f));
  add_triangle(0, add_vertex(-2, 0, 0, 0.1f, 0.9f), add_vertex(-2, -1, 0, 0, 0.5f));
  add_triangle(0, add_vertex(0, 2, 0, 0.5f, 0), add_vertex(-1, 2, 0, 0.3f, 0));
}
void cancelling() {  // two triangles with opposite directions
  clear();
  add_vertex(0, 0, 0, 0, 0);
  add_triangle(0, add_vertex(1, 0, 0, 1, 0), add_vertex(0, 1, 0, 0, -1));
  add_triangle(0, add_vertex(-1, 0, 0, 1, 0), add_vertex(0, -1, 0, 0, -1));
}
/// Two triangles of one fan with exactly opposite directions of u. The sum at a vertex is that of the larger angle: 90
/// against 45 degrees at vertex 0, 45 against 90 at vertex 2.
void folded() {
  clear();
  add_vertex(0, 0, 0, 0, 0);
  add_vertex(1, 0, 0, 1, 0);
  add_vertex(0, 1, 0, 0, 1);
  add_vertex(1, 1, 0, -1, 1);
  add_triangle(0, 1, 2);
  add_triangle(0, 2, 3);
}
void normal_along_u() {  // dP/du is parallel to the normal
  grid(2, 2);
  for_each_vertex([](float* row, uint32_t) { set_normal(row, 1, 0, 0); });
}
void scaled(float position, float uv) {
  bumpy();
  for_each_vertex([&](float* row, uint32_t) {
    for (int c = 0; c < 3; ++c) row[c] *= position;
    row[6] *= uv;
    row[7] *= uv;
  });
}
void huge() {
  scaled(2e37f, 1e37f);
}
void tiny() {
  scaled(1e-37f, 1e-37f);
}
void random_soup(uint64_t seed, uint32_t vertices, int64_t steps) {
  shd::tests::Random random{seed};
  clear();
  for (uint32_t i = 0; i < vertices; ++i) {
    const auto step = [&] { return static_cast<float>(random.whole(-steps, steps)); };
    const float x = step(), y = step(), z = step(), u = step();
    add_vertex(x, y, z, u, step());
  }
  for (int t = 0; t < 300; ++t) {
    const auto any = [&] { return static_cast<uint32_t>(random.whole(0, vertices - 1)); };
    const uint32_t a = any(), b = any();
    add_triangle(a, b, any());
  }
}
void soup_of_12() {
  random_soup(1, 12, 1000);
}
void soup_of_60() {
  random_soup(2, 60, 1000);
}
void soup_on_few_places() {
  random_soup(3, 200, 1);
}
void nan_position() {
  grid(4, 4);
  g_shape.vertex[12][1] = NAN;
  g_shape.vertex[0][0] = INFINITY;
}

struct Case {
  const char* name;
  void (*make)();
  uint32_t split, tangentless;
};

const Case kCases[] = {
    {"quad", quad, 0, 0},
    {"grid", grid_5x3, 0, 0},
    {"turned_uv", turned_uv, 0, 0},
    {"mirrored_half", mirrored_half, 4, 0},
    {"bumpy", bumpy, 0, 0},
    {"bumpy_unindexed", bumpy_unindexed, 0, 0},
    {"minus_zero", minus_zero, 0, 0},
    {"seam", seam, 0, 0},
    {"sphere_with_poles", sphere, 0, 1},
    {"degenerate_uv/island", degenerate_uv_island, 0, 1},
    {"degenerate_uv/between_mirrors", degenerate_uv_between_mirrors, 0, 0},
    {"degenerate_uv/line", degenerate_uv_line, 0, 16},
    {"degenerate_uv/missing", missing_uv, 0, 16},
    {"nan_uv", nan_uv, 13, 0},
    {"zero_area", zero_area, 0, 2},
    {"unused_vertices", unused_vertices, 0, 1},
    {"flipped_winding", flipped_winding, 3, 0},
    {"doubled_faces", doubled_faces, 0, 0},
    {"two_sided", two_sided, 9, 0},
    {"bow_tie", bow_tie, 1, 0},
    {"cancelling", cancelling, 1, 0},
    {"folded", folded, 0, 0},
    {"normal_along_u", normal_along_u, 0, 9},
    {"position_2e37_uv_1e37", huge, 0, 0},
    {"position_1e-37_uv_1e-37", tiny, 0, 0},
    {"random_soup/12_vertices", soup_of_12, ~0u, ~0u},
    {"random_soup/60_vertices", soup_of_60, ~0u, ~0u},
    {"random_soup/27_places", soup_on_few_places, ~0u, ~0u},
    {"nan_position", nan_position, 0, 2},
};

Mesh* build_shape() {
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = g_shape.vertex_count;
  constexpr size_t kStride = sizeof g_shape.vertex[0];
  for (int c = 0; c < 3; ++c) desc.position[c] = {&g_shape.vertex[0][c], kStride};
  for (int c = 0; c < 3; ++c) desc.normal[c] = {&g_shape.vertex[0][3 + c], kStride};
  for (int c = 0; c < 2; ++c) desc.uv[c] = {&g_shape.vertex[0][6 + c], kStride};
  desc.indices.data = g_shape.indices;
  desc.index_count = g_shape.corner_count;
  desc.flags = SHD_MESH_TANGENTS | SHD_MESH_KEEP_NONFINITE;
  Mesh* mesh = shd::core::create<Mesh>(g_context->allocator);
  shd::geometry::build(*g_context, desc, mesh);
  return mesh;
}

void run_oracle(const Mesh& mesh) {
  for (uint32_t i = 0; i < g_shape.vertex_count; ++i) {  // as the mesh has read them
    float* row = g_shape.vertex[i];
    const float read[5] = {mesh.nx[i], mesh.ny[i], mesh.nz[i], mesh.u[i], mesh.v[i]};
    memcpy(row + 3, read, sizeof read);
  }
  shd_ref_tangents oracle = {g_shape.vertex, g_shape.indices, g_shape.corner_count, g_group,   g_forward,
                             g_backward,     g_sign,          g_has_area,           g_tangent, g_strength};
  shd_ref_tangents_of(&oracle);
}

/// Every column of `vertex` except the tangent equals the caller's `source`.
void check_copy(const Mesh& mesh, uint32_t vertex, uint32_t source) {
  const float got[8] = {mesh.px[vertex], mesh.py[vertex], mesh.pz[vertex], mesh.nx[vertex],
                        mesh.ny[vertex], mesh.nz[vertex], mesh.u[vertex],  mesh.v[vertex]};
  assert_memory_equal(got, g_shape.vertex[source], sizeof got);
}

void test_against_oracle(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  c.make();
  Mesh* mesh = build_shape();
  run_oracle(*mesh);
  if (c.split != ~0u) assert_int_equal(mesh->info.split_count, c.split);
  if (c.tangentless != ~0u) assert_int_equal(mesh->info.tangentless_count, c.tangentless);
  assert_int_equal(mesh->vertex_count, g_shape.vertex_count + mesh->info.split_count);
  assert_int_equal(mesh->info.vertex_count, mesh->vertex_count);
  for (size_t i = 0; i < g_shape.corner_count; ++i) {
    const uint32_t v = mesh->indices[i];
    assert_in_range(v, 0, mesh->vertex_count - 1);
    check_copy(*mesh, v, g_shape.indices[i]);
    assert_true(mesh->tw[v] == static_cast<float>(g_tangent[i][3]));
    if (g_strength[i] > 0 && g_strength[i] < 1e-6) continue;  // directions cancel: any unit vector is valid
    const double got[3] = {double{mesh->tx[v]}, double{mesh->ty[v]}, double{mesh->tz[v]}};
    const double tolerance = g_strength[i] > 0 ? 2e-7 / fmin(1.0, g_strength[i]) : 2e-7;
    for (size_t axis = 0; axis < 3; ++axis) {
      shd_assert_close(c.name, 3 * i + axis, got[axis], g_tangent[i][axis], tolerance, 0);
    }
  }
  shd::core::destroy(g_context->allocator, mesh);
}

/// Tangents are unit, perpendicular to the normal and of handedness 1 or -1 for any input; the padding is 0.
void test_invariants(void**) {
  for (const Case& c : kCases) {
    c.make();
    Mesh* mesh = build_shape();
    for (size_t i = 0; i < mesh->vertex_count; ++i) {
      const double t[3] = {double{mesh->tx[i]}, double{mesh->ty[i]}, double{mesh->tz[i]}};
      const double n[3] = {double{mesh->nx[i]}, double{mesh->ny[i]}, double{mesh->nz[i]}};
      shd_assert_close(c.name, i, shd_ref_dot3(t, t), 1.0, 3e-7, 0);
      shd_assert_close(c.name, i, shd_ref_dot3(t, n), 0.0, 3e-7, 0);
      assert_true(mesh->tw[i] == 1.0f || mesh->tw[i] == -1.0f);
    }
    shd::geometry::for_each_column(mesh, [&](const shd::core::Array<float>* column) {
      for (size_t i = mesh->vertex_count; i < column->size(); ++i) assert_true((*column)[i] == 0.0f);
    });
    shd::core::destroy(g_context->allocator, mesh);
  }
}

/// Opposite triangles of a fan are one group: no vertex is split, and both corners of an edge share its tangents.
void test_folded(void**) {
  folded();
  Mesh* mesh = build_shape();
  assert_int_equal(mesh->vertex_count, 4);
  const double want[3] = {1, 0, -1};  // x at vertices 0 and 2
  for (size_t i = 0; i < 3; i += 2) {
    shd_assert_close("x", i, static_cast<double>(mesh->tx[i]), want[i], 1e-7, 0);
    shd_assert_close("y", i, static_cast<double>(mesh->ty[i]), 0, 1e-7, 0);
    assert_true(mesh->tz[i] == 0);
  }
  assert_true(mesh->tw[0] == mesh->tw[2]);
  shd::core::destroy(g_context->allocator, mesh);
}

/// In a mesh with separate vertices for every corner, each corner has the tangent of the indexed mesh.
void test_duplicates_change_nothing(void**) {
  bumpy();
  Mesh* indexed = build_shape();
  bumpy_unindexed();
  Mesh* unindexed = build_shape();
  for (size_t c = 0; c < g_shape.corner_count; ++c) {
    const uint32_t a = indexed->indices[c], b = unindexed->indices[c];
    assert_true(indexed->tx[a] == unindexed->tx[b] && indexed->ty[a] == unindexed->ty[b]);
    assert_true(indexed->tz[a] == unindexed->tz[b] && indexed->tw[a] == unindexed->tw[b]);
  }
  shd::core::destroy(g_context->allocator, indexed);
  shd::core::destroy(g_context->allocator, unindexed);
}

void test_weld(void**) {
  constexpr size_t kCount = 700;
  static float columns[2][kCount];
  static uint32_t got[kCount];
  shd::tests::Random random{5};
  const float values[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, -1e-45f, 3e38f, INFINITY, NAN, 0.1f, 2048.0f, 1.0000001f};
  for (auto& column : columns) {
    for (float& value : column) value = values[random.whole(0, 11)];
  }
  const float* const both[2] = {columns[0], columns[1]};
  shd::geometry::weld(g_context->allocator, both, 2, kCount, got);
  const auto same = [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (size_t i = 0; i < kCount; ++i) {
    size_t want = 0;
    while (!same(columns[0][i], columns[0][want]) || !same(columns[1][i], columns[1][want])) ++want;
    assert_int_equal(got[i], want);
  }
  shd::geometry::weld(g_context->allocator, both, 2, 0, got);
}

/// The bits of all cases are equal on every machine and compiler.
void test_bits(void**) {
  uint64_t hash = SHD_HASH_START;
  for (const Case& c : kCases) {
    if (c.make == sphere || c.make == missing_uv) continue;  // made with sin and cos of libm
    if (c.make == folded) continue;                          // test_folded() has its values
    c.make();
    Mesh* mesh = build_shape();
    const shd::core::Array<float>* const columns[] = {&mesh->tx, &mesh->ty, &mesh->tz, &mesh->tw};
    for (const auto* column : columns) hash = shd_hash(hash, column->data(), mesh->vertex_count * sizeof(float));
    hash = shd_hash(hash, mesh->indices.data(), mesh->indices.size() * sizeof(uint32_t));
    shd::core::destroy(g_context->allocator, mesh);
  }
  assert_int_equal(hash, 0x600521dc748e77bfull);
}

}  // namespace

int main() {
  constexpr size_t kCaseCount = sizeof kCases / sizeof kCases[0];
  static CMUnitTest tests[kCaseCount + 5];
  size_t n = 0;
  for (const Case& c : kCases) tests[n++] = {c.name, test_against_oracle, nullptr, nullptr, const_cast<Case*>(&c)};
  tests[n++] = {"opposite_directions", test_folded, nullptr, nullptr, nullptr};
  tests[n++] = {"invariants", test_invariants, nullptr, nullptr, nullptr};
  tests[n++] = {"duplicates_change_nothing", test_duplicates_change_nothing, nullptr, nullptr, nullptr};
  tests[n++] = {"weld", test_weld, nullptr, nullptr, nullptr};
  tests[n++] = {"bits", test_bits, nullptr, nullptr, nullptr};
  g_context = shd::core::create_context(shd_context_desc_default());
  const int failed = _cmocka_run_group_tests("unit.geometry.tangents", tests, n, nullptr, nullptr);
  shd::core::release(*g_context);
  return failed;
}
