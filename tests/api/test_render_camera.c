/* SPDX-License-Identifier: MIT */
/* shd_render_desc.camera: the frame has the bits of a view with the aspect of the picture, for any window of it. */
#include "support/scene.h"

enum { WIDTH = 64, HEIGHT = 36, PIXELS = WIDTH * HEIGHT };

static shd_scene g_scene;
static shd_context *g_context;

static int set_up(void **state)
{
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &g_context));
    shd_scene_open(&g_scene, SHD_SCENE_MIXED, g_context);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    shd_scene_close(&g_scene);
    shd_context_release(g_context);
    return 0;
}

static shd_camera oblique(float aspect)
{
    shd_camera camera = shd_camera_default();
    camera.eye[0] = 1.5f;
    camera.eye[1] = 0.5f;
    camera.aspect = aspect;
    return camera;
}

/* Renders colour and depth into a framebuffer of the given size. */
static void draw(const shd_render_desc *desc, uint32_t width, uint32_t height, float *out)
{
    shd_framebuffer_desc made = shd_framebuffer_desc_default();
    shd_render_desc read = *desc;
    shd_framebuffer *framebuffer = NULL;
    int plane;
    made.width = width;
    made.height = height;
    shd_assert_ok(shd_framebuffer_create(g_context, &made, &framebuffer));
    read.framebuffer = framebuffer;
    shd_assert_ok(shd_render(g_context, &read));
    for (plane = 0; plane < 5; ++plane) {
        const shd_f32_out column = {out + (size_t)plane * width * height, 0};
        shd_assert_ok(shd_framebuffer_read_plane(framebuffer, (shd_plane)plane, &column));
    }
    shd_framebuffer_release(framebuffer);
}

struct aspect_case {
    const char *name;
    float aspect;                     /* aspect of the camera */
    uint32_t picture[2], viewport[4]; /* 0 = absent */
    float wanted;                     /* aspect of a view with the same bits */
};

static const struct aspect_case k_aspects[] = {
    {"aspect/framebuffer", 0, {0, 0}, {0, 0, 0, 0}, (float)WIDTH / HEIGHT},
    {"aspect/picture", 0, {200, 40}, {0, 0, 0, 0}, 5},
    {"aspect/viewport", 0, {0, 0}, {8, 4, 20, 30}, 20.0f / 30.0f},
    {"aspect/given", 1.25f, {0, 0}, {0, 0, 0, 0}, 1.25f},
};

static void test_aspect(void **state)
{
    const struct aspect_case *c = (const struct aspect_case *)*state;
    static float got[5 * PIXELS], want[5 * PIXELS];
    const shd_region viewport = {c->viewport[0], c->viewport[1], c->viewport[2], c->viewport[3]};
    const shd_camera camera = oblique(c->aspect), explicit_camera = oblique(c->wanted);
    shd_render_desc desc = g_scene.desc;
    size_t i, covered = 0;
    desc.picture_width = c->picture[0];
    desc.picture_height = c->picture[1];
    if (viewport.width) desc.viewport = &viewport;
    shd_assert_ok(shd_view_from_camera(&explicit_camera, &desc.view));
    draw(&desc, WIDTH, HEIGHT, want);
    desc.view.world_to_view[3] = (float)NAN; /* ignored, because there is a camera */
    desc.camera = &camera;
    draw(&desc, WIDTH, HEIGHT, got);
    assert_memory_equal(got, want, sizeof got);
    for (i = 0; i < PIXELS; ++i) covered += got[4 * PIXELS + i] < 1;
    assert_true(covered > 50);
}

static void test_refused(void **state)
{
    shd_render_desc desc = g_scene.desc;
    shd_camera camera = oblique(0);
    (void)state;
    desc.camera = &camera;
    camera.near_plane = 0;
    shd_assert_result("near", shd_render(g_context, &desc), SHD_ERROR_INVALID_ARGUMENT, "camera.near_plane: 0");
    camera = oblique(-1);
    shd_assert_result("aspect", shd_render(g_context, &desc), SHD_ERROR_INVALID_ARGUMENT, "camera.aspect: -1");
    camera = oblique(0);
    camera.struct_size = 4;
    shd_assert_result("size", shd_render(g_context, &desc), SHD_ERROR_INVALID_ARGUMENT, "camera.struct_size: 4");
}

int main(void)
{
    struct CMUnitTest tests[8];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_aspects / sizeof k_aspects[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_aspects[i].name, test_aspect, NULL, NULL, (void *)&k_aspects[i]};
    }
    tests[n++] = (struct CMUnitTest){"refused", test_refused, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_camera", tests, n, set_up, tear_down);
}
