// SPDX-License-Identifier: MIT
// glTF 2.0 meshes, nodes, lights, cameras and animations to models. Right values follow from the specification.
#include <cmath>
#include <limits>

#include "scene/pose.h"
#include "support/gltf_file.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

std::string number(int value) {
  return std::to_string(value);
}

/// A square with one further attribute of `width` numbers, equal in all vertices.
template <class T>
Geometry with_attribute(const char* name, const std::vector<T>& element, bool normalized) {
  GltfFile file;
  std::vector<T> numbers;
  for (int i = 0; i < 4; ++i) numbers.insert(numbers.end(), element.begin(), element.end());
  const int position = file.square(), other = file.column<T>(numbers, element.size(), normalized);
  const std::string text =
      file.with_primitive("\"attributes\":{\"POSITION\":" + number(position) + ",\"" + name + "\":" + number(other) +
                          "},\"indices\":" + number(file.square_indices()));
  const Model model = read_text(text);
  assert_int_equal(model.geometries.size(), 1);
  if (!model.warnings.empty()) fail_msg("%s", warnings_of(model).c_str());
  return model.geometries[0];
}

void assert_row(const char* name, const std::vector<float>& column, const std::vector<double>& want) {
  assert_int_equal(column.size(), 4 * want.size());
  for (size_t i = 0; i < column.size(); ++i) shd_assert_close(name, i, column[i], want[i % want.size()], 1e-7, 1e-7);
}

/// Component types and normalisation (sections 3.6.2.2 and 3.11, KHR_mesh_quantization).
void test_types(void**) {
  assert_row("uv/float", with_attribute<float>("TEXCOORD_0", {0.25f, 2}, false).uv, {0.25, 2});
  assert_row("uv/u8", with_attribute<uint8_t>("TEXCOORD_0", {51, 255}, true).uv, {0.2, 1});
  assert_row("uv/u16", with_attribute<uint16_t>("TEXCOORD_1", {13107, 65535}, true).uv1, {0.2, 1});
  assert_row("uv/i16_plain", with_attribute<int16_t>("TEXCOORD_0", {-3, 2}, false).uv, {-3, 2});
  assert_row("uv/u8_plain", with_attribute<uint8_t>("TEXCOORD_0", {3, 2}, false).uv, {3, 2});
  assert_row("uv/i8", with_attribute<int8_t>("TEXCOORD_0", {-128, 127}, true).uv, {-1, 1});
  assert_row("normal/i8", with_attribute<int8_t>("NORMAL", {0, 0, 127}, true).normal, {0, 0, 1});
  assert_row("normal/i16", with_attribute<int16_t>("NORMAL", {-32767, 0, 0}, true).normal, {-1, 0, 0});
  assert_row("color/float", with_attribute<float>("COLOR_0", {0.25f, 0.5f, 2, 0.75f}, false).color,
             {0.25, 0.5, 2, 0.75});
  assert_row("color/rgb", with_attribute<float>("COLOR_0", {0.25f, 0.5f, 2}, false).color, {0.25, 0.5, 2, 1});
  assert_row("color/u8", with_attribute<uint8_t>("COLOR_0", {51, 102, 255, 0}, true).color, {0.2, 0.4, 1, 0});
  assert_row("color/u16", with_attribute<uint16_t>("COLOR_0", {13107, 0, 65535}, true).color, {0.2, 0, 1, 1});
  assert_row("color/u8_not_normalized", with_attribute<uint8_t>("COLOR_0", {51, 0, 255}, false).color, {0.2, 0, 1, 1});
}

template <class T>
void check_position(const char* name, T one, bool normalized, double want) {
  GltfFile file;
  const int position = file.column<T>({0, 0, 0, one, 0, 0, one, one, 0, 0, one, 0}, 3, normalized);
  const Model model = read_text(file.with_primitive("\"attributes\":{\"POSITION\":" + number(position) +
                                                    "},\"indices\":" + number(file.square_indices())));
  shd_assert_close(name, 0, area_of(model), want, 0, 1e-6);
}

void test_positions(void**) {
  check_position<float>("float", 3, false, 9);
  check_position<uint16_t>("u16", 1000, false, 1e6);
  check_position<int16_t>("i16_normalized", 32767, true, 1);
  check_position<int8_t>("i8", 100, false, 1e4);
  check_position<uint8_t>("u8_normalized", 255, true, 1);
}

/// Indices and modes (section 3.7.2.1): signed area in the plane z = 0, triangles, a warning.
struct Mode {
  const char* name;
  int mode;
  std::vector<uint32_t> indices;
  double area;
  size_t triangles;
  const char* warning;
};

const Mode kModes[] = {
    {"mode/triangles", 4, {0, 1, 2, 0, 2, 3}, 1, 2, ""},
    {"mode/incomplete", 4, {0, 1, 2, 0, 2}, 0.5, 1, ""},
    {"mode/strip", 5, {1, 2, 0, 3}, 1, 2, ""},
    {"mode/fan", 6, {0, 1, 2, 3}, 1, 2, ""},
    {"mode/index_out_of_range", 4, {0, 1, 2, 0, 2, 9}, 0.5, 1, "1 faces with indices out of range"},
    {"mode/huge_index", 4, {0, 1, 2, 0, 2, 0xffffffff}, 0.5, 1, "1 faces with indices out of range"},
    {"mode/points", 0, {0, 1, 2}, 0, 0, "points"},
    {"mode/lines", 1, {0, 1}, 0, 0, "lines"},
    {"mode/line_loop", 2, {0, 1, 2}, 0, 0, "lines"},
    {"mode/line_strip", 3, {0, 1, 2}, 0, 0, "lines"},
};

/// The primitive stands beside a square of area 1, which is drawn in any case.
void test_mode(void** state) {
  const Mode& row = *static_cast<const Mode*>(*state);
  GltfFile file;
  const std::string position = "\"attributes\":{\"POSITION\":" + number(file.square()) + "},\"indices\":";
  const std::string first = position + number(file.column<uint32_t>(row.indices, 1)) + ",\"mode\":" + number(row.mode);
  const Model model = read_text(file.with_primitive(first + "},{" + position + number(file.square_indices())));
  size_t triangles = 0;
  for (const Geometry& g : model.geometries) triangles += g.indices.size() / 3;
  assert_int_equal(triangles, row.triangles + 2);
  shd_assert_close(row.name, 0, area_of(model), row.area + 1, 1e-6, 0);
  assert_true(*row.warning ? has_warning(model, row.warning) : model.warnings.empty());
}

void test_not_finite(void**) {
  GltfFile file;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int good = file.square(), bad = file.column<float>({0, 0, 0, nan, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
  const std::string indices = "},\"indices\":" + number(file.square_indices());
  const Model model = read_text(file.with_primitive("\"attributes\":{\"POSITION\":" + number(good) + indices +
                                                    "},{\"attributes\":{\"POSITION\":" + number(bad) + indices));
  shd_assert_close("area", 0, area_of(model), 1.5, 1e-6, 0);
  assert_true(has_warning(model, "1 faces with indices out of range or positions that are not finite"));
}

/// Section 3.6.2.3: the third corner of a degenerate square moves, also without a buffer view.
void test_sparse(void**) {
  for (const bool base : {true, false}) {
    GltfFile file;
    const std::string floats = GltfFile::bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 0, 0});
    const int view = base ? file.view(floats) : -1;
    const int rows = file.view(GltfFile::bytes_of<uint8_t>({1, 2}));
    const int values = file.view(GltfFile::bytes_of<float>({1, 0, 0, 1, 1, 0}));
    const int position =
        file.accessor(view, 5126, 3, "VEC3",
                      ",\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":" + number(rows) +
                          ",\"componentType\":5121},\"values\":{\"bufferView\":" + number(values) + "}}");
    const Model model = read_text(file.with_primitive("\"attributes\":{\"POSITION\":" + number(position) + "}"));
    shd_assert_close("area", base, area_of(model), 0.5, 1e-6, 0);
  }
}

/// Positions and texture coordinates in one view of stride 20, each from its offset on.
void test_interleaved(void**) {
  GltfFile file;
  const int view = file.view(GltfFile::bytes_of<float>({0, 0, 0, .1f, .2f, 1, 0, 0, .3f, .4f, 1, 1, 0, .5f, .6f}),
                             ",\"byteStride\":20");
  const int position = file.accessor(view, 5126, 3, "VEC3"),
            uv = file.accessor(view, 5126, 3, "VEC2", ",\"byteOffset\":12");
  const Model model = read_text(
      file.with_primitive("\"attributes\":{\"POSITION\":" + number(position) + ",\"TEXCOORD_0\":" + number(uv) + "}"));
  shd_assert_close("area", 0, area_of(model), 0.5, 1e-6, 0);
  for (size_t i = 0; i < 6; ++i) shd_assert_close("uv", i, model.geometries[0].uv[i], 0.1 * double(i + 1), 1e-6, 0);
}

/// Section 3.7.2.1: without normals they are flat, and tangents are ignored.
void test_flat(void**) {
  GltfFile file;
  const int position = file.square(), tangent = file.column<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, 4);
  const Model model = read_text(file.with_primitive("\"attributes\":{\"POSITION\":" + number(position) +
                                                    ",\"TANGENT\":" + number(tangent) + "}"));
  assert_true(model.geometries[0].shading == Shading::kFlat && model.geometries[0].tangent.empty());
  assert_true(with_attribute<float>("NORMAL", {0, 0, 1}, false).shading == Shading::kSmooth);
}

/// Vertices that no triangle uses are left out, so that primitives may share long accessors.
void test_shared_accessor(void**) {
  GltfFile file;
  std::vector<float> numbers(3 * 1000);
  for (size_t i = 0; i < 1000; ++i) numbers[3 * i] = float(i), numbers[3 * i + 1] = float(i * i);
  const int position = file.column<float>(numbers, 3), indices = file.column<uint16_t>({997, 999, 998}, 1);
  Limits limits;
  limits.vertices = 3;
  const Model model = read_text(
      file.with_primitive("\"attributes\":{\"POSITION\":" + number(position) + "},\"indices\":" + number(indices)), "m",
      {}, limits);
  assert_int_equal(model.geometries[0].position.size(), 9);
  shd_assert_close("x", 0, model.geometries[0].position[3 * model.geometries[0].indices[1]], 999, 0, 0);
}

/// A square, and nodes and other members.
std::string square_scene(const std::string& nodes, const std::string& members = "", const std::string& scene = "0") {
  GltfFile file;
  const int position = file.square(), indices = file.square_indices();
  file.members = ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + number(position) +
                 "},\"indices\":" + number(indices) + "}]}],\"scenes\":[{\"nodes\":[" + scene + "]}],\"nodes\":[" +
                 nodes + "]" + members;
  return file.text();
}

void test_nodes(void**) {
  const Model model =
      read_text(square_scene("{\"translation\":[4000000.125,0,0],\"rotation\":[0,0,1,1],\"children\":[1]},"
                             "{\"matrix\":[2,0,0,0,0,3,0,0,0,0,1,0,5,6,7,1],\"mesh\":0},{\"mesh\":0}"));
  assert_int_equal(model.placements.size(), 1);  // the third node is in no scene
  const Matrix m = place(model)[0].object_to_world;
  const double want[16] = {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 3999994.125, 5, 7, 1};
  for (size_t i = 0; i < 16; ++i) shd_assert_close("matrix", i, m[i], want[i], 1e-9, 0);
}

/// A root of the scene has a parent outside of it: the parent is left out.
void test_outer_parent(void**) {
  const Model model =
      read_text(square_scene("{\"translation\":[5,0,0],\"children\":[1]},{\"mesh\":0,\"name\":\"root\"}", "", "1"));
  assert_int_equal(model.placements.size(), 1);
  shd_assert_close("x", 0, place(model)[0].object_to_world[12], 0, 0, 0);
  if (!has_warning(model, "node \"root\": a parent outside the scene is left out"))
    fail_msg("%s", warnings_of(model).c_str());
}

void test_scenes(void**) {
  GltfFile file;
  const std::string mesh =
      ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + number(file.square()) + "}}]}]";
  file.members = mesh +
                 ",\"scene\":1,\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1,2],\"name\":\"b\"}],"
                 "\"nodes\":[{\"mesh\":0},{\"mesh\":0},{\"mesh\":0}]";
  Model model = read_text(file.text());
  assert_int_equal(model.placements.size(), 2);
  assert_true(has_warning(model, "scene \"b\" is drawn"));
  file.members = mesh + ",\"nodes\":[{\"mesh\":0,\"children\":[1]},{\"mesh\":0}]";
  assert_int_equal(read_text(file.text()).placements.size(), 2);
}

/// EXT_mesh_gpu_instancing: copies of translation, rotation and scale; integers of rotations are normalised.
void test_instancing(void**) {
  GltfFile file;
  const int position = file.square(), t = file.column<float>({0, 0, 0, 2, 0, 0}, 3),
            r = file.column<int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}, 4, true),
            s = file.column<float>({1, 1, 1, 3, 3, 3}, 3);
  file.members =
      ",\"scenes\":[{\"nodes\":[0]}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + number(position) +
      "}}]}],\"nodes\":[{\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{"
      "\"attributes\":{\"TRANSLATION\":" +
      number(t) + ",\"ROTATION\":" + number(r) + ",\"SCALE\":" + number(s) + "}}}}]";
  const Model model = read_text(file.text());
  assert_true(model.warnings.empty());
  assert_int_equal(model.placements[0].copies.size(), 2);
  const Matrix& m = model.placements[0].copies[1];  // half a turn about z
  const double want[16] = {-3, 0, 0, 0, 0, -3, 0, 0, 0, 0, 3, 0, 2, 0, 0, 1};
  for (size_t i = 0; i < 16; ++i) shd_assert_close("copy", i, m[i], want[i], 1e-6, 0);
}

/// Section 3.7.2.2: weights of the node, else of the mesh.
void test_morph(void**) {
  GltfFile file;
  const std::string position = number(file.square());
  const std::string target = number(file.column<float>({0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0}, 3));
  file.members =
      ",\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"weights\":[0.25]}],\"meshes\":[{"
      "\"weights\":[0.5],\"primitives\":[{\"attributes\":{\"POSITION\":" +
      position + "},\"targets\":[{\"POSITION\":" + target + "}]}]}]";
  const Model model = read_text(file.text());
  assert_int_equal(model.geometries[0].morphs.size(), 1);
  assert_int_equal(model.geometries[0].morphs[0].position.size(), model.geometries[0].position.size());
  shd_assert_close("mesh", 0, model.nodes[0].weights[0], 0.5, 0, 0);
  shd_assert_close("node", 0, model.nodes[1].weights[0], 0.25, 0, 0);
}

/// Section 3.7.3.3: joints of a skin, two sets of four, inverse bind matrices.
void test_skin(void**) {
  GltfFile file;
  std::vector<uint8_t> first, second;
  std::vector<uint16_t> half;
  for (int i = 0; i < 4; ++i) {
    first.insert(first.end(), {0, 1, 0, 0});
    second.insert(second.end(), {1, 0, 0, 0});
    half.insert(half.end(), {32768, 0, 0, 0});
  }
  const int position = file.square(), j0 = file.column<uint8_t>(first, 4), w0 = file.column<uint16_t>(half, 4, true),
            j1 = file.column<uint8_t>(second, 4);
  const int bind = file.column<float>(
      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}, 16);
  file.members =
      ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"skin\":0},{},{}],\"skins\":[{\"joints\":[1,2],"
      "\"inverseBindMatrices\":" +
      number(bind) + "}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + number(position) +
      ",\"JOINTS_0\":" + number(j0) + ",\"WEIGHTS_0\":" + number(w0) + ",\"JOINTS_1\":" + number(j1) +
      ",\"WEIGHTS_1\":" + number(w0) + "}}]}]";
  const Model model = read_text(file.text());
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.influences, 8);
  assert_int_equal(g.joint[1], 1);
  assert_int_equal(g.joint[4], 1);
  shd_assert_close("weight", 0, g.weight[4], 32768.0 / 65535.0, 1e-6, 0);
  assert_int_equal(model.placements[0].skin, 0);
  assert_int_equal(model.skins[0].joints.size(), 2);
  shd_assert_close("bind", 0, model.skins[0].inverse_binds[1][12], 5, 0, 0);
}

/// Appendix C: the values of a channel by their interpolation.
void test_animation(void**) {
  GltfFile file;
  const int position = file.square(), times = file.column<float>({0, 2}, 1),
            t = file.column<float>({0, 0, 0, 4, 0, 0}, 3);
  const int r = file.column<int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}, 4, true);
  const int cubic = file.column<float>({0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0}, 3);
  const auto sampler = [&](int output, const char* how) {
    return "{\"input\":" + number(times) + ",\"output\":" + number(output) + ",\"interpolation\":\"" + how + "\"}";
  };
  file.members =
      ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{"
      "\"POSITION\":" +
      number(position) +
      "}}]}],\"animations\":[{\"name\":\"a\",\"channels\":["
      "{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
      "{\"sampler\":1,\"target\":{\"node\":0,\"path\":\"rotation\"}},"
      "{\"sampler\":2,\"target\":{\"node\":0,\"path\":\"scale\"}}],\"samplers\":[" +
      sampler(t, "STEP") + "," + sampler(r, "LINEAR") + "," + sampler(cubic, "CUBICSPLINE") + "]}]";
  const Model model = read_text(file.text());
  if (!model.warnings.empty()) fail_msg("%s", warnings_of(model).c_str());
  assert_int_equal(model.animations.size(), 1);
  const std::vector<Channel>& c = model.animations[0].channels;
  assert_int_equal(c.size(), 3);
  assert_true(c[0].interpolation == Interpolation::kStep && c[0].target == Target::kTranslation);
  assert_true(c[1].interpolation == Interpolation::kLinear && c[2].interpolation == Interpolation::kCubicSpline);
  shd_assert_close("rotation", 0, c[1].values[6], 1, 1e-6, 0);
  shd_assert_close("moved", 0, pose_of(model, &model.animations[0], 2).worlds[0][12], 4, 1e-6, 0);
  shd_assert_close("scaled", 0, pose_of(model, &model.animations[0], 1).worlds[0][10], 1.5, 1e-6, 0);
}

void test_stage(void**) {
  const Model model = read_text(square_scene(
      "{\"mesh\":0,\"children\":[1]},{\"camera\":0,\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}},{\"camera\":"
      "1},"
      "{\"extensions\":{\"KHR_lights_punctual\":{\"light\":1}}}",
      ",\"cameras\":[{\"type\":\"perspective\",\"name\":\"c\",\"perspective\":{\"yfov\":0.75,\"aspectRatio\":2,"
      "\"znear\":0.5}},"
      "{\"type\":\"orthographic\",\"name\":\"flat\",\"orthographic\":{\"xmag\":1,\"ymag\":1,\"znear\":0,\"zfar\":1}}],"
      "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"spot\",\"color\":[1,0.5,0],\"intensity\":8,"
      "\"range\":6,\"spot\":{\"innerConeAngle\":0.25,\"outerConeAngle\":0.5}},{\"type\":\"directional\"}]}}",
      "0,2,3"));
  assert_int_equal(model.cameras.size(), 1);
  shd_assert_close("yfov", 0, model.cameras[0].camera.fov_y, 0.75, 1e-6, 0);
  assert_true(model.cameras[0].camera.far_plane == 0.0f && model.cameras[0].node == 1);
  assert_true(has_warning(model, "camera \"flat\"") && has_warning(model, "no perspective"));
  assert_int_equal(model.lights.size(), 2);
  const shd_light_desc& spot = model.lights[0].desc;
  assert_true(spot.kind == SHD_LIGHT_KIND_SPOT && spot.intensity[1] == 4 && spot.range == 6 && spot.direction[2] == -1);
  shd_assert_close("outer", 0, spot.outer_angle, 0.5, 0, 0);
  assert_true(model.lights[1].desc.kind == SHD_LIGHT_KIND_DIRECTIONAL && model.lights[1].desc.intensity[0] == 1);
}

void test_variants(void**) {
  GltfFile file;
  const Model model = read_text(file.with_primitive(
      "\"attributes\":{\"POSITION\":" + number(file.square()) +
          "},\"material\":0,\"extensions\":{\"KHR_materials_variants\":"
          "{\"mappings\":[{\"material\":0,\"variants\":[1]},{\"material\":1,\"variants\":[0,2]}]}}",
      ",\"materials\":[{\"name\":\"x\"},{\"name\":\"y\"}],\"extensions\":{\"KHR_materials_variants\":{\"variants\":["
      "{\"name\":\"one\"},{\"name\":\"two\"},{\"name\":\"three\"}]}}"));
  assert_string_equal(model.surfaces[model.placements[0].surface].name.c_str(), "y");
  assert_true(has_warning(model, "\"two\", \"three\""));
}

}  // namespace

int main() {
  ADD_ROWS(kModes, test_mode);
  add("types", test_types, nullptr);
  add("positions", test_positions, nullptr);
  add("not_finite", test_not_finite, nullptr);
  add("sparse", test_sparse, nullptr);
  add("interleaved", test_interleaved, nullptr);
  add("flat", test_flat, nullptr);
  add("shared_accessor", test_shared_accessor, nullptr);
  add("nodes", test_nodes, nullptr);
  add("outer_parent", test_outer_parent, nullptr);
  add("scenes", test_scenes, nullptr);
  add("instancing", test_instancing, nullptr);
  add("morph", test_morph, nullptr);
  add("skin", test_skin, nullptr);
  add("animation", test_animation, nullptr);
  add("stage", test_stage, nullptr);
  add("variants", test_variants, nullptr);
  return _cmocka_run_group_tests("unit.scene.gltf", g_tests, g_count, nullptr, nullptr);
}
