/* SPDX-License-Identifier: MIT */
/* Environments for tests, and lookups of a fixed set of directions. Each test program includes this header once. */
#ifndef SHD_TESTS_SUPPORT_ENVIRONMENTS_H
#define SHD_TESTS_SUPPORT_ENVIRONMENTS_H

#include "support/check.h"

#include <math.h>

#include <shd/environment.h>

#include "support/noise.h"

enum { DIRECTIONS = 97 };

static shd_context *g_context;
static float g_direction[3][DIRECTIONS];
static float g_out[3][DIRECTIONS + 1];

static inline shd_environment *create_with(shd_context *context, shd_projection projection, const shd_image *image,
                                           shd_irradiance irradiance, shd_environment_table_flags tables)
{
    shd_environment_desc desc = shd_environment_desc_default();
    shd_environment *environment = NULL;
    desc.projection = projection;
    desc.image = image;
    desc.irradiance = irradiance;
    desc.tables = tables;
    shd_assert_ok(shd_environment_create(context, &desc, &environment));
    return environment;
}
static inline shd_environment *create(shd_context *context, shd_projection projection, const shd_image *image,
                                      shd_irradiance irradiance)
{
    return create_with(context, projection, image, irradiance, SHD_ENVIRONMENT_TABLE_ALL);
}

static inline shd_environment_lookups lookups_of(size_t count)
{
    shd_environment_lookups lookups = shd_environment_lookups_default();
    lookups.count = count;
    for (int c = 0; c < 3; ++c) lookups.direction[c] = shd_f32_column(g_direction[c], 0);
    return lookups;
}

static inline void outputs(shd_environment_values *light)
{
    *light = shd_environment_values_default();
    for (int c = 0; c < 3; ++c) light->channel[c] = shd_f32_out_column(g_out[c], 0);
}

/** Looks up the radiance of all directions; width NULL = sharp. */
static inline void look_up(const shd_environment *environment, const float *roughness, const float *exponent)
{
    shd_environment_lookups lookups = lookups_of(DIRECTIONS);
    shd_environment_values light;
    outputs(&light);
    lookups.roughness = shd_f32_column(roughness, 0);
    lookups.exponent = shd_f32_column(exponent, 0);
    shd_assert_ok(shd_environment_sample_radiance(environment, &lookups, &light));
}

static inline void irradiance_of(const shd_environment *environment)
{
    const shd_environment_lookups lookups = lookups_of(DIRECTIONS);
    shd_environment_values light;
    outputs(&light);
    shd_assert_ok(shd_environment_sample_irradiance(environment, &lookups, &light));
}

/** Sets the directions: random ones, the axes, and the diagonals where the octahedron folds. */
static inline void make_directions(void)
{
    uint32_t state = 7;
    for (size_t i = 0; i < DIRECTIONS; ++i) {
        double n[3], square = 0.0;
        for (int c = 0; c < 3; ++c) {
            n[c] = i < 27 ? (double)((int)(i / (c == 0   ? 1
                                                : c == 1 ? 3
                                                         : 9)) %
                                         3 -
                                     1)
                          : (double)shd_noise(&state) * 0x1p-31 - 1.0;
            square += n[c] * n[c];
        }
        if (square == 0.0) n[2] = square = 1.0;
        for (int c = 0; c < 3; ++c) g_direction[c][i] = (float)(n[c] / sqrt(square));
    }
}

static inline int open_context(void **state)
{
    (void)state;
    make_directions();
    shd_assert_ok(shd_context_create(NULL, &g_context));
    return 0;
}
static inline int close_context(void **state)
{
    (void)state;
    shd_context_release(g_context);
    return 0;
}

#endif /* SHD_TESTS_SUPPORT_ENVIRONMENTS_H */
