/* SPDX-License-Identifier: MIT */
/* A ball under a sun and a lamp, without shadows and with shadows of each of the five filters, in one picture. */
#include "frame_scene.h"

#include <stdio.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { WIDTH = 400, HEIGHT = 300, COLUMNS = 2, ROWS = 3 };

static uint8_t pixels[ROWS * HEIGHT][COLUMNS * WIDTH][4];

/* Renders a map for each light except the ambient one. The maps keep all data that they need, so that further frames
   can use them without rendering. */
static shd_result create_shadows(shd_context *context, const struct scene *scene, shd_shadow_filter filter,
                                 shd_shadow *shadows[SCENE_LIGHTS])
{
    int i;
    for (i = 1; i < SCENE_LIGHTS; ++i) {
        shd_shadow_desc desc = shd_shadow_desc_default();
        shd_shadow_render_desc render = shd_shadow_render_desc_default();
        shd_result result;
        desc.filter = filter;
        desc.taps = filter == SHD_SHADOW_FILTER_PCSS ? 7 : 5;
        desc.filter_size = 0.1f;                /* SUMMED_AREA_VARIANCE: length in the world */
        desc.light_size = i == 1 ? 0.2f : 0.6f; /* PCSS: size as seen from the scene, and in the world */
        desc.bleed = 0.2f;
        if ((result = shd_shadow_create(context, &desc, &shadows[i])) != SHD_OK) return result;
        render.light = scene->lights[i];
        render.draws = scene->draws;
        render.draw_count = SCENE_DRAWS;
        if ((result = shd_shadow_render(context, shadows[i], &render)) != SHD_OK) return result;
    }
    return SHD_OK;
}

/* Renders into tile `tile` of the picture, and returns the sum of its green channel. */
static shd_result render(shd_context *context, const struct scene *scene, shd_shadow *const *shadows, int tile,
                         float *sum)
{
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_camera camera = shd_camera_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_image image = shd_image_default();
    shd_plane_view green = shd_plane_view_default();
    size_t i;
    shd_result result;
    fd.width = WIDTH, fd.height = HEIGHT, fd.sample_count = 4;
    camera.eye[0] = 4.0f, camera.eye[1] = 3.0f, camera.eye[2] = 1.6f;
    camera.target[1] = 0.4f;
    if ((result = shd_framebuffer_create(context, &fd, &framebuffer)) != SHD_OK) return result;
    rd.framebuffer = framebuffer;
    rd.camera = &camera; /* its aspect is that of the picture */
    rd.draws = scene->draws;
    rd.draw_count = SCENE_DRAWS;
    rd.lights = (const shd_light *const *)scene->lights;
    rd.light_count = SCENE_LIGHTS;
    rd.shadows = (const shd_shadow *const *)shadows; /* one for each light, or NULL */
    result = shd_render(context, &rd);
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = WIDTH, image.height = HEIGHT;
    image.pixels = pixels[tile / COLUMNS * HEIGHT][tile % COLUMNS * WIDTH];
    image.row_stride = sizeof pixels[0];
    if (result == SHD_OK) result = shd_framebuffer_read_color(framebuffer, &image);
    if (result == SHD_OK) result = shd_framebuffer_view_plane(framebuffer, SHD_PLANE_G, &green);
    for (i = 0; result == SHD_OK && i < WIDTH * HEIGHT; ++i) {
        *sum += green.f32[i / WIDTH * (green.row_stride / sizeof(float)) + i % WIDTH];
    }
    shd_framebuffer_release(framebuffer);
    return result;
}

int main(void)
{
    shd_context *context = NULL;
    struct scene scene = {NULL};
    float lit = 0;
    int tile, i, good;
    good = shd_context_create(NULL, &context) == SHD_OK && scene_create(context, &scene) == SHD_OK &&
           render(context, &scene, NULL, 0, &lit) == SHD_OK;
    for (tile = 1; good && tile < COLUMNS * ROWS; ++tile) {
        shd_shadow *shadows[SCENE_LIGHTS] = {NULL};
        float shadowed = 0;
        good = create_shadows(context, &scene, (shd_shadow_filter)(tile - 1), shadows) == SHD_OK &&
               render(context, &scene, shadows, tile, &shadowed) == SHD_OK && shadowed < 0.97f * lit;
        for (i = 0; i < SCENE_LIGHTS; ++i) shd_shadow_release(shadows[i]);
    }
#ifdef EXAMPLE_HAS_IO
    if (good) {
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8_SRGB;
        image.width = COLUMNS * WIDTH, image.height = ROWS * HEIGHT;
        image.pixels = pixels;
        good = shd_image_save(&image, "shadows.png", NULL) == SHD_OK && printf("shadows.png written\n") > 0;
    }
#endif
    if (!good) fprintf(stderr, "shadows: wrong picture or error: %s\n", shd_last_error());
    scene_release(&scene);
    shd_context_release(context);
    return good ? 0 : 1;
}
