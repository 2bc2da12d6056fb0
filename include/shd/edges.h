/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Edges of a mesh for line drawings: silhouettes, creases and borders.
 *
 * After Gooch, Gooch, Shirley and Cohen, "A Non-Photorealistic Lighting Model for Automatic Technical Illustration"
 * (1998). Frames draw these edges as lines with SHD_FILL_LINES (shd/render.h); shd_mesh_find_edges() returns them as
 * columns.
 *
 * Corners of triangles at the same position count as one vertex, so seams of uv and normals are not borders. Triangles
 * without area or with a corner that is not finite are ignored.
 *
 * Thread safety: any thread.
 *
 * @code
 * size_t count = 0;
 * shd_edges_desc desc = shd_edges_desc_default();
 * shd_edges edges = shd_edges_default();
 * edges.vertex[0] = shd_u32_out_column(from, 0), edges.vertex[1] = shd_u32_out_column(to, 0);
 * result = shd_mesh_find_edges(mesh, &desc, capacity, &edges, &count);
 * @endcode
 */
#ifndef SHD_EDGES_H
#define SHD_EDGES_H

#include <shd/column.h>
#include <shd/mesh.h>

SHD_BEGIN_DECLS

/**
 * Kinds of edges; combine with |.
 *
 * An edge of two triangles may be both SILHOUETTE and CREASE. Where both triangles run along it in the same direction,
 * as on a Moebius strip, the second triangle counts as flipped.
 */
typedef enum shd_edge {
    SHD_EDGE_NONE = 0,
    /**
     * Between two triangles of which one faces the eye e and the other does not: f0(e) f1(e) <= 0 with
     * f(e) = (e - p) . n, p a corner of the triangle and n its normal.
     */
    SHD_EDGE_SILHOUETTE = 1,
    SHD_EDGE_CREASE = 2,      /**< between two triangles with unit normals n0 . n1 <= crease_cosine, in object space */
    SHD_EDGE_BORDER = 4,      /**< an edge of one triangle */
    SHD_EDGE_NONMANIFOLD = 8, /**< an edge of three triangles or more */
    SHD_EDGE_ALL = 15,        /**< all kinds */
    SHD_EDGE_MAX_ENUM = 0x7fffffff
} shd_edge;
typedef uint32_t shd_edge_flags; /**< shd_edge bits */

/** Edges to find. */
typedef struct shd_edges_desc {
    uint32_t struct_size; /**< set by shd_edges_desc_default() */
    shd_edge_flags edges; /**< kinds to find; default SHD_EDGE_ALL */
    /**
     * Eye in object space, finite: the point (x, y, z) with w = 1, or with w = 0 the direction to an eye at infinity.
     * Any other (x, y, z, w) except 0 is the point (x, y, z) / w. Default (0, 0, 1, 0).
     */
    float eye[4];
    float crease_cosine; /**< -1..1; default 0.5: edges of 60 degrees and sharper */
    /* ---- end of 0.1; append below ---- */
} shd_edges_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_edges_desc shd_edges_desc_default(void)
{
    shd_edges_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.edges = SHD_EDGE_ALL;
    desc.eye[2] = 1.0f;
    desc.crease_cosine = 0.5f;
    return desc;
}

/** Columns for edges; NULL = not wanted. */
typedef struct shd_edges {
    uint32_t struct_size;  /**< set by shd_edges_default() */
    shd_u32_out vertex[2]; /**< the two ends, in the direction of the first triangle */
    shd_u32_out
        triangle[2];   /**< the first triangle, and the other one; 0xffffffff for borders and non-manifold edges */
    shd_u32_out kinds; /**< shd_edge bits, among the requested ones */
    /* ---- end of 0.1; append below ---- */
} shd_edges;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_edges shd_edges_default(void)
{
    shd_edges edges = SHD_ZERO_INIT;
    edges.struct_size = (uint32_t)sizeof edges;
    return edges;
}

/**
 * Find all edges of the requested kinds in a mesh. Each edge is listed once, in the order of the edges' first
 * triangles.
 *
 * The result has the same bits on every machine.
 * @param mesh       made with SHD_MESH_ADJACENCY
 * @param desc       borrowed for the call
 * @param capacity   elements of the columns; 0 to count edges
 * @param out        gets the first `capacity` edges; may be NULL if capacity is 0
 * @param out_count  number of edges found, which may exceed `capacity`; 0 on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_find_edges(const shd_mesh *mesh, const shd_edges_desc *desc, size_t capacity,
                                                     const shd_edges *out, size_t *out_count);

SHD_END_DECLS

#endif /* SHD_EDGES_H */
