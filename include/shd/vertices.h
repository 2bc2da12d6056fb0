/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Vertex programs: functions of the caller that read and write columns of vertices.
 *
 * The structs here go from the library to the program: struct_size is the size of the library's struct. A program that
 * was compiled with newer headers compares struct_size with the end of a field before it reads the field.
 *
 * Thread safety: a program runs on any worker of the executor, and calls may be concurrent. It must not throw or
 *                longjmp. Floating-point control is the IEEE default while it runs.
 *
 * @code
 * static void wave(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
 * {
 *     size_t i;
 *     for (i = 0; i < in->count; ++i) out->y[i] += 0.1f * out->w[i] * sinf(in->px[i]);
 * }
 * @endcode
 */
#ifndef SHD_VERTICES_H
#define SHD_VERTICES_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Largest number of varyings: values that a vertex program passes to fragments. */
#define SHD_MAX_VARYINGS 16

/** Interpolation of a varying from the three vertices of a triangle to a fragment. */
typedef enum shd_interpolation {
    /** Linear on the triangle itself. */
    SHD_INTERPOLATION_PERSPECTIVE = 0,
    /**
     * Linear on the screen between the three projected vertices, also for clipped triangles. If a vertex cannot be
     * projected (w < 2^-100, or more than 2^60 pixels away), PERSPECTIVE is used.
     */
    SHD_INTERPOLATION_AFFINE = 1,
    /** The value of the triangle's first vertex, for all fragments and at every frequency. */
    SHD_INTERPOLATION_FLAT = 2,
    SHD_INTERPOLATION_MAX_ENUM = 0x7fffffff
} shd_interpolation;

/**
 * Neighbouring vertices of one draw, one row each, as packed columns of `count` elements; borrowed for the call.
 *
 * Every vertex of a triangle is processed for each instance of the draw, up to 512 vertices per call. It is processed
 * once, or once in each pass that needs it if the frame has several passes (shd_render_desc.pass_triangles). The
 * grouping of vertices and the order of calls are unspecified.
 */
typedef struct shd_vertices {
    uint32_t struct_size;           /**< size of the library's struct */
    uint32_t draw;                  /**< index into shd_render_desc.draws */
    uint32_t instance;              /**< index into shd_draw.instances, 0 without instances */
    uint32_t first;                 /**< row i is vertex first + i of the mesh */
    size_t attribute_count;         /**< number of `attribute` columns */
    size_t count;                   /**< rows; must not be changed */
    const float *px, *py, *pz;      /**< position, object space */
    const float *nx, *ny, *nz;      /**< normal, object space, unit */
    const float *tx, *ty, *tz, *tw; /**< tangent, object space, and handedness; NULL if the mesh has no tangents */
    const float *u, *v;             /**< texture coordinates; 0 if the mesh has none */
    const float *u1, *v1;           /**< second set of texture coordinates; NULL if the mesh has none */
    const float *const *attribute;  /**< [attribute_count] columns of the mesh; NULL for absent ones */
    const float *object_to_world;   /**< [16], column-major; of the instance */
    const float *world_to_view;     /**< [16], column-major */
    const float *view_to_clip;      /**< [16], column-major */
    const float *eye;               /**< [3], world space */
    const void *uniforms;           /**< shd_draw.uniforms */
    /* ---- end of 0.1; append below ---- */
} shd_vertices;

/**
 * Values that a program may change, as packed columns of `count` elements.
 *
 * Each column starts with the values that the draw has without a program. A vertex whose values stay unchanged gives
 * the same bits as without a program. Triangles with a vertex that has NaN or infinity in any column are dropped;
 * shd_render_stats.nonfinite_triangle_count counts them.
 */
typedef struct shd_vertex_outputs {
    uint32_t struct_size;  /**< size of the library's struct */
    size_t varying_count;  /**< shd_material_desc.varying_count */
    float *x, *y, *z, *w;  /**< clip space: visible with -w..w for x and y, 0..w for z */
    float *px, *py, *pz;   /**< position, world space, for lighting and wo */
    float *nx, *ny, *nz;   /**< normal, world space; changed normals are normalised afterwards */
    float *u, *v;          /**< texture coordinates */
    float *const *varying; /**< [varying_count] columns that start as 0 */
    /* ---- end of 0.1; append below ---- */
} shd_vertex_outputs;

/**
 * A vertex program: reads and writes in->count rows.
 *
 * Each row must depend on its own inputs alone. Otherwise the frame depends on the grouping of vertices.
 */
typedef void (*shd_vertex_fn)(const shd_vertices *in, shd_vertex_outputs *out, void *user_data);

SHD_END_DECLS

#endif /* SHD_VERTICES_H */
