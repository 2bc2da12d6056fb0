/* SPDX-License-Identifier: MIT */
/* Framebuffers with interleaved colour: the bits that the float planes are read as, for every way to draw a frame. */
#include "support/scene.h"

static const shd_format k_formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F};
enum { FORMATS = sizeof k_formats / sizeof k_formats[0], WIDTH = 203, HEIGHT = 151 };

static unsigned char g_want[16 * WIDTH * HEIGHT];

static shd_framebuffer *make(shd_context *context, shd_format format, uint32_t samples)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.sample_count = samples;
    desc.aovs = SHD_AOV_UV | SHD_AOV_TRIANGLE | SHD_AOV_TARGET2;
    desc.color_format = format;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
    return framebuffer;
}

static shd_image packed(shd_format format, void *pixels)
{
    shd_image image = shd_image_default();
    image.format = format;
    image.width = WIDTH;
    image.height = HEIGHT;
    image.pixels = pixels;
    return image;
}

/* Fails unless the interleaved framebuffer has the colour and the planes of the one with four planes. */
static void expect_same(const char *what, const shd_framebuffer *planes, const shd_framebuffer *pixels)
{
    shd_image view = shd_image_default(), want;
    int plane;
    uint32_t y;
    shd_assert_ok(shd_framebuffer_view_color(pixels, &view));
    want = packed(view.format, g_want);
    shd_assert_ok(shd_framebuffer_read_color(planes, &want));
    for (y = 0; y < HEIGHT; ++y) {
        const size_t size = WIDTH * shd_format_size(view.format);
        if (memcmp((const char *)view.pixels + y * view.row_stride, g_want + y * size, size)) {
            fail_msg("%s: row %u of format %d differs", what, y, (int)view.format);
        }
    }
    for (plane = SHD_PLANE_DEPTH; plane <= SHD_PLANE_TARGET3_A; ++plane) {
        shd_plane_view a = shd_plane_view_default(), b = shd_plane_view_default();
        const shd_result result = shd_framebuffer_view_plane(planes, (shd_plane)plane, &a);
        assert_int_equal(shd_framebuffer_view_plane(pixels, (shd_plane)plane, &b), result);
        for (y = 0; result == SHD_OK && y < HEIGHT; ++y) {
            const char *const row_a = (const char *)(a.f32 ? (const void *)a.f32 : a.u32) + y * a.row_stride;
            const char *const row_b = (const char *)(b.f32 ? (const void *)b.f32 : b.u32) + y * b.row_stride;
            assert_memory_equal(row_a, row_b, 4 * WIDTH);
        }
    }
}

/* One way to draw the scene. */
struct way {
    const char *name;
    shd_scene_kind kind;
    uint32_t samples, passes, supersampling, workers;
    int window; /* scissor, or a part of a larger picture */
    float clear[4];
};
static const struct way k_ways[] = {
    {"plain", SHD_SCENE_MIXED, 1, 0, 0, 1, 0, {0.25f, 0.5f, 0.75f, 1}},
    {"workers", SHD_SCENE_MIXED, 1, 0, 0, 4, 0, {2, -1, 0, 0.5f}},
    {"glass", SHD_SCENE_GLASS, 1, 0, 0, 1, 0, {0, 0, 0, 0}},
    {"samples", SHD_SCENE_GLASS, 4, 0, 0, 1, 0, {0.1f, 0.2f, 0.3f, 0.4f}},
    {"scissor", SHD_SCENE_GLASS, 4, 0, 0, 1, 1, {0.5f, 0.5f, 0.5f, 1}},
    {"crop", SHD_SCENE_LIT, 1, 0, 0, 2, 2, {0.5f, 0.5f, 0.5f, 1}},
    {"passes", SHD_SCENE_GLASS, 1, 1024, 0, 1, 0, {0.7f, 0, 0, 1}},
    {"passes_samples", SHD_SCENE_MIXED, 4, 1024, 0, 4, 1, {0, 0.7f, 0, 1}},
    {"supersampling", SHD_SCENE_GLASS, 1, 0, 3, 1, 0, {0, 0, 0.7f, 1}},
    {"supersampling_scissor", SHD_SCENE_SURFACE, 2, 0, 2, 2, 1, {0, 0, 0.7f, 1}},
    {"lines", SHD_SCENE_LINES, 4, 0, 0, 1, 0, {1, 1, 1, 1}},
};

static void draw(const struct way *way, shd_scene *scene, shd_framebuffer *framebuffer)
{
    static const shd_region k_scissor = {37, 21, 100, 77};
    shd_render_desc desc = scene->desc;
    const float background[4] = {0.3f, 0.6f, 0.1f, 0.8f};
    desc.framebuffer = framebuffer;
    desc.stats = NULL;
    desc.draw_count = 0;
    memcpy(desc.clear_color, background, sizeof background);
    shd_assert_ok(shd_render(scene->context, &desc));
    desc.draw_count = scene->desc.draw_count;
    memcpy(desc.clear_color, way->clear, sizeof way->clear);
    if (way->passes) desc.pass_triangles = way->passes;
    if (way->supersampling) desc.supersampling = way->supersampling;
    if (way->window == 1) desc.scissor = &k_scissor;
    if (way->window == 2) {
        desc.picture_width = WIDTH + 99;
        desc.picture_height = HEIGHT + 50;
        desc.crop_x = 31;
        desc.crop_y = 29;
    }
    shd_assert_ok(shd_render(scene->context, &desc));
}

static void test_way(void **state)
{
    const struct way *way = (const struct way *)*state;
    int simd; /* unit.film.pixels has every target */
    for (simd = SHD_SIMD_BEST; simd <= SHD_SIMD_BASELINE; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        shd_framebuffer *planes;
        shd_scene scene;
        size_t i;
        desc.simd = (shd_simd)simd;
        desc.worker_count = way->workers;
        shd_assert_ok(shd_context_create(&desc, &context));
        shd_scene_open(&scene, way->kind, context);
        planes = make(context, SHD_FORMAT_RGBA32F, way->samples);
        draw(way, &scene, planes);
        for (i = 0; i < FORMATS; ++i) {
            shd_framebuffer *pixels = make(context, k_formats[i], way->samples);
            draw(way, &scene, pixels);
            expect_same(way->name, planes, pixels);
            shd_framebuffer_release(pixels);
        }
        shd_framebuffer_release(planes);
        shd_scene_close(&scene);
        shd_context_release(context);
    }
}

/* SHD_RENDER_LOAD starts from the rounded colour: a frame without draws changes nothing, one with draws blends over
   it. */
static void test_load(void **state)
{
    static float rounded[4][WIDTH * HEIGHT];
    shd_context *context = NULL;
    shd_scene scene;
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&scene, SHD_SCENE_GLASS, context);
    for (i = 0; i < FORMATS; ++i) {
        shd_framebuffer *pixels = make(context, k_formats[i], 1), *again = make(context, k_formats[i], 1);
        shd_render_desc desc = scene.desc;
        shd_image view = shd_image_default(), want = packed(SHD_FORMAT_RGBA32F, g_want);
        size_t c, k;
        draw(&k_ways[2], &scene, pixels);
        draw(&k_ways[2], &scene, again);
        desc.framebuffer = again;
        desc.stats = NULL;
        desc.flags = SHD_RENDER_LOAD;
        desc.draw_count = 0;
        shd_assert_ok(shd_render(context, &desc));
        shd_assert_ok(shd_framebuffer_view_color(pixels, &view));
        shd_assert_ok(shd_framebuffer_read_color(again, &want));
        for (c = 0; c < 4; ++c) {
            const shd_f32_out out = shd_f32_out_column(rounded[c], 0);
            shd_assert_ok(shd_framebuffer_read_plane(pixels, (shd_plane)(SHD_PLANE_R + c), &out));
            for (k = 0; k < WIDTH * HEIGHT; ++k) {
                float value;
                memcpy(&value, g_want + 16 * k + 4 * c, sizeof value);
                if (memcmp(&value, &rounded[c][k], sizeof value)) fail_msg("channel %zu of pixel %zu changed", c, k);
            }
        }
        desc.draw_count = scene.desc.draw_count;
        shd_assert_ok(shd_render(context, &desc));
        shd_assert_ok(shd_framebuffer_read_color(again, &want));
        for (k = c = 0; k < WIDTH * HEIGHT; ++k) {
            float value;
            memcpy(&value, g_want + 16 * k, sizeof value);
            c += value != rounded[0][k];
        }
        assert_true(c > 1000);
        shd_framebuffer_release(pixels);
        shd_framebuffer_release(again);
    }
    shd_scene_close(&scene);
    shd_context_release(context);
}

static void test_info(void **state)
{
    shd_context *context = NULL;
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (i = 0; i < FORMATS; ++i) {
        shd_framebuffer *pixels = make(context, k_formats[i], 1), *planes = make(context, SHD_FORMAT_RGBA32F, 1);
        shd_framebuffer_info a = shd_framebuffer_info_default(), b = shd_framebuffer_info_default();
        shd_image view = shd_image_default();
        const size_t stride = (WIDTH + 15) / 16 * 16, size = shd_format_size(k_formats[i]);
        shd_assert_ok(shd_framebuffer_get_info(pixels, &a));
        shd_assert_ok(shd_framebuffer_get_info(planes, &b));
        assert_int_equal(a.color_format, k_formats[i]);
        assert_int_equal(b.color_format, SHD_FORMAT_RGBA32F);
        assert_int_equal(b.byte_size - a.byte_size, stride * HEIGHT * (16 - size));
        shd_assert_ok(shd_framebuffer_view_color(pixels, &view));
        assert_int_equal(view.format, k_formats[i]);
        assert_int_equal(view.width, WIDTH);
        assert_int_equal(view.height, HEIGHT);
        assert_int_equal(view.row_stride, stride * size);
        shd_framebuffer_release(pixels);
        shd_framebuffer_release(planes);
    }
    shd_context_release(context);
}

static void test_refused(void **state)
{
    static const shd_format k_bad[] = {SHD_FORMAT_NONE,   SHD_FORMAT_R8,  SHD_FORMAT_RGBA16, SHD_FORMAT_RGB8,
                                       SHD_FORMAT_RGB32F, (shd_format)21, (shd_format)-1};
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT, absent = SHD_ERROR_NOT_FOUND;
    shd_context *context = NULL;
    shd_framebuffer *pixels, *planes;
    shd_plane_view plane = shd_plane_view_default();
    shd_image view = shd_image_default();
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (i = 0; i < sizeof k_bad / sizeof k_bad[0]; ++i) {
        shd_framebuffer_desc desc = shd_framebuffer_desc_default();
        shd_framebuffer *none = NULL;
        desc.width = desc.height = 8;
        desc.color_format = k_bad[i];
        shd_assert_result("format", shd_framebuffer_create(context, &desc, &none), bad, "framebuffer.color_format: ");
        assert_null(none);
    }
    pixels = make(context, SHD_FORMAT_RGBA8, 1);
    planes = make(context, SHD_FORMAT_RGBA32F, 1);
    shd_assert_result("plane", shd_framebuffer_view_plane(pixels, SHD_PLANE_G, &plane), absent, "plane: 1 is not in");
    shd_assert_result("planes", shd_framebuffer_view_color(planes, &view), absent, "framebuffer: its colour is four");
    assert_true(!view.pixels && view.width == 0);
    shd_assert_result("null", shd_framebuffer_view_color(pixels, NULL), bad, "out_view: NULL");
    shd_assert_result("null", shd_framebuffer_view_color(NULL, &view), bad, "framebuffer: NULL");
    view.struct_size = 4;
    shd_assert_result("size", shd_framebuffer_view_color(pixels, &view), bad, "out_view.struct_size: 4");
    shd_framebuffer_release(pixels);
    shd_framebuffer_release(planes);
    shd_context_release(context);
}

int main(void)
{
    struct CMUnitTest tests[32];
    size_t n = 0, i;
    memset(tests, 0, sizeof tests);
    for (i = 0; i < sizeof k_ways / sizeof k_ways[0]; ++i, ++n) {
        tests[n].name = k_ways[i].name;
        tests[n].test_func = test_way;
        tests[n].initial_state = (void *)&k_ways[i];
    }
    tests[n].name = "load", tests[n++].test_func = test_load;
    tests[n].name = "info", tests[n++].test_func = test_info;
    tests[n].name = "refused", tests[n++].test_func = test_refused;
    return _cmocka_run_group_tests("api.framebuffer_formats", tests, n, NULL, NULL);
}
