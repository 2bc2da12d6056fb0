// SPDX-License-Identifier: MIT
// Scenes of models made by hand: culling, materials, filters, colours of vertices, poses, and models far away from 0.
#include "scene/objects.h"
#include "support/check.h"
#include "support/models.h"

namespace {

using namespace shd;
using namespace shd::scene;

shd_context* g_context;

/// glTF 2.0, 3.7.4: with a negative determinant the winding turns; 3.9.5: double-sided faces are not culled.
void test_cull(void**) {
  const struct {
    const char* name;
    Matrix matrix;
    bool double_sided;
    shd_cull cull;
  } cases[] = {{"single", kIdentity, false, SHD_CULL_BACK},
               {"mirrored", test::scaled(-1, 1, 1), false, SHD_CULL_FRONT},
               {"turned", test::scaled(-1, -1, 1), false, SHD_CULL_BACK},
               {"flattened", test::scaled(1, 1, 0), false, SHD_CULL_NONE},
               {"tiny", test::scaled(1e-12, 1e-12, 1e-12), false, SHD_CULL_BACK},
               {"double", test::scaled(-1, 1, 1), true, SHD_CULL_NONE}};
  for (const auto& c : cases) {
    Model model = test::model_of(test::square_geometry(), c.matrix);
    model.surfaces[0].double_sided = c.double_sided;
    Objects scene;
    test::make_scene(g_context, std::move(model), &scene);
    if (scene.instances[0].cull != c.cull || scene.draws[0].cull != c.cull)
      fail_msg("%s: %d", c.name, scene.draws[0].cull);
  }
}

void test_materials(void**) {
  Surface unlit, glass, metal, hidden, masked, bumpy;
  unlit.unlit = true;
  unlit.emission = {1, 1, 1};
  glass.metallic_roughness = metal.metallic_roughness = true;
  glass.transmission = metal.transmission = 1;
  glass.ior = 1.33f;
  metal.metallic = 1;
  metal.ior = 0;
  Surface mapped = metal;
  mapped.maps[SHD_SLOT_METALLIC].texture = 0;
  assert_int_equal(desc_of(mapped).model, SHD_MODEL_GLASS);
  hidden.alpha = masked.alpha = Alpha::kMask;
  hidden.alpha_cutoff = 1.5f;
  masked.alpha_cutoff = 0.25f;
  bumpy.bump_scale = 0.5f;
  bumpy.maps[SHD_SLOT_HEIGHT].texture = 0;
  assert_int_equal(desc_of(unlit).model, SHD_MODEL_UNLIT);
  assert_true(desc_of(unlit).emission[0] == 0);
  assert_int_equal(desc_of(glass).model, SHD_MODEL_GLASS);
  assert_true(desc_of(glass).ior == 1.33f);
  assert_int_equal(desc_of(metal).model, SHD_MODEL_METALLIC_ROUGHNESS);
  assert_true(desc_of(metal).ior == 10);
  assert_true(desc_of(hidden).opacity == 0 && desc_of(hidden).alpha_cutoff == 1);
  assert_true(desc_of(masked).opacity == 1 && desc_of(masked).alpha_cutoff == 0.25f);
  assert_true(desc_of(bumpy).bump == SHD_BUMP_GRADIENT && desc_of(bumpy).bump_scale == 0.5f);
}

/// One warning names the material whose transmission is left out, and why.
void test_transmission_warning(void**) {
  const struct {
    float transmission, metallic;
    const char* why;
  } rows[] = {{0.25f, 0, "less than half of the light passes"}, {1, 1, "it is a metal"}};
  for (const auto& row : rows) {
    Model model = test::model_of(test::square_geometry());
    model.surfaces[0].transmission = row.transmission;
    model.surfaces[0].metallic = row.metallic;
    Objects scene;
    test::make_scene(g_context, std::move(model), &scene);
    assert_int_equal(scene.warnings.size(), 1);
    assert_string_equal(scene.warnings[0].c_str(),
                        (std::string("material \"paint\": its transmission is left out: ") + row.why).c_str());
  }
}

void test_filters(void**) {
  const Filter none = Filter::kDefault, nearest = Filter::kNearest, linear = Filter::kLinear;
  const struct {
    const char* name;
    Filter magnify, minify, mip;
    bool no_mip;
    shd_filter filter;
    shd_magnification magnification;
  } cases[] = {{"none", none, none, none, false, SHD_FILTER_EWA, SHD_MAGNIFICATION_DEFAULT},
               {"linear", linear, linear, linear, false, SHD_FILTER_EWA, SHD_MAGNIFICATION_DEFAULT},
               {"nearest", nearest, nearest, none, true, SHD_FILTER_NEAREST, SHD_MAGNIFICATION_NEAREST},
               {"no levels", none, linear, none, true, SHD_FILTER_BILINEAR, SHD_MAGNIFICATION_DEFAULT},
               {"nearest level", none, linear, nearest, false, SHD_FILTER_BILINEAR_MIP, SHD_MAGNIFICATION_DEFAULT},
               {"nearest both", none, nearest, nearest, false, SHD_FILTER_NEAREST_MIP, SHD_MAGNIFICATION_DEFAULT},
               {"two levels", none, nearest, linear, false, SHD_FILTER_NEAREST_MIP_LINEAR, SHD_MAGNIFICATION_DEFAULT},
               {"smooth near", linear, nearest, nearest, false, SHD_FILTER_NEAREST_MIP, SHD_MAGNIFICATION_BILINEAR},
               {"sharp near", nearest, linear, linear, false, SHD_FILTER_EWA, SHD_MAGNIFICATION_NEAREST}};
  shd_sampler_desc host = shd_sampler_desc_default();
  host.filter = SHD_FILTER_EWA;
  for (const auto& c : cases) {
    Map map;
    map.magnify = c.magnify, map.minify = c.minify, map.mip = c.mip, map.no_mip = c.no_mip;
    map.wrap_u = SHD_WRAP_MIRROR;
    const shd_sampler_desc desc = sampler_of(map, host, false), kept = sampler_of(map, host, true);
    if (desc.filter != c.filter || desc.magnification != c.magnification) fail_msg("%s: %d", c.name, desc.filter);
    assert_true(kept.filter == SHD_FILTER_EWA && kept.magnification == SHD_MAGNIFICATION_DEFAULT);
    assert_true(kept.wrap_u == SHD_WRAP_MIRROR);
  }
}

/// Colours are the attributes 0 to 3, and the material reads them by the slot of tints.
void test_colors(void**) {
  Geometry g = test::square_geometry();
  g.color = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0.5f, 1, 0, 0, 1};
  Objects scene;
  test::make_scene(g_context, test::model_of(g), &scene);
  const shd_material_desc& desc = scene.parts->materials.descs[0];
  assert_int_equal(desc.slot_count, 1);
  assert_int_equal(desc.slots[0].target, SHD_SLOT_TINT);
  assert_int_equal(desc.slots[0].source, SHD_SLOT_SOURCE_VERTEX);
  float alpha[4] = {};
  const shd_f32_out out = {alpha, 0};
  assert_int_equal(shd_mesh_read_attribute(scene.meshes[0].get(), 3, &out), SHD_OK);
  assert_true(alpha[1] == 1 && alpha[2] == 0.5f);
  Objects plain;
  test::make_scene(g_context, test::model_of(test::square_geometry()), &plain);
  assert_int_equal(plain.parts->materials.descs[0].slot_count, 0);
}

/// A model in UTM metres: its origin is moved away in double, and its camera and light with it.
void test_far(void**) {
  Geometry g = test::square_geometry();
  g.origin = {408201.125, 4080928.0625, 100};
  Model model = test::model_of(g);
  model.lights.push_back({"lamp", shd_light_desc_default(), 0});
  model.lights[0].desc.position[2] = 3;
  model.nodes.emplace_back();
  model.nodes[1].matrix = test::moved(408201.625, 4080928.5625, 105);
  model.cameras.push_back({"eye", shd_camera_default(), 1});
  model.cameras[0].camera.eye[2] = 0;
  model.cameras[0].camera.target[2] = -1;
  Objects scene;
  test::make_scene(g_context, std::move(model), &scene);
  const auto& origin = scene.parts->origin;
  shd_assert_close("origin", 0, origin[0], 408201.625, 1e-9, 0);
  shd_assert_close("origin", 1, origin[1], 4080928.5625, 1e-9, 0);
  shd_assert_close("low", 0, scene.bounds.low[0], -0.5, 1e-9, 0);
  shd_assert_close("high", 1, scene.bounds.high[1], 0.5, 1e-9, 0);
  assert_true(scene.instances[0].object_to_world[12] == -0.5f && scene.instances[0].object_to_world[14] == 0);
  assert_true(scene.cameras[0].eye[0] == 0 && scene.cameras[0].eye[2] == 5 && scene.cameras[0].target[2] == 4);
  shd_assert_close("light", 0, scene.light_descs[0].position[2], 3 - 100, 1e-4, 0);
}

/// Radii from 1e-12 to 1e12 around 0 keep their coordinates.
void test_sizes(void**) {
  for (const double size : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    Objects scene;
    test::make_scene(g_context, test::model_of(test::square_geometry(), test::scaled(size, size, size)), &scene);
    assert_true(scene.parts->origin[0] == 0);
    shd_assert_close("high", 0, scene.bounds.high[0], size, 0, 1e-12);
    shd_assert_close("matrix", 0, scene.instances[0].object_to_world[0], size, 0, 1e-7);
  }
}

/// A pose moves nodes, lights, cameras and morph targets, and shares the rigid meshes.
void test_pose(void**) {
  Geometry soft = test::square_geometry();
  soft.morphs.resize(1);
  soft.morphs[0].position = std::vector<float>(12, 1);
  Model model = test::model_of(test::square_geometry());
  model.geometries.push_back(soft);
  model.nodes[0].parts = true;
  model.nodes[0].weights = {0.25f};
  model.placements.push_back({1, 0, 0, -1, {}});
  model.placements.push_back({0, 0, 0, -1, {test::moved(1, 0, 0), test::moved(2, 0, 0)}});
  model.lights.push_back({"lamp", shd_light_desc_default(), 0});
  model.animations.push_back({"walk",
                              {{0, Target::kTranslation, Interpolation::kLinear, {0, 2}, {0, 0, 0, 4, 0, 0}},
                               {0, Target::kWeights, Interpolation::kLinear, {1, 3}, {0, 1}}}});
  Objects rest, posed;
  test::make_scene(g_context, std::move(model), &rest);
  assert_true(rest.parts->animations[0].first == 0 && rest.parts->animations[0].last == 3);
  assert_true(test::positions_of(rest.meshes[1].get())[0] == 0.25f);
  pose_objects(rest.parts, 0, 1.5, &posed);
  assert_ptr_equal(posed.meshes[0].get(), rest.meshes[0].get());
  assert_ptr_not_equal(posed.meshes[1].get(), rest.meshes[1].get());
  assert_int_equal(posed.instances.size(), 4);
  const float want[] = {3, 3, 4, 5};
  for (size_t i = 0; i < 4; ++i) assert_true(posed.instances[i].object_to_world[12] == want[i]);
  assert_true(test::positions_of(posed.meshes[1].get())[0] == 0.25f);
  assert_true(posed.light_descs[0].position[0] == 3);
  Objects late;
  pose_objects(posed.parts, 0, 99, &late);
  assert_true(test::positions_of(late.meshes[1].get())[0] == 1 && late.instances[0].object_to_world[12] == 4);
}

/// Flat normals of a shared edge, and computed normals with one warning for the mesh.
void test_normals(void**) {
  Geometry g = test::square_geometry();
  g.position[11] = 1;  // the second triangle is tilted
  g.normal.clear();
  g.shading = Shading::kFlat;
  Objects flat, smooth;
  test::make_scene(g_context, test::model_of(g), &flat);
  const std::vector<float> normal = test::normals_of(flat.meshes[0].get());
  assert_int_equal(normal.size(), 18);
  assert_true(normal[2] == 1 && normal[5] == 1 && normal[8] == 1);
  for (size_t i = 4; i < 6; ++i) assert_true(normal[3 * i] == normal[9] && normal[9] > 0.1f);
  assert_true(flat.warnings.empty());
  g = test::square_geometry();
  g.normal = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1};
  test::make_scene(g_context, test::model_of(g), &smooth);
  assert_int_equal(smooth.warnings.size(), 1);
  assert_true(test::normals_of(smooth.meshes[0].get())[2] == 1 && test::normals_of(smooth.meshes[0].get())[11] == -1);
}

/// A grey PNG of one pixel with the chunk gAMA of linear light.
std::vector<unsigned char> make_linear_png() {
  const auto chunk = [](std::string data) {
    uint32_t crc = ~0u;
    std::string out(4, '\0');
    for (const unsigned char byte : data) {
      crc ^= byte;
      for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    out[3] = static_cast<char>(data.size() - 4);
    for (int shift = 24; shift >= 0; shift -= 8) data += static_cast<char>(~crc >> shift);
    return out + data;
  };
  using namespace std::string_literals;
  const std::string pixels = "\x78\x01\x01\x02\x00\xfd\xff\x00\x80\x00\x82\x00\x81"s;  // RFC 1950, stored
  const std::string file = "\x89PNG\r\n\x1a\n" + chunk("IHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0"s) +
                           chunk("gAMA\0\1\x86\xa0"s) + chunk("IDAT" + pixels) + chunk("IEND");
  return {file.begin(), file.end()};
}

/// glTF 2.0, 5.19: colour information of an image is ignored. Other models have that of the file.
void test_encoding(void**) {
  for (const bool srgb : {false, true}) {
    Model model = test::model_of(test::square_geometry());
    TextureSource source;
    source.file = make_linear_png();
    source.srgb = srgb;
    model.textures.push_back(source);
    Objects scene;
    test::make_scene(g_context, std::move(model), &scene);
    shd_texture_info info = shd_texture_info_default();
    assert_true(scene.warnings.empty() && scene.parts->warnings.empty());
    shd_assert_ok(shd_texture_get_info(scene.parts->textures[0].get(), &info));
    assert_int_equal(info.format, srgb ? SHD_FORMAT_RGBA8_SRGB : SHD_FORMAT_RGBA8);
  }
}

/// Tangents follow uv. A normal map at uv1 has none.
void test_tangents(void**) {
  for (const uint32_t set : {0u, 1u}) {
    Model model = test::model_of(test::square_geometry());
    Geometry& g = model.geometries[0];
    g.uv = g.uv1 = {0, 0, 0, 0, 0, 0, 0, 0};
    model.textures.emplace_back();
    model.textures[0].rgba = {128, 128, 255, 255};
    model.textures[0].width = model.textures[0].height = 1;
    model.surfaces[0].maps[SHD_SLOT_NORMAL].texture = 0;
    model.surfaces[0].maps[SHD_SLOT_NORMAL].uv_set = set;
    Objects scene;
    test::make_scene(g_context, std::move(model), &scene);
    shd_mesh_info info = shd_mesh_info_default();
    shd_assert_ok(shd_mesh_get_info(scene.meshes[0].get(), &info));
    assert_int_equal(info.tangentless_count, set == 0 ? 4 : 0);  // uv gives no direction
  }
}

}  // namespace

int main() {
  if (shd_context_create(nullptr, &g_context) != SHD_OK) return 1;
  const CMUnitTest tests[] = {
      cmocka_unit_test(test_cull),     cmocka_unit_test(test_materials), cmocka_unit_test(test_transmission_warning),
      cmocka_unit_test(test_filters),  cmocka_unit_test(test_colors),    cmocka_unit_test(test_far),
      cmocka_unit_test(test_sizes),    cmocka_unit_test(test_pose),      cmocka_unit_test(test_normals),
      cmocka_unit_test(test_encoding), cmocka_unit_test(test_tangents),
  };
  const int failures = cmocka_run_group_tests_name("unit.scene.objects", tests, nullptr, nullptr);
  shd_context_release(g_context);
  return failures;
}
