/* SPDX-License-Identifier: MIT */
/* Bakes: values and states of texels, counts of bad charts, dilation, agreement with frames, refused descs. */
#include <stdlib.h>

#include "support/bake_scene.h"
#include "support/frame.h"
#include "support/rows.h"

enum { k_width = 48, k_height = 32, k_texels = k_width * k_height };
static uint32_t g_states[k_texels];

/* Bakes a frame of the fixture and reads its planes. */
static shd_bake_stats bake(shd_frame *f, shd_bake_desc desc)
{
    shd_bake_stats stats = shd_bake_stats_default();
    int plane;
    desc.states.data = g_states;
    desc.stats = &stats;
    shd_assert_ok(shd_bake(f->context, &f->desc, &desc));
    for (plane = 0; plane < SHD_FRAME_PLANES; ++plane) {
        const shd_f32_out floats = {f->plane[plane], 0};
        const shd_u32_out integers = {f->u32[plane], 0};
        if (f->plane[plane]) {
            shd_assert_ok(shd_framebuffer_read_plane(f->framebuffer, (shd_plane)plane, &floats));
        }
        if (f->u32[plane]) {
            shd_assert_ok(shd_framebuffer_read_u32_plane(f->framebuffer, (shd_plane)plane, &integers));
        }
    }
    return stats;
}

static void open_frame(shd_frame *f)
{
    shd_frame_open_aovs(f, k_width, k_height, 1,
                        SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE | SHD_AOV_POSITION | SHD_AOV_BARYCENTRICS |
                            SHD_AOV_DRAW | SHD_AOV_DERIVATIVES);
}

static shd_material_desc program_desc(void)
{
    shd_material_desc desc = shd_material_desc_default();
    desc.model = SHD_MODEL_PROGRAM;
    desc.program.fragment = shd_bake_program;
    return desc;
}

/* Two triangles that fill a rectangle of texture coordinates; positions are 3 u, 2 v, 1. */
static void set_quad(float *v, float u0, float v0, float u1, float v1)
{
    static const int k_corner[6][2] = {{0, 0}, {0, 1}, {1, 0}, {1, 0}, {0, 1}, {1, 1}};
    int i;
    for (i = 0; i < 6; ++i, v += 8) {
        const float x = k_corner[i][0] ? u1 : u0, y = k_corner[i][1] ? v1 : v0;
        const float vertex[8] = {3 * x, 2 * y, 1, 0, 0, 1, x, y};
        memcpy(v, vertex, sizeof vertex);
    }
}

/* A chart over the whole texture: every texel is shaded once at its centre, with derivatives of one texel. */
static void test_full_chart(void **state)
{
    shd_frame f;
    float vertices[48];
    const shd_material_desc material = program_desc();
    shd_bake_stats stats;
    size_t i;
    (void)state;
    open_frame(&f);
    set_quad(vertices, 0, 0, 1, 1);
    (void)shd_frame_draw(&f, vertices, 6, &material);
    stats = bake(&f, shd_bake_desc_default());
    assert_int_equal(stats.triangles, 2);
    assert_int_equal(stats.centre_texels, k_texels);
    assert_int_equal(stats.touched_texels + stats.dilated_texels + stats.overlapping_texels, 0);
    assert_int_equal(stats.outside_triangles + stats.zero_area_triangles + stats.nonfinite_triangles, 0);
    assert_int_equal(f.stats.fragments, k_texels);
    for (i = 0; i < k_texels; ++i) {
        const double u = ((double)(i % k_width) + 0.5) / k_width, v = ((double)(i / k_width) + 0.5) / k_height;
        assert_int_equal(g_states[i], SHD_TEXEL_STATE_CENTRE);
        shd_assert_close("u", i, f.plane[SHD_PLANE_U][i], u, 2e-7, 0);
        shd_assert_close("v", i, f.plane[SHD_PLANE_V][i], v, 2e-7, 0);
        shd_assert_close("r", i, f.plane[SHD_PLANE_R][i], 4 * u, 1e-6, 0);
        shd_assert_close("g", i, f.plane[SHD_PLANE_G][i], v, 1e-6, 0);
        shd_assert_close("b", i, f.plane[SHD_PLANE_B][i], (double)(i % k_width) + 0.5 + 1.0 / k_width, 1e-6, 1e-6);
        shd_assert_close("dvdy", i, f.plane[SHD_PLANE_DVDY][i], 1.0 / k_height, 0, 1e-5);
        assert_true(f.plane[SHD_PLANE_DEPTH][i] == 1.0f);
    }
    shd_frame_close(&f);
}

/* The bits of the planes are those of the triangle at the nearest point: nothing lies outside a chart. */
static void test_no_extrapolation(void **state)
{
    shd_frame f;
    float vertices[48];
    shd_bake_desc desc = shd_bake_desc_default();
    const shd_material_desc material = program_desc();
    shd_bake_stats stats;
    size_t i;
    (void)state;
    open_frame(&f);
    set_quad(vertices, 0.203f, 0.301f, 0.711f, 0.787f);
    (void)shd_frame_draw(&f, vertices, 6, &material);
    desc.dilation = 2;
    stats = bake(&f, desc);
    assert_true(stats.touched_texels > 20 && stats.dilated_texels > 40);
    for (i = 0; i < k_texels; ++i) {
        const double x = (double)(i % k_width), y = (double)(i / k_width);
        const double left = 0.203 * k_width, right = 0.711 * k_width, top = 0.301 * k_height, bottom = 0.787 * k_height;
        const int touches = x + 1 > left + 0.004 && x < right - 0.004 && y + 1 > top + 0.004 && y < bottom - 0.004;
        const int centre = x + 0.5 > left && x + 0.5 < right && y + 0.5 > top && y + 0.5 < bottom;
        if (touches) assert_int_equal(g_states[i], centre ? SHD_TEXEL_STATE_CENTRE : SHD_TEXEL_STATE_TOUCHED);
        if (!touches) assert_true(g_states[i] == SHD_TEXEL_STATE_EMPTY || g_states[i] == SHD_TEXEL_STATE_DILATED);
        if (g_states[i] == SHD_TEXEL_STATE_EMPTY) {
            assert_int_equal(f.triangle[i], 0xffffffff);
            assert_true(f.plane[SHD_PLANE_R][i] == 0.0f);
            continue;
        }
        assert_true(f.plane[SHD_PLANE_U][i] >= 0.203f && f.plane[SHD_PLANE_U][i] <= 0.711f);
        assert_true(f.plane[SHD_PLANE_V][i] >= 0.301f && f.plane[SHD_PLANE_V][i] <= 0.787f);
        if (touches) {
            const double u = fmin(fmax((x + 0.5) / k_width, 0.203), 0.711);
            shd_assert_close("u", i, f.plane[SHD_PLANE_U][i], u, 2.0 / (256 * k_width), 0);
        }
    }
    shd_frame_close(&f);
}

/* ---- bad charts ---- */

static void test_overlaps(void **state)
{
    shd_frame f;
    float vertices[2][48];
    const shd_material_desc material = program_desc();
    shd_bake_stats stats;
    size_t i, shared = 0;
    (void)state;
    open_frame(&f);
    set_quad(vertices[0], 0, 0, 0.5f, 1);
    set_quad(vertices[1], 0.25f, 0, 1, 1);
    (void)shd_frame_draw(&f, vertices[0], 6, &material);
    (void)shd_frame_draw(&f, vertices[1], 6, &material);
    stats = bake(&f, shd_bake_desc_default());
    assert_int_equal(stats.overlapping_texels, k_texels / 4);
    for (i = 0; i < k_texels; ++i) {
        const size_t x = i % k_width;
        assert_int_equal(f.u32[SHD_PLANE_DRAW][i], x < k_width / 2 ? 0 : 1); /* the first draw wins */
        shared += x >= k_width / 4 && x < k_width / 2;
    }
    assert_int_equal(shared, stats.overlapping_texels);
    shd_frame_close(&f);
}

struct chart_case {
    const char *name;
    float corner[3][2];
    uint64_t zero_area, outside, nonfinite;
    int bakes;
};
static const struct chart_case k_charts[] = {
    {"charts/point", {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, 1, 0, 0, 0},
    {"charts/line", {{0.25f, 0.25f}, {0.5f, 0.5f}, {0.75f, 0.75f}}, 1, 0, 0, 0},
    {"charts/below_the_grid", {{0.5f, 0.5f}, {0.50001f, 0.5f}, {0.5f, 0.50001f}}, 1, 0, 0, 0},
    {"charts/sliver", {{0.1f, 0.1f}, {0.9f, 0.11f}, {0.1f, 0.11f}}, 0, 0, 0, 1},
    {"charts/outside", {{1.5f, 0.5f}, {2.5f, 0.5f}, {1.5f, 0.9f}}, 0, 1, 0, 0},
    {"charts/negative", {{-1, -1}, {-2, -1}, {-1, -2}}, 0, 1, 0, 0},
    {"charts/over_the_edge", {{0.5f, 0.5f}, {1.5f, 0.5f}, {0.5f, 1.5f}}, 0, 1, 0, 1},
    {"charts/huge", {{-1e30f, -1e30f}, {1e30f, -1e30f}, {0, 1e30f}}, 0, 1, 0, 1},
    {"charts/beyond_float", {{-3e38f, 0}, {3e38f, 0}, {0, 3e38f}}, 0, 1, 1, 0},
    {"charts/nan", {{NAN, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.9f}}, 0, 0, 0, 1}, /* meshes read NaN as 0 */
    {"charts/mirrored", {{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}}, 0, 0, 0, 1},
    {"charts/whole_edge", {{0, 0}, {1, 0}, {0, 1}}, 0, 0, 0, 1},
};

static void test_chart(void **state)
{
    const struct chart_case *c = (const struct chart_case *)*state;
    shd_frame f;
    float vertices[24] = {0};
    const shd_material_desc material = program_desc();
    shd_bake_stats stats;
    int k;
    open_frame(&f);
    for (k = 0; k < 3; ++k) {
        float *v = vertices + 8 * k;
        v[k] = 1;
        v[5] = 1;
        v[6] = c->corner[k][0];
        v[7] = c->corner[k][1];
    }
    (void)shd_frame_draw(&f, vertices, 3, &material);
    stats = bake(&f, shd_bake_desc_default());
    assert_int_equal(stats.triangles, 1);
    assert_int_equal(stats.zero_area_triangles, c->zero_area);
    assert_int_equal(stats.outside_triangles, c->outside);
    assert_int_equal(stats.nonfinite_triangles, c->nonfinite);
    assert_int_equal(stats.centre_texels + stats.touched_texels > 0, c->bakes);
    assert_int_equal(stats.nonfinite_texels, 0);
    shd_frame_close(&f);
}

/* A mesh without uv, without uv1, without vertices, with positions that are not finite; no draws. */
static void test_no_coordinates(void **state)
{
    static const float k_position[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const float k_nan[9] = {0, 0, 0, NAN, 0, 0, 0, INFINITY, 0};
    static const float k_uv[6] = {0, 0, 1, 0, 0, 1};
    shd_frame f;
    const shd_material_desc material = program_desc();
    int k;
    (void)state;
    open_frame(&f);
    shd_assert_ok(shd_material_create(f.context, &material, &f.material[0]));
    for (k = 0; k < 5; ++k) {
        shd_mesh_desc desc = shd_mesh_desc_default();
        shd_bake_desc options = shd_bake_desc_default();
        shd_bake_stats stats;
        int c;
        desc.vertex_count = k == 2 ? 0 : 3;
        desc.flags = SHD_MESH_KEEP_NONFINITE;
        for (c = 0; c < 3; ++c) desc.position[c] = shd_f32_column((k == 3 ? k_nan : k_position) + c, 12);
        for (c = 0; c < 2 && k != 0; ++c) desc.uv[c] = shd_f32_column(k_uv + c, 8);
        shd_assert_ok(shd_mesh_create(f.context, &desc, &f.mesh[0]));
        f.draw[0] = shd_draw_default();
        f.draw[0].mesh = f.mesh[0];
        f.draw[0].material = f.material[0];
        f.desc.draw_count = k == 4 ? 0 : 1;
        options.uv_set = k == 1;
        options.dilation = 5;
        stats = bake(&f, options);
        assert_int_equal(stats.triangles, k == 2 || k == 4 ? 0 : 1);
        assert_int_equal(stats.zero_area_triangles, k <= 1 ? 1 : 0);
        assert_int_equal(stats.nonfinite_triangles, k == 3 ? 1 : 0);
        assert_int_equal(stats.centre_texels + stats.touched_texels + stats.dilated_texels, 0);
        shd_mesh_release(f.mesh[0]);
        f.mesh[0] = NULL;
    }
    shd_frame_close(&f);
}

/* ---- materials ---- */

/* A lit surface whose texture coordinates are its place in a parallel projection: the bake is the frame. */
static void test_like_a_frame(void **state)
{
    shd_frame f;
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc light = shd_light_desc_default();
    float vertices[3 * 8 * 40], *baked[4];
    uint32_t seed = 3;
    size_t i, c;
    int triangle, k;
    (void)state;
    open_frame(&f);
    for (triangle = 0; triangle < 40; ++triangle) {
        const float x = (float)(triangle % 8) / 8, y = (float)(triangle / 8) / 5;
        for (k = 0; k < 3; ++k) {
            float *v = vertices + 8 * (3 * triangle + k);
            v[6] = x + (k == 1 ? 0.125f : 0.0f);
            v[7] = y + (k == 2 ? 0.2f : 0.0f);
            v[0] = 2 * v[6] - 1;
            v[1] = 1 - 2 * v[7];
            v[2] = 0.5f + 0.2f * shd_bake_random(&seed);
            v[3] = shd_bake_random(&seed) - 0.5f;
            v[4] = shd_bake_random(&seed) - 0.5f;
            v[5] = 1;
        }
    }
    material.model = SHD_MODEL_BLINN_PHONG;
    material.specular[0] = material.specular[1] = material.specular[2] = 0.5f;
    (void)shd_frame_draw(&f, vertices, 120, &material);
    light.kind = SHD_LIGHT_KIND_POINT;
    light.position[2] = 2;
    shd_frame_light(&f, &light);
    f.desc.view.eye[2] = 3;
    (void)bake(&f, shd_bake_desc_default());
    for (c = 0; c < 4; ++c) {
        baked[c] = (float *)malloc(k_texels * sizeof(float));
        assert_non_null(baked[c]);
        memcpy(baked[c], f.plane[c], k_texels * sizeof(float));
    }
    shd_frame_render(&f);
    for (i = 0, k = 0; i < k_texels; ++i) {
        if (f.triangle[i] == 0xffffffff) continue;
        ++k;
        for (c = 0; c < 4; ++c) shd_assert_close("channel", i, baked[c][i], f.plane[c][i], 2e-5, 0);
    }
    assert_true(k > k_texels / 3);
    for (c = 0; c < 4; ++c) free(baked[c]);
    shd_frame_close(&f);
}

static void discard_left(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        out->discard[i] = in->u[i] < 0.5f;
        out->r[i] = i % 2 ? NAN : 1.0f;
        out->a[i] = 0.25f;
    }
}

/* Dropped fragments leave texels empty, blends write the colour itself, and NaN is counted. */
static void test_dropped(void **state)
{
    shd_frame f;
    float vertices[48];
    shd_material_desc material = program_desc();
    shd_bake_stats stats;
    size_t i;
    (void)state;
    open_frame(&f);
    set_quad(vertices, 0, 0, 1, 1);
    material.program.fragment = discard_left;
    material.flags = SHD_MATERIAL_DISCARDS;
    material.blend = SHD_BLEND_PREMULTIPLIED;
    (void)shd_frame_draw(&f, vertices, 6, &material);
    stats = bake(&f, shd_bake_desc_default());
    assert_int_equal(stats.centre_texels, k_texels / 2);
    assert_true(stats.nonfinite_texels > k_texels / 8);
    for (i = 0; i < k_texels; ++i) {
        const int dropped = i % k_width < k_width / 2;
        assert_int_equal(g_states[i], dropped ? SHD_TEXEL_STATE_EMPTY : SHD_TEXEL_STATE_CENTRE);
        assert_true(f.plane[SHD_PLANE_A][i] == (dropped ? 0.0f : 0.25f));
        assert_int_equal(f.triangle[i] == 0xffffffff, dropped);
    }
    shd_frame_close(&f);
}

/* Interleaved colour, and every frequency. */
static void test_formats(void **state)
{
    shd_context *context = NULL;
    shd_framebuffer_desc target = shd_framebuffer_desc_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_material_desc material_desc = shd_material_desc_default();
    shd_material *material = NULL;
    shd_draw draw = shd_draw_default();
    static float red[k_bake_texels];
    const shd_f32_out column = {red, 0};
    int frequency;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    target.width = k_bake_width;
    target.height = k_bake_height;
    target.color_format = SHD_FORMAT_RGBA8_SRGB;
    shd_assert_ok(shd_framebuffer_create(context, &target, &frame.framebuffer));
    material_desc.model = SHD_MODEL_UNLIT;
    material_desc.diffuse[0] = 0.5f;
    shd_assert_ok(shd_material_create(context, &material_desc, &material));
    draw.mesh = shd_bake_mesh(context, 90, 4);
    draw.material = material;
    frame.draws = &draw;
    frame.draw_count = 1;
    frame.clear_color[0] = 1.0f;
    for (frequency = SHD_FREQUENCY_PHONG; frequency <= SHD_FREQUENCY_FLAT; ++frequency) {
        shd_bake_desc desc = shd_bake_desc_default();
        static uint32_t states[k_bake_texels];
        size_t i;
        draw.frequency = (shd_frequency)frequency;
        desc.states.data = states;
        desc.dilation = 4;
        shd_assert_ok(shd_bake(context, &frame, &desc));
        shd_assert_ok(shd_framebuffer_read_plane(frame.framebuffer, SHD_PLANE_R, &column));
        for (i = 0; i < k_bake_texels; ++i) {
            shd_assert_close("red", i, red[i], states[i] == SHD_TEXEL_STATE_EMPTY ? 1.0 : 0.5, 0.005, 0);
        }
    }
    shd_mesh_release((shd_mesh *)draw.mesh);
    shd_material_release(material);
    shd_framebuffer_release(frame.framebuffer);
    shd_context_release(context);
}

/* ---- refused descs ---- */

static const shd_region k_region = {0, 0, 4, 4};
struct bad_case {
    const char *name;
    void (*edit)(shd_render_desc *frame, shd_bake_desc *bake);
    const char *message;
};
static void bad_uv_set(shd_render_desc *f, shd_bake_desc *b) { (void)f, b->uv_set = 2; }
static void bad_dilation(shd_render_desc *f, shd_bake_desc *b) { (void)f, b->dilation = 1025; }
static void bad_bake_flags(shd_render_desc *f, shd_bake_desc *b) { (void)f, b->flags = 1; }
static void bad_states(shd_render_desc *f, shd_bake_desc *b) { (void)f, b->states.stride = 3; }
static void bad_framebuffer(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->framebuffer = NULL; }
static void bad_flags(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->flags = SHD_RENDER_LOAD; }
static void bad_visibility(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->visibility = SHD_VISIBILITY_NEWELL; }
static void bad_picture(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->picture_width = 99; }
static void bad_crop(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->crop_y = 1; }
static void bad_viewport(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->viewport = &k_region; }
static void bad_scissor(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->scissor = &k_region; }
static void bad_supersampling(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->supersampling = 2; }
static void bad_background(shd_render_desc *f, shd_bake_desc *b)
{
    (void)b, f->background = SHD_BACKGROUND_ENVIRONMENT;
}
static void bad_volumes(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->volume_count = 1; }
static void bad_clear(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->clear_color[2] = NAN; }
static void bad_draws(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->draws = NULL; }
static void bad_material(shd_render_desc *f, shd_bake_desc *b)
{
    static shd_draw draw;
    (void)b;
    draw = f->draws[0];
    draw.material = NULL;
    f->draws = &draw;
}
static const struct bad_case k_bad[] = {
    {"bad/uv_set", bad_uv_set, "bake.uv_set: 2 is not in 0..1"},
    {"bad/dilation", bad_dilation, "bake.dilation: 1025 is not in 0..1024"},
    {"bad/bake_flags", bad_bake_flags, "bake.flags: 1"},
    {"bad/states", bad_states, "bake.states.stride: 3"},
    {"bad/framebuffer", bad_framebuffer, "render.framebuffer: NULL"},
    {"bad/flags", bad_flags, "render.flags: a bake takes"},
    {"bad/visibility", bad_visibility, "render.visibility: a bake takes"},
    {"bad/picture", bad_picture, "render.picture_width and picture_height: a bake takes"},
    {"bad/crop", bad_crop, "render.crop_x and crop_y: a bake takes"},
    {"bad/viewport", bad_viewport, "render.viewport: a bake takes"},
    {"bad/scissor", bad_scissor, "render.scissor: a bake takes"},
    {"bad/supersampling", bad_supersampling, "render.supersampling: a bake takes"},
    {"bad/background", bad_background, "render.background: a bake takes"},
    {"bad/volumes", bad_volumes, "render.volume_count: a bake takes"},
    {"bad/clear_color", bad_clear, "render.clear_color[2]: nan"},
    {"bad/draws", bad_draws, "render.draws: NULL"},
    {"bad/material", bad_material, "render.draws[0]: draw.material: NULL, but a bake shades every draw"},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    shd_frame f;
    float vertices[48];
    const shd_material_desc material = program_desc();
    shd_bake_desc desc = shd_bake_desc_default();
    shd_bake_stats stats = shd_bake_stats_default();
    open_frame(&f);
    set_quad(vertices, 0, 0, 1, 1);
    (void)shd_frame_draw(&f, vertices, 6, &material);
    stats.triangles = 7;
    desc.stats = &stats;
    desc.states.data = g_states;
    c->edit(&f.desc, &desc);
    shd_assert_result(c->name, shd_bake(f.context, &f.desc, &desc), SHD_ERROR_INVALID_ARGUMENT, c->message);
    assert_int_equal(stats.triangles, 0);
    shd_frame_close(&f);
}

static void test_bad_handles(void **state)
{
    shd_frame f;
    shd_framebuffer_desc four = shd_framebuffer_desc_default();
    shd_framebuffer *samples = NULL;
    (void)state;
    open_frame(&f);
    shd_assert_result("context", shd_bake(NULL, &f.desc, NULL), SHD_ERROR_INVALID_ARGUMENT, "context: NULL");
    shd_assert_result("frame", shd_bake(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "render: NULL");
    four.width = four.height = 8;
    four.samples = 4;
    shd_assert_ok(shd_framebuffer_create(f.context, &four, &samples));
    f.desc.framebuffer = samples;
    shd_assert_result("samples", shd_bake(f.context, &f.desc, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "render.framebuffer: 4 samples a pixel, but a bake takes 1");
    shd_framebuffer_release(samples);
    shd_frame_close(&f);
}

int main(void)
{
    add("full_chart", test_full_chart, NULL);
    add("no_extrapolation", test_no_extrapolation, NULL);
    add("overlaps", test_overlaps, NULL);
    ADD_ROWS(k_charts, test_chart);
    add("no_coordinates", test_no_coordinates, NULL);
    add("like_a_frame", test_like_a_frame, NULL);
    add("dropped", test_dropped, NULL);
    add("formats", test_formats, NULL);
    ADD_ROWS(k_bad, test_bad);
    add("bad_handles", test_bad_handles, NULL);
    return _cmocka_run_group_tests("api.bake", g_tests, g_count, NULL, NULL);
}
