/* SPDX-License-Identifier: MIT */
/* Solid textures of every kind as a number, which is equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_SOLID_HASH_H
#define SHD_TESTS_SUPPORT_SOLID_HASH_H

#include "support/pixel_hash.h"

enum { SHD_SOLID_HASH_POINTS = 16411, SHD_SOLID_HASH_SIZE = 61 }; /* two tasks */

/** The i-th of all descs: each kind with each of its options, of one octave or six. Returns 0 beyond the last one. */
static inline int shd_describe_solid(uint32_t i, shd_solid_desc *desc)
{
    *desc = shd_solid_desc_default();
    desc->kind = (shd_solid)(i % 8);
    i /= 8;
    desc->octaves = i % 2 ? 6 : 1;
    desc->gradients = i % 2 ? SHD_SOLID_GRADIENTS_TABLE : SHD_SOLID_GRADIENTS_HASHED;
    desc->fade = i % 3 ? SHD_SOLID_FADE_QUINTIC : SHD_SOLID_FADE_CUBIC;
    desc->sum = i % 3 == 1 ? SHD_SOLID_SUM_TURBULENCE : SHD_SOLID_SUM_FBM;
    desc->distance = (shd_solid_distance)(i % 3);
    desc->seed = 17 * i;
    desc->size = 0.75f;
    desc->color_count = 2 + i % 3;
    desc->colors[1][0] = 0.3f;
    return i < 6;
}

/** Hash of values, gradients and colours of places, with and without widths. */
static inline uint64_t shd_solid_points_hash(shd_context *context)
{
    float *const memory = (float *)shd_scene_memory(12 * SHD_SOLID_HASH_POINTS * sizeof(float));
    float *column[12];
    uint64_t hash = SHD_HASH_START;
    uint32_t kind;
    shd_solid_desc desc;
    size_t i, c;
    for (c = 0; c < 12; ++c) column[c] = memory + c * SHD_SOLID_HASH_POINTS;
    for (i = 0; i < SHD_SOLID_HASH_POINTS; ++i) {
        const float t = (float)i;
        column[0][i] = 0.0117f * t - 90.0f;
        column[1][i] = 3.7f - 0.31f * (float)(i % 97);
        column[2][i] = i % 101 == 0 ? 1e9f * t : 0.0041f * t;
        column[3][i] = i % 7 ? 0.05f * (float)(i % 50) : 0.0f;
    }
    for (kind = 0; shd_describe_solid(kind, &desc); ++kind) {
        shd_solid_points points = shd_solid_points_default();
        shd_solid_values values = shd_solid_values_default();
        points.count = kind == 12 ? SHD_SOLID_HASH_POINTS : 353;
        for (c = 0; c < 3; ++c) points.position[c].data = column[c];
        if (kind % 2) points.width.data = column[3];
        values.value.data = column[4];
        for (c = 0; c < 3; ++c) values.gradient[c].data = column[5 + c];
        for (c = 0; c < 4; ++c) values.channel[c].data = column[8 + c];
        shd_assert_ok(shd_solid_evaluate(context, &desc, &points, &values));
        for (c = 4; c < 12; ++c) hash = shd_hash(hash, column[c], points.count * sizeof(float));
    }
    free(memory);
    return hash;
}

/** Hash of a frame in which solid textures feed several slots of the scene's draws. */
static inline uint64_t shd_solid_frame_hash(uint64_t hash, shd_context *context)
{
    shd_scene scene;
    shd_material *material[3];
    size_t i;
    shd_scene_open(&scene, SHD_SCENE_MIXED, context);
    for (i = 0; i < 3; ++i) {
        shd_material_desc desc = shd_material_desc_default();
        shd_solid_desc solid[2];
        shd_slot slots[2];
        (void)shd_describe_solid(8 + 2 + (uint32_t)i * 2, &solid[0]);
        (void)shd_describe_solid(6 + (uint32_t)i % 2, &solid[1]);
        slots[0] = shd_slot_solid(SHD_SLOT_DIFFUSE, &solid[0]);
        slots[1] = shd_slot_solid(SHD_SLOT_ROUGHNESS, &solid[1]);
        slots[1].place_space = SHD_PLACE_SPACE_WORLD;
        slots[1].place_transform[4] = 0.5f;
        desc.model = SHD_MODEL_METALLIC_ROUGHNESS;
        desc.slots = slots;
        desc.slot_count = 2;
        shd_assert_ok(shd_material_create(context, &desc, &material[i]));
    }
    for (i = 0; i < scene.desc.draw_count; ++i) scene.draw[i].material = material[i % 3];
    hash = shd_frame_hash(hash, &scene, SHD_FORMAT_RGBA16F, 1);
    for (i = 0; i < 3; ++i) shd_material_release(material[i]);
    shd_scene_close(&scene);
    return hash;
}

/** Both of a context made from `desc`. */
static inline uint64_t shd_solid_hash(const shd_context_desc *desc)
{
    shd_context *context = NULL;
    uint64_t hash;
    shd_assert_ok(shd_context_create(desc, &context));
    hash = shd_solid_frame_hash(shd_solid_points_hash(context), context);
    shd_context_release(context);
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_SOLID_HASH_H */
