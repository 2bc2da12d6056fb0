/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Lights.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a light never changes, so concurrent use is free.
 *
 * E is the irradiance of a surface that faces a light: I for a directional light, I / r^2 for a point or spot light at
 * distance r, with r^2 at least 1e-8, and 0 at r = 0. E is further scaled by
 *  - max(0, 1 - (r / range)^4) if the light has a range (glTF extension KHR_lights_punctual): 0 beyond the range;
 *  - t^2 (3 - 2 t) for spots, with t = (cos a - cos outer) / (cos inner - cos outer) clamped to 0..1 and a the angle to
 *    the axis: 1 inside the inner cone, 0 outside the outer cone;
 *  - the light cookie, a texture that the light projects onto the scene.
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
    SHD_LIGHT_POINT = 0,       /**< from a point in all directions */
    SHD_LIGHT_DIRECTIONAL = 1, /**< the same everywhere, from far away */
    SHD_LIGHT_AMBIENT = 2,     /**< I_a, from all directions; ambient lights are summed */
    SHD_LIGHT_SPOT = 3,        /**< from a point into a cone */
    SHD_LIGHT_KIND_MAX_ENUM = 0x7fffffff
} shd_light_kind;

/** What a light is made from. */
typedef struct shd_light_desc {
    uint32_t struct_size; /**< set by shd_light_desc_default() */
    shd_light_kind kind;  /**< default SHD_LIGHT_POINT */
    float intensity[3];   /**< I, scene-linear RGB, 0..1e12; default 1 */
    float position[3];    /**< of points and spots, and of the cookie of directional lights: world space, finite;
                               default 0 */
    float direction[3];   /**< of directional lights and spots: direction of the light rays, world space, any length
                               except 0; default (0, -1, 0) */
    uint32_t reserved;    /**< 0 */
    float range;       /**< of points and spots: distance from which E is 0, in world units; 0 = no limit, the default.
                               Lights with a finite range are culled beyond it */
    float inner_angle; /**< of spots: half angle of the full cone [rad], 0..outer_angle; default 0 */
    float outer_angle; /**< of spots: half angle of the cone [rad], 0.001..pi/2, with a cookie up to 1.55; default
                               pi/4 */
    float up[3];       /**< up direction of the cookie and of shadow maps, world space. Orthogonalised against
                               `direction`; replaced by another direction if parallel to it. Default (0, 1, 0) */
    float extent[2];   /**< of directional lights: width and height of the cookie in world units, above 0; default 1.
                               Its centre lies on the ray from `position`; samplers that repeat tile it */
    /**
     * Light cookie: a colour that multiplies E, seen from the light. It covers the square around the outer cone of a
     * spot, or a rectangle of `extent` of a directional light. The fourth channel is ignored. Points and ambient lights
     * have no cookie. NULL = none; retained.
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

/** Common sets of lights. */
typedef enum shd_light_preset {
    /**
     * Two points of intensity 500 at (30, 50, 20) and (-30, 50, 0), and ambient light of 10: the lights of graphics
     * courses, for models with k_a 0.005, k_s 0.7937 and p 150 seen from (0, 0, 10).
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
