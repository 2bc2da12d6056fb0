/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Tessellation: cutting the triangles of a mesh into smaller ones, and displacing vertices along their normals
 *        by a texture.
 *
 * Lifetime:      the result is a mesh of its own.
 * Thread safety: any thread; concurrent reads of the mesh and the texture.
 *
 * @code
 * shd_tessellation_desc desc = shd_tessellation_desc_default();
 * desc.segments = 8;
 * desc.displacement = heights, desc.amplitude = 0.05f;
 * result = shd_mesh_tessellate(context, mesh, &desc, &fine);
 * @endcode
 */
#ifndef SHD_TESSELLATE_H
#define SHD_TESSELLATE_H

#include <shd/mesh.h>
#include <shd/sampler.h>
#include <shd/texture.h>
#include <shd/view.h>

SHD_BEGIN_DECLS

/** Number of parts of an edge. */
typedef enum shd_tessellation_mode {
    SHD_TESSELLATION_MODE_UNIFORM = 0, /**< `segments` for each edge: a triangle becomes segments^2 */
    /**
     * The smallest number for which no part is longer than `edge_length`. It depends only on the positions of the
     * edge's two ends, so triangles on both sides agree and no cracks open, even where uv or normals differ.
     */
    SHD_TESSELLATION_MODE_ADAPTIVE = 1,
    SHD_TESSELLATION_MODE_MAX_ENUM = 0x7fffffff
} shd_tessellation_mode;

/**
 * Normals of a displaced mesh.
 *
 * The mean of face normals, weighted by area. Vertices that shared position and normal before displacement share the
 * mean. Seams of uv therefore stay smooth, and creases stay sharp.
 */
typedef enum shd_displaced_normals {
    /**
     * The previous normals, tilted by the slope of the heights: n - grad h, where grad h is the gradient on the faces
     * around the vertex before displacement. Coarse triangles with smooth normals keep their smooth look.
     */
    SHD_DISPLACED_NORMALS_TILTED = 0,
    SHD_DISPLACED_NORMALS_KEPT = 1,  /**< the previous normals */
    SHD_DISPLACED_NORMALS_FACES = 2, /**< the normals of the faces around the vertex after displacement */
    SHD_DISPLACED_NORMALS_MAX_ENUM = 0x7fffffff
} shd_displaced_normals;

/** Largest number of parts of an edge. */
#define SHD_MAX_TESSELLATION_SEGMENTS 1024

/** Options of tessellation and displacement. */
typedef struct shd_tessellation_desc {
    uint32_t struct_size;       /**< set by shd_tessellation_desc_default() */
    shd_tessellation_mode mode; /**< default SHD_TESSELLATION_MODE_UNIFORM */
    uint32_t segments;          /**< UNIFORM: parts of an edge, 1..SHD_MAX_TESSELLATION_SEGMENTS; default 1 */
    uint32_t
        max_segments; /**< ADAPTIVE: largest number of parts of an edge, 1..SHD_MAX_TESSELLATION_SEGMENTS; default 64 */
    float edge_length; /**< ADAPTIVE: longest part, > 0: [pixels], or [world units] if picture_width is 0; default 8 */
    uint32_t picture_width;  /**< ADAPTIVE: of the picture [pixels], up to 65536; default 0 = lengths in world units */
    uint32_t picture_height; /**< ADAPTIVE: of the picture [pixels], 1..65536 if picture_width is not 0 */
    uint32_t max_triangles;  /**< the call is refused if the result would have more, 1..2^28; default 2^24 */
    /**
     * ADAPTIVE: view for lengths in pixels. An edge counts as turned about its middle until it is perpendicular to the
     * line of sight; its length is then projected to the picture. An edge that passes the eye has max_segments parts,
     * an edge behind the eye has 1. Default: identity matrices, eye at 0.
     */
    shd_view view;
    /** Replaces `view`, as in shd_render_desc; an aspect of 0 is that of the picture. NULL = `view`. */
    const shd_camera *camera;
    float object_to_world[16];       /**< ADAPTIVE: column-major, affine, finite; default identity */
    const shd_texture *displacement; /**< channel r is the height; borrowed for the call; NULL = no displacement */
    const shd_sampler *sampler;    /**< sampler of `displacement`; borrowed for the call; NULL = the default sampler */
    float lod;                     /**< level of detail of the lookups, log2 of base texels, -32..32; default 0 */
    float amplitude;               /**< factor of heights [object units], -1e12..1e12; default 0 = no displacement */
    float offset;                  /**< height that is not displaced, -1e12..1e12; default 0 */
    shd_displaced_normals normals; /**< used with displacement; default SHD_DISPLACED_NORMALS_TILTED */
    /* ---- end of 0.1; append below ---- */
} shd_tessellation_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_tessellation_desc shd_tessellation_desc_default(void)
{
    shd_tessellation_desc desc = SHD_ZERO_INIT;
    int i;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.segments = 1;
    desc.max_segments = 64;
    desc.edge_length = 8.0f;
    desc.max_triangles = (uint32_t)1 << 24;
    for (i = 0; i < 16; i += 5) {
        desc.object_to_world[i] = desc.view.world_to_view[i] = desc.view.view_to_clip[i] = 1.0f;
    }
    return desc;
}

/**
 * Make a mesh of smaller triangles.
 *
 * Triangles follow the order of the original triangles. The vertices of `mesh` come first and keep their numbers and
 * columns, except that -0 becomes 0; vertices on edges and inside triangles follow. Every column is interpolated
 * linearly, normals and tangents are normalised, and handedness is the sign of the interpolated value. A triangle whose
 * edges have different numbers of parts is cut into rows across its two most finely cut edges. Parts meet at vertices
 * only, so a closed mesh stays closed.
 *
 * Displacement moves a vertex along its unit normal by amplitude * (texel - offset), with the texel at its uv. A height
 * that is not finite, or moves a vertex beyond the range of float, counts as 0. Vertices at one position move together
 * by the mean of their displacements, so seams of uv and creases stay closed. A sheet whose two sides are faces at the
 * same positions therefore does not move. Tangents are projected into the planes of the new normals. Heights are looked
 * up only at the vertices: if parts are longer than two texels of level `lod`, texels between vertices have no effect.
 *
 * If the result would have more than max_triangles, the call is refused before it allocates memory, and the error text
 * names the field. In ADAPTIVE mode an edge with an end that is not finite has 1 part. The info of the new mesh has the
 * normalless_count, tangentless_count and split_count of `mesh`.
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
