/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Images made from an image in the caller's memory: mip levels, normals of heights, moments of normals.
 *
 * Thread safety: any thread; concurrent reads of the base.
 *
 * @code
 * shd_mip_desc desc = shd_mip_desc_default();
 * desc.kernel = SHD_MIP_KERNEL_KAISER;
 * desc.content = SHD_TEXEL_CONTENT_NORMAL;
 * result = shd_mip_build(context, &base, &desc, level_count, levels);
 * @endcode
 */
#ifndef SHD_MIP_H
#define SHD_MIP_H

#include <shd/context.h>
#include <shd/image.h>
#include <shd/wrap.h>

SHD_BEGIN_DECLS

/**
 * Filter kernel along one axis, in texels of the new level.
 *
 * The weight of a source texel is the integral of the kernel over the texel, for any ratio of sizes. The weights of a
 * level's texel sum to 1, so constant images stay constant.
 */
typedef enum shd_mip_kernel {
    SHD_MIP_KERNEL_BOX = 0,      /**< the texel's own area (Williams 1983) */
    SHD_MIP_KERNEL_TRIANGLE = 1, /**< 1 - |x|, radius 1 */
    SHD_MIP_KERNEL_KAISER = 2,   /**< sinc under a Kaiser window of parameter 4, radius 3 */
    SHD_MIP_KERNEL_LANCZOS = 3,  /**< sinc(x) sinc(x / 3), radius 3 */
    SHD_MIP_KERNEL_MAX_ENUM = 0x7fffffff
} shd_mip_kernel;

/** Source of each level. */
typedef enum shd_mip_source {
    SHD_MIP_SOURCE_BASE = 0, /**< every level is made from the base and rounded once */
    /** Every level is made from the previous, stored level; faster for many levels, but rounding errors add up. */
    SHD_MIP_SOURCE_PREVIOUS = 1,
    SHD_MIP_SOURCE_MAX_ENUM = 0x7fffffff
} shd_mip_source;

/** Content of the texels, which decides how they are averaged. */
typedef enum shd_texel_content {
    SHD_TEXEL_CONTENT_COLOR = 0, /**< light: _SRGB formats are decoded before filtering */
    SHD_TEXEL_CONTENT_DATA = 1,  /**< numbers: _SRGB formats are filtered without decoding */
    /**
     * Unit vectors in three or four channels. Integer channels, of _SRGB formats too, hold (n + 1) / 2. Levels are
     * renormalised; a zero mean becomes (0, 0, 1). The fourth channel of a level is the length of the mean, at most 1;
     * materials compute a wider specular lobe from it (Toksvig, "Mipmapping Normal Maps", 2005). The caller sets the
     * fourth channel of the base, 1 for unit vectors.
     */
    SHD_TEXEL_CONTENT_NORMAL = 2,
    SHD_TEXEL_CONTENT_HEIGHT = 3, /**< as data */
    /**
     * Colour whose alpha is tested, in four channels. Alpha of every level is scaled so that the share of texels that
     * reach `alpha_cutoff` is the share of the base (Castano, "Computing Alpha Mipmaps", 2010). The share is exact to
     * the nearest texel, except where texels of equal alpha lie at the cutoff.
     */
    SHD_TEXEL_CONTENT_ALPHA_COVERAGE = 4,
    /**
     * Colour with straight alpha, in four channels. r, g and b of a level are averages weighted by alpha, as averages
     * of premultiplied colour: transparent texels do not shine through (Porter and Duff, "Compositing Digital Images",
     * 1984). The weight of a texel is max(alpha, 0) + 2^-20, so that colours under alpha 0 alone are averaged, too.
     */
    SHD_TEXEL_CONTENT_ALPHA_WEIGHTED = 5,
    SHD_TEXEL_CONTENT_MAX_ENUM = 0x7fffffff
} shd_texel_content;

/** Options of mip levels. Zero is the default of each except alpha_cutoff. */
typedef struct shd_mip_desc {
    uint32_t struct_size;      /**< set by shd_mip_desc_default() */
    shd_texel_content content; /**< default SHD_TEXEL_CONTENT_COLOR */
    shd_mip_kernel kernel;     /**< default SHD_MIP_KERNEL_BOX */
    shd_mip_source source;     /**< default SHD_MIP_SOURCE_BASE */
    /**
     * Texels beyond the edge, for kernels wider than the box; default SHD_WRAP_REPEAT. With SHD_WRAP_BORDER only texels
     * inside count, with weights scaled to sum 1.
     */
    shd_wrap wrap_u;
    shd_wrap wrap_v;    /**< as wrap_u, for v */
    float alpha_cutoff; /**< cutoff of SHD_TEXEL_CONTENT_ALPHA_COVERAGE, 0..1; default 0.5 */
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
 * Make mip levels 1..level_count of an image, in the caller's memory, on the context's executor.
 *
 * With the defaults the levels are those of SHD_TABLE_MIPMAP. Results are clamped to the range of the format, because
 * kernels with negative lobes can exceed it. Finite texels give finite levels.
 * @param base         at most 2^28 pixels; borrowed for the call
 * @param desc         borrowed for the call
 * @param level_count  0..floor(log2(max(width, height)))
 * @param levels       [level_count], all with the same struct_size; level l is levels[l - 1]: the format of the base,
 *                     max(1, width >> l) by max(1, height >> l). Pixels are written; they are unspecified if an
 *                     allocation or the executor fails. They must not overlap each other or the base (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mip_build(shd_context *context, const shd_image *base, const shd_mip_desc *desc,
                                               size_t level_count, const shd_image *levels);

/** Slope of a height field at a texel, in heights per texel. h(i) is the height i texels further along the axis. */
typedef enum shd_height_slope {
    SHD_HEIGHT_SLOPE_CENTRAL = 0, /**< (h(1) - h(-1)) / 2 */
    SHD_HEIGHT_SLOPE_FORWARD = 1, /**< h(1) - h(0), as SHD_BUMP_TEXEL */
    /** The mean of SHD_HEIGHT_SLOPE_CENTRAL over three rows with weights 1/4, 1/2, 1/4 (Sobel and Feldman 1968). */
    SHD_HEIGHT_SLOPE_SOBEL = 2,
    SHD_HEIGHT_SLOPE_MAX_ENUM = 0x7fffffff
} shd_height_slope;

/** Options of shd_mip_build_normals(). */
typedef struct shd_normals_desc {
    uint32_t struct_size;   /**< set by shd_normals_desc_default() */
    float scale;            /**< height of the value 1 [texels], -1e6..1e6; default 1 */
    shd_height_slope slope; /**< default SHD_HEIGHT_SLOPE_CENTRAL */
    shd_wrap wrap_u;        /**< heights beyond the edges; SHD_WRAP_BORDER is 0; default SHD_WRAP_REPEAT */
    shd_wrap wrap_v;        /**< as wrap_u, for v */
    /* ---- end of 0.1; append below ---- */
} shd_normals_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_normals_desc shd_normals_desc_default(void)
{
    shd_normals_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.scale = 1.0f;
    return desc;
}

/**
 * Make the normal map of a height map (Blinn, "Simulation of Wrinkled Surfaces", 1978).
 *
 * A texel is the unit vector along (-scale hx, scale hy, 1), with the slopes hx towards growing u and hy towards growing
 * v. So x points to the right in the image, y up and z out of it, as in glTF 2.0 and as SHD_SLOT_NORMAL reads it.
 * Integer channels hold (n + 1) / 2; a fourth channel is 1. The result is computed in double and rounded once.
 * @param heights  the first channel of any format that is not compressed; numbers, so _SRGB formats are not decoded.
 *                 Heights that are not finite count as 0. At most 2^28 pixels; borrowed for the call
 * @param desc     borrowed for the call; NULL = all defaults
 * @param out      three or four channels, the width and height of `heights`. Pixels are written; they are unspecified if
 *                 the executor fails. They must not overlap `heights` (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mip_build_normals(shd_context *context, const shd_image *heights,
                                                       const shd_normals_desc *desc, const shd_image *out);

/**
 * Turn a normal map into the moments of its slopes, whose averages keep the roughness of normals.
 *
 * A texel is (bx, by, bx^2, by^2) with (bx, by) = (nx / nz, ny / nz), and bx by in an image of its own (Olano and
 * Baker, "LEAN Mapping", 2010, section 3). Build the levels of the results as SHD_TEXEL_CONTENT_DATA; any filter may
 * read them. A filtered texel (bx, by, Mxx, Myy) and Mxy give the mean normal normalise(bx, by, 1) and the covariance
 * of slopes (Mxx - bx^2, Mxy - bx by; Mxy - bx by, Myy - by^2), over which lobes are averaged (shd_normal_encoding).
 *
 * nz is raised to at least 1/32 of the normal's length, so |bx| and |by| are at most 32. Normals that point backwards
 * are limited in the same way. A texel that is 0 or not finite becomes flat: four zeros.
 * @param normals  three or four channels, as for SHD_TEXEL_CONTENT_NORMAL, of any length; borrowed for the call
 * @param out      an image of that width and height, SHD_FORMAT_RGBA16F or SHD_FORMAT_RGBA32F. Pixels are written; they
 *                 are unspecified if the executor fails. They must not overlap `normals` (checked)
 * @param mixed    bx by, for SHD_SLOT_NORMAL_MIXED: as `out`, but SHD_FORMAT_R16F or SHD_FORMAT_R32F. NULL = not wanted
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mip_build_moments(shd_context *context, const shd_image *normals,
                                                       const shd_image *out, const shd_image *mixed);

SHD_END_DECLS

#endif /* SHD_MIP_H */
