/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Lights: points, directional lights, spots and ambient light, with light cookies.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a light never changes, so concurrent use is free.
 *
 * E is the irradiance of a surface that faces a light: I for a directional light, I / r^2 for a point or spot light at
 * distance r, with r^2 at least 1e-8, and 0 at r = 0. E is also multiplied by
 *  - max(0, 1 - (r / range)^4) if the light has a range (glTF extension KHR_lights_punctual): 0 beyond the range;
 *  - t^2 (3 - 2 t) for spots, with t = (cos a - cos outer) / (cos inner - cos outer) clamped to 0..1 and a the angle to
 *    the axis: 1 inside the inner cone, 0 outside the outer cone;
 *  - the light cookie, a texture that the light projects onto the scene.
 *
 * The factor pi: most models (Lambert, Phong, Blinn-Phong, combined, toon) reflect k_d E n.l without 1 / pi, as
 * graphics courses do. Metallic-roughness and normalised Blinn-Phong reflect k_d E n.l / pi, as glTF 2.0 and physics
 * do. The same light is therefore pi times darker with them. To keep the brightness of diffuse surfaces when the model
 * changes, multiply the intensity of point, spot and directional lights by pi = 3.14159265, or divide it by pi on the
 * way back. Ambient lights keep their intensity: no model divides I_a by pi. Example: a directional light of I = 1 at
 * n.l = 1 makes a white Lambert surface 1 and a white rough dielectric about 0.3; with I = 3.14159265 the latter is
 * about 1.
 *
 * @code
 * shd_light_desc desc = shd_light_desc_default();
 * desc.kind = SHD_LIGHT_KIND_SPOT;
 * desc.position[1] = 4.0f;     // above the origin
 * desc.direction[1] = -1.0f;   // downwards
 * desc.outer_angle = 0.5f;
 * desc.intensity[0] = desc.intensity[1] = desc.intensity[2] = 16.0f; // E = 1 at the origin: 16 / 4^2
 * result = shd_light_create(context, &desc, &light);
 * @endcode
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
    SHD_LIGHT_KIND_POINT = 0,       /**< from a point in all directions */
    SHD_LIGHT_KIND_DIRECTIONAL = 1, /**< parallel rays of equal E everywhere */
    SHD_LIGHT_KIND_AMBIENT = 2,     /**< I_a, from all directions; ambient lights add up */
    SHD_LIGHT_KIND_SPOT = 3,        /**< from a point into a cone */
    SHD_LIGHT_KIND_MAX_ENUM = 0x7fffffff
} shd_light_kind;

/** Kind, intensity and placement of a light. */
typedef struct shd_light_desc {
    uint32_t struct_size; /**< set by shd_light_desc_default() */
    shd_light_kind kind;  /**< default SHD_LIGHT_KIND_POINT */
    /** I, scene-linear RGB, 0..1e12; default 1. Points and spots: E = 1 at distance r takes I = r^2. */
    float intensity[3];
    /** Position of points, spots and the cookie of directional lights; world space, finite; default 0. */
    float position[3];
    /**
     * Directional lights and spots: direction of the light rays, world space, any length except 0; default (0, -1, 0).
     */
    float direction[3];
    /**
     * Points and spots: distance from which E is 0 [world units]; default 0 = no limit. Lights with a finite range are
     * culled beyond it.
     */
    float range;
    float inner_angle; /**< spots: half angle of the full cone [rad], 0..outer_angle; default 0 */
    /** Spots: half angle of the cone [rad], 0.001..pi/2, with a cookie up to 1.55; default pi/4. */
    float outer_angle;
    /**
     * Up direction of the cookie and of shadow maps, world space. Orthogonalised against `direction`; replaced by
     * another direction if parallel to it. Default (0, 1, 0).
     */
    float up[3];
    /**
     * Directional lights: width and height of the cookie [world units], above 0; default 1. The centre of the cookie
     * lies on the ray from `position`; with wraps that repeat, the cookie tiles the plane.
     */
    float extent[2];
    /**
     * Light cookie: a texture of colours that multiply E, as seen from the light. It covers the square around the outer
     * cone of a spot, or a rectangle of size `extent` for a directional light. The fourth channel is ignored. Points
     * and ambient lights have no cookie. NULL = none; retained.
     */
    shd_texture *texture;
    shd_sampler *sampler; /**< sampler of `texture`; NULL = bilinear, black outside; retained */
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
