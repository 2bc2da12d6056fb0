// SPDX-License-Identifier: MIT
// MTL files to surfaces, by the MTL specification (Wavefront, 1995) and the PBR statements of later programs.
#include <cmath>
#include <cstring>

#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

const char kObj[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n";

Model read_mtl(const std::string& statements) {
  return read_text(std::string("mtllib m.mtl\n") + kObj, "m.obj", {{"m.mtl", "newmtl m\n" + statements + "\n"}});
}

/// One number of the surface, and a warning ("" = none).
struct Number {
  const char *name, *text;
  double (*get)(const Surface& surface);
  double wanted;
  const char* warning;
};

#define GET(expression) [](const Surface& s) { return static_cast<double>(expression); }

const Number kNumbers[] = {
    {"kd", "Kd 0.25 0.5 0.75", GET(s.diffuse[1]), 0.5, ""},
    {"kd/one_number", "Kd .25", GET(s.diffuse[2]), 0.25, ""},
    {"kd/absent", "Ks 0 0 0", GET(s.diffuse[0]), 0.6f, ""},
    {"kd/absent_with_map", "map_Kd a.png", GET(s.diffuse[0]), 1, ""},
    {"kd/black_with_map", "Kd 0 0 0\nmap_Kd a.png", GET(s.diffuse[0]), 1, ""},
    {"kd/comment", "Kd 1 0.5 1 # pink", GET(s.diffuse[1]), 0.5, ""},
    {"kd/spectral", "Kd spectral a.rfl 1", GET(s.diffuse[1]), 0.6f, "values of kd are not understood"},
    {"kd/xyz", "Kd xyz 1 1 1", GET(s.diffuse[1]), 0.6f, "values of kd are not understood"},
    {"ks", "Ks 0.5 0.5 1\nNs 20", GET(s.specular[2]), 1, ""},
    {"ns", "Ns 20", GET(s.exponent), 20, ""},
    {"ns/zero", "Ns 0", GET(s.exponent), 1, ""},
    {"ns/zero_no_highlight", "Ks 1 1 1\nNs 0", GET(s.specular[0]), 0, ""},
    {"ke", "Ke 0 2 0", GET(s.emission[1]), 2, ""},
    {"ke/map", "map_Ke a.png", GET(s.emission[1]), 1, ""},
    {"d", "d 0.25", GET(s.opacity), 0.25, ""},
    {"d/zero", "d 0", GET(s.opacity), 1, ""},
    {"d/blend", "d 0.25", GET(s.alpha == Alpha::kBlend), 1, ""},
    {"d/one", "d 1", GET(s.alpha == Alpha::kOpaque), 1, ""},
    {"d/halo", "d -halo 0.5", GET(s.opacity), 0.5, "-halo"},
    {"tr", "Tr 0.25", GET(s.opacity), 0.75, ""},
    {"tr/d_first", "d 0.5\nTr 0.25", GET(s.opacity), 0.5, ""},
    {"ni", "Ni 1.33", GET(s.ior), 1.33f, ""},
    {"ni/one", "Ni 1", GET(s.ior), 1.5, ""},
    {"illum/0", "illum 0", GET(s.unlit), 1, ""},
    {"illum/1", "Ks 1 1 1\nNs 20\nillum 1", GET(s.specular[0]), 0, ""},
    {"illum/negative", "illum -1", GET(s.unlit), 0, "values of illum are not understood"},
    {"pbr/illum_0", "Pr 0.5\nillum 0", GET(s.unlit), 1, ""},
    {"pbr/illum_3", "Pr 0.5\nillum 3", GET(s.unlit), 0, "illum 3"},
    {"pbr/pc_alone", "Pc 0.5", GET(s.metallic_roughness), 0, "Pc without Pr or Pm"},
    {"illum/3", "illum 3", GET(s.unlit), 0, "illum 3"},
    {"ka/grey", "Ka 0.2 0.2 0.2", GET(s.diffuse[0]), 0.6f, ""},
    {"ka/colour", "Ka 1 0 0", GET(s.diffuse[0]), 0.6f, "Ka is left out"},
    {"tf", "Tf 1 1 0", GET(s.opacity), 1, "Tf (transmission filter)"},
    {"pbr/pr", "Pr 0.25", GET(s.roughness), 0.25, ""},
    {"pbr/model", "Pr 0.25", GET(s.metallic_roughness), 1, ""},
    {"pbr/pm", "Pm 0.75", GET(s.metallic), 0.75, ""},
    {"pbr/pm_map", "map_Pm a.png", GET(s.metallic), 1, ""},
    {"pbr/pc", "Pr 1\nPc 0.5\nPcr 0.125", GET(s.clearcoat), 0.5, ""},
    {"pbr/pcr", "Pr 1\nPc 0.5\nPcr 0.125", GET(s.clearcoat_roughness), 0.125, ""},
    {"pbr/ps", "Ps 0.5", GET(s.metallic_roughness), 0, "Ps (sheen)"},
    {"pbr/aniso", "aniso 0.05", GET(s.opacity), 1, "aniso (anisotropy)"},
    {"pbr/anisor", "anisor 0.1", GET(s.opacity), 1, "anisor (rotation"},
    {"pbr/aniso_zero", "aniso 0\nanisor 0", GET(s.opacity), 1, ""},
    {"unknown", "sharpness 60\nsharpness 70", GET(s.opacity), 1, "sharpness is left out"},
    {"indented", "  Kd 1 0.5 1", GET(s.diffuse[1]), 0.5, ""},
    {"double_sided", "Kd 1 1 1", GET(s.double_sided), 1, ""},
};

void test_number(void** state) {
  const Number& row = *static_cast<const Number*>(*state);
  const Model model = read_mtl(row.text);
  shd_assert_close(row.name, 0, row.get(model.surfaces[0]), row.wanted, 1e-7, 0);
  if (*row.warning ? !has_warning(model, row.warning) : !model.warnings.empty()) {
    fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
  }
  assert_true(model.warnings.size() <= 1);
}

/// A map statement: the slot, the file, and uv (0.25, 0.25 downwards) after the transform.
struct Maps {
  const char *name, *text;
  shd_slot_target target;
  const char* file;
  float u, v;
  const char* warning;
};

const Maps kMaps[] = {
    {"map/kd", "map_Kd a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, ""},
    {"map/trailing_blank", "map_Kd a.png ", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, ""},
    {"map/trailing_tab", "map_Kd a.png\t", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, ""},
    {"map/trailing_cr", "map_Kd a.png \r", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, ""},
    {"map/blanks", "map_Kd my  own map.png", SHD_SLOT_DIFFUSE, "my  own map.png", 0.25f, 0.25f, ""},
    {"map/scale", "map_Kd -s 2 4 1 a.png", SHD_SLOT_DIFFUSE, "a.png", 0.5f, -2, ""},
    {"map/scale_short", "map_Kd -s 2 a.png", SHD_SLOT_DIFFUSE, "a.png", 0.5f, 0.25f, ""},
    {"map/scale_and_number", "map_Kd -s 2 4 8", SHD_SLOT_DIFFUSE, "8", 0.5f, -2, ""},
    {"map/offset", "map_Kd -o 0.5 0.25 0 a.png", SHD_SLOT_DIFFUSE, "a.png", 0.75f, 0, ""},
    {"map/both", "map_Kd -o 0.5 0 -s 2 2 a b.png", SHD_SLOT_DIFFUSE, "a b.png", 1, -0.5f, ""},
    {"map/blend_on", "map_Kd -blendu on -blendv on -cc off a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, ""},
    {"map/blend_off", "map_Kd -blendu off a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, "option -blendu of map_kd"},
    {"map/turbulence", "map_Kd -t 1 1 1 a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, "option -t of map_kd"},
    {"map/gain", "map_Kd -mm 0 2 a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, "option -mm of map_kd"},
    {"map/gain_one", "map_Kd -mm 0 1 a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, ""},
    {"map/type", "map_Kd -type sphere a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, "option -type of map_kd"},
    {"map/dash_name", "map_Kd -a.png", SHD_SLOT_DIFFUSE, "-a.png", 0.25f, 0.25f, ""},
    {"map/ks", "map_Ks a.png", SHD_SLOT_SPECULAR, "a.png", 0.25f, 0.25f, ""},
    {"map/ns", "map_Ns a.png", SHD_SLOT_EXPONENT, "a.png", 0.25f, 0.25f, ""},
    {"map/d", "map_d a.png", SHD_SLOT_OPACITY, "a.png", 0.25f, 0.25f, ""},
    {"map/ke", "map_Ke a.png", SHD_SLOT_EMISSION, "a.png", 0.25f, 0.25f, ""},
    {"map/bump", "map_Bump -bm 0.5 a.png", SHD_SLOT_HEIGHT, "a.png", 0.25f, 0.25f, ""},
    {"map/bump_short", "bump a.png", SHD_SLOT_HEIGHT, "a.png", 0.25f, 0.25f, ""},
    {"map/norm", "norm a.png", SHD_SLOT_NORMAL, "a.png", 0.25f, 0.25f, ""},
    {"map/norm_scale", "norm -bm 2 a.png", SHD_SLOT_NORMAL, "a.png", 0.25f, 0.25f, ""},
    {"map/quotes", "map_Kd \"a b.png\"", SHD_SLOT_DIFFUSE, "a b.png", 0.25f, 0.25f, ""},
    {"map/twice", "map_Kd b.png\nmap_Kd a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f, "map_kd is given twice"},
    {"map/channel_of_color", "map_Kd -imfchan r a.png", SHD_SLOT_DIFFUSE, "a.png", 0.25f, 0.25f,
     "option -imfchan of map_kd"},
    {"map/ks_beside_pr", "Pr 0.5\nmap_Pr a.png\nmap_Ks b.png", SHD_SLOT_ROUGHNESS, "a.png", 0.25f, 0.25f,
     "map_ks beside Pr"},
    {"map/pr", "map_Pr a.png", SHD_SLOT_ROUGHNESS, "a.png", 0.25f, 0.25f, ""},
    {"map/pm", "map_Pm a.png", SHD_SLOT_METALLIC, "a.png", 0.25f, 0.25f, ""},
};

void test_map(void** state) {
  const Maps& row = *static_cast<const Maps*>(*state);
  const Model model = read_mtl(row.text);
  const Map& map = model.surfaces[0].maps[row.target];
  assert_int_equal(map.texture, 0);
  const TextureSource& texture = model.textures[0];
  assert_string_equal(texture.name.c_str(), row.file);
  const bool color =
      row.target == SHD_SLOT_DIFFUSE || row.target == SHD_SLOT_SPECULAR || row.target == SHD_SLOT_EMISSION;
  assert_true(texture.data == !color);
  const std::array<float, 6>& t = map.uv_transform;
  shd_assert_close(row.name, 0, t[0] * 0.25f + t[1] * 0.25f + t[2], row.u, 1e-6, 0);
  shd_assert_close(row.name, 1, t[3] * 0.25f + t[4] * 0.25f + t[5], row.v, 1e-6, 0);
  if (*row.warning ? !has_warning(model, row.warning) : !model.warnings.empty()) {
    fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
  }
}

/// Maps that are not drawn are named.
void test_other_maps(void**) {
  for (const char* const word : {"disp", "decal", "refl", "map_Ps", "map_opacity"}) {
    const Model model = read_mtl(std::string(word) + " a.png");
    assert_true(model.textures.empty() && model.warnings.size() == 1);
    assert_true(has_warning(model, std::strcmp(word, "map_Ps") ? word : "map_ps"));
  }
}

void test_options(void**) {
  const Model model = read_mtl("map_Kd -clamp on a.png\nmap_d -imfchan m b.png\nbump -bm 0.5 c.png");
  const Surface& s = model.surfaces[0];
  assert_int_equal(s.maps[SHD_SLOT_DIFFUSE].wrap_u, SHD_WRAP_CLAMP);
  assert_int_equal(s.maps[SHD_SLOT_OPACITY].channel, 3);
  assert_true(s.bump_scale == 0.5f && s.alpha == Alpha::kBlend);
  assert_true(read_mtl("bump c.png").surfaces[0].bump_scale == 1);
  assert_true(read_mtl("norm -bm 2 c.png").surfaces[0].normal_scale == 2);
  // A map_d of the same file is the alpha of the colour, unless it names a channel or lies at another place.
  const auto opacity_of = [](const char* options) {
    return read_mtl(std::string("map_Kd a.png\nmap_d ") + options + " a.png").surfaces[0].maps[SHD_SLOT_OPACITY];
  };
  assert_true(opacity_of("").texture < 0 && opacity_of("-imfchan m").texture < 0);
  assert_true(opacity_of("-imfchan g").channel == 1 && opacity_of("-s 2 2 2").texture >= 0);
}

/// Libraries: several ones, in folders, with blanks, before or after usemtl, in UTF-16, and materials with blanks.
struct Library {
  const char *name, *obj;
  const char *file, *mtl;
  const char* folder;  // folder of the texture; null = the material is not found
  const char* warning;
};

const Library kLibraries[] = {
    {"library/one", "mtllib a.mtl\n", "a.mtl", "newmtl m\n", "", ""},
    {"library/second", "mtllib gone.mtl a.mtl\n", "a.mtl", "newmtl m\n", "", "gone.mtl"},
    {"library/two_statements", "mtllib gone.mtl\nmtllib a.mtl\n", "a.mtl", "newmtl m\n", "", "gone.mtl"},
    {"library/blanks", "mtllib my own.mtl\n", "my own.mtl", "newmtl m\n", "", ""},
    {"library/blanks_of_several", "mtllib my own.mtl gone.mtl\n", "my own.mtl", "newmtl m\n", "", "gone.mtl"},
    {"library/folder", "mtllib mats/a.mtl\n", "mats/a.mtl", "newmtl m\n", "mats/", ""},
    {"library/backslash", "mtllib mats\\a.mtl\n", "mats\\a.mtl", "newmtl m\n", "mats/", ""},
    {"library/byte_order_mark", "mtllib a.mtl\n", "a.mtl", "\xef\xbb\xbfnewmtl m\n", "", ""},
    {"library/twice", "mtllib a.mtl\n", "a.mtl", "newmtl m\nKd 0 0 0\nnewmtl m\n", "", "defined twice"},
    {"library/trailing_blanks", "mtllib a.mtl \t\n", "a.mtl", "newmtl m \t\n", "", ""},
    {"library/missing", "mtllib gone.mtl\n", "a.mtl", "newmtl m\n", nullptr, "gone.mtl"},
    {"library/other_material", "mtllib a.mtl\n", "a.mtl", "newmtl n\n", nullptr, "material \"m\""},
};

void test_library(void** state) {
  const Library& row = *static_cast<const Library*>(*state);
  for (int after = 0; after < 2; ++after) {  // mtllib before and after usemtl
    const std::string text = after ? std::string(kObj) + row.obj : std::string(row.obj) + kObj;
    const Model model = read_text(text, "m.obj", {{row.file, std::string(row.mtl) + "map_Kd img/a.png\n"}});
    if (row.folder) assert_string_equal(model.textures[0].folder.c_str(), row.folder);
    const Surface& surface = model.surfaces[model.placements[0].surface];
    assert_string_equal(surface.name.c_str(), row.folder ? "m" : "default");
    if (*row.warning ? !has_warning(model, row.warning) : !model.warnings.empty()) {
      fail_msg("%s: warnings \"%s\"", row.name, warnings_of(model).c_str());
    }
  }
}

struct Name {
  const char *name, *defined, *used;
};

const Name kNames[] = {
    {"name/blanks", "my own material", "my own material"}, {"name/number_sign", "Material #25", "Material #25"},
    {"name/comment", "red", "red # for the roof"},         {"name/trailing_blank", "red ", "red  "},
    {"name/utf8", "gr\xc3\xbcn", "gr\xc3\xbcn"},
};

void test_name(void** state) {
  const Name& row = *static_cast<const Name*>(*state);
  const Model model =
      read_text("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl " + std::string(row.used) + "\nf 1 2 3\n", "m.obj",
                {{"a.mtl", std::string("newmtl ") + row.defined + "\nKd 0.5 1 1\n"}});
  assert_true(model.warnings.empty() && model.surfaces[0].diffuse[0] == 0.5f);
}

}  // namespace

int main() {
  ADD_ROWS(kNumbers, test_number);
  ADD_ROWS(kMaps, test_map);
  ADD_ROWS(kLibraries, test_library);
  ADD_ROWS(kNames, test_name);
  add("map/others", test_other_maps, nullptr);
  add("map/options", test_options, nullptr);
  return _cmocka_run_group_tests("unit.scene.mtl", g_tests, g_count, nullptr, nullptr);
}
