/* SPDX-License-Identifier: MIT */
/* Lights: every field of the desc. */
#include "support/check.h"

#include <shd/light.h>

static shd_context *g_context;
static shd_texture *g_texture;
static shd_sampler *g_ripmap;

static void edit_nothing(shd_light_desc *d) { (void)d; }
static void edit_size(shd_light_desc *d) { d->struct_size = 4; }
static void edit_directional(shd_light_desc *d) { d->kind = SHD_LIGHT_KIND_DIRECTIONAL; }
static void edit_ambient(shd_light_desc *d) { d->kind = SHD_LIGHT_KIND_AMBIENT; }
static void edit_kind(shd_light_desc *d) { d->kind = (shd_light_kind)4; }
static void edit_kind_negative(shd_light_desc *d) { d->kind = (shd_light_kind)-1; }
static void edit_dark(shd_light_desc *d) { d->intensity[0] = d->intensity[1] = d->intensity[2] = 0; }
static void edit_minus_zero(shd_light_desc *d) { d->intensity[1] = -0.0f; }
static void edit_bright(shd_light_desc *d) { d->intensity[2] = 1e12f; }
static void edit_too_bright(shd_light_desc *d) { d->intensity[2] = 1.1e12f; }
static void edit_negative(shd_light_desc *d) { d->intensity[0] = -1e-30f; }
static void edit_nan_intensity(shd_light_desc *d) { d->intensity[1] = (float)NAN; }
static void edit_inf_intensity(shd_light_desc *d) { d->intensity[1] = INFINITY; }
static void edit_far(shd_light_desc *d) { d->position[0] = -3.4e38f; }
static void edit_nan_position(shd_light_desc *d) { d->position[2] = (float)NAN; }
static void edit_inf_position(shd_light_desc *d) { d->position[0] = -INFINITY; }
static void edit_zero_direction(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_DIRECTIONAL;
    d->direction[1] = -0.0f;
}
static void edit_zero_direction_of_point(shd_light_desc *d) { d->direction[1] = 0; }
static void edit_denormal_direction(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_DIRECTIONAL;
    d->direction[1] = 1e-45f;
}
static void edit_long_direction(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_DIRECTIONAL;
    d->direction[0] = d->direction[1] = d->direction[2] = 3.4e38f;
}
static void edit_nan_direction(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_DIRECTIONAL;
    d->direction[0] = (float)NAN;
}
static void edit_inf_direction(shd_light_desc *d) { d->direction[2] = INFINITY; }

static void edit_spot(shd_light_desc *d) { d->kind = SHD_LIGHT_KIND_SPOT; }
static void edit_spot_direction_0(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->direction[1] = 0;
}
static void edit_spot_up_along_direction(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->up[1] = -3;
}
static void edit_spot_up_0(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->up[1] = 0;
}
static void edit_up_nan(shd_light_desc *d) { d->up[0] = (float)NAN; }
static void edit_range_1e_6(shd_light_desc *d) { d->range = 1e-6f; }
static void edit_range_negative(shd_light_desc *d) { d->range = -1; }
static void edit_range_1e_7(shd_light_desc *d) { d->range = 1e-7f; }
static void edit_range_nan(shd_light_desc *d) { d->range = (float)NAN; }
static void edit_range_inf(shd_light_desc *d) { d->range = INFINITY; }
static void edit_outer_half_pi(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->outer_angle = 1.57079637f;
}
static void edit_outer_2(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->outer_angle = 2;
}
static void edit_outer_0(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->outer_angle = 0;
}
static void edit_outer_nan(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->outer_angle = (float)NAN;
}
static void edit_inner_is_outer(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->inner_angle = d->outer_angle;
}
static void edit_inner_above_outer(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->inner_angle = 1;
}
static void edit_inner_negative(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->inner_angle = -0.1f;
}
static void edit_extent_0(shd_light_desc *d) { d->extent[0] = 0; }
static void edit_extent_nan(shd_light_desc *d) { d->extent[1] = (float)NAN; }
static void edit_texture_of_spot(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->texture = g_texture;
}
static void edit_texture_of_directional(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_DIRECTIONAL;
    d->texture = g_texture;
}
static void edit_texture_of_point(shd_light_desc *d) { d->texture = g_texture; }
static void edit_texture_of_half_pi(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->texture = g_texture;
    d->outer_angle = 1.57f;
}
static void edit_sampler_without_texture(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->sampler = g_ripmap;
}
static void edit_sampler_without_table(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->texture = g_texture;
    d->sampler = g_ripmap;
}
static void edit_sampler_as_texture(shd_light_desc *d)
{
    d->kind = SHD_LIGHT_KIND_SPOT;
    d->texture = (shd_texture *)(void *)g_ripmap;
}

struct create_case {
    const char *name;
    void (*edit)(shd_light_desc *desc);
    shd_result expected;
    const char *message;
};

#define BAD SHD_ERROR_INVALID_ARGUMENT
static const struct create_case k_create[] = {
    {"create/defaults", edit_nothing, SHD_OK, ""},
    {"create/directional", edit_directional, SHD_OK, ""},
    {"create/ambient", edit_ambient, SHD_OK, ""},
    {"create/intensity_0", edit_dark, SHD_OK, ""},
    {"create/intensity_minus_0", edit_minus_zero, SHD_OK, ""},
    {"create/intensity_1e12", edit_bright, SHD_OK, ""},
    {"create/position_flt_max", edit_far, SHD_OK, ""},
    {"create/direction_denormal", edit_denormal_direction, SHD_OK, ""},
    {"create/direction_flt_max", edit_long_direction, SHD_OK, ""},
    {"create/direction_0_of_a_point_light", edit_zero_direction_of_point, SHD_OK, ""},
    {"create/struct_size_4", edit_size, BAD, "light.struct_size: 4"},
    {"create/kind_4", edit_kind, BAD, "light.kind: 4 is not in 0..3"},
    {"create/kind_negative", edit_kind_negative, BAD, "light.kind: "},
    {"create/intensity_1.1e12", edit_too_bright, BAD, "light.intensity[2]: 1.1e+12 is not in 0..1e+12"},
    {"create/intensity_negative", edit_negative, BAD, "light.intensity[0]: -1e-30"},
    {"create/intensity_nan", edit_nan_intensity, BAD, "light.intensity[1]: "},
    {"create/intensity_inf", edit_inf_intensity, BAD, "light.intensity[1]: inf"},
    {"create/position_nan", edit_nan_position, BAD, "light.position[2]: "},
    {"create/position_inf", edit_inf_position, BAD, "light.position[0]: -inf is not finite"},
    {"create/direction_0", edit_zero_direction, BAD, "light.direction: (0, 0, 0)"},
    {"create/direction_nan", edit_nan_direction, BAD, "light.direction[0]: "},
    {"create/direction_inf", edit_inf_direction, BAD, "light.direction[2]: inf is not finite"},
    {"create/spot", edit_spot, SHD_OK, ""},
    {"create/spot/direction_0", edit_spot_direction_0, BAD, "light.direction: (0, 0, 0)"},
    {"create/spot/up_along_direction", edit_spot_up_along_direction, SHD_OK, ""},
    {"create/spot/up_0", edit_spot_up_0, SHD_OK, ""},
    {"create/up_nan", edit_up_nan, BAD, "light.up[0]: "},
    {"create/range_1e-6", edit_range_1e_6, SHD_OK, ""},
    {"create/range_negative", edit_range_negative, BAD, "light.range: -1"},
    {"create/range_1e-7", edit_range_1e_7, BAD, "light.range: 1e-07"},
    {"create/range_nan", edit_range_nan, BAD, "light.range: "},
    {"create/range_inf", edit_range_inf, BAD, "light.range: inf"},
    {"create/outer_half_pi", edit_outer_half_pi, SHD_OK, ""},
    {"create/outer_2", edit_outer_2, BAD, "light.outer_angle: 2 is not in 0.001.."},
    {"create/outer_0", edit_outer_0, BAD, "light.outer_angle: 0"},
    {"create/outer_nan", edit_outer_nan, BAD, "light.outer_angle: "},
    {"create/inner_is_outer", edit_inner_is_outer, SHD_OK, ""},
    {"create/inner_above_outer", edit_inner_above_outer, BAD, "light.inner_angle: 1 is not in 0.."},
    {"create/inner_negative", edit_inner_negative, BAD, "light.inner_angle: -0.1"},
    {"create/extent_0", edit_extent_0, BAD, "light.extent[0]: 0"},
    {"create/extent_nan", edit_extent_nan, BAD, "light.extent[1]: "},
    {"create/texture_of_spot", edit_texture_of_spot, SHD_OK, ""},
    {"create/texture_of_directional", edit_texture_of_directional, SHD_OK, ""},
    {"create/texture_of_point", edit_texture_of_point, BAD, "light.texture: set, but the kind is neither"},
    {"create/texture_of_half_pi", edit_texture_of_half_pi, BAD, "light.outer_angle: 1.57 is not in 0.001..1.55"},
    {"create/sampler_without_texture", edit_sampler_without_texture, BAD,
     "light.sampler: set, but light.texture is NULL"},
    {"create/sampler_without_table", edit_sampler_without_table, BAD,
     "sampler.filter: RIPMAP, but the texture has no SHD_TABLE_RIPMAP"},
    {"create/sampler_as_texture", edit_sampler_as_texture, BAD, "light.texture: not a live handle of its type"},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_light_desc desc = shd_light_desc_default();
    shd_light *light = (shd_light *)&desc;
    c->edit(&desc);
    shd_assert_result(c->name, shd_light_create(g_context, &desc, &light), c->expected, c->message);
    if (c->expected == SHD_OK) {
        assert_non_null(light);
    } else {
        assert_null(light);
    }
    shd_light_release(light);
}

static void test_null_desc(void **state)
{
    shd_light *light = NULL;
    (void)state;
    shd_assert_ok(shd_light_create(g_context, NULL, &light));
    assert_non_null(light);
    shd_light_release(light);
}

static void test_newer_desc(void **state)
{
    struct {
        shd_light_desc desc;
        uint32_t later[2];
    } newer;
    shd_light *light = NULL;
    (void)state;
    memset(&newer, 0, sizeof newer);
    newer.desc = shd_light_desc_default();
    newer.desc.struct_size = (uint32_t)sizeof newer;
    shd_assert_ok(shd_light_create(g_context, &newer.desc, &light));
    shd_light_release(light);
    newer.later[1] = 1;
    shd_assert_result("set tail", shd_light_create(g_context, &newer.desc, &light), SHD_ERROR_UNSUPPORTED,
                      "light: byte");
    assert_null(light);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_create) + 2];
    static const unsigned char texel[4] = {255, 128, 0, 255};
    shd_texture_desc texture = shd_texture_desc_default();
    shd_sampler_desc ripmap = shd_sampler_desc_default();
    size_t n = 0, i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    texture.width = texture.height = 1;
    texture.format = SHD_FORMAT_RGBA8;
    texture.texels = texel;
    if (shd_texture_create(g_context, &texture, &g_texture) != SHD_OK) return 1;
    ripmap.filter = SHD_FILTER_RIPMAP;
    if (shd_sampler_create(g_context, &ripmap, &g_ripmap) != SHD_OK) return 1;
    for (i = 0; i < COUNT(k_create); ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    tests[n++] = (struct CMUnitTest){"create/null_desc", test_null_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"create/newer_desc", test_newer_desc, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.light", tests, n, NULL, NULL);
    shd_sampler_release(g_ripmap);
    shd_texture_release(g_texture);
    shd_context_release(g_context);
    return failed;
}
