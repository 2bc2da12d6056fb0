/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Filtered texture lookups, in batches of thousands of points per call.
 *
 * (u, v) = (0, 0) is the outer corner of the first texel of row 0; v grows downwards; texel centres lie at
 * (i + 0.5) / size. Let J be the 2 x 2 matrix of derivatives in texels of the base level and s the root mean square of
 * its singular values. The level of detail is lambda = clamp(log2(s) - 3/8 + lod_bias, lod_min, lod_max). At lambda
 * <= 0 trilinear is bilinear on level 0. Otherwise it blends the levels floor(lambda) and the next one by the fraction
 * of lambda. shd_profile has the rules of the other filters and of other texture units.
 *
 * Lookups of a texture with a projection (shd_texture_desc) read (u, v, w) as a direction of any length in world space,
 * and the derivatives as its changes per pixel step. The footprint is found on the image, on the equator for LAT_LONG,
 * by the exact Jacobian of the projection; for CUBE on the plane of the face. Levels of detail have no other limit than
 * in 2D: footprints longer than an image have the coarser levels of their length, and an infinite component of a change
 * gives the coarsest level. Only places of probes are limited: a line of probes is at most one circle along a parallel
 * of LAT_LONG, and ends at most one image beyond OCTAHEDRAL, MIRROR_BALL and ANGULAR. Beyond an edge of an image texels
 * come from the neighbouring image, so that no filter has a seam or a pole. Wraps and borders have no effect; `layer`
 * has none for CUBE. RIPMAP and SUMMED_AREA return SHD_ERROR_UNSUPPORTED. SHD_PRECISION_FAST has no effect. A
 * direction of length 0, or with a component that is NaN or infinite, counts as +Z; derivatives of the result are 0.
 *
 * Coordinates are computed in binary32. Repeat and mirror first reduce a coordinate to its fraction of the period (1 or
 * 2 images), with an error of at most 2^-24 of the period. On an axis of n texels the point of a lookup is within
 * 4e-7 n texels of the exact one, with every wrap and filter.
 *
 * All filters but RIPMAP and SUMMED_AREA filter 3D textures, with LEAST_ERROR or EXACT and without blur. J is then the
 * 3 x 2 matrix of derivatives, s the root mean square of its two singular values, and the footprint lies in space, in
 * the plane of the derivatives. BILINEAR is linear, HERMITE smooth and BICUBIC cubic on all three axes, and other
 * filters accordingly; docs/volumes.md has their definitions. SHD_PRECISION_FAST has no effect.
 *
 * Defined for all inputs: NaN and infinite coordinates count as 0, NaN derivatives as 0, infinite derivatives as the
 * coarsest level; a NaN `lod` counts as 0. A texel of weight 0 has no effect, even if it is NaN. Finite texels and
 * borders give finite values and derivatives: a blend that leaves the range of float, which takes the lobes of a
 * bicubic kernel or a derivative, becomes the largest float of its sign before the next blend.
 *
 * Each lookup depends on its own inputs only: results have the same bits for any batch size, order and worker count.
 *
 * Thread safety: concurrent reads. Batches of more than 16384 lookups are split over the executor of the texture's
 * context; others run on the calling thread alone. Fragment and vertex programs may look textures up.
 *
 * @code
 * shd_lookups lookups = shd_lookups_default();
 * shd_texels texels = shd_texels_default();
 * lookups.count = count;
 * lookups.u = shd_f32_column(u, 0), lookups.v = shd_f32_column(v, 0);
 * texels.channel[0] = shd_f32_out_column(red, 0);
 * result = shd_texture_sample(texture, sampler, &lookups, &texels);
 * @endcode
 */
#ifndef SHD_LOOKUP_H
#define SHD_LOOKUP_H

#include <shd/column.h>
#include <shd/sampler.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/** Points to look up, as columns of `count` elements. Required: u, v. Absent columns are NULL. */
typedef struct shd_lookups {
    uint32_t struct_size; /**< set by shd_lookups_default() */
    size_t count;         /**< number of lookups; 0 is allowed */
    shd_f32_in u;         /**< normalised coordinate across; required */
    shd_f32_in v;         /**< normalised coordinate down; required */
    /**
     * Third coordinate: across the slices of a 3D texture, or of a direction; required by these textures, without
     * effect for others.
     */
    shd_f32_in w;
    shd_f32_in dudx;      /**< du/dx per pixel step; absent = 0 */
    shd_f32_in dvdx;      /**< dv/dx; absent = 0 */
    shd_f32_in dwdx;      /**< dw/dx per pixel step, where w has effect; absent = 0 */
    shd_f32_in dudy;      /**< du/dy; absent = 0 */
    shd_f32_in dvdy;      /**< dv/dy; absent = 0 */
    shd_f32_in dwdy;      /**< dw/dy; absent = 0 */
    shd_f32_in lod;       /**< log2 of the footprint in base texels; replaces the derivatives, width and blur */
    shd_u32_in layer;     /**< layer of the array; absent = 0; numbers beyond the last layer mean the last layer */
    shd_u32_in random;    /**< random bits of SHD_FILTER_STOCHASTIC; absent = hashed from u, v and, if read, w */
    shd_f32_in reference; /**< compared with texels by samplers with `compares`; absent = 0 */
    /* ---- end of 0.1; append below ---- */
} shd_lookups;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_lookups shd_lookups_default(void)
{
    shd_lookups lookups = SHD_ZERO_INIT;
    lookups.struct_size = (uint32_t)sizeof lookups;
    return lookups;
}

/** Columns for the filtered values: linear, and premultiplied only if the texels are. */
typedef struct shd_texels {
    /** Set by shd_texels_default(). 0 is accepted for the layout of 0.1, so that `shd_texels texels = {0};` works. */
    uint32_t struct_size;
    shd_f32_out channel[4]; /**< r, g, b, a after the texture's swizzle; NULL = not wanted */
    /**
     * d/du and d/dv of the channels, with u and v normalised and the footprint held constant; NULL = not wanted.
     * Available for BILINEAR, BICUBIC, HERMITE, BILINEAR_MIP, TRILINEAR, RIPMAP, ANISOTROPIC and EWA, and for a
     * magnification filter in this list; other filters return SHD_ERROR_UNSUPPORTED. BILINEAR has kinks at texel
     * centres; the result there is the derivative to the right. EWA has kinks where a texel enters the ellipse; the
     * result there is the derivative of the weights. du, dv and dw of a texture of directions are the derivatives in
     * the three components of the direction, not normalised, with the footprint held constant in the image.
     */
    shd_f32_out du[4];
    shd_f32_out dv[4];
    /**
     * d/dw of the channels of a 3D texture or of one of directions, as du; NULL = not wanted. 2D textures return
     * SHD_ERROR_UNSUPPORTED.
     */
    shd_f32_out dw[4];
    /**
     * 0 for lookups that found all their tiles. With SHD_MISSING_TILES_COARSER, l + 1 if a tile of level l is missing
     * and coarser levels were filtered instead. NULL = not wanted.
     */
    shd_u32_out coarser;
    size_t nonfinite_count; /**< written: lookups whose coordinates, derivatives or lod were not finite */
    /* ---- end of 0.1; append below ---- */
} shd_texels;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_texels shd_texels_default(void)
{
    shd_texels texels = SHD_ZERO_INIT;
    texels.struct_size = (uint32_t)sizeof texels;
    return texels;
}

/**
 * Filter `lookups->count` points of a texture.
 * @param texture  concurrent reads
 * @param sampler  may come from another context
 * @param lookups  columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_sample(const shd_texture *texture, const shd_sampler *sampler,
                                                    const shd_lookups *lookups, shd_texels *out);

/** Columns for levels of detail; NULL = not wanted. */
typedef struct shd_levels {
    uint32_t struct_size;   /**< set by shd_levels_default() */
    shd_f32_out lod;        /**< continuous level of trilinear in the sampler's profile, after bias and clamps */
    shd_u32_out level;      /**< nearest mip level: ceil(lod + 1/2) - 1, or the profile's */
    size_t nonfinite_count; /**< written: lookups whose coordinates, derivatives or lod were not finite */
    /* ---- end of 0.1; append below ---- */
} shd_levels;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_levels shd_levels_default(void)
{
    shd_levels levels = SHD_ZERO_INIT;
    levels.struct_size = (uint32_t)sizeof levels;
    return levels;
}

/**
 * Compute the levels of detail of `lookups->count` points, as trilinear filtering uses them.
 * @param texture  concurrent reads
 * @param sampler  its bias, clamps, width, blur and profile are used; its filter has no effect
 * @param lookups  columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_query_levels(const shd_texture *texture, const shd_sampler *sampler,
                                                          const shd_lookups *lookups, shd_levels *out);

SHD_END_DECLS

#endif /* SHD_LOOKUP_H */
