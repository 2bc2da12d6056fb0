/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Lights.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a light never changes, so concurrent use is free.
 */
#ifndef SHD_LIGHT_H
#define SHD_LIGHT_H

#include <shd/context.h>

SHD_BEGIN_DECLS

/** A source of light in world space. */
typedef struct shd_light shd_light;

/** Kind of light. */
typedef enum shd_light_kind {
    SHD_LIGHT_POINT = 0,       /**< irradiance I / r^2 at distance r, r^2 not below 1e-8; nothing at r = 0 */
    SHD_LIGHT_DIRECTIONAL = 1, /**< irradiance I everywhere */
    SHD_LIGHT_AMBIENT = 2,     /**< I_a; several ambient lights add up */
    SHD_LIGHT_KIND_MAX_ENUM = 0x7fffffff
} shd_light_kind;

/** What a light is made from. */
typedef struct shd_light_desc {
    uint32_t struct_size; /**< set by shd_light_desc_default() */
    shd_light_kind kind;  /**< default SHD_LIGHT_POINT */
    float intensity[3];   /**< I, scene-linear RGB, 0..1e12; default 1 */
    float position[3];    /**< point lights: world space, finite; default 0 */
    float direction[3];   /**< directional lights: the way the light travels, world space; any length but 0;
                               default (0, -1, 0) */
    uint32_t reserved;    /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_light_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_light_desc shd_light_desc_default(void)
{
    shd_light_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.intensity[0] = desc.intensity[1] = desc.intensity[2] = 1.0f;
    desc.direction[1] = -1.0f;
    return desc;
}

/**
 * Make a light.
 * @param context    retained
 * @param desc       borrowed for the call; NULL = all defaults
 * @param out_light  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_light_create(shd_context *context, const shd_light_desc *desc,
                                                  shd_light **out_light);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_light_retain(shd_light *light);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_light_release(shd_light *light);

SHD_END_DECLS

#endif /* SHD_LIGHT_H */
