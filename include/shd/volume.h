/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Volumes: 3D textures of density, rendered by marching rays with a transfer function.
 *
 * A volume fills a box. A ray through the centre of a pixel enters the box and leaves it, or ends at the depth of a
 * sample. This part of length L is divided into n = ceil(L / step) equal steps of dt = L / n, at most
 * SHD_MAX_VOLUME_STEPS. At a point of step k, the density of the texture gives a colour c and an extinction sigma by
 * the transfer function. Steps are accumulated from front to back, until A exceeds 0.999 (Levoy, "Efficient Ray Tracing
 * of Volume Data", 1990):
 *
 *     a = 1 - exp(-sigma dt),  C += (1 - A) c a,  A += (1 - A) a
 *
 * (C, A) is then blended over the pixel as a premultiplied colour. Transmittance 1 - A is in [0, 1] for any input.
 *
 * Density is the red channel of lookups of level 0, linear on three axes, with clamped edges. NaN counts as 0. Below
 * the first point and above the last one, the values are those of that point.
 *
 * Lifetime:      reference counted; create returns an owned reference. The texture must not change afterwards.
 * Thread safety: retain/release from any thread; a volume never changes, so concurrent renders may use it.
 *
 * @code
 * const float density[2] = {0.1f, 1.0f}, extinction[2] = {0.0f, 20.0f};
 * shd_volume_desc desc = shd_volume_desc_default();
 * shd_volume_draw draw = shd_volume_draw_default();
 * desc.texture = texture; // shd_texture_desc.depth is not 0
 * desc.point_count = 2;
 * desc.density = shd_f32_column(density, 0), desc.extinction = shd_f32_column(extinction, 0);
 * result = shd_volume_create(context, &desc, &volume);
 * draw.volume = volume;
 * render.volumes = &draw, render.volume_count = 1;
 * @endcode
 */
#ifndef SHD_VOLUME_H
#define SHD_VOLUME_H

#include <shd/column.h>
#include <shd/material.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/** Largest number of steps of a ray through one volume. */
#define SHD_MAX_VOLUME_STEPS 4096

/** A density field with its transfer function. */
typedef struct shd_volume shd_volume;

/** Density, transfer function, steps and shading of a volume. Required: point_count, texture, density, extinction. */
typedef struct shd_volume_desc {
    uint32_t struct_size; /**< set by shd_volume_desc_default() */
    float step;           /**< length of a step [world units], above 0, at most 1e12; default 1/256 */
    shd_texture *texture; /**< 3D texture; retained */
    size_t point_count;   /**< points of the transfer function, 1..256 */
    /**
     * [point_count] densities of the points, -1e38..1e38, never decreasing. Values are interpolated between points; two
     * points of one density are a jump.
     */
    shd_f32_in density;
    shd_f32_in extinction; /**< [point_count] sigma [1 / world unit], 0..1e12 */
    /** [point_count] scene-linear r, g, b, 0..1e6: radiance, or the diffuse colour of `material`; absent = 1. */
    shd_f32_in color[3];
    /**
     * Shades the points by the lights of the frame, with shadows and cookies, but not by its environment: an opaque
     * material without slots and debug view, of a model that reflects light; others are SHD_ERROR_UNSUPPORTED. Its
     * diffuse colour is multiplied by `color`. The normal is the direction in which density falls fastest, by central
     * differences over two texels; it faces the viewer where the gradient is 0, and always with
     * SHD_MATERIAL_DOUBLE_SIDED. NULL = `color` is radiance; retained.
     */
    shd_material *material;
    float bounds_min[3]; /**< corner of the texture's (0, 0, 0) in object space, finite; default 0 */
    float bounds_max[3]; /**< corner of the texture's (1, 1, 1); above bounds_min on each axis; default 1 */
    /**
     * The point of a step lies at a fraction 1/2 + jitter (h - 1/2) of the step, with h in [0, 1) hashed from the pixel
     * of the picture and `seed`; 0..1; default 0.
     */
    float jitter;
    uint32_t seed; /**< seed of the jitter; default 0 */
    /* ---- end of 0.1; append below ---- */
} shd_volume_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_volume_desc shd_volume_desc_default(void)
{
    shd_volume_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.bounds_max[0] = desc.bounds_max[1] = desc.bounds_max[2] = 1.0f;
    desc.step = 0.00390625f;
    return desc;
}

/**
 * Make a volume. Finds the range of density in each block of the texture, so that rays skip blocks without extinction;
 * the pictures have the same bits as without skipping. A texture in tiles loads each tile of its base level once; a
 * tile that cannot be loaded fails the call.
 * @param context     retained
 * @param desc        borrowed for the call
 * @param out_volume  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_volume_create(shd_context *context, const shd_volume_desc *desc,
                                                   shd_volume **out_volume);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_volume_retain(shd_volume *volume);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_volume_release(shd_volume *volume);

/** One volume in the frame. Required: volume. */
typedef struct shd_volume_draw {
    uint32_t struct_size;      /**< set by shd_volume_draw_default(); the same in every element of the array */
    const shd_volume *volume;  /**< borrowed for the call */
    float object_to_world[16]; /**< affine, finite, invertible; default identity */
    /* ---- end of 0.1; append below ---- */
} shd_volume_draw;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_volume_draw shd_volume_draw_default(void)
{
    shd_volume_draw draw = SHD_ZERO_INIT;
    draw.struct_size = (uint32_t)sizeof draw;
    draw.object_to_world[0] = draw.object_to_world[5] = 1.0f;
    draw.object_to_world[10] = draw.object_to_world[15] = 1.0f;
    return draw;
}

SHD_END_DECLS

#endif /* SHD_VOLUME_H */
