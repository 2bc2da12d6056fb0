/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief What one lookup reads and how it is put together.
 *
 * Every filter of shd but SUMMED_AREA and EXACT is a tree of blends of texels, and the explanation is that tree,
 * recorded from the kernel itself. Replaying it in float gives exactly what shd_texture_sample gives:
 *
 *     node i < tap_count              v[i] = taps[i].value[c]
 *     node tap_count + k              v = s == 0 ? v[a] : v[a] + s * (v[b] - v[a]), with a, b, s of blends[k];
 *                                     (1 - s) * v[a] + s * v[b] where the difference overflows
 *     stored channel c                v * scale_high[c] + v * scale_low[c] of the last node; v where scale_low is 0
 *
 * Thread safety: concurrent reads.
 */
#ifndef SHD_EXPLAIN_H
#define SHD_EXPLAIN_H

#include <shd/lookup.h>

SHD_BEGIN_DECLS

/** A texel that a lookup reads. */
typedef struct shd_tap {
    uint32_t layer;   /**< of the array */
    uint32_t level_u; /**< times the width was halved: the mip level, or the ripmap's across */
    uint32_t level_v; /**< times the height was halved: the mip level, or the ripmap's down */
    uint32_t x;       /**< column, after wrapping */
    uint32_t y;       /**< row, after wrapping */
    uint32_t border;  /**< 1 = the border colour instead of the texel */
    float weight;     /**< in the result; those of all taps add up to 1 but for rounding */
    float value[4];   /**< stored channels as the blends see them: unorm ones as codes, unless on a border wrap */
} shd_tap;

/** A step of the tree. */
typedef struct shd_blend {
    uint32_t a; /**< node */
    uint32_t b; /**< node */
    float s;    /**< weight of b */
} shd_blend;

/** An explanation, with the caller's memory for its tables. */
typedef struct shd_explanation {
    uint32_t struct_size;    /**< set by shd_explanation_default() */
    uint32_t tap_capacity;   /**< taps there is room for */
    uint32_t blend_capacity; /**< blends there is room for */
    uint32_t tap_count;      /**< written: taps of the lookup */
    uint32_t blend_count;    /**< written: blends of the lookup; fewer than taps */
    uint32_t filter;         /**< written: shd_filter that was used, after magnification */
    shd_tap *taps;           /**< [tap_capacity], filled as far as they go; NULL with a capacity of 0 */
    shd_blend *blends;       /**< [blend_capacity], likewise */
    float result[4];         /**< written: r, g, b, a as shd_texture_sample gives them */
    float lod;               /**< written: level of detail of the longer axis, after bias and clamps */
    float scale_high[4];     /**< written: from the blends' units to the result, by stored channel */
    float scale_low[4];      /**< written */
    /** Written: the stored channel that r, g, b, a of the result are; 4 = the texture's `fill`. */
    uint32_t channel_source[4];
    /**
     * Written: longer half axis of the footprint's ellipse, u and v in base-level texels, width and blur included;
     * (2^lod, 0) where the lookup has a level of detail. At most 2^100 long.
     */
    float longer_axis[2];
    float shorter_axis[2]; /**< written: the shorter one, before any limit of their ratio */
    uint32_t reserved;     /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_explanation;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_explanation shd_explanation_default(void)
{
    shd_explanation explanation = SHD_ZERO_INIT;
    explanation.struct_size = (uint32_t)sizeof explanation;
    return explanation;
}

/**
 * Explain lookup `index` of a batch. Call once without memory for the counts, then again with it.
 * @param texture      concurrent reads
 * @param sampler      any filter but SUMMED_AREA and EXACT (SHD_ERROR_UNSUPPORTED)
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
