// SPDX-License-Identifier: MIT
// PLY files to models (Turk, "The PLY Polygon File Format", 1994): text and binary of both byte orders, every type,
// polygons and strips, colours of vertices and faces, textures, and files that are damaged.
#include <cmath>
#include <cstring>

#include "core/failure.h"
#include "support/model_mutants.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

#define POSITIONS "property float x\nproperty float y\nproperty float z\n"
#define RGB "property uchar red\nproperty uchar green\nproperty uchar blue\n"
#define FACE "element face 1\nproperty list uchar int vertex_indices\n"
#define DATA "end_header\n"

/// A text file of three vertices.
std::string text_of_triangle(const std::string& vertex, const std::string& faces, const std::string& row = "") {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\n" POSITIONS + vertex + faces;
  for (const char* position : {"0 0 0", "1 0 0", "1 1 0"}) text.insert(text.size(), position + row + "\n");
  return text;
}

struct Text {
  const char *name, *text;
  size_t triangles;
  const char* warning;  // "" = none
};

#define SQUARE "ply\nformat ascii 1.0\nelement vertex 4\n" POSITIONS
#define CORNERS "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"

const Text kTexts[] = {
    {"text/polygon", SQUARE FACE DATA CORNERS "4 0 1 2 3\n", 2, ""},
    {"text/vertex_index", SQUARE "element face 1\nproperty list uchar uint vertex_index\n" DATA CORNERS "4 0 1 2 3\n",
     2, ""},
    {"text/line_ends",
     "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
     "property float z\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
     "0 0 0\r\n1 0 0\r\n1 1 0\r\n3 0 1 2\r\n",
     1, ""},
    {"text/comments",
     "ply\nformat ascii 1.0\ncomment of C:\\models\\\nobj_info by hand\nelement vertex 4\n" POSITIONS FACE DATA
     "comment here\ncomment\n" CORNERS "4 0 1 2 3\n",
     2, ""},
    {"text/blank_after_ply", "ply \nformat ascii 1.0\nelement vertex 4\n" POSITIONS FACE DATA CORNERS "4 0 1 2 3\n", 2,
     ""},
    {"text/no_corner_uvs",
     SQUARE "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n" DATA CORNERS
            "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 0\n",
     2, "faces without texture coordinates"},
    {"text/faces_first", "ply\nformat ascii 1.0\n" FACE "element vertex 4\n" POSITIONS DATA "4 0 1 2 3\n" CORNERS, 2,
     ""},
    {"text/strip",
     SQUARE "element tristrips 1\nproperty list int int vertex_indices\n" DATA CORNERS "8 0 1 3 2 -1 0 1 2\n", 3, ""},
    {"text/joined_strip",
     SQUARE "element tristrips 1\nproperty list int int vertex_indices\n" DATA CORNERS "5 0 1 3 3 2\n", 1, ""},
    {"text/edges",
     SQUARE FACE "element edge 1\nproperty int vertex1\nproperty int vertex2\n" DATA CORNERS "4 0 1 2 3\n0 1\n", 2,
     "PLY: element \"edge\" is left out"},
    {"text/quality",
     "ply\nformat ascii 1.0\nelement vertex 4\n" POSITIONS "property float quality\n" FACE DATA
     "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n4 0 1 2 3\n",
     2, "PLY: property \"quality\" of element \"vertex\" is left out"},
    {"text/further", SQUARE FACE DATA CORNERS "4 0 1 2 3 9\n", 2, "rows of element \"face\" have further numbers"},
    {"text/index",
     SQUARE "element face 2\nproperty list uchar int vertex_indices\n" DATA CORNERS "4 0 1 2 3\n3 0 1 4\n", 2,
     "1 faces with indices out of range"},
    {"text/negative_index",
     SQUARE "element face 2\nproperty list uchar int vertex_indices\n" DATA CORNERS "4 0 1 2 3\n3 0 1 -1\n", 2,
     "1 faces with indices out of range"},
    {"text/nan",
     "ply\nformat ascii 1.0\nelement vertex 5\n" POSITIONS "element face 2\n"
     "property list uchar int vertex_indices\n" DATA CORNERS "nan 0 0\n4 0 1 2 3\n3 0 1 4\n",
     2, "1 faces with indices out of range or positions that are not finite"},
    {"text/empty_face", SQUARE "element face 2\nproperty list uchar int vertex_indices\n" DATA CORNERS "4 0 1 2 3\n0\n",
     2, "1 faces"},
};

void test_text(void** state) {
  const Text& row = *static_cast<const Text*>(*state);
  const Model model = read_text(row.text, "m.ply");
  assert_int_equal(model.geometries.size(), 1);
  assert_int_equal(model.geometries[0].indices.size(), 3 * row.triangles);
  if (*row.warning ? !has_warning(model, row.warning) : !model.warnings.empty()) {
    fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
  }
  shd_assert_close(row.name, 0, area_of(model), 0.5 * static_cast<double>(row.triangles), 0, 0);
}

/// A value in a type, in one byte order.
template <class Number>
void append(std::string& out, double value, bool big) {
  const auto number = static_cast<Number>(value);
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  for (size_t i = 0; i < sizeof number; ++i) out.push_back(bytes[big ? sizeof number - 1 - i : i]);
}

struct Type {
  const char *name, *word;
  void (*append)(std::string& out, double value, bool big);
};

const Type kTypes[] = {
    {"binary/char", "char", append<int8_t>},    {"binary/uint8", "uint8", append<uint8_t>},
    {"binary/short", "short", append<int16_t>}, {"binary/uint16", "uint16", append<uint16_t>},
    {"binary/int", "int", append<int32_t>},     {"binary/uint32", "uint32", append<uint32_t>},
    {"binary/float", "float32", append<float>}, {"binary/double", "double", append<double>},
};

/// Positions, a property to skip, and indices of one type in both byte orders.
void test_binary(void** state) {
  const Type& row = *static_cast<const Type*>(*state);
  for (const bool big : {false, true}) {
    const std::string type = row.word;
    std::string file = std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
                       " 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " + type + " skipped\nproperty " +
                       type + " y\nproperty " + type + " z\nelement face 1\nproperty list " + type + " " + type +
                       " vertex_indices\nend_header\n";
    for (const double value : {0, 99, 0, 5, 100, 99, 0, 5, 100, 99, 50, 5, 3, 0, 1, 2}) row.append(file, value, big);
    const Model model = read_text(file, "m.ply");
    shd_assert_close(row.name, big, area_of(model), 2500, 0, 0);
    assert_true(model.geometries[0].position[2] + model.geometries[0].origin[2] == 5);
    assert_true(has_warning(model, "property \"skipped\""));
  }
}

/// Text and binary, with colours of faces, texture coordinates of corners and a strip.
void test_mutants(void**) {
  assert_mutants_end(
      text_of_triangle(RGB, FACE "property list uchar float texcoord\n" DATA, " 1 2 3") + "3 0 1 2 6 0 0 1 0 1 1\n",
      "m.ply", 4);
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" POSITIONS FACE RGB
                     "element tristrips 1\nproperty list int int vertex_indices\n" DATA;
  for (const double value : {0, 0, 0, 1, 0, 0, 1, 1, 0}) append<float>(file, value, false);
  append<uint8_t>(file, 3, false);
  for (const double value : {0, 1, 2}) append<int32_t>(file, value, false);
  for (const double value : {255, 0, 9}) append<uint8_t>(file, value, false);
  for (const double value : {4, 0, 1, 2, 0}) append<int32_t>(file, value, false);
  assert_mutants_end(file, "m.ply", 4);
}

struct ColorRow {
  const char *name, *vertex, *face, *vertex_row, *face_row;
  float color[4];
  bool blends;
};

const float kLinear188 = 0.5028865f;

const ColorRow kColors[] = {
    {"colors/uchar", RGB, "", " 255 0 188", "", {1, 0, kLinear188, 1}, false},
    {"colors/alpha", RGB "property uchar alpha\n", "", " 255 0 188 51", "", {1, 0, kLinear188, 0.2f}, true},
    {"colors/opaque", RGB "property uchar alpha\n", "", " 255 0 188 255", "", {1, 0, kLinear188, 1}, false},
    {"colors/ushort",
     "property ushort r\nproperty ushort g\nproperty ushort b\n",
     "",
     " 65535 0 48316",
     "",
     {1, 0, kLinear188, 1},
     false},
    {"colors/int_codes",
     "property int red\nproperty int green\nproperty int blue\n",
     "",
     " 255 0 188",
     "",
     {1, 0, kLinear188, 1},
     false},
    {"colors/float_codes",
     "property float red\nproperty float green\nproperty float blue\n",
     "",
     " 255 0 188",
     "",
     {1, 0, kLinear188, 1},
     false},
    {"colors/float",
     "property float diffuse_red\nproperty float diffuse_green\nproperty float diffuse_blue\n",
     "",
     " 1 0 0.73725490196",
     "",
     {1, 0, kLinear188, 1},
     false},
    {"colors/face", "", RGB, "", " 255 0 188", {1, 0, kLinear188, 1}, false},
};

/// Integers are sRGB codes of the type's range. The grey of files without material is white under colours.
void test_colors(void** state) {
  const ColorRow& row = *static_cast<const ColorRow*>(*state);
  const Model model = read_text(text_of_triangle(row.vertex, std::string(FACE) + row.face + DATA, row.vertex_row) +
                                    "3 0 1 2" + row.face_row + "\n",
                                "m.ply");
  const Geometry& g = model.geometries[0];
  const Surface& surface = model.surfaces[model.placements[0].surface];
  assert_int_equal(g.color.size(), 12);
  for (size_t i = 0; i < 12; ++i) {
    shd_assert_close("colour", i, static_cast<double>(g.color[i]), static_cast<double>(row.color[i % 4]), 1e-5, 0);
  }
  assert_true(surface.diffuse[0] == 1);
  assert_true((surface.alpha == Alpha::kBlend) == row.blends);
  assert_true(model.warnings.empty());
}

/// Two faces with colours of their own at 45 degrees: their common edge stays smooth, as without colours.
void test_face_colors(void**) {
  const Model model = read_text("ply\nformat ascii 1.0\nelement vertex 4\n" POSITIONS
                                "element face 2\nproperty list uchar int vertex_indices\n" RGB DATA
                                "0 0 0\n1 0 0\n0 1 0\n-1 0 1\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n",
                                "m.ply");
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.position.size() / 3, 6);
  for (size_t i = 0; i < 6; ++i) {
    const float* const p = &g.position[3 * i];
    const bool shared = p[0] == 0 && p[2] == 0;
    const double wanted = shared ? std::sqrt(0.2) : p[0] > 0 ? 0 : std::sqrt(0.5);  // mean (1 0 2) / sqrt(5)
    shd_assert_close("normal.x", i, static_cast<double>(g.normal[3 * i]), wanted, 1e-6, 0);
  }
  const uint32_t *first = &g.indices[0], *second = &g.indices[3];
  assert_true(g.color[4 * first[0]] == 1 && g.color[4 * second[0]] == 0 && g.color[4 * second[0] + 2] == 1);
}

/// A file whose vertices have colours, too: these count.
void test_both_colors(void**) {
  const Model model = read_text(text_of_triangle(RGB, FACE RGB DATA, " 255 255 255") + "3 0 1 2 255 0 0\n", "m.ply");
  assert_true(model.geometries[0].color[1] == 1);
  assert_true(has_warning(model, "property \"red\" of element \"face\""));
}

/// Names keep blanks inside; MeshLab writes one behind. v grows downwards in a Model.
void test_texture(void**) {
  std::string text = text_of_triangle("property float s\nproperty float t\n", FACE DATA, " 0.25 0.75") + "3 0 1 2\n";
  text.insert(text.find("element"), "comment TextureFile my map.png \n");
  const Model model = read_text(text, "m.ply");
  assert_int_equal(model.textures.size(), 1);
  assert_string_equal(model.textures[0].name.c_str(), "my map.png");
  assert_true(model.geometries[0].uv[0] == 0.25f && model.geometries[0].uv[1] == 0.25f);
  assert_true(model.surfaces[0].maps[SHD_SLOT_DIFFUSE].texture == 0 && model.surfaces[0].diffuse[0] == 1);
}

/// Texture coordinates of corners, and two textures by number.
void test_corner_uvs(void**) {
  const Model model = read_text(
      "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
      "element vertex 4\n" POSITIONS
      "element face 2\nproperty list uchar int vertex_indices\n"
      "property list uchar float texcoord\nproperty int texnumber\n" DATA CORNERS
      "3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 0.5 0.5 1 1 0 1 1\n",
      "m.ply");
  assert_int_equal(model.geometries.size(), 2);
  assert_int_equal(model.textures.size(), 2);
  for (size_t i = 0; i < 2; ++i) {
    const int32_t texture = model.surfaces[model.placements[i].surface].maps[SHD_SLOT_DIFFUSE].texture;
    assert_int_equal(texture, i);
    assert_true(model.geometries[i].uv[2 * model.geometries[i].indices[0]] == 0.5f * static_cast<float>(i));
  }
  assert_true(model.warnings.empty());
}

/// Positions are doubles, far away too.
void test_far(void**) {
  const Model model = read_text(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\n" FACE DATA "4080928.25 408201 0\n4080928.5 408201 0\n4080928.5 408201.125 0\n3 0 1 2\n",
      "m.ply");
  const Geometry& g = model.geometries[0];
  assert_true(static_cast<double>(g.position[0]) + g.origin[0] == 4080928.25);
  shd_assert_close("area", 0, area_of(model), 0.015625, 0, 0);
  assert_true(model.warnings.empty());
}

/// A number of no texture: no texture for its faces.
void test_texture_numbers(void**) {
  const struct {
    const char *number, *warning;
  } rows[] = {{"-1", ""}, {"1", "texnumber"}, {"-2", "texnumber"}, {"nan", "texnumber"}};
  for (const auto& row : rows) {
    std::string text = text_of_triangle("property float s\nproperty float t\n",
                                        "element face 2\nproperty list uchar int vertex_indices\n"
                                        "property float texnumber\n" DATA,
                                        " 0 0") +
                       "3 0 1 2 0\n3 2 1 0 " + row.number + "\n";
    text.insert(text.find("element"), "comment TextureFile a.png\n");
    const Model model = read_text(text, "m.ply");
    assert_int_equal(model.geometries.size(), 2);
    for (size_t i = 0; i < 2; ++i) {
      const int32_t texture = model.surfaces[model.placements[i].surface].maps[SHD_SLOT_DIFFUSE].texture;
      assert_int_equal(texture, i == 0 ? 0 : -1);
    }
    assert_true(*row.warning ? has_warning(model, row.warning) : model.warnings.empty());
  }
}

/// Properties that count together are left out together.
void test_incomplete(void**) {
  const struct {
    const char *properties, *row, *warning;
  } rows[] = {{"property uchar red\nproperty uchar alpha\n", " 255 0", "property \"red\""},
              {"property uchar red\nproperty uchar alpha\n", " 255 0", "property \"alpha\""},
              {"property float nx\nproperty float nz\n", " 0 1", "property \"nz\""},
              {"property float s\n", " 1", "property \"s\""}};
  for (const auto& row : rows) {
    const Model model = read_text(text_of_triangle(row.properties, FACE DATA, row.row) + "3 0 1 2\n", "m.ply");
    if (!has_warning(model, row.warning)) fail_msg("%s: %s", row.warning, warnings_of(model).c_str());
    assert_true(model.geometries[0].color.empty() && model.geometries[0].uv.empty());
    assert_true(model.geometries[0].normal[2] == 1);
  }
}

struct Bad {
  const char *name, *text;
  shd_result result;
  const char* message;
};

const Bad kBad[] = {
    {"bad/no_end", "ply\nformat ascii 1.0\n", SHD_ERROR_CORRUPT, "the header has no end"},
    {"bad/format", "ply\nformat binary 1.0\n" DATA, SHD_ERROR_UNSUPPORTED, "format \"binary\""},
    {"bad/type", "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n" DATA, SHD_ERROR_CORRUPT,
     "\"half\" is no type"},
    {"bad/count", "ply\nformat ascii 1.0\nelement vertex -1\n" DATA, SHD_ERROR_CORRUPT, "\"vertex\" has no count"},
    {"bad/count_range", "ply\nformat ascii 1.0\nelement face 4294967296\n" DATA, SHD_ERROR_CORRUPT, "has no count"},
    {"bad/limit", "ply\nformat ascii 1.0\nelement vertex 4000000000\n" POSITIONS FACE DATA, SHD_ERROR_LIMIT,
     "max_vertices"},
    {"bad/property", "ply\nformat ascii 1.0\nproperty float x\n" DATA, SHD_ERROR_CORRUPT, "before the first element"},
    {"bad/no_vertices", "ply\nformat ascii 1.0\n" FACE DATA "3 0 1 2\n", SHD_ERROR_CORRUPT, "x, y and z"},
    {"bad/no_z",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n" FACE DATA "0 0\n3 0 0 0\n",
     SHD_ERROR_CORRUPT, "x, y and z"},
    {"bad/short_row", SQUARE FACE DATA "0 0\n", SHD_ERROR_CORRUPT, "row 0 of element \"vertex\": too few numbers"},
    {"bad/short_file", SQUARE FACE DATA CORNERS, SHD_ERROR_CORRUPT, "row 0 of element \"face\": the file ends"},
    {"bad/no_length", SQUARE FACE DATA CORNERS "x\n", SHD_ERROR_CORRUPT, "a list without a length"},
    {"bad/length", SQUARE FACE DATA CORNERS "1e15 0 1 2\n", SHD_ERROR_CORRUPT, "longer than the file"},
    {"bad/negative_length", SQUARE FACE DATA CORNERS "-3 0 1 2\n", SHD_ERROR_CORRUPT, "longer than the file"},
    {"bad/points", SQUARE DATA CORNERS, SHD_ERROR_UNSUPPORTED, "it has points and no faces"},
    {"bad/texcoord", SQUARE FACE "property list uchar float texcoord\n" DATA CORNERS "4 0 1 2 3 2 0 0\n",
     SHD_ERROR_CORRUPT, "face 0 has no texture coordinates for each corner"},
};

void test_bad(void** state) {
  const Bad& row = *static_cast<const Bad*>(*state);
  try {
    read_text(row.text, "m.ply");
  } catch (const shd::core::Failure& failure) {
    assert_int_equal(failure.code, row.result);
    if (!std::strstr(failure.what(), row.message)) fail_msg("%s: \"%s\"", row.name, failure.what());
    return;
  }
  fail_msg("%s is read", row.name);
}

}  // namespace

int main() {
  ADD_ROWS(kTexts, test_text);
  ADD_ROWS(kTypes, test_binary);
  ADD_ROWS(kColors, test_colors);
  add("mutants", test_mutants, nullptr);
  add("face_colors", test_face_colors, nullptr);
  add("both_colors", test_both_colors, nullptr);
  add("texture", test_texture, nullptr);
  add("corner_uvs", test_corner_uvs, nullptr);
  add("texture_numbers", test_texture_numbers, nullptr);
  add("incomplete", test_incomplete, nullptr);
  add("far", test_far, nullptr);
  ADD_ROWS(kBad, test_bad);
  return _cmocka_run_group_tests("unit.scene.ply", g_tests, g_count, nullptr, nullptr);
}
