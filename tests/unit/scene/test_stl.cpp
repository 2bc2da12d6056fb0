// SPDX-License-Identifier: MIT
// STL files to models: text and binary by the specification of 1989, colours of VisCAM and Magics, normals of length 0.
#include <cmath>
#include <cstring>

#include "support/model_mutants.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

#define FACET(n) "facet normal " n "\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n"

struct Row {
  const char *name, *text;
  size_t meshes, triangles;
  const char* warning;  // "" = none
};

const Row kTexts[] = {
    {"text/one", "solid a\n" FACET("0 0 1") "endsolid a\n", 1, 1, ""},
    {"text/empty_solid", "solid a\n" FACET("0 0 1") "endsolid a\nsolid b\nendsolid b\n", 1, 1,
     "mesh \"b\": it has no triangles"},
    {"text/two_solids", "solid a\n" FACET("0 0 1") "endsolid a\nsolid b\n" FACET("0 0 1") "endsolid\n", 2, 2, ""},
    {"text/capitals",
     "SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 1 1 0\nENDLOOP\n"
     "ENDFACET\nENDSOLID\n",
     1, 1, ""},
    {"text/comment", "# made by hand\nsolid a\n" FACET("0 0 1") "endsolid\n", 1, 1, ""},
    {"text/without_endsolid", "solid\n" FACET("0 0 1"), 1, 1, ""},
    {"text/odd_word", "solid a\n" FACET("0 0 1") "color 1 0 0\n" FACET("0 0 1") "endsolid\n", 1, 2, "line 9"},
    {"text/nan_position",
     "solid a\n" FACET("0 0 1") "facet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 1 0 0\nvertex 1 1 "
                                "0\nendloop\nendfacet\nendsolid\n",
     1, 1, "1 faces with positions that are not finite"},
    {"text/zero_normal", "solid a\n" FACET("0 0 0") "endsolid\n", 1, 1, "normals of length 0"},
    {"text/missing_normal", "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n",
     1, 1, "normals of length 0"},
    {"text/stale_normal",
     "solid a\nfacet normal -1.#IND 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
     "0\nendloop\nendfacet\n" FACET("0 0 1") "endsolid\n",
     1, 2, "normals of length 0"},
    {"text/short_loop",
     "solid a\n" FACET("0 0 1") "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n", 1, 1,
     "fewer than 3 vertices"},
    {"text/line_before_facet", "solid a\ncolor 1 0 0\n" FACET("0 0 1") "endsolid a\n", 1, 1, "line 2"},
    {"text/nan_normal", "solid a\n" FACET("nan nan nan") "endsolid\n", 1, 1, "normals of length 0"},
};

void test_text(void** state) {
  const Row& row = *static_cast<const Row*>(*state);
  const Model model = read_text(row.text);
  assert_int_equal(model.geometries.size(), row.meshes);
  size_t triangles = 0;
  for (const Geometry& g : model.geometries) triangles += g.indices.size() / 3;
  assert_int_equal(triangles, row.triangles);
  shd_assert_close(row.name, 0, area_of(model), 0.5 * static_cast<double>(row.triangles), 0, 0);
  if (*row.warning ? !has_warning(model, row.warning) : !model.warnings.empty()) {
    fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
  }
  const float z = std::strstr(row.name, "_normal") ? 0.0f : 1.0f;  // 0 = computed later
  assert_true(model.geometries[0].normal[2] == z);
}

std::string binary(const std::string& header, uint16_t first, uint16_t second) {
  std::string out = header;
  out.resize(80, ' ');
  const uint32_t count = 2;
  out.append(reinterpret_cast<const char*>(&count), 4);
  for (const uint16_t attribute : {first, second}) {
    const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0};
    out.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    out.append(reinterpret_cast<const char*>(&attribute), 2);
  }
  return out;
}

struct Binary {
  const char *name, *header;
  uint16_t first, second;
  float color[6];  // colours of both facets; negative = no colours
};

const float kHalf = 0.2158605f;  // sRGB code 128

const Binary kBinaries[] = {
    {"binary/plain", "part", 0, 0, {-1, 0, 0, 0, 0, 0}},
    {"binary/solid_header", "solid part", 0, 0, {-1, 0, 0, 0, 0, 0}},
    {"binary/viscam", "part", 0x8000 | 31 << 10, 0x8000 | 31, {1, 0, 0, 0, 0, 1}},
    {"binary/viscam_one_plain", "part", 0x8000 | 31 << 5, 31, {0, 1, 0, 0.6f, 0.6f, 0.6f}},
    {"binary/magics", "COLOR=\x80\x80\x80\xff,MATERIAL=", 31, 31 << 10, {1, 0, 0, 0, 0, 1}},
    {"binary/magics_default", "COLOR=\x80\x80\x80\xff", 0x8000 | 31, 31 << 5, {kHalf, kHalf, kHalf, 0, 1, 0}},
};

void test_binary(void** state) {
  const Binary& row = *static_cast<const Binary*>(*state);
  const Model model = read_text(binary(row.header, row.first, row.second));
  const Geometry& g = model.geometries[0];
  assert_int_equal(g.indices.size(), 6);
  shd_assert_close(row.name, 0, area_of(model), 1, 0, 0);
  assert_true(has_warning(model, "MATERIAL") == (std::strstr(row.header, "MATERIAL") != nullptr));
  const bool colored = row.color[0] >= 0;
  assert_int_equal(g.color.size(), colored ? 24 : 0);
  assert_true(model.surfaces[0].diffuse[0] == (colored ? 1.0f : 0.6f));
  for (size_t vertex = 0; colored && vertex < 6; ++vertex) {
    for (size_t c = 0; c < 3; ++c) {
      shd_assert_close(row.name, vertex, g.color[4 * vertex + c], row.color[3 * (vertex / 3) + c], 1e-6, 0);
    }
  }
}

/// Files whose sizes are not those of their headers: bytes behind the facets, counts that were never written, and an
/// end in the middle. Such files are STL by their name.
void test_sizes(void**) {
  const auto counted = [](uint32_t count, size_t size) {
    std::string file = binary("part", 0, 0);
    std::memcpy(&file[80], &count, 4);
    file.resize(size, '\0');
    return file;
  };
  const Model longer = read_text(counted(2, 84 + 100 + 7), "a.STL");
  assert_true(longer.geometries[0].indices.size() == 6 && has_warning(longer, "7 bytes behind the last facet"));
  for (const uint32_t open : {0u, UINT32_MAX}) {
    const Model model = read_text(counted(open, 84 + 100), "a.stl");
    assert_true(model.geometries[0].indices.size() == 6 && has_warning(model, "2 fit into the file"));
  }
  try {
    read_text(counted(3, 84 + 100), "a.stl");
    fail_msg("no failure");
  } catch (const shd::core::Failure& failure) {
    assert_string_equal(failure.what(), "STL: the file ends in facet 2 of 3");
  }
}

/// A count of facets that the bytes do not have is no binary STL, and a budget comes before the memory.
void test_limits(void**) {
  Limits limits;
  limits.triangles = 1;
  std::string message;
  try {
    read_text(binary("x", 0, 0), "m.stl", {}, limits);
  } catch (const shd::core::Failure& failure) {
    message = failure.what();
  }
  assert_string_equal(message.c_str(), "2 triangles are above scene.max_triangles 1");
}

void test_mutants(void**) {
  assert_mutants_end("solid a\n" FACET("0 0 1") "endsolid a\n", "m.stl", 6);
  assert_mutants_end(binary("COLOR=\xff\x01\x01\xff", 0x8000, 0x7c00), "m.stl", 0);
}

}  // namespace

int main() {
  ADD_ROWS(kTexts, test_text);
  ADD_ROWS(kBinaries, test_binary);
  add("sizes", test_sizes, nullptr);
  add("limits", test_limits, nullptr);
  add("mutants", test_mutants, nullptr);
  return _cmocka_run_group_tests("unit.scene.stl", g_tests, g_count, nullptr, nullptr);
}
