/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Lights.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a light never changes, so concurrent use is free.
 *
 * What a surface that faces a light gets of it is E: I of a directional light, I / r^2 of a point or spot light at
 * distance r, with r^2 not below 1e-8 and nothing at r = 0. That times
 *  - max(0, 1 - (r / range)^4) where there is a range (Khronos glTF extension KHR_lights_punctual): 0 from there on;
 *  - in spots t^2 (3 - 2 t), with t = (cos a - cos outer) / (cos inner - cos outer) held in 0..1 at the angle a off the
 *    axis: 1 inside the inner cone, 0 outside the outer one;
 *  - the light's texture, which it projects as a slide.
 */
#ifndef SHD_LIGHT_H
#define SHD_LIGHT_H

#include <shd/context.h>
#include <shd/sampler.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/** A source of light in world space. */
typedef struct shd_light shd_light;

/** Kind of light. */
typedef enum shd_light_kind {
    SHD_LIGHT_POINT = 0,       /**< from a point to all sides */
    SHD_LIGHT_DIRECTIONAL = 1, /**< the same everywhere, from far away */
    SHD_LIGHT_AMBIENT = 2,     /**< I_a, from all sides; several ambient lights add up */
    SHD_LIGHT_SPOT = 3,        /**< from a point into a cone */
    SHD_LIGHT_KIND_MAX_ENUM = 0x7fffffff
} shd_light_kind;

/** What a light is made from. */
typedef struct shd_light_desc {
    uint32_t struct_size; /**< set by shd_light_desc_default() */
    shd_light_kind kind;  /**< default SHD_LIGHT_POINT */
    float intensity[3];   /**< I, scene-linear RGB, 0..1e12; default 1 */
    float position[3];    /**< of points and spots, and of the texture of directional lights: world space, finite;
                               default 0 */
    float direction[3];   /**< of directional lights and spots: the way the light travels, world space; any length
                               but 0; default (0, -1, 0) */
    uint32_t reserved;    /**< 0 */
    float range;       /**< of points and spots: where they end, in world units; 0 = nowhere, the default. Lights that
                               end cost little where they do not reach */
    float inner_angle; /**< of spots: half angle of the full cone [rad], 0..outer_angle; default 0 */
    float outer_angle; /**< of spots: half angle of the cone [rad], 0.001..pi/2, with a texture up to 1.55; default
                               pi/4 */
    float up[3];       /**< world direction that is up in the texture and in shadow maps; what is not at a right angle
                               to `direction` does not count; along it, some other is taken; default (0, 1, 0) */
    float extent[2];   /**< of directional lights with a texture: its width and height in world units, above 0;
                               default 1. Its middle lies on the ray from `position`; samplers that repeat tile it */
    /**
     * Colour that multiplies E, as if seen from the light: of a spot the square around its outer cone, of a directional
     * light a rectangle of `extent`. The fourth channel does not count. NULL = none; retained. Not for points and
     * ambient lights.
     */
    shd_texture *texture;
    shd_sampler *sampler; /**< NULL = bilinear, black outside; retained */
    /* ---- end of 0.1; append below ---- */
} shd_light_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_light_desc shd_light_desc_default(void)
{
    shd_light_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.intensity[0] = desc.intensity[1] = desc.intensity[2] = 1.0f;
    desc.direction[1] = -1.0f;
    desc.outer_angle = 0.785398163f;
    desc.up[1] = 1.0f;
    desc.extent[0] = desc.extent[1] = 1.0f;
    return desc;
}

/** Sets of lights that are often wanted. */
typedef enum shd_light_preset {
    /**
     * Two points of intensity 500 at (30, 50, 20) and (-30, 50, 0), and ambient light of 10: what graphics courses
     * light their models with, seen from (0, 0, 10). The models' k_a is 0.005, k_s 0.7937 and p 150.
     */
    SHD_LIGHT_PRESET_TWO_POINTS = 0,
    SHD_LIGHT_PRESET_MAX_ENUM = 0x7fffffff
} shd_light_preset;

/**
 * Descs of a set of lights.
 * @param preset  which
 * @param count   in: room at `descs`; out: lights of the set
 * @param descs   [*count], filled as far as there is room; NULL = only count
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_light_preset_descs(shd_light_preset preset, size_t *count, shd_light_desc *descs);

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
