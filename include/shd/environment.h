/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Environments: light from all directions, from an image of radiance.
 *
 * A texel of radiance L that covers the solid angle w has the light of a directional light of irradiance E = L w
 * (shd/light.h), spread evenly over w. An environment is the sum of these lights. Models reflect it as they reflect
 * lights: METALLIC_ROUGHNESS and BLINN_PHONG_NORMALIZED divide the diffuse term by pi, the others do not. In an
 * environment of radiance 1 a white Lambert surface has the radiance pi, and a white rough dielectric about 1.
 *
 * The tables are computed when the environment is made: irradiance by direction of the normal, and mean radiance over
 * the lobes of GGX and Phong by direction of mirror reflection. docs/environment-light.md describes their accuracy. In
 * an environment of radiance 1, models reflect the integrals of their lobes within 0.004, at every roughness and
 * exponent.
 *
 * Directions are those of shd/projection.h, with +Y up. shd_render_desc turns and scales an environment in a frame.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; an environment never changes, so concurrent use is free.
 *
 * @code
 * shd_environment_desc desc = shd_environment_desc_default();
 * desc.image = &image; // latitude and longitude, linear RGB
 * result = shd_environment_create(context, &desc, &environment);
 * @endcode
 */
#ifndef SHD_ENVIRONMENT_H
#define SHD_ENVIRONMENT_H

#include <shd/column.h>
#include <shd/context.h>
#include <shd/image.h>
#include <shd/projection.h>

SHD_BEGIN_DECLS

/** Light from all directions. */
typedef struct shd_environment shd_environment;

/** Method that computes the irradiance. */
typedef enum shd_irradiance {
    /**
     * Spherical harmonics of the orders 0 to 2 (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
     * Environment Maps", 2001), at least 0. The error is up to 0.1 of the irradiance of a single light that faces the
     * surface, and about 0.01 for environments without a sun.
     */
    SHD_IRRADIANCE_HARMONICS = 0,
    SHD_IRRADIANCE_CONVOLVED = 1, /**< a map of 96 x 96 directions: error up to 0.018 of such a light */
    SHD_IRRADIANCE_MAX_ENUM = 0x7fffffff
} shd_irradiance;

/** Tables of an environment in addition to the irradiance; combine with |. */
typedef enum shd_environment_table {
    SHD_ENVIRONMENT_TABLE_NONE = 0,
    SHD_ENVIRONMENT_TABLE_RADIANCE = 1, /**< the image itself, for backgrounds and mirrors; part of every other table */
    SHD_ENVIRONMENT_TABLE_GGX = 2,      /**< lobes of METALLIC_ROUGHNESS */
    SHD_ENVIRONMENT_TABLE_PHONG = 4,    /**< lobes of PHONG, COMBINED, TOON and both models of Blinn */
    SHD_ENVIRONMENT_TABLE_ALL = 7,
    SHD_ENVIRONMENT_TABLE_MAX_ENUM = 0x7fffffff
} shd_environment_table;
typedef uint32_t shd_environment_table_flags; /**< shd_environment_table bits */

/** Image and tables of an environment. Required: image. */
typedef struct shd_environment_desc {
    uint32_t struct_size;      /**< set by shd_environment_desc_default() */
    shd_projection projection; /**< any but SHD_PROJECTION_NONE; default SHD_PROJECTION_LAT_LONG */
    /**
     * Linear radiance, of any format and of 1 x 1 up to 2^26 pixels; borrowed for the call. One channel means grey; the
     * fourth is ignored. CUBE takes the six faces on top of each other: height = 6 width. MIRROR_BALL, ANGULAR and
     * OCTAHEDRAL are square. Channels that are negative or NaN count as 0, and those above 1e12 as 1e12;
     * shd_environment_info counts them.
     */
    const shd_image *image;
    shd_irradiance irradiance;          /**< default SHD_IRRADIANCE_HARMONICS */
    shd_environment_table_flags tables; /**< default SHD_ENVIRONMENT_TABLE_ALL */
    /* ---- end of 0.1; append below ---- */
} shd_environment_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_environment_desc shd_environment_desc_default(void)
{
    shd_environment_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.projection = SHD_PROJECTION_LAT_LONG;
    desc.tables = SHD_ENVIRONMENT_TABLE_ALL;
    return desc;
}

/**
 * Make an environment on the executor of the context.
 *
 * Kept: 11 bytes for each of 1 to 4 texels a pixel, of at least 64^2 (12 bytes each) and at most 2048^2 texels, and
 * 4.2 MB or less for each kind of lobe. Temporary: 16 bytes a pixel, 224 bytes a row, and twice the bytes kept. Fixed:
 * lobes and CONVOLVED take up to 12 MB of temporary memory more. Maps hold three channels of 16 bits with a common
 * exponent: errors of up to 2^-16 of the largest channel.
 * @param context          retained
 * @param desc             borrowed for the call
 * @param out_environment  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_environment_create(shd_context *context, const shd_environment_desc *desc,
                                                        shd_environment **out_environment);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_environment_retain(shd_environment *environment);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_environment_release(shd_environment *environment);

/** Properties of an environment. */
typedef struct shd_environment_info {
    uint32_t struct_size;               /**< set by shd_environment_info_default() */
    shd_projection projection;          /**< as in its desc */
    shd_irradiance irradiance;          /**< as in its desc */
    shd_environment_table_flags tables; /**< as in its desc, with SHD_ENVIRONMENT_TABLE_RADIANCE if there are lobes */
    uint32_t map_size;     /**< texels a side of the largest map, 0 without SHD_ENVIRONMENT_TABLE_RADIANCE */
    float mean[3];         /**< mean radiance of all directions */
    size_t replaced_count; /**< channels of the image that were negative, NaN or above 1e12 */
    size_t byte_size;      /**< bytes of all tables */
    /* ---- end of 0.1; append below ---- */
} shd_environment_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_environment_info shd_environment_info_default(void)
{
    shd_environment_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Get the properties of an environment.
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_environment_get_info(const shd_environment *environment,
                                                          shd_environment_info *out_info);

/** Lookups of an environment, as columns of `count` elements. */
typedef struct shd_environment_lookups {
    uint32_t struct_size;    /**< set by shd_environment_lookups_default() */
    size_t count;            /**< number of lookups; 0 is allowed */
    shd_f32_in direction[3]; /**< x, y, z, any length; required. 0, NaN and infinity count as +Z */
    /**
     * Roughness of a GGX lobe around the direction, clamped to 0..1, NaN = 1: the mean of the radiance, weighted by
     * D(h) n.l with n = v = direction (Karis, "Real Shading in Unreal Engine 4", 2013). Only for environments with
     * SHD_ENVIRONMENT_TABLE_GGX.
     */
    shd_f32_in roughness;
    /**
     * Exponent p of a Phong lobe around the direction r, clamped to 0..1e6, NaN = 0: the mean of the radiance, weighted
     * by max(0, r.l)^p. Only for environments with SHD_ENVIRONMENT_TABLE_PHONG. Without roughness and exponent, lookups
     * give the radiance itself.
     */
    shd_f32_in exponent;
    /* ---- end of 0.1; append below ---- */
} shd_environment_lookups;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_environment_lookups shd_environment_lookups_default(void)
{
    shd_environment_lookups lookups = SHD_ZERO_INIT;
    lookups.struct_size = (uint32_t)sizeof lookups;
    return lookups;
}

/** Columns for irradiance or radiance; NULL = not wanted. */
typedef struct shd_environment_values {
    uint32_t struct_size;   /**< set by shd_environment_values_default() */
    shd_f32_out channel[3]; /**< red, green, blue; irradiance, or radiance in the unit of the image */
    size_t nonfinite_count; /**< written: lookups with a number that is not finite */
    /* ---- end of 0.1; append below ---- */
} shd_environment_values;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_environment_values shd_environment_values_default(void)
{
    shd_environment_values values = SHD_ZERO_INIT;
    values.struct_size = (uint32_t)sizeof values;
    return values;
}

/**
 * Look up the irradiance of surfaces whose normals are the directions, on the executor of the environment's context.
 * @param lookups  columns, borrowed for the call, without roughness and exponent
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_environment_sample_irradiance(const shd_environment *environment,
                                                                   const shd_environment_lookups *lookups,
                                                                   shd_environment_values *out);

/**
 * Look up the radiance, or its mean over lobes, on the executor of the environment's context.
 * @param lookups  columns, borrowed for the call, with at most one of roughness and exponent
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_environment_sample_radiance(const shd_environment *environment,
                                                                 const shd_environment_lookups *lookups,
                                                                 shd_environment_values *out);

SHD_END_DECLS

#endif /* SHD_ENVIRONMENT_H */
