/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief The texels that one lookup reads, and the blends that combine them.
 *
 * Every filter of shd except SUMMED_AREA and EXACT is a tree of blends of texels. The explanation is that tree,
 * recorded from the kernel itself. Replaying it in float gives exactly the values of shd_texture_sample():
 *
 *     node i < tap_count              v[i] = taps[i].value[c]
 *     node tap_count + k              v = s == 0 ? v[a] : v[a] + s * (v[b] - v[a]), with a, b, s of blends[k];
 *                                     (1 - s) * v[a] + s * v[b] where that is not finite, clamped to the largest
 *                                     floats if v[a] and v[b] are finite
 *     stored channel c                v * scale_high[c] + v * scale_low[c] of the last node; v where scale_low is 0
 *
 * Thread safety: concurrent reads.
 *
 * @code
 * shd_tap taps[64];
 * shd_explanation explanation = shd_explanation_default();
 * explanation.taps = taps, explanation.tap_capacity = 64;
 * result = shd_texture_explain(texture, sampler, &lookups, 0, &explanation);
 * for (i = 0; i < explanation.tap_count && i < 64; ++i) printf("%u %u %g\n", taps[i].x, taps[i].y, taps[i].weight);
 * @endcode
 */
#ifndef SHD_EXPLAIN_H
#define SHD_EXPLAIN_H

#include <shd/lookup.h>

SHD_BEGIN_DECLS

/** A texel that a lookup reads. Grows with shd_explanation.tap_size. */
typedef struct shd_tap {
    uint32_t layer;   /**< layer of the array */
    uint32_t level_u; /**< number of times the width was halved: the mip level, or the ripmap's level across */
    uint32_t level_v; /**< number of times the height was halved: the mip level, or the ripmap's level down */
    uint32_t x;       /**< column, after wrapping */
    uint32_t y;       /**< row, after wrapping */
    uint32_t z;       /**< slice of a 3D texture, after wrapping; else 0 */
    uint32_t border;  /**< 1 = the border colour instead of the texel, else 0 */
    float weight;     /**< share of the result; the weights of all taps sum to 1 up to rounding */
    /**
     * Stored channels as the blends read them: unorm channels as integers, unless a wrap is SHD_WRAP_BORDER; comparison
     * lookups: 0 or 1 in the channel of r.
     */
    float value[4];
} shd_tap;

/** A blend of two nodes of the tree. Grows with shd_explanation.blend_size. */
typedef struct shd_blend_step {
    uint32_t a; /**< node */
    uint32_t b; /**< node */
    float s;    /**< weight of b */
} shd_blend_step;

/** An explanation, with the caller's memory for its tables. */
typedef struct shd_explanation {
    uint32_t struct_size;   /**< set by shd_explanation_default() */
    shd_filter filter;      /**< written: the filter that was used, after magnification */
    float lod;              /**< written: level of detail of trilinear in the profile, after bias and clamps */
    float result[4];        /**< written: r, g, b, a of shd_texture_sample() with SHD_PRECISION_FULL */
    shd_tap *taps;          /**< [tap_capacity]; gets the first taps; NULL with a capacity of 0 */
    size_t tap_size;        /**< bytes of the caller's shd_tap; set by shd_explanation_default() */
    size_t tap_capacity;    /**< elements of `taps` */
    size_t tap_count;       /**< written: taps of the lookup */
    shd_blend_step *blends; /**< [blend_capacity]; gets the first blends; NULL with a capacity of 0 */
    size_t blend_size;      /**< bytes of the caller's shd_blend_step; set by shd_explanation_default() */
    size_t blend_capacity;  /**< elements of `blends` */
    size_t blend_count;     /**< written: blends of the lookup; fewer than taps */
    float scale_high[4];    /**< written: factor from the blends' units to the result, by stored channel */
    float scale_low[4];     /**< written: lower bits of that factor */
    /** Written: the stored channel of r, g, b, a of the result; 4 = a constant: `fill`, or 0, 0, 1 of comparisons. */
    uint32_t channel_source[4];
    /**
     * Written: longer half axis of the footprint's ellipse, u and v in base-level texels, width and blur included;
     * (2^lod, 0) if the lookup has a level of detail. At most 2^100 long. 3D textures: the first two components.
     */
    float longer_axis[2];
    float shorter_axis[2]; /**< written: the shorter half axis, before any limit of anisotropy; 0 for 3D textures */
    /* ---- end of 0.1; append below ---- */
} shd_explanation;

/** Defaults, compiled into the caller so that the sizes are the caller's. */
static inline shd_explanation shd_explanation_default(void)
{
    shd_explanation explanation = SHD_ZERO_INIT;
    explanation.struct_size = (uint32_t)sizeof explanation;
    explanation.tap_size = (uint32_t)sizeof(shd_tap);
    explanation.blend_size = (uint32_t)sizeof(shd_blend_step);
    return explanation;
}

/**
 * Explain lookup `index` of a batch. Call once without memory for the counts, then again with it.
 * @param texture      concurrent reads
 * @param sampler      any filter except SUMMED_AREA and EXACT (SHD_ERROR_UNSUPPORTED)
 * @param lookups      as for shd_texture_sample, borrowed for the call
 * @param index        0..lookups->count - 1
 * @param explanation  its tables are borrowed for the call
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_explain(const shd_texture *texture, const shd_sampler *sampler,
                                                     const shd_lookups *lookups, size_t index,
                                                     shd_explanation *explanation);

SHD_END_DECLS

#endif /* SHD_EXPLAIN_H */
