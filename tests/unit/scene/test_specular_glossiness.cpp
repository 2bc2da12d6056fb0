// SPDX-License-Identifier: MIT
// Surfaces of KHR_materials_pbrSpecularGlossiness become metallic-roughness surfaces: factors, and textures texel by
// texel. Right values follow from the equations of appendix B of glTF 2.0: base (1 - metallic) is the diffuse colour,
// and .04 (1 - metallic) + base metallic the colour at normal incidence.
#include <cmath>
#include <cstring>

#include "core/failure.h"
#include "scene/specular_glossiness.h"
#include "support/check.h"
#include "support/random.h"

namespace {

using namespace shd::scene;

shd_context* g_context;

using Texels = std::vector<std::array<float, 4>>;

Texture texture_of(uint32_t width, uint32_t height, const Texels& texels) {
  shd_texture_desc desc = shd_texture_desc_default();
  Texture out;
  desc.format = SHD_FORMAT_RGBA32F;
  desc.width = width;
  desc.height = height;
  desc.texels = texels.data();
  shd_assert_ok(shd_texture_create(g_context, &desc, out.out()));
  return out;
}

/// A model of one surface; texture 0 is its diffuse map, texture 1 its specular one.
struct Fixture {
  Model model;
  Limits limits;
  Deadline deadline{60};
  TextureLoad load{g_context, SHD_TABLE_NONE, limits, deadline, 0, {}, {}};
  std::vector<std::string> warnings;

  Fixture(Texture&& diffuse, Texture&& specular) {
    Surface s;
    s.metallic_roughness = s.specular_glossiness = true;
    s.diffuse = s.specular = {1, 1, 1};
    s.roughness = 0;
    s.maps[SHD_SLOT_DIFFUSE].texture = diffuse.get() ? 0 : -1;
    s.maps[SHD_SLOT_SPECULAR].texture = specular.get() ? 1 : -1;
    model.surfaces.push_back(s);
    add_texture(load, std::move(diffuse), "diffuse");
    add_texture(load, std::move(specular), "specular");
  }
  Surface& surface() { return model.surfaces[0]; }
  void convert() { convert_surfaces(load, model, &warnings); }

  /// Texels of a map of the surface, row after row.
  Texels read(shd_slot_target target, shd_texture_info* info) {
    shd_texture* const texture = load.textures[size_t(surface().maps[target].texture)].get();
    *info = shd_texture_info_default();
    shd_assert_ok(shd_texture_get_info(texture, info));
    shd_sampler_desc plain = shd_sampler_desc_default();
    plain.filter = SHD_FILTER_NEAREST;
    Sampler sampler;
    shd_assert_ok(shd_sampler_create(g_context, &plain, sampler.out()));
    Texels out(size_t{info->width} * info->height);
    for (size_t i = 0; i < out.size(); ++i) {
      const float u = (float(i % info->width) + 0.5f) / float(info->width);
      const float v = (float(i / info->width) + 0.5f) / float(info->height);
      shd_lookups lookups = shd_lookups_default();
      shd_texels texels = shd_texels_default();
      lookups.count = 1;
      lookups.u = shd_f32_column(&u, 4), lookups.v = shd_f32_column(&v, 4);
      for (size_t c = 0; c < 4; ++c) texels.channel[c] = shd_f32_out_column(&out[i][c], 4);
      shd_assert_ok(shd_texture_sample(texture, sampler.get(), &lookups, &texels));
    }
    return out;
  }
};

/// Greys have one solution of the equations. Without a base in 0..1, or below the dielectric, there is no metal.
void test_equations(void**) {
  shd::tests::Random random = {31};
  size_t metals = 0;
  for (int i = 0; i < 10000; ++i) {
    const float d = random.real(0.0, 1.0), s = random.real(0.0, 1.0);
    const BaseMetal made = convert_specular({d, d, d}, {s, s, s});
    const double base = double(made.base[0]), m = double(made.metallic);
    assert_true(m >= 0 && m <= 1 && base >= 0 && base <= 1);
    if (s < 0.04f) assert_true(m == 0);
    if (s < 0.04f || base >= 0.999) continue;
    ++metals;
    shd_assert_close("diffuse", i, base * (1 - m), double(d) * (1 - double(s)), 2e-4, 0);
    shd_assert_close("specular", i, 0.04 * (1 - m) + base * m, double(s), 2e-4, 0);
  }
  assert_true(metals > 1000);
}

void test_factors(void**) {
  Fixture dielectric({}, {}), metal({}, {}), missing({}, {});
  dielectric.surface().diffuse = {0.1f, 0.4f, 0.9f};
  dielectric.surface().specular = {0.03f, 0.03f, 0.03f};
  dielectric.convert();
  const double ior = double(dielectric.surface().ior);
  shd_assert_close("base", 0, double(dielectric.surface().diffuse[2]), 0.9 * 0.97, 1e-6, 0);
  shd_assert_close("f0", 0, std::pow((ior - 1) / (ior + 1), 2), 0.03, 1e-6, 0);
  assert_true(dielectric.surface().metallic == 0);
  metal.surface().diffuse = {0, 0, 0};
  metal.surface().specular = {0.8f, 0.6f, 0.2f};
  metal.convert();
  shd_assert_close("metallic", 0, double(metal.surface().metallic), 1, 1e-6, 0);
  shd_assert_close("metal", 0, double(metal.surface().diffuse[1]), 0.6, 1e-6, 0);
  missing.surface().maps[SHD_SLOT_SPECULAR].texture = 1;  // it could not be loaded
  missing.convert();
  assert_true(missing.surface().metallic == 0 && missing.surface().roughness == 0.5f);
  for (Fixture* f : {&dielectric, &metal, &missing}) {
    assert_true(f->load.textures.size() == 2 && f->warnings.empty());
    for (const Map& map : f->surface().maps) assert_int_equal(map.texture, -1);
  }
}

/// A red dielectric and a yellow metal; the smaller map is read between its texels.
void test_textures(void**) {
  Fixture f(texture_of(2, 1, {{1, 0, 0, 0.5f}, {0, 0, 0, 1}}),
            texture_of(2, 2, {{0.04f, 0.04f, 0.04f, 1}, {0.8f, 0.6f, 0.2f, 0.25f}, {0, 0, 0, 0}, {1, 1, 1, 1}}));
  f.surface().maps[SHD_SLOT_DIFFUSE].magnify = Filter::kNearest;
  f.surface().roughness = 0.5f;  // glossiness 0.5
  f.convert();
  shd_texture_info info;
  const Texels base = f.read(SHD_SLOT_DIFFUSE, &info);
  assert_true(info.width == 2 && info.height == 2 && info.format == SHD_FORMAT_RGBA16F && info.flags == 0);
  const Texels want = {{0.96f, 0, 0, 0.5f}, {0.8f, 0.6f, 0.2f, 1}, {1, 0, 0, 0.5f}, {1, 1, 1, 1}};
  for (size_t i = 0; i < 4; ++i) {
    for (int c = 0; c < 4; ++c) shd_assert_close("base", int(i), double(base[i][c]), double(want[i][c]), 1e-3, 0);
  }
  const Texels shape = f.read(SHD_SLOT_ROUGHNESS, &info);
  const float roughness[4] = {0.5f, 0.875f, 1, 0.5f}, metallic[4] = {0, 1, 0, 1};
  for (size_t i = 0; i < 4; ++i) {
    shd_assert_close("roughness", int(i), double(shape[i][0]), double(roughness[i]), 1e-4, 0);
    shd_assert_close("metallic", int(i), double(shape[i][1]), double(metallic[i]), 1e-4, 0);
  }
  const Surface& s = f.surface();
  assert_true(s.maps[SHD_SLOT_METALLIC].channel == 1 && s.maps[SHD_SLOT_METALLIC].texture == 3);
  assert_true(s.maps[SHD_SLOT_DIFFUSE].magnify == Filter::kNearest && s.maps[SHD_SLOT_SPECULAR].texture == -1);
  assert_true(s.metallic == 1 && s.roughness == 1 && s.diffuse[0] == 1 && f.warnings.empty());
  assert_string_equal(f.load.names[2].c_str(), " (base colour)");
}

/// One map alone takes the factor of the other one; blended colours are premultiplied.
void test_one_texture(void**) {
  shd_texture_info info;
  Fixture specular({}, texture_of(1, 1, {{0.04f, 0.04f, 0.04f, 0.5f}}));
  specular.surface().diffuse = {0.5f, 0.25f, 0};
  specular.convert();
  const Texels base = specular.read(SHD_SLOT_DIFFUSE, &info);
  shd_assert_close("factor", 0, double(base[0][1]), 0.24, 1e-3, 0);
  shd_assert_close("alpha", 0, double(base[0][3]), 1, 0, 0);
  Fixture diffuse(texture_of(1, 1, {{1, 0.5f, 0, 0.5f}}), {});
  diffuse.surface().specular = {0.04f, 0.04f, 0.04f};
  diffuse.surface().alpha = Alpha::kBlend;
  diffuse.convert();
  const Texels blended = diffuse.read(SHD_SLOT_DIFFUSE, &info);
  assert_int_equal(info.flags, SHD_TEXTURE_PREMULTIPLIED);
  shd_assert_close("premultiplied", 0, double(blended[0][0]), 0.48, 1e-3, 0);
  shd_assert_close("alpha", 1, double(blended[0][3]), 0.5, 0, 0);
}

/// Cases without conversion: maps at different places, unlit surfaces, and more texels than the budget has.
void test_left_out(void**) {
  const auto texel = [] { return texture_of(1, 1, {{1, 1, 1, 1}}); };
  Fixture apart(texel(), texel()), unlit(texel(), texel()),
      large(texture_of(1, 64, Texels(64)), texture_of(64, 1, Texels(64)));
  apart.surface().maps[SHD_SLOT_SPECULAR].uv_set = 1;
  apart.surface().specular = {0.03f, 0.03f, 0.03f};
  apart.convert();
  assert_int_equal(apart.warnings.size(), 1);
  assert_non_null(strstr(apart.warnings[0].c_str(), "specularGlossinessTexture is left out"));
  assert_true(apart.surface().maps[SHD_SLOT_DIFFUSE].texture == 0 && apart.surface().roughness == 0.5f);
  unlit.surface().unlit = true;
  unlit.convert();
  assert_true(unlit.surface().maps[SHD_SLOT_DIFFUSE].texture == 0 && unlit.load.textures.size() == 2);
  large.limits.texture_bytes = 12 * 64 * 64;
  try {
    large.convert();
    fail_msg("no failure");
  } catch (const shd::core::Failure& failure) {
    assert_int_equal(failure.code, SHD_ERROR_LIMIT);
  }
}

}  // namespace

int main() {
  if (shd_context_create(nullptr, &g_context) != SHD_OK) return 1;
  const CMUnitTest tests[] = {cmocka_unit_test(test_equations), cmocka_unit_test(test_factors),
                              cmocka_unit_test(test_textures), cmocka_unit_test(test_one_texture),
                              cmocka_unit_test(test_left_out)};
  const int failed = cmocka_run_group_tests_name("unit.scene.specular_glossiness", tests, nullptr, nullptr);
  shd_context_release(g_context);
  return failed;
}
