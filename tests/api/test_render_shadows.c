/* SPDX-License-Identifier: MIT */
/* Frames with shadows: the light of each source at a fragment is multiplied by the result of shd_shadow_sample()
 * there; refusals. */
#include "support/shadow_scene.h"

#define BAD SHD_ERROR_INVALID_ARGUMENT
enum { k_width = 96, k_height = 72, k_pixels = k_width * k_height };

static struct {
    shd_context *context;
    shd_light *sun, *lamp, *cookie, *ambient;
    shd_shadow *of_sun, *of_lamp, *of_cookie, *empty;
    shd_material *material;
    shd_framebuffer *framebuffer;
    struct shd_boxes boxes;
} g;

static shd_light *make_light(shd_light_kind kind, shd_texture *texture)
{
    shd_light_desc desc = shd_light_desc_default();
    shd_light *light = NULL;
    desc.kind = kind;
    desc.position[0] = 1.5f;
    desc.position[1] = 3.0f;
    desc.position[2] = 0.8f;
    desc.direction[0] = -0.5f;
    desc.direction[2] = -0.3f;
    desc.texture = texture;
    if (kind == SHD_LIGHT_KIND_POINT) desc.intensity[0] = desc.intensity[1] = desc.intensity[2] = 6.0f;
    shd_assert_ok(shd_light_create(g.context, &desc, &light));
    return light;
}

static int set_up(void **state)
{
    static const float k_low[3][3] = {{-2, -0.2f, -2}, {-0.5f, 0, -0.4f}, {0.5f, 0.9f, 0.2f}};
    static const float k_high[3][3] = {{2, 0, 2}, {0.1f, 0.8f, 0.3f}, {0.9f, 1, 0.8f}};
    static const unsigned char k_texels[4 * 2 * 2] = {255, 255, 255, 255, 255, 90,  20, 255,
                                                      40,  200, 255, 255, 128, 128, 90, 255};
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_material_desc material_desc = shd_material_desc_default();
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_shadow_desc shadow_desc = shd_shadow_desc_default();
    shd_texture *texture = NULL;
    int i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &g.context));
    texture_desc.format = SHD_FORMAT_RGBA8;
    texture_desc.width = texture_desc.height = 2;
    texture_desc.texels = k_texels;
    shd_assert_ok(shd_texture_create(g.context, &texture_desc, &texture));
    g.sun = make_light(SHD_LIGHT_KIND_DIRECTIONAL, NULL);
    g.lamp = make_light(SHD_LIGHT_KIND_POINT, NULL);
    g.cookie = make_light(SHD_LIGHT_KIND_SPOT, texture);
    g.ambient = make_light(SHD_LIGHT_KIND_AMBIENT, NULL);
    shd_texture_release(texture);
    shd_boxes_open(&g.boxes, g.context);
    for (i = 0; i < 3; ++i) shd_boxes_add(&g.boxes, k_low[i], k_high[i]);
    shadow_desc.size = 256;
    shadow_desc.filter = SHD_SHADOW_FILTER_PCF;
    g.of_sun = shd_boxes_shadow(&g.boxes, g.context, &shadow_desc, g.sun);
    g.of_lamp = shd_boxes_shadow(&g.boxes, g.context, &shadow_desc, g.lamp);
    g.of_cookie = shd_boxes_shadow(&g.boxes, g.context, &shadow_desc, g.cookie);
    shd_assert_ok(shd_shadow_create(g.context, NULL, &g.empty));
    material_desc.model = SHD_MODEL_BLINN_PHONG;
    memset(material_desc.ambient, 0, sizeof material_desc.ambient);
    shd_assert_ok(shd_material_create(g.context, &material_desc, &g.material));
    for (i = 0; i < 3; ++i) g.boxes.draws[i].material = g.material;
    desc.width = k_width;
    desc.height = k_height;
    desc.aovs = SHD_AOV_POSITION | SHD_AOV_NORMAL | SHD_AOV_DRAW;
    shd_assert_ok(shd_framebuffer_create(g.context, &desc, &g.framebuffer));
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    shd_shadow_release(g.of_sun);
    shd_shadow_release(g.of_lamp);
    shd_shadow_release(g.of_cookie);
    shd_shadow_release(g.empty);
    shd_light_release(g.sun);
    shd_light_release(g.lamp);
    shd_light_release(g.cookie);
    shd_light_release(g.ambient);
    shd_material_release(g.material);
    shd_framebuffer_release(g.framebuffer);
    shd_boxes_close(&g.boxes);
    shd_context_release(g.context);
    return 0;
}

static shd_result render(const shd_light *const *lights, const shd_shadow *const *shadows, size_t count)
{
    shd_camera camera = shd_camera_default();
    shd_render_desc desc = shd_render_desc_default();
    camera.eye[1] = 3;
    camera.eye[2] = 3.2f;
    camera.aspect = (float)k_width / k_height;
    shd_assert_ok(shd_view_from_camera(&camera, &desc.view));
    desc.framebuffer = g.framebuffer;
    desc.draws = g.boxes.draws;
    desc.draw_count = g.boxes.count;
    desc.lights = lights;
    desc.light_count = count;
    desc.shadows = shadows;
    return shd_render(g.context, &desc);
}

static void read_planes(shd_plane first, float out[3][k_pixels])
{
    int k;
    for (k = 0; k < 3; ++k) {
        const shd_f32_out column = {out[k], 0};
        shd_assert_ok(shd_framebuffer_read_plane(g.framebuffer, (shd_plane)((int)first + k), &column));
    }
}

/* The frame with all lights equals the sum, over the lights, of frames without shadows times visibility. */
static void expect_product(const char *name, const shd_light *const *lights, const shd_shadow *const *shadows,
                           size_t count)
{
    static float sum[3][k_pixels], part[3][k_pixels], position[3][k_pixels], normal[3][k_pixels], visible[k_pixels];
    size_t l, i, k, partial = 0, dark = 0;
    memset(sum, 0, sizeof sum);
    for (l = 0; l < count; ++l) {
        shd_assert_ok(render(&lights[l], NULL, 1));
        read_planes(SHD_PLANE_R, part);
        read_planes(SHD_PLANE_PX, position);
        read_planes(SHD_PLANE_NX, normal);
        for (i = 0; i < k_pixels; ++i) visible[i] = 1;
        if (shadows[l]) {
            shd_shadow_lookups lookups = shd_shadow_lookups_default();
            shd_shadow_values out = {sizeof out, {visible, 0}, 0};
            lookups.count = k_pixels;
            for (k = 0; k < 3; ++k) {
                lookups.position[k].data = position[k];
                lookups.normal[k].data = normal[k];
            }
            shd_assert_ok(shd_shadow_sample(shadows[l], &lookups, &out));
        }
        for (i = 0; i < k_pixels; ++i) {
            for (k = 0; k < 3; ++k) sum[k][i] += part[k][i] * visible[i];
            partial += visible[i] > 0 && visible[i] < 1;
            dark += visible[i] == 0;
        }
    }
    shd_assert_ok(render(lights, shadows, count));
    read_planes(SHD_PLANE_R, part);
    for (k = 0; k < 3; ++k) {
        for (i = 0; i < k_pixels; ++i) shd_assert_close(name, i, part[k][i], sum[k][i], 1e-6, 1e-5);
    }
    if (partial < 50 || dark < 100) fail_msg("%s: %zu pixels in penumbra, %zu in shadow", name, partial, dark);
}

static void test_product(void **state)
{
    const shd_light *one[] = {g.sun}, *spot[] = {g.cookie}, *three[] = {g.lamp, g.cookie, g.sun};
    const shd_shadow *of_one[] = {g.of_sun}, *of_spot[] = {g.of_cookie}, *of_three[] = {g.of_lamp, NULL, g.of_sun};
    const shd_light *many[] = {g.sun, g.lamp, g.cookie, g.sun, g.lamp, g.cookie, g.sun};
    const shd_shadow *of_many[] = {g.of_sun, g.of_lamp, g.of_cookie, g.of_sun, NULL, g.of_cookie, g.of_sun};
    (void)state;
    expect_product("one", one, of_one, 1);
    expect_product("textured_spot", spot, of_spot, 1);
    expect_product("three", three, of_three, 3);
    expect_product("seven", many, of_many, 7);
}

/* At Gouraud and flat frequency shadows are evaluated at corners or centroids: a small box in shadow is completely
 * dark. */
static void test_frequencies(void **state)
{
    static const shd_frequency k_all[] = {SHD_FREQUENCY_PHONG, SHD_FREQUENCY_GOURAUD, SHD_FREQUENCY_FLAT};
    static const float k_low[3] = {0.64f, 0.01f, 0.4f}, k_high[3] = {0.66f, 0.03f, 0.42f};
    static float color[3][k_pixels];
    static uint32_t draws[k_pixels];
    const shd_light *lights[] = {g.sun};
    const shd_shadow *shadows[1];
    shd_light_desc desc = shd_light_desc_default();
    shd_light *down = NULL;
    shd_shadow *shadow;
    size_t f, i;
    (void)state;
    desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    shd_assert_ok(shd_light_create(g.context, &desc, &down));
    shadow = shd_boxes_shadow(&g.boxes, g.context, NULL, down);
    lights[0] = down;
    shadows[0] = shadow;
    shd_boxes_add(&g.boxes, k_low, k_high); /* under the plate */
    g.boxes.draws[3].material = g.material;
    for (f = 0; f < 3; ++f) {
        const shd_u32_out column = {draws, 0};
        size_t lit = 0;
        for (i = 0; i < 4; ++i) g.boxes.draws[i].frequency = k_all[f];
        shd_assert_ok(render(lights, shadows, 1));
        read_planes(SHD_PLANE_R, color);
        shd_assert_ok(shd_framebuffer_read_u32_plane(g.framebuffer, SHD_PLANE_DRAW, &column));
        for (i = 0; i < k_pixels; ++i) {
            if (draws[i] == 3) assert_true(color[0][i] == 0.0f);
            lit += draws[i] == 2 && color[0][i] > 0.0f;
        }
        assert_true(lit > 20);
        for (i = 0; i < 4; ++i) g.boxes.draws[i].frequency = SHD_FREQUENCY_PHONG;
    }
    g.boxes.count = 3;
    shd_shadow_release(shadow);
    shd_light_release(down);
}

static void test_refused(void **state)
{
    const shd_light *lights[] = {g.ambient, g.sun};
    const shd_shadow *shadows[] = {NULL, NULL};
    (void)state;
    shd_assert_ok(render(lights, shadows, 2));
    shadows[1] = g.empty;
    shd_assert_result("not_rendered", render(lights, shadows, 2), BAD,
                      "render.shadows[1]: shadow: it was not rendered");
    shadows[1] = g.of_lamp;
    shd_assert_result("other_kind", render(lights, shadows, 2), BAD, "render.shadows[1]: shadow: rendered for a light");
    shadows[1] = NULL;
    shadows[0] = g.of_sun;
    shd_assert_result("ambient", render(lights, shadows, 2), BAD, "render.shadows[0]: shadow: rendered for a light");
    shadows[0] = (const shd_shadow *)(const void *)g.sun;
    shd_assert_result("a_light", render(lights, shadows, 2), BAD, "render.shadows[0]: shadow: not a live handle");
    shadows[0] = NULL;
    shd_assert_ok(render(lights, shadows, 2));
}

int main(void)
{
    static const struct CMUnitTest k_tests[] = {
        {"product", test_product, NULL, NULL, NULL},
        {"frequencies", test_frequencies, NULL, NULL, NULL},
        {"refused", test_refused, NULL, NULL, NULL},
    };
    return _cmocka_run_group_tests("api.render_shadows", k_tests, sizeof k_tests / sizeof k_tests[0], set_up,
                                   tear_down);
}
