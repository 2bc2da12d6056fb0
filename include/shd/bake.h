/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Bakes: materials and fragment programs shaded into a texture, at the texture coordinates of a mesh.
 *
 * A bake is a frame whose triangles lie at their texture coordinates: the corner (u, v) lies at the point (u width,
 * v height) of the framebuffer, with v downwards as in textures. Each texel is shaded once, in world space, by the
 * same stages as a fragment of shd_render(). Derivatives are per texel.
 *
 * Coverage is conservative: a texel is shaded if a triangle shares area with it. If a triangle covers the centre of the
 * texel (by the top-left rule of shd/render.h), the texel is shaded at its centre. Otherwise it is shaded at the point
 * of the triangle nearest to the centre, so that attributes are never extrapolated. Several triangles may touch a
 * texel: one that covers the centre comes first, then the nearest to the centre, then the first in the order of draws
 * and triangles. Coordinates are rounded to multiples of 1/256 texel.
 *
 * Coordinates do not wrap: parts of triangles outside 0..1 are not baked, and shd_bake_stats.outside_triangle_count
 * counts these triangles. Triangles without area in texture coordinates are counted too and bake nothing, as do all
 * triangles of a mesh without the uv set. Coordinates beyond 2^20 texels are cut there.
 *
 * Thread safety: exclusive use of the framebuffer; all other objects may be shared between concurrent calls.
 *
 * @code
 * shd_render_desc frame = shd_render_desc_default();
 * shd_bake_desc bake = shd_bake_desc_default();
 * frame.framebuffer = atlas;
 * frame.draws = &draw, frame.draw_count = 1; // the material is a fragment program
 * bake.dilation = 4;
 * result = shd_bake(context, &frame, &bake);
 * @endcode
 */
#ifndef SHD_BAKE_H
#define SHD_BAKE_H

#include <shd/render.h>

SHD_BEGIN_DECLS

/** Source of the value of a baked texel. */
typedef enum shd_texel_state {
    SHD_TEXEL_STATE_EMPTY = 0,  /**< no triangle: the clear values of the frame */
    SHD_TEXEL_STATE_CENTER = 1, /**< a triangle that covers the centre of the texel */
    /** The nearest point of a triangle that covers a part of the texel, without its centre. */
    SHD_TEXEL_STATE_TOUCHED = 2,
    SHD_TEXEL_STATE_DILATED = 3, /**< a copy of the nearest texel that a triangle shaded */
    SHD_TEXEL_STATE_MAX_ENUM = 0x7fffffff
} shd_texel_state;

/** Statistics of a bake. */
typedef struct shd_bake_stats {
    uint32_t struct_size;              /**< set by shd_bake_stats_default() */
    uint64_t triangle_count;           /**< in all draws */
    uint64_t zero_area_triangle_count; /**< without area in texture coordinates, rounded to 1/256 texel; not baked */
    uint64_t nonfinite_triangle_count; /**< with a position or texture coordinate that is not finite; not baked */
    uint64_t outside_triangle_count;   /**< with a corner outside 0..1; the part inside is baked */
    uint64_t center_texel_count;       /**< texels of SHD_TEXEL_STATE_CENTER */
    uint64_t touched_texel_count;      /**< texels of SHD_TEXEL_STATE_TOUCHED */
    uint64_t dilated_texel_count;      /**< texels of SHD_TEXEL_STATE_DILATED */
    uint64_t overlapping_texel_count;  /**< texels whose centre several triangles cover */
    uint64_t nonfinite_texel_count;    /**< shaded texels whose r, g, b or a is NaN or infinite (kept as written) */
    /* ---- end of 0.1; append below ---- */
} shd_bake_stats;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_bake_stats shd_bake_stats_default(void)
{
    shd_bake_stats stats = SHD_ZERO_INIT;
    stats.struct_size = (uint32_t)sizeof stats;
    return stats;
}

/** Options of a bake; nothing is required. */
typedef struct shd_bake_desc {
    uint32_t struct_size; /**< set by shd_bake_desc_default() */
    uint32_t uv_set;      /**< texture coordinates at which triangles lie: 0 = uv of the mesh, 1 = uv1; default 0 */
    /**
     * Largest distance [texels], 0..1024, over which empty texels get a copy of the nearest shaded texel, in all planes
     * except depth: seams then do not mix with the background when the texture is filtered. Distances are between
     * centres; of equally near texels the one in the upper row is copied, then the left one. Default 0 = none.
     */
    uint32_t dilation;
    shd_u32_out states;    /**< shd_texel_state of width * height texels; default not wanted */
    shd_bake_stats *stats; /**< its struct_size is read; NULL = not wanted; all zero on failure */
    /* ---- end of 0.1; append below ---- */
} shd_bake_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_bake_desc shd_bake_desc_default(void)
{
    shd_bake_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Shade the surfaces of draws into a framebuffer at their texture coordinates.
 *
 * A bake reads these fields of the frame: the framebuffer (with one sample per pixel), clear_color, camera or view,
 * draws, lights, shadows, environment with its intensity and rotation, progress and stats. The view gives the eye.
 * Vertex programs run; their clip positions have no effect. The other fields must have their defaults, except
 * pass_triangles, which has no effect: all triangles are processed together. Depth becomes 1, and overdraw stays 0.
 *
 * Every draw has a material. Its colour replaces that of the texel: blends have no effect, and a is the opacity of the
 * material. Fragments that a program or the alpha test drops leave their texel empty. SHD_MATERIAL_DOUBLE_SIDED and
 * _ALPHA_TO_COVERAGE, and cull, fill, compare, depth biases and flags of a draw have no effect. The bits of the result
 * do not depend on workers or SIMD targets.
 * @param context  its executor, allocator and SIMD target do the work; the objects may come from any context
 * @param frame    borrowed for the call
 * @param desc     borrowed for the call; NULL = all defaults
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_bake(shd_context *context, const shd_render_desc *frame,
                                          const shd_bake_desc *desc);

SHD_END_DECLS

#endif /* SHD_BAKE_H */
