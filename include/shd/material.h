/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Reflectance: a model with its coefficients, or a program of the caller.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a material never changes, so concurrent use is free.
 */
#ifndef SHD_MATERIAL_H
#define SHD_MATERIAL_H

#include <shd/context.h>
#include <shd/slot.h>
#include <shd/vertices.h>

SHD_BEGIN_DECLS

/** How a surface reflects light. */
typedef struct shd_material shd_material;

/**
 * Reflectance model: the radiance L towards the eye. n: unit normal, l: unit vector to a light, v: to the eye,
 * h = (v + l) / |v + l|, E: irradiance (shd/light.h). Sums are over all lights except ambient lights, whose sum is I_a.
 * k_d, k_a, k_s, p and so on are constants of the material times their slots. "Specular" terms are 0 where n.l <= 0
 * (but see SHD_SPECULAR_UNGATED) and where v + l = 0; 0^0 = 1. Every model adds the emission, and multiplies I_a by the
 * occlusion.
 */
typedef enum shd_model {
    /** k_a I_a + sum of k_d E max(0, n.l) */
    SHD_MODEL_LAMBERT = 0,
    /** Lambert + sum of k_s E max(0, n.h)^p (Blinn 1977) */
    SHD_MODEL_BLINN_PHONG = 1,
    /** program.fragment */
    SHD_MODEL_PROGRAM = 2,
    /** k_d, independent of lights and frequency */
    SHD_MODEL_UNLIT = 3,
    /** Lambert + sum of k_s E max(0, v.r)^p with r = 2 (n.l) n - l (Phong 1975) */
    SHD_MODEL_PHONG = 4,
    /**
     * k_a I_a + sum of (k_d / pi + k_s N max(0, n.h)^p) E max(0, n.l), N = (p + 2)(p + 4) / (8 pi (2^(-p/2) + p)):
     * reflects at most the incident light where k_d + k_s <= 1 (Giesen, "Phong and Blinn-Phong Normalization Factors",
     * 2009)
     */
    SHD_MODEL_BLINN_PHONG_NORMALIZED = 5,
    /** k_d (I_a + sum of E max(0, n.l)) + sum of E k_s max(0, n.h)^p (Shirley and Marschner, "Fundamentals of Computer
     * Graphics", 2009, 10.2) */
    SHD_MODEL_COMBINED = 6,
    /**
     * k_w w + (1 - k_w) c with k_w the mean of (1 + n.l) / 2 over the lights, 1/2 without any: w = warm + warm_mix k_d,
     * c = cool + cool_mix k_d (Gooch et al., "A Non-Photorealistic Lighting Model", 1998)
     */
    SHD_MODEL_GOOCH = 7,
    /** Lambert + the specular term of Blinn-Phong with n.l rounded up to a multiple of 1 / toon_steps and max(0, n.h)^p
     * to 0 below 1/2, else 1 */
    SHD_MODEL_TOON = 8,
    /**
     * Metallic-roughness of glTF 2.0, appendix B: k_a I_a (b (1 - m) + F0) + sum of E max(0, n.l) (b (1 - m) (1 - f)
     * (1 - (1 - v.h)^5) / pi + F D V), with base colour b = k_d, metallic m, alpha = max(roughness^2, 0.001),
     * F = F0 + (1 - F0) (1 - v.h)^5, F0 = f (1 - m) + b m, f = ((ior - 1) / (ior + 1))^2, the distribution D of
     * Trowbridge and Reitz (GGX) and V, the height-correlated masking and shadowing of Smith over 4 (n.l) (n.v).
     * Metals reflect at most the incident light. Dielectrics do not: diffuse plus specular reflection exceeds 1 at
     * grazing angles (1.2 at 75 degrees from n, 1.6 at 85)
     */
    SHD_MODEL_METALLIC_ROUGHNESS = 9,
    /** k_d times SHD_SLOT_MATCAP at (1/2 + x/2, 1/2 - y/2) of the normal in view space */
    SHD_MODEL_MATCAP = 10,
    /** Debug view of the shading normal: (n + 1) / 2 */
    SHD_MODEL_SHOW_NORMAL = 11,
    /** Debug view of the texture coordinates: (u - floor(u), v - floor(v), 0) */
    SHD_MODEL_SHOW_UV = 12,
    /** Debug view of the level of detail of the diffuse texture: from blue (0) over green to red (its last level) */
    SHD_MODEL_SHOW_LEVEL = 13,
    /** Debug view of the barycentric coordinates in the triangle */
    SHD_MODEL_SHOW_BARYCENTRICS = 14,
    SHD_MODEL_MAX_ENUM = 0x7fffffff
} shd_model;

/**
 * Encoding of a normal in tangent space by the values of SHD_SLOT_NORMAL: x along u, y up in the image, against v, as
 * in glTF 2.0 (but see SHD_NORMAL_Y_DOWN), z along the normal. Textures of 8 and 16 bits hold (c + 1) / 2 of a
 * component c; float textures, vertices and procedures hold c itself.
 */
typedef enum shd_normal_encoding {
    SHD_NORMAL_XYZ = 0, /**< (x, y, z) */
    SHD_NORMAL_XY = 1,  /**< (x, y), z = sqrt(1 - x^2 - y^2) */
    /**
     * XYZ with the length of the mean normal as the fourth channel, as shd_mip_build() makes it. The variance of
     * normals within a pixel widens the specular lobe (Toksvig, "Mipmapping Normal Maps", 2005)
     */
    SHD_NORMAL_TOKSVIG = 2,
    /**
     * (x / z, y / z) and their squares, in floats, as shd_normal_moments() makes them. The variance of slopes within a
     * pixel widens the specular lobe (Olano and Baker, "LEAN Mapping", 2010, for isotropic lobes)
     */
    SHD_NORMAL_MOMENTS = 3,
    SHD_NORMAL_MAX_ENUM = 0x7fffffff
} shd_normal_encoding;

/** How SHD_SLOT_HEIGHT tilts normals. */
typedef enum shd_bump {
    SHD_BUMP_NONE = 0, /**< no tilt; heights are for parallax only */
    /**
     * The surface moved along n by bump_scale h, in world units: n - bump_scale grad h, with the gradient on the
     * surface from the exact derivative of the filtered height in u and v (Mikkelsen, "Bump Mapping Unparametrized
     * Surfaces on the GPU", 2010). Filters without derivatives use differences over a texel.
     */
    SHD_BUMP_GRADIENT = 1,
    /**
     * (-s (h(u + 1/w, v) - h(u, v)), -s (h(u, v + 1/h) - h(u, v)), 1) along t, v and n, with s = bump_scale:
     * differences over one texel, independent of the size of the surface (after Blinn, "Simulation of Wrinkled
     * Surfaces", 1978)
     */
    SHD_BUMP_TEXEL = 2,
    SHD_BUMP_MAX_ENUM = 0x7fffffff
} shd_bump;

/**
 * How a fragment of colour c and opacity a is blended onto a sample of colour d and opacity A. Models give c = a L with
 * the radiance L and a = opacity times its slot times the alpha of the diffuse slot; c = L for STRAIGHT and OPAQUE.
 */
typedef enum shd_blend_mode {
    SHD_BLEND_OPAQUE = 0,        /**< c, and for A the a of a program or 1 of a model */
    SHD_BLEND_PREMULTIPLIED = 1, /**< c + (1 - a) d, a + (1 - a) A: "over" (Porter and Duff 1984) */
    SHD_BLEND_STRAIGHT = 2,      /**< a c + (1 - a) d, a + (1 - a) A */
    SHD_BLEND_ADD = 3,           /**< c + d, A */
    SHD_BLEND_MULTIPLY = 4,      /**< c d + (1 - a) d, A */
    /**
     * After all other draws, independent of order: with R the product of 1 - a, w = max(0.01, 3000 (1 - depth)^3) and
     * C = sum of w c / sum of w a, the result is (1 - R) C + R d, 1 - R + R A. An approximation (McGuire and Bavoil,
     * "Weighted Blended Order-Independent Transparency", 2013, equation 10). Depth is tested, not written.
     */
    SHD_BLEND_WEIGHTED = 5,
    /**
     * After all other draws, PREMULTIPLIED from far to near per sample; equal depths in the order of draws and
     * triangles. Depth is tested, not written.
     */
    SHD_BLEND_SORTED = 6,
    SHD_BLEND_MAX_ENUM = 0x7fffffff
} shd_blend_mode;

/** Options of a material; combine with |. */
typedef enum shd_material_flag {
    SHD_MATERIAL_NONE = 0,
    /** Keep the specular term where n.l <= 0, as the textbook formula does; by default it is 0 there. */
    SHD_SPECULAR_UNGATED = 1,
    /** Add the ambient term once per light, ambient lights not counted, instead of once. */
    SHD_AMBIENT_PER_LIGHT = 2,
    /** The program may set shd_radiance.discard. */
    SHD_MATERIAL_DISCARDS = 4,
    /** Keep the first round(a * sample count) samples of a pixel and drop the others. */
    SHD_ALPHA_TO_COVERAGE = 8,
    /** Flip normals on triangles seen from behind. */
    SHD_DOUBLE_SIDED = 16,
    /** Mapped normals have y down in the image, along v, as usual with Direct3D; default is up, as in glTF. */
    SHD_NORMAL_Y_DOWN = 32,
    SHD_MATERIAL_FLAG_MAX_ENUM = 0x7fffffff
} shd_material_flag;

/**
 * Code of the caller. A frame whose program throws, longjmps or changes the count is undefined; a C++ exception that
 * reaches shd becomes SHD_ERROR_CALLBACK.
 */
typedef struct shd_material_program {
    shd_fragment_fn fragment; /**< required for SHD_MODEL_PROGRAM, else NULL */
    void *user_data;          /**< passed to both; borrowed until release */
    shd_vertex_fn vertex;     /**< for any model; NULL = the matrices of view and draw only */
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
    shd_material_program program; /**< default none */
    shd_blend_mode blend;         /**< default SHD_BLEND_OPAQUE */
    float alpha_cutoff;           /**< fragments with a below it are dropped, 0..1; default 0 = none */
    uint32_t varying_count;       /**< number of varyings that program.vertex writes, 0..16; 0 without it */
    shd_interpolation interpolation[SHD_MAX_VARYINGS]; /**< of each varying; default SHD_INTERPOLATION_PERSPECTIVE */
    uint32_t reserved;                                 /**< 0 */
    shd_slot slot[SHD_SLOT_COUNT];                     /**< by SHD_SLOT_...; default constants */
    float emission[3];                                 /**< 0..1e12; default 0: set it to use the slot */
    float metallic;                                    /**< 0..1; default 0 */
    float roughness;                                   /**< 0..1; default 0.5 */
    float ior;                                         /**< of METALLIC_ROUGHNESS without metal, 1..10; default 1.5 */
    float occlusion_strength;                          /**< 0..1; default 1 */
    float warm[3], cool[3];                            /**< of GOOCH, 0..1e6; default (0.4, 0.4, 0), (0, 0, 0.4) */
    float warm_mix, cool_mix;                          /**< 0..1; default 0.6, 0.2 */
    uint32_t toon_steps;                               /**< 1..256; default 3 */
    shd_normal_encoding normal_encoding;               /**< default SHD_NORMAL_XYZ */
    float normal_scale; /**< multiplies x and y of mapped normals, -1e3..1e3; default 1 */
    shd_bump bump;      /**< default SHD_BUMP_NONE */
    float bump_scale;   /**< -1e6..1e6; default 1 */
    /**
     * Depth of height 0 below the surface, in world units; height 1 lies on the surface. At Phong frequency, textures
     * of the uv set of the height are looked up where the line of sight meets the heights (parallax occlusion mapping,
     * Tatarchuk 2006). The triangles do not move. 0..1e6; 0 = off, the default.
     */
    float parallax_depth;
    uint32_t parallax_steps; /**< maximum number of lookups of the height per fragment, 2..256; default 24 */
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
    for (c = 0; c < SHD_SLOT_COUNT; ++c) desc.slot[c].uv_transform[0] = desc.slot[c].uv_transform[4] = 1.0f;
    desc.roughness = 0.5f;
    desc.ior = 1.5f;
    desc.occlusion_strength = 1.0f;
    desc.warm[0] = desc.warm[1] = desc.cool[2] = 0.4f;
    desc.warm_mix = 0.6f;
    desc.cool_mix = 0.2f;
    desc.toon_steps = 3;
    desc.normal_scale = desc.bump_scale = 1.0f;
    desc.parallax_steps = 24;
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
