/* SPDX-License-Identifier: MIT */
/* Shadows: every field of the descs, refusals, and the state after a failed call. */
#include "support/noise.h"
#include "support/shadow_scene.h"

#define BAD SHD_ERROR_INVALID_ARGUMENT

static struct {
    shd_context *context;
    shd_light *light, *ambient, *point;
    struct shd_boxes boxes;
} g;

static shd_light *make_light(shd_light_kind kind)
{
    shd_light_desc desc = shd_light_desc_default();
    shd_light *light = NULL;
    desc.kind = kind;
    shd_assert_ok(shd_light_create(g.context, &desc, &light));
    return light;
}

static int set_up(void **state)
{
    static const float k_low[3] = {-1, -1, -1}, k_high[3] = {1, 0, 1};
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &g.context));
    g.light = make_light(SHD_LIGHT_KIND_DIRECTIONAL);
    g.ambient = make_light(SHD_LIGHT_KIND_AMBIENT);
    g.point = make_light(SHD_LIGHT_KIND_POINT);
    shd_boxes_open(&g.boxes, g.context);
    shd_boxes_add(&g.boxes, k_low, k_high);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    shd_boxes_close(&g.boxes);
    shd_light_release(g.light);
    shd_light_release(g.ambient);
    shd_light_release(g.point);
    shd_context_release(g.context);
    return 0;
}

static void edit_nothing(shd_shadow_desc *d) { (void)d; }
static void edit_struct_size(shd_shadow_desc *d) { d->struct_size = 8; }
static void edit_size_15(shd_shadow_desc *d) { d->size = 15; }
static void edit_size_16(shd_shadow_desc *d) { d->size = 16; }
static void edit_size_8192(shd_shadow_desc *d) { d->size = 8192; }
static void edit_size_8193(shd_shadow_desc *d) { d->size = 8193; }
static void edit_filter(shd_shadow_desc *d) { d->filter = (shd_shadow_filter)5; }
static void edit_filter_negative(shd_shadow_desc *d) { d->filter = (shd_shadow_filter)-1; }
static void edit_taps_0(shd_shadow_desc *d) { d->taps = 0; }
static void edit_taps_16(shd_shadow_desc *d) { d->taps = 16; }
static void edit_filter_size(shd_shadow_desc *d) { d->filter_size = -1; }
static void edit_filter_size_nan(shd_shadow_desc *d) { d->filter_size = (float)NAN; }
static void edit_light_size(shd_shadow_desc *d) { d->light_size = 1.1e9f; }
static void edit_light_size_inf(shd_shadow_desc *d) { d->light_size = INFINITY; }
static void edit_bias(shd_shadow_desc *d) { d->bias = -0.001f; }
static void edit_bias_nan(shd_shadow_desc *d) { d->bias = (float)NAN; }
static void edit_bias_slope(shd_shadow_desc *d) { d->bias_slope = 1001; }
static void edit_normal_offset(shd_shadow_desc *d) { d->normal_offset = -1; }
static void edit_caster_cull(shd_shadow_desc *d) { d->caster_cull = (shd_cull)3; }
static void edit_bleed(shd_shadow_desc *d) { d->bleed = 1; }
static void edit_min_variance(shd_shadow_desc *d) { d->min_variance = -1e-20f; }
static void edit_all(shd_shadow_desc *d)
{
    d->filter = SHD_SHADOW_FILTER_PCSS;
    d->taps = 15;
    d->filter_size = d->light_size = d->bias = d->normal_offset = d->min_variance = 1e9f;
    d->bias_slope = 1000;
    d->caster_cull = SHD_CULL_FRONT;
    d->bleed = 0.99f;
}

struct create_case {
    const char *name;
    void (*edit)(shd_shadow_desc *desc);
    shd_result expected;
    const char *message;
};
static const struct create_case k_create[] = {
    {"create/defaults", edit_nothing, SHD_OK, ""},
    {"create/all", edit_all, SHD_OK, ""},
    {"create/struct_size", edit_struct_size, BAD, "shadow.struct_size"},
    {"create/size_15", edit_size_15, BAD, "shadow.size: 15 is not in 16..8192"},
    {"create/size_16", edit_size_16, SHD_OK, ""},
    {"create/size_8192", edit_size_8192, SHD_OK, ""},
    {"create/size_8193", edit_size_8193, BAD, "shadow.size: 8193"},
    {"create/filter_5", edit_filter, BAD, "shadow.filter: 5"},
    {"create/filter_negative", edit_filter_negative, BAD, "shadow.filter"},
    {"create/taps_0", edit_taps_0, BAD, "shadow.taps: 0 is not in 1..15"},
    {"create/taps_16", edit_taps_16, BAD, "shadow.taps: 16"},
    {"create/filter_size_negative", edit_filter_size, BAD, "shadow.filter_size: -1"},
    {"create/filter_size_nan", edit_filter_size_nan, BAD, "shadow.filter_size"},
    {"create/light_size_1.1e9", edit_light_size, BAD, "shadow.light_size: 1.1e+09"},
    {"create/light_size_inf", edit_light_size_inf, BAD, "shadow.light_size: inf"},
    {"create/bias_negative", edit_bias, BAD, "shadow.bias: -0.001"},
    {"create/bias_nan", edit_bias_nan, BAD, "shadow.bias"},
    {"create/bias_slope_1001", edit_bias_slope, BAD, "shadow.bias_slope: 1001"},
    {"create/normal_offset_negative", edit_normal_offset, BAD, "shadow.normal_offset: -1"},
    {"create/caster_cull_3", edit_caster_cull, BAD, "shadow.caster_cull: 3"},
    {"create/bleed_1", edit_bleed, BAD, "shadow.bleed: 1 is not in 0..0.99"},
    {"create/min_variance_negative", edit_min_variance, BAD, "shadow.min_variance"},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_shadow_desc desc = shd_shadow_desc_default();
    shd_shadow *shadow = (shd_shadow *)&desc;
    c->edit(&desc);
    shd_assert_result(c->name, shd_shadow_create(g.context, &desc, &shadow), c->expected, c->message);
    assert_true((shadow != NULL) == (c->expected == SHD_OK));
    shd_shadow_release(shadow);
}

static void test_create_arguments(void **state)
{
    shd_shadow *shadow = (shd_shadow *)state;
    shd_assert_result("null_out", shd_shadow_create(g.context, NULL, NULL), BAD, "out_shadow");
    shd_assert_result("null_context", shd_shadow_create(NULL, NULL, &shadow), BAD, "context: NULL");
    assert_null(shadow);
    shd_assert_ok(shd_shadow_create(g.context, NULL, &shadow));
    shd_shadow_retain(shadow);
    shd_shadow_release(shadow);
    shd_shadow_release(shadow);
    shd_shadow_retain(NULL);
    shd_shadow_release(NULL);
}

static void no_light(shd_shadow_render_desc *d) { d->light = NULL; }
static void mesh_as_light(shd_shadow_render_desc *d) { d->light = (const shd_light *)(const void *)g.boxes.cube; }
static void ambient_light(shd_shadow_render_desc *d) { d->light = g.ambient; }
static void render_size(shd_shadow_render_desc *d) { d->struct_size = 12; }
static void no_draws(shd_shadow_render_desc *d) { d->draws = NULL; }
static void many_draws(shd_shadow_render_desc *d) { d->draw_count = (1u << 20) + 1; }
static void near_nan(shd_shadow_render_desc *d) { d->near_plane = (float)NAN; }
static void far_inf(shd_shadow_render_desc *d) { d->far_plane = INFINITY; }
static void near_at_far(shd_shadow_render_desc *d) { d->near_plane = d->far_plane = 2; }
static void near_of_point(shd_shadow_render_desc *d)
{
    d->light = g.point;
    d->far_plane = 2;
}
static void bounds_nan(shd_shadow_render_desc *d) { d->bounds_min[1] = (float)NAN; }
static void bounds_inf(shd_shadow_render_desc *d) { d->bounds_max[2] = INFINITY; }
static void bounds_reversed(shd_shadow_render_desc *d) { d->bounds_min[0] = 1; }
static void bad_draw(shd_shadow_render_desc *d)
{
    static shd_draw draw;
    draw = shd_draw_default();
    d->draws = &draw;
}
static void far_draw(shd_shadow_render_desc *d)
{
    static shd_draw draw;
    draw = g.boxes.draws[0];
    draw.object_to_world[12] = 1e30f;
    d->draws = &draw;
}

struct render_case {
    const char *name;
    void (*edit)(shd_shadow_render_desc *desc);
    const char *message;
};
static const struct render_case k_render[] = {
    {"render/no_light", no_light, "shadow_render.light: NULL"},
    {"render/mesh_as_light", mesh_as_light, "shadow_render.light: not a live handle"},
    {"render/ambient", ambient_light, "shadow_render.light: AMBIENT"},
    {"render/struct_size", render_size, "shadow_render.struct_size"},
    {"render/no_draws", no_draws, "shadow_render.draws: NULL"},
    {"render/many_draws", many_draws, "shadow_render.draw_count: 1048577"},
    {"render/near_nan", near_nan, "shadow_render.near_plane[0]"},
    {"render/far_inf", far_inf, "shadow_render.far_plane[0]: inf"},
    {"render/near_at_far", near_at_far, "shadow_render.far_plane: 2 is not above near_plane, 2"},
    {"render/near_0_of_point", near_of_point, "shadow_render.near_plane: 0"},
    {"render/bounds_nan", bounds_nan, "shadow_render.bounds_min[1]"},
    {"render/bounds_inf", bounds_inf, "shadow_render.bounds_max[2]: inf"},
    {"render/bounds_reversed", bounds_reversed, "shadow_render.bounds_max[0]: 0 is below bounds_min, 1"},
    {"render/bad_draw", bad_draw, "shadow_render.draws[0]: draw.mesh: NULL"},
    {"render/far_draw", far_draw, "shadow_render.draws: bounds of 1e+30 exceed 1e+18"},
};

/* The previous map stays, with the same bits. */
static void test_render(void **state)
{
    const struct render_case *c = (const struct render_case *)*state;
    static const float k_in[3] = {0.1f, -2, 0.2f}, k_out[3] = {3, -2, 0};
    shd_shadow_render_desc render = shd_shadow_render_desc_default();
    shd_shadow *shadow = shd_boxes_shadow(&g.boxes, g.context, NULL, g.light);
    render.light = g.light;
    render.draws = g.boxes.draws;
    render.draw_count = g.boxes.count;
    c->edit(&render);
    shd_assert_result(c->name, shd_shadow_render(g.context, shadow, &render), BAD, c->message);
    assert_true(shd_shadow_at(shadow, k_in, NULL) == 0.0f);
    assert_true(shd_shadow_at(shadow, k_out, NULL) == 1.0f);
    shd_shadow_release(shadow);
}

static void test_render_arguments(void **state)
{
    shd_shadow_render_desc render = shd_shadow_render_desc_default();
    shd_shadow *shadow = NULL;
    (void)state;
    render.light = g.light;
    shd_assert_ok(shd_shadow_create(g.context, NULL, &shadow));
    shd_assert_result("null_context", shd_shadow_render(NULL, shadow, &render), BAD, "context: NULL");
    shd_assert_result("null_shadow", shd_shadow_render(g.context, NULL, &render), BAD, "shadow: NULL");
    shd_assert_result("null_desc", shd_shadow_render(g.context, shadow, NULL), BAD, "shadow_render: NULL");
    shd_assert_ok(shd_shadow_render(g.context, shadow, &render)); /* nothing casts shadows */
    shd_shadow_release(shadow);
}

static void test_lookups(void **state)
{
    static const float k_p[6] = {0, -2, 0, 9, 9, 9};
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow *shadow = NULL;
    float value = -5;
    shd_shadow_values out = {sizeof out, {NULL, 0}, 0};
    int k;
    (void)state;
    shd_assert_ok(shd_shadow_create(g.context, NULL, &shadow));
    out.visibility.data = &value;
    shd_assert_result("not_rendered", shd_shadow_sample(shadow, &lookups, &out), BAD, "shadow: it was not rendered");
    shd_shadow_release(shadow);
    shadow = shd_boxes_shadow(&g.boxes, g.context, NULL, g.light);
    shd_assert_ok(shd_shadow_sample(shadow, &lookups, &out)); /* no points */
    lookups.count = 1;
    shd_assert_result("null_shadow", shd_shadow_sample(NULL, &lookups, &out), BAD, "shadow: NULL");
    shd_assert_result("null_lookups", shd_shadow_sample(shadow, NULL, &out), BAD, "lookups: NULL");
    shd_assert_result("no_position", shd_shadow_sample(shadow, &lookups, &out), BAD, "lookups.position[0].data");
    for (k = 0; k < 3; ++k) lookups.position[k].data = k_p + k;
    lookups.normal[1].data = k_p;
    shd_assert_result("one_normal", shd_shadow_sample(shadow, &lookups, &out), BAD, "lookups.normal[0].data");
    lookups.normal[1].data = NULL;
    lookups.position[2].stride = 7;
    shd_assert_result("stride", shd_shadow_sample(shadow, &lookups, &out), BAD, "lookups.position[2].stride: 7");
    lookups.position[2].stride = 0;
    shd_assert_result("out", shd_shadow_sample(shadow, &lookups, NULL), BAD, "values: NULL");
    lookups.struct_size = 4;
    shd_assert_result("struct_size", shd_shadow_sample(shadow, &lookups, &out), BAD, "lookups.struct_size");
    lookups.struct_size = sizeof lookups;
    out.visibility.data = NULL;
    shd_assert_result("no_out", shd_shadow_sample(shadow, &lookups, &out), BAD, "values.visibility.data: NULL");
    assert_true(value == -5.0f);
    shd_shadow_release(shadow);
}

/** Rows of eight floats: position, normal and two unused ones. */
static float g_rows[5][8];

struct overlap_case {
    const char *name;
    size_t first, stride; /**< position of `out`, in floats from the start of g_rows */
    const char *message;  /**< "" = accepted */
};
static const struct overlap_case k_overlaps[] = {
    {"overlaps/apart", 6, 8, ""},
    {"overlaps/position", 0, 8, "values.visibility: overlaps lookups.position[0]"},
    {"overlaps/normal", 4, 8, "values.visibility: overlaps lookups.normal[1]"},
    {"overlaps/a_row_later", 10, 8, "values.visibility: overlaps lookups.position[2]"},
    {"overlaps/packed", 11, 1, "values.visibility: overlaps lookups.normal[0]"},
};

static void test_overlaps(void **state)
{
    const struct overlap_case *c = (const struct overlap_case *)*state;
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow *shadow = shd_boxes_shadow(&g.boxes, g.context, NULL, g.light);
    shd_shadow_values out = {sizeof out, {NULL, 0}, 0};
    int k;
    lookups.count = 4;
    for (k = 0; k < 3; ++k) {
        lookups.position[k].data = &g_rows[0][k];
        lookups.normal[k].data = &g_rows[0][3 + k];
        lookups.position[k].stride = lookups.normal[k].stride = sizeof g_rows[0];
    }
    out.visibility.data = &g_rows[0][0] + c->first;
    out.visibility.stride = c->stride * sizeof(float);
    shd_assert_result(c->name, shd_shadow_sample(shadow, &lookups, &out), c->message[0] ? BAD : SHD_OK, c->message);
    shd_shadow_release(shadow);
}

/* Interleaved points in a batch that several tasks share. */
static void test_strides(void **state)
{
    enum { k_count = 40000 };
    static float points[k_count][7], packed[6][k_count], want[k_count], got[2 * k_count];
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow_values out = {sizeof out, {want, 0}, 0};
    shd_shadow_desc desc = shd_shadow_desc_default();
    shd_shadow *shadow;
    uint32_t seed = 1;
    int i, k;
    (void)state;
    desc.filter = SHD_SHADOW_FILTER_PCF;
    shadow = shd_boxes_shadow(&g.boxes, g.context, &desc, g.light);
    for (i = 0; i < k_count; ++i) {
        for (k = 0; k < 6; ++k) {
            shd_noise(&seed);
            points[i][k] = packed[k][i] = (float)(seed >> 8) / 8388608.0f - 1.0f;
        }
    }
    lookups.count = k_count;
    for (k = 0; k < 6; ++k) {
        shd_f32_in *column = k < 3 ? &lookups.position[k] : &lookups.normal[k - 3];
        column->data = packed[k];
    }
    shd_assert_ok(shd_shadow_sample(shadow, &lookups, &out));
    for (k = 0; k < 6; ++k) {
        shd_f32_in *column = k < 3 ? &lookups.position[k] : &lookups.normal[k - 3];
        column->data = &points[0][k];
        column->stride = sizeof points[0];
    }
    out.visibility.data = got;
    out.visibility.stride = 2 * sizeof(float);
    shd_assert_ok(shd_shadow_sample(shadow, &lookups, &out));
    for (i = 0; i < k_count; ++i) assert_true(got[2 * i] == want[i] && got[2 * i + 1] == 0.0f);
    shd_shadow_release(shadow);
}

int main(void)
{
    static struct CMUnitTest tests[64];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_create / sizeof k_create[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    for (i = 0; i < sizeof k_render / sizeof k_render[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_render[i].name, test_render, NULL, NULL, (void *)&k_render[i]};
    }
    tests[n++] = (struct CMUnitTest){"create/arguments", test_create_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"render/arguments", test_render_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"lookups", test_lookups, NULL, NULL, NULL};
    for (i = 0; i < sizeof k_overlaps / sizeof k_overlaps[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_overlaps[i].name, test_overlaps, NULL, NULL, (void *)&k_overlaps[i]};
    }
    tests[n++] = (struct CMUnitTest){"strides", test_strides, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.shadow", tests, n, set_up, tear_down);
}
