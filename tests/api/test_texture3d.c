/* SPDX-License-Identifier: MIT */
/* 3D textures through the API: refused descs, samplers and lookups; calls of few and of many lookups; slices read and
 * written; explanations; other uses of textures. */
#include "support/volume_scene.h"

static shd_context *g_context;
static shd_texture *g_texture;
static float g_in[9][k_solid_lookups], g_out[4][k_solid_lookups], g_slow[4][2 * k_solid_lookups];

static int setup(void **state)
{
    uint32_t seed = 3;
    size_t c, i;
    (void)state;
    for (c = 0; c < 9; ++c) {
        for (i = 0; i < k_solid_lookups; ++i) g_in[c][i] = (c < 3 ? 1.5f : 0.1f) * shd_solid_in(&seed, -1, 1);
    }
    if (shd_context_create(NULL, &g_context) != SHD_OK) return -1;
    g_texture = shd_solid_texture(g_context, SHD_FORMAT_RGBA8);
    return 0;
}
static int teardown(void **state)
{
    (void)state;
    shd_texture_release(g_texture);
    shd_context_release(g_context);
    return 0;
}

static shd_lookups make_lookups(size_t first, size_t count)
{
    shd_lookups lookups = shd_lookups_default();
    shd_f32_in *const column[9] = {&lookups.u,    &lookups.v,    &lookups.w,    &lookups.dudx, &lookups.dvdx,
                                   &lookups.dwdx, &lookups.dudy, &lookups.dvdy, &lookups.dwdy};
    size_t c;
    lookups.count = count;
    for (c = 0; c < 9; ++c) column[c]->data = g_in[c] + first;
    return lookups;
}

/* ---- descs ---- */

struct create_case {
    const char *name;
    void (*edit)(shd_texture_desc *desc);
    shd_result expected;
    const char *message;
};
static unsigned char g_texels[4096 * 4 + SHD_TEXTURE_PADDING];

static void edit_nothing(shd_texture_desc *d) { (void)d; }
static void edit_thin(shd_texture_desc *d) { d->depth = 1; }
static void edit_layers(shd_texture_desc *d) { d->layer_count = 2; }
static void edit_ripmap(shd_texture_desc *d) { d->tables = SHD_TABLE_RIPMAP; }
static void edit_summed(shd_texture_desc *d) { d->tables = SHD_TABLE_MIPMAP | SHD_TABLE_SUMMED_AREA; }
static void edit_too_many(shd_texture_desc *d)
{
    d->width = d->height = 4096;
    d->depth = 17;
}
static void edit_overflow(shd_texture_desc *d) { d->width = d->height = d->depth = 65536; }
static void edit_stride_small(shd_texture_desc *d) { d->layer_stride = 16 * 16 * 4 - 4; }
static void edit_stride_large(shd_texture_desc *d) { d->layer_stride = (size_t)-1 / 8 * 4; }
static void edit_borrow(shd_texture_desc *d) { d->flags = SHD_TEXTURE_BORROW; }
static void edit_borrow_stride(shd_texture_desc *d)
{
    d->flags = SHD_TEXTURE_BORROW;
    d->layer_stride = 16 * 16 * 4 + 4;
}
static void edit_levels(shd_texture_desc *d) { d->level_count = 5; }

static const struct create_case k_create[] = {
    {"create/16x16x16", edit_nothing, SHD_OK, ""},
    {"create/one_slice", edit_thin, SHD_OK, ""},
    {"create/borrowed", edit_borrow, SHD_OK, ""},
    {"create/layers", edit_layers, SHD_ERROR_INVALID_ARGUMENT, "texture.layer_count: 2 is not in 1..1"},
    {"create/ripmap", edit_ripmap, SHD_ERROR_UNSUPPORTED, "texture.tables: 0x2, but a 3D texture"},
    {"create/summed_area", edit_summed, SHD_ERROR_UNSUPPORTED, "texture.tables: 0x5, but a 3D texture"},
    {"create/2^28_and_a_slice", edit_too_many, SHD_ERROR_INVALID_ARGUMENT,
     "texture.width * texture.height * texture.depth: 285212672 is not in 1..268435456"},
    {"create/2^48", edit_overflow, SHD_ERROR_INVALID_ARGUMENT,
     "texture.width * texture.height * texture.depth: 281474976710656"},
    {"create/slices_overlap", edit_stride_small, SHD_ERROR_INVALID_ARGUMENT,
     "texture.layer_stride: 1020 is below 1024"},
    {"create/slices_too_far", edit_stride_large, SHD_ERROR_INVALID_ARGUMENT, "exceeds the address space"},
    {"create/borrowed_apart", edit_borrow_stride, SHD_ERROR_INVALID_ARGUMENT,
     "SHD_TEXTURE_BORROW, but texture.layer_stride 1028, not 1024"},
    {"create/too_many_levels", edit_levels, SHD_ERROR_INVALID_ARGUMENT, "texture.level_count: 5 is not in 0..4"},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    desc.format = SHD_FORMAT_RGBA8;
    desc.kind = SHD_TEXTURE_KIND_3D;
    desc.width = desc.height = desc.depth = 16;
    desc.texels = g_texels;
    desc.tables = SHD_TABLE_MIPMAP;
    c->edit(&desc);
    shd_assert_result(c->name, shd_texture_create(g_context, &desc, &texture), c->expected, c->message);
    if (c->expected == SHD_OK) {
        shd_texture_info info = shd_texture_info_default();
        shd_assert_ok(shd_texture_get_info(texture, &info));
        assert_int_equal(info.depth, desc.depth);
        assert_int_equal(info.level_count, 5);
    }
    shd_texture_release(texture);
}

/* ---- samplers and lookups ---- */

struct sampler_case {
    const char *name;
    void (*edit)(shd_sampler_desc *desc);
    shd_result expected;
    const char *message;
};
static void sampler_default(shd_sampler_desc *d) { (void)d; }
static void sampler_nearest(shd_sampler_desc *d) { d->magnification = SHD_MAGNIFICATION_NEAREST; }
static void sampler_exact_profile(shd_sampler_desc *d) { d->profile = SHD_PROFILE_EXACT; }
static void sampler_fast(shd_sampler_desc *d) { d->precision = SHD_PRECISION_FAST; }
static void sampler_bicubic(shd_sampler_desc *d) { d->filter = SHD_FILTER_BICUBIC; }
static void sampler_ripmap(shd_sampler_desc *d) { d->filter = SHD_FILTER_RIPMAP; }
static void sampler_summed(shd_sampler_desc *d) { d->filter = SHD_FILTER_SUMMED_AREA; }
static void sampler_ewa(shd_sampler_desc *d) { d->filter = SHD_FILTER_EWA; }
static void sampler_stochastic(shd_sampler_desc *d) { d->filter = SHD_FILTER_STOCHASTIC; }
static void sampler_exact(shd_sampler_desc *d) { d->filter = SHD_FILTER_EXACT; }
static void sampler_magnified(shd_sampler_desc *d) { d->magnification = SHD_MAGNIFICATION_BICUBIC; }
static void sampler_vulkan(shd_sampler_desc *d) { d->profile = SHD_PROFILE_VULKAN; }
static void sampler_blur(shd_sampler_desc *d) { d->blur_v = 0.5f; }

static const struct sampler_case k_samplers[] = {
    {"sample/trilinear", sampler_default, SHD_OK, ""},
    {"sample/nearest_magnification", sampler_nearest, SHD_OK, ""},
    {"sample/exact_profile", sampler_exact_profile, SHD_OK, ""},
    {"sample/fast", sampler_fast, SHD_OK, ""},
    {"sample/bicubic", sampler_bicubic, SHD_OK, ""},
    {"sample/ripmap", sampler_ripmap, SHD_ERROR_UNSUPPORTED, "sampler.filter: RIPMAP, but the texture is 3D"},
    {"sample/summed_area", sampler_summed, SHD_ERROR_UNSUPPORTED, "sampler.filter: SUMMED_AREA, but"},
    {"sample/ewa", sampler_ewa, SHD_OK, ""},
    {"sample/stochastic", sampler_stochastic, SHD_OK, ""},
    {"sample/exact", sampler_exact, SHD_OK, ""},
    {"sample/bicubic_magnification", sampler_magnified, SHD_OK, ""},
    {"sample/vulkan", sampler_vulkan, SHD_ERROR_UNSUPPORTED, "sampler.profile: VULKAN, but the texture is 3D"},
    {"sample/blur", sampler_blur, SHD_ERROR_UNSUPPORTED, "sampler.blur_v: not 0, but the texture is 3D"},
};

static shd_sampler *make_sampler(void (*edit)(shd_sampler_desc *))
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_sampler *sampler = NULL;
    edit(&desc);
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    return sampler;
}

static shd_texels make_texels(size_t first)
{
    shd_texels texels = shd_texels_default();
    size_t c;
    for (c = 0; c < 4; ++c) texels.channel[c].data = g_out[c] + first;
    return texels;
}

static void test_sampler(void **state)
{
    const struct sampler_case *c = (const struct sampler_case *)*state;
    shd_sampler *sampler = make_sampler(c->edit);
    shd_lookups lookups = make_lookups(0, 100), without = make_lookups(0, 100);
    shd_texels texels = make_texels(0);
    shd_levels levels = shd_levels_default();
    shd_explanation explanation = shd_explanation_default();
    without.w.data = NULL;
    shd_assert_result(c->name, shd_texture_sample(g_texture, sampler, &lookups, &texels), c->expected, c->message);
    /* An integral is no tree of blends. */
    if (c->edit == sampler_exact) {
        shd_assert_result(c->name, shd_texture_explain(g_texture, sampler, &lookups, 0, &explanation),
                          SHD_ERROR_UNSUPPORTED, "EXACT has no explanation");
    } else {
        shd_assert_result(c->name, shd_texture_explain(g_texture, sampler, &lookups, 0, &explanation), c->expected,
                          c->message);
    }
    if (c->expected == SHD_OK) {
        levels.lod.data = g_out[0];
        shd_assert_ok(shd_texture_query_levels(g_texture, sampler, &lookups, &levels));
        shd_assert_result("no w", shd_texture_sample(g_texture, sampler, &without, &texels), SHD_ERROR_INVALID_ARGUMENT,
                          "lookups.w.data: NULL, but the texture is 3D");
        shd_assert_result("no w", shd_texture_query_levels(g_texture, sampler, &without, &levels),
                          SHD_ERROR_INVALID_ARGUMENT, "lookups.w.data: NULL");
        without.count = 0;
        shd_assert_ok(shd_texture_sample(g_texture, sampler, &without, &texels));
    }
    shd_sampler_release(sampler);
}

/* Calls of one lookup, of a few, and of columns with strides give the bits of one call. */
static void test_splits(void **state)
{
    static const size_t k_counts[] = {1, 3, 16, 257};
    shd_sampler *sampler = make_sampler(sampler_default);
    shd_lookups lookups = make_lookups(0, k_solid_lookups);
    shd_texels texels = make_texels(0);
    static float whole[4][k_solid_lookups];
    size_t k, c, i;
    (void)state;
    shd_assert_ok(shd_texture_sample(g_texture, sampler, &lookups, &texels));
    memcpy(whole, g_out, sizeof whole);
    for (k = 0; k < sizeof k_counts / sizeof k_counts[0]; ++k) {
        memset(g_out, 0, sizeof g_out);
        for (i = 0; i < k_solid_lookups; i += k_counts[k]) {
            const size_t rest = k_solid_lookups - i;
            lookups = make_lookups(i, rest < k_counts[k] ? rest : k_counts[k]);
            texels = make_texels(i);
            shd_assert_ok(shd_texture_sample(g_texture, sampler, &lookups, &texels));
        }
        assert_memory_equal(whole, g_out, sizeof whole);
    }
    lookups = make_lookups(0, k_solid_lookups);
    for (c = 0; c < 4; ++c) texels.channel[c] = (shd_f32_out){g_slow[c], 2 * sizeof(float)};
    shd_assert_ok(shd_texture_sample(g_texture, sampler, &lookups, &texels));
    for (c = 0; c < 4; ++c) {
        for (i = 0; i < k_solid_lookups; ++i) assert_memory_equal(&whole[c][i], &g_slow[c][2 * i], sizeof(float));
    }
    shd_sampler_release(sampler);
}

/* Replaying an explanation gives the values; its taps are texels of the levels. */
static void test_explain(void **state)
{
    static const shd_filter k_filters[] = {SHD_FILTER_NEAREST, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC};
    static shd_tap taps[1024];
    static shd_blend_step blends[1024];
    static float value[2048];
    size_t f, i, k;
    (void)state;
    for (f = 0; f < 3; ++f) {
        shd_sampler_desc desc = shd_sampler_desc_default();
        shd_sampler *sampler = NULL;
        desc.filter = k_filters[f];
        shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
        for (i = 0; i < 60; ++i) {
            const shd_lookups lookups = make_lookups(0, 100);
            shd_explanation e = shd_explanation_default();
            e.taps = taps;
            e.blends = blends;
            e.tap_capacity = e.blend_capacity = 1024;
            shd_assert_ok(shd_texture_explain(g_texture, sampler, &lookups, i, &e));
            assert_true(e.tap_count > 0 && e.tap_count <= 1024);
            for (k = 0; k < e.tap_count; ++k) {
                const uint32_t l = taps[k].level_u;
                static unsigned char slice[k_solid_width * k_solid_height * 4];
                shd_image image = shd_image_default();
                image.format = SHD_FORMAT_RGBA8;
                image.width = k_solid_width >> l ? k_solid_width >> l : 1;
                image.height = k_solid_height >> l ? k_solid_height >> l : 1;
                image.pixels = slice;
                shd_assert_ok(shd_texture_read_level(g_texture, taps[k].z, l, &image));
                assert_int_equal(taps[k].layer, 0);
                assert_true(taps[k].value[0] == (float)slice[4 * (taps[k].y * image.width + taps[k].x)]);
                value[k] = taps[k].value[0];
            }
            for (k = 0; k < e.blend_count; ++k) {
                const float a = value[blends[k].a], b = value[blends[k].b], s = blends[k].s;
                value[e.tap_count + k] = s == 0 ? a : a + s * (b - a);
            }
            value[0] = value[e.tap_count + e.blend_count - 1];
            assert_true(value[0] * e.scale_high[0] + value[0] * e.scale_low[0] == e.result[0]);
        }
        shd_sampler_release(sampler);
    }
}

/* A slice that is written is read back, and levels change with it. */
static void test_update(void **state)
{
    static unsigned char before[5 * 4 * 4], after[5 * 4 * 4], pixels[4 * 3 * 4];
    shd_texture *texture = shd_solid_texture(g_context, SHD_FORMAT_RGBA8);
    shd_image image = shd_image_default(), level = shd_image_default();
    size_t i;
    (void)state;
    image.format = level.format = SHD_FORMAT_RGBA8;
    image.width = 4;
    image.height = 3;
    image.pixels = pixels;
    level.width = 5;
    level.height = 4;
    level.pixels = before;
    for (i = 0; i < sizeof pixels; ++i) pixels[i] = (unsigned char)(i * 5);
    shd_assert_ok(shd_texture_read_level(texture, 2, 2, &level));
    shd_assert_ok(shd_texture_update(texture, 12, 16, 14, &image));
    level.pixels = after;
    shd_assert_ok(shd_texture_read_level(texture, 2, 2, &level));
    assert_true(memcmp(before, after, sizeof before) != 0);
    shd_assert_result("slice 13", shd_texture_update(texture, 13, 0, 0, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "layer: 13 is not in 0..12");
    shd_assert_result("slice 3 of level 2", shd_texture_read_level(texture, 3, 2, &level), SHD_ERROR_INVALID_ARGUMENT,
                      "layer: 3 is not in 0..2");
    shd_texture_release(texture);
}

/* Uses of textures that have two coordinates refuse 3D textures. */
static void test_other_uses(void **state)
{
    shd_light_desc light = shd_light_desc_default();
    shd_material_desc material = shd_material_desc_default();
    shd_slot slot = shd_slot_vertex(SHD_SLOT_HEIGHT, 0);
    slot.source = SHD_SLOT_SOURCE_CONSTANT;
    shd_light *made_light = NULL;
    shd_material *made_material = NULL;
    (void)state;
    light.kind = SHD_LIGHT_KIND_SPOT;
    light.texture = g_texture;
    shd_assert_result("light", shd_light_create(g_context, &light, &made_light), SHD_ERROR_UNSUPPORTED,
                      "light.texture: a texture of 3D");
    slot.source = SHD_SLOT_SOURCE_TEXTURE;
    slot.texture = g_texture;
    material.slots = &slot;
    material.slot_count = 1;
    shd_assert_result("slot", shd_material_create(g_context, &material, &made_material), SHD_ERROR_UNSUPPORTED,
                      "material.slots[0].texture: a texture of 3D");
}

int main(void)
{
    struct CMUnitTest tests[48];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_create / sizeof k_create[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    for (i = 0; i < sizeof k_samplers / sizeof k_samplers[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_samplers[i].name, test_sampler, NULL, NULL, (void *)&k_samplers[i]};
    }
    tests[n++] = (struct CMUnitTest){"splits", test_splits, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"explain", test_explain, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"update", test_update, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"other_uses", test_other_uses, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.texture3d", tests, n, setup, teardown);
}
