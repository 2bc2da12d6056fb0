/* SPDX-License-Identifier: MIT */
/* Frames in an environment as a number, which is equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_ENVIRONMENT_HASH_H
#define SHD_TESTS_SUPPORT_ENVIRONMENT_HASH_H

#include "support/noise.h"
#include "support/scene.h"

/** Every model, slot and frequency in the light of noise with bright spots, before it, and with both irradiances. */
static inline uint64_t shd_environment_hash(const shd_context_desc *desc)
{
    enum { k_width = 64, k_height = 32 };
    static float texels[3 * k_width * k_height];
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    uint32_t seed = 11;
    int round, i;
    shd_assert_ok(shd_context_create(desc, &context));
    for (i = 0; i < 3 * k_width * k_height; ++i) {
        shd_noise(&seed);
        texels[i] = (float)(seed >> 8) / 16777216.0f * (seed >> 8 & 63 ? 0.3f : 40.0f);
    }
    for (round = 0; round < 2; ++round) {
        shd_environment_desc environment_desc = shd_environment_desc_default();
        shd_image image = shd_image_default();
        shd_environment *environment = NULL;
        shd_scene scene;
        uint64_t frame;
        image.format = SHD_FORMAT_RGB32F;
        image.width = k_width, image.height = k_height;
        image.pixels = texels;
        environment_desc.image = &image;
        environment_desc.irradiance = round ? SHD_IRRADIANCE_CONVOLVED : SHD_IRRADIANCE_HARMONICS;
        shd_assert_ok(shd_environment_create(context, &environment_desc, &environment));
        shd_scene_open(&scene, SHD_SCENE_SURFACE, context);
        scene.desc.environment = environment;
        scene.desc.environment_intensity = 0.75f;
        scene.desc.environment_to_world[0] = scene.desc.environment_to_world[8] = 0.6f;
        scene.desc.environment_to_world[2] = -0.8f;
        scene.desc.environment_to_world[6] = 0.8f;
        scene.desc.background = SHD_BACKGROUND_ENVIRONMENT;
        scene.desc.background_roughness = round ? 0.2f : 0.0f;
        frame = shd_scene_render(&scene);
        hash = shd_hash(hash, &frame, sizeof frame);
        shd_scene_close(&scene);
        shd_environment_release(environment);
    }
    shd_context_release(context);
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_ENVIRONMENT_HASH_H */
