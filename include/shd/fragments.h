/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Fragment programs: functions of the caller that shade columns of fragments.
 *
 * The structs here go from the library to the program: struct_size is the size of the library's struct. A program that
 * was compiled with newer headers compares struct_size with the end of a field before it reads the field.
 *
 * Thread safety: a program runs on any worker of the executor, and calls may be concurrent. It must not throw or
 *                longjmp. Floating-point control is the IEEE default while it runs. It may look textures up
 *                (shd/lookup.h).
 *
 * @code
 * static void uv_as_colour(const shd_fragments *in, shd_radiance *out, void *user_data)
 * {
 *     size_t i;
 *     for (i = 0; i < in->count; ++i) out->r[i] = in->u[i], out->g[i] = in->v[i];
 * }
 * @endcode
 */
#ifndef SHD_FRAGMENTS_H
#define SHD_FRAGMENTS_H

#include <shd/mesh.h>
#include <shd/vertices.h>

SHD_BEGIN_DECLS

/**
 * Points to shade, one row each, as packed columns of `count` elements; borrowed for the call.
 *
 * A row is a visible fragment at Phong frequency, a vertex at Gouraud frequency, and a triangle's centroid at flat
 * frequency. For vertices and centroids x, y, depth and the derivatives are 0.
 */
typedef struct shd_fragments {
    uint32_t struct_size;   /**< size of the library's struct */
    uint32_t draw;          /**< index into shd_render_desc.draws; the same for every row */
    uint32_t instance;      /**< index into shd_draw.instances, 0 without instances; the same for every row */
    size_t varying_count;   /**< shd_material_desc.varying_count */
    size_t attribute_count; /**< number of `attribute` columns */
    size_t count;           /**< rows */
    const void *uniforms;   /**< shd_draw.uniforms */
    /**
     * Raster position, pixels from the left edge. It is the centre of the pixel, or the mean of the covered samples if
     * there are several samples and the triangle does not cover the centre. With SHD_DRAW_SAMPLE_SHADING it is the
     * position of the sample.
     */
    const float *x;
    const float *y;            /**< raster position, pixels from the top edge, as x */
    const float *depth;        /**< depth-buffer value, 0 near .. 1 far */
    const uint32_t *triangle;  /**< index of the triangle in its mesh */
    const float *px, *py, *pz; /**< position, world space */
    const float *nx, *ny, *nz; /**< shading normal, world space, unit */
    const float *ox, *oy, *oz; /**< wo: towards the eye, world space, unit (0 at the eye itself) */
    /**
     * Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
     * the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
     */
    const float *tx, *ty, *tz, *tw;
    const float *u, *v;            /**< texture coordinates, perspective-correct */
    const float *u1, *v1;          /**< second set of texture coordinates; 0 if the mesh has none */
    const float *dudx, *dvdx;      /**< analytic derivatives of u, v along one pixel to the right */
    const float *dudy, *dvdy;      /**< analytic derivatives of u, v along one pixel down */
    const float *const *attribute; /**< [attribute_count] columns of the mesh, interpolated; NULL for absent ones */
    /**
     * [varying_count] columns of the vertex program, interpolated by shd_material_desc.interpolation. At Gouraud
     * frequency they are the values of the vertex, at flat frequency the mean of the triangle's three vertices. FLAT
     * varyings have the value of the first vertex at every frequency.
     */
    const float *const *varying;
    /* ---- end of 0.1; append below ---- */
} shd_fragments;

/** Output of a program: scene-linear, premultiplied by a. r, g, b start as 0 and a as 1. */
typedef struct shd_radiance {
    uint32_t struct_size; /**< size of the library's struct */
    size_t target_count;  /**< number of `target` elements: 3 */
    float *r, *g, *b, *a; /**< packed columns of `count` elements */
    uint32_t *discard;    /**< starts as 0; any other value drops the row. NULL without SHD_MATERIAL_DISCARDS */
    /**
     * [target_count] r, g, b, a of SHD_AOV_TARGET1, 2 and 3; start as 0. NULL for targets that the framebuffer lacks.
     */
    float *const (*target)[4];
    /* ---- end of 0.1; append below ---- */
} shd_radiance;

/**
 * A fragment program: reads in->count rows and writes the same number of rows.
 *
 * The framebuffer keeps all values, even NaN and infinity; shd_render_stats.nonfinite_fragment_count counts these.
 */
typedef void (*shd_fragment_fn)(const shd_fragments *in, shd_radiance *out, void *user_data);

SHD_END_DECLS

#endif /* SHD_FRAGMENTS_H */
