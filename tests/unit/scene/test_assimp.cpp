// SPDX-License-Identifier: MIT
// Formats that assimp reads: normals, vertices and parts that the picture has not.
#include <cmath>

#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

/// A source of Collada with three vectors.
std::string source(const std::string& id, const std::string& numbers) {
  return "<source id=\"" + id + "\"><float_array id=\"" + id + "a\" count=\"9\">" + numbers +
         "</float_array><technique_common><accessor source=\"#" + id +
         "a\" count=\"3\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
         "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>";
}

/// A Collada file of one triangle, and of a line between two of its vertices. normals: "" = none.
std::string collada(const std::string& positions, const std::string& normals = "") {
  const std::string input = normals.empty() ? "" : "<input semantic=\"NORMAL\" source=\"#n\"/>";
  return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
         "<asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id=\"g\"><mesh>" +
         source("p", positions) + (normals.empty() ? "" : source("n", normals)) +
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>" + input +
         "</vertices><triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p>"
         "</triangles><lines count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1</p></lines>"
         "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\"><node id=\"n0\">"
         "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
         "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
}

struct Normals {
  const char *name, *normal;
  float z;
  bool warned;
};

const Normals kNormals[] = {
    {"normals/good", "0 0 1 ", 1, false},
    {"normals/zero", "0 0 0 ", 0, true},
    {"normals/nan", "nan nan nan ", 0, true},
};

void test_normals(void** state) {
  const Normals& row = *static_cast<const Normals*>(*state);
  const std::string normal = row.normal;
  const Model model = read_text(collada("0 0 0 1 0 0 1 1 0", normal + normal + normal), "m.dae");
  assert_true(model.geometries[0].normal[2] == row.z);
  assert_true(has_warning(model, "normals of length 0") == row.warned);
}

/// Vertices are not moved together, however near.
void test_near(void**) {
  const Model model = read_text(collada("0 0 0 1e-8 0 0 1e-8 1e-8 0"), "m.dae");
  assert_int_equal(model.geometries[0].position.size(), 9);
  shd_assert_close("area", 0, area_of(model), 0.5e-16, 0, 1e-5);
}

/// Far from the origin floats lose detail before the model is seen.
void test_far(void**) {
  const Model model = read_text(collada("4080928 0 0 4080929 0 0 4080929 1 0"), "m.dae");
  assert_true(has_warning(model, "lose detail"));
  shd_assert_close("x", 0, model.geometries[0].position[0] + model.geometries[0].origin[0], 4080928, 0, 0);
  shd_assert_close("area", 0, area_of(model), 0.5, 0, 0);
}

/// Lines are left out, and the file is read. Both sides are drawn.
void test_lines(void**) {
  const Model model = read_text(collada("0 0 0 1 0 0 1 1 0"), "m.dae");
  assert_int_equal(model.geometries.size(), 1);
  assert_int_equal(model.geometries[0].indices.size(), 3);
  assert_true(has_warning(model, "lines and points are left out"));
  assert_true(model.surfaces[model.placements[0].surface].double_sided);
}

}  // namespace

int main() {
  ADD_ROWS(kNormals, test_normals);
  add("near", test_near, nullptr);
  add("far", test_far, nullptr);
  add("lines", test_lines, nullptr);
  return _cmocka_run_group_tests("unit.scene.assimp", g_tests, g_count, nullptr, nullptr);
}
