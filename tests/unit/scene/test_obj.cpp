// SPDX-License-Identifier: MIT
// OBJ files to models, by the format's definition (Wavefront, "Advanced Visualizer", appendix B1): statements, indices,
// polygons, smoothing groups, numbers, sizes. Right values are areas and normals that follow from the texts.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <tuple>

#include "support/model_mutants.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

/// The whole text is one row: its area in the plane z = 0, the number of its triangles and a warning ("" = none).
struct Row {
  const char* name;
  const char* text;
  double area;
  size_t triangles;
  const char* warning;
};

const Row kRows[] = {
    {"triangle", SQUARE "f 1 2 3\n", 0.5, 1, ""},
    {"square", SQUARE "f 1 2 3 4\n", 1, 2, ""},
    {"clockwise", SQUARE "f 4 3 2 1\n", -1, 2, ""},
    {"without_line_end", SQUARE "f 1 2 3", 0.5, 1, ""},
    {"carriage_returns", "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r", 0.5, 1, ""},
    {"crlf", "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n", 0.5, 1, ""},
    {"byte_order_mark", "\xef\xbb\xbf" SQUARE "f 1 2 3 4\n", 1, 2, ""},
    {"comment_first", "# made by hand\n\n" SQUARE "f 1 2 3 4\n", 1, 2, ""},
    {"comment_after_face", SQUARE "f 1 2 3 4 # square\n", 1, 2, ""},
    {"comment_with_backslash", SQUARE "# a\\\nf 1 2 3 4\n", 1, 2, ""},
    {"continued", SQUARE "f -4 -3 \\\n-2 -1\n", 1, 2, ""},
    {"continued_inside_position", "v 0 \\\n0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", 0.5, 1, ""},
    {"continued_at_the_end", SQUARE "f 1 2 3 4 \\", 1, 2, ""},
    {"indented", "  v 0 0 0\n\tv 1 0 0\n v 1 1 0\n   f 1 2 3\n", 0.5, 1, ""},
    {"tabs", "v\t0\t0\t0\nv\t1\t0\t0\nv\t1\t1\t0\nf\t1\t2\t3\t\n", 0.5, 1, ""},
    {"numbers", "v -.5 +0 0e0\nv .5 0. -0\nv 5E-1 1.e0 0\nf 1 2 3\n", 0.5, 1, ""},
    {"number_too_small", "v 1e-999 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", 0.5, 1, ""},
    {"weights", "v 0 0 0 1\nv 1 0 0 1\nv 1 1 0 2\nf 1 2 3\n", 0.5, 1, ""},
    {"mixed_corners", SQUARE "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1 4\n", 1, 2, ""},
    {"negative_among_vertices", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 5 5 5\n", 0.5, 1, ""},
    {"concave", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n", 10, 3, ""},
    {"concave_quad", "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n", 1, 2, ""},
    {"concave_quad_turned", "v 2 1 0\nv 0 2 0\nv 1 1 0\nv 0 0 0\nf 1 2 3 4\n", 1, 2, ""},
    {"middle_of_an_edge", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n", 4, 3, ""},
    {"hole_with_bridge",
     "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n", 12, 8, ""},
    {"lines", SQUARE "f 1 2 3\nl 1 3 2\n", 0.5, 1, "lines are left out"},
    {"points", SQUARE "o a\nf 1 2 3\no b\np 1 2\n", 0.5, 1, "points are left out"},
    {"lod", SQUARE "lod 2\nf 1 2 3 4\n", 1, 2, "\"lod\": left out"},
    {"curves", SQUARE "cstype bezier\ncurv 0 1 1 2 3 4\nend\nf 1 2 3 4\n", 1, 2, "\"curv\": left out"},
    {"odd_line", SQUARE "f one two three\nf 1 2 3 4\n", 1, 2, "line 5: \"f one two three\" is not understood"},
    {"odd_lines", SQUARE "f a b c\nf 1\nf 1 2 3 4\n", 1, 2, "is not understood, and 1 further ones"},
    {"odd_position", "v a b c\n" SQUARE "f 2 3 4 5\n", 1, 2, "line 1: \"v a b c\""},
    {"index_zero", SQUARE "f 1 2 3 4\nf 0 1 2\n", 1, 2, "1 faces with indices out of range"},
    {"index_too_large", SQUARE "f 1 2 3 4\nf 1 2 99\n", 1, 2, "1 faces with indices out of range"},
    {"index_beyond_64_bits", SQUARE "f 1 2 3 4\nf 1 2 99999999999999999999\n", 1, 2, "indices out of range"},
    {"index_before_the_first", SQUARE "f 1 2 3 4\nf -5 1 2\n", 1, 2, "1 faces with indices out of range"},
    {"uv_out_of_range", SQUARE "vt 0 0\nf 1/1 2/1 3/2 4/1\n", 1, 2,
     "texture coordinates or normals with indices out of range at 1 corners of faces"},
    {"normals_that_do_not_exist", SQUARE "f 1//1 2//2 3//3 4//4\n", 1, 2,
     "texture coordinates or normals with indices out of range at 4 corners of faces"},
    {"nan", SQUARE "v nan 0 0\nf 1 2 3 4\nf 1 2 5\n", 1, 2, "1 faces with positions that are not finite"},
    {"infinite", SQUARE "v 1e999 0 0\nf 1 2 3 4\nf 1 2 5\n", 1, 2, "1 faces with positions that are not finite"},
    {"missing_mtl", "mtllib gone.mtl\n" SQUARE "f 1 2 3 4\n", 1, 2, "gone.mtl"},
    {"missing_material", SQUARE "usemtl m\nf 1 2 3 4\n", 1, 2, "material \"m\" is in no MTL file"},
    {"normal_zero", SQUARE "vn 0 0 0\nf 1//1 2//1 3//1\n", 0.5, 1, "normals of length 0 or not finite"},
};

void test_row(void** state) {
  const Row& row = *static_cast<const Row*>(*state);
  const Model model = read_text(row.text);
  size_t triangles = 0;
  for (const Geometry& g : model.geometries) triangles += g.indices.size() / 3;
  assert_int_equal(triangles, row.triangles);
  shd_assert_close(row.name, 0, area_of(model), row.area, 1e-6, 0);
  if (*row.warning ? !has_warning(model, row.warning) : !model.warnings.empty()) {
    fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
  }
}

/// A roof of two slopes, whose ridge is shared: the number of different normals.
struct Roof {
  const char *name, *first, *second;
  size_t normals, vertices;
};

const Roof kRoofs[] = {
    {"groups/none", "", "", 2, 8},  // sharp: the slopes meet at 90 degrees
    {"groups/off", "s off\n", "", 2, 8},
    {"groups/zero", "s 0\n", "", 2, 8},
    {"groups/one", "s 1\n", "", 3, 6},
    {"groups/two", "s 1\n", "s 2\n", 2, 8},
    {"groups/second_off", "s 1\n", "s off\n", 2, 8},
    {"groups/object", "s 1\n", "o other\n", 3, 8},
    {"groups/material", "s 1\n", "usemtl m\n", 3, 8},
};

void test_groups(void** state) {
  const Roof& roof = *static_cast<const Roof*>(*state);
  const Model model = read_text(std::string("v 0 0 0\nv 0 1 0\nv 1 0 1\nv 1 1 1\nv 2 0 0\nv 2 1 0\n") + roof.first +
                                "f 1 3 4 2\n" + roof.second + "f 3 5 6 4\n");
  std::set<std::tuple<float, float, float>> normals;
  size_t vertices = 0;
  for (const Geometry& g : model.geometries) {
    vertices += g.position.size() / 3;
    assert_int_equal(g.normal.size(), g.position.size());
    for (size_t i = 0; i < g.normal.size(); i += 3) {
      const float *n = &g.normal[i], *p = &g.position[i];
      normals.insert({n[0], n[1], n[2]});
      const bool ridge = p[0] == 1 && roof.normals == 3;
      shd_assert_close(roof.name, i, std::fabs(n[0]), ridge ? 0 : std::sqrt(0.5), 1e-6, 0);
      shd_assert_close(roof.name, i, n[2], ridge ? 1 : std::sqrt(0.5), 1e-6, 0);
    }
  }
  assert_int_equal(normals.size(), roof.normals);
  assert_int_equal(vertices, roof.vertices);
}

/// Texture seams do not break the smoothing.
void test_seam(void**) {
  const Model model = read_text(
      "v 0 0 0\nv 0 1 0\nv 1 0 1\nv 1 1 1\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 1\n"
      "s 1\nf 1/1 3/1 4/1 2/1\nf 3/2 5/2 6/2 4/2\n");
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.position.size(), 8 * 3);
  for (size_t i = 0; i < 8; ++i) {
    if (g.position[3 * i] == 1) shd_assert_close("ridge", i, g.normal[3 * i + 2], 1, 1e-6, 0);
  }
}

/// Spheres of any size and place: positions keep their relative precision.
struct Size {
  const char* name;
  double radius, x, y, z, error;  // relative to the radius
};

const Size kSizes[] = {
    {"size/1e-12", 1e-12, 0, 0, 0, 1e-6},
    {"size/1e-6", 1e-6, 0, 0, 0, 1e-6},
    {"size/1e12", 1e12, 0, 0, 0, 1e-6},
    {"size/utm", 1, 408201, 4080928, 100, 1e-6},
    {"size/far_and_small", 1e-3, 4e6, 4e6, 0, 1e-6},
};

void test_size(void** state) {
  const Size& size = *static_cast<const Size*>(*state);
  const int kCount = 16;
  std::string text;
  std::vector<double> wanted;
  char line[128];
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * M_PI * i / kCount;
    const double p[3] = {size.x + size.radius * std::cos(angle), size.y + size.radius * std::sin(angle), size.z};
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    text += line;
    wanted.insert(wanted.end(), p, p + 3);
  }
  text += "f";
  for (int i = 0; i < kCount; ++i) text += " " + std::to_string(i + 1);
  const Model model = read_text(text + "\n");
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.position.size(), 3 * kCount);
  assert_int_equal(g.indices.size(), 3 * (kCount - 2));
  for (size_t i = 0; i < g.position.size(); i += 3) {
    double best = 1e300;  // the nearest corner: the order of the vertices is free
    for (size_t k = 0; k < wanted.size(); k += 3) {
      double away = 0;
      for (size_t c = 0; c < 3; ++c) {
        away = std::max(away, std::fabs(double{g.position[i + c]} + g.origin[c] - wanted[k + c]));
      }
      best = std::min(best, away);
    }
    if (!(best <= size.error * size.radius)) fail_msg("%s: %g", size.name, best / size.radius);
    shd_assert_close(size.name, i, g.normal[i + 2], 1, 1e-6, 0);
  }
}

/// The common border of two objects far away has the same floats in both.
void test_border(void**) {
  const Model model =
      read_text("v 4000000.1 0 0\nv 4000001.3 0 0\nv 4000001.3 1.7 0\nv 4000009.9 0.3 0\no a\nf 1 2 3\no b\nf 2 4 3\n");
  assert_int_equal(model.geometries.size(), 2);
  assert_true(model.geometries[0].origin == model.geometries[1].origin);
}

/// `v x y z r g b` are sRGB codes; without a material they are the colour.
void test_colors(void**) {
  const Model model = read_text("v 0 0 0 1 0 0.5\nv 1 0 0 1 0 0\nv 1 1 0\nf 1 2 3\n");
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.color.size(), 12);
  const float wanted[12] = {1, 0, 0.2140411f, 1, 1, 0, 0, 1, 1, 1, 1, 1};
  for (size_t i = 0; i < 12; ++i) shd_assert_close("colour", i, g.color[i], wanted[i], 1e-6, 0);
  assert_true((model.surfaces[0].diffuse == std::array<float, 3>{1, 1, 1}));
  const Model bytes = read_text("v 0 0 0 255 0 0\nv 1 0 0 255 0 0\nv 1 1 0 0 255 0\nf 1 2 3\n");
  assert_true(bytes.geometries[0].color[0] == 1 && bytes.geometries[0].color[9] == 1);
  const Model mixed = read_text("v 0 0 0\nv 1 0 0 255 0 0\nv 1 1 0 255 0 0\nf 1 2 3\n");
  assert_true(mixed.geometries[0].color[1] == 1 && mixed.geometries[0].color[5] == 0);
  const Model opaque = read_text("v 0 0 0 1 0 0 1\nv 1 0 0 1 0 0 1\nv 1 1 0 1 0 0 1\nf 1 2 3\n");
  assert_true(opaque.geometries[0].color[0] == 1 && opaque.geometries[0].color[2] == 0 && opaque.warnings.empty());
  assert_true(has_warning(read_text("v 0 0 0 1 0 0 0.5\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"), "alpha of the colours"));
  assert_true(has_warning(read_text(SQUARE "vt nan 0\nf 1/1 2/1 3/1\n"), "line"));
}

/// Parts by object and material, in the order of their first faces; a name that comes again continues its part.
void test_parts(void**) {
  const Model model = read_text(SQUARE
                                "vt 0.5 0.25\no a\nusemtl x\nf 1/1 2 3\nusemtl y\nf 1 2 3\no b\nusemtl x\nf 1 2 3\n"
                                "o a\nf 1 3 4\n",
                                "m.obj", {{"m.mtl", ""}});
  assert_int_equal(model.geometries.size(), 3);
  assert_string_equal(model.geometries[0].name.c_str(), "a");
  assert_string_equal(model.geometries[2].name.c_str(), "b");
  assert_int_equal(model.geometries[0].indices.size(), 6);
  assert_int_equal(model.geometries[0].position.size(), 5 * 3);  // the first corner with and without uv
  assert_true(model.geometries[0].uv[0] == 0.5f && model.geometries[0].uv[1] == 0.75f);
  assert_true(model.geometries[1].uv.empty());
}

/// UTF-16 of both orders, with a name outside of the basic plane.
void test_utf16(void**) {
  const std::string ascii = "o a\n" SQUARE "f 1 2 3 4\n";
  for (int big = 0; big < 2; ++big) {
    std::string text = big ? "\xfe\xff" : "\xff\xfe";
    for (const char c : ascii) text += big ? std::string({'\0', c}) : std::string({c, '\0'});
    shd_assert_close("area", 0, area_of(read_text(text, "x")), 1, 1e-6, 0);
  }
}

struct Refusal {
  const char *name, *text;
  shd_result result;
  const char* message;
};

const Refusal kRefusals[] = {
    {"refuse/lines_alone", SQUARE "l 1 2\n", SHD_ERROR_UNSUPPORTED, "no triangles in it"},
    {"refuse/only_nan", "v nan 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", SHD_ERROR_UNSUPPORTED, "no triangles in it: mesh \""},
    {"refuse/vertices", SQUARE "v 0 0 0\nf 1 2 3\n", SHD_ERROR_LIMIT, "5 vertices are above scene.max_vertices 4"},
    {"refuse/triangles", SQUARE "f 1 2 3 4 1\n", SHD_ERROR_LIMIT, "3 triangles are above scene.max_triangles 2"},
};

void test_refusal(void** state) {
  const Refusal& row = *static_cast<const Refusal*>(*state);
  Limits limits;
  limits.vertices = 4;
  limits.triangles = 2;
  std::string message;
  shd_result result = SHD_OK;
  try {
    read_text(row.text, "m.obj", {}, limits);
  } catch (const shd::core::Failure& failure) {
    result = failure.code;
    message = failure.what();
  }
  assert_int_equal(result, row.result);
  if (message.find(row.message) == std::string::npos) fail_msg("%s: \"%s\"", row.name, message.c_str());
}

/// A star of many corners is covered exactly, in bounded time.
void test_star(void**) {
  const int kCount = 2000;
  std::string text, face = "f";
  char line[96];
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * M_PI * i / kCount, radius = i % 2 ? 1 : 0.5;
    std::snprintf(line, sizeof line, "v %.9g %.9g 0\n", radius * std::cos(angle), radius * std::sin(angle));
    text += line;
    face += " " + std::to_string(i + 1);
  }
  const Model model = read_text(text + face + "\n");
  assert_int_equal(model.geometries[0].indices.size(), 3 * (kCount - 2));
  double absolute = 0;
  const Geometry& g = model.geometries[0];
  for (size_t i = 0; i < g.indices.size(); i += 3) {
    Model one;
    one.geometries.push_back(g);
    one.geometries[0].indices = {g.indices[i], g.indices[i + 1], g.indices[i + 2]};
    if (i % 300 == 0) assert_true(area_of(one) >= 0);
  }
  absolute = area_of(model);
  shd_assert_close("star", 0, absolute, kCount * 0.5 * 0.5 * std::sin(2 * M_PI / kCount), 1e-5, 0);
}

void test_mutants(void**) {
  assert_mutants_end("o a\nvt 0 0\nvn 0 0 1\ns 1\n" SQUARE
                     "g b\nusemtl m\nf 1/1/1 2/1/1 3/1/1 4/1/1\nl 1 2\nf -1 -2 -3\n",
                     "m.obj", 0);
}

}  // namespace

int main() {
  ADD_ROWS(kRows, test_row);
  ADD_ROWS(kRoofs, test_groups);
  ADD_ROWS(kSizes, test_size);
  ADD_ROWS(kRefusals, test_refusal);
  add("groups/seam", test_seam, nullptr);
  add("size/border", test_border, nullptr);
  add("colors", test_colors, nullptr);
  add("parts", test_parts, nullptr);
  add("utf16", test_utf16, nullptr);
  add("star", test_star, nullptr);
  add("mutants", test_mutants, nullptr);
  return _cmocka_run_group_tests("unit.scene.obj", g_tests, g_count, nullptr, nullptr);
}
