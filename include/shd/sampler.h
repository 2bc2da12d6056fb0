/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Samplers: filter, wrap and level of detail of texture lookups.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a sampler never changes, so concurrent use is free.
 *
 * @code
 * shd_sampler_desc desc = shd_sampler_desc_default();
 * desc.filter = SHD_FILTER_ANISOTROPIC;
 * desc.max_anisotropy = 8.0f;
 * result = shd_sampler_create(context, &desc, &sampler);
 * @endcode
 *
 * A shadow map is compared with the depth of each lookup, and the results are filtered:
 *
 * @code
 * desc = shd_sampler_desc_default();
 * desc.filter = SHD_FILTER_BILINEAR, desc.wrap_u = desc.wrap_v = SHD_WRAP_CLAMP;
 * desc.compares = 1, desc.compare = SHD_COMPARE_LESS_EQUAL;
 * result = shd_sampler_create(context, &desc, &compare);
 * lookups.reference = shd_f32_column(depth, 0);
 * result = shd_texture_sample(shadow_map, compare, &lookups, &lit);
 * @endcode
 */
#ifndef SHD_SAMPLER_H
#define SHD_SAMPLER_H

#include <shd/context.h>
#include <shd/wrap.h>

SHD_BEGIN_DECLS

/** A filter with its settings, for any texture. */
typedef struct shd_sampler shd_sampler;

/**
 * Reconstruction and minification filter.
 *
 * Filters that use mip levels read only level 0 of a texture without a mipmap. Ripmap and summed-area lookups are
 * refused if the texture does not have the table.
 */
typedef enum shd_filter {
    /** Bilinear on the two nearest mip levels, blended by the fraction of the level of detail (Williams 1983). */
    SHD_FILTER_TRILINEAR = 0,
    SHD_FILTER_NEAREST = 1,  /**< the texel of level 0 that contains (u, v) */
    SHD_FILTER_BILINEAR = 2, /**< the four texels of level 0 around (u, v) */
    /** The 4 x 4 texels of level 0 around (u, v), weighted by the cubic `cubic` (Mitchell and Netravali 1988). */
    SHD_FILTER_BICUBIC = 3,
    SHD_FILTER_NEAREST_MIP = 4,  /**< the texel of the nearest mip level that contains (u, v) */
    SHD_FILTER_BILINEAR_MIP = 5, /**< bilinear on the nearest mip level */
    /** Bilinear on the four nearest ripmap levels, which halve each axis on its own. Needs SHD_TABLE_RIPMAP. */
    SHD_FILTER_RIPMAP = 6,
    /**
     * The average of the texels over `box`, where each texel is a square of constant value, from sums over rectangles
     * (Crow 1984). Needs SHD_TABLE_SUMMED_AREA. Sides of a box are at least 1 texel, which makes magnification
     * bilinear, and at most 2^22. Bias and clamps of the level of detail apply to log2 of a side; `lod` is a square of
     * 2^lod texels. If a box touches a texel that is not finite, the result is NaN in its channel.
     */
    SHD_FILTER_SUMMED_AREA = 7,
    /** Trilinear probes of the footprint's shorter axis, along the longer one (McCormack et al. 1999). */
    SHD_FILTER_ANISOTROPIC = 8,
    /**
     * The texels inside the footprint's ellipse, weighted by exp(-2 r^2) - exp(-2) with r from 0 at its centre to 1 on
     * its edge (Greene and Heckbert 1986), on the mip level on which the footprint's shorter half axis b is 1..2
     * texels, b >= a / max_anisotropy; on the finest level, b = max(b, 1). Half axes: sqrt(0.84^2 a^2 + c) and
     * sqrt(0.84^2 b^2 + c) in texels of level l, c = 1 - 0.6127 (1 - 4^-l): Heckbert's reconstruction filter without
     * the averaging of level l. Bilinear where a is at most one texel of level 0; blended from bilinear to EWA where a
     * is one to two texels. `lod` is a circle. Reads at most 16 (max_anisotropy + 1) texels, 4 times as many in 3D.
     */
    SHD_FILTER_EWA = 9,
    /** An unbiased estimate of the filter that `stochastic_filter` names, from what shd_stochastic picks at random. */
    SHD_FILTER_STOCHASTIC = 10,
    /**
     * The average of the bilinear reconstruction over the footprint's parallelogram, computed in double: the ground
     * truth. It uses the finest level on which the parallelogram covers at most 16 / tolerance^2 cells (2^10..2^24). If
     * it covers more cells even on the coarsest level, it is shortened to this number. `lod` is a square of 2^lod
     * texels, in 3D a box. docs/filter-exact.md has its definition on images of directions. Slow.
     */
    SHD_FILTER_EXACT = 11,
    /**
     * The texels that contain (u, v) of the two nearest mip levels, blended by the fraction of the level of detail:
     * VK_FILTER_NEAREST with VK_SAMPLER_MIPMAP_MODE_LINEAR, GL_NEAREST_MIPMAP_LINEAR, D3D's MIN_MAG_POINT_MIP_LINEAR.
     */
    SHD_FILTER_NEAREST_MIP_LINEAR = 12,
    /**
     * The texels of BILINEAR with smooth weights: the fraction s of the way between two texels becomes 3 s^2 - 2 s^3
     * (Hermite interpolation with slopes of 0 at the texels; Perlin 1985). Derivatives are continuous, so no creases
     * show as Mach bands, and values stay between those of the texels. Each texel becomes a flat spot.
     */
    SHD_FILTER_HERMITE = 13,
    SHD_FILTER_MAX_ENUM = 0x7fffffff
} shd_filter;

/**
 * Filter for magnification: where the level of detail of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP and TRILINEAR is
 * 0 or below, and where the footprint of all other filters is at most one texel long.
 */
typedef enum shd_magnification {
    /**
     * The default of the filter: nearest for NEAREST, NEAREST_MIP and NEAREST_MIP_LINEAR, bicubic for BICUBIC, Hermite
     * for HERMITE, bilinear for all others.
     */
    SHD_MAGNIFICATION_DEFAULT = 0,
    SHD_MAGNIFICATION_NEAREST = 1,  /**< SHD_FILTER_NEAREST */
    SHD_MAGNIFICATION_BILINEAR = 2, /**< SHD_FILTER_BILINEAR */
    SHD_MAGNIFICATION_BICUBIC = 3,  /**< SHD_FILTER_BICUBIC */
    SHD_MAGNIFICATION_HERMITE = 4,  /**< SHD_FILTER_HERMITE */
    SHD_MAGNIFICATION_MAX_ENUM = 0x7fffffff
} shd_magnification;

/** Cubic kernels by their (B, C) of Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (1988). */
typedef enum shd_cubic {
    SHD_CUBIC_CATMULL_ROM = 0, /**< (0, 1/2): interpolates, overshoots */
    SHD_CUBIC_B_SPLINE = 1,    /**< (1, 0): smooths, never overshoots */
    SHD_CUBIC_MITCHELL = 2,    /**< (1/3, 1/3): in between */
    SHD_CUBIC_MAX_ENUM = 0x7fffffff
} shd_cubic;

/** Weights of the probes of SHD_FILTER_ANISOTROPIC along the longer axis. */
typedef enum shd_probe_weights {
    SHD_PROBE_WEIGHTS_EQUAL = 0,    /**< a box */
    SHD_PROBE_WEIGHTS_GAUSSIAN = 1, /**< exp(-2 x^2), x = -1..1 from end to end of the probes */
    SHD_PROBE_WEIGHTS_MAX_ENUM = 0x7fffffff
} shd_probe_weights;

/** Area that SHD_FILTER_SUMMED_AREA averages. */
typedef enum shd_box {
    /** The bounding rectangle of the footprint's parallelogram: |dudx| + |dudy| by |dvdx| + |dvdy|. */
    SHD_BOX_BOUNDING = 0,
    /**
     * The average over the bounding rectangles of N equal parts of the parallelogram along its longer side a. If b is
     * the other side in texels, N = ceil(|a| / max(|b|, 1)), at most max_anisotropy.
     */
    SHD_BOX_ORIENTED = 1,
    SHD_BOX_MAX_ENUM = 0x7fffffff
} shd_box;

/**
 * Definition of the level of detail, the levels and the probes of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP,
 * TRILINEAR and ANISOTROPIC.
 *
 * LEAST_ERROR differs from EXACT in RIPMAP as well, and in STOCHASTIC of these filters. All other filters are the same
 * in all profiles, because EWA, SUMMED_AREA and EXACT have the least error as they are.
 *
 * Mean PSNR [dB] of five scenes under a box of one pixel and a tent of two: four photographs, then checker, noise and
 * zone plate. docs/filters.md has more rules and figures, measured by `SHD_BENCH_PHOTOGRAPHS=folder shd-bench
 * --benchmark_filter=^default/` (bench/README.md).
 *
 * | filter | LEAST_ERROR | EXACT | OpenImageIO |
 * |---|---|---|---|
 * | BILINEAR_MIP | 41.0 41.2, 34.2 33.5 | 37.0 39.0, 31.9 33.1 | 34.5 36.3, 29.4 31.5 |
 * | TRILINEAR | 42.7 43.0, 36.3 35.1 | 37.5 40.1, 33.3 34.5 | 39.5 41.5, 34.1 34.7 |
 * | ANISOTROPIC (16) | 49.5 46.2, 43.4 37.6 | 46.1 46.6, 42.8 38.9 | 43.8 47.5, 38.1 39.0 |
 * | RIPMAP | 44.4 44.9, 37.7 36.2 | 40.5 43.8, 36.9 37.1 | |
 *
 * Below, x and y are the columns of the matrix J of derivatives in base-level texels, a = max_anisotropy, and lambda is
 * the level of detail before bias and clamps.
 */
typedef enum shd_profile {
    /**
     * The levels of least measured error, a little finer than the footprint. Let s1 >= s2 be the singular values of J,
     * and rms(x, y) = sqrt((x^2 + y^2) / 2). lambda = log2(rms(s1, s2)) - 3/8. ANISOTROPIC: r = min(s1 / s2, a), lambda
     * = log2(rms(s1 / r, s2)) - 1/8 - 1 / (4 r), and ceil(r - 1/8) probes along the longer axis. RIPMAP: log2 of the
     * extent along each axis, less 3/8. The column `lod` of lookups is used as it is.
     */
    SHD_PROFILE_LEAST_ERROR = 0,
    /**
     * Vulkan 1.3 specification, "Image Operations": lambda = log2(max(|x|, |y|)). ANISOTROPIC: eta = min(longer /
     * shorter, a) for the longer and the shorter one of x and y, lambda = log2(longer / eta), and ceil(eta) probes of
     * equal weight at i / (ceil(eta) + 1) - 1/2 of the longer one. Fractions of levels and weights of bilinear lookups
     * (BILINEAR's too) have 8 bits, as most desktop GPUs report in mipmapPrecisionBits and subTexelPrecisionBits.
     * Weights of textures with a projection are not rounded.
     */
    SHD_PROFILE_VULKAN = 1,
    /**
     * Direct3D 11.3 functional specification, 7.18.10 and 7.18.11: lambda = log2(m), with m the major axis of J's
     * ellipse, or the longer of x and y if they are parallel. ANISOTROPIC: r = min(m^2 / |det J|, a), lambda = log2(m /
     * r), ceil(min(r, max(m, 1))) probes along m. The specification does not define the places and weights of probes;
     * shd uses the places and weights of SHD_PROFILE_VULKAN. Fractions of levels and weights of bilinear lookups have
     * 8 bits, as in SHD_PROFILE_VULKAN, and the nearest level is floor(lod + 1/2).
     */
    SHD_PROFILE_D3D11 = 2,
    /**
     * OpenImageIO 2.4, TextureSystem with default options. The width w of the filter, in units of the texture, is the
     * largest of |du/dx| .. |dv/dy| plus the larger blur. The coarser level is the first one on which w is at most one
     * texel of the smaller side; the finer level is the next finer one. The weight of the coarser level is 2 w - 1,
     * with w in texels of this level; NEAREST_MIP and BILINEAR_MIP use the coarser level. ANISOTROPIC: axes m >= n of
     * the ellipse in units of the texture, lengthened by blur; where m > a n they become m' = (m + a n) / 2 and n' = m'
     * / a. Levels by w = n. N = floor(2 m / n - 1) probes, at least 1 and at most one per half texel of level 0, at p
     * (m - n), p = (2 k + 1 - N) / N, k = 0 to N - 1, of weight exp(-2 x^2), x = p m / (2 (m - n)). `width_x` and
     * `width_y` scale the derivatives of u and of v, as swidth and twidth do.
     */
    SHD_PROFILE_OIIO = 3,
    /** As LEAST_ERROR with lambda = log2(s1), log2(s1 / r) for ANISOTROPIC, and without the 3/8 of a level. */
    SHD_PROFILE_EXACT = 4,
    SHD_PROFILE_MAX_ENUM = 0x7fffffff
} shd_profile;

/** Arithmetic of lookups. Each has the same bits on every SIMD target. */
typedef enum shd_precision {
    SHD_PRECISION_FULL = 0, /**< weights and sums are binary32 floats */
    /**
     * Texels are blended in integers of 16 bits, with fractions of 15 bits. Values are within 2^-11 of
     * SHD_PRECISION_FULL, an eighth of a step of 8 bits. Where all texels are equal, values have the same bits.
     *
     * Levels of detail are the same. In LEAST_ERROR and EXACT, ANISOTROPIC blends levels in a part of the way between
     * them: it has the levels and probes of a level_blend of at most 9/32. Its values are within
     * 2^-11 + 2^-22 (width + height) of SHD_PRECISION_FULL with that level_blend, for footprints of up to 4 textures.
     *
     * It applies to 2D textures of 8-bit unorm formats of one to four channels, the filters BILINEAR, BILINEAR_MIP,
     * TRILINEAR and ANISOTROPIC with equal weights of the probes, and every wrap except SHD_WRAP_BORDER. All other
     * lookups, derivatives of values, and shd_texture_explain() have SHD_PRECISION_FULL.
     *
     * Choose it for pictures of 8 bits. Keep SHD_PRECISION_FULL for measurements, and for values whose differences
     * matter, such as heights and normals.
     */
    SHD_PRECISION_FAST = 1,
    SHD_PRECISION_MAX_ENUM = 0x7fffffff
} shd_precision;

/**
 * Random choice of SHD_FILTER_STOCHASTIC. The expected value of each is the named filter F = sum of w_k t_k, with the
 * texels t_k and their weights w_k.
 */
typedef enum shd_stochastic {
    /** One texel, with its weight as the probability. Variance: sum of w_k (t_k - F)^2. */
    SHD_STOCHASTIC_TEXEL = 0,
    /**
     * One of the two levels of TRILINEAR, or one probe of ANISOTROPIC and one of its levels; then the bilinear lookup
     * b_i of its four texels, or eight in 3D. With the probabilities p_i the variance is sum of p_i (b_i - F)^2: the
     * variance of one texel less the mean variance within a quad. Where the level of detail is at most 0, trilinear has
     * none. Other filters are refused.
     */
    SHD_STOCHASTIC_QUAD = 1,
    SHD_STOCHASTIC_MAX_ENUM = 0x7fffffff
} shd_stochastic;

/** Lookups where a tile of the texture is not in memory (shd/tile_cache.h). No effect for other textures. */
typedef enum shd_missing_tiles {
    SHD_MISSING_TILES_WAIT = 0, /**< load the tile; the result does not depend on the content of the cache */
    /**
     * Never load and wait for no callback: filter from the finest levels with resident tiles, and request missing ones
     * (shd_tile_cache_load_requested()). A lookup that needs a missing tile of level l is done again with a level of
     * detail of at least l + 1, and so on; BILINEAR, BICUBIC and HERMITE become BILINEAR_MIP, and NEAREST becomes
     * NEAREST_MIP. If no tile of any level is resident, the result is 0. shd_texels has the column `coarser`.
     */
    SHD_MISSING_TILES_COARSER = 1,
    SHD_MISSING_TILES_MAX_ENUM = 0x7fffffff
} shd_missing_tiles;

/**
 * Comparisons `z OP d`: of a depth z with the depth d of a sample in depth tests, or of a reference z with a texel d in
 * comparison lookups (shd_sampler_desc.compares). If z or d is NaN, every comparison except ALWAYS is false.
 */
typedef enum shd_compare {
    SHD_COMPARE_LESS = 0,          /**< z < d */
    SHD_COMPARE_LESS_EQUAL = 1,    /**< z <= d */
    SHD_COMPARE_EQUAL = 2,         /**< z = d */
    SHD_COMPARE_GREATER_EQUAL = 3, /**< z >= d */
    SHD_COMPARE_GREATER = 4,       /**< z > d, for depth that decreases with the distance (clear_depth 0) */
    SHD_COMPARE_NOT_EQUAL = 5,     /**< z < d or z > d */
    SHD_COMPARE_ALWAYS = 6,        /**< true */
    SHD_COMPARE_NEVER = 7,         /**< false */
    SHD_COMPARE_MAX_ENUM = 0x7fffffff
} shd_compare;

/** Settings of a sampler. */
typedef struct shd_sampler_desc {
    uint32_t struct_size;            /**< set by shd_sampler_desc_default() */
    shd_filter filter;               /**< default SHD_FILTER_TRILINEAR */
    shd_magnification magnification; /**< default SHD_MAGNIFICATION_DEFAULT */
    shd_wrap wrap_u;                 /**< default SHD_WRAP_REPEAT */
    shd_wrap wrap_v;                 /**< default SHD_WRAP_REPEAT */
    shd_wrap wrap_w; /**< across the slices of a 3D texture; no effect for others; default SHD_WRAP_REPEAT */
    /**
     * Colour of texels outside with SHD_WRAP_BORDER: stored r, g, b, a, linear, before the swizzle of the texture;
     * channels that come from its `fill` are `fill` outside, too; finite; default 0.
     */
    float border[4];
    /** Default SHD_PROFILE_LEAST_ERROR. It also determines which lookups are magnified (shd_magnification). */
    shd_profile profile;
    float lod_bias; /**< added to the level of detail, -15..15; default 0 */
    float lod_min;  /**< lowest level of detail, 0..32; default 0; it is used where lod_max is lower */
    float lod_max;  /**< highest level of detail, 0..32; default 32 */
    /**
     * Part of the way between two mip levels in which TRILINEAR, NEAREST_MIP_LINEAR and ANISOTROPIC in LEAST_ERROR and
     * EXACT blend them, 0..1; default 1. If f is the fraction of the level of detail, the share of the coarser level is
     * clamp((f - 1/2) / level_blend + 1/2, 0, 1), and a level without share is not read. With 0, only the nearer level
     * is read.
     */
    float level_blend;
    float width_x;        /**< factor of the derivatives in x, 0..64; default 1 */
    float width_y;        /**< factor of the derivatives in y, 0..64; default 1 */
    float blur_u;         /**< blur in u, 0..1, added to the footprint as covariance; default 0 */
    float blur_v;         /**< blur in v, 0..1, added to the footprint as covariance; default 0 */
    float max_anisotropy; /**< largest ratio of the footprint's axes, 1..64; default 16 */
    /**
     * Largest number of texels that a lookup of ANISOTROPIC or EWA reads; in 3D textures 2 or 4 times as many. 0 = no
     * limit besides max_anisotropy, or 32 or more; default 0. It limits the ratio of the footprint's axes as
     * max_anisotropy does: longer footprints use coarser levels.
     */
    uint32_t max_texels;
    shd_probe_weights
        probe_weights; /**< weights of ANISOTROPIC in LEAST_ERROR and EXACT; default SHD_PROBE_WEIGHTS_EQUAL */
    /**
     * Length by which a footprint may exceed the probes of ANISOTROPIC in LEAST_ERROR and EXACT before another one is
     * added, in widths of a probe, 0..1; default 1/8. A footprint r times as long as wide has ceil(r - probe_slack)
     * probes.
     */
    float probe_slack;
    shd_cubic cubic; /**< kernel of bicubic filters; default SHD_CUBIC_CATMULL_ROM */
    shd_box box;     /**< area of SHD_FILTER_SUMMED_AREA; default SHD_BOX_BOUNDING */
    float tolerance; /**< tolerance of SHD_FILTER_EXACT, 2^-12..1; default 2^-6 */
    /**
     * Filter that SHD_FILTER_STOCHASTIC estimates: BILINEAR, BICUBIC (B-spline only), TRILINEAR, ANISOTROPIC or EWA;
     * default SHD_FILTER_TRILINEAR.
     */
    shd_filter stochastic_filter;
    shd_stochastic stochastic; /**< random choice of SHD_FILTER_STOCHASTIC; default SHD_STOCHASTIC_TEXEL */
    uint32_t seed;             /**< seed of SHD_FILTER_STOCHASTIC; default 0 */
    /**
     * 1 = comparison lookups, as texture units have them for shadow maps (percentage-closer filtering; Reeves, Salesin
     * and Cook 1987; Vulkan 1.3 specification, "Depth Compare Operation"); 0 = lookups return texels; default 0. Each
     * texel that the filter reads becomes 1 if the comparison of the lookup's `reference` with it is true, else 0. The
     * filter blends these numbers. The result is in r; g and b are 0, and a is 1.
     *
     * A texel is its channel of r after the texture's swizzle, which may be a constant of `fill`. Texels outside with
     * SHD_WRAP_BORDER have the border colour. UNORM and SRGB formats clamp the reference to [0, 1]. Numbers are
     * compared as floats, after sRGB is decoded.
     *
     * Works with NEAREST, BILINEAR, NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP, TRILINEAR and ANISOTROPIC on all
     * textures. Other filters, derivatives, and samplers of materials, lights and tessellations return
     * SHD_ERROR_UNSUPPORTED. SHD_PRECISION_FAST has no effect.
     */
    uint32_t compares;
    shd_compare compare;             /**< comparison of these lookups; default SHD_COMPARE_LESS */
    shd_precision precision;         /**< default SHD_PRECISION_FULL */
    shd_missing_tiles missing_tiles; /**< default SHD_MISSING_TILES_WAIT */
    /* ---- end of 0.1; append below ---- */
} shd_sampler_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_sampler_desc shd_sampler_desc_default(void)
{
    shd_sampler_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.lod_max = 32.0f;
    desc.width_x = desc.width_y = 1.0f;
    desc.max_anisotropy = 16.0f;
    desc.tolerance = 0.015625f;
    desc.probe_slack = 0.125f;
    desc.level_blend = 1.0f;
    return desc;
}

/**
 * Make a sampler.
 * @param context      retained
 * @param desc         borrowed for the call; NULL = all defaults
 * @param out_sampler  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_sampler_create(shd_context *context, const shd_sampler_desc *desc,
                                                    shd_sampler **out_sampler);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_sampler_retain(shd_sampler *sampler);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_sampler_release(shd_sampler *sampler);

SHD_END_DECLS

#endif /* SHD_SAMPLER_H */
