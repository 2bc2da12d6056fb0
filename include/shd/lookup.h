/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Filtered texture lookups, thousands per call.
 *
 * (u, v) = (0, 0) is the outer corner of the first texel of row 0; v grows downwards; texel centres lie at
 * (i + 0.5) / size. Level of detail, with J the 2 x 2 matrix of derivatives in base-level texels and s its
 * larger singular value: lambda = clamp(log2(s) + lod_bias, lod_min, lod_max). At lambda <= 0 trilinear is
 * bilinear on level 0; the levels are floor(lambda) and the next, blended by the fraction. Other profiles of the
 * sampler find them as enum shd_profile says.
 *
 * Total: NaN and infinite coordinates count as 0, NaN derivatives as 0, infinite ones as the coarsest level;
 * a NaN `lod` counts as 0. Texels that are finite give finite results; a texel of weight 0 never counts.
 *
 * Each lookup depends on its own inputs only: the same bits for any batch size, order and worker count.
 *
 * Thread safety: concurrent reads; batches of more than 16384 lookups are split over the executor of the texture's
 * context, others run on the calling thread alone. Fragment and vertex programs may look textures up.
 */
#ifndef SHD_LOOKUP_H
#define SHD_LOOKUP_H

#include <shd/column.h>
#include <shd/sampler.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/** Points to look up, as columns of `count` elements. Absent optional columns are NULL. */
typedef struct shd_lookups {
    uint32_t struct_size; /**< set by shd_lookups_default() */
    uint32_t reserved;    /**< 0 */
    size_t count;         /**< number of lookups; 0 is allowed */
    shd_f32_in u;         /**< normalised coordinate across; required */
    shd_f32_in v;         /**< normalised coordinate down; required */
    shd_f32_in dudx;      /**< du/dx per pixel step; absent = 0 */
    shd_f32_in dvdx;      /**< dv/dx; absent = 0 */
    shd_f32_in dudy;      /**< du/dy; absent = 0 */
    shd_f32_in dvdy;      /**< dv/dy; absent = 0 */
    shd_f32_in lod;       /**< log2 of the footprint in base texels; replaces the derivatives, width and blur */
    shd_u32_in layer;     /**< image of the array; absent = 0, beyond the last = the last */
    shd_u32_in random;    /**< random bits of SHD_FILTER_STOCHASTIC; absent = drawn from the bits of u and v */
    /* ---- end of 0.1; append below ---- */
} shd_lookups;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_lookups shd_lookups_default(void)
{
    shd_lookups lookups = SHD_ZERO_INIT;
    lookups.struct_size = (uint32_t)sizeof lookups;
    return lookups;
}

/** Where the filtered values go: linear, not premultiplied unless the texels were. */
typedef struct shd_texels {
    /**
     * 0 = the layout of 0.1, so that `shd_texels out = {0};` works; else sizeof(shd_texels).
     */
    uint32_t struct_size;
    uint32_t reserved;      /**< 0 */
    shd_f32_out channel[4]; /**< r, g, b, a after the texture's swizzle; unwanted ones NULL */
    /**
     * d/du and d/dv of the channels, u and v normalised and the footprint held constant; unwanted ones NULL. For
     * BILINEAR, BICUBIC, BILINEAR_MIP, TRILINEAR, RIPMAP, ANISOTROPIC and EWA (and a magnification among them);
     * other filters answer SHD_ERROR_UNSUPPORTED. At a texel centre, where BILINEAR has a kink, the one to the right;
     * those of EWA, which has one where a texel enters the ellipse, follow its weights.
     */
    shd_f32_out du[4];
    shd_f32_out dv[4];
    size_t nonfinite_count; /**< written: lookups whose coordinates or derivatives (or lod) were not finite */
    /* ---- end of 0.1; append below ---- */
} shd_texels;

/**
 * Filter `lookups->count` points of a texture.
 * @param texture  concurrent reads
 * @param sampler  may come from another context
 * @param lookups  columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_sample(const shd_texture *texture, const shd_sampler *sampler,
                                                    const shd_lookups *lookups, shd_texels *out);

/** Where levels of detail go; unwanted ones NULL. */
typedef struct shd_levels {
    shd_f32_out lod;   /**< continuous: log2 of the footprint's longer axis or the profile's, after bias and clamps */
    shd_u32_out level; /**< the mip level nearest to it: ceil(lod + 1/2) - 1, or as the profile has it */
} shd_levels;

/**
 * Levels of detail of `lookups->count` points, as trilinear filtering uses them: what pictures of mip levels show.
 * @param texture  concurrent reads
 * @param sampler  its bias, clamps, width, blur and profile count, its filter does not
 * @param lookups  columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_query_levels(const shd_texture *texture, const shd_sampler *sampler,
                                                          const shd_lookups *lookups, const shd_levels *out);

SHD_END_DECLS

#endif /* SHD_LOOKUP_H */
