/* SPDX-License-Identifier: MIT */
/* A sphere in a smooth sky: the sky as an environment, and as one directional light for each of its texels. */
#ifndef SHD_TESTS_SUPPORT_SKY_H
#define SHD_TESTS_SUPPORT_SKY_H

#include "support/check.h"

#include <shd/shd.h>

#include "ref/environment_ref.h"
#include "support/noise.h"
#include "support/rows.h"

enum { EDGE = 48, WIDTH = 32, HEIGHT = 16, LIGHTS = WIDTH * HEIGHT };

static shd_context *g_context;
static shd_environment *g_environment;
static float g_texels[3 * LIGHTS];
static shd_light *g_lights[LIGHTS];

/** A smooth sky with a bright side. */
static void fill_sky(void)
{
    for (size_t i = 0; i < LIGHTS; ++i) {
        long double n[3];
        double away;
        ref_unproject(SHD_PROJECTION_LAT_LONG, (i % WIDTH + 0.5L) / WIDTH, (i / WIDTH + 0.5L) / HEIGHT, 0, n);
        away = (double)(n[0] * 0.6L + n[1] * 0.64L + n[2] * 0.48L);
        g_texels[3 * i] = (float)(0.2 + 0.1 * (double)n[1] + 2.0 * pow(fmax(away, 0.0), 8.0));
        g_texels[3 * i + 1] = (float)(0.3 + 0.2 * (double)n[1]);
        g_texels[3 * i + 2] = (float)(0.4 - 0.3 * (double)n[0]);
    }
}

static void make_lights(void)
{
    shd_image image = shd_image_default();
    shd_environment_desc desc = shd_environment_desc_default();
    ref_environment ref;
    fill_sky();
    image.format = SHD_FORMAT_RGB32F;
    image.width = WIDTH, image.height = HEIGHT;
    image.pixels = g_texels;
    desc.image = &image;
    desc.irradiance = SHD_IRRADIANCE_CONVOLVED;
    shd_assert_ok(shd_environment_create(g_context, &desc, &g_environment));
    ref = ref_environment_of(SHD_PROJECTION_LAT_LONG, &image);
    for (size_t i = 0; i < LIGHTS; ++i) {
        shd_light_desc light = shd_light_desc_default();
        light.kind = SHD_LIGHT_KIND_DIRECTIONAL;
        for (int c = 0; c < 3; ++c) {
            light.direction[c] = (float)-ref.lights[i].direction[c];
            light.intensity[c] = (float)(ref.lights[i].radiance[c] * ref.lights[i].solid_angle);
        }
        shd_assert_ok(shd_light_create(g_context, &light, &g_lights[i]));
    }
    free(ref.lights);
}

struct picture {
    float plane[4][EDGE * EDGE];
};

/** A sphere, or nothing without a material. */
struct scene {
    shd_mesh *mesh;
    shd_draw draw;
    shd_camera camera;
    shd_render_desc desc;
};

static void open_scene(struct scene *scene, shd_material *material)
{
    shd_shape_desc shape = shd_shape_desc_default();
    shape.segments[0] = 48, shape.segments[1] = 24;
    shd_assert_ok(shd_mesh_create_shape(g_context, &shape, SHD_MESH_NONE, &scene->mesh));
    scene->draw = shd_draw_default();
    scene->draw.mesh = scene->mesh;
    scene->draw.material = material;
    scene->camera = shd_camera_default();
    scene->desc = shd_render_desc_default();
    scene->desc.camera = &scene->camera;
    scene->desc.draws = &scene->draw;
    scene->desc.draw_count = material ? 1 : 0;
    scene->desc.environment = g_environment;
}

/** Renders a window of a picture of EDGE x EDGE pixels on a context. */
static void render_window(shd_context *context, struct scene *scene, uint32_t x, uint32_t y, uint32_t edge,
                          struct picture *out)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = desc.height = edge;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &scene->desc.framebuffer));
    scene->desc.picture_width = scene->desc.picture_height = EDGE;
    scene->desc.crop_x = x, scene->desc.crop_y = y;
    shd_assert_ok(shd_render(context, &scene->desc));
    for (int c = 0; c < 4; ++c) {
        const shd_f32_out to = shd_f32_out_column(out->plane[c], 0); /* packed rows of the window */
        shd_assert_ok(shd_framebuffer_read_plane(scene->desc.framebuffer, (shd_plane)(SHD_PLANE_R + c), &to));
    }
    shd_framebuffer_release(scene->desc.framebuffer);
}
static void render(struct scene *scene, struct picture *out) { render_window(g_context, scene, 0, 0, EDGE, out); }

static void close_scene(struct scene *scene) { shd_mesh_release(scene->mesh); }

/** Largest and root mean square difference of two pictures, divided by the largest value of the channel in `want`. */
static void compare(const char *what, const struct picture *got, const struct picture *want, double max_error,
                    double rms_error)
{
    double worst = 0.0, squares = 0.0;
    size_t count = 0;
    for (int c = 0; c < 3; ++c) {
        double largest = 0.0;
        for (size_t i = 0; i < EDGE * EDGE; ++i) largest = fmax(largest, (double)want->plane[c][i]);
        for (size_t i = 0; i < EDGE * EDGE; ++i) {
            const double error = fabs((double)got->plane[c][i] - (double)want->plane[c][i]) / largest;
            if (want->plane[3][i] == 0.0f) continue;
            if (!(error <= worst)) worst = error;
            squares += error * error;
            ++count;
        }
    }
    if (getenv("SHD_TEST_VERBOSE")) printf("%s: %.5f %.5f\n", what, worst, sqrt(squares / (double)count));
    assert_true(count > 1000);
    if (!(worst <= max_error) || !(sqrt(squares / (double)count) <= rms_error)) {
        fail_msg("%s: largest error %.5f, mean %.5f", what, worst, sqrt(squares / (double)count));
    }
}

struct model_case {
    const char *name;
    shd_model model;
    shd_frequency frequency;
    float exponent, roughness, metallic;
    double max_error, rms_error;
};
static shd_material *make_material(const struct model_case *row)
{
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    desc.model = row->model;
    desc.exponent = row->exponent;
    desc.roughness = row->roughness;
    desc.metallic = row->metallic;
    desc.diffuse[0] = 0.9f, desc.diffuse[1] = 0.6f, desc.diffuse[2] = 0.3f;
    shd_assert_ok(shd_material_create(g_context, &desc, &material));
    return material;
}

static int open_context(void **state)
{
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &g_context));
    make_lights();
    return 0;
}
static int close_context(void **state)
{
    (void)state;
    for (size_t i = 0; i < LIGHTS; ++i) shd_light_release(g_lights[i]);
    shd_environment_release(g_environment);
    shd_context_release(g_context);
    return 0;
}

#endif
