/* SPDX-License-Identifier: MIT */
/* A frame built by hand: identity view, so that positions are normalised device coordinates; a few draws with a mesh
   and a material each; and its planes as arrays. */
#ifndef SHD_TESTS_SUPPORT_FRAME_H
#define SHD_TESTS_SUPPORT_FRAME_H

#include <stdlib.h>

#include "support/check.h"

#include <shd/shd.h>

enum { SHD_FRAME_DRAWS = 4, SHD_FRAME_LIGHTS = 4, SHD_FRAME_PLANES = SHD_PLANE_TARGET3_A + 1 };

SHD_BEGIN_DECLS

/** The frame of a test. shd_frame_render fills `plane`, and `u32` for integer planes; absent planes are NULL. */
typedef struct shd_frame {
    shd_context *context;
    shd_framebuffer *framebuffer;
    shd_mesh *mesh[SHD_FRAME_DRAWS];
    shd_material *material[SHD_FRAME_DRAWS];
    shd_light *light[SHD_FRAME_LIGHTS];
    shd_draw draw[SHD_FRAME_DRAWS];
    shd_render_desc desc;
    shd_render_stats stats;
    uint32_t width, height;
    float *plane[SHD_FRAME_PLANES];
    uint32_t *u32[SHD_FRAME_PLANES];
    uint32_t *triangle; /* u32[SHD_PLANE_TRIANGLE] */
} shd_frame;

void shd_frame_open_aovs(shd_frame *f, uint32_t width, uint32_t height, uint32_t samples, uint32_t aovs);

void shd_frame_open_samples(shd_frame *f, uint32_t width, uint32_t height, uint32_t samples);

void shd_frame_open(shd_frame *f, uint32_t width, uint32_t height);

void shd_frame_close(shd_frame *f);

/**
 * Adds a draw of `count` vertices, in records of eight floats: position, normal, uv; every three form a triangle.
 */
shd_draw *shd_frame_draw(shd_frame *f, const float *vertices, uint32_t count, const shd_material_desc *material);

void shd_frame_light(shd_frame *f, const shd_light_desc *desc);

/** Renders, and reads all planes. */
void shd_frame_render(shd_frame *f);

/** A quad over [x0, x1] x [y0, y1] at depths z0 (left) and z1 (right), normal +z, uv (0, 0) top left, (1, 1) bottom
    right: two counter-clockwise triangles. */
void shd_frame_quad(float x0, float y0, float x1, float y1, float z0, float z1, float out[48]);

/** A material that emits its colour, given an ambient light of 1. */
shd_material_desc shd_frame_plain(float r, float g, float b);

void shd_frame_ambient(shd_frame *f);

SHD_END_DECLS

#endif /* SHD_TESTS_SUPPORT_FRAME_H */
