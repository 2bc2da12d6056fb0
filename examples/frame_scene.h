/* SPDX-License-Identifier: MIT */
/* The scene of frame.c: a tiled floor, a ball on it and two lights, all made in code. */
#ifndef SHD_EXAMPLES_FRAME_SCENE_H
#define SHD_EXAMPLES_FRAME_SCENE_H

#include <shd/shd.h>

enum { SCENE_DRAWS = 2, SCENE_LIGHTS = 3 };

struct scene {
    shd_texture *tiles;
    shd_mesh *meshes[SCENE_DRAWS];
    shd_material *materials[SCENE_DRAWS];
    shd_light *lights[SCENE_LIGHTS];
    shd_draw draws[SCENE_DRAWS];
};

/* Fills `scene`, which must be all zero. On failure, release the objects that exist. */
shd_result scene_create(shd_context *context, struct scene *scene);
void scene_release(struct scene *scene);

#endif /* SHD_EXAMPLES_FRAME_SCENE_H */
