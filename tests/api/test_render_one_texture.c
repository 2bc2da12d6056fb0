/* SPDX-License-Identifier: MIT */
/* Materials whose colour is one lookup have a path of their own, which frames with further planes do not take: both
   give the same bits. */
#include "support/pixel_hash.h"
#include "support/simd.h"

enum { WIDTH = 203, HEIGHT = 151, PIXELS = WIDTH * HEIGHT };

static unsigned char g_got[16 * PIXELS], g_want[16 * PIXELS];

/* A scene in perspective, or without; a surface that covers the whole picture. AFFINE: with SHD_DRAW_AFFINE */
enum { SCENE, PARALLEL, FLOOR, AFFINE = 4 };

struct way {
    const char *name;
    shd_format texture;
    shd_filter filter;
    shd_wrap wrap;
    shd_precision precision;
    float diffuse[3];
    int moved; /* the slot has a uv transform */
    shd_format color;
    uint32_t samples, workers, supersampling;
    int window; /* scissor, or a part of a larger picture */
    int view;
};
#define WHITE   \
    {           \
        1, 1, 1 \
    }
static const struct way k_ways[] = {
    {"planes", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA32F, 1, 1, 0, 0, 0},
    {"pixels", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FAST, WHITE, 0, SHD_FORMAT_RGBA8,
     1, 4, 0, 0, 0},
    {"srgb",
     SHD_FORMAT_RGBA8_SRGB,
     SHD_FILTER_ANISOTROPIC,
     SHD_WRAP_MIRROR,
     SHD_PRECISION_FULL,
     {0.5f, 0, 3},
     1,
     SHD_FORMAT_RGBA8_SRGB,
     1,
     1,
     0,
     0,
     0},
    {"one channel",
     SHD_FORMAT_R8,
     SHD_FILTER_NEAREST,
     SHD_WRAP_CLAMP,
     SHD_PRECISION_FULL,
     {0.25f, 1, 1},
     0,
     SHD_FORMAT_RGBA16F,
     1,
     1,
     0,
     2,
     0},
    {"words", SHD_FORMAT_RGBA16, SHD_FILTER_EWA, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 1, SHD_FORMAT_RGBA32F, 1,
     2, 0, 1, 0},
    {"samples",
     SHD_FORMAT_RGBA8,
     SHD_FILTER_BILINEAR,
     SHD_WRAP_REPEAT,
     SHD_PRECISION_FULL,
     {1, 0.5f, 1},
     0,
     SHD_FORMAT_RGBA8,
     4,
     1,
     0,
     0,
     0},
    {"samples, planes", SHD_FORMAT_RGBA8, SHD_FILTER_BICUBIC, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA32F, 16, 1, 0, 2, 0},
    {"supersampling", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA8, 1, 1, 2, 1, 0},
    {"border", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_BORDER, SHD_PRECISION_FULL, WHITE, 0, SHD_FORMAT_RGBA8,
     1, 1, 0, 0, 0},
    {"floats", SHD_FORMAT_RGBA16F, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA32F, 1, 1, 0, 0, 0},
    {"parallel", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA8, 1, 3, 0, 2, PARALLEL},
    {"floor", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0, SHD_FORMAT_RGBA8,
     1, 2, 0, 0, FLOOR},
    {"floor, clamped", SHD_FORMAT_RGBA8_SRGB, SHD_FILTER_BILINEAR_MIP, SHD_WRAP_CLAMP, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA8, 1, 1, 0, 0, FLOOR},
    {"floor, words", SHD_FORMAT_RGBA16, SHD_FILTER_BILINEAR, SHD_WRAP_MIRROR, SHD_PRECISION_FULL, WHITE, 1,
     SHD_FORMAT_RGBA8, 1, 1, 0, 2, FLOOR},
    {"floor, one channel", SHD_FORMAT_R8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA8, 1, 1, 0, 0, FLOOR},
    {"floor, red",
     SHD_FORMAT_RGBA8,
     SHD_FILTER_TRILINEAR,
     SHD_WRAP_REPEAT,
     SHD_PRECISION_FULL,
     {1, 0.5f, 1},
     0,
     SHD_FORMAT_RGBA8,
     1,
     1,
     0,
     0,
     FLOOR},
    {"floor, sRGB", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA8_SRGB, 1, 1, 0, 1, FLOOR},
    {"floor, halves", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA16F, 1, 1, 0, 2, FLOOR},
    {"floor, anisotropic",
     SHD_FORMAT_RGBA8_SRGB,
     SHD_FILTER_ANISOTROPIC,
     SHD_WRAP_MIRROR,
     SHD_PRECISION_FULL,
     {0.5f, 1, 1.5f},
     1,
     SHD_FORMAT_RGBA8,
     1,
     3,
     0,
     2,
     FLOOR},
    {"floor, samples", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA8, 4, 1, 0, 0, FLOOR},
    {"affine", SHD_FORMAT_RGBA8, SHD_FILTER_HERMITE, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0, SHD_FORMAT_RGBA8, 1,
     2, 0, 2, SCENE | AFFINE},
    {"affine, floor", SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA8, 1, 1, 0, 2, FLOOR | AFFINE},
    {"affine, floor, samples", SHD_FORMAT_RGBA8, SHD_FILTER_ANISOTROPIC, SHD_WRAP_REPEAT, SHD_PRECISION_FULL, WHITE, 0,
     SHD_FORMAT_RGBA32F, 4, 3, 0, 0, FLOOR | AFFINE},
    {"hermite", SHD_FORMAT_RGBA8, SHD_FILTER_HERMITE, SHD_WRAP_MIRROR, SHD_PRECISION_FAST, WHITE, 0, SHD_FORMAT_RGBA8,
     1, 1, 0, 0, FLOOR},
    {"parallel, samples", SHD_FORMAT_RGBA8, SHD_FILTER_ANISOTROPIC, SHD_WRAP_REPEAT, SHD_PRECISION_FAST, WHITE, 0,
     SHD_FORMAT_RGBA32F, 4, 1, 0, 0, PARALLEL},
};

static shd_texture *make_texture(shd_context *context, shd_format format)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    unsigned char texels[64 * 32 * 8];
    uint32_t seed = 3;
    size_t i;
    for (i = 0; i < sizeof texels; ++i) texels[i] = (unsigned char)(255.0f * shd_scene_random(&seed));
    for (i = 0; format == SHD_FORMAT_RGBA16F && i < sizeof texels; i += 2) texels[i + 1] &= 0x3b; /* below 1 */
    desc.format = format;
    desc.width = 64;
    desc.height = 32;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

static shd_material *make_material(shd_context *context, const struct way *way, shd_texture *texture,
                                   shd_sampler *sampler)
{
    static const float k_moved[6] = {0.75f, 0.25f, 0.125f, -0.5f, 1.5f, 2};
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    shd_slot_list slots;
    shd_slot *slot;
    slots.count = 0;
    desc.model = SHD_MODEL_UNLIT;
    memcpy(desc.diffuse, way->diffuse, sizeof desc.diffuse);
    slot = shd_slot_list_add(&slots, &desc, shd_slot_texture(SHD_SLOT_DIFFUSE, texture, sampler));
    if (way->moved) memcpy(slot->uv_transform, k_moved, sizeof k_moved);
    shd_assert_ok(shd_material_create(context, &desc, &material));
    return material;
}

static void draw(const struct way *way, const shd_scene *scene, uint32_t aovs, unsigned char *out,
                 shd_render_stats *stats)
{
    static const shd_region k_scissor = {37, 21, 100, 77};
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_render_desc frame = scene->desc;
    shd_image view = shd_image_default();
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.sample_count = way->samples;
    desc.color_format = way->color;
    desc.aovs = aovs;
    shd_assert_ok(shd_framebuffer_create(scene->context, &desc, &framebuffer));
    frame.framebuffer = framebuffer;
    frame.stats = stats;
    if (way->supersampling) frame.supersampling = way->supersampling;
    if (way->window == 1) frame.scissor = &k_scissor;
    if (way->window == 2) {
        frame.picture_width = WIDTH + 99;
        frame.picture_height = HEIGHT + 50;
        frame.crop_x = 31;
        frame.crop_y = 29;
    }
    shd_assert_ok(shd_render(scene->context, &frame));
    view.format = way->color;
    view.width = WIDTH;
    view.height = HEIGHT;
    view.pixels = out;
    shd_assert_ok(shd_framebuffer_read_color(framebuffer, &view));
    shd_framebuffer_release(framebuffer);
}

/** A surface over the whole picture that recedes, drawn by the first draw alone. */
static shd_mesh *make_floor(shd_scene *scene)
{
    static const float k_vertices[4][5] = {
        {-20, 20, 0, -20, 1}, {20, 20, 0, 20, 1}, {-1, -1, 0, -1, 21}, {1, -1, 0, 1, 21}};
    static const float k_depth[4] = {20, 20, 1, 1};
    static const uint32_t k_indices[6] = {0, 2, 1, 1, 2, 3};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    float positions[4][3];
    size_t i;
    for (i = 0; i < 4; ++i) {
        positions[i][0] = k_vertices[i][0];
        positions[i][1] = k_vertices[i][1];
        positions[i][2] = k_depth[i];
    }
    desc.vertex_count = 4;
    for (i = 0; i < 3; ++i) {
        desc.position[i].data = &positions[0][i];
        desc.position[i].stride = sizeof positions[0];
    }
    for (i = 0; i < 2; ++i) {
        desc.uv[i].data = &k_vertices[0][3 + i];
        desc.uv[i].stride = sizeof k_vertices[0];
    }
    desc.indices.data = k_indices;
    desc.index_count = 6;
    shd_assert_ok(shd_mesh_create(scene->context, &desc, &mesh));
    scene->draw[0].mesh = mesh;
    scene->draw[0].cull = SHD_CULL_NONE;
    memset(scene->draw[0].object_to_world, 0, sizeof scene->draw[0].object_to_world);
    for (i = 0; i < 4; ++i) scene->draw[0].object_to_world[5 * i] = 1;
    scene->desc.draw_count = 1;
    /* w is z, and the depth is 0. */
    memset(&scene->desc.view.world_to_view, 0, sizeof scene->desc.view.world_to_view);
    for (i = 0; i < 4; ++i) scene->desc.view.world_to_view[5 * i] = 1;
    memset(&scene->desc.view.view_to_clip, 0, sizeof scene->desc.view.view_to_clip);
    scene->desc.view.view_to_clip[0] = scene->desc.view.view_to_clip[5] = scene->desc.view.view_to_clip[11] = 1;
    return mesh;
}

static void test_way(void **state)
{
    const struct way *way = (const struct way *)*state;
    int simd;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        shd_sampler_desc sampler_desc = shd_sampler_desc_default();
        shd_context *context = NULL;
        shd_sampler *sampler = NULL;
        shd_texture *texture;
        shd_material *material;
        shd_mesh *floor = NULL;
        shd_scene scene;
        shd_render_stats own = shd_render_stats_default(), general = shd_render_stats_default();
        size_t i;
        if (!shd_simd_can_run(simd)) continue;
        desc.simd = (shd_simd)simd;
        desc.worker_count = way->workers;
        shd_assert_ok(shd_context_create(&desc, &context));
        shd_scene_open(&scene, SHD_SCENE_MIXED, context);
        if ((way->view & 3) == PARALLEL) shd_scene_look_parallel(&scene);
        if ((way->view & 3) == FLOOR) floor = make_floor(&scene);
        sampler_desc.filter = way->filter;
        sampler_desc.wrap_u = sampler_desc.wrap_v = way->wrap;
        sampler_desc.precision = way->precision;
        shd_assert_ok(shd_sampler_create(context, &sampler_desc, &sampler));
        texture = make_texture(context, way->texture);
        material = make_material(context, way, texture, sampler);
        for (i = 0; i < scene.desc.draw_count; ++i) {
            scene.draw[i].material = material;
            scene.draw[i].flags = way->view & AFFINE ? SHD_DRAW_AFFINE : SHD_DRAW_NONE;
        }
        draw(way, &scene, 0, g_got, &own);
        draw(way, &scene, SHD_AOV_OVERDRAW, g_want, &general);
        if (memcmp(g_got, g_want, PIXELS * shd_format_size(way->color))) {
            fail_msg("%s: the paths differ on target %d", way->name, simd);
        }
        assert_int_equal(own.fragment_count, general.fragment_count);
        assert_int_equal(own.nonfinite_fragment_count, general.nonfinite_fragment_count);
        assert_true(own.fragment_count > (way->window == 1 ? 5000u : 10000u));
        if ((way->view & 3) == FLOOR && way->window != 1) assert_true(own.fragment_count >= PIXELS);
        if (way->view & AFFINE) {
            for (i = 0; i < scene.desc.draw_count; ++i) scene.draw[i].flags = SHD_DRAW_NONE;
            draw(way, &scene, 0, g_want, &general);
            assert_int_equal(own.fragment_count, general.fragment_count);
            assert_memory_not_equal(g_got, g_want, PIXELS * shd_format_size(way->color));
        }
        shd_material_release(material);
        shd_mesh_release(floor);
        shd_texture_release(texture);
        shd_sampler_release(sampler);
        shd_scene_close(&scene);
        shd_context_release(context);
    }
}

int main(void)
{
    struct CMUnitTest tests[sizeof k_ways / sizeof k_ways[0]];
    size_t i;
    memset(tests, 0, sizeof tests);
    for (i = 0; i < sizeof k_ways / sizeof k_ways[0]; ++i) {
        tests[i].name = k_ways[i].name;
        tests[i].test_func = test_way;
        tests[i].initial_state = (void *)&k_ways[i];
    }
    return _cmocka_run_group_tests("api.render_one_texture", tests, sizeof tests / sizeof tests[0], NULL, NULL);
}
