/* SPDX-License-Identifier: MIT */
/* Small scenes that all tests of whole frames share. They use only exact arithmetic (no libm except sqrtf), so that
   their hashes are equal on every machine. Objects are made step by step, so that a test can make each step fail. */
#ifndef SHD_TESTS_SUPPORT_SCENE_H
#define SHD_TESTS_SUPPORT_SCENE_H

#include <stdlib.h>

#include "support/check.h"
#include "support/noise.h"
#include "support/slots.h"

#include <shd/extension.h>
#include <shd/shd.h>

SHD_BEGIN_DECLS

/** The scenes. */
typedef enum shd_scene_kind {
    SHD_SCENE_MIXED = 0, /* every model, frequency and filter, clipped at the near plane, NaN; 5k triangles */
    SHD_SCENE_FLOOR = 1, /* a textured plane that runs behind the eye: trilinear, minified to one texel; every plane */
    SHD_SCENE_LIT = 2,   /* lights of every kind on all three frequencies */
    SHD_SCENE_GLASS = 3, /* as MIXED with every blend and depth state, and four samples per pixel */
    SHD_SCENE_SMALL =
        4, /* as GLASS with few triangles, two samples and every plane: for tests that render hundreds of times */
    SHD_SCENE_MOVED = 5,   /* as GLASS with one sample, every vertex moved by a program */
    SHD_SCENE_LINES = 6,   /* as GLASS, most draws as lines */
    SHD_SCENE_SURFACE = 7, /* as MIXED with every model, slot and normal modification; lights with ranges and cookies */
    SHD_SCENE_KINDS = 8
} shd_scene_kind;

enum {
    SHD_SCENE_TEXTURES = 4,
    SHD_SCENE_SAMPLERS = 4,
    SHD_SCENE_MESHES = 4,
    SHD_SCENE_MATERIALS = 10,
    SHD_SCENE_LIGHTS = 4,
    SHD_SCENE_DRAWS = 12,
    SHD_SCENE_STEPS =
        SHD_SCENE_TEXTURES + SHD_SCENE_SAMPLERS + SHD_SCENE_MESHES + SHD_SCENE_MATERIALS + SHD_SCENE_LIGHTS + 1
};

/** Objects of a scene, and the frame of them. All zero is an empty scene. */
typedef struct shd_scene {
    shd_scene_kind kind;
    shd_vertex_fn vertex; /* for every material without its own; set before the steps */
    shd_context *context; /* borrowed */
    shd_texture *texture[SHD_SCENE_TEXTURES];
    shd_sampler *sampler[SHD_SCENE_SAMPLERS];
    shd_mesh *mesh[SHD_SCENE_MESHES];
    shd_material *material[SHD_SCENE_MATERIALS];
    shd_light *light[SHD_SCENE_LIGHTS];
    shd_framebuffer *framebuffer;
    shd_draw draw[SHD_SCENE_DRAWS];
    shd_render_desc desc;
    shd_render_stats stats;
} shd_scene;

/** Next number of a linear congruential sequence (Knuth), in [0, 1). */
float shd_scene_random(uint32_t *state);

/** Allocates memory of the test, not of the library; aborts on failure. */
void *shd_scene_memory(size_t size);

/** Vertices as records of five floats, position and uv, and triangles. */
typedef struct shd_scene_geometry {
    float *vertices;
    uint32_t *indices;
    uint32_t vertex_count;
    size_t index_count;
} shd_scene_geometry;

void shd_scene_vertex(shd_scene_geometry *g, float x, float y, float z, float u, float v);

/** Hills over [-1, 1]^2, facing +y. */
void shd_scene_hills(shd_scene_geometry *g, uint32_t n);

/** A program that reads every column. */
void shd_scene_program(const shd_fragments *in, shd_radiance *out, void *user_data);

shd_slot *shd_scene_slot(shd_scene *s, shd_slot_list *slots, shd_material_desc *desc, shd_slot_target target,
                         size_t texture);

/** Creates one object of the scene: steps 0..SHD_SCENE_STEPS - 1, in order. */
shd_result shd_scene_step(shd_scene *s, size_t step);

/** Composes the frame after all steps. */
void shd_scene_compose(shd_scene *s);

/** Makes a scene that must not fail. */
void shd_scene_open(shd_scene *s, shd_scene_kind kind, shd_context *context);

/** Releases every object; skips objects that were never made. */
void shd_scene_close(shd_scene *s);

/** Hash of all planes of a framebuffer; all NaN are equal. */
uint64_t shd_hash_framebuffer(const shd_framebuffer *framebuffer);

/** Hash of the counts of the statistics, without time and memory. The counts that only some frames ask for change it if
    one of them is not 0. */
uint64_t shd_hash_stats(uint64_t hash, const shd_render_stats *stats);

/** Renders, and returns the hash of the planes and the statistics. */
uint64_t shd_scene_render(shd_scene *s);

/** The hash of a scene on one thread with the best SIMD target. */
uint64_t shd_scene_reference(shd_scene_kind kind);

SHD_END_DECLS

#endif /* SHD_TESTS_SUPPORT_SCENE_H */
