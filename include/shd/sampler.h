/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief How a texture is looked up: filter, wrap and level of detail.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a sampler never changes, so concurrent use is free.
 */
#ifndef SHD_SAMPLER_H
#define SHD_SAMPLER_H

#include <shd/context.h>

SHD_BEGIN_DECLS

/** A filter with its settings; belongs to no texture. */
typedef struct shd_sampler shd_sampler;

/** Reconstruction and minification filter. */
typedef enum shd_filter {
    /** Bilinear on the two nearest mip levels, blended by the fraction of the level of detail (Williams 1983). */
    SHD_FILTER_TRILINEAR = 0,
    SHD_FILTER_NEAREST = 1,  /**< the texel of level 0 that contains (u, v) */
    SHD_FILTER_BILINEAR = 2, /**< the four texels of level 0 around (u, v) */
    SHD_FILTER_MAX_ENUM = 0x7fffffff
} shd_filter;

/** What lies outside [0, 1), for texel index i of n (Vulkan specification, "Wrapping Operation"). */
typedef enum shd_wrap {
    SHD_WRAP_REPEAT = 0, /**< i mod n */
    SHD_WRAP_CLAMP = 1,  /**< clamp(i, 0, n - 1) */
    SHD_WRAP_MIRROR = 2, /**< repeat with every second copy flipped */
    SHD_WRAP_BORDER = 3, /**< the border colour outside 0..n - 1 */
    SHD_WRAP_MAX_ENUM = 0x7fffffff
} shd_wrap;

/** Settings of a sampler. */
typedef struct shd_sampler_desc {
    uint32_t struct_size; /**< set by shd_sampler_desc_default() */
    shd_filter filter;    /**< default SHD_FILTER_TRILINEAR */
    shd_wrap wrap_u;      /**< default SHD_WRAP_REPEAT */
    shd_wrap wrap_v;      /**< default SHD_WRAP_REPEAT */
    float border[4];      /**< r, g, b, a, linear; finite; default 0. One-channel formats read r */
    float lod_bias;       /**< added to the level of detail, -15..15; default 0 */
    float lod_min;        /**< lowest level of detail, 0..32; default 0; wins over lod_max */
    float lod_max;        /**< highest level of detail, 0..32; default 32 */
    uint32_t reserved;    /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_sampler_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_sampler_desc shd_sampler_desc_default(void)
{
    shd_sampler_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.lod_max = 32.0f;
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
