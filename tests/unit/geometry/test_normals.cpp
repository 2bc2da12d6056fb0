// SPDX-License-Identifier: MIT
// Vertex normals of every weighting against the oracle, on solids, degenerate faces and random meshes.
#include "support/check.h"

#include "core/context.h"
#include "geometry/mesh.h"
#include "geometry/normals.h"
#include "ref/mesh_ref.h"

namespace {

using shd::geometry::Mesh;

shd::core::Context* g_context;

constexpr size_t kMaxVertices = 2000;
constexpr size_t kMaxTriangles = 4000;

/// A mesh to be built, as rows of position and index triples.
struct Shape {
  float position[3 * kMaxVertices];
  uint32_t indices[3 * kMaxTriangles];
  uint32_t vertex_count;
  size_t triangle_count;
};
Shape g_shape;

void set_shape(const float* position, size_t vertices, const uint32_t* indices, size_t triangles) {
  memcpy(g_shape.position, position, 3 * vertices * sizeof(float));
  memcpy(g_shape.indices, indices, 3 * triangles * sizeof(uint32_t));
  g_shape.vertex_count = static_cast<uint32_t>(vertices);
  g_shape.triangle_count = triangles;
}

void cube() {
  static const float k_position[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  static const uint32_t k_indices[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                         2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  set_shape(k_position, 8, k_indices, 12);
}

void tetrahedron() {
  static const float k_position[12] = {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
  static const uint32_t k_indices[12] = {0, 1, 3, 0, 2, 1, 0, 3, 2, 1, 2, 3};
  set_shape(k_position, 4, k_indices, 4);
}

// A fan with needles, whose faces differ in area by 1e8 and in angle by 100.
void uneven_fan() {
  static const float k_position[18] = {0, 0, 0, 1e4f, 0, 0, 0, 1e-4f, 1, -3, 2, 0.5f, -1e-3f, -1, 7, 1e4f, -1, -1e-3f};
  static const uint32_t k_indices[15] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1};
  set_shape(k_position, 6, k_indices, 5);
}

// Points, edges and repeated corners among proper faces; vertex 5 has only faces without area, vertex 6 has no faces.
void degenerate() {
  static const float k_position[21] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 0, 0, 4, 0, 0, 9, 9, 9};
  static const uint32_t k_indices[21] = {0, 1, 2, 0, 2, 3, 0, 4, 5, 1, 1, 3, 2, 2, 2, 0, 1, 4, 5, 4, 0};
  set_shape(k_position, 7, k_indices, 7);
}

// Faces whose normals cancel exactly at every vertex.
void two_sided() {
  static const float k_position[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 1};
  set_shape(k_position, 3, k_indices, 2);
}

uint32_t next_random(uint64_t* state) {  // Knuth, "The Art of Computer Programming" 2 (1997), MMIX constants
  *state = *state * 6364136223846793005ull + 1442695040888963407ull;
  return static_cast<uint32_t>(*state >> 33);
}

/// Vertices joined at random, some of them twice; coordinates of a given magnitude.
void random_mesh(uint64_t seed, float magnitude) {
  g_shape.vertex_count = 500;
  g_shape.triangle_count = 1000;
  for (float& p : g_shape.position) p = (static_cast<float>(next_random(&seed)) / 1073741824.0f - 1.0f) * magnitude;
  for (uint32_t& i : g_shape.indices) i = next_random(&seed) % 500;
}

void random_1() {
  random_mesh(1, 1.0f);
}
void random_huge() {
  random_mesh(2, 3.4e38f);
}
void random_tiny() {
  random_mesh(3, 1e-38f);
}

/// A height field of steps: shared vertices, regular valence, no cancellation.
void height_field() {
  constexpr uint32_t kSide = 40;
  uint64_t seed = 4;
  g_shape.vertex_count = kSide * kSide;
  for (uint32_t i = 0; i < kSide * kSide; ++i) {
    g_shape.position[3 * i] = static_cast<float>(i % kSide);
    g_shape.position[3 * i + 1] = static_cast<float>(next_random(&seed) % 1000) / 300.0f;
    g_shape.position[3 * i + 2] = static_cast<float>(i / kSide) * 0.1f;
  }
  size_t t = 0;
  for (uint32_t y = 0; y + 1 < kSide; ++y) {
    for (uint32_t x = 0; x + 1 < kSide; ++x, t += 2) {
      const uint32_t a = y * kSide + x;
      const uint32_t quad[6] = {a, a + kSide, a + 1, a + 1, a + kSide, a + kSide + 1};
      memcpy(g_shape.indices + 3 * t, quad, sizeof quad);
    }
  }
  g_shape.triangle_count = t;
}

struct Case {
  const char* name;
  void (*make)();
  shd_normal_weight weight;
};

#define ALL_WEIGHTS(name, make)                                                                       \
  {name "/area", make, SHD_NORMAL_WEIGHT_AREA}, {name "/uniform", make, SHD_NORMAL_WEIGHT_UNIFORM}, { \
    name "/angle", make, SHD_NORMAL_WEIGHT_ANGLE                                                      \
  }

const Case kCases[] = {
    ALL_WEIGHTS("cube", cube),
    ALL_WEIGHTS("tetrahedron", tetrahedron),
    ALL_WEIGHTS("uneven_fan", uneven_fan),
    ALL_WEIGHTS("degenerate", degenerate),
    ALL_WEIGHTS("two_sided", two_sided),
    ALL_WEIGHTS("random", random_1),
    ALL_WEIGHTS("random_3.4e38", random_huge),
    ALL_WEIGHTS("random_1e-38", random_tiny),
    ALL_WEIGHTS("height_field", height_field),
};

/// Builds the mesh on the heap, because a failing assertion leaves the test by longjmp.
Mesh* build_shape(shd_normal_weight weight, uint32_t flags) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = g_shape.vertex_count;
  for (int c = 0; c < 3; ++c) desc.position[c] = {g_shape.position + c, 3 * sizeof(float)};
  desc.indices.data = g_shape.indices;
  desc.index_count = 3 * g_shape.triangle_count;
  desc.normal_weight = weight;
  desc.flags = flags;
  Mesh* mesh = shd::core::create<Mesh>(g_context->allocator);
  shd::geometry::build(*g_context, desc, mesh);
  return mesh;
}

void free_shape(Mesh* mesh) {
  shd::core::destroy(g_context->allocator, mesh);
}

void test_against_oracle(void** state) {
  const Case& c = *static_cast<const Case*>(*state);
  c.make();
  Mesh* mesh = build_shape(c.weight, 0);
  uint32_t normalless = 0;
  for (uint32_t i = 0; i < g_shape.vertex_count; ++i) {
    double want[3];
    if (!shd_ref_vertex_normal(g_shape.position, g_shape.indices, g_shape.triangle_count, c.weight, i, want)) {
      ++normalless;
    }
    const float got[3] = {mesh->nx[i], mesh->ny[i], mesh->nz[i]};
    double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      shd_assert_close(c.name, 3 * i + static_cast<size_t>(axis), static_cast<double>(got[axis]), want[axis], 1.2e-7,
                       0);
      square += static_cast<double>(got[axis]) * static_cast<double>(got[axis]);
    }
    shd_assert_close(c.name, i, square, 1.0, 2e-7, 0);
  }
  assert_int_equal(mesh->info.normalless_count, normalless);
  for (size_t i = g_shape.vertex_count; i < mesh->nx.size(); ++i) {
    assert_true(mesh->nx[i] == 0.0f && mesh->ny[i] == 0.0f && mesh->nz[i] == 0.0f);
  }
  free_shape(mesh);
}

// With angle weighting, the triangulation of the sides of a cube does not matter.
void test_cube_corners(void**) {
  cube();
  Mesh* angle = build_shape(SHD_NORMAL_WEIGHT_ANGLE, 0);
  const double third = 0.57735026918962576;
  for (uint32_t i = 0; i < 8; ++i) {
    const double want[3] = {i & 1 ? third : -third, i & 2 ? third : -third, i & 4 ? third : -third};
    shd_assert_close("x", i, static_cast<double>(angle->nx[i]), want[0], 6e-8, 0);
    shd_assert_close("y", i, static_cast<double>(angle->ny[i]), want[1], 6e-8, 0);
    shd_assert_close("z", i, static_cast<double>(angle->nz[i]), want[2], 6e-8, 0);
  }
  free_shape(angle);
  Mesh* uniform = build_shape(SHD_NORMAL_WEIGHT_UNIFORM, 0);
  assert_true(fabsf(uniform->nx[1] - uniform->nz[1]) > 0.1f || fabsf(uniform->ny[1] + uniform->nx[1]) > 0.1f);
  free_shape(uniform);
}

// A non-finite vertex affects only its own faces.
void test_nonfinite_vertex(void**) {
  const float bad[] = {NAN, INFINITY, -INFINITY};
  const shd_normal_weight weights[] = {SHD_NORMAL_WEIGHT_AREA, SHD_NORMAL_WEIGHT_UNIFORM, SHD_NORMAL_WEIGHT_ANGLE};
  for (const float value : bad) {
    for (const shd_normal_weight weight : weights) {
      tetrahedron();
      g_shape.position[3 * 3 + 1] = value;
      Mesh* mesh = build_shape(weight, SHD_MESH_KEEP_NONFINITE);
      assert_int_equal(mesh->info.nonfinite_count, 1);
      assert_int_equal(mesh->info.normalless_count, 1);
      assert_true(mesh->nx[3] == 0.0f && mesh->ny[3] == 0.0f && mesh->nz[3] == 1.0f);
      const float third = 0.57735026919f;  // normal of the only remaining face, 0, 2, 1
      for (uint32_t i = 0; i < 3; ++i) {
        shd_assert_close("x", i, static_cast<double>(mesh->nx[i]), static_cast<double>(-third), 6e-8, 0);
        shd_assert_close("y", i, static_cast<double>(mesh->ny[i]), static_cast<double>(third), 6e-8, 0);
        shd_assert_close("z", i, static_cast<double>(mesh->nz[i]), static_cast<double>(third), 6e-8, 0);
      }
      free_shape(mesh);
    }
  }
}

// The bits of a height field are equal on every machine and compiler.
void test_bits(void**) {
  const shd_normal_weight weights[] = {SHD_NORMAL_WEIGHT_AREA, SHD_NORMAL_WEIGHT_UNIFORM, SHD_NORMAL_WEIGHT_ANGLE};
  height_field();
  uint64_t hash = SHD_HASH_START;
  for (const shd_normal_weight weight : weights) {
    Mesh* mesh = build_shape(weight, 0);
    hash = shd_hash(hash, mesh->nx.data(), mesh->vertex_count * sizeof(float));
    hash = shd_hash(hash, mesh->ny.data(), mesh->vertex_count * sizeof(float));
    hash = shd_hash(hash, mesh->nz.data(), mesh->vertex_count * sizeof(float));
    free_shape(mesh);
  }
  assert_int_equal(hash, 0x6d8a19f43370b727ull);
}

}  // namespace

int main() {
  constexpr size_t kCaseCount = sizeof kCases / sizeof kCases[0];
  static CMUnitTest tests[kCaseCount + 3];
  size_t n = 0;
  for (const Case& c : kCases) tests[n++] = {c.name, test_against_oracle, nullptr, nullptr, const_cast<Case*>(&c)};
  tests[n++] = {"cube_corners", test_cube_corners, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite_vertex", test_nonfinite_vertex, nullptr, nullptr, nullptr};
  tests[n++] = {"bits", test_bits, nullptr, nullptr, nullptr};
  g_context = shd::core::create_context(shd_context_desc_default());
  const int failed = _cmocka_run_group_tests("unit.geometry.normals", tests, n, nullptr, nullptr);
  shd::core::release(*g_context);
  return failed;
}
