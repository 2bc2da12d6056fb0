// SPDX-License-Identifier: MIT
// Computed normals: means over the faces of up to 60 degrees around a corner, weighted by area. Right values follow
// from the angles.
#include <cmath>
#include <cstring>

#include "core/failure.h"
#include "scene/read/creases.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

constexpr double kDegree = 3.14159265358979323846 / 180;

const Limits kLimits;

std::string vertex(double x, double y, double z) {
  return "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
}

/// Two unit squares at the y axis, whose normals are `angle` degrees apart, in a file of each format without normals.
std::string book_of(const std::string& format, double angle) {
  const double x = std::cos(angle * kDegree), z = std::sin(angle * kDegree);
  std::string vertices =
      vertex(0, 0, 0) + vertex(0, 1, 0) + vertex(1, 0, 0) + vertex(1, 1, 0) + vertex(-x, 0, z) + vertex(-x, 1, z);
  if (format == "obj") return vertices + "f 1 3 4 2\nf 1 2 6 5\n";
  for (size_t at; (at = vertices.find("v ")) != std::string::npos;) vertices.erase(at, 2);
  const std::string faces = "4 0 2 3 1\n4 0 1 5 4\n";
  if (format == "off") return "OFF\n6 2 0\n" + vertices + faces;
  return "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\n"
         "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
         vertices + faces;
}

struct Book {
  const char *name, *format;
  double angle;
  size_t vertices;
};

const Book kBooks[] = {
    {"obj/30", "obj", 30, 6}, {"obj/59", "obj", 59, 6}, {"obj/61", "obj", 61, 8}, {"obj/90", "obj", 90, 8},
    {"obj/80", "obj", 80, 8}, {"ply/59", "ply", 59, 6}, {"ply/61", "ply", 61, 8},
#if defined(SHD_HAS_ASSIMP)
    {"off/59", "off", 59, 6}, {"off/61", "off", 61, 8},
#endif
};

void test_book(void** state) {
  const Book& book = *static_cast<const Book*>(*state);
  const Model model = read_text(book_of(book.format, book.angle), std::string("m.") + book.format);
  if (!model.warnings.empty()) fail_msg("%s: %s", book.name, warnings_of(model).c_str());
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.position.size() / 3, book.vertices);
  assert_int_equal(g.normal.size(), g.position.size());
  for (size_t i = 0; i < g.position.size(); i += 3) {
    const float x = g.position[i];
    const double half = book.vertices == 6 ? 0.5 * book.angle : -1;  // the common edge
    const double sine = static_cast<double>(g.normal[i]);
    if (std::fabs(x) < 0.001f && half >= 0) {
      shd_assert_close(book.name, i, sine, std::sin(half * kDegree), 1e-5, 0);
    } else if (std::fabs(x) < 0.001f) {
      assert_true(std::fabs(sine) < 1e-5 || std::fabs(sine - std::sin(book.angle * kDegree)) < 1e-5);
    } else {
      shd_assert_close(book.name, i, sine, x > 0 ? 0 : std::sin(book.angle * kDegree), 1e-5, 0);
    }
  }
}

/// A surface and its copy that faces the other way do not cancel, with and without a smoothing group.
void test_both_sides(void**) {
  for (const char* group : {"", "s 1\n"}) {
    const std::string text = vertex(0, 0, 0) + vertex(1, 0, 0) + vertex(0, 1, 0) + group + "f 1 2 3\nf 1 3 2\n";
    const Geometry g = read_text(text).geometries[0];
    assert_int_equal(g.indices.size(), 6);
    for (size_t i = 0; i < 6; ++i) assert_true(g.normal[3 * g.indices[i] + 2] == (i < 3 ? 1.0f : -1.0f));
  }
}

/// Columns follow split vertices, and equal positions of two geometries are one place.
void test_columns(void**) {
  Geometry parts[2];
  parts[0].position = {0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1};
  parts[0].indices = {0, 2, 1, 0, 1, 3};  // at 90 degrees
  parts[0].uv = {0, 0, 1, 1, 2, 2, 3, 3};
  parts[0].color = {0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 1, 3, 3, 3, 1};
  parts[1].position = {-1, 0, 1, 0, 1, 0, 0, 0, 0};  // at 45 degrees to both
  parts[1].indices = {0, 2, 1};
  const Deadline deadline(60);
  add_creased_normals(parts, 2, kLimits, deadline);
  assert_int_equal(parts[0].position.size(), 6 * 3);
  assert_int_equal(parts[0].uv.size(), 6 * 2);
  for (const uint32_t i : parts[0].indices) {
    const float* const p = &parts[0].position[3 * i];
    const float want = p[1] == 1 ? 1 : p[0] == 1 ? 2 : p[2] == 1 ? 3 : 0;
    assert_true(parts[0].uv[2 * i + 1] == want && parts[0].color[4 * i + 2] == want);
  }
  const float* const n = &parts[0].normal[3 * parts[0].indices[0]];  // the mean of (0 0 1) and (1 0 1)
  shd_assert_close("place", 0, static_cast<double>(n[0]), 1 / std::sqrt(5.0), 1e-6, 0);
  shd_assert_close("place", 2, static_cast<double>(n[2]), 2 / std::sqrt(5.0), 1e-6, 0);
}

/// An apex of more faces than the search takes: the mean of all, without quadratic time.
void test_crowd(void**) {
  constexpr uint32_t kFaces = 20000;
  std::vector<CreaseCorner> corners;
  std::vector<Point> faces;
  for (uint32_t i = 0; i < kFaces; ++i) {
    const double angle = 360.0 * kDegree * i / kFaces;
    faces.push_back({2 * std::cos(angle), 2 * std::sin(angle), 1});
    corners.push_back({0, i, kCrease});
  }
  const CornerNormals normals = crease_normals(corners, faces, 1, Deadline(10));
  assert_int_equal(normals.normals.size(), 1);
  shd_assert_close("crowd", 0, normals.normals[0][2], 1, 1e-6, 0);
}

void test_budget(void**) {
  Geometry g;
  g.position = {0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1};
  g.indices = {0, 2, 1, 0, 1, 3};
  Limits limits;
  limits.vertices = 5;
  try {
    add_creased_normals(&g, 1, limits, Deadline(60));
    fail();
  } catch (const shd::core::Failure& failure) {
    assert_non_null(strstr(failure.what(), "max_vertices"));
  }
}

}  // namespace

int main() {
  ADD_ROWS(kBooks, test_book);
  add("both_sides", test_both_sides, nullptr);
  add("columns", test_columns, nullptr);
  add("crowd", test_crowd, nullptr);
  add("budget", test_budget, nullptr);
  return _cmocka_run_group_tests("unit.scene.creases", g_tests, g_count, nullptr, nullptr);
}
