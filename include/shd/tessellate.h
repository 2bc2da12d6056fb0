/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Meshes cut into smaller triangles, and moved along their normals by a texture.
 *
 * Lifetime:      the mesh that comes out is a mesh of its own.
 * Thread safety: any thread; concurrent reads of the mesh and the texture that go in.
 */
#ifndef SHD_TESSELLATE_H
#define SHD_TESSELLATE_H

#include <shd/mesh.h>
#include <shd/sampler.h>
#include <shd/texture.h>
#include <shd/view.h>

SHD_BEGIN_DECLS

/** How many parts an edge is cut into. */
typedef enum shd_tessellation_mode {
    SHD_TESSELLATION_UNIFORM = 0, /**< `segments` for each edge, so that a triangle becomes segments^2 */
    /**
     * As many as bring the parts to `edge_length`: a function of the positions of the edge's two ends alone, so that
     * triangles on both sides agree and no cracks open, wherever uv or normals differ.
     */
    SHD_TESSELLATION_ADAPTIVE = 1,
    SHD_TESSELLATION_MODE_MAX_ENUM = 0x7fffffff
} shd_tessellation_mode;

/**
 * Normals of a displaced mesh. Faces count by area, over the vertices that shared position and normal before they were
 * moved, so that seams of uv stay smooth and creases stay creases.
 */
typedef enum shd_displaced_normals {
    /**
     * The normals there were, tilted by the slope of the heights: n - grad h, with the gradient on the faces around
     * before they were moved. Coarse triangles with smooth normals do not show.
     */
    SHD_DISPLACED_NORMALS_TILTED = 0,
    SHD_DISPLACED_NORMALS_KEPT = 1,  /**< as they were */
    SHD_DISPLACED_NORMALS_FACES = 2, /**< those of the faces around after they were moved */
    SHD_DISPLACED_NORMALS_MAX_ENUM = 0x7fffffff
} shd_displaced_normals;

/** Limits of tessellation. */
enum {
    SHD_MAX_SEGMENTS = 1024 /**< parts of one edge */
};

/** How a mesh is cut and moved. */
typedef struct shd_tessellation_desc {
    uint32_t struct_size;          /**< set by shd_tessellation_desc_default() */
    shd_tessellation_mode mode;    /**< default uniform */
    uint32_t segments;             /**< UNIFORM: parts of an edge, 1..SHD_MAX_SEGMENTS; default 1 */
    uint32_t max_segments;         /**< ADAPTIVE: no more of them, 1..SHD_MAX_SEGMENTS; default 64 */
    float edge_length;             /**< ADAPTIVE: longest part [pixels], without `view` [world units]; > 0; default 8 */
    uint32_t width;                /**< ADAPTIVE with `view`: of the picture, 1..65536; default 1024 */
    uint32_t height;               /**< ADAPTIVE with `view`: of the picture, 1..65536; default 1024 */
    shd_displaced_normals normals; /**< default tilted; used where displacement takes place */
    /**
     * ADAPTIVE: the size of an edge in the picture is that of a line of its length across the line of sight at its
     * middle; one that passes the eye has max_segments, one behind it 1. Borrowed for the call; NULL = world units.
     */
    const shd_view *view;
    const float *object_to_world;    /**< ADAPTIVE: [16], column-major; borrowed for the call; NULL = identity */
    const shd_texture *displacement; /**< channel r is the height; borrowed for the call; NULL = nothing moves */
    const shd_sampler *sampler;      /**< of `displacement`; borrowed for the call; NULL = the default sampler */
    size_t max_triangles;            /**< refused if there would be more; 1..2^28; default 2^24 */
    float amplitude;                 /**< [object units], -1e12..1e12; 0 = nothing moves; default 0 */
    float offset;                    /**< height that stays where it is, -1e12..1e12; default 0 */
    float lod;                       /**< of the lookups, log2 of base texels, -32..32; default 0 */
    uint32_t reserved;               /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_tessellation_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_tessellation_desc shd_tessellation_desc_default(void)
{
    shd_tessellation_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.segments = 1;
    desc.max_segments = 64;
    desc.edge_length = 8.0f;
    desc.width = 1024;
    desc.height = 1024;
    desc.max_triangles = (size_t)1 << 24;
    return desc;
}

/**
 * A mesh of smaller triangles on those of `mesh`. Triangles come in the order of those that they are parts of. The
 * vertices of `mesh` come first, with their numbers and columns; those on edges and inside follow, every column
 * interpolated linearly, normals and tangents made unit again, handedness its sign. Where the edges of a triangle have
 * different numbers of parts, it is cut into rows across its two most finely cut edges. Parts meet at vertices only, so
 * that a closed mesh stays closed.
 *
 * Displacement moves a vertex along its unit normal by amplitude * (texel - offset), with the texel at its uv; a height
 * that is not finite, or moves it beyond the range of float, counts as 0. Vertices at one position move together, by
 * the mean of what each would move by, so that seams of uv and creases stay closed; a sheet whose two sides are faces
 * at the same positions does not move. Tangents are laid into the plane of the new normals. Heights are looked up at
 * the vertices alone: parts longer than two texels of the level `lod` skip some.
 *
 * Refused with the field named, before anything is allocated: more than max_triangles. An edge with an end that is not
 * finite has 1 part in ADAPTIVE mode. normalless_count, tangentless_count and split_count of the new mesh's info are
 * those of `mesh`.
 * @param context   retained by the new mesh
 * @param mesh      concurrent reads
 * @param desc      borrowed for the call
 * @param out_mesh  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_tessellate(shd_context *context, const shd_mesh *mesh,
                                                     const shd_tessellation_desc *desc, shd_mesh **out_mesh);

SHD_END_DECLS

#endif /* SHD_TESSELLATE_H */
