/* SPDX-License-Identifier: MIT */
/* Render a frame: a shiny ball over a tiled floor, shown through ACES and saved as EXR and PNG. */
#include "frame_scene.h"

#include <stdio.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_COLOR
#include <shd/color.h>
#endif
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { WIDTH = 640, HEIGHT = 400 };

/* Everything that the frame needs, in one struct, so that a single exit releases it. */
struct frame {
    shd_context *context;
    shd_framebuffer *framebuffer;
    struct scene scene;
};

static shd_result render(struct frame *f)
{
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_camera camera = shd_camera_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_result result;

    fd.width = WIDTH, fd.height = HEIGHT;
    camera.eye[0] = 2.0f, camera.eye[1] = 1.8f, camera.eye[2] = 4.0f;
    camera.target[1] = 0.7f;
    if ((result = shd_framebuffer_create(f->context, &fd, &f->framebuffer)) != SHD_OK) return result;

    rd.camera = &camera; /* its aspect is that of the picture */
    rd.framebuffer = f->framebuffer;
    rd.draws = f->scene.draws;
    rd.draw_count = SCENE_DRAWS;
    rd.lights = (const shd_light *const *)f->scene.lights;
    rd.light_count = SCENE_LIGHTS;
    return shd_render(f->context, &rd);
}

/* The ball in the middle is lit; the sky is empty; the floor lies in front. */
static int check(const shd_framebuffer *framebuffer)
{
    shd_plane_view green = shd_plane_view_default(), alpha = shd_plane_view_default(), depth = shd_plane_view_default();
    size_t row, ball, sky, floor;
    if (shd_framebuffer_view_plane(framebuffer, SHD_PLANE_G, &green) != SHD_OK ||
        shd_framebuffer_view_plane(framebuffer, SHD_PLANE_A, &alpha) != SHD_OK ||
        shd_framebuffer_view_plane(framebuffer, SHD_PLANE_DEPTH, &depth) != SHD_OK) {
        return 0;
    }
    row = green.row_stride / sizeof(float);
    ball = HEIGHT / 2 * row + WIDTH / 2, sky = WIDTH / 2, floor = (HEIGHT - 1) * row + WIDTH / 2;
    return green.f32[ball] > 0.1f && alpha.f32[ball] == 1.0f && alpha.f32[sky] == 0.0f && depth.f32[sky] == 1.0f &&
           alpha.f32[floor] == 1.0f && depth.f32[floor] < depth.f32[ball] && depth.f32[ball] < 1.0f;
}

/* Scene-linear, and what a display shows: the sRGB curve alone, or a view of libshd_color. */
static shd_result save(const struct frame *f)
{
    shd_result result = SHD_OK;
#ifdef EXAMPLE_HAS_IO
    shd_save_desc desc = shd_save_desc_default();
    desc.dither = SHD_DITHER_ORDERED;
#ifdef EXAMPLE_HAS_COLOR
    shd_color_view view = {NULL, "sRGB", "ACES 1.0 SDR-video"};
    shd_color *color = NULL;
    if ((result = shd_color_create(f->context, NULL, &color)) != SHD_OK) return result;
    view.color = color;
    desc.display.apply = shd_color_apply_view, desc.display.user_data = &view;
#endif
    result = shd_framebuffer_save(f->framebuffer, "frame.exr", NULL);
    if (result == SHD_OK) result = shd_framebuffer_save(f->framebuffer, "frame.png", &desc);
    if (result == SHD_OK) printf("frame.exr and frame.png written\n");
#ifdef EXAMPLE_HAS_COLOR
    shd_color_release(color);
#endif
#else
    (void)f;
#endif
    return result;
}

int main(void)
{
    struct frame f = {NULL, NULL, {NULL}};
    int good = shd_context_create(NULL, &f.context) == SHD_OK && scene_create(f.context, &f.scene) == SHD_OK &&
               render(&f) == SHD_OK && check(f.framebuffer) && save(&f) == SHD_OK;
    if (!good) fprintf(stderr, "frame: wrong picture or error: %s\n", shd_last_error());
    scene_release(&f.scene);
    shd_framebuffer_release(f.framebuffer);
    shd_context_release(f.context);
    return good ? 0 : 1;
}
