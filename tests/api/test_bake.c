/* SPDX-License-Identifier: MIT */
/* Bakes: values and states of texels, counts of bad charts, dilation, agreement with frames. */
#include "support/bake_frame.h"
#include "support/rows.h"

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
    assert_int_equal(stats.triangle_count, 2);
    assert_int_equal(stats.center_texel_count, k_texels);
    assert_int_equal(stats.touched_texel_count + stats.dilated_texel_count + stats.overlapping_texel_count, 0);
    assert_int_equal(stats.outside_triangle_count + stats.zero_area_triangle_count + stats.nonfinite_triangle_count, 0);
    assert_int_equal(f.stats.fragment_count, k_texels);
    for (i = 0; i < k_texels; ++i) {
        const double u = ((double)(i % k_width) + 0.5) / k_width, v = ((double)(i / k_width) + 0.5) / k_height;
        assert_int_equal(g_states[i], SHD_TEXEL_STATE_CENTER);
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
    assert_true(stats.touched_texel_count > 20 && stats.dilated_texel_count > 40);
    for (i = 0; i < k_texels; ++i) {
        const double x = (double)(i % k_width), y = (double)(i / k_width);
        const double left = 0.203 * k_width, right = 0.711 * k_width, top = 0.301 * k_height, bottom = 0.787 * k_height;
        const int touches = x + 1 > left + 0.004 && x < right - 0.004 && y + 1 > top + 0.004 && y < bottom - 0.004;
        const int centre = x + 0.5 > left && x + 0.5 < right && y + 0.5 > top && y + 0.5 < bottom;
        if (touches) assert_int_equal(g_states[i], centre ? SHD_TEXEL_STATE_CENTER : SHD_TEXEL_STATE_TOUCHED);
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
    assert_int_equal(stats.overlapping_texel_count, k_texels / 4);
    for (i = 0; i < k_texels; ++i) {
        const size_t x = i % k_width;
        assert_int_equal(f.u32[SHD_PLANE_DRAW][i], x < k_width / 2 ? 0 : 1); /* the first draw wins */
        shared += x >= k_width / 4 && x < k_width / 2;
    }
    assert_int_equal(shared, stats.overlapping_texel_count);
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
    assert_int_equal(stats.triangle_count, 1);
    assert_int_equal(stats.zero_area_triangle_count, c->zero_area);
    assert_int_equal(stats.outside_triangle_count, c->outside);
    assert_int_equal(stats.nonfinite_triangle_count, c->nonfinite);
    assert_int_equal(stats.center_texel_count + stats.touched_texel_count > 0, c->bakes);
    assert_int_equal(stats.nonfinite_texel_count, 0);
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
        assert_int_equal(stats.triangle_count, k == 2 || k == 4 ? 0 : 1);
        assert_int_equal(stats.zero_area_triangle_count, k <= 1 ? 1 : 0);
        assert_int_equal(stats.nonfinite_triangle_count, k == 3 ? 1 : 0);
        assert_int_equal(stats.center_texel_count + stats.touched_texel_count + stats.dilated_texel_count, 0);
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
    assert_int_equal(stats.center_texel_count, k_texels / 2);
    assert_true(stats.nonfinite_texel_count > k_texels / 8);
    for (i = 0; i < k_texels; ++i) {
        const int dropped = i % k_width < k_width / 2;
        assert_int_equal(g_states[i], dropped ? SHD_TEXEL_STATE_EMPTY : SHD_TEXEL_STATE_CENTER);
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
    return _cmocka_run_group_tests("api.bake", g_tests, g_count, NULL, NULL);
}
