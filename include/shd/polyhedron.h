/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Generalised barycentric coordinates of points in polyhedra: closed triangle meshes, as cages.
 *
 * A polyhedron gives each of its vertices i a weight b_i at a point x, with
 * - partition of unity: the sum of all b_i is 1;
 * - linear precision: the sum of b_i v_i is x;
 * - Lagrange property: at vertex j, b_j is 1 and all others are 0; on a face, only its vertices have weights.
 *
 * Values of the vertices, as colours or the positions of a moved cage, are thus interpolated in the whole space. With
 * s_i = v_i - x, r_i = |s_i| and b_i = w_i / sum of all w_j:
 *
 * | kind       | polyhedra            | w_i, summed over the triangles at the vertex                  | b_i >= 0     |
 * |------------|----------------------|---------------------------------------------------------------|--------------|
 * | WACHSPRESS | convex               | det(n_0, n_j, n_j+1) / (h_0 h_j h_j+1), with the outward unit | yes          |
 * |            |                      | normals n_j of its faces in order, and their distances h_j    |              |
 * | MEAN_VALUE | closed, any topology | (m . N_i) / (s_i . N_i), with N_i = s_k x s_l of the other    | in convex    |
 * |            |                      | corners k, l, m = half the sum of angle(s_k, s_l) N_i / |N_i| | polyhedra    |
 *
 * Sources: Warren, "Barycentric Coordinates for Convex Polytopes" (1996), in the form of Ju, Schaefer, Warren and
 * Desbrun, "A Geometric Construction of Coordinates for Convex Polyhedra Using Polar Duals" (2005); Ju, Schaefer and
 * Warren, "Mean Value Coordinates for Closed Triangular Meshes" (2005), in the vector form of Floater, Kos and Reimers,
 * "Mean Value Coordinates in 3D" (2005).
 *
 * Faces of WACHSPRESS are the largest flat parts of the surface: a cube of 12 triangles has 6 faces. Vertices may lie
 * 2^-21 of half the longest side of the bounding box beside the plane of their face.
 *
 * Results have the same bits on every SIMD target, for every number of workers and every split of a batch. WACHSPRESS
 * is computed in double and rounded once. MEAN_VALUE is computed in float where this is sufficient, otherwise in
 * double. The weights differ from the exact ones by at most 4e-6, and the point that they reproduce differs from x by
 * at most 2.4e-7 of the longest side of the bounding box along each axis. Floats are sufficient for points inside that
 * are not close to the plane of a triangle, within about 2^-9 of half the longest side, or to an edge.
 *
 * Defined for all inputs: points that are not finite count as 0 in that coordinate. Points outside have the weights of
 * the nearest point of the surface with WACHSPRESS. The formula of MEAN_VALUE holds in the whole space; its weights
 * grow with the distance. Points farther from the centre of the bounding box than 2^8 times its longest side count as
 * the point at this distance in their direction. With MEAN_VALUE, points closer to an edge than 2^-26 of the distance
 * to its farther vertex count as points of the edge, and points closer to a triangle than 2^-26 of the distance to its
 * nearest edge as points of the triangle.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a polyhedron never changes, so concurrent reads are allowed. Batches
 *                are split over the executor of its context.
 *
 * @code
 * shd_polyhedron_desc desc = shd_polyhedron_desc_default(); // fill counts, position and indices
 * shd_polyhedron_points points = shd_polyhedron_points_default(); // fill count and position
 * shd_polyhedron_values values = shd_polyhedron_values_default();
 * result = shd_polyhedron_create(context, &desc, &cage);
 * values.vertex_value = moved; // x, y and z of the moved vertices
 * values.value = deformed;     // x, y and z of the moved points
 * values.value_count = 3;
 * result = shd_polyhedron_interpolate(cage, &points, &values);
 * @endcode
 */
#ifndef SHD_POLYHEDRON_H
#define SHD_POLYHEDRON_H

#include <shd/column.h>
#include <shd/context.h>
#include <shd/polygon.h>
#include <shd/result.h>

SHD_BEGIN_DECLS

/** Largest number of vertices of a polyhedron. */
#define SHD_MAX_POLYHEDRON_VERTICES 4096

/** Largest number of triangles of a polyhedron. */
#define SHD_MAX_POLYHEDRON_TRIANGLES 8192

/** Largest number of values of a vertex in one call. */
#define SHD_MAX_POLYHEDRON_VALUES 64

/** A closed triangle mesh with the kind of its coordinates. */
typedef struct shd_polyhedron shd_polyhedron;

/**
 * Vertices and triangles of a polyhedron. Required: position, indices.
 *
 * The mesh is closed: each edge lies in two triangles, which run along it in opposite directions, and each vertex lies
 * in a triangle. All triangles are counter-clockwise from outside, or all clockwise. They have an area, and enclose a
 * volume. The mesh may have several parts and handles. It is not checked for triangles that intersect.
 */
typedef struct shd_polyhedron_desc {
    uint32_t struct_size;   /**< set by shd_polyhedron_desc_default() */
    shd_barycentric kind;   /**< WACHSPRESS or MEAN_VALUE; default SHD_BARYCENTRIC_MEAN_VALUE */
    size_t vertex_count;    /**< 4..SHD_MAX_POLYHEDRON_VERTICES */
    size_t index_count;     /**< a multiple of 3, 12..3 * SHD_MAX_POLYHEDRON_TRIANGLES */
    shd_f32_in position[3]; /**< [vertex_count] x, y and z, finite; required */
    shd_u32_in indices;     /**< [index_count] vertex numbers, three for each triangle; required */
    /* ---- end of 0.1; append below ---- */
} shd_polyhedron_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_polyhedron_desc shd_polyhedron_desc_default(void)
{
    shd_polyhedron_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.kind = SHD_BARYCENTRIC_MEAN_VALUE;
    return desc;
}

/**
 * Copy and check vertices and triangles.
 * @param context         retained
 * @param desc            columns, borrowed for the call
 * @param out_polyhedron  owned; NULL on failure
 * @return SHD_ERROR_INVALID_ARGUMENT names the vertex, edge or triangle that breaks a rule; SHD_ERROR_OUT_OF_MEMORY
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_polyhedron_create(shd_context *context, const shd_polyhedron_desc *desc,
                                                       shd_polyhedron **out_polyhedron);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_polyhedron_retain(shd_polyhedron *polyhedron);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_polyhedron_release(shd_polyhedron *polyhedron);

/** Points at which coordinates are computed, as columns of `count` elements. Required: position. */
typedef struct shd_polyhedron_points {
    uint32_t struct_size;   /**< set by shd_polyhedron_points_default() */
    size_t count;           /**< number of points; 0 is allowed */
    shd_f32_in position[3]; /**< x, y and z; required */
    /* ---- end of 0.1; append below ---- */
} shd_polyhedron_points;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_polyhedron_points shd_polyhedron_points_default(void)
{
    shd_polyhedron_points points = SHD_ZERO_INIT;
    points.struct_size = (uint32_t)sizeof points;
    return points;
}

/** Columns for the coordinates. Required: weight. */
typedef struct shd_polyhedron_weights {
    uint32_t struct_size;      /**< set by shd_polyhedron_weights_default() */
    size_t weight_count;       /**< number of columns; vertex_count of the polyhedron */
    const shd_f32_out *weight; /**< [weight_count] b_i, one column for each vertex; NULL columns are not wanted */
    size_t outside_count;      /**< written: points outside the polyhedron */
    size_t nonfinite_count;    /**< written: points that are not finite */
    /* ---- end of 0.1; append below ---- */
} shd_polyhedron_weights;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_polyhedron_weights shd_polyhedron_weights_default(void)
{
    shd_polyhedron_weights weights = SHD_ZERO_INIT;
    weights.struct_size = (uint32_t)sizeof weights;
    return weights;
}

/**
 * Compute the barycentric coordinates of points.
 * @param polyhedron  concurrent reads
 * @param points      columns, borrowed for the call
 * @param out         columns, borrowed for the call; must not overlap any input or each other (checked)
 * @return SHD_ERROR_INVALID_ARGUMENT; SHD_ERROR_OUT_OF_MEMORY
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_polyhedron_evaluate(const shd_polyhedron *polyhedron,
                                                         const shd_polyhedron_points *points,
                                                         shd_polyhedron_weights *out);

/** Values of the vertices, and columns for their sums with the coordinates as weights. Required: all columns. */
typedef struct shd_polyhedron_values {
    uint32_t struct_size; /**< set by shd_polyhedron_values_default() */
    size_t value_count;   /**< values of a vertex, 1..SHD_MAX_POLYHEDRON_VALUES */
    const shd_f32_in
        *vertex_value;        /**< [value_count] columns of as many elements as the polyhedron has vertices, finite */
    const shd_f32_out *value; /**< [value_count] columns for the sums of b_i vertex_value_i */
    size_t outside_count;     /**< written: points outside the polyhedron */
    size_t nonfinite_count;   /**< written: points that are not finite */
    /* ---- end of 0.1; append below ---- */
} shd_polyhedron_values;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_polyhedron_values shd_polyhedron_values_default(void)
{
    shd_polyhedron_values values = SHD_ZERO_INIT;
    values.struct_size = (uint32_t)sizeof values;
    return values;
}

/**
 * Interpolate values of the vertices at points, without storing the coordinates.
 * @param polyhedron  concurrent reads
 * @param points      columns, borrowed for the call
 * @param out         columns, borrowed for the call; outputs must not overlap any input or each other (checked)
 * @return SHD_ERROR_INVALID_ARGUMENT; SHD_ERROR_OUT_OF_MEMORY
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_polyhedron_interpolate(const shd_polyhedron *polyhedron,
                                                            const shd_polyhedron_points *points,
                                                            shd_polyhedron_values *out);

SHD_END_DECLS

#endif /* SHD_POLYHEDRON_H */
