/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Draws: a mesh with its material and its place in the world, for frames, shadow maps, bakes and occlusion.
 *
 * A frame reads all fields of a draw. Shadow maps, bakes, occlusion and libshd_embree document the fields that they
 * read.
 *
 * Thread safety: plain data.
 *
 * @code
 * shd_draw draw = shd_draw_default();
 * draw.mesh = mesh, draw.material = material;
 * draw.object_to_world[12] = 1.0f; // moved by 1 along x
 * desc.draws = &draw, desc.draw_count = 1;
 * @endcode
 */
#ifndef SHD_DRAW_H
#define SHD_DRAW_H

#include <shd/edges.h>
#include <shd/material.h>
#include <shd/mesh.h>

SHD_BEGIN_DECLS

/** Points at which the reflectance model is evaluated. Textures are looked up per fragment at every frequency. */
typedef enum shd_frequency {
    SHD_FREQUENCY_PHONG = 0,   /**< per fragment, with interpolated and renormalised normals (Phong 1975) */
    SHD_FREQUENCY_GOURAUD = 1, /**< per vertex, colours interpolated (Gouraud 1971) */
    SHD_FREQUENCY_FLAT = 2,    /**< once per triangle, with the face normal at the centroid */
    SHD_FREQUENCY_MAX_ENUM = 0x7fffffff
} shd_frequency;

/** Triangles that are skipped; front = counter-clockwise on the screen, seen with y up. */
typedef enum shd_cull {
    SHD_CULL_NONE = 0,
    SHD_CULL_BACK = 1,
    SHD_CULL_FRONT = 2,
    SHD_CULL_MAX_ENUM = 0x7fffffff
} shd_cull;

/** Options of a draw; combine with |. */
typedef enum shd_draw_flag {
    SHD_DRAW_NONE = 0,
    SHD_DRAW_KEEP_DEPTH = 1,     /**< test depth without writing it */
    SHD_DRAW_SAMPLE_SHADING = 2, /**< shade every sample at its own position, instead of every pixel once */
    /**
     * Interpolate attributes linearly on the screen, between the projected vertices (X / W, Y / W) of the unclipped
     * triangle, instead of linearly on the triangle. A fragment then shows another point of its triangle: position,
     * normal, texture coordinates, tangent, attributes of the mesh, barycentric coordinates, perspective varyings and
     * derivatives are those of this point. Coverage and depth do not change. Triangles of one W have the same values
     * either way, and triangles with a vertex of W < 2^-100 or |X| or |Y| > 2^60 W, such as one behind the eye, have
     * those without this flag. Textures swim, as on consoles without a division for each pixel (PlayStation 1): only
     * teaching and such looks need this flag. No effect on bakes and shadow maps.
     */
    SHD_DRAW_AFFINE = 4,
    SHD_DRAW_FLAG_MAX_ENUM = 0x7fffffff
} shd_draw_flag;
typedef uint32_t shd_draw_flags; /**< shd_draw_flag bits */

/** Parts of a triangle that are drawn. */
typedef enum shd_fill {
    SHD_FILL_SOLID = 0,
    SHD_FILL_WIREFRAME = 1, /**< its three edges */
    SHD_FILL_POINTS = 2,    /**< its three vertices */
    SHD_FILL_LINES = 3,     /**< its edges of the kinds in shd_draw.edges; for meshes with SHD_MESH_ADJACENCY */
    SHD_FILL_MAX_ENUM = 0x7fffffff
} shd_fill;

/**
 * One mesh in the frame. Required: mesh.
 *
 * Lines are rectangles around the edge, as long as the edge, with square ends (OpenGL 4.6 core specification,
 * 14.5, antialiased lines). Points are squares around the vertices. Both lie on the grid of 8 subpixel bits and cover
 * samples as triangles do, so a line or point narrower than 1 may fall between samples. Depth varies along a line and
 * is constant across it; a point has the depth of its vertex. depth_bias_slope uses these depths instead of the
 * triangle's. Attributes are interpolated at the pixel, with barycentric coordinates clamped to the triangle, and
 * texture coordinates clamped to those of its vertices; a triangle without area gives the mean of its corners.
 *
 * Culling drops all lines and points of a triangle. A triangle without area is dropped if `cull` is not NONE. Clipping
 * at the near and far plane adds no edges. A vertex beyond these planes has no point, and an edge without length has no
 * line. A shared edge or vertex is drawn once by each of its triangles, with the same samples and depths.
 * SHD_COMPARE_LESS therefore shows it once, but with SHD_DRAW_KEEP_DEPTH a blend is applied several times.
 *
 * SHD_FILL_LINES draws each edge of the mesh once, for triangles facing either way: `cull` has no effect. The edge
 * belongs to its first triangle: this triangle's vertices shade it, and it is ordered and counted with this triangle.
 * Silhouettes are found for the centre of projection of world_to_view and view_to_clip (view.eye, if a camera made the
 * view), or for the direction of a parallel projection. They depend on object_to_world and the positions of the mesh;
 * vertex programs have no effect on them.
 *
 * A drawing without hidden lines takes two draws. The first draws the mesh as usual (without a material, if only lines
 * shall be visible), with depth_bias 1e-5 and depth_bias_slope fill_width / 2 + 1. This bias moves the surface behind
 * the lines that lie on its front. The second draws the lines with SHD_COMPARE_LESS_EQUAL. Lines over everything use
 * SHD_COMPARE_ALWAYS.
 */
typedef struct shd_draw {
    uint32_t struct_size;         /**< set by shd_draw_default(); the same in every element of the array */
    const shd_mesh *mesh;         /**< required; borrowed for the call */
    const shd_material *material; /**< borrowed for the call; NULL = draw depth only, without programs */
    const void *uniforms;         /**< passed to the programs of the material; borrowed for the call; default NULL */
    float object_to_world[16];    /**< affine, finite; default identity */
    /**
     * Object-to-world matrices, [instance_count][16], each affine and finite, instead of object_to_world. The mesh is
     * drawn with each of them as if by separate draws, in order. Borrowed for the call.
     */
    const float *instances;
    size_t instance_count;   /**< all draws together up to 2^20; default 0 = once, with object_to_world */
    shd_frequency frequency; /**< default SHD_FREQUENCY_PHONG */
    shd_draw_flags flags;    /**< default none */
    shd_cull cull;           /**< default SHD_CULL_NONE */
    shd_compare compare;     /**< default SHD_COMPARE_LESS */
    float depth_bias;        /**< added to depth, -1..1; the sum is clamped to 0..1; default 0 */
    /** Factor of another bias: the larger of |dz/dx| and |dz/dy| per pixel; finite; default 0. */
    float depth_bias_slope;
    shd_fill fill;        /**< default SHD_FILL_SOLID */
    float fill_width;     /**< width of lines and points [pixels], 1/16..64; default 1 */
    shd_edge_flags edges; /**< edges of SHD_FILL_LINES; default SHD_EDGE_ALL */
    float crease_cosine;  /**< threshold of SHD_EDGE_CREASE, as in shd_edges_desc: -1..1; default 0.5 */
    /* ---- end of 0.1; append below ---- */
} shd_draw;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_draw shd_draw_default(void)
{
    shd_draw draw = SHD_ZERO_INIT;
    draw.struct_size = (uint32_t)sizeof draw;
    draw.object_to_world[0] = draw.object_to_world[5] = 1.0f;
    draw.object_to_world[10] = draw.object_to_world[15] = 1.0f;
    draw.fill_width = 1.0f;
    draw.edges = SHD_EDGE_ALL;
    draw.crease_cosine = 0.5f;
    return draw;
}

SHD_END_DECLS

#endif /* SHD_DRAW_H */
