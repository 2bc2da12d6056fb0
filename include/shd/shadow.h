/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Shadow maps: depths of a scene as seen from a light, and the fraction of the light that reaches a point.
 *
 * A map is drawn by shd_shadow_render with the rasteriser of shd_render (Williams, "Casting Curved Shadows on Curved
 * Surfaces", 1978), looked up by shd_shadow_sample, and used by frames whose shd_render_desc.shadows contains it. A
 * directional light has one orthographic map; a point light has six maps, the faces of a cube.
 *
 * A point is lit if the plane of its surface is not behind the depth of the texels that the filter compares, at the
 * centre of each texel (Isidoro, "Shadow Mapping: GPU-based Tips and Techniques", GDC 2006). Planes with normals
 * therefore have no shadow acne at any filter size. The biases below prevent it for curved surfaces, interpolated
 * normals and the rounding to the pixel grid. Depths are lengths in world space, so a bias has the same effect for any
 * fitted range. The defaults suit most scenes: a larger bias, normal offset or filter lets light into contacts, and a
 * larger map keeps it out.
 *
 * A point is lit if its position is not finite, if it is outside the map, or if it is behind a spot. A normal that is
 * not finite is ignored.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; concurrent reads; shd_shadow_render needs the shadow for itself
 *                (exclusive use of the object).
 *
 * @code
 * shd_shadow_render_desc desc = shd_shadow_render_desc_default();
 * result = shd_shadow_create(context, NULL, &shadow);
 * desc.light = sun;
 * desc.draws = draws, desc.draw_count = draw_count;
 * result = shd_shadow_render(context, shadow, &desc);
 * render.shadows = shadows; // [light_count], with `shadow` at the place of the sun
 * @endcode
 */
#ifndef SHD_SHADOW_H
#define SHD_SHADOW_H

#include <shd/draw.h>
#include <shd/light.h>

SHD_BEGIN_DECLS

/** Depths as seen from a light. */
typedef struct shd_shadow shd_shadow;

/** Computation of visibility from depths. */
typedef enum shd_shadow_filter {
    SHD_SHADOW_FILTER_HARD = 0, /**< the nearest texel, 0 or 1 */
    /**
     * The mean of n x n bilinear comparisons a texel apart (Reeves, Salesin and Cook, "Rendering Antialiased Shadows
     * with Depth Maps", 1987). It varies continuously. Reads (n + 1)^2 texels, n = taps.
     */
    SHD_SHADOW_FILTER_PCF = 1,
    /**
     * Chebyshev's bound of the distribution of depths in n x n texels, n = taps, interpolated from four neighbours
     * (Donnelly and Lauritzen, "Variance Shadow Maps", 2006).
     */
    SHD_SHADOW_FILTER_VARIANCE = 2,
    /**
     * Chebyshev's bound over a square of edge length filter_size around the point, from a summed-area table (Lauritzen,
     * GPU Gems 3, 2007, 8).
     */
    SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE = 3,
    /**
     * Penumbras that widen with the distance to the blockers (Fernando, "Percentage-Closer Soft Shadows", 2005): the
     * mean depth of blockers from n x n texels, then the mean of n x n bilinear comparisons over the width of the
     * penumbra, n = taps. Only blockers that a ray from the point to the light meets determine the width, if there are
     * any (Guennebaud, Barthe and Paulin, "Real-Time Soft Shadow Mapping by Backprojection", 2006). Reads 5 n^2 texels
     * for any width; in wide penumbras they are not adjacent. The pattern of the texels is shifted at each point
     * (Cranley and Patterson, 1976) by a hash of the bits of its position, so penumbras have fine noise, less with more
     * taps. Equal positions have equal patterns in every frame, tile and batch.
     */
    SHD_SHADOW_FILTER_PCSS = 4,
    SHD_SHADOW_FILTER_MAX_ENUM = 0x7fffffff
} shd_shadow_filter;

/** Options of a shadow. */
typedef struct shd_shadow_desc {
    uint32_t struct_size;     /**< set by shd_shadow_desc_default() */
    uint32_t size;            /**< edge length of each face [texels], 16..8192; default 1024 */
    shd_shadow_filter filter; /**< default SHD_SHADOW_FILTER_HARD */
    uint32_t taps;            /**< n of PCF, VARIANCE and PCSS, 1..15; default 3 */
    /**
     * SUMMED_AREA_VARIANCE: edge length of the averaged square, world length at the point, 0..1e9; clamped to one texel
     * to size / 4 texels. Default 0.
     */
    float filter_size;
    /**
     * PCSS: edge length of the square light, world length, 0..1e9; default 0. For directional lights: width of the
     * penumbra per distance of blocker and receiver, which is twice the tangent of half the angular size of the light
     * (the sun: 0.0093). Search and penumbra are at most size / 4 texels wide.
     */
    float light_size;
    float bias; /**< points are moved towards the light by this depth, world length, 0..1e9; default 0 */
    /**
     * Factor of another bias: the edge length of a texel at the point times 1/4 + s. s is the sum of the |slopes| of
     * the surface across and along the map, at most 8. A slope is depth over length. The plane of the surface is exact
     * at each texel, so this bias covers only the difference of the surface from its plane. Without a normal, 1/4 + s
     * is replaced by 2, or by n + 1 for PCF. 0..1000; default 1.
     */
    float bias_slope;
    /**
     * Before the lookup, points are moved along their normal by this world length, 0..1e9; default 0. For coarse meshes
     * with smooth normals: about the edge length of a texel.
     */
    float normal_offset;
    /**
     * Faces that cast no shadow: BACK faces are turned away from the light, FRONT faces towards it. Replaces the
     * culling of the draws. Default SHD_CULL_NONE, for open surfaces. FRONT avoids acne on closed objects without a
     * bias, but light leaks where they touch other surfaces.
     */
    shd_cull caster_cull;
    /** VARIANCE, SUMMED_AREA_VARIANCE: visibilities below this value become 0, 0..0.99; default 0. */
    float bleed;
    float min_variance; /**< VARIANCE, SUMMED_AREA_VARIANCE: world length squared, 0..1e9; default 0 */
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
 * Make a shadow without a map. Call shd_shadow_render() before any lookup.
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

/** Light and draws of a map; borrowed for the call. Required: light. */
typedef struct shd_shadow_render_desc {
    uint32_t struct_size;   /**< set by shd_shadow_render_desc_default() */
    const shd_light *light; /**< required; directional, spot or point */
    /**
     * [draw_count] draws that cast shadows, as in shd_render_desc; NULL if draw_count is 0. Depth comparison, depth
     * biases and culling of a draw are ignored; a draw with SHD_DRAW_KEEP_DEPTH casts no shadow. Vertex programs run
     * with the light's view. Alpha tests and programs that drop fragments apply too, except for draws with WEIGHTED or
     * SORTED blending. Opacity by itself has no effect.
     */
    const shd_draw *draws;
    size_t draw_count; /**< up to 2^20 */
    /**
     * Range of depths, near_plane < far_plane. Surfaces outside cast no shadow. Both 0 = fitted to the draws.
     * Directional lights: measured from the origin of the world along the direction of the light, any sign. Other
     * lights: measured from the light along the axis of the face, > 0; a fitted near_plane is at least 1/256 of
     * far_plane.
     */
    float near_plane;
    float far_plane;
    /**
     * Directional lights: the part of the world that needs shadows. Both 0 = the bounds of the draws. Draws between
     * this part and the light still cast shadows. The size of texels is rounded up in steps of 1/8 to 1/16, and texels
     * lie at multiples of their size, so shadows do not shimmer while bounds of constant size move.
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
 * Render the map and replace the previous one. On failure the previous map stays.
 *
 * The cone of a spot has one map up to an outer angle of 1.1 rad [63 degrees], and six faces as a point light beyond.
 * Filters read up to size / 8 texels (PCF and VARIANCE: size / 4) beyond the edge of a face, so each face is rendered
 * wider by this margin. The fitted range uses the bounds of the meshes: set bounds and planes if vertex programs move
 * the vertices. Bounds beyond 1e18 are SHD_ERROR_INVALID_ARGUMENT. The map takes 4 bytes per texel (VARIANCE 8,
 * SUMMED_AREA_VARIANCE 16), and during rendering 4 bytes per texel more and a framebuffer of up to 2048 x 2048 pixels.
 * @param context  its executor, allocator and SIMD target do the work; the objects may come from any context
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shadow_render(shd_context *context, shd_shadow *shadow,
                                                   const shd_shadow_render_desc *desc);

/** Size and range of a rendered map. */
typedef struct shd_shadow_info {
    uint32_t struct_size;     /**< set by shd_shadow_info_default() */
    shd_shadow_filter filter; /**< as in its desc */
    uint32_t width;           /**< elements of a row of a face: size, or size + 1 of SUMMED_AREA_VARIANCE */
    uint32_t height;          /**< rows of a face, = width */
    size_t face_count;        /**< 1; 6 for points and wide spots: +X, -X, +Y, -Y, +Z, -Z; 0 before rendering */
    float near_plane;         /**< least depth of the map, as in shd_shadow_render_desc; 0 before rendering */
    float far_plane;          /**< largest depth */
    size_t byte_size;         /**< bytes of the map */
    /* ---- end of 0.1; append below ---- */
} shd_shadow_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shadow_info shd_shadow_info_default(void)
{
    shd_shadow_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Get size and range of a rendered map.
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shadow_get_info(const shd_shadow *shadow, shd_shadow_info *out_info);

/**
 * Copy a face of the map out, as its filter reads it, row by row from the top.
 *
 * HARD, PCF and PCSS: the first column has the depth of the surface at the centre of each texel, +infinity where there
 * is none; the second column must be NULL. Depths are world lengths, measured as near_plane is. VARIANCE: mean and
 * variance of depths in taps x taps texels, where empty texels have the far depth. SUMMED_AREA_VARIANCE: sums of s and
 * of s^2 over all texels left of column x and above row y, not normalised, with
 * s = (depth - (near_plane + far_plane) / 2) / (far_plane - near_plane), 1/2 where there is no surface. Each sum is
 * rounded to a float.
 * @param face  0..face_count - 1. A shadow that was not rendered is SHD_ERROR_INVALID_ARGUMENT
 * @param out   [2] columns of shd_shadow_info.width * height elements; NULL data = not wanted. They must not overlap
 *              (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shadow_read_map(const shd_shadow *shadow, uint32_t face, const shd_f32_out *out);

/** Points on surfaces; borrowed for the call. */
typedef struct shd_shadow_lookups {
    uint32_t struct_size;   /**< set by shd_shadow_lookups_default() */
    size_t count;           /**< number of points; 0 is allowed */
    shd_f32_in position[3]; /**< x, y, z, world space; required unless count is 0 */
    shd_f32_in normal[3];   /**< unit, world space; all three columns or none */
    /* ---- end of 0.1; append below ---- */
} shd_shadow_lookups;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shadow_lookups shd_shadow_lookups_default(void)
{
    shd_shadow_lookups lookups = SHD_ZERO_INIT;
    lookups.struct_size = (uint32_t)sizeof lookups;
    return lookups;
}

/** Columns for the visibility of the light. */
typedef struct shd_shadow_values {
    uint32_t struct_size;   /**< set by shd_shadow_values_default() */
    shd_f32_out visibility; /**< 0 (in shadow) to 1 (lit); required unless count is 0 */
    size_t nonfinite_count; /**< written: points with a number that is not finite */
    /* ---- end of 0.1; append below ---- */
} shd_shadow_values;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shadow_values shd_shadow_values_default(void)
{
    shd_shadow_values values = SHD_ZERO_INIT;
    values.struct_size = (uint32_t)sizeof values;
    return values;
}

/**
 * Compute the fraction of the light that reaches each point, 0 (in shadow) to 1 (lit), as frames do.
 *
 * Runs on the executor of the shadow's context.
 * @param lookups  columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shadow_sample(const shd_shadow *shadow, const shd_shadow_lookups *lookups,
                                                   shd_shadow_values *out);

SHD_END_DECLS

#endif /* SHD_SHADOW_H */
