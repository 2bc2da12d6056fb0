/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Mip levels of an image in the caller's memory: kernels, and what texels mean.
 *
 * Thread safety: any thread; concurrent reads of the base.
 */
#ifndef SHD_MIP_H
#define SHD_MIP_H

#include <shd/context.h>
#include <shd/image.h>
#include <shd/wrap.h>

SHD_BEGIN_DECLS

/**
 * Filters of one axis, in texels of the level that is made. A source texel weighs the integral of the kernel over
 * it, for any ratio of sizes, and the weights of a level texel sum to 1: a constant stays what it is.
 */
typedef enum shd_mip_kernel {
    SHD_MIP_BOX = 0,      /**< the texel's own area (Williams 1983) */
    SHD_MIP_TRIANGLE = 1, /**< 1 - |x|, radius 1 */
    SHD_MIP_KAISER = 2,   /**< sinc under a Kaiser window of parameter 4, radius 3 */
    SHD_MIP_LANCZOS = 3,  /**< sinc(x) sinc(x / 3), radius 3 */
    SHD_MIP_KERNEL_MAX_ENUM = 0x7fffffff
} shd_mip_kernel;

/** What a level is filtered from. */
typedef enum shd_mip_source {
    SHD_MIP_FROM_BASE = 0,     /**< every level from the base: rounded once */
    SHD_MIP_FROM_PREVIOUS = 1, /**< from the stored level above: faster for many levels, rounding adds up */
    SHD_MIP_SOURCE_MAX_ENUM = 0x7fffffff
} shd_mip_source;

/** What the texels mean. */
typedef enum shd_semantic {
    SHD_SEMANTIC_COLOR = 0, /**< light: _SRGB formats are filtered decoded */
    SHD_SEMANTIC_DATA = 1,  /**< numbers: the codes of _SRGB formats are filtered as they are */
    /**
     * Unit vectors, in three or four channels; integer channels hold (n + 1) / 2, of _SRGB formats too. Levels are
     * renormalised; a zero mean becomes (0, 0, 1). A fourth channel receives the length of the mean, at most 1,
     * from which a specular exponent is widened (Toksvig, "Mipmapping Normal Maps", 2005); that of the base is the
     * caller's, 1 for unit vectors.
     */
    SHD_SEMANTIC_NORMAL = 2,
    SHD_SEMANTIC_HEIGHT = 3, /**< as data */
    /**
     * Colour whose alpha is tested: alpha of every level is scaled so that as large a part of its texels as of the
     * base's reaches `alpha_cutoff` (Castano, "Computing Alpha Mipmaps", 2010), to the nearest texel unless texels
     * of equal alpha stand there. Four channels.
     */
    SHD_SEMANTIC_ALPHA_COVERAGE = 4,
    SHD_SEMANTIC_MAX_ENUM = 0x7fffffff
} shd_semantic;

/** How mip levels are made. */
typedef struct shd_mip_desc {
    uint32_t struct_size;  /**< set by shd_mip_desc_default() */
    shd_mip_kernel kernel; /**< default box */
    shd_mip_source source; /**< default the base */
    shd_semantic semantic; /**< default colour */
    shd_wrap wrap_u;       /**< what kernels wider than the box read beyond the edge; default repeat. With */
    shd_wrap wrap_v;       /**< SHD_WRAP_BORDER they read nothing there, and the rest weighs more */
    float alpha_cutoff;    /**< of SHD_SEMANTIC_ALPHA_COVERAGE, 0..1; default 0.5 */
    uint32_t reserved;     /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_mip_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_mip_desc shd_mip_desc_default(void)
{
    shd_mip_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.alpha_cutoff = 0.5f;
    return desc;
}

/**
 * Make mip levels 1..level_count of an image, in the caller's memory, on the context's executor. With the defaults
 * they are what SHD_TABLE_MIPMAP builds. Results that leave the range of the format, which kernels with negative
 * lobes can give, are clamped to it; finite texels give finite levels.
 * @param base         at most 2^28 pixels; borrowed for the call
 * @param desc         borrowed for the call
 * @param level_count  0..floor(log2(max(width, height)))
 * @param levels       [level_count], all of one struct_size; level l is levels[l - 1]: the format of the base,
 *                     max(1, width >> l) by max(1, height >> l). Pixels are written, unspecified on failure to
 *                     allocate or of the executor; they overlap neither each other nor the base
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mip_build(shd_context *context, const shd_image *base, const shd_mip_desc *desc,
                                               uint32_t level_count, const shd_image *levels);

/**
 * Turn a normal map into the moments of its slopes, from which lookups get back how rough the normals under a footprint
 * make a surface, while plain means of normals make it smooth (Olano and Baker, "LEAN Mapping", 2010; without
 * the mixed moment, as in Baker, "Spectacular Specular: LEAN and CLEAN Specular Highlights", 2011). A texel is (bx, by,
 * bx^2, by^2), (bx, by) = (nx / nz, ny / nz). Levels are made of the result as SHD_SEMANTIC_DATA, and any filter may
 * read it: from a filtered (bx, by, Mx, My) come the mean normal normalise(bx, by, 1) and the variance of a slope,
 * max(0, Mx + My - bx^2 - by^2) / 2, which widens a lobe. nz is taken as at least 1/32 of the normal's length, so that
 * bx and by are at most 32; normals that point backwards count as such. A texel that is 0 or not finite is flat: four
 * zeros.
 * @param normals  three or four channels, as for SHD_SEMANTIC_NORMAL, of any length; borrowed for the call
 * @param out      of that width and height, SHD_FORMAT_RGBA16F or SHD_FORMAT_RGBA32F, not overlapping `normals`. Pixels
 *                 are written, unspecified on failure of the executor
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_normal_moments(shd_context *context, const shd_image *normals,
                                                    const shd_image *out);

SHD_END_DECLS

#endif /* SHD_MIP_H */
