/* SPDX-License-Identifier: MIT */
/* The normal as a colour: -1..1 becomes 0..1. */
#include "course.h"

#include <math.h>

static void shade(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        out->r[i] = 0.5f * (in->nx[i] + 1.0f);
        out->g[i] = 0.5f * (in->ny[i] + 1.0f);
        out->b[i] = 0.5f * (in->nz[i] + 1.0f);
    }
}

/* Compares with the frame's own planes of normals. */
static int check(struct course *course, const shd_framebuffer *frame)
{
    size_t x, y;
    int c;
    for (c = 0; c < 3; ++c) {
        shd_plane_view color = shd_plane_view_default(), normal = shd_plane_view_default(),
                       alpha = shd_plane_view_default();
        if (shd_framebuffer_view_plane(frame, (shd_plane)(SHD_PLANE_R + c), &color) != SHD_OK ||
            shd_framebuffer_view_plane(frame, (shd_plane)(SHD_PLANE_NX + c), &normal) != SHD_OK ||
            shd_framebuffer_view_plane(frame, SHD_PLANE_A, &alpha) != SHD_OK) {
            return 0;
        }
        for (y = 0; y < course->options.size; ++y) {
            for (x = 0; x < course->options.size; ++x) {
                const size_t i = y * (color.row_stride / sizeof(float)) + x;
                const size_t j = y * (normal.row_stride / sizeof(float)) + x;
                if (alpha.f32[i] == 0.0f) continue;
                if (!(fabsf(color.f32[i] - 0.5f * (normal.f32[j] + 1.0f)) < 1e-6f)) return 0;
            }
        }
    }
    return 1;
}

int main(int argc, char **argv)
{
    const struct course_program program = {"normal", 0, shade, check};
    return course_main(argc, argv, &program);
}
