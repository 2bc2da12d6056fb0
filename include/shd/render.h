/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Whole frames: one call takes everything it needs.
 *
 * Triangles cover the samples that they contain, with 8 subpixel bits and the top-left rule: the centre of a
 * pixel, or the standard positions of 2, 4, 8 or 16 samples; attributes are perspective-correct with analytic
 * derivatives. Draws take effect in their order, but for the order-independent blends, which come last, and for frames
 * that are painted from far to near. The frame has the same bits for any executor, worker count and SIMD target.
 *
 * Thread safety: one thread at a time per framebuffer; meshes, materials, lights and textures may be shared
 * between concurrent renders.
 */
#ifndef SHD_RENDER_H
#define SHD_RENDER_H

#include <shd/edges.h>
#include <shd/framebuffer.h>
#include <shd/light.h>
#include <shd/material.h>
#include <shd/mesh.h>
#include <shd/view.h>

SHD_BEGIN_DECLS

struct shd_shadow; /* shd/shadow.h */

/** How often the reflectance model runs. Textures are looked up per fragment in every case. */
typedef enum shd_frequency {
    SHD_FREQUENCY_PHONG = 0,   /**< per fragment, with interpolated and renormalised normals (Phong 1975) */
    SHD_FREQUENCY_GOURAUD = 1, /**< per vertex, colours interpolated (Gouraud 1971) */
    SHD_FREQUENCY_FLAT = 2,    /**< once per triangle, with the face normal at the centroid */
    SHD_FREQUENCY_MAX_ENUM = 0x7fffffff
} shd_frequency;

/** Which triangles are skipped; front = counter-clockwise on the screen, seen with y up. */
typedef enum shd_cull {
    SHD_CULL_NONE = 0,
    SHD_CULL_BACK = 1,
    SHD_CULL_FRONT = 2,
    SHD_CULL_MAX_ENUM = 0x7fffffff
} shd_cull;

/** Which depths z pass against the depth d that a sample has. NaN passes nowhere. */
typedef enum shd_compare {
    SHD_COMPARE_LESS = 0,          /**< z < d */
    SHD_COMPARE_LESS_EQUAL = 1,    /**< z <= d */
    SHD_COMPARE_EQUAL = 2,         /**< z = d */
    SHD_COMPARE_GREATER_EQUAL = 3, /**< z >= d */
    SHD_COMPARE_GREATER = 4,       /**< z > d, for depth that falls with the distance (clear_depth 0) */
    SHD_COMPARE_NOT_EQUAL = 5,     /**< z != d */
    SHD_COMPARE_ALWAYS = 6,        /**< every z */
    SHD_COMPARE_NEVER = 7,         /**< none */
    SHD_COMPARE_MAX_ENUM = 0x7fffffff
} shd_compare;

/** Switches of a draw; combine with |. */
typedef enum shd_draw_flag {
    SHD_DRAW_NONE = 0,
    SHD_DRAW_KEEP_DEPTH = 1,     /**< test depth without writing it */
    SHD_DRAW_SAMPLE_SHADING = 2, /**< shade every sample at its own place, not every pixel once */
    SHD_DRAW_FLAG_MAX_ENUM = 0x7fffffff
} shd_draw_flag;

/** What of a triangle is drawn. */
typedef enum shd_fill {
    SHD_FILL_SOLID = 0,
    SHD_FILL_WIREFRAME = 1, /**< its three edges */
    SHD_FILL_POINTS = 2,    /**< its three vertices */
    SHD_FILL_LINES = 3,     /**< those of its edges that shd_draw.edges names, of a mesh with SHD_MESH_ADJACENCY */
    SHD_FILL_MAX_ENUM = 0x7fffffff
} shd_fill;

/**
 * One mesh in the frame.
 *
 * Its lines are rectangles with the edge as their middle, square at its ends and not longer (OpenGL 4.6 core
 * specification, 14.5, antialiased lines), its points squares around the vertices, both on the grid of 8 subpixel bits
 * and covered as triangles are: a width below 1 may fall between samples. Depth runs along a line and does not change
 * across it; a point has that of its vertex. depth_bias_slope goes by these depths, not by the triangle's. Attributes
 * are those of the triangle at the pixel, held inside it; without area, their mean. A triangle that faces the culled
 * way goes as a whole, and one without area goes if either way is culled. Edges are cut at the near and far plane,
 * which adds none; a vertex beyond has no point, an edge without length no line. What triangles share each of them
 * draws: the same samples at the same depths, so that SHD_COMPARE_LESS shows it once, but a blend that keeps depth adds
 * up.
 *
 * SHD_FILL_LINES draws each edge of the mesh once, whichever way its triangles face: `cull` does not apply. It goes
 * with the first of its triangles, by whose vertices it is drawn and shaded and in whose place it is counted.
 * Silhouettes are those seen from the point that world_to_view and view_to_clip together show nowhere, which with a
 * camera is view.eye, or without perspective from the direction that they show nowhere; by object_to_world and the
 * mesh's own positions, whatever a vertex program makes of them. A drawing without hidden lines takes two draws: the
 * mesh as it is, without material if nothing but lines is to show, with depth_bias 1e-5 and depth_bias_slope fill_width
 * / 2 + 1, by which it makes way for lines on its front; then its lines with SHD_COMPARE_LESS_EQUAL. Lines over
 * everything compare ALWAYS.
 */
typedef struct shd_draw {
    uint32_t struct_size;         /**< set by shd_draw_default(); the same in every element of the array */
    shd_frequency frequency;      /**< default SHD_FREQUENCY_PHONG */
    const shd_mesh *mesh;         /**< required; borrowed for the call */
    const shd_material *material; /**< borrowed for the call; NULL = depth alone, without programs */
    float object_to_world[16];    /**< affine, finite; default identity */
    shd_cull cull;                /**< default SHD_CULL_NONE */
    shd_compare compare;          /**< default SHD_COMPARE_LESS */
    uint32_t flags;               /**< shd_draw_flag bits */
    float depth_bias;             /**< added to depth, -1..1; the sum is clamped to 0..1; default 0 */
    float depth_bias_slope;       /**< the same times the larger of |dz/dx| and |dz/dy| per pixel, finite; default 0 */
    uint32_t reserved;            /**< 0 */
    /**
     * Object-to-world matrices, [instance_count][16], each affine and finite, in place of object_to_world: the mesh is
     * drawn with each of them as by draws of their own, one after the other; borrowed for the call.
     */
    const float *instances;
    size_t instance_count; /**< 0 = once, by object_to_world; with those of all draws up to 2^20 */
    const void *uniforms;  /**< handed to the programs of the material; borrowed for the call; default NULL */
    shd_fill fill;         /**< default SHD_FILL_SOLID */
    float fill_width;      /**< across lines and along the sides of points, 1/16..64 pixels; default 0 = 1 */
    uint32_t edges;        /**< of SHD_FILL_LINES: shd_edge_kind bits; default SHD_EDGE_ALL */
    float crease_cosine;   /**< of SHD_EDGE_CREASE, as in shd_edges_desc: -1..1; default 0.5 */
    /* ---- end of 0.1; append below ---- */
} shd_draw;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_draw shd_draw_default(void)
{
    shd_draw draw = SHD_ZERO_INIT;
    draw.struct_size = (uint32_t)sizeof draw;
    draw.object_to_world[0] = draw.object_to_world[5] = 1.0f;
    draw.object_to_world[10] = draw.object_to_world[15] = 1.0f;
    draw.edges = SHD_EDGE_ALL;
    draw.crease_cosine = 0.5f;
    return draw;
}

/** Switches of a frame; combine with |. */
typedef enum shd_render_flag {
    SHD_RENDER_NONE = 0,
    SHD_RENDER_COUNT_HIDDEN = 1, /**< fill shd_render_stats.hidden_samples: coverage is found twice or more */
    SHD_RENDER_FLAG_MAX_ENUM = 0x7fffffff
} shd_render_flag;

/**
 * What decides which of several triangles a sample shows. PAINTER and NEWELL put the triangles of all draws into one
 * order and paint each over what is there, whatever the depths: draws compare as with SHD_COMPARE_ALWAYS, and a depth
 * is that of what was painted last. Depth falls with the distance in draws that compare GREATER or GREATER_EQUAL, grows
 * in all others, and has its bias; shd_draw_flag works as ever. Opaque draws are shaded once they have all been
 * painted, PREMULTIPLIED, STRAIGHT, ADD and MULTIPLY take effect in the order of painting, and WEIGHTED and SORTED come
 * last and test the painted depths. A draw without material leaves its depth and hides nothing.
 */
typedef enum shd_visibility {
    SHD_VISIBILITY_DEPTH = 0, /**< the depth of the sample, by the draw's comparison (Catmull 1974) */
    /**
     * The painter's algorithm: triangles by their farthest vertex, far ones first, equal ones in the order of draws and
     * triangles. Wrong where triangles overlap and the one whose farthest vertex is farther is nearer there;
     * shd_render_stats.order_conflicts tells. O(n log n).
     */
    SHD_VISIBILITY_PAINTER = 1,
    /**
     * The painter's algorithm with the tests, reordering and cuts of Newell, Newell and Sancha, "A Solution to the
     * Hidden Surface Problem" (1972): right but for depths that differ by less than a shift of 1/256 pixel makes, or
     * 2^-23. Triangles that overlap in a circle or pass through each other are cut along the plane of one of them; new
     * vertices lie on the grid of 1/256 pixel, so that a sample nearer than that to the cut, or to an edge that was
     * cut, may go to either side, and windows of a picture may differ there. Pieces keep the attributes and ids of
     * their triangle. Where a piece would have no area on that grid nothing is cut, and there are at most n + 1024 cuts
     * and 1024 n + 2^22 comparisons for n triangles; what remains wrong is counted in order_conflicts. Runs on one
     * thread, and takes up to 1000 bytes a triangle.
     */
    SHD_VISIBILITY_NEWELL = 2,
    SHD_VISIBILITY_MAX_ENUM = 0x7fffffff
} shd_visibility;

/** What happened to the triangles of a frame: the counts up to `rasterised` add up to `triangles`. */
typedef struct shd_render_stats {
    uint64_t triangles;           /**< in all draws */
    uint64_t nonfinite;           /**< dropped: a vertex is NaN or infinite after transformation */
    uint64_t outside;             /**< dropped: outside the view volume */
    uint64_t culled;              /**< dropped: facing the wrong way, or without area on the pixel grid, or, of
                                       SHD_FILL_LINES, without an edge of its own to show */
    uint64_t empty;               /**< dropped: between pixel centres */
    uint64_t rasterised;          /**< drawn, hidden or not */
    uint64_t clipped;             /**< of those outside, culled, empty and rasterised: cut by a clip plane */
    uint64_t fragments;           /**< shaded; of opaque draws each pixel once for every triangle it shows, in each
                                       pass (shd_render_desc.pass_triangles) */
    uint64_t nonfinite_fragments; /**< of those: r, g, b or a was NaN or infinite (kept as written) */
    uint64_t hidden_samples;      /**< covered, but failed the depth test before shading; 0 unless asked for. Draws
                                       that blend or drop fragments are tested by depths that lag behind as the
                                       library sees fit */
    uint64_t scratch_bytes;       /**< most working memory in use at a time; depends on the number of workers */
    double vertex_seconds;        /**< wall-clock time of a stage: transforming vertices */
    double assembly_seconds;      /**< finding the triangles that show, and clipping them */
    double binning_seconds;       /**< sorting them by distance, if the visibility method does, and into tiles */
    double tile_seconds;          /**< coverage, shading and blending */
    /**
     * With PAINTER and NEWELL, pairs of triangles, or pieces, that overlap on the screen where the one painted first
     * is nearer somewhere in the overlap, by more than NEWELL sees. Where very many triangles crowd, a lower bound:
     * pairs are looked for in cells of a grid, and in each up to 64 for every triangle in it and 1024 more.
     */
    uint64_t order_conflicts;
    uint64_t splits; /**< cuts that NEWELL made */
} shd_render_stats;

/** Host progress callback. */
typedef struct shd_progress {
    /**
     * Called after pieces of the frame with the part done, (0, 1], never twice at once, on any worker; must
     * not throw or longjmp or call shd. Anything but 0 cancels: the render returns SHD_ERROR_CANCELLED and
     * the framebuffer holds a part of the frame.
     */
    int32_t (*report)(void *user_data, float fraction);
    void *user_data; /**< borrowed for the call */
} shd_progress;

/** Pixels of a picture, origin at the top left corner. */
typedef struct shd_region {
    uint32_t x;      /**< first column */
    uint32_t y;      /**< first row */
    uint32_t width;  /**< pixels */
    uint32_t height; /**< pixels */
} shd_region;

/**
 * A whole frame, or a window of it. The picture is what draws are projected to; the framebuffer holds its pixels from
 * (crop_x, crop_y) on, each with the bits that it has in the whole. Everything is borrowed for the call. */
typedef struct shd_render_desc {
    uint32_t struct_size;           /**< set by shd_render_desc_default() */
    uint32_t load;                  /**< 0 = clear the planes first; 1 = load them: each sample starts as its pixel */
    float clear_color[4];           /**< linear, premultiplied RGBA; default 0 */
    float clear_depth;              /**< 0..1; default 1 */
    uint32_t flags;                 /**< shd_render_flag bits */
    shd_framebuffer *framebuffer;   /**< required */
    shd_view view;                  /**< default: identity matrices, eye at 0 */
    const shd_draw *draws;          /**< [draw_count], drawn in order; NULL if draw_count is 0 */
    size_t draw_count;              /**< up to 2^20 */
    const shd_light *const *lights; /**< [light_count]; NULL if light_count is 0 */
    size_t light_count;             /**< up to 2^20 */
    shd_render_stats *stats;        /**< NULL = not wanted; all zero on failure */
    shd_progress progress;          /**< default none */
    uint32_t picture_width;         /**< pixels, that of the framebuffer..65536; 0 = that of the framebuffer */
    uint32_t picture_height;        /**< the same */
    uint32_t crop_x;                /**< where the framebuffer lies in the picture, all of it inside; default 0 */
    uint32_t crop_y;                /**< the same */
    const shd_region *viewport;     /**< of the picture, not empty: what NDC -1..1 maps to; NULL = all of it */
    const shd_region *scissor;      /**< of the picture: pixels that may change; NULL = all of them */
    shd_visibility visibility;      /**< default SHD_VISIBILITY_DEPTH */
    /**
     * n, 2..16; 0 and 1 = off. The frame is that of a picture n times as large, as are crop, viewport and scissor, with
     * the framebuffer's samples in each of its pixels; up to 65536 of them a side. Colour and targets of a pixel are
     * the plain average of its n x n; depth and the other planes are those of the top left one. Derivatives, and
     * so footprints of textures, are those of the large picture, as are raster positions in programs; lines and points
     * are n times as wide there. With `load` each starts as its pixel. The large picture is drawn in blocks of up to
     * 1024 x 1024, in memory for one of them; statistics are the sums over blocks, so that a triangle counts in each.
     */
    uint32_t supersampling;
    /**
     * Most triangles that are worked on at a time, 1024..2^31-1; 0 = 2^21. A frame of more is drawn in passes: whole
     * draws, each counting as 16 triangles at least, or parts of one; those of SHD_BLEND_WEIGHTED and SHD_BLEND_SORTED
     * come together in the last. The framebuffer gets the same bits from any number. Working memory is at most 512
     * bytes for each of these triangles, 256 for each draw or instance, 24 for each sample of the framebuffer and 16
     * more for each of its targets, and 8 MiB for each worker; but for triangles that touch dozens of tiles of 64 x 64
     * pixels (4 bytes each), pieces that triangles are clipped into (48 each), varyings of vertex programs (4 bytes
     * each, of up to three vertices a triangle), and what comes together in the last pass.
     * Only with SHD_VISIBILITY_DEPTH: the others put all triangles into one order.
     */
    uint32_t pass_triangles;
    uint32_t reserved; /**< 0 */
    /**
     * [light_count], each NULL or a shadow of shd/shadow.h rendered for a light of that kind: what reaches a fragment
     * of the light is multiplied by the shadow's visibility at its position, with its shading normal; NULL = none.
     */
    const struct shd_shadow *const *shadows;
    /* ---- end of 0.1; append below ---- */
} shd_render_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_render_desc shd_render_desc_default(void)
{
    shd_render_desc desc = SHD_ZERO_INIT;
    int i;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.clear_depth = 1.0f;
    for (i = 0; i < 16; i += 5) desc.view.world_to_view[i] = desc.view.view_to_clip[i] = 1.0f;
    return desc;
}

/**
 * Render a frame.
 * On SHD_ERROR_OUT_OF_MEMORY, SHD_ERROR_CALLBACK or SHD_ERROR_CANCELLED the framebuffer may hold a part of
 * the frame; every other object is as before and the next render works.
 * @param context  its executor, allocator and SIMD target do the work; the objects may come from any context
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_render(shd_context *context, const shd_render_desc *desc);

SHD_END_DECLS

#endif /* SHD_RENDER_H */
