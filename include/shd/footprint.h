/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Texture derivatives for ray tracers: from ray differentials and from ray cones.
 *
 * A rasteriser computes the derivatives of (u, v) from plane equations. A ray tracer computes them at the hit of a ray
 * on a surface with the parametrisation dp/du, dp/dv. Both functions write the derivatives that shd_lookups reads.
 *
 * Defined for all inputs: the derivatives of an axis are 0 where dp/du and dp/dv are parallel, zero or not finite,
 * where the ray is parallel to the surface, and where a result would not be a finite float.
 *
 * Thread safety: any thread; the work is done on the calling thread.
 *
 * @code
 * shd_ray_cones cones = shd_ray_cones_default(); // fill count and columns
 * shd_derivatives derivatives = shd_derivatives_default();
 * derivatives.dudx = shd_f32_out_column(dudx, 0); // and so on
 * result = shd_derivatives_from_cones(&cones, &derivatives);
 * @endcode
 */
#ifndef SHD_FOOTPRINT_H
#define SHD_FOOTPRINT_H

#include <shd/column.h>
#include <shd/context.h>

SHD_BEGIN_DECLS

/** Columns for derivatives per pixel step; NULL = not wanted. */
typedef struct shd_derivatives {
    uint32_t struct_size;   /**< set by shd_derivatives_default() */
    shd_f32_out dudx;       /**< du/dx */
    shd_f32_out dvdx;       /**< dv/dx */
    shd_f32_out dudy;       /**< du/dy */
    shd_f32_out dvdy;       /**< dv/dy */
    size_t nonfinite_count; /**< written: hits with a number that is not finite */
    /* ---- end of 0.1; append below ---- */
} shd_derivatives;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_derivatives shd_derivatives_default(void)
{
    shd_derivatives derivatives = SHD_ZERO_INIT;
    derivatives.struct_size = (uint32_t)sizeof derivatives;
    return derivatives;
}

/** Hits of rays with their differentials, as columns of `count` elements; x, y, z in one space. */
typedef struct shd_ray_differentials {
    uint32_t struct_size;       /**< set by shd_ray_differentials_default() */
    size_t count;               /**< number of hits; 0 is allowed */
    shd_f32_in dpdu[3];         /**< change of the surface point with u; required */
    shd_f32_in dpdv[3];         /**< change of the surface point with v; required */
    shd_f32_in direction[3];    /**< direction of the ray, any length; required */
    shd_f32_in distance;        /**< distance to the hit, in lengths of `direction`; absent = 0 */
    shd_f32_in origin_dx[3];    /**< change of the ray's origin per pixel step in x; absent = 0 */
    shd_f32_in origin_dy[3];    /**< change of the ray's origin per pixel step in y; absent = 0 */
    shd_f32_in direction_dx[3]; /**< change of `direction` per pixel step in x; absent = 0 */
    shd_f32_in direction_dy[3]; /**< change of `direction` per pixel step in y; absent = 0 */
    /* ---- end of 0.1; append below ---- */
} shd_ray_differentials;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_ray_differentials shd_ray_differentials_default(void)
{
    shd_ray_differentials rays = SHD_ZERO_INIT;
    rays.struct_size = (uint32_t)sizeof rays;
    return rays;
}

/**
 * Compute derivatives from ray differentials.
 *
 * The change of the hit point is d(o + t d) + dt d, with dt chosen so that it lies in the surface. It is then expressed
 * in dp/du and dp/dv (Igehy, "Tracing Ray Differentials", 1999, sections 3.1 and 3.2).
 * @param context  its executor and SIMD target are used; concurrent reads
 * @param rays     columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_derivatives_from_differentials(shd_context *context,
                                                                    const shd_ray_differentials *rays,
                                                                    shd_derivatives *out);

/** Hits of rays with their cones, as columns of `count` elements; x, y, z in one space. */
typedef struct shd_ray_cones {
    uint32_t struct_size;    /**< set by shd_ray_cones_default() */
    size_t count;            /**< number of hits; 0 is allowed */
    shd_f32_in dpdu[3];      /**< change of the surface point with u; required */
    shd_f32_in dpdv[3];      /**< change of the surface point with v; required */
    shd_f32_in direction[3]; /**< direction of the ray, any length; required */
    shd_f32_in width;        /**< diameter of the cone at the hit, in the units of the points; required */
    /* ---- end of 0.1; append below ---- */
} shd_ray_cones;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_ray_cones shd_ray_cones_default(void)
{
    shd_ray_cones cones = SHD_ZERO_INIT;
    cones.struct_size = (uint32_t)sizeof cones;
    return cones;
}

/**
 * Compute derivatives from ray cones.
 *
 * The derivatives are the axes of the ellipse in which the cone meets the surface: along the projected direction (x)
 * and across it (y). Each is as long as the ellipse in its direction (Akenine-Moller et al., "Improved Shader and
 * Texture Level of Detail Using Ray Cones", 2021, section 5). Angles between ray and surface below 2^-10 rad count as
 * 2^-10 rad.
 * @param context  its executor and SIMD target are used; concurrent reads
 * @param cones    columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_derivatives_from_cones(shd_context *context, const shd_ray_cones *cones,
                                                            shd_derivatives *out);

SHD_END_DECLS

#endif /* SHD_FOOTPRINT_H */
