/* SPDX-License-Identifier: MIT */
/* Everything that a fly-over renders with. */
#ifndef FLYOVER_SCENE_H
#define FLYOVER_SCENE_H

#include "flight.h"
#include "planet.h"

struct scene {
    shd_context *context;
    shd_tile_cache *cache;
    shd_texture *planet;
    shd_sampler *sampler;
    shd_material *material;
    shd_mesh *globe;
    shd_light *lights[2];
    shd_framebuffer *framebuffer;
    uint32_t width, height;
};

/* Makes the scene. scene_release() also releases what a failed call made. */
shd_result scene_create(struct scene *scene, uint32_t width, uint32_t height, uint64_t budget,
                        shd_missing_tiles missing);
void scene_release(struct scene *scene);

/* Renders a frame to pixels [height][width][4], sRGB. */
shd_result scene_render(const struct scene *scene, const struct flight *flight, uint8_t *pixels);

#endif
