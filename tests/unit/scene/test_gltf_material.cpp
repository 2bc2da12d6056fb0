// SPDX-License-Identifier: MIT
// Materials, textures and samplers of glTF 2.0, and their extensions, to surfaces. Right values follow from the texts.
#include <cmath>

#include "support/gltf_file.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

/// A triangle with this material. Image 0 is a file, image 1 has another name; both have a texture, and two samplers.
Model read_material(const std::string& material,
                    const std::string& textures = "{\"source\":0,\"sampler\":0},{\"source\":1}") {
  GltfFile file;
  const std::string position = std::to_string(file.column<float>({0, 0, 0, 1, 0, 0, 1, 1, 0}, 3));
  return read_text(file.with_primitive(
      "\"attributes\":{\"POSITION\":" + position + "},\"material\":0",
      ",\"materials\":[{\"name\":\"s\"," + material + "}],\"textures\":[" + textures +
          "],\"images\":[{\"uri\":\"a.png\"},{\"uri\":\"b.png\"},{\"uri\":\"c.ktx2\"}],\"samplers\":[{\"wrapS\":33071,"
          "\"wrapT\":33648,\"magFilter\":9728,\"minFilter\":9985}]"));
}

#define EXTENSION(name, members) "\"extensions\":{\"" name "\":{" members "}}"

/// A material, the function that takes a number of its surface, the right number, and a warning ("" = none).
struct Row {
  const char* name;
  const char* material;
  double (*value)(const Surface& s);
  double want;
  const char* warning;
};

const Row kRows[] = {
    {"core/default_metallic", "\"doubleSided\":false", [](const Surface& s) { return double(s.metallic); }, 1, ""},
    {"core/default_roughness", "\"doubleSided\":false", [](const Surface& s) { return double(s.roughness); }, 1, ""},
    {"core/base", "\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.25,0.5,1,0.75]}",
     [](const Surface& s) { return double(s.diffuse[1]); }, 0.5, ""},
    {"core/opacity", "\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.25,0.5,1,0.75]}",
     [](const Surface& s) { return double(s.opacity); }, 0.75, ""},
    {"core/single_sided", "\"alphaMode\":\"OPAQUE\"", [](const Surface& s) { return double(s.double_sided); }, 0, ""},
    {"core/double_sided", "\"doubleSided\":true", [](const Surface& s) { return double(s.double_sided); }, 1, ""},
    {"core/normal_scale", "\"normalTexture\":{\"index\":0,\"scale\":2}",
     [](const Surface& s) { return double(s.normal_scale); }, 2, ""},
    {"core/occlusion", "\"occlusionTexture\":{\"index\":0,\"strength\":0.25}",
     [](const Surface& s) { return double(s.occlusion_strength); }, 0.25, ""},
    {"alpha/mask", "\"alphaMode\":\"MASK\"", [](const Surface& s) { return double(s.alpha == Alpha::kMask); }, 1, ""},
    {"alpha/blend", "\"alphaMode\":\"BLEND\"", [](const Surface& s) { return double(s.alpha == Alpha::kBlend); }, 1,
     ""},
    {"alpha/default_cutoff", "\"alphaMode\":\"MASK\"", [](const Surface& s) { return double(s.alpha_cutoff); }, 0.5,
     ""},
    {"alpha/cutoff_0", "\"alphaMode\":\"MASK\",\"alphaCutoff\":0",
     [](const Surface& s) { return double(s.alpha_cutoff); }, 0, ""},
    {"alpha/cutoff_above_1", "\"alphaMode\":\"MASK\",\"alphaCutoff\":1.5",
     [](const Surface& s) { return double(s.alpha_cutoff); }, 1.5, ""},
    {"alpha/unknown", "\"alphaMode\":\"DITHER\"", [](const Surface& s) { return double(s.alpha == Alpha::kOpaque); }, 1,
     "\"DITHER\""},
    {"emission",
     "\"emissiveFactor\":[0.1,0.05,0.02]," EXTENSION("KHR_materials_emissive_strength", "\"emissiveStrength\":5"),
     [](const Surface& s) { return double(s.emission[0]); }, 0.5, ""},
    {"unlit", EXTENSION("KHR_materials_unlit", ""), [](const Surface& s) { return double(s.unlit); }, 1, ""},
    {"ior", EXTENSION("KHR_materials_ior", "\"ior\":1.33"), [](const Surface& s) { return double(s.ior); }, 1.33, ""},
    {"ior/default", "\"doubleSided\":false", [](const Surface& s) { return double(s.ior); }, 1.5, ""},
    {"ior/0", "\"pbrMetallicRoughness\":{\"metallicFactor\":0}," EXTENSION("KHR_materials_ior", "\"ior\":0"),
     [](const Surface& s) { return s.specular_glossiness ? double(s.specular[1]) : -1; }, 1, ""},
    {"ior/diamond",
     "\"pbrMetallicRoughness\":{\"metallicFactor\":0},\"extensions\":{\"KHR_materials_ior\":{\"ior\":2.4},"
     "\"KHR_materials_transmission\":{\"transmissionFactor\":1}}",
     [](const Surface& s) { return s.specular_glossiness ? -1 : double(s.ior); }, 2.4f, ""},
    {"ior/0_metal", EXTENSION("KHR_materials_ior", "\"ior\":0"), [](const Surface& s) { return double(s.ior); }, 0,
     "0 or above 10"},
    {"specular/strong",
     "\"pbrMetallicRoughness\":{\"metallicFactor\":0},\"extensions\":{\"KHR_materials_ior\":{\"ior\":1000},"
     "\"KHR_materials_specular\":{\"specularFactor\":0.5,\"specularColorFactor\":[0.08,1,0]}}",
     [](const Surface& s) { return s.specular_glossiness ? double(s.specular[0]) : -1; }, 0.03984032, ""},
    {"specular/strong_texture",
     "\"extensions\":{\"KHR_materials_ior\":{\"ior\":1000},\"KHR_materials_specular\":{\"specularColorTexture\":"
     "{\"index\":0}}}",
     [](const Surface& s) { return double(s.ior); }, 1.5, "KHR_materials_specular"},
    {"specular/weak_colour",
     "\"pbrMetallicRoughness\":{\"metallicFactor\":0}," EXTENSION("KHR_materials_specular",
                                                                  "\"specularColorFactor\":[1,0,0]"),
     [](const Surface& s) { return double(s.specular[0]); }, 0.04, "colour of a weak reflection"},
    {"specular/0", EXTENSION("KHR_materials_specular", "\"specularFactor\":0"),
     [](const Surface& s) { return double(s.ior); }, 1, "KHR_materials_specular"},
    {"specular/1", EXTENSION("KHR_materials_specular", "\"specularFactor\":1"),
     [](const Surface& s) { return double(s.ior); }, 1.5, ""},
    {"specular/quarter", EXTENSION("KHR_materials_specular", "\"specularFactor\":0.25"),  // F0 0.04 becomes 0.01
     [](const Surface& s) { return std::pow((double(s.ior) - 1) / (double(s.ior) + 1), 2); }, 0.01,
     "KHR_materials_specular"},
    {"transmission", EXTENSION("KHR_materials_transmission", "\"transmissionFactor\":0.75"),
     [](const Surface& s) { return double(s.transmission); }, 0.75, ""},
    {"transmission/texture",
     EXTENSION("KHR_materials_transmission", "\"transmissionFactor\":1,\"transmissionTexture\":{\"index\":0}"),
     [](const Surface& s) { return double(s.transmission); }, 1, "transmissionTexture"},
    {"clearcoat", EXTENSION("KHR_materials_clearcoat", "\"clearcoatFactor\":0.5,\"clearcoatRoughnessFactor\":0.25"),
     [](const Surface& s) { return double(s.clearcoat + s.clearcoat_roughness); }, 0.75, ""},
    {"specgloss/base", EXTENSION("KHR_materials_pbrSpecularGlossiness", "\"diffuseFactor\":[0.1,0.4,0.9,0.5]"),
     [](const Surface& s) { return double(s.diffuse[2]); }, 0.9, ""},
    {"specgloss/opacity", EXTENSION("KHR_materials_pbrSpecularGlossiness", "\"diffuseFactor\":[0.1,0.4,0.9,0.5]"),
     [](const Surface& s) { return double(s.opacity); }, 0.5, ""},
    {"specgloss/specular", EXTENSION("KHR_materials_pbrSpecularGlossiness", "\"specularFactor\":[0.03,0.5,2]"),
     [](const Surface& s) { return double(s.specular[0] + s.specular[1] + s.specular[2]); }, 1.53, ""},
    {"specgloss/specular_default", EXTENSION("KHR_materials_pbrSpecularGlossiness", ""),
     [](const Surface& s) { return double(s.specular[1]); }, 1, ""},
    {"specgloss/roughness", EXTENSION("KHR_materials_pbrSpecularGlossiness", "\"glossinessFactor\":0.75"),
     [](const Surface& s) { return double(s.roughness); }, 0.25, ""},
    {"specgloss/kind", EXTENSION("KHR_materials_pbrSpecularGlossiness", ""),
     [](const Surface& s) { return double(s.specular_glossiness); }, 1, ""},
    {"fault", "\"pbrMetallicRoughness\":{\"roughnessFactor\":\"rough\"}",
     [](const Surface& s) { return double(s.roughness); }, 1, "roughnessFactor: is not a number"},
    {"ignored/sheen", EXTENSION("KHR_materials_sheen", ""), [](const Surface&) { return 0.0; }, 0,
     "KHR_materials_sheen"},
    {"ignored/anisotropy", EXTENSION("KHR_materials_anisotropy", ""), [](const Surface&) { return 0.0; }, 0,
     "KHR_materials_anisotropy"},
    {"ignored/iridescence", EXTENSION("KHR_materials_iridescence", ""), [](const Surface&) { return 0.0; }, 0,
     "KHR_materials_iridescence"},
    {"ignored/volume", EXTENSION("KHR_materials_volume", ""), [](const Surface&) { return 0.0; }, 0,
     "KHR_materials_volume"},
    {"ignored/dispersion", EXTENSION("KHR_materials_dispersion", ""), [](const Surface&) { return 0.0; }, 0,
     "KHR_materials_dispersion"},
};

void test_row(void** state) {
  const Row& row = *static_cast<const Row*>(*state);
  const Model model = read_material(row.material);
  assert_string_equal(model.surfaces[0].name.c_str(), "s");
  assert_true(model.surfaces[0].metallic_roughness);
  shd_assert_close(row.name, 0, row.value(model.surfaces[0]), row.want, 1e-6, 0);
  if (*row.warning ? model.warnings.size() != 1 || !has_warning(model, row.warning) : !model.warnings.empty()) {
    fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
  }
}

/// A texture info: its slot, channel, set of texture coordinates, and whether it is data.
struct Slot {
  const char* name;
  const char* material;
  shd_slot_target target;
  uint32_t channel, uv_set;
  bool data;
};

const Slot kSlots[] = {
    {"slot/base", "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"texCoord\":1}}", SHD_SLOT_DIFFUSE, 0,
     1, false},
    {"slot/metallic", "\"pbrMetallicRoughness\":{\"metallicRoughnessTexture\":{\"index\":0}}", SHD_SLOT_METALLIC, 2, 0,
     true},
    {"slot/roughness", "\"pbrMetallicRoughness\":{\"metallicRoughnessTexture\":{\"index\":0}}", SHD_SLOT_ROUGHNESS, 1,
     0, true},
    {"slot/normal", "\"normalTexture\":{\"index\":0}", SHD_SLOT_NORMAL, 0, 0, true},
    {"slot/occlusion", "\"occlusionTexture\":{\"index\":0}", SHD_SLOT_OCCLUSION, 0, 0, true},
    {"slot/emission", "\"emissiveTexture\":{\"index\":0}", SHD_SLOT_EMISSION, 0, 0, false},
    {"slot/clearcoat", EXTENSION("KHR_materials_clearcoat", "\"clearcoatTexture\":{\"index\":0}"), SHD_SLOT_CLEARCOAT,
     0, 0, true},
    {"slot/clearcoat_roughness", EXTENSION("KHR_materials_clearcoat", "\"clearcoatRoughnessTexture\":{\"index\":0}"),
     SHD_SLOT_CLEARCOAT_ROUGHNESS, 1, 0, true},
    {"slot/clearcoat_normal", EXTENSION("KHR_materials_clearcoat", "\"clearcoatNormalTexture\":{\"index\":0}"),
     SHD_SLOT_CLEARCOAT_NORMAL, 0, 0, true},
    {"slot/specgloss", EXTENSION("KHR_materials_pbrSpecularGlossiness", "\"diffuseTexture\":{\"index\":0}"),
     SHD_SLOT_DIFFUSE, 0, 0, false},
    {"slot/specgloss_specular",
     EXTENSION("KHR_materials_pbrSpecularGlossiness", "\"specularGlossinessTexture\":{\"index\":0}"), SHD_SLOT_SPECULAR,
     0, 0, false},
    {"slot/transform_texcoord",
     "\"emissiveTexture\":{\"index\":0,\"texCoord\":0," EXTENSION("KHR_texture_transform", "\"texCoord\":1") "}",
     SHD_SLOT_EMISSION, 0, 1, false},
};

void test_slot(void** state) {
  const Slot& row = *static_cast<const Slot*>(*state);
  const Model model = read_material(row.material);
  const Map& map = model.surfaces[0].maps[row.target];
  assert_true(model.warnings.empty());
  assert_int_equal(map.texture, 0);
  assert_int_equal(map.channel, row.channel);
  assert_int_equal(map.uv_set, row.uv_set);
  assert_int_equal(model.textures[0].data, row.data);
  assert_string_equal(model.textures[0].name.c_str(), "a.png");
  assert_true(map.wrap_u == SHD_WRAP_CLAMP && map.wrap_v == SHD_WRAP_MIRROR && map.magnify == Filter::kNearest);
  assert_true(map.minify == Filter::kLinear && map.mip == Filter::kNearest && !map.no_mip);
}

/// KHR_texture_transform, "translation * rotation * scale": (u, v) = (1, 0) and (0, 1) through it.
void test_transform(void**) {
  const Model model = read_material("\"emissiveTexture\":{\"index\":0," EXTENSION(
      "KHR_texture_transform", "\"offset\":[0.5,0.25],\"rotation\":1.5707963267948966,\"scale\":[2,3]") "}");
  const std::array<float, 6>& t = model.surfaces[0].maps[SHD_SLOT_EMISSION].uv_transform;
  const double want[6] = {0, 3, 0.5, -2, 0, 0.25};
  for (size_t i = 0; i < 6; ++i) shd_assert_close("transform", i, t[i], want[i], 1e-6, 0);
}

/// The image of a texture, by its extensions.
struct Image {
  const char *name, *texture, *image, *warning;
};

const Image kImages[] = {
    {"image/core", "{\"source\":1}", "b.png", ""},
    {"image/webp", "{\"source\":1," EXTENSION("EXT_texture_webp", "\"source\":0") "}", "a.png", ""},
    {"image/webp_alone", "{" EXTENSION("EXT_texture_webp", "\"source\":0") "}", "a.png", ""},
    {"image/basisu", "{\"source\":1," EXTENSION("KHR_texture_basisu", "\"source\":2") "}", "b.png",
     "KHR_texture_basisu"},
    {"image/basisu_alone", "{" EXTENSION("KHR_texture_basisu", "\"source\":2") "}", "c.ktx2", "KHR_texture_basisu"},
    {"image/none", "{}", "", "textures[0]: has no image"},
    {"image/out_of_range", "{\"source\":7}", "", "textures[0].source: 7"},
};

void test_image(void** state) {
  const Image& row = *static_cast<const Image*>(*state);
  const Model model = read_material("\"emissiveTexture\":{\"index\":0}", row.texture);
  assert_string_equal(model.textures.empty() ? "" : model.textures[0].name.c_str(), row.image);
  if (*row.warning ? !has_warning(model, row.warning) : !model.warnings.empty()) {
    fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
  }
}

/// An image as colours and as data is two textures; sets of texture coordinates above 1 are left out.
void test_uses(void**) {
  const Model model = read_material(
      "\"emissiveTexture\":{\"index\":0},\"normalTexture\":{\"index\":0},"
      "\"occlusionTexture\":{\"index\":1,\"texCoord\":2}");
  assert_int_equal(model.textures.size(), 2);
  assert_true(has_warning(model, "texCoord 2"));
}

/// Section 3.9.6: the material of a primitive without one.
void test_default(void**) {
  GltfFile file;
  const Model model =
      read_text(file.with_primitive("\"attributes\":{\"POSITION\":" + std::to_string(file.square()) + "}"));
  const Surface& s = model.surfaces.at(model.placements[0].surface);
  assert_true(s.metallic_roughness && s.metallic == 1 && s.roughness == 1 && s.diffuse[0] == 1 && !s.double_sided);
}

}  // namespace

int main() {
  ADD_ROWS(kRows, test_row);
  ADD_ROWS(kSlots, test_slot);
  ADD_ROWS(kImages, test_image);
  add("transform", test_transform, nullptr);
  add("uses", test_uses, nullptr);
  add("default", test_default, nullptr);
  return _cmocka_run_group_tests("unit.scene.gltf_material", g_tests, g_count, nullptr, nullptr);
}
