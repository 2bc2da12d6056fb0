/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Columns that a vertex program reads and writes.
 *
 * Thread safety: a program runs on any worker of the executor, several calls at once; it must not throw
 * or longjmp. Floating-point control is the IEEE default while it runs.
 */
#ifndef SHD_VERTICES_H
#define SHD_VERTICES_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Limits of vertex and fragment programs. */
enum {
    SHD_MAX_VARYINGS = 16 /**< values of a vertex that its program hands on to fragments */
};

/** How a varying gets from the three vertices of a triangle to a fragment. */
typedef enum shd_interpolation {
    /** Linear on the triangle itself. */
    SHD_INTERPOLATION_PERSPECTIVE = 0,
    /**
     * Linear on the screen, between the places of the three vertices, clipped or not. As PERSPECTIVE where one of them
     * has no place: with w < 2^-100, or more than 2^60 pixels away.
     */
    SHD_INTERPOLATION_AFFINE = 1,
    /** That of the triangle's first vertex, in every row of the triangle whatever the frequency. */
    SHD_INTERPOLATION_FLAT = 2,
    SHD_INTERPOLATION_MAX_ENUM = 0x7fffffff
} shd_interpolation;

/**
 * Neighbouring vertices of one draw, one row each, packed columns of `count` elements; borrowed for the call. Every
 * vertex of a triangle comes for each instance of the draw, up to 512 at a time: once, or where the frame takes several
 * passes (shd_render_desc.pass_triangles) once or more in each that needs it. Which come together and in which order
 * the calls are made may change.
 */
typedef struct shd_vertices {
    uint32_t struct_size;           /**< of the library's struct */
    uint32_t draw;                  /**< index into shd_render_desc.draws */
    uint32_t instance;              /**< index into shd_draw.instances, 0 without */
    uint32_t first;                 /**< row i is vertex first + i of the mesh */
    size_t count;                   /**< rows; must stay as it is */
    const float *px, *py, *pz;      /**< position, object space */
    const float *nx, *ny, *nz;      /**< normal, object space, unit */
    const float *u, *v;             /**< texture coordinates; 0 if the mesh has none */
    const float *tx, *ty, *tz, *tw; /**< tangent, object space, and handedness; NULL if the mesh has none */
    const float *object_to_world;   /**< [16], column-major; of the instance */
    const float *world_to_view;     /**< [16], column-major */
    const float *view_to_clip;      /**< [16], column-major */
    const float *eye;               /**< [3], world space */
    const void *uniforms;           /**< shd_draw.uniforms */
} shd_vertices;

/**
 * What a program may change, packed columns of `count` elements. Each starts as what it is without a program, and a
 * vertex whose values stay as they were has the same bits in the frame as without. The triangles of a vertex with NaN
 * or infinity in any column are dropped and counted as shd_render_stats.nonfinite.
 */
typedef struct shd_vertex_outputs {
    uint32_t struct_size;             /**< of the library's struct */
    uint32_t varying_count;           /**< that of the material */
    float *x, *y, *z, *w;             /**< clip space: visible with -w..w for x and y, 0..w for z */
    float *px, *py, *pz;              /**< position, world space: what lights and wo go by */
    float *nx, *ny, *nz;              /**< normal, world space; made unit afterwards where it was changed */
    float *u, *v;                     /**< texture coordinates */
    float *varying[SHD_MAX_VARYINGS]; /**< start as 0; NULL from varying_count on */
} shd_vertex_outputs;

/**
 * A vertex program: reads and writes in->count rows. Each row must depend on its own inputs alone, or the frame depends
 * on how vertices are cut into calls.
 */
typedef void (*shd_vertex_fn)(const shd_vertices *in, shd_vertex_outputs *out, void *user_data);

SHD_END_DECLS

#endif /* SHD_VERTICES_H */
