/* SPDX-License-Identifier: MIT */
/* Volumes through the API: refused descs; frames with hidden and overlapping volumes, samples, windows, passes and
 * depth orders; densities that are not finite. */
#include "support/volume_scene.h"

enum { k_pixels = k_ball_width * k_ball_height };
typedef float planes_t[5][k_pixels];
static planes_t g_planes, g_other;

/* ---- descs ---- */

static shd_ball_scene g_scene;
static int setup(void **state)
{
    (void)state;
    shd_ball_open(&g_scene, NULL, 1);
    return 0;
}
static int teardown(void **state)
{
    (void)state;
    shd_ball_close(&g_scene);
    return 0;
}

struct desc_case {
    const char *name;
    void (*edit)(shd_volume_desc *desc);
    shd_result expected;
    const char *message;
};
static float g_density[3], g_extinction[3], g_red[3];
static shd_texture *g_flat;
static shd_material *g_other_material;

static void make_material(void (*edit)(shd_material_desc *), shd_volume_desc *desc)
{
    shd_material_desc material = shd_material_desc_default();
    edit(&material);
    shd_assert_ok(shd_material_create(g_scene.context, &material, &g_other_material));
    desc->material = g_other_material;
}
static void material_unlit(shd_material_desc *d) { d->model = SHD_MODEL_UNLIT; }
static void material_blended(shd_material_desc *d) { d->blend = SHD_BLEND_ADD; }

static void edit_nothing(shd_volume_desc *d) { (void)d; }
static void edit_one_point(shd_volume_desc *d) { d->point_count = 1; }
static void edit_jump(shd_volume_desc *d) { (void)d, g_density[1] = g_density[2]; }
static void edit_step_tiny(shd_volume_desc *d) { d->step = 1e-30f; }
static void edit_step_denormal(shd_volume_desc *d) { d->step = 1e-45f; }
static void edit_no_points(shd_volume_desc *d) { d->point_count = 0; }
static void edit_many_points(shd_volume_desc *d) { d->point_count = 257; }
static void edit_no_density(shd_volume_desc *d) { d->density.data = NULL; }
static void edit_no_extinction(shd_volume_desc *d) { d->extinction.data = NULL; }
static void edit_order(shd_volume_desc *d) { (void)d, g_density[2] = 0.125f; }
static void edit_density_nan(shd_volume_desc *d) { (void)d, g_density[1] = NAN; }
static void edit_density_infinite(shd_volume_desc *d) { (void)d, g_density[2] = INFINITY; }
static void edit_extinction_negative(shd_volume_desc *d) { (void)d, g_extinction[1] = -1; }
static void edit_extinction_nan(shd_volume_desc *d) { (void)d, g_extinction[0] = NAN; }
static void edit_color_negative(shd_volume_desc *d) { (void)d, g_red[2] = -0.5f; }
static void edit_stride(shd_volume_desc *d) { d->density.stride = 3; }
static void edit_no_texture(shd_volume_desc *d) { d->texture = NULL; }
static void edit_flat_texture(shd_volume_desc *d) { d->texture = g_flat; }
static void edit_box_inverted(shd_volume_desc *d) { d->bounds_min[1] = 2; }
static void edit_box_empty(shd_volume_desc *d) { d->bounds_max[2] = d->bounds_min[2]; }
static void edit_box_nan(shd_volume_desc *d) { d->bounds_max[0] = NAN; }
static void edit_step_zero(shd_volume_desc *d) { d->step = 0; }
static void edit_step_negative(shd_volume_desc *d) { d->step = -0.5f; }
static void edit_step_nan(shd_volume_desc *d) { d->step = NAN; }
static void edit_jitter(shd_volume_desc *d) { d->jitter = 1.5f; }
static void edit_unlit(shd_volume_desc *d) { make_material(material_unlit, d); }
static void edit_blended(shd_volume_desc *d) { make_material(material_blended, d); }

static const struct desc_case k_descs[] = {
    {"create/plain", edit_nothing, SHD_OK, ""},
    {"create/one_point", edit_one_point, SHD_OK, ""},
    {"create/jump", edit_jump, SHD_OK, ""},
    {"create/step_1e-30", edit_step_tiny, SHD_OK, ""},
    {"create/step_denormal", edit_step_denormal, SHD_OK, ""},
    {"create/no_points", edit_no_points, SHD_ERROR_INVALID_ARGUMENT, "volume.point_count: 0 is not in 1..256"},
    {"create/257_points", edit_many_points, SHD_ERROR_INVALID_ARGUMENT, "volume.point_count: 257"},
    {"create/no_density", edit_no_density, SHD_ERROR_INVALID_ARGUMENT, "volume.density.data: NULL"},
    {"create/no_extinction", edit_no_extinction, SHD_ERROR_INVALID_ARGUMENT, "volume.extinction.data: NULL"},
    {"create/out_of_order", edit_order, SHD_ERROR_INVALID_ARGUMENT,
     "volume.density[2]: 0.125 is below volume.density[1], 0.5"},
    {"create/density_nan", edit_density_nan, SHD_ERROR_INVALID_ARGUMENT, "volume.density[1]: nan"},
    {"create/density_infinite", edit_density_infinite, SHD_ERROR_INVALID_ARGUMENT, "volume.density[2]: inf"},
    {"create/extinction_negative", edit_extinction_negative, SHD_ERROR_INVALID_ARGUMENT,
     "volume.extinction[1]: -1 is not in 0..1e+12"},
    {"create/extinction_nan", edit_extinction_nan, SHD_ERROR_INVALID_ARGUMENT, "volume.extinction[0]: nan"},
    {"create/color_negative", edit_color_negative, SHD_ERROR_INVALID_ARGUMENT, "volume.color[0][2]: -0.5"},
    {"create/stride_odd", edit_stride, SHD_ERROR_INVALID_ARGUMENT, "volume.density.stride: 3"},
    {"create/no_texture", edit_no_texture, SHD_ERROR_INVALID_ARGUMENT, "volume.texture: NULL"},
    {"create/flat_texture", edit_flat_texture, SHD_ERROR_INVALID_ARGUMENT, "volume.texture: its depth is 0"},
    {"create/box_inverted", edit_box_inverted, SHD_ERROR_INVALID_ARGUMENT,
     "volume.bounds_max[1]: 1 is not above volume.bounds_min[1], 2"},
    {"create/box_empty", edit_box_empty, SHD_ERROR_INVALID_ARGUMENT, "volume.bounds_max[2]: 0 is not above"},
    {"create/box_nan", edit_box_nan, SHD_ERROR_INVALID_ARGUMENT, "volume.bounds_max[0]: nan is not finite"},
    {"create/step_0", edit_step_zero, SHD_ERROR_INVALID_ARGUMENT, "volume.step: 0 is not above 0"},
    {"create/step_negative", edit_step_negative, SHD_ERROR_INVALID_ARGUMENT, "volume.step: -0.5"},
    {"create/step_nan", edit_step_nan, SHD_ERROR_INVALID_ARGUMENT, "volume.step: nan"},
    {"create/jitter_1.5", edit_jitter, SHD_ERROR_INVALID_ARGUMENT, "volume.jitter: 1.5 is not in 0..1"},
    {"create/unlit", edit_unlit, SHD_ERROR_UNSUPPORTED, "volume.material: its model or debug view reflects no light"},
    {"create/blended", edit_blended, SHD_ERROR_UNSUPPORTED, "volume.material: its blend is"},
};

static shd_volume_desc volume_desc(shd_texture *texture)
{
    shd_volume_desc desc = shd_volume_desc_default();
    int i;
    for (i = 0; i < 3; ++i) {
        g_density[i] = 0.25f * (float)(i + 1);
        g_extinction[i] = (float)i;
        g_red[i] = 1.0f;
    }
    desc.texture = texture;
    desc.point_count = 3;
    desc.density.data = g_density;
    desc.extinction.data = g_extinction;
    desc.color[0].data = g_red;
    return desc;
}

static void test_create(void **state)
{
    const struct desc_case *c = (const struct desc_case *)*state;
    static const unsigned char k_texel[4] = {0};
    shd_texture_desc flat = shd_texture_desc_default();
    shd_volume_desc desc = volume_desc(g_scene.texture);
    shd_volume *volume = (shd_volume *)&desc;
    flat.format = SHD_FORMAT_R8;
    flat.width = flat.height = 1;
    flat.texels = k_texel;
    shd_assert_ok(shd_texture_create(g_scene.context, &flat, &g_flat));
    c->edit(&desc);
    shd_assert_result(c->name, shd_volume_create(g_scene.context, &desc, &volume), c->expected, c->message);
    if (c->expected != SHD_OK) assert_null(volume);
    shd_volume_release(volume);
    shd_material_release(g_other_material);
    shd_texture_release(g_flat);
    g_other_material = NULL;
}

static void test_render_errors(void **state)
{
    static shd_volume_draw placed[2];
    shd_render_desc desc = g_scene.desc;
    int i;
    (void)state;
    placed[0] = placed[1] = g_scene.placed[0];
    desc.volumes = placed;
    desc.volume_count = 2;
    placed[1].volume = NULL;
    shd_assert_result("NULL", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.volumes[1]: volume.volume: NULL");
    placed[1].volume = (const shd_volume *)g_scene.texture;
    shd_assert_result("texture", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.volumes[1]: volume.volume: not a live handle of its type");
    placed[1] = placed[0];
    placed[1].object_to_world[5] = 0;
    shd_assert_result("singular", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.volumes[1]: volume.object_to_world: it cannot be inverted");
    for (i = 0; i < 9; ++i) placed[1].object_to_world[i / 3 * 4 + i % 3] = (float)(i / 3 + i % 3 * 3 + 1); /* rank 2 */
    shd_assert_result("rank_2", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.volumes[1]: volume.object_to_world: it cannot be inverted");
    placed[1].object_to_world[5] = NAN;
    shd_assert_result("nan", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "volume.object_to_world[5]: nan is not finite");
    placed[1] = placed[0];
    placed[1].struct_size = 16;
    shd_assert_result("size", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.volumes[1].struct_size: 16 differs");
    desc.volumes = NULL;
    shd_assert_result("no array", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.volumes: NULL");
    desc.volume_count = 1025;
    shd_assert_result("too many", shd_render(g_scene.context, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.volume_count: 1025 is not in 0..1024");
}

/* ---- frames ---- */

static float *at(planes_t planes, size_t c, size_t x, size_t y) { return &planes[c][y * k_ball_width + x]; }

/* A volume lies before the background and inside the cube; depth does not change. */
static void test_scene(void **state)
{
    shd_ball_scene scene;
    size_t i, changed = 0, kept = 0;
    (void)state;
    shd_ball_open(&scene, NULL, 1);
    (void)shd_ball_render(&scene, g_planes);
    scene.desc.volume_count = 0;
    (void)shd_ball_render(&scene, g_other);
    assert_memory_equal(g_planes[4], g_other[4], sizeof g_other[4]);
    for (i = 0; i < k_pixels; ++i) {
        const int is_changed = g_planes[0][i] != g_other[0][i] || g_planes[3][i] != g_other[3][i];
        changed += (size_t)is_changed;
        kept += (size_t)!is_changed;
        assert_true(g_planes[3][i] >= 0 && g_planes[3][i] <= 1);
        assert_true(g_planes[0][i] >= 0 && isfinite(g_planes[0][i]));
    }
    assert_true(changed > k_pixels / 8 && kept > k_pixels / 8);
    assert_true(*at(g_planes, 3, k_ball_width / 2, k_ball_height / 2) == 1);
    shd_ball_close(&scene);
}

/* A box of one density has the opacity of its depth, for any step; an opaque quad behind it adds nothing, one inside
   cuts it. */
static void test_homogeneous(void **state)
{
    static const float k_steps[] = {1e-30f, 0.003f, 0.1f, 5.0f};
    static const unsigned char k_texels[8] = {255, 255, 255, 255, 255, 255, 255, 255};
    const float density = 0.5f, sigma = 1.5f;
    shd_ball_scene scene;
    shd_texture_desc texture = shd_texture_desc_default();
    shd_texture *solid = NULL;
    size_t k;
    (void)state;
    shd_ball_open(&scene, NULL, 1);
    texture.format = SHD_FORMAT_R8;
    texture.kind = SHD_TEXTURE_KIND_3D;
    texture.width = texture.height = texture.depth = 2;
    texture.texels = k_texels;
    shd_assert_ok(shd_texture_create(scene.context, &texture, &solid));
    for (k = 0; k < sizeof k_steps / sizeof k_steps[0]; ++k) {
        shd_volume_desc desc = shd_volume_desc_default();
        shd_volume *volume = NULL;
        shd_volume_draw placed = shd_volume_draw_default();
        int with_cube;
        desc.texture = solid;
        desc.point_count = 1;
        desc.density.data = &density;
        desc.extinction.data = &sigma;
        desc.step = k_steps[k];
        desc.bounds_min[0] = desc.bounds_min[1] = desc.bounds_min[2] = -1;
        shd_assert_ok(shd_volume_create(scene.context, &desc, &volume));
        placed.volume = volume;
        scene.camera.eye[0] = scene.camera.eye[1] = 0;
        scene.desc.volumes = &placed;
        scene.desc.volume_count = 1;
        scene.desc.clear_color[2] = 0;
        scene.desc.light_count = 0;
        for (with_cube = 0; with_cube < 2; ++with_cube) {
            const double length = with_cube ? 1 - 0.35 : 2; /* the cube has an edge of 0.7 */
            scene.desc.draw_count = (size_t)with_cube;
            (void)shd_ball_render(&scene, g_planes);
            shd_assert_close("red", k, (double)*at(g_planes, 0, k_ball_width / 2, k_ball_height / 2),
                             -expm1(-1.5 * length), 2e-4, 0);
            shd_assert_close("opacity", k, (double)*at(g_planes, 3, k_ball_width / 2, k_ball_height / 2),
                             with_cube ? 1 : -expm1(-1.5 * length), 2e-4, 0);
        }
        shd_volume_release(volume);
    }
    shd_texture_release(solid);
    shd_ball_close(&scene);
}

/* A window of the picture has the bits of the picture; so have passes, and depths that fall with the distance. */
static void test_window_and_passes(void **state)
{
    shd_ball_scene scene;
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *window = NULL;
    shd_draw draws[200];
    static float part[30 * 20];
    const shd_f32_out column = {part, 0};
    size_t i, y;
    (void)state;
    shd_ball_open(&scene, NULL, 1);
    (void)shd_ball_render(&scene, g_planes);
    desc.width = 30;
    desc.height = 20;
    shd_assert_ok(shd_framebuffer_create(scene.context, &desc, &window));
    scene.desc.framebuffer = window;
    scene.desc.picture_width = k_ball_width;
    scene.desc.picture_height = k_ball_height;
    scene.desc.crop_x = 31;
    scene.desc.crop_y = 27;
    shd_assert_ok(shd_render(scene.context, &scene.desc));
    shd_assert_ok(shd_framebuffer_read_plane(window, SHD_PLANE_R, &column));
    for (y = 0; y < 20; ++y) {
        assert_memory_equal(part + 30 * y, at(g_planes, 0, 31, 27 + y), 30 * sizeof(float));
    }
    shd_framebuffer_release(window);
    scene.desc.framebuffer = scene.framebuffer;
    scene.desc.crop_x = scene.desc.crop_y = 0;
    for (i = 0; i < 200; ++i) draws[i] = scene.draw;
    scene.desc.draws = draws;
    scene.desc.draw_count = 200;
    scene.desc.pass_triangles = 1024;
    (void)shd_ball_render(&scene, g_other);
    assert_memory_equal(g_planes, g_other, sizeof g_planes);
    shd_ball_close(&scene);
}

/* Reversed depths give the picture of forward ones, up to the rounding of depths. */
static void test_depth_orders(void **state)
{
    shd_ball_scene scene;
    size_t i;
    (void)state;
    shd_ball_open(&scene, NULL, 1);
    shd_assert_ok(shd_view_from_camera(&scene.camera, &scene.desc.view));
    scene.desc.camera = NULL;
    shd_assert_ok(shd_matrix_perspective(0.8f, (float)k_ball_width / k_ball_height, 0.1f, 100.0f,
                                         SHD_DEPTH_ORDER_FORWARD, scene.desc.view.view_to_clip));
    (void)shd_ball_render(&scene, g_planes);
    shd_assert_ok(shd_matrix_perspective(0.8f, (float)k_ball_width / k_ball_height, 0.1f, INFINITY,
                                         SHD_DEPTH_ORDER_REVERSED, scene.desc.view.view_to_clip));
    scene.desc.clear_depth = 0;
    scene.draw.compare = SHD_COMPARE_GREATER;
    (void)shd_ball_render(&scene, g_other);
    for (i = 0; i < k_pixels; ++i) {
        const double slack = g_planes[3][i] == 1 ? 0.02 : 2e-3;
        shd_assert_close("red", i, (double)g_other[0][i], (double)g_planes[0][i], slack, 0);
    }
    shd_ball_close(&scene);
}

/* Where all samples of a pixel have one depth, several samples give the bits of one. */
static void test_samples(void **state)
{
    shd_ball_scene one, four;
    size_t x, y, same = 0;
    (void)state;
    shd_ball_open(&one, NULL, 1);
    shd_ball_open(&four, NULL, 4);
    one.desc.draw_count = four.desc.draw_count = 0;
    (void)shd_ball_render(&one, g_planes);
    (void)shd_ball_render(&four, g_other);
    assert_memory_equal(g_planes, g_other, sizeof g_planes);
    one.desc.draw_count = four.desc.draw_count = 1;
    (void)shd_ball_render(&one, g_planes);
    (void)shd_ball_render(&four, g_other);
    for (y = 0; y < k_ball_height; ++y) {
        for (x = 0; x < k_ball_width; ++x) {
            assert_true(isfinite(*at(g_other, 0, x, y)) && *at(g_other, 3, x, y) <= 1);
            same += *at(g_planes, 0, x, y) == *at(g_other, 0, x, y);
        }
    }
    assert_true(same > k_pixels / 2);
    shd_ball_close(&one);
    shd_ball_close(&four);
}

/* The jitter moves points of steps, by the seed, and not the mean. */
static void test_jitter(void **state)
{
    shd_volume_desc desc = volume_desc(g_scene.texture);
    shd_volume_draw placed = shd_volume_draw_default();
    shd_render_desc render = g_scene.desc;
    double mean[3] = {0, 0, 0};
    uint64_t hash[3];
    size_t i;
    int k;
    (void)state;
    render.volumes = &placed;
    render.volume_count = 1;
    render.draw_count = 0;
    desc.step = 0.2f;
    for (k = 0; k < 3; ++k) {
        shd_volume *volume = NULL;
        const shd_f32_out column = {g_planes[3], 0};
        desc.jitter = k ? 1.0f : 0.0f;
        desc.seed = (uint32_t)k;
        shd_assert_ok(shd_volume_create(g_scene.context, &desc, &volume));
        placed.volume = volume;
        shd_assert_ok(shd_render(g_scene.context, &render));
        shd_assert_ok(shd_framebuffer_read_plane(g_scene.framebuffer, SHD_PLANE_A, &column));
        hash[k] = shd_hash(SHD_HASH_START, g_planes[3], sizeof g_planes[3]);
        for (i = 0; i < k_pixels; ++i) mean[k] += (double)g_planes[3][i] / k_pixels;
        shd_volume_release(volume);
    }
    assert_true(hash[0] != hash[1] && hash[1] != hash[2]);
    shd_assert_close("mean", 1, mean[1], mean[0], 0, 0.02);
    shd_assert_close("mean", 2, mean[2], mean[0], 0, 0.02);
}

/* Densities that are NaN, infinite and negative give colours in range. */
static void test_bad_densities(void **state)
{
    static float texels[9 * 9 * 9];
    static const float k_bad[] = {NAN, INFINITY, -INFINITY, -1.0f, 3.4e38f, -3.4e38f, 1e-45f, 0.5f};
    shd_texture_desc texture = shd_texture_desc_default();
    shd_volume_draw placed = shd_volume_draw_default();
    shd_render_desc render = g_scene.desc;
    shd_texture *solid = NULL;
    uint32_t seed = 4;
    size_t i, c;
    int shaded;
    (void)state;
    for (i = 0; i < 9 * 9 * 9; ++i) texels[i] = k_bad[shd_solid_bits(&seed) % 8];
    texture.format = SHD_FORMAT_R32F;
    texture.kind = SHD_TEXTURE_KIND_3D;
    texture.width = texture.height = texture.depth = 9;
    texture.texels = texels;
    shd_assert_ok(shd_texture_create(g_scene.context, &texture, &solid));
    for (shaded = 0; shaded < 2; ++shaded) {
        shd_volume_desc desc = volume_desc(solid);
        shd_volume *volume = NULL;
        desc.material = shaded ? g_scene.material : NULL;
        shd_assert_ok(shd_volume_create(g_scene.context, &desc, &volume));
        placed.volume = volume;
        render.volumes = &placed;
        render.volume_count = 1;
        shd_assert_ok(shd_render(g_scene.context, &render));
        for (c = 0; c < 4; ++c) {
            const shd_f32_out column = {g_planes[c], 0};
            shd_assert_ok(shd_framebuffer_read_plane(g_scene.framebuffer, (shd_plane)c, &column));
            for (i = 0; i < k_pixels; ++i) {
                assert_true(g_planes[c][i] >= 0 && g_planes[c][i] < 100);
                assert_true(c < 3 || g_planes[c][i] <= 1);
            }
        }
        shd_volume_release(volume);
    }
    shd_texture_release(solid);
}

/* Views that show nothing leave the frame as it is. */
static void test_degenerate_views(void **state)
{
    shd_ball_scene scene;
    int k;
    (void)state;
    shd_ball_open(&scene, NULL, 1);
    scene.desc.camera = NULL;
    for (k = 0; k < 4; ++k) {
        size_t i;
        memset(&scene.desc.view, 0, sizeof scene.desc.view);
        for (i = 0; i < 16; ++i) {
            scene.desc.view.world_to_view[i] = k == 0   ? 0
                                               : k == 1 ? 3e38f
                                               : k == 2 ? (i % 5 == 0 ? 1e-40f : 0)
                                                        : (float)i; /* rank 2 */
            scene.desc.view.view_to_clip[i] = i % 5 == 0 ? (k == 2 ? 1e-40f : 1) : 0;
        }
        scene.desc.draw_count = 0;
        (void)shd_ball_render(&scene, g_planes);
        for (i = 0; i < k_pixels; ++i) assert_true(isfinite(g_planes[0][i]) && g_planes[3][i] <= 1);
        for (i = 0; i < k_pixels; ++i) assert_true(k != 3 || g_planes[3][i] == g_planes[3][0]);
    }
    shd_ball_close(&scene);
}

int main(void)
{
    struct CMUnitTest tests[64];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_descs / sizeof k_descs[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_descs[i].name, test_create, NULL, NULL, (void *)&k_descs[i]};
    }
    tests[n++] = (struct CMUnitTest){"render_errors", test_render_errors, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"scene", test_scene, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"homogeneous", test_homogeneous, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"window_and_passes", test_window_and_passes, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"depth_orders", test_depth_orders, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"samples", test_samples, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"jitter", test_jitter, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bad_densities", test_bad_densities, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"degenerate_views", test_degenerate_views, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.volume", tests, n, setup, teardown);
}
