// SPDX-License-Identifier: MIT
// Bounds of bad input: descs and columns that are refused, and lookups that are degenerate, huge or not finite, whose
// values of shd_texture_sample() stay inside.
#include <cfloat>

#include "support/bounds_scene.h"

namespace shd::tests
{
namespace
{

struct Fixture {
    shd_context *context = nullptr;
    shd_texture *texture = nullptr;
    shd_sampler *sampler = nullptr;
    float u[4] = {0.1f, 0.4f, 0.6f, 0.9f}, v[4] = {0.3f, 0.2f, 0.8f, 0.5f}, low[16], high[16];
    uint8_t texels[64 * 4];
    shd_lookups in = shd_lookups_default();
    shd_texels lower = shd_texels_default(), upper = shd_texels_default();

    void open(const shd_texture_desc *edit_texture, const shd_sampler_desc *edit_sampler)
    {
        for (size_t i = 0; i < sizeof texels; ++i) texels[i] = static_cast<uint8_t>(i * 37);
        shd_texture_desc td = edit_texture ? *edit_texture : shd_texture_desc_default();
        if (!edit_texture) td.format = SHD_FORMAT_RGBA8, td.width = td.height = 8, td.texels = texels;
        shd_assert_ok(shd_texture_create(g_context, &td, &texture));
        shd_assert_ok(shd_sampler_create(g_context, edit_sampler, &sampler));
        in.count = 4;
        in.u = shd_f32_column(u, 0), in.v = shd_f32_column(v, 0);
        lower.channel[0] = shd_f32_out_column(low, 0), upper.channel[0] = shd_f32_out_column(high, 0);
    }
    void close()
    {
        shd_sampler_release(sampler);
        shd_texture_release(texture);
    }
};

struct BadDesc {
    const char *name;
    void (*edit)(shd_bounds_desc *desc);
    shd_result result;
    const char *message;
};
constexpr shd_result kInvalid = SHD_ERROR_INVALID_ARGUMENT, kUnsupported = SHD_ERROR_UNSUPPORTED;
const BadDesc kBadDescs[] = {
    {"rules_0", [](auto *d) { d->level_rules = 0; }, kInvalid, "bounds.level_rules: 0 is not in 1..31"},
    {"rules_unknown", [](auto *d) { d->level_rules = 64; }, kUnsupported, "bounds.level_rules: bits 0x40"},
    {"subtexel_1", [](auto *d) { d->subtexel_bits = 1; }, kInvalid, "bounds.subtexel_bits: 1 is not in 2..24"},
    {"subtexel_25", [](auto *d) { d->subtexel_bits = 25; }, kInvalid, "bounds.subtexel_bits: 25"},
    {"level_0", [](auto *d) { d->level_bits = 0; }, kInvalid, "bounds.level_bits: 0 is not in 1..24"},
    {"weight_25", [](auto *d) { d->weight_bits = 25; }, kInvalid, "bounds.weight_bits: 25 is not in 0..24"},
    {"result_25", [](auto *d) { d->result_bits = 25; }, kInvalid, "bounds.result_bits: 25 is not in 0..24"},
    {"coordinate_nan", [](auto *d) { d->coordinate_error = NAN; }, kInvalid, "bounds.coordinate_error: nan"},
    {"coordinate_1", [](auto *d) { d->coordinate_error = 1; }, kInvalid, "bounds.coordinate_error: 1 is not in 0.."},
    {"derivative", [](auto *d) { d->derivative_error = -1; }, kInvalid, "bounds.derivative_error: -1"},
    {"level_error", [](auto *d) { d->level_error = INFINITY; }, kInvalid, "bounds.level_error: inf"},
    {"relative", [](auto *d) { d->relative_error = 2; }, kInvalid, "bounds.relative_error: 2 is not in 0..1"},
    {"srgb", [](auto *d) { d->srgb_error = 1.5f; }, kInvalid, "bounds.srgb_error: 1.5 is not in 0..1"},
    {"size", [](auto *d) { d->struct_size = 8; }, kInvalid, "bounds.struct_size: 8"},
};

void test_bad_desc(void **)
{
    Fixture f;
    f.open(nullptr, nullptr);
    for (const BadDesc &row : kBadDescs) {
        shd_bounds_desc desc = shd_bounds_desc_default();
        row.edit(&desc);
        shd_assert_result(row.name, shd_texture_bounds(f.texture, f.sampler, &f.in, &desc, &f.lower, &f.upper),
                          row.result, row.message);
    }
    f.close();
}

struct BadCall {
    const char *name;
    void (*edit)(Fixture *f);
    shd_result result;
    const char *message;
};
const BadCall kBadCalls[] = {
    {"lookups", [](Fixture *f) { f->in.u.data = nullptr; }, kInvalid, "lookups.u.data: NULL"},
    {"none", [](Fixture *f) { f->lower.channel[0].data = f->upper.channel[0].data = nullptr; }, kInvalid,
     "lower.channel, upper.channel: NULL for all"},
    {"stride", [](Fixture *f) { f->upper.channel[0].stride = 3; }, kInvalid, "upper.channel[0].stride: 3"},
    {"overlap", [](Fixture *f) { f->upper.channel[0] = f->lower.channel[0]; }, kInvalid, "upper.channel"},
    {"input", [](Fixture *f) { f->lower.channel[0].data = f->u; }, kInvalid, "lower.channel"},
    {"derivatives", [](Fixture *f) { f->upper.du[1].data = f->high + 8; }, kUnsupported, "upper.du, dv, dw: set"},
    {"size", [](Fixture *f) { f->lower.struct_size = 4; }, kInvalid, "lower.struct_size: 4"},
};

void test_bad_call(void **)
{
    for (const BadCall &row : kBadCalls) {
        Fixture f;
        f.open(nullptr, nullptr);
        row.edit(&f);
        shd_assert_result(row.name, shd_texture_bounds(f.texture, f.sampler, &f.in, nullptr, &f.lower, &f.upper),
                          row.result, row.message);
        f.close();
    }
    Fixture f;
    f.open(nullptr, nullptr);
    shd_assert_result("texture", shd_texture_bounds(nullptr, f.sampler, &f.in, nullptr, &f.lower, &f.upper), kInvalid,
                      "texture: NULL");
    shd_assert_result("sampler", shd_texture_bounds(f.texture, nullptr, &f.in, nullptr, &f.lower, &f.upper), kInvalid,
                      "sampler: NULL");
    shd_assert_result("lower", shd_texture_bounds(f.texture, f.sampler, &f.in, nullptr, nullptr, &f.upper), kInvalid,
                      "lower: NULL");
    shd_assert_result("upper", shd_texture_bounds(f.texture, f.sampler, &f.in, nullptr, &f.lower, nullptr), kInvalid,
                      "upper: NULL");
    shd_bounds_desc desc = shd_bounds_desc_default();
    shd_assert_result("preset", shd_bounds_desc_from_rules(static_cast<shd_rules>(4), &desc), kInvalid,
                      "bounds_preset.rules: 4 is not in 0..3");
    assert_int_equal(desc.subtexel_bits, 0);
    shd_assert_result("preset", shd_bounds_desc_from_rules(SHD_RULES_D3D11, nullptr), kInvalid, "out_desc: NULL");
    f.in.count = 0;
    f.in.u.data = nullptr;
    shd_assert_ok(shd_texture_bounds(f.texture, f.sampler, &f.in, nullptr, &f.lower, &f.upper));
    f.close();
}

struct Refused {
    const char *name;
    void (*edit)(shd_texture_desc *texture, shd_sampler_desc *sampler);
    const char *message;
};
const Refused kRefused[] = {
    {"ewa", [](auto *, auto *s) { s->filter = SHD_FILTER_EWA; }, "sampler.filter: EWA has no bounds"},
    {"exact", [](auto *, auto *s) { s->filter = SHD_FILTER_EXACT; }, "sampler.filter: EXACT has no bounds"},
    {"bicubic", [](auto *, auto *s) { s->magnification = SHD_MAGNIFICATION_BICUBIC; },
     "sampler.magnification: BICUBIC"},
    {"hermite", [](auto *, auto *s) { s->magnification = SHD_MAGNIFICATION_HERMITE; },
     "sampler.magnification: HERMITE"},
    {"nearest",
     [](auto *, auto *s) { s->filter = SHD_FILTER_ANISOTROPIC, s->magnification = SHD_MAGNIFICATION_NEAREST; },
     "sampler.magnification: NEAREST of ANISOTROPIC"},
    {"fast", [](auto *, auto *s) { s->filter = SHD_FILTER_ANISOTROPIC, s->precision = SHD_PRECISION_FAST; },
     "sampler.precision: FAST of ANISOTROPIC"},
    {"blur", [](auto *, auto *s) { s->blur_v = 0.1f; }, "sampler.blur_u, blur_v"},
    {"level_blend", [](auto *, auto *s) { s->level_blend = 0.5f; }, "sampler.level_blend"},
    {"lat_long",
     [](auto *t, auto *) { t->kind = SHD_TEXTURE_KIND_DIRECTIONS, t->projection = SHD_PROJECTION_LAT_LONG; },
     "texture.projection: LAT_LONG has no bounds: no standard defines its lookups along parallels"},
};

void test_refused(void **)
{
    static uint8_t texels[256];
    for (const Refused &row : kRefused) {
        shd_texture_desc td = shd_texture_desc_default();
        td.format = SHD_FORMAT_RGBA8, td.width = td.height = 8, td.texels = texels;
        shd_sampler_desc sd = shd_sampler_desc_default();
        row.edit(&td, &sd);
        Fixture f;
        f.open(&td, &sd);
        f.in.w = f.in.u;
        shd_assert_result(row.name, shd_texture_bounds(f.texture, f.sampler, &f.in, nullptr, &f.lower, &f.upper),
                          kUnsupported, row.message);
        f.close();
    }
    shd_sampler_desc sd = shd_sampler_desc_default();
    sd.profile = SHD_PROFILE_OIIO;
    shd_bounds_desc desc = shd_bounds_desc_default();
    desc.level_rules = SHD_LEVEL_RULE_PROFILE;
    Fixture f;
    f.open(nullptr, &sd);
    shd_assert_result("oiio", shd_texture_bounds(f.texture, f.sampler, &f.in, &desc, &f.lower, &f.upper), kUnsupported,
                      "sampler.profile: OIIO");
    f.close();
}

constexpr float kInf = INFINITY;
const float kStrange[] = {0.0f, -0.0f,  0.5f,  1.0f,   -1.0f,   1e-42f,   FLT_MIN, 0.3f,  17.25f, -3e4f,
                          1e7f, -1e10f, 1e19f, -1e30f, FLT_MAX, -FLT_MAX, kInf,    -kInf, NAN};

SceneLookups strange_lookups(const SceneTexture &kind, size_t count, Random *random)
{
    SceneLookups out;
    const auto pick = [&]() { return kStrange[random->whole(0, static_cast<int64_t>(std::size(kStrange)) - 1)]; };
    for (size_t i = 0; i < count; ++i) {
        out.add(kind, false, random);
        for (auto &column : out.column) {
            if (!random->whole(0, 2)) column.back() = pick();
        }
        out.layer.back() = static_cast<uint32_t>(random->bits());
    }
    return out;
}

void check_strange(const Scene &scene, const shd_bounds_desc &desc)
{
    shd_sampler *sampler = scene.sampler(g_context);
    const shd_lookups in = scene.lookups.columns();
    SceneValues values, low, high;
    shd_texels out = values.columns(in.count), lower = low.columns(in.count), upper = high.columns(in.count);
    shd_assert_ok(shd_texture_bounds(scene.pixels->texture, sampler, &in, &desc, &lower, &upper));
    shd_assert_ok(shd_texture_sample(scene.pixels->texture, sampler, &in, &out));
    assert_int_equal(out.nonfinite_count, lower.nonfinite_count);
    assert_int_equal(out.nonfinite_count, upper.nonfinite_count);
    for (size_t i = 0; i < in.count; ++i) {
        for (int c = 0; c < 4; ++c) {
            const float value = values.channel[c][i], a = low.channel[c][i], b = high.channel[c][i];
            if (a <= value && value <= b) continue;
            const ref::UnitLookup at = scene.lookups.at(i);
            fail_msg("format %d, filter %d, profile %d, (%g %g %g, %g %g %g, %g %g %g): %.9g is not in %.9g..%.9g",
                     scene.kind.format, scene.image.sampler.filter, scene.image.sampler.profile, at.p[0], at.p[1],
                     at.p[2], at.dx[0], at.dx[1], at.dx[2], at.dy[0], at.dy[1], at.dy[2], double{value}, double{a},
                     double{b});
        }
    }
    shd_sampler_release(sampler);
}

void test_strange(void **)
{
    Random random{3};
    Scenes scenes(g_context, 0, 21);
    for (Scene &scene : scenes.list) {
        scene.lookups = strange_lookups(scene.kind, SHD_IS_SANITIZED ? 50 : 200, &random);
        scene.image.sampler.profile = scene.kind.depth ? SHD_PROFILE_EXACT : SHD_PROFILE_VULKAN;
        check_strange(scene, preset(SHD_RULES_VULKAN));
        shd_bounds_desc own = preset(SHD_RULES_D3D11);
        own.level_rules = SHD_LEVEL_RULE_PROFILE;
        for (shd_profile profile : {SHD_PROFILE_LEAST_ERROR, SHD_PROFILE_EXACT, SHD_PROFILE_D3D11}) {
            if (scene.kind.depth && profile == SHD_PROFILE_D3D11) continue;
            scene.image.sampler.profile = profile;
            check_strange(scene, own);
        }
    }
}

/// The sampler's widths apply to derivatives that are already within a face.
void test_wide(void **)
{
    Random random{5};
    Scenes scenes(g_context, 0, 22);
    shd_bounds_desc desc = preset(SHD_RULES_VULKAN);
    for (const float width : {0.0f, 0.4f, 8.5f, 64.0f}) {
        for (Scene &scene : scenes.list) {
            scene.lookups = strange_lookups(scene.kind, SHD_IS_SANITIZED ? 10 : 100, &random);
            scene.image.sampler.width_x = width;
            scene.image.sampler.width_y = 8.0f;
            for (shd_profile profile : {SHD_PROFILE_VULKAN, SHD_PROFILE_LEAST_ERROR, SHD_PROFILE_D3D11}) {
                if (scene.kind.depth && profile != SHD_PROFILE_LEAST_ERROR) continue;
                scene.image.sampler.profile = profile;
                desc.level_rules = SHD_LEVEL_RULE_PROFILE;
                check_strange(scene, desc);
            }
        }
    }
}

void test_nonfinite_texels(void **)
{
    static float texels[16];
    for (int i = 0; i < 16; ++i) texels[i] = static_cast<float>(i);
    texels[5] = NAN;
    shd_texture_desc td = shd_texture_desc_default();
    td.format = SHD_FORMAT_R32F, td.width = td.height = 4, td.texels = texels;
    shd_sampler_desc sd = shd_sampler_desc_default();
    sd.filter = SHD_FILTER_BILINEAR;
    Fixture f;
    f.open(&td, &sd);
    shd_assert_ok(shd_texture_bounds(f.texture, f.sampler, &f.in, nullptr, &f.lower, &f.upper));
    assert_true(isinf(f.low[1]) && f.low[1] < 0 && isinf(f.high[1]) && f.high[1] > 0);
    assert_true(std::isfinite(f.low[3]) && std::isfinite(f.high[3]));
    f.close();
}

/// Bounds do not depend on the size of a batch, on strides or on workers.
void test_batches(void **)
{
    const SceneTexture kind = kSceneTextures[0];
    Random random{8};
    const ScenePixels pixels(g_context, kind, &random);
    Scene scene = {kind, &pixels, pixels.image, {}};
    scene.image.sampler = scene_sampler(kind, SHD_FILTER_TRILINEAR, 0, &random);
    for (int i = 0; i < 40000; ++i) scene.lookups.add(kind, false, &random);
    const SceneBounds all(g_context, scene, preset(SHD_RULES_VULKAN));
    shd_sampler *sampler = scene.sampler(g_context);
    for (size_t first : {size_t{0}, size_t{16383}, size_t{39900}}) {
        shd_lookups in = scene.lookups.columns();
        in.count = 100;
        for (shd_f32_in *column : {&in.u, &in.v, &in.dudx, &in.dvdx, &in.dudy, &in.dvdy}) column->data += first;
        in.layer.data += first;
        float low[300], high[300];
        shd_texels lower = shd_texels_default(), upper = shd_texels_default();
        lower.channel[2] = shd_f32_out_column(low, 12), upper.channel[2] = shd_f32_out_column(high, 12);
        shd_assert_ok(shd_texture_bounds(pixels.texture, sampler, &in, nullptr, &lower, &upper));
        for (size_t i = 0; i < 100; ++i) {
            assert_true(low[3 * i] == all.lower.channel[2][first + i]);
            assert_true(high[3 * i] == all.upper.channel[2][first + i]);
        }
    }
    shd_sampler_release(sampler);
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_bad_desc), cmocka_unit_test(test_bad_call),
                                       cmocka_unit_test(test_refused),  cmocka_unit_test(test_strange),
                                       cmocka_unit_test(test_wide),     cmocka_unit_test(test_nonfinite_texels),
                                       cmocka_unit_test(test_batches)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
