/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Reflectance: a model with its coefficients, or a program of the caller's.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a material never changes, so concurrent use is free.
 */
#ifndef SHD_MATERIAL_H
#define SHD_MATERIAL_H

#include <shd/context.h>
#include <shd/fragments.h>
#include <shd/sampler.h>
#include <shd/texture.h>
#include <shd/vertices.h>

SHD_BEGIN_DECLS

/** How a surface answers light. */
typedef struct shd_material shd_material;

/**
 * Reflectance model. n: unit normal, l: unit vector to the light, v: to the eye, h = (v + l) / |v + l|,
 * E = I / r^2 for a point light and I for a directional one, k_d times the diffuse texture if there is one.
 */
typedef enum shd_model {
    /** k_a I_a + sum of k_d E max(0, n.l) */
    SHD_MODEL_LAMBERT = 0,
    /** Lambert + sum of k_s E max(0, n.h)^p; 0 where v + l = 0 (Blinn 1977) */
    SHD_MODEL_BLINN_PHONG = 1,
    /** program.fragment */
    SHD_MODEL_PROGRAM = 2,
    /** k_d, whatever the lights and the frequency */
    SHD_MODEL_UNLIT = 3,
    SHD_MODEL_MAX_ENUM = 0x7fffffff
} shd_model;

/**
 * How a fragment's colour c and opacity a meet the colour d and opacity A of a sample. Models give c = a L with the
 * radiance L and a = opacity times the diffuse texture's alpha; L itself with STRAIGHT and OPAQUE.
 */
typedef enum shd_blend_mode {
    SHD_BLEND_OPAQUE = 0,        /**< c, and for A the a of a program or 1 of a model */
    SHD_BLEND_PREMULTIPLIED = 1, /**< c + (1 - a) d, a + (1 - a) A: "over" (Porter and Duff 1984) */
    SHD_BLEND_STRAIGHT = 2,      /**< a c + (1 - a) d, a + (1 - a) A */
    SHD_BLEND_ADD = 3,           /**< c + d, A */
    SHD_BLEND_MULTIPLY = 4,      /**< c d + (1 - a) d, A */
    /**
     * After all other draws, in any order: with R the product of 1 - a, w = max(0.01, 3000 (1 - depth)^3) and
     * C = sum of w c / sum of w a, the result is (1 - R) C + R d, 1 - R + R A. An approximation (McGuire and Bavoil,
     * "Weighted Blended Order-Independent Transparency", 2013, equation 10). Depth is tested, not written.
     */
    SHD_BLEND_WEIGHTED = 5,
    /**
     * After all other draws, PREMULTIPLIED from far to near for every sample, equal depths in the order of draws and
     * triangles. Depth is tested, not written.
     */
    SHD_BLEND_SORTED = 6,
    SHD_BLEND_MAX_ENUM = 0x7fffffff
} shd_blend_mode;

/** Switches of a material; combine with |. */
typedef enum shd_material_flag {
    SHD_MATERIAL_NONE = 0,
    /** Keep the specular term where n.l <= 0, as the textbook formula does; by default it is 0 there. */
    SHD_SPECULAR_UNGATED = 1,
    /** Add the ambient term once per point or directional light instead of once. */
    SHD_AMBIENT_PER_LIGHT = 2,
    /** The program may set shd_radiance.discard. */
    SHD_MATERIAL_DISCARDS = 4,
    /** Keep the first round(a samples) of a pixel's samples and drop the others. */
    SHD_ALPHA_TO_COVERAGE = 8,
    SHD_MATERIAL_FLAG_MAX_ENUM = 0x7fffffff
} shd_material_flag;

/**
 * The caller's code. What happens to a frame whose program throws, longjmps or changes the number of rows is undefined;
 * where a C++ exception reaches shd it becomes SHD_ERROR_CALLBACK.
 */
typedef struct shd_material_program {
    shd_fragment_fn fragment; /**< required for SHD_MODEL_PROGRAM, else NULL */
    void *user_data;          /**< passed to both; borrowed until release */
    shd_vertex_fn vertex;     /**< for any model; NULL = the matrices of view and draw alone */
} shd_material_program;

/** Model and coefficients, scene-linear RGB. */
typedef struct shd_material_desc {
    uint32_t struct_size;         /**< set by shd_material_desc_default() */
    shd_model model;              /**< default SHD_MODEL_LAMBERT */
    uint32_t flags;               /**< shd_material_flag bits */
    float ambient[3];             /**< k_a, 0..1e6; default 0.05 */
    float diffuse[3];             /**< k_d, 0..1e6; default 0.8 */
    float specular[3];            /**< k_s, 0..1e6; default 0.5 */
    float exponent;               /**< p, 0..1e6; default 64 */
    float opacity;                /**< of models, 0..1; default 1 */
    shd_texture *diffuse_texture; /**< multiplies k_d; NULL = none; retained */
    shd_sampler *diffuse_sampler; /**< NULL = default sampler; retained */
    shd_material_program program; /**< default none */
    shd_blend_mode blend;         /**< default SHD_BLEND_OPAQUE */
    float alpha_cutoff;           /**< fragments with a below it are dropped, 0..1; default 0 = none */
    uint32_t varying_count;       /**< what program.vertex writes for fragments, 0..16; 0 without it */
    shd_interpolation interpolation[SHD_MAX_VARYINGS]; /**< of each varying; default SHD_INTERPOLATION_PERSPECTIVE */
    uint32_t reserved;                                 /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_material_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_material_desc shd_material_desc_default(void)
{
    shd_material_desc desc = SHD_ZERO_INIT;
    int c;
    desc.struct_size = (uint32_t)sizeof desc;
    for (c = 0; c < 3; ++c) {
        desc.ambient[c] = 0.05f;
        desc.diffuse[c] = 0.8f;
        desc.specular[c] = 0.5f;
    }
    desc.exponent = 64.0f;
    desc.opacity = 1.0f;
    return desc;
}

/**
 * Make a material.
 * @param context       retained
 * @param desc          borrowed for the call; NULL = all defaults
 * @param out_material  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_material_create(shd_context *context, const shd_material_desc *desc,
                                                     shd_material **out_material);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_material_retain(shd_material *material);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_material_release(shd_material *material);

SHD_END_DECLS

#endif /* SHD_MATERIAL_H */
