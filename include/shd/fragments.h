/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Columns that a fragment program reads and writes.
 *
 * Thread safety: a program runs on any worker of the executor, several calls at once; it must not throw
 * or longjmp. Floating-point control is the IEEE default while it runs. It may look textures up (shd/lookup.h).
 */
#ifndef SHD_FRAGMENTS_H
#define SHD_FRAGMENTS_H

#include <shd/mesh.h>
#include <shd/vertices.h>

SHD_BEGIN_DECLS

/**
 * Points to shade, one row each, packed columns of `count` elements; borrowed for the call.
 * At Phong frequency a row is a visible fragment, at Gouraud a vertex, at flat a triangle's centroid; for
 * the latter two x, y, depth and the derivatives are 0.
 */
typedef struct shd_fragments {
    uint32_t struct_size; /**< of the library's struct */
    uint32_t draw;        /**< index into shd_render_desc.draws; the same for every row */
    size_t count;         /**< rows */
    /**
     * Raster position, pixels from the left edge: the centre of the pixel; with several samples, where the triangle
     * does not cover that, the mean of those that it covers; with SHD_DRAW_SAMPLE_SHADING the sample
     */
    const float *x;
    const float *y;            /**< the same from the top edge */
    const float *depth;        /**< depth-buffer value, 0 near .. 1 far */
    const float *px, *py, *pz; /**< position, world space */
    const float *nx, *ny, *nz; /**< shading normal, world space, unit */
    const float *ox, *oy, *oz; /**< wo: towards the eye, world space, unit (0 at the eye itself) */
    const float *u, *v;        /**< texture coordinates, perspective-correct */
    const float *dudx, *dvdx;  /**< analytic derivatives along one pixel to the right */
    const float *dudy, *dvdy;  /**< analytic derivatives along one pixel down */
    const uint32_t *triangle;  /**< index of the triangle in its mesh */
    uint32_t instance;         /**< index into shd_draw.instances, 0 without; the same for every row */
    uint32_t varying_count;    /**< that of the material */
    const void *uniforms;      /**< shd_draw.uniforms */
    /**
     * What the vertex program wrote, by shd_material_desc.interpolation; NULL from varying_count on. At Gouraud
     * frequency that of the vertex, at flat the mean of the triangle's three; flat ones are the first vertex's.
     */
    const float *varying[SHD_MAX_VARYINGS];
    /**
     * Tangent in world space, of any length, and handedness: that of the mesh, interpolated; without one, that of the
     * triangle, unit; 0 where neither uv nor tangents tell. The bitangent tw (n x t) runs against v
     */
    const float *tx, *ty, *tz, *tw;
    const float *u1, *v1;                       /**< the second set; 0 if the mesh has none */
    const float *attribute[SHD_MAX_ATTRIBUTES]; /**< of the mesh, interpolated; NULL where it has none */
} shd_fragments;

/** What a program writes: scene-linear, premultiplied by a. r, g, b start as 0 and a as 1. */
typedef struct shd_radiance {
    uint32_t struct_size; /**< of the library's struct */
    uint32_t reserved;    /**< 0 */
    float *r, *g, *b, *a; /**< packed columns of `count` elements */
    uint32_t *discard;    /**< starts as 0; anything else drops the row. NULL but with SHD_MATERIAL_DISCARDS */
    float *target[3][4];  /**< r, g, b, a of SHD_AOV_TARGET1 to 3, start as 0; NULL if the framebuffer has them not */
} shd_radiance;

/**
 * A fragment program: reads in->count rows, writes as many. What it writes is kept, NaN and infinity too; these are
 * counted as shd_render_stats.nonfinite_fragments.
 */
typedef void (*shd_fragment_fn)(const shd_fragments *in, shd_radiance *out, void *user_data);

SHD_END_DECLS

#endif /* SHD_FRAGMENTS_H */
