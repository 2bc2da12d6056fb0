/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Edges of a mesh that a line drawing shows: silhouettes, creases and borders.
 *
 * After Gooch, Gooch, Shirley and Cohen, "A Non-Photorealistic Lighting Model for Automatic Technical Illustration"
 * (1998). Frames draw them as lines with SHD_FILL_LINES (shd/render.h); here they come as columns.
 *
 * Corners of triangles at the same place are one, so that seams of uv and normals are no borders. Triangles without
 * area, and those with a corner that is not finite, do not count.
 *
 * Thread safety: any thread.
 */
#ifndef SHD_EDGES_H
#define SHD_EDGES_H

#include <shd/column.h>
#include <shd/mesh.h>

SHD_BEGIN_DECLS

/**
 * Kinds of edges; combine with |. An edge of two triangles may be both SILHOUETTE and CREASE. Where both run along it
 * the same way, as somewhere on a Moebius strip, the second one counts as turned over.
 */
typedef enum shd_edge_kind {
    SHD_EDGE_NONE = 0,
    /**
     * Between two triangles of which the eye e is before one and not before the other: f0(e) f1(e) <= 0 with
     * f(e) = (e - p) . n, p a corner of the triangle and n its normal.
     */
    SHD_EDGE_SILHOUETTE = 1,
    SHD_EDGE_CREASE = 2,      /**< between two triangles with unit normals n0 . n1 <= crease_cosine, in object space */
    SHD_EDGE_BORDER = 4,      /**< of one triangle */
    SHD_EDGE_NONMANIFOLD = 8, /**< of three triangles or more */
    SHD_EDGE_ALL = 15,        /**< every one of them */
    SHD_EDGE_KIND_MAX_ENUM = 0x7fffffff
} shd_edge_kind;

/** Which edges to find. */
typedef struct shd_edges_desc {
    uint32_t struct_size; /**< set by shd_edges_desc_default() */
    uint32_t kinds;       /**< shd_edge_kind bits; default SHD_EDGE_ALL */
    /**
     * Object space, finite: the point (x, y, z) with w = 1, the direction to an eye far away with w = 0; any (x, y, z,
     * w) but 0 is the point (x, y, z) / w. Default (0, 0, 1, 0).
     */
    float eye[4];
    float crease_cosine; /**< -1..1; default 0.5: edges of 60 degrees and sharper */
    uint32_t reserved;   /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_edges_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_edges_desc shd_edges_desc_default(void)
{
    shd_edges_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.kinds = SHD_EDGE_ALL;
    desc.eye[2] = 1.0f;
    desc.crease_cosine = 0.5f;
    return desc;
}

/** Columns that edges are written to, those wanted. */
typedef struct shd_edges {
    shd_u32_out vertex[2];   /**< its ends, as the first of its triangles has them */
    shd_u32_out triangle[2]; /**< that triangle, and the other one; 0xffffffff for a border and a non-manifold edge */
    shd_u32_out kinds;       /**< shd_edge_kind bits, of those asked for */
} shd_edges;

/**
 * Find the edges of a mesh that are of one of the kinds, each once, in the order of their first triangles. The same
 * bits on every machine.
 * @param mesh       made with SHD_MESH_ADJACENCY
 * @param desc       borrowed for the call
 * @param capacity   elements of the columns; 0 to count edges
 * @param out        the first `capacity` edges; may be NULL if that is 0
 * @param out_count  how many edges there are, which may be more than `capacity`; 0 on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_find_edges(const shd_mesh *mesh, const shd_edges_desc *desc, size_t capacity,
                                                     const shd_edges *out, size_t *out_count);

SHD_END_DECLS

#endif /* SHD_EDGES_H */
