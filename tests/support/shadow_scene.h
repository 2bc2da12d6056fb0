/* SPDX-License-Identifier: MIT */
/* Scenes of boxes, lights for them and lookups, for tests of shadows. */
#ifndef SHD_TESTS_SUPPORT_SHADOW_SCENE_H
#define SHD_TESTS_SUPPORT_SHADOW_SCENE_H

#include "support/check.h"

#include <shd/shd.h>

/** Boxes, each a draw of one mesh, the cube -1..1 with outward faces. */
struct shd_boxes {
    shd_mesh *cube;
    shd_draw draws[16];
    size_t count;
};

static inline void shd_boxes_open(struct shd_boxes *boxes, shd_context *context)
{
    static const float k_position[24] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1,
                                         -1, -1, 1,  1, -1, 1,  -1, 1, 1,  1, 1, 1};
    static const uint32_t k_indices[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                                           1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
    shd_mesh_desc desc = shd_mesh_desc_default();
    int c;
    memset(boxes, 0, sizeof *boxes);
    desc.vertex_count = 8;
    for (c = 0; c < 3; ++c) {
        desc.position[c].data = k_position + c;
        desc.position[c].stride = 3 * sizeof(float);
    }
    desc.indices.data = k_indices;
    desc.index_count = 36;
    shd_assert_ok(shd_mesh_create(context, &desc, &boxes->cube));
}

static inline void shd_boxes_add(struct shd_boxes *boxes, const float low[3], const float high[3])
{
    shd_draw *draw = &boxes->draws[boxes->count++];
    int k;
    *draw = shd_draw_default();
    draw->mesh = boxes->cube;
    for (k = 0; k < 3; ++k) {
        draw->object_to_world[5 * k] = 0.5f * (high[k] - low[k]);
        draw->object_to_world[12 + k] = 0.5f * (high[k] + low[k]);
    }
}

static inline void shd_boxes_close(struct shd_boxes *boxes) { shd_mesh_release(boxes->cube); }

/** A shadow of the boxes, rendered for a light. */
static inline shd_shadow *shd_boxes_shadow(const struct shd_boxes *boxes, shd_context *context,
                                           const shd_shadow_desc *desc, const shd_light *light)
{
    shd_shadow_render_desc render = shd_shadow_render_desc_default();
    shd_shadow *shadow = NULL;
    shd_assert_ok(shd_shadow_create(context, desc, &shadow));
    render.light = light;
    render.draws = boxes->draws;
    render.draw_count = boxes->count;
    shd_assert_ok(shd_shadow_render(context, shadow, &render));
    return shadow;
}

/** Visibility at one point of a surface. */
static inline float shd_shadow_at(const shd_shadow *shadow, const float p[3], const float n[3])
{
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    float visibility = -1.0f;
    shd_shadow_values out = {sizeof out, {&visibility, 0}, 0};
    int k;
    lookups.count = 1;
    for (k = 0; k < 3; ++k) {
        lookups.position[k].data = p + k;
        if (n) lookups.normal[k].data = n + k;
    }
    shd_assert_ok(shd_shadow_sample(shadow, &lookups, &out));
    return visibility;
}

#endif /* SHD_TESTS_SUPPORT_SHADOW_SCENE_H */
