/* SPDX-License-Identifier: MIT */
/* Large framebuffers, whose rows are written past the caches, have the bits of small ones: the bands of a picture are
   equal to the whole picture. */
#include "support/scene.h"
#include "support/simd.h"

enum { WIDTH = 1091, HEIGHT = 1013, BAND = 200, MOST = 16 * WIDTH };

static unsigned char *g_whole, *g_band;
static float *g_whole_depth, *g_band_depth;

struct way {
    const char *name;
    shd_scene_kind scene;
    shd_format color;
    int plain; /* every material is one texture */
    uint32_t width, samples;
};
static const struct way k_ways[] = {
    {"pixels", SHD_SCENE_FLOOR, SHD_FORMAT_RGBA8, 1, WIDTH, 1},
    {"whole tiles", SHD_SCENE_FLOOR, SHD_FORMAT_RGBA8, 1, 1088, 1},
    {"sRGB", SHD_SCENE_FLOOR, SHD_FORMAT_RGBA8_SRGB, 1, WIDTH, 1},
    {"halves", SHD_SCENE_FLOOR, SHD_FORMAT_RGBA16F, 1, 1090, 1},
    {"lit", SHD_SCENE_LIT, SHD_FORMAT_RGBA8, 0, WIDTH, 1},
    {"lit, halves", SHD_SCENE_LIT, SHD_FORMAT_RGBA16F, 0, WIDTH, 1},
    {"planes", SHD_SCENE_FLOOR, SHD_FORMAT_RGBA32F, 1, WIDTH, 1},
    {"mixed planes", SHD_SCENE_MIXED, SHD_FORMAT_RGBA32F, 0, WIDTH, 1},
    {"blended planes", SHD_SCENE_GLASS, SHD_FORMAT_RGBA32F, 0, WIDTH, 4},
    {"samples", SHD_SCENE_GLASS, SHD_FORMAT_RGBA8, 0, WIDTH, 4},
};

/* Draws rows `top` to top + height - 1 of the picture. */
static void draw(const struct way *way, const shd_scene *scene, uint32_t top, uint32_t height, unsigned char *out,
                 float *depth)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_render_desc frame = scene->desc;
    shd_image view = shd_image_default();
    shd_f32_out column = {NULL, sizeof(float)};
    desc.width = way->width;
    desc.height = height;
    desc.color_format = way->color;
    desc.sample_count = way->samples;
    shd_assert_ok(shd_framebuffer_create(scene->context, &desc, &framebuffer));
    frame.framebuffer = framebuffer;
    frame.picture_width = way->width;
    frame.picture_height = HEIGHT;
    frame.crop_y = top;
    shd_assert_ok(shd_render(scene->context, &frame));
    frame.flags |= SHD_RENDER_LOAD; /* over the contents */
    shd_assert_ok(shd_render(scene->context, &frame));
    view.format = way->color;
    view.width = way->width;
    view.height = height;
    view.pixels = out;
    shd_assert_ok(shd_framebuffer_read_color(framebuffer, &view));
    column.data = depth;
    shd_assert_ok(shd_framebuffer_read_plane(framebuffer, SHD_PLANE_DEPTH, &column));
    shd_framebuffer_release(framebuffer);
}

/* Gives all draws a material whose colour is one texture of the scene. */
static shd_material *make_plain(shd_scene *scene)
{
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    shd_slot_list slots;
    size_t i;
    slots.count = 0;
    desc.model = SHD_MODEL_UNLIT;
    shd_slot_list_add(&slots, &desc, shd_slot_texture(SHD_SLOT_DIFFUSE, scene->texture[0], scene->sampler[0]));
    shd_assert_ok(shd_material_create(scene->context, &desc, &material));
    for (i = 0; i < scene->desc.draw_count; ++i) scene->draw[i].material = material;
    return material;
}

static void check_bands(const struct way *way, int simd, uint32_t workers)
{
    const size_t row = way->width * shd_format_size(way->color), depth_row = way->width * sizeof(float);
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    shd_material *plain = NULL;
    shd_scene scene;
    uint32_t top, y;
    desc.simd = (shd_simd)simd;
    desc.worker_count = workers;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&scene, way->scene, context);
    scene.desc.clear_color[1] = 0.25f;
    if (way->plain) plain = make_plain(&scene);
    draw(way, &scene, 0, HEIGHT, g_whole, g_whole_depth);
    for (top = 0; top < HEIGHT; top += BAND) {
        const uint32_t height = HEIGHT - top < BAND ? HEIGHT - top : BAND;
        draw(way, &scene, top, height, g_band, g_band_depth);
        for (y = 0; y < height; ++y) {
            const int same_color = memcmp(g_whole + (top + y) * row, g_band + y * row, row) == 0;
            const int same_depth =
                memcmp(g_whole_depth + (top + y) * way->width, g_band_depth + y * way->width, depth_row) == 0;
            if (!same_color || !same_depth) fail_msg("%s: simd %d, row %u", way->name, simd, top + y);
        }
    }
    shd_material_release(plain);
    shd_scene_close(&scene);
    shd_context_release(context);
}

static void test_bands(void **state)
{
    const struct way *way = (const struct way *)*state;
    int simd;
    check_bands(way, SHD_SIMD_BEST, 3);
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        if (shd_simd_can_run(simd) && way->plain) check_bands(way, simd, 1);
    }
}

int main(void)
{
    enum { WAYS = sizeof k_ways / sizeof k_ways[0] };
    struct CMUnitTest tests[WAYS];
    int i, failed;
    memset(tests, 0, sizeof tests);
    for (i = 0; i < WAYS; ++i) {
        tests[i].name = k_ways[i].name;
        tests[i].test_func = test_bands;
        tests[i].initial_state = (void *)&k_ways[i];
    }
    g_whole = shd_scene_memory((size_t)MOST * HEIGHT);
    g_band = shd_scene_memory((size_t)MOST * BAND);
    g_whole_depth = shd_scene_memory(sizeof(float) * WIDTH * HEIGHT);
    g_band_depth = shd_scene_memory(sizeof(float) * WIDTH * BAND);
    failed = _cmocka_run_group_tests("api.render_large", tests, WAYS, NULL, NULL);
    free(g_whole);
    free(g_band);
    free(g_whole_depth);
    free(g_band_depth);
    return failed;
}
