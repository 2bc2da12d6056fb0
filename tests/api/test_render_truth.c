/* SPDX-License-Identifier: MIT */
/* Frames with known pixels: coverage, depth, order, clearing, culling, texture orientation, perspective. */
#include "support/frame.h"

struct cover_case {
    const char *name;
    uint32_t width, height;
};
static const struct cover_case k_covers[] = {{"cover/1x1", 1, 1},
                                             {"cover/7x5", 7, 5},
                                             {"cover/64x64", 64, 64},
                                             {"cover/65x63", 65, 63},
                                             {"cover/203x151", 203, 151}};

/* Two triangles over the whole frame: each pixel belongs to exactly one of them. */
static void test_cover(void **state)
{
    const struct cover_case *c = (const struct cover_case *)*state;
    const shd_material_desc plain = shd_frame_plain(0.25f, 0.5f, 0.75f);
    const size_t pixels = (size_t)c->width * c->height;
    float quad[48];
    size_t i, lower = 0;
    shd_frame f;
    shd_frame_open(&f, c->width, c->height);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &plain);
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    assert_int_equal(f.stats.fragment_count, pixels);
    assert_int_equal(f.stats.rasterized_triangle_count, 2);
    for (i = 0; i < pixels; ++i) {
        assert_true(f.triangle[i] < 2);
        lower += f.triangle[i] == 0;
        shd_assert_close("r", i, (double)f.plane[SHD_PLANE_R][i], 0.25, 1e-7, 0.0);
        shd_assert_close("g", i, (double)f.plane[SHD_PLANE_G][i], 0.5, 1e-7, 0.0);
        shd_assert_close("b", i, (double)f.plane[SHD_PLANE_B][i], 0.75, 1e-7, 0.0);
        shd_assert_close("a", i, (double)f.plane[SHD_PLANE_A][i], 1.0, 0.0, 0.0);
        shd_assert_close("depth", i, (double)f.plane[SHD_PLANE_DEPTH][i], 0.5, 0.0, 0.0);
    }
    assert_true(pixels < 2 || (lower > pixels / 3 && lower < pixels * 2 / 3 + 1));
    shd_frame_close(&f);
}

/* Each triangle alone covers exactly the pixels that the other does not cover. */
static void test_shared_edge(void **state)
{
    const shd_material_desc plain = shd_frame_plain(1, 1, 1);
    float quad[48];
    size_t i;
    uint64_t sum;
    shd_frame f;
    uint32_t first[33 * 29];
    (void)state;
    shd_frame_open(&f, 33, 29);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 3, &plain);
    shd_frame_draw(&f, quad + 24, 3, &plain);
    f.desc.draw_count = 1;
    shd_frame_render(&f);
    sum = f.stats.fragment_count;
    memcpy(first, f.triangle, sizeof first);
    f.desc.draws = &f.draw[1];
    shd_frame_render(&f);
    sum += f.stats.fragment_count;
    assert_int_equal(sum, 33 * 29);
    for (i = 0; i < 33 * 29; ++i) assert_true((first[i] == 0) != (f.triangle[i] == 0));
    shd_frame_close(&f);
}

static void test_depth_ramp(void **state)
{
    const shd_material_desc plain = shd_frame_plain(1, 1, 1);
    float quad[48];
    uint32_t x, y;
    shd_frame f;
    (void)state;
    shd_frame_open(&f, 97, 31);
    shd_frame_quad(-1, -1, 1, 1, 0.125f, 0.875f, quad);
    shd_frame_draw(&f, quad, 6, &plain);
    shd_frame_render(&f);
    for (y = 0; y < 31; ++y) {
        for (x = 0; x < 97; ++x) {
            const size_t at = (size_t)y * 97 + x;
            shd_assert_close("depth", at, (double)f.plane[SHD_PLANE_DEPTH][at], 0.125 + 0.75 * (x + 0.5) / 97, 1e-6, 0);
            shd_assert_close("u", at, (double)f.plane[SHD_PLANE_U][at], (x + 0.5) / 97, 1e-6, 0.0);
            shd_assert_close("v", at, (double)f.plane[SHD_PLANE_V][at], (y + 0.5) / 31, 1e-6, 0.0);
            shd_assert_close("nz", at, (double)f.plane[SHD_PLANE_NZ][at], 1.0, 1e-6, 0.0);
        }
    }
    shd_frame_close(&f);
}

struct order_case {
    const char *name;
    float first, second; /* depths of two quads over everything, red then green */
    float clear_depth;
    int expected; /* 0 red, 1 green, 2 neither */
};
static const struct order_case k_orders[] = {
    {"order/nearer_second", 0.5f, 0.25f, 1.0f, 1},        {"order/farther_second", 0.25f, 0.5f, 1.0f, 0},
    {"order/tie_keeps_first", 0.5f, 0.5f, 1.0f, 0},       {"order/clear_depth_between", 0.5f, 0.25f, 0.4f, 1},
    {"order/clear_depth_nearest", 0.5f, 0.25f, 0.25f, 2}, {"order/at_far_plane", 1.0f, 1.0f, 1.0f, 2},
    {"order/at_near_plane", 0.5f, 0.0f, 1.0f, 1},
};
static void test_order(void **state)
{
    const struct order_case *c = (const struct order_case *)*state;
    const shd_material_desc red = shd_frame_plain(1, 0, 0), green = shd_frame_plain(0, 1, 0);
    const double want_depth = c->expected == 0   ? (double)c->first
                              : c->expected == 1 ? (double)c->second
                                                 : (double)c->clear_depth;
    float quad[48];
    size_t i;
    shd_frame f;
    shd_frame_open(&f, 70, 3);
    shd_frame_quad(-1, -1, 1, 1, c->first, c->first, quad);
    shd_frame_draw(&f, quad, 6, &red);
    shd_frame_quad(-1, -1, 1, 1, c->second, c->second, quad);
    shd_frame_draw(&f, quad, 6, &green);
    shd_frame_ambient(&f);
    f.desc.clear_depth = c->clear_depth;
    f.desc.clear_color[2] = 0.5f;
    shd_frame_render(&f);
    assert_int_equal(f.stats.fragment_count, c->expected == 2 ? 0 : 210);
    for (i = 0; i < 210; ++i) {
        shd_assert_close("r", i, (double)f.plane[SHD_PLANE_R][i], c->expected == 0, 0.0, 0.0);
        shd_assert_close("g", i, (double)f.plane[SHD_PLANE_G][i], c->expected == 1, 0.0, 0.0);
        shd_assert_close("b", i, (double)f.plane[SHD_PLANE_B][i], c->expected == 2 ? 0.5 : 0.0, 0.0, 0.0);
        shd_assert_close("depth", i, (double)f.plane[SHD_PLANE_DEPTH][i], want_depth, 0.0, 0.0);
        assert_int_equal(f.triangle[i] == 0xffffffffu, c->expected == 2);
    }
    shd_frame_close(&f);
}

/* Two draws in one frame give the same pixels as two frames, the second with SHD_RENDER_LOAD. */
static void test_load(void **state)
{
    const shd_material_desc red = shd_frame_plain(1, 0, 0), green = shd_frame_plain(0, 1, 0);
    static float together[SHD_PLANE_TRIANGLE][100 * 80];
    float quad[48];
    int plane;
    shd_frame f;
    (void)state;
    shd_frame_open(&f, 100, 80);
    shd_frame_quad(-0.9f, -0.8f, 0.4f, 0.9f, 0.2f, 0.8f, quad);
    shd_frame_draw(&f, quad, 6, &red);
    shd_frame_quad(-0.3f, -0.9f, 0.8f, 0.5f, 0.7f, 0.3f, quad);
    shd_frame_draw(&f, quad, 6, &green);
    shd_frame_ambient(&f);
    f.desc.clear_color[0] = 0.125f;
    shd_frame_render(&f);
    for (plane = 0; plane < SHD_PLANE_TRIANGLE; ++plane) memcpy(together[plane], f.plane[plane], sizeof together[0]);
    f.desc.draw_count = 1;
    shd_frame_render(&f);
    f.desc.flags |= SHD_RENDER_LOAD;
    f.desc.clear_color[0] = 0.75f; /* not used */
    f.desc.clear_depth = 0.0f;
    f.desc.draws = &f.draw[1];
    shd_frame_render(&f);
    for (plane = 0; plane < SHD_PLANE_TRIANGLE; ++plane) {
        assert_memory_equal(together[plane], f.plane[plane], sizeof together[0]);
    }
    f.desc.draw_count = 0;
    shd_frame_render(&f);
    assert_memory_equal(together[0], f.plane[0], sizeof together[0]);
    shd_frame_close(&f);
}

struct cull_case {
    const char *name;
    shd_cull cull;
    int clockwise, mirrored, drawn;
};
static const struct cull_case k_culls[] = {
    {"cull/none_front", SHD_CULL_NONE, 0, 0, 1},          {"cull/none_back", SHD_CULL_NONE, 1, 0, 1},
    {"cull/back_front", SHD_CULL_BACK, 0, 0, 1},          {"cull/back_back", SHD_CULL_BACK, 1, 0, 0},
    {"cull/front_front", SHD_CULL_FRONT, 0, 0, 0},        {"cull/front_back", SHD_CULL_FRONT, 1, 0, 1},
    {"cull/back_front_mirrored", SHD_CULL_BACK, 0, 1, 0}, {"cull/back_back_mirrored", SHD_CULL_BACK, 1, 1, 1},
};
static void test_cull(void **state)
{
    const struct cull_case *c = (const struct cull_case *)*state;
    const shd_material_desc plain = shd_frame_plain(1, 1, 1);
    float quad[48];
    shd_draw *draw;
    shd_frame f;
    shd_frame_open(&f, 20, 20);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    if (c->clockwise) {
        float swapped[8];
        int t;
        for (t = 0; t < 2; ++t) {
            memcpy(swapped, quad + 24 * t + 8, sizeof swapped);
            memcpy(quad + 24 * t + 8, quad + 24 * t + 16, sizeof swapped);
            memcpy(quad + 24 * t + 16, swapped, sizeof swapped);
        }
    }
    draw = shd_frame_draw(&f, quad, 6, &plain);
    draw->cull = c->cull;
    if (c->mirrored) draw->object_to_world[0] = -1.0f;
    shd_frame_render(&f);
    assert_int_equal(f.stats.fragment_count, c->drawn ? 400 : 0);
    assert_int_equal(f.stats.culled_triangle_count, c->drawn ? 0 : 2);
    shd_frame_close(&f);
}

/* A texture on a quad with one pixel per texel: every texel is at its pixel, row 0 on top. */
static void test_texels(void **state)
{
    enum { k_width = 37, k_height = 23 };
    static float texels[k_height][k_width][4];
    shd_texture_desc texture = shd_texture_desc_default();
    shd_sampler_desc sampler = shd_sampler_desc_default();
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc light = shd_light_desc_default();
    shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, NULL, NULL);
    float quad[48];
    uint32_t x, y, c;
    shd_frame f;
    (void)state;
    for (y = 0; y < k_height; ++y) {
        for (x = 0; x < k_width; ++x) {
            texels[y][x][0] = 0.03125f * (float)x;
            texels[y][x][1] = 0.0625f * (float)y;
            texels[y][x][2] = (float)((x * 7 + y * 13) % 32) * 0.25f;
        }
    }
    shd_frame_open(&f, k_width, k_height);
    texture.format = SHD_FORMAT_RGBA32F;
    texture.width = k_width;
    texture.height = k_height;
    texture.texels = texels;
    shd_assert_ok(shd_texture_create(f.context, &texture, &slot.texture));
    sampler.filter = SHD_FILTER_NEAREST;
    shd_assert_ok(shd_sampler_create(f.context, &sampler, &slot.sampler));
    material.slots = &slot;
    material.slot_count = 1;
    for (c = 0; c < 3; ++c) material.diffuse[c] = 1.0f;
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &material);
    shd_texture_release(slot.texture); /* the material retains them */
    shd_sampler_release(slot.sampler);
    light.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    light.direction[1] = 0.0f;
    light.direction[2] = -1.0f;
    shd_frame_light(&f, &light);
    shd_frame_render(&f);
    for (y = 0; y < k_height; ++y) {
        for (x = 0; x < k_width; ++x) {
            for (c = 0; c < 3; ++c) {
                const size_t at = (size_t)y * k_width + x;
                shd_assert_close("texel", 4 * at + c, (double)f.plane[c][at], (double)texels[y][x][c], 1e-6, 1e-6);
            }
        }
    }
    shd_frame_close(&f);
}

/* A floor seen by a camera: uv against the intersection of the pixel's ray, in double. */
static void test_perspective(void **state)
{
    static const float k_size = 50.0f;
    const shd_material_desc plain = shd_frame_plain(1, 1, 1);
    const float corner[4][8] = {{-50, 0, 50, 0, 1, 0, 0, 0},
                                {50, 0, 50, 0, 1, 0, 1, 0},
                                {50, 0, -50, 0, 1, 0, 1, 1},
                                {-50, 0, -50, 0, 1, 0, 0, 1}};
    static const int k_order[6] = {0, 1, 2, 0, 2, 3};
    shd_camera camera = shd_camera_default();
    float quad[48];
    double focal;
    uint32_t x, y, seen = 0;
    shd_frame f;
    int i;
    (void)state;
    for (i = 0; i < 6; ++i) memcpy(quad + 8 * i, corner[k_order[i]], sizeof corner[0]);
    shd_frame_open(&f, 120, 90);
    shd_frame_draw(&f, quad, 6, &plain);
    camera.aspect = 120.0f / 90.0f;
    camera.eye[0] = 0.0f;
    camera.eye[1] = 2.0f;
    camera.eye[2] = 0.0f;
    camera.target[1] = 2.0f; /* level, towards -z */
    camera.target[2] = -10.0f;
    shd_assert_ok(shd_view_from_camera(&camera, &f.desc.view));
    shd_frame_render(&f);
    focal = 1.0 / tan(0.5 * (double)camera.fov_y);
    for (y = 0; y < 90; ++y) {
        for (x = 0; x < 120; ++x) {
            const size_t at = (size_t)y * 120 + x;
            const double dx = (2.0 * (x + 0.5) / 120 - 1) * (double)camera.aspect / focal;
            const double dy = (1 - 2.0 * (y + 0.5) / 90) / focal;
            const double t = -2.0 / dy, wx = dx * t, wz = -t; /* where the ray meets y = 0 */
            const int inside = dy < 0 && t > 0.1 && t < 49.9 && wx > -49.9 && wx < 49.9;
            if (f.triangle[at] == 0xffffffffu) {
                assert_false(inside);
                continue;
            }
            ++seen;
            shd_assert_close("u", at, (double)f.plane[SHD_PLANE_U][at], (wx + (double)k_size) / 100, 2e-5, 1e-5);
            shd_assert_close("v", at, (double)f.plane[SHD_PLANE_V][at], ((double)k_size - wz) / 100, 2e-5, 1e-5);
        }
    }
    assert_true(seen > 3000);
    shd_frame_close(&f);
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_covers / sizeof k_covers[0] + sizeof k_orders / sizeof k_orders[0] +
                                   sizeof k_culls / sizeof k_culls[0] + 5];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_covers / sizeof k_covers[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_covers[i].name, test_cover, NULL, NULL, (void *)&k_covers[i]};
    }
    for (i = 0; i < sizeof k_orders / sizeof k_orders[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_orders[i].name, test_order, NULL, NULL, (void *)&k_orders[i]};
    }
    for (i = 0; i < sizeof k_culls / sizeof k_culls[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_culls[i].name, test_cull, NULL, NULL, (void *)&k_culls[i]};
    }
    tests[n++] = (struct CMUnitTest){"shared_edge", test_shared_edge, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"depth_ramp", test_depth_ramp, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"load", test_load, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"texels", test_texels, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"perspective", test_perspective, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_truth", tests, n, NULL, NULL);
}
