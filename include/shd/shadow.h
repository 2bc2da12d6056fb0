/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Shadow maps: depths of a scene as a light sees it, and the part of the light that reaches a point.
 *
 * A map is drawn by shd_shadow_render with the rasteriser of shd_render (Williams, "Casting Curved Shadows on Curved
 * Surfaces", 1978), looked up by shd_shadow_sample, and used by frames that name it in shd_render_desc.shadows. A
 * directional light has one orthographic map; a point light six, the faces of a cube.
 *
 * A point is lit where the plane of its surface, continued to the centre of each texel that a filter compares, is not
 * behind the texel's depth: with normals, lit planes have no stripes of shadow at any filter size. What is left (curved
 * surfaces, interpolated normals, the pixel grid) is for the biases below. Depths are kept in world lengths, and so
 * biases mean the same after every fit.
 *
 * A point whose position is not finite, that lies outside the map, or behind the light of a spot, is lit. A normal
 * that is not finite counts as none.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; concurrent reads; shd_shadow_render needs the shadow for itself (one
 *                thread at a time per object).
 */
#ifndef SHD_SHADOW_H
#define SHD_SHADOW_H

#include <shd/render.h>

SHD_BEGIN_DECLS

/** Depths as a light sees them. */
typedef struct shd_shadow shd_shadow;

/** How visibility comes from depths. */
typedef enum shd_shadow_filter {
    SHD_SHADOW_HARD = 0, /**< the nearest texel, 0 or 1 */
    /**
     * The mean of n x n bilinear comparisons a texel apart (Reeves, Salesin and Cook, "Rendering Antialiased Shadows
     * with Depth Maps", 1987), which changes smoothly from point to point: (n + 1)^2 texels, n = taps.
     */
    SHD_SHADOW_PCF = 1,
    /**
     * Chebyshev's bound of a distribution of depths (Donnelly and Lauritzen, "Variance Shadow Maps", 2006): those of
     * n x n texels, n = taps, blended from four neighbours.
     */
    SHD_SHADOW_VARIANCE = 2,
    /** The same over a square of filter_size around the point, by a table of sums (Lauritzen, GPU Gems 3, 2007, 8). */
    SHD_SHADOW_SUMMED_AREA_VARIANCE = 3,
    /**
     * Penumbras that widen with the distance to what blocks the light (Fernando, "Percentage-Closer Soft Shadows",
     * 2005): its mean depth from n x n texels, then the mean of n x n bilinear comparisons over the penumbra's width,
     * n = taps. 5 n^2 texels whatever the width; those of wide penumbras lie apart.
     */
    SHD_SHADOW_PCSS = 4,
    SHD_SHADOW_FILTER_MAX_ENUM = 0x7fffffff
} shd_shadow_filter;

/** What a shadow is made with. */
typedef struct shd_shadow_desc {
    uint32_t struct_size;     /**< set by shd_shadow_desc_default() */
    uint32_t size;            /**< texels a side of each face, 16..8192; default 1024 */
    shd_shadow_filter filter; /**< default SHD_SHADOW_HARD */
    uint32_t taps;            /**< n of PCF, VARIANCE and PCSS, 1..15; default 3 */
    /**
     * SUMMED_AREA_VARIANCE: side of the square that is averaged, world length at the point, 0..1e9, at least one texel
     * and at most size / 4; default 0.
     */
    float filter_size;
    /**
     * PCSS: side of the square light, 0..1e9; default 0. World length; of directional lights the width of a penumbra
     * per length between blocker and receiver, twice the tangent of half the angle that the light is seen under (the
     * sun: 0.0093). Neither search nor penumbra is wider than size / 4 texels.
     */
    float light_size;
    float bias;       /**< depth that points are moved to the light, world length, 0..1e9; default 0 */
    float bias_slope; /**< more of that: side of a texel there times 1/4 + |slope| of the surface across and along the
                              map, both up to 64; without a normal 2, of PCF n + 1. 0..1000; default 1 */
    float normal_offset; /**< points are moved along their normal first, world length, 0..1e9; default 0 */
    shd_cull casters;    /**< faces that cast no shadow: BACK, those turned away from the light, or FRONT, those turned
                              to it; default SHD_CULL_NONE. In place of the draws' own */
    float bleed;         /**< VARIANCE, SUMMED_AREA_VARIANCE: visibility up to it counts as 0, 0..0.99; default 0 */
    float min_variance;  /**< of the same, world length squared, 0..1e9; default 0 */
    /* ---- end of 0.1; append below ---- */
} shd_shadow_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shadow_desc shd_shadow_desc_default(void)
{
    shd_shadow_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.size = 1024;
    desc.taps = 3;
    desc.bias_slope = 1.0f;
    return desc;
}

/**
 * Make a shadow without a map, which cannot be looked up before it is rendered.
 * @param context     retained
 * @param desc        borrowed for the call; NULL = all defaults
 * @param out_shadow  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shadow_create(shd_context *context, const shd_shadow_desc *desc,
                                                   shd_shadow **out_shadow);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_shadow_retain(shd_shadow *shadow);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_shadow_release(shd_shadow *shadow);

/** What a map is rendered from. Everything is borrowed for the call. */
typedef struct shd_shadow_render_desc {
    uint32_t struct_size;   /**< set by shd_shadow_render_desc_default() */
    uint32_t reserved;      /**< 0 */
    const shd_light *light; /**< required; directional, spot or point */
    /**
     * What casts shadows, as in shd_render_desc; NULL if draw_count is 0. Comparison, depth biases and culling of a
     * draw do not count; one with SHD_DRAW_KEEP_DEPTH casts no shadow. Materials count by the fragments that alpha or
     * their program drops and by their vertex program, both seen from the light, but for those blended WEIGHTED or
     * SORTED; opacity as such does not.
     */
    const shd_draw *draws;
    size_t draw_count; /**< up to 2^20 */
    /**
     * Depths that are drawn, near_plane < far_plane; what is nearer or farther casts no shadow. Both 0 = fitted to the
     * draws. Directional: along the light's way from the world's origin, any sign. Others: from the light, along the
     * axis of the face, > 0; fitted, near_plane is at least 1/256 of far_plane.
     */
    float near_plane;
    float far_plane;
    /**
     * Directional lights: the part of the world that needs shadows, in place of the bounds of the draws; both 0 =
     * those. Draws between it and the light still cast theirs. The map covers it with texels of a size rounded up in
     * steps of 1/8 to 1/16, at places that are multiples of it: shadows stand still while bounds of the same size move.
     */
    float bounds_min[3];
    float bounds_max[3];
    /* ---- end of 0.1; append below ---- */
} shd_shadow_render_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shadow_render_desc shd_shadow_render_desc_default(void)
{
    shd_shadow_render_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Render the map, in place of the one before; on failure that one stays.
 *
 * The cone of a spot has one map up to an outer angle of 1.1 rad [63 degrees], and six faces as a point light beyond.
 * Filters reach over the edge of a face by up to size / 8 texels (PCF and VARIANCE size / 4), for which each is drawn
 * so much wider. Draws are fitted by the bounds of their meshes, wherever vertex programs move the vertices: then give
 * bounds and planes. Bounds beyond 1e18 are SHD_ERROR_INVALID_ARGUMENT. The map takes 4 bytes a texel, 8 of VARIANCE
 * and 16 of SUMMED_AREA_VARIANCE, and while it is drawn 4 more and a framebuffer of up to 2048 x 2048.
 * @param context  its executor, allocator and SIMD target do the work; the objects may come from any context
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shadow_render(shd_context *context, shd_shadow *shadow,
                                                   const shd_shadow_render_desc *desc);

/** Points of surfaces. Borrowed for the call. */
typedef struct shd_shadow_lookups {
    uint32_t struct_size;   /**< set by shd_shadow_lookups_default() */
    uint32_t reserved;      /**< 0 */
    size_t count;           /**< 0 is fine */
    shd_f32_in position[3]; /**< x, y, z, world space; required unless count is 0 */
    shd_f32_in normal[3];   /**< unit, world space; all three or none */
    /* ---- end of 0.1; append below ---- */
} shd_shadow_lookups;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shadow_lookups shd_shadow_lookups_default(void)
{
    shd_shadow_lookups lookups = SHD_ZERO_INIT;
    lookups.struct_size = (uint32_t)sizeof lookups;
    return lookups;
}

/**
 * Part of the light that reaches each point, 0 (in shadow) to 1 (lit). Frames use the same. Runs on the executor of the
 * shadow's context.
 * @param out  [count]; must not overlap the points
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shadow_sample(const shd_shadow *shadow, const shd_shadow_lookups *lookups,
                                                   shd_f32_out out);

SHD_END_DECLS

#endif /* SHD_SHADOW_H */
