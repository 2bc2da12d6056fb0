/* SPDX-License-Identifier: MIT */
/* Shadows of a small scene as a number, which is equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_SHADOW_HASH_H
#define SHD_TESTS_SUPPORT_SHADOW_HASH_H

#include "support/noise.h"
#include "support/shadow_scene.h"

/** Visibility of points in a crossing of boxes: every filter, every kind of light, with and without normals. */
static inline uint64_t shd_shadow_hash(const shd_context_desc *desc)
{
    enum { k_points = 6000 };
    static const shd_light_kind k_kinds[] = {SHD_LIGHT_KIND_DIRECTIONAL, SHD_LIGHT_KIND_SPOT, SHD_LIGHT_KIND_POINT};
    static const float k_low[3][3] = {{-3, -1, -3}, {-1, 0, -0.5f}, {0.7f, 1, 0.3f}};
    static const float k_high[3][3] = {{3, 0, 3}, {0.3f, 1.2f, 0.4f}, {1.6f, 1.1f, 2}};
    static float points[6][k_points], out[k_points];
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    struct shd_boxes boxes;
    uint32_t seed = 3;
    size_t kind, i;
    int filter, k, normals;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_boxes_open(&boxes, context);
    for (i = 0; i < 3; ++i) shd_boxes_add(&boxes, k_low[i], k_high[i]);
    boxes.draws[1].object_to_world[4] = 0.3f; /* sheared */
    for (i = 0; i < k_points; ++i) {
        for (k = 0; k < 6; ++k) {
            shd_noise(&seed);
            points[k][i] = ((float)(seed >> 8) / 8388608.0f - 1.0f) * (k < 3 ? 3.0f : 0.57f);
        }
        if (i % 3 == 0) points[1][i] = 0.0f;
    }
    for (kind = 0; kind < 3; ++kind) {
        shd_light_desc light_desc = shd_light_desc_default();
        shd_light *light = NULL;
        light_desc.kind = k_kinds[kind];
        light_desc.position[0] = 1.5f;
        light_desc.position[1] = 3.5f;
        light_desc.direction[0] = -0.6f;
        light_desc.direction[2] = 0.2f;
        shd_assert_ok(shd_light_create(context, &light_desc, &light));
        for (filter = SHD_SHADOW_FILTER_HARD; filter <= SHD_SHADOW_FILTER_PCSS; ++filter) {
            shd_shadow_desc shadow_desc = shd_shadow_desc_default();
            shd_shadow *shadow;
            shadow_desc.size = 200;
            shadow_desc.filter = (shd_shadow_filter)filter;
            shadow_desc.taps = 4;
            shadow_desc.filter_size = 0.15f;
            shadow_desc.light_size = 0.3f;
            shadow_desc.bleed = 0.1f;
            shadow = shd_boxes_shadow(&boxes, context, &shadow_desc, light);
            for (normals = 0; normals < 2; ++normals) {
                shd_shadow_lookups lookups = shd_shadow_lookups_default();
                shd_shadow_values column = {sizeof column, {out, 0}, 0};
                lookups.count = k_points;
                for (k = 0; k < 3; ++k) {
                    lookups.position[k].data = points[k];
                    if (normals) lookups.normal[k].data = points[3 + k];
                }
                shd_assert_ok(shd_shadow_sample(shadow, &lookups, &column));
                hash = shd_hash(hash, out, sizeof out);
            }
            shd_shadow_release(shadow);
        }
        shd_light_release(light);
    }
    shd_boxes_close(&boxes);
    shd_context_release(context);
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_SHADOW_HASH_H */
