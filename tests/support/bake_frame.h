/* SPDX-License-Identifier: MIT */
/* A frame to bake into, charts that are rectangles, and a material that shows what a program reads. */
#ifndef SHD_TESTS_SUPPORT_BAKE_FRAME_H
#define SHD_TESTS_SUPPORT_BAKE_FRAME_H

#include <stdlib.h>

#include "support/bake_scene.h"
#include "support/frame.h"

enum { k_width = 48, k_height = 32, k_texels = k_width * k_height };
static uint32_t g_states[k_texels];

static inline void open_frame(shd_frame *f)
{
    shd_frame_open_aovs(f, k_width, k_height, 1,
                        SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE | SHD_AOV_POSITION | SHD_AOV_BARYCENTRICS |
                            SHD_AOV_DRAW | SHD_AOV_DERIVATIVES);
}

static inline shd_material_desc program_desc(void)
{
    shd_material_desc desc = shd_material_desc_default();
    desc.model = SHD_MODEL_PROGRAM;
    desc.program.fragment = shd_bake_program;
    return desc;
}

/* Two triangles that fill a rectangle of texture coordinates; positions are 3 u, 2 v, 1. */
static inline void set_quad(float *v, float u0, float v0, float u1, float v1)
{
    static const int k_corner[6][2] = {{0, 0}, {0, 1}, {1, 0}, {1, 0}, {0, 1}, {1, 1}};
    int i;
    for (i = 0; i < 6; ++i, v += 8) {
        const float x = k_corner[i][0] ? u1 : u0, y = k_corner[i][1] ? v1 : v0;
        const float vertex[8] = {3 * x, 2 * y, 1, 0, 0, 1, x, y};
        memcpy(v, vertex, sizeof vertex);
    }
}

#endif /* SHD_TESTS_SUPPORT_BAKE_FRAME_H */
