// SPDX-License-Identifier: MIT
// Containers, URIs, extensions and compressed geometry of glTF 2.0; damaged and hostile files.
#include <chrono>
#include <cstdio>
#include <cstring>

#if defined(SHD_HAS_MESHOPT)
#include <meshoptimizer.h>
#endif
#if defined(SHD_HAS_DRACO)
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif

// After Draco: cmocka has a macro named fail.
#include "support/gltf_file.h"
#include "support/model_mutants.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

std::string number(size_t value) {
  return std::to_string(value);
}

/// A square as JSON, with other members.
std::string square(const std::string& members = "", const std::string& uri = "") {
  GltfFile file;
  file.uri = uri;
  const int position = file.square(), indices = file.square_indices();
  return file.with_primitive(
      "\"attributes\":{\"POSITION\":" + std::to_string(position) + "},\"indices\":" + std::to_string(indices), members);
}

std::string square_glb() {
  GltfFile file;
  const int position = file.square(), indices = file.square_indices();
  file.with_primitive("\"attributes\":{\"POSITION\":" + std::to_string(position) +
                      "},\"indices\":" + std::to_string(indices));
  return file.glb();
}

std::string square_bytes() {
  GltfFile file;
  file.square();
  file.square_indices();
  return file.bytes();
}

/// Sections 4.4 and 2.6: the content decides.
void test_containers(void**) {
  for (const char* name : {"a.gltf", "a.glb", "a", "a.obj"}) {
    shd_assert_close(name, 0, area_of(read_text(square(), name)), 1, 1e-6, 0);
    shd_assert_close(name, 1, area_of(read_text(square_glb(), name)), 1, 1e-6, 0);
    shd_assert_close(name, 2, area_of(read_text("\xef\xbb\xbf" + square(), name)), 1, 1e-6, 0);
    shd_assert_close(name, 3, area_of(read_text(" \r\n\t" + square(), name)), 1, 1e-6, 0);
  }
  shd_assert_close("more bytes", 0, area_of(read_text(square_glb() + "more", "a.glb")), 1, 1e-6, 0);
}

/// RFC 3986, sections 2.1 and 3; RFC 2397. `file` is the one that exists.
struct Uri {
  const char *name, *uri, *file;
};

const Uri kUris[] = {
    {"uri/plain", "a.bin", "a.bin"},
    {"uri/encoded_blank", "my%20part.bin", "my part.bin"},
    {"uri/encoded_utf8", "t%C3%ABx.bin", "t\xc3\xabx.bin"},
    {"uri/encoded_hash", "a%23b.bin", "a#b.bin"},
    {"uri/encoded_folder", "sub%20dir/a.bin", "sub dir/a.bin"},
    {"uri/blank", "my part.bin", "my part.bin"},
    {"uri/utf8", "t\xc3\xabx.bin", "t\xc3\xabx.bin"},
    {"uri/escaped_utf8", "t\\u00ebx.bin", "t\xc3\xabx.bin"},
    {"uri/query", "a.bin?version=2", "a.bin"},
    {"uri/fragment", "a.bin#part", "a.bin"},
    {"uri/name_with_question_mark", "a?.bin", "a?.bin"},
    {"uri/name_with_percent", "a%20b.bin", "a%20b.bin"},
    {"uri/stray_percent", "100%.bin", "100%.bin"},
    {"uri/lower_case_digits", "a%c3%ab.bin", "a\xc3\xab.bin"},
};

void test_uri(void** state) {
  const Uri& row = *static_cast<const Uri*>(*state);
  shd_assert_close(row.name, 0, area_of(read_text(square("", row.uri), "a.gltf", {{row.file, square_bytes()}})), 1,
                   1e-6, 0);
}

/// Images are named or embedded; nothing is decoded here.
void test_images(void**) {
  const std::map<std::string, std::string> files = {{"a%20b.png", "x"}};
  const struct {
    const char *image, *name, *bytes;
  } rows[] = {
      {"\"uri\":\"my%20map.png\"", "my map.png", ""},
      {"\"uri\":\"a%20b.png\"", "a%20b.png", ""},
      {"\"uri\":\"data:image/png;base64,AAEC\"", "images[0]", "\x00\x01\x02"},
      {"\"uri\":\"data:image/png;base64,AAE=\"", "images[0]", "\x00\x01"},
      {"\"uri\":\"data:,a%41\"", "images[0]", "aA"},
      {"\"bufferView\":0,\"mimeType\":\"image/png\",\"name\":\"n\"", "n", nullptr},
  };
  for (const auto& row : rows) {
    const Model model = read_text(square(",\"images\":[{" + std::string(row.image) +
                                         "}],\"textures\":[{\"source\":0}],"
                                         "\"materials\":[{\"emissiveTexture\":{\"index\":0}}]"),
                                  "a", files);
    assert_int_equal(model.textures.size(), 1);
    assert_string_equal(model.textures[0].name.c_str(), row.name);
    const size_t size =
        row.bytes ? (*row.bytes || row.name[0] != 'i' ? strlen(row.bytes) : model.textures[0].file.size()) : 48;
    assert_int_equal(model.textures[0].file.size(), size);
    if (row.bytes && size) assert_memory_equal(model.textures[0].file.data(), row.bytes, size);
  }
}

/// A file that is refused, or read with a warning (SHD_OK).
struct Odd {
  const char* name;
  std::string text;
  shd_result result;
  const char* message;
};

std::string nested(const char* open, const char* close, int depth) {
  std::string out = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
  for (int i = 0; i < depth; ++i) out += open;
  out += "0";
  for (int i = 0; i < depth; ++i) out += close;
  return out + "}";
}

#define ASSET "{\"asset\":{\"version\":\"2.0\"}"

const Odd kOdd[] = {
    {"required/unknown", square(",\"extensionsRequired\":[\"VENDOR_a\",\"KHR_texture_transform\",\"VENDOR_b\"]"),
     SHD_ERROR_UNSUPPORTED, "VENDOR_a, VENDOR_b"},
    {"required/basisu", square(",\"extensionsRequired\":[\"KHR_texture_basisu\"]"), SHD_ERROR_UNSUPPORTED,
     "KHR_texture_basisu"},
    {"required/quantization", square(",\"extensionsRequired\":[\"KHR_mesh_quantization\"]"), SHD_OK, ""},
    {"used/unknown", square(",\"extensionsUsed\":[\"VENDOR_a\"]"), SHD_OK, "extension VENDOR_a is ignored"},
    {"used/not_listed", square(",\"extensions\":{\"VENDOR_b\":{}}"), SHD_OK, "extension VENDOR_b is ignored"},
    {"used/in_extras", square(",\"extras\":{\"extensions\":{\"VENDOR_c\":{}}}"), SHD_OK, ""},
    {"version/3", "{\"asset\":{\"version\":\"3.0\"}}", SHD_ERROR_UNSUPPORTED, "\"3.0\""},
    {"version/min", "{\"asset\":{\"version\":\"2.1\",\"minVersion\":\"2.1\"}}", SHD_ERROR_UNSUPPORTED, "\"2.1\""},
    {"version/absent", "{\"asset\":{}}", SHD_ERROR_UNSUPPORTED, "asset.version"},
    {"empty", ASSET "}", SHD_ERROR_UNSUPPORTED, "no triangles in it"},
    {"json/cut", ASSET ",", SHD_ERROR_CORRUPT, "JSON"},
    {"json/huge_number", ASSET ",\"a\":1e999}", SHD_ERROR_CORRUPT, "JSON"},
    {"json/not_utf8", ASSET ",\"a\":\"\xff\"}", SHD_ERROR_CORRUPT, "JSON"},
    {"json/deep_arrays", nested("[", "]", 200000), SHD_ERROR_LIMIT, "nested more than"},
    {"json/deep_objects", nested("{\"a\":", "}", 200000), SHD_ERROR_LIMIT, "nested more than"},
    {"json/array_as_object", ASSET ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[5]}", SHD_ERROR_CORRUPT,
     "nodes[0]: is not an object"},
    {"nodes/cycle", ASSET ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[1]},{\"children\":[0]}]}",
     SHD_ERROR_CORRUPT, "nodes[0]: has two parents"},
    {"nodes/no_child", ASSET ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[9]}]}", SHD_ERROR_CORRUPT,
     "9 is no node"},
    {"nodes/no_mesh", ASSET ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":3}]}", SHD_ERROR_CORRUPT,
     "nodes[0].mesh: 3"},
    {"buffer/missing", square("", "gone.bin"), SHD_ERROR_UNSUPPORTED, "gone.bin"},
    {"buffer/scheme", square("", "https://example.org/a.bin"), SHD_ERROR_UNSUPPORTED, "https://example.org/a.bin"},
    {"buffer/not_base64", square("", "data:a;base64,AA$A"), SHD_ERROR_UNSUPPORTED, "base64"},
    {"glb/header", "glTF\x02", SHD_ERROR_CORRUPT, "binary glTF"},
    {"glb/cut", square_glb().substr(0, 100), SHD_ERROR_CORRUPT, "the header says"},
};

void test_odd(void** state) {
  const Odd& row = *static_cast<const Odd*>(*state);
  std::string message;
  shd_result result = SHD_OK;
  try {
    const Model model = read_text(row.text, "a.gltf");
    message = warnings_of(model);
    if (!*row.message) assert_int_equal(model.warnings.size(), 0);
  } catch (const shd::core::Failure& failure) {
    result = failure.code;
    message = failure.what();
  }
  if (result != row.result || message.find(row.message) == std::string::npos) {
    fail_msg("%s: %d \"%s\"", row.name, static_cast<int>(result), message.c_str());
  }
}

/// Budgets, each met before memory is taken.
struct Budget {
  const char* name;
  std::string primitive;  // after the square's position 0 and indices 1; accessor 2 has 4e9 elements and no bytes
  const char* message;
};

const Budget kBudgets[] = {
    {"budget/vertices", "\"attributes\":{\"POSITION\":2}", "scene.max_vertices 1000"},
    {"budget/triangles", "\"attributes\":{\"POSITION\":0},\"indices\":3", "scene.max_triangles 1000"},
    {"budget/strip", "\"attributes\":{\"POSITION\":0},\"indices\":3,\"mode\":5", "scene.max_triangles 1000"},
};

void test_budget(void** state) {
  const Budget& row = *static_cast<const Budget*>(*state);
  GltfFile file;
  file.square();
  file.square_indices();
  file.accessor(-1, 5126, 4000000000u, "VEC3");
  file.accessor(-1, 5125, 4000000000u, "SCALAR");
  Limits limits;
  limits.vertices = limits.triangles = 1000;
  try {
    read_text(file.with_primitive(row.primitive), "a", {}, limits);
  } catch (const shd::core::Failure& failure) {
    assert_int_equal(failure.code, SHD_ERROR_LIMIT);
    if (!strstr(failure.what(), row.message)) fail_msg("%s: %s", row.name, failure.what());
    return;
  }
  fail_msg("%s: was read", row.name);
}

void test_mutants(void**) {
  GltfFile file;
  const int position = file.square(), indices = file.square_indices(),
            weights = file.column<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
  const int joints = file.column<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 4),
            times = file.column<float>({0, 1}, 1);
  const int moves = file.column<float>({0, 0, 0, 1, 1, 1}, 3);
  file.members =
      ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"skin\":0,\"children\":[1]},{\"translation\":[1,2,3]}],"
      "\"skins\":[{\"joints\":[1]}],\"materials\":[{\"emissiveFactor\":[1,1,1]}],\"meshes\":[{\"primitives\":[{"
      "\"material\":0,\"indices\":" +
      number(size_t(indices)) + ",\"attributes\":{\"POSITION\":" + number(size_t(position)) +
      ",\"JOINTS_0\":" + number(size_t(joints)) + ",\"WEIGHTS_0\":" + number(size_t(weights)) +
      "},\"targets\":[{\"POSITION\":0}]}]}],\"animations\":[{\"channels\":[{\"sampler\":0,"
      "\"target\":{\"node\":1,\"path\":\"translation\"}}],\"samplers\":[{\"input\":" +
      number(size_t(times)) + ",\"output\":" + number(size_t(moves)) + "}]}]";
  assert_mutants_end(file.glb(), "a.glb", 12);
}

#if defined(SHD_HAS_MESHOPT)
std::string compressed_view(GltfFile& file, const std::string& code, size_t stride, size_t count,
                            const std::string& more) {
  const int at = file.view(code);
  (void)at;
  const size_t offset = file.bytes().size() - code.size();
  return "{\"buffer\":1,\"byteLength\":" + number(stride * count) + ",\"byteStride\":" + number(stride) +
         ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" + number(offset) +
         ",\"byteLength\":" + number(code.size()) + ",\"byteStride\":" + number(stride) +
         ",\"count\":" + number(count) + more + "}}}";
}

/// EXT_meshopt_compression: positions, indices and octahedral normals; buffer 1 is a fallback without bytes.
std::string meshopt_square(size_t vertex_count, GltfFile& file, char version = 0) {
  const float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const unsigned indices[6] = {0, 1, 2, 0, 2, 3};
  const signed char normals[16] = {0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0};
  std::string code(meshopt_encodeVertexBufferBound(4, 12), '\0'), triangles(meshopt_encodeIndexBufferBound(6, 4), '\0'),
      octahedral(meshopt_encodeVertexBufferBound(4, 4), '\0');
  code.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(&code[0]), code.size(), positions, 4, 12));
  code[0] = static_cast<char>(code[0] + version);
  triangles.resize(
      meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(&triangles[0]), triangles.size(), indices, 6));
  octahedral.resize(
      meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(&octahedral[0]), octahedral.size(), normals, 4, 4));
  const std::string views[] = {
      compressed_view(file, code, 12, vertex_count, ",\"mode\":\"ATTRIBUTES\""),
      compressed_view(file, triangles, 4, 6, ",\"mode\":\"TRIANGLES\""),
      compressed_view(file, octahedral, 4, 4, ",\"mode\":\"ATTRIBUTES\",\"filter\":\"OCTAHEDRAL\"")};
  const int position = file.accessor(file.raw_view(views[0]), 5126, vertex_count, "VEC3");
  std::string index_view = views[1];
  index_view.erase(index_view.find(",\"byteStride\":4"), 15);
  const int index = file.accessor(file.raw_view(index_view), 5125, 6, "SCALAR");
  const int normal = file.accessor(file.raw_view(views[2]), 5120, 4, "VEC3", ",\"normalized\":true");
  file.more_buffers = ",{\"byteLength\":4096,\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}";
  file.with_primitive("\"attributes\":{\"POSITION\":" + std::to_string(position) +
                          ",\"NORMAL\":" + std::to_string(normal) + "},\"indices\":" + std::to_string(index),
                      ",\"extensionsRequired\":[\"EXT_meshopt_compression\"]");
  return file.text();
}

void test_meshopt(void**) {
  GltfFile file, bomb;
  const Model model = read_text(meshopt_square(4, file));
  if (!model.warnings.empty()) fail_msg("%s", warnings_of(model).c_str());
  shd_assert_close("area", 0, area_of(model), 1, 1e-6, 0);
  assert_int_equal(model.geometries[0].normal.size(), 12);
  shd_assert_close("normal", 0, model.geometries[0].normal[2], 1, 0.01, 0);
  GltfFile newer;
  try {
    read_text(meshopt_square(4, newer, 14));
    fail();
  } catch (const shd::core::Failure& failure) {
    assert_non_null(strstr(failure.what(), "does not read version 14 of the vertex codec"));
  }
  Limits limits;
  limits.file_bytes = 1 << 16;
  try {
    read_text(meshopt_square(8000, bomb), "a", {}, limits);
    fail();
  } catch (const shd::core::Failure& failure) {
    assert_non_null(strstr(failure.what(), "scene.max_file_bytes"));
  }
  assert_mutants_end(file.glb(), "a.glb", 12);
}
#endif

#if defined(SHD_HAS_DRACO)
/// KHR_draco_mesh_compression: a square with texture coordinates. `faces` and `points` are the counts of the accessors.
std::string draco_square(size_t faces, size_t points, int method, GltfFile& file) {
  const float corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, uv[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  const unsigned indices[2][3] = {{0, 1, 2}, {0, 2, 3}};
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int map = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (uint32_t f = 0; f < 2; ++f) {
    const unsigned* v = indices[f];
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(f), corner[v[0]], corner[v[1]], corner[v[2]]);
    builder.SetAttributeValuesForFace(map, draco::FaceIndex(f), uv[v[0]], uv[v[1]], uv[v[2]]);
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer code;
  assert_true(encoder.EncodeMeshToBuffer(*mesh, &code).ok());
  const int view = file.view(std::string(code.data(), code.size()));
  const int p = file.accessor(-1, 5126, points, "VEC3"), t = file.accessor(-1, 5126, points, "VEC2");
  const int index = file.accessor(-1, 5123, 3 * faces, "SCALAR");
  file.with_primitive("\"attributes\":{\"POSITION\":" + std::to_string(p) + ",\"TEXCOORD_0\":" + std::to_string(t) +
                          "},\"indices\":" + std::to_string(index) +
                          ",\"extensions\":{\"KHR_draco_mesh_compression\":{"
                          "\"bufferView\":" +
                          std::to_string(view) +
                          ",\"attributes\":{\"POSITION\":" + std::to_string(mesh->attribute(0)->unique_id()) +
                          ",\"TEXCOORD_0\":" + std::to_string(mesh->attribute(1)->unique_id()) + "}}}",
                      ",\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]");
  return file.text();
}

void test_draco(void**) {
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    GltfFile file, fewer;
    const Model model = read_text(draco_square(2, 4, method, file));
    if (!model.warnings.empty()) fail_msg("%s", warnings_of(model).c_str());
    shd_assert_close("area", size_t(method), area_of(model), 1, 1e-5, 0);
    const Geometry& g = model.geometries[0];
    for (size_t i = 0; i < 4; ++i)
      shd_assert_close("v", i, g.uv[2 * i + 1], 1 - double(g.position[3 * i + 1]), 1e-5, 0);
    try {
      read_text(draco_square(1, 4, method, fewer));
      fail();
    } catch (const shd::core::Failure& failure) {
      assert_non_null(strstr(failure.what(), "more triangles than its accessor"));
    }
    assert_mutants_end(file.glb(), "a.glb", 12);
  }
}
#endif

}  // namespace

int main() {
  ADD_ROWS(kUris, test_uri);
  ADD_ROWS(kOdd, test_odd);
  ADD_ROWS(kBudgets, test_budget);
  add("containers", test_containers, nullptr);
  add("images", test_images, nullptr);
  add("mutants", test_mutants, nullptr);
#if defined(SHD_HAS_MESHOPT)
  add("meshopt", test_meshopt, nullptr);
#endif
#if defined(SHD_HAS_DRACO)
  add("draco", test_draco, nullptr);
#endif
  return _cmocka_run_group_tests("unit.scene.gltf_file", g_tests, g_count, nullptr, nullptr);
}
