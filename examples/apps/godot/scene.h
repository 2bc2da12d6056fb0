/* SPDX-License-Identifier: MIT */
/* A torus that turns above a checkered floor. The Godot module and the C program of the test draw it. */
#ifndef GODOT_SCENE_H
#define GODOT_SCENE_H

#include <stdint.h>

#include <shd/shd.h>

struct scene {
    uint32_t width, height;
    shd_context *context;
    shd_texture *texture;
    shd_sampler *sampler;
    shd_material *materials[2]; /* floor, torus */
    shd_mesh *meshes[2];
    shd_light *lights[2];
    shd_framebuffer *framebuffer;
};

/* Makes the objects for frames of a size. After a failure the scene is closed; shd_last_error() has the text. */
shd_result scene_open(struct scene *scene, uint32_t width, uint32_t height);

/* Draws a frame into width * height pixels, RGBA of 8 bits in sRGB. */
shd_result scene_draw(const struct scene *scene, int frame, uint8_t *pixels);

/* Releases all objects. A scene of zeros, or one that is closed, stays as it is. */
void scene_close(struct scene *scene);

#endif /* GODOT_SCENE_H */
