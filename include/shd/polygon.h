/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Generalised barycentric coordinates of points in polygons.
 *
 * Every kind gives each vertex i of a polygon a weight b_i at a point x, with
 * - partition of unity: the sum of all b_i is 1;
 * - linear precision: the sum of b_i v_i is x, for x inside the polygon;
 * - Lagrange property: at vertex j, b_j is 1 and all others are 0; on an edge the weights of its two vertices are
 *   linear along the edge, and all others are 0.
 *
 * With s_i = v_i - x, r_i = |s_i|, A_i the area of the triangle (x, v_i, v_i+1), C_i that of (v_i-1, v_i, v_i+1), a_i
 * the angle from s_i to s_i+1, and b_i = w_i / sum of all w_j:
 *
 * | kind              | polygons | w_i                                                        | b_i >= 0           |
 * |-------------------|----------|------------------------------------------------------------|--------------------|
 * | WACHSPRESS        | convex   | C_i / (A_i-1 A_i)                                          | yes                |
 * | MEAN_VALUE        | simple   | (tan(a_i-1 / 2) + tan(a_i / 2)) / r_i                      | in convex polygons |
 * | DISCRETE_HARMONIC | convex   | cot of the angles at v_i-1 in (x, v_i-1, v_i) and at v_i+1 | not always         |
 * |                   |          | in (x, v_i, v_i+1)                                         |                    |
 * | HARMONIC          | simple   | solution of the Laplace equation with the values on edges  | up to its error    |
 *
 * Sources: Wachspress, "A Rational Finite Element Basis" (1975), in the form of Meyer et al., "Generalized Barycentric
 * Coordinates on Irregular Polygons" (2002); Floater, "Mean Value Coordinates" (2003), and Hormann and Floater, "Mean
 * Value Coordinates for Arbitrary Planar Polygons" (2006); Pinkall and Polthier, "Computing Discrete Minimal Surfaces
 * and Their Conjugates" (1993); Joshi et al., "Harmonic Coordinates for Character Articulation" (2007).
 *
 * The weights are computed in double and rounded once. HARMONIC solves with linear elements on a Delaunay triangulation
 * of the polygon whose triangles are divided into `segments`^2 equal ones: partition of unity, linear precision and
 * the values on the edges are exact, and the error inside falls with the square of the size of an element where the
 * polygon has no reflex vertex. Next to reflex vertices it falls with a power of 2/3 or less: in an L shape,
 * coordinates of 32 segments differ from those of 256 by up to 0.05, of 64 by 0.03 and of 128 by 0.015, for 4, 12 and
 * 80 ms of one core before the first point. It needs a build with Eigen.
 *
 * Defined for all inputs: points that are not finite count as 0 in that coordinate. Points outside the polygon have the
 * weights of the nearest point of its edges, except for MEAN_VALUE, whose formula holds in the whole plane. With D the
 * distance from vertex 0 to its farthest vertex, points farther than 2^20 D from vertex 0 count as the point at this
 * distance in their direction. Where rounding leaves no finite weights, as in polygons with edges of 1 and of 1e38, the
 * weights are those of the nearest point of the edges, too. Points
 * closer to an edge than 2^-40 of the distance to its farther vertex count as points of the edge.
 *
 * Thread safety: any thread. With a context, batches of more than 16384 points are split over its executor.
 *
 * @code
 * shd_polygon_desc desc = shd_polygon_desc_default(); // fill vertex_count and vertex
 * shd_polygon_points points = shd_polygon_points_default(); // fill count and position
 * shd_polygon_weights weights = shd_polygon_weights_default();
 * desc.kind = SHD_BARYCENTRIC_MEAN_VALUE;
 * weights.weight = columns; // one column for each vertex
 * weights.weight_count = desc.vertex_count;
 * result = shd_polygon_evaluate(context, &desc, &points, &weights);
 * @endcode
 */
#ifndef SHD_POLYGON_H
#define SHD_POLYGON_H

#include <shd/column.h>
#include <shd/context.h>
#include <shd/result.h>

SHD_BEGIN_DECLS

/** Kind of generalised barycentric coordinates; the file's comment has the formulas. */
typedef enum shd_barycentric {
    SHD_BARYCENTRIC_WACHSPRESS = 0,        /**< rational functions on convex polygons */
    SHD_BARYCENTRIC_MEAN_VALUE = 1,        /**< closed form on simple polygons */
    SHD_BARYCENTRIC_DISCRETE_HARMONIC = 2, /**< cotangent weights on convex polygons */
    SHD_BARYCENTRIC_HARMONIC = 3,          /**< solution of the Laplace equation on simple polygons */
    SHD_BARYCENTRIC_MAX_ENUM = 0x7fffffff
} shd_barycentric;

/** Largest number of vertices of a polygon. */
#define SHD_MAX_POLYGON_VERTICES 256

/**
 * A polygon and the kind of its coordinates.
 *
 * The polygon is simple: its edges meet in its vertices only, where exactly two of them meet, and no edge is a point.
 * Its vertices run in either direction. Convex kinds need a turn at every vertex.
 */
typedef struct shd_polygon_desc {
    uint32_t struct_size; /**< set by shd_polygon_desc_default() */
    shd_barycentric kind; /**< default SHD_BARYCENTRIC_WACHSPRESS */
    /**
     * HARMONIC: parts of each side of a triangle, 1..256; default 32. The solution has about
     * vertex_count segments^2 / 2 nodes. Nodes times vertices are limited to 2^24.
     */
    uint32_t segments;
    shd_f32_in vertex[2]; /**< [vertex_count] x and y, finite; required */
    size_t vertex_count;  /**< 3..SHD_MAX_POLYGON_VERTICES */
    /* ---- end of 0.1; append below ---- */
} shd_polygon_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_polygon_desc shd_polygon_desc_default(void)
{
    shd_polygon_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.segments = 32;
    return desc;
}

/** Points at which coordinates are computed, as columns of `count` elements. Required: position. */
typedef struct shd_polygon_points {
    uint32_t struct_size;   /**< set by shd_polygon_points_default() */
    size_t count;           /**< number of points; 0 is allowed */
    shd_f32_in position[2]; /**< x and y; required */
    /* ---- end of 0.1; append below ---- */
} shd_polygon_points;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_polygon_points shd_polygon_points_default(void)
{
    shd_polygon_points points = SHD_ZERO_INIT;
    points.struct_size = (uint32_t)sizeof points;
    return points;
}

/** Columns for the coordinates. */
typedef struct shd_polygon_weights {
    uint32_t struct_size;      /**< set by shd_polygon_weights_default() */
    size_t weight_count;       /**< number of columns; vertex_count of the polygon */
    const shd_f32_out *weight; /**< [weight_count] b_i, one column for each vertex; NULL columns are not wanted */
    size_t outside_count;      /**< written: points outside the polygon */
    size_t nonfinite_count;    /**< written: points that are not finite */
    /* ---- end of 0.1; append below ---- */
} shd_polygon_weights;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_polygon_weights shd_polygon_weights_default(void)
{
    shd_polygon_weights weights = SHD_ZERO_INIT;
    weights.struct_size = (uint32_t)sizeof weights;
    return weights;
}

/**
 * Compute the barycentric coordinates of points.
 * @param context  its executor and allocator are used; concurrent reads. The solver of HARMONIC also uses malloc
 * @param desc     columns, borrowed for the call
 * @param points   columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @return SHD_ERROR_UNSUPPORTED for HARMONIC in a build without Eigen; SHD_ERROR_OUT_OF_MEMORY; a polygon that is too
 *         thin for the triangles of HARMONIC is SHD_ERROR_INVALID_ARGUMENT
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_polygon_evaluate(shd_context *context, const shd_polygon_desc *desc,
                                                      const shd_polygon_points *points, shd_polygon_weights *out);

SHD_END_DECLS

#endif /* SHD_POLYGON_H */
