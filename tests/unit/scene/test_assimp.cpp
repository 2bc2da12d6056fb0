// SPDX-License-Identifier: MIT
// Formats that assimp reads: colours, normals, names and parts that the picture has not.
#include <cmath>

#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

/// A PLY file of one triangle with further properties of the vertices and the face.
std::string ply(const std::string& comment, const std::string& vertex, const std::string& face, const char* rows[3],
                const std::string& face_row) {
  std::string text = "ply\nformat ascii 1.0\n" + comment + "element vertex 3\nproperty float x\nproperty float y\n" +
                     "property float z\n" + vertex + "element face 1\nproperty list uchar int vertex_indices\n" + face +
                     "end_header\n";
  for (int i = 0; i < 3; ++i) text += std::string(rows[i]) + "\n";
  return text + "3 0 1 2" + face_row + "\n";
}

const char* k_plain[3] = {"0 0 0", "1 0 0", "1 1 0"};

/// Colours of PLY vertices are sRGB codes: 188 is 0.503 of linear light. The grey of files without material is white.
void test_ply_colors(void**) {
  const char* rows[3] = {"0 0 0 255 0 188", "1 0 0 255 0 188", "1 1 0 255 0 188"};
  const Model model =
      read_text(ply("", "property uchar red\nproperty uchar green\nproperty uchar blue\n", "", rows, ""), "m.ply");
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.color.size(), 12);
  const double wanted[4] = {1, 0, 0.5028865, 1};
  for (size_t i = 0; i < 12; ++i) shd_assert_close("colour", i, g.color[i], wanted[i % 4], 1e-5, 0);
  assert_true(model.surfaces[model.placements[0].surface].diffuse[0] == 1);
  assert_true(model.warnings.empty());
}

void test_ply_face_colors(void**) {
  const Model model = read_text(
      ply("", "", "property uchar red\nproperty uchar green\nproperty uchar blue\n", k_plain, " 255 0 0"), "m.ply");
  assert_true(model.warnings.size() == 1 && has_warning(model, "colours of faces"));
}

/// MeshLab writes a blank behind the name.
void test_ply_texture(void**) {
  const char* rows[3] = {"0 0 0 0 0", "1 0 0 1 0", "1 1 0 1 1"};
  const Model model = read_text(
      ply("comment TextureFile my map.png \n", "property float s\nproperty float t\n", "", rows, ""), "m.ply");
  assert_int_equal(model.textures.size(), 1);
  assert_string_equal(model.textures[0].name.c_str(), "my map.png");
}

struct Normals {
  const char *name, *normal;
  float z;
  bool warned;
};

const Normals kNormals[] = {
    {"normals/good", " 0 0 1", 1, false},
    {"normals/zero", " 0 0 0", 0, true},
    {"normals/nan", " nan nan nan", 0, true},
};

void test_normals(void** state) {
  const Normals& row = *static_cast<const Normals*>(*state);
  const std::string texts[3] = {std::string("0 0 0") + row.normal, std::string("1 0 0") + row.normal,
                                std::string("1 1 0") + row.normal};
  const char* rows[3] = {texts[0].c_str(), texts[1].c_str(), texts[2].c_str()};
  const Model model =
      read_text(ply("", "property float nx\nproperty float ny\nproperty float nz\n", "", rows, ""), "m.ply");
  assert_true(model.geometries[0].normal[2] == row.z);
  assert_true(has_warning(model, "normals of length 0") == row.warned);
}

/// Vertices are not moved together, however near.
void test_near(void**) {
  const char* rows[3] = {"0 0 0", "1e-8 0 0", "1e-8 1e-8 0"};
  const Model model = read_text(ply("", "", "", rows, ""), "m.ply");
  assert_int_equal(model.geometries[0].position.size(), 9);
  shd_assert_close("area", 0, area_of(model), 0.5e-16, 0, 1e-5);
}

/// Far from the origin floats lose detail before the model is seen.
void test_far(void**) {
  const char* rows[3] = {"4080928 0 0", "4080929 0 0", "4080929 1 0"};
  const Model model = read_text(ply("", "", "", rows, ""), "m.ply");
  assert_true(has_warning(model, "lose detail"));
  shd_assert_close("x", 0, model.geometries[0].position[0] + model.geometries[0].origin[0], 4080928, 0, 0);
  shd_assert_close("area", 0, area_of(model), 0.5, 0, 0);
}

/// A Collada file with triangles and with lines: the lines are left out, and the file is read. Both sides are drawn.
void test_lines(void**) {
  const Model model = read_text(
      "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
      "<asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id=\"g\"><mesh><source id=\"p\">"
      "<float_array id=\"a\" count=\"9\">0 0 0 1 0 0 1 1 0</float_array><technique_common>"
      "<accessor source=\"#a\" count=\"3\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" "
      "type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"
      "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
      "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p></triangles>"
      "<lines count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1</p></lines>"
      "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\"><node id=\"n\">"
      "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
      "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>",
      "m.dae");
  assert_int_equal(model.geometries.size(), 1);
  assert_int_equal(model.geometries[0].indices.size(), 3);
  assert_true(has_warning(model, "lines and points are left out"));
  assert_true(model.surfaces[model.placements[0].surface].double_sided);
}

}  // namespace

int main() {
  add("ply/colors", test_ply_colors, nullptr);
  add("ply/face_colors", test_ply_face_colors, nullptr);
  add("ply/texture", test_ply_texture, nullptr);
  ADD_ROWS(kNormals, test_normals);
  add("near", test_near, nullptr);
  add("far", test_far, nullptr);
  add("lines", test_lines, nullptr);
  return _cmocka_run_group_tests("unit.scene.assimp", g_tests, g_count, nullptr, nullptr);
}
