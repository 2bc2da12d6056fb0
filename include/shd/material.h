/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Materials: a reflectance model with its coefficients, or a program of the caller.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a material never changes, so concurrent use is free.
 *
 * @code
 * const shd_slot bricks = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, sampler);
 * shd_material_desc desc = shd_material_desc_default();
 * desc.model = SHD_MODEL_BLINN_PHONG;
 * desc.slots = &bricks, desc.slot_count = 1;
 * result = shd_material_create(context, &desc, &material);
 * @endcode
 */
#ifndef SHD_MATERIAL_H
#define SHD_MATERIAL_H

#include <shd/context.h>
#include <shd/slot.h>
#include <shd/vertices.h>

SHD_BEGIN_DECLS

/** Reflectance of a surface. */
typedef struct shd_material shd_material;

/**
 * Reflectance model: the radiance L towards the eye.
 *
 * n: unit normal, l: unit vector to a light, v: unit vector to the eye, h = (v + l) / |v + l|, E: irradiance
 * (shd/light.h). Sums are over all lights except ambient lights, whose sum is I_a. k_d, k_a, k_s, p and so on are
 * constants of the material times their slots. "Specular" terms are 0 where n.l <= 0 (except with
 * SHD_MATERIAL_SPECULAR_UNGATED) and where v + l = 0; 0^0 = 1. Every model adds the emission, and multiplies I_a by the
 * occlusion.
 *
 * BLINN_PHONG_NORMALIZED and METALLIC_ROUGHNESS divide the diffuse term by pi, the other models do not: with lights
 * whose intensity is pi times as large, their diffuse surfaces are as bright as those of LAMBERT (shd/light.h).
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
    /**
     * Blinn-Phong with n.l rounded up to a multiple of 1 / toon_steps, and max(0, n.h)^p replaced by 0 below 1/2 and by
     * 1 from 1/2 on
     */
    SHD_MODEL_TOON = 8,
    /**
     * Metallic-roughness of glTF 2.0, appendix B: k_a I_a (b (1 - m) + F0) + sum of E max(0, n.l) (b (1 - m) (1 - f)
     * (1 - (1 - v.h)^5) / pi + F D V), with base colour b = k_d, metallic m, alpha = max(roughness^2, 0.001),
     * F = F0 + (1 - F0) (1 - v.h)^5, F0 = f (1 - m) + b m, f = ((ior - 1) / (ior + 1))^2, the distribution D of
     * Trowbridge and Reitz (GGX) and V, the height-correlated masking and shadowing of Smith over 4 (n.l) (n.v), where
     * n.v counts as at least 1e-4: interpolated normals may face away from the eye. Metals reflect at most the incident
     * light. Dielectrics exceed it at grazing angles (1.2 at 75 degrees from n, 1.6 at 85), diffuse plus specular
     */
    SHD_MODEL_METALLIC_ROUGHNESS = 9,
    /** k_d times SHD_SLOT_MATCAP at (1/2 + x/2, 1/2 - y/2) of the normal in view space; a normal
     * without a direction reads the middle */
    SHD_MODEL_MATCAP = 10,
    /**
     * A clear solid: k_a I_a + sum of E max(0, n.l) F D V + k_d (1 - F) T, with F, D and V of METALLIC_ROUGHNESS for
     * F0 = ((ior - 1) / (ior + 1))^2, and T the radiance of the frame's environment (shd_render_desc.environment) along
     * the refracted line of sight, 0 without one. The solid counts as a sphere with the normal of the fragment, which
     * turns the line of sight twice. Other draws are not seen through it
     */
    SHD_MODEL_GLASS = 11,
    SHD_MODEL_MAX_ENUM = 0x7fffffff
} shd_model;

/** Debug views of values that the rasteriser computes. They replace the model's radiance L; the emission is added. */
typedef enum shd_debug_view {
    SHD_DEBUG_VIEW_NONE = 0,   /**< the model */
    SHD_DEBUG_VIEW_NORMAL = 1, /**< shading normal: (n + 1) / 2 */
    SHD_DEBUG_VIEW_UV = 2,     /**< texture coordinates: (u - floor(u), v - floor(v), 0) */
    /** Level of detail of the diffuse texture: blue for level 0, over green, to red for the last level. */
    SHD_DEBUG_VIEW_LEVEL = 3,
    SHD_DEBUG_VIEW_BARYCENTRICS = 4, /**< barycentric coordinates in the triangle */
    SHD_DEBUG_VIEW_MAX_ENUM = 0x7fffffff
} shd_debug_view;

/**
 * Encoding of a tangent-space normal in the values of SHD_SLOT_NORMAL.
 *
 * x points along u, z along the normal, and y up in the image, against v, as in glTF 2.0 (down with
 * SHD_MATERIAL_NORMAL_Y_DOWN). Textures of 8 and 16 bits hold (c + 1) / 2 of a component c; float textures, vertices
 * and procedures hold c itself.
 */
typedef enum shd_normal_encoding {
    SHD_NORMAL_ENCODING_XYZ = 0, /**< (x, y, z) */
    SHD_NORMAL_ENCODING_XY = 1,  /**< (x, y), z = sqrt(1 - x^2 - y^2) */
    /**
     * XYZ with the length of the mean normal as the fourth channel, as shd_mip_build() makes it. The variance of
     * normals within a pixel widens the specular lobe (Toksvig, "Mipmapping Normal Maps", 2005)
     */
    SHD_NORMAL_ENCODING_TOKSVIG = 2,
    /**
     * (x / z, y / z) and their squares, in floats, and their product in SHD_SLOT_NORMAL_MIXED, as
     * shd_mip_build_moments() makes them. Lobes are averaged over normals with slopes of mean b and covariance S within
     * the pixel (Olano and Baker, "LEAN Mapping", 2010), so grooves stretch highlights across them. With S = 0 the
     * results are those of XYZ:
     * - diffuse: the mean of max(0, n.l) over a Gaussian of slopes around the mean normal, divided by
     *   sqrt(1 + trace S);
     * - max(0, n.h)^p: Laplace's method, that is the lobe of the normal between b and h where its product with the
     *   Gaussian is largest, times the Gaussian there, divided by sqrt(det(1 + p S G)), G being the metric of angles;
     * - max(0, v.r)^p: the same with 4 p h.l in place of p;
     * - METALLIC_ROUGHNESS: adaptive Gauss-Hermite quadrature (Naylor and Smith, "Applications of a Method for the
     *   Efficient Computation of Posterior Distributions", 1982): the sum of the lobes of four normals along the longer
     *   axis of S. Normals and weights suit the Gaussian of slopes times a Gaussian around h with the precision
     *   2 (0.2 + r^2) / (1 + r^2) / alpha^2, r = s / (6 alpha^2) for the larger variance s of S.
     * GOOCH and TOON use the mean normal only. SHD_FILTER_EWA with a lod_bias of -0.5 to -0.25 is closest to shading
     * many samples a pixel: its default footprint is wider than a pixel
     */
    SHD_NORMAL_ENCODING_MOMENTS = 3,
    SHD_NORMAL_ENCODING_MAX_ENUM = 0x7fffffff
} shd_normal_encoding;

/** Tilt of normals by SHD_SLOT_HEIGHT. */
typedef enum shd_bump {
    SHD_BUMP_NONE = 0, /**< no tilt; heights are for parallax only */
    /**
     * The normal of the surface moved along n by bump_scale h [world units]: n - bump_scale grad h. The gradient on the
     * surface uses the exact derivative of the filtered height in u and v (Mikkelsen, "Bump Mapping Unparametrized
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
 * Blending of a fragment of colour c and opacity a onto a sample of colour d and opacity A.
 *
 * Models give c = a L with the radiance L and a = opacity times its slot times the alpha of the diffuse slot. For
 * STRAIGHT and OPAQUE they give c = L.
 */
typedef enum shd_blend {
    SHD_BLEND_OPAQUE = 0,        /**< colour c; A becomes the a of a program, or 1 for a model */
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
} shd_blend;

/** Options of a material; combine with |. */
typedef enum shd_material_flag {
    SHD_MATERIAL_NONE = 0,
    /** Keep the specular term where n.l <= 0, as in the textbook formula; by default it is 0 there. */
    SHD_MATERIAL_SPECULAR_UNGATED = 1,
    /** Add the ambient term once for each light that is not ambient, instead of once in total. */
    SHD_MATERIAL_AMBIENT_PER_LIGHT = 2,
    /** The program may set shd_radiance.discard. */
    SHD_MATERIAL_DISCARDS = 4,
    /** Keep the first round(a * sample count) samples of a pixel and drop the others. */
    SHD_MATERIAL_ALPHA_TO_COVERAGE = 8,
    /** Flip normals on triangles seen from behind. */
    SHD_MATERIAL_DOUBLE_SIDED = 16,
    /** Mapped normals have y down in the image, along v, as usual with Direct3D; default is up, as in glTF. */
    SHD_MATERIAL_NORMAL_Y_DOWN = 32,
    SHD_MATERIAL_FLAG_MAX_ENUM = 0x7fffffff
} shd_material_flag;
typedef uint32_t shd_material_flags; /**< shd_material_flag bits */

/**
 * Functions of the caller. Frozen.
 *
 * A C++ exception that reaches shd becomes SHD_ERROR_CALLBACK. The frame is undefined if a program throws, longjmps or
 * changes the count.
 */
typedef struct shd_material_program {
    shd_fragment_fn fragment; /**< required for SHD_MODEL_PROGRAM, else NULL */
    shd_vertex_fn vertex;     /**< for any model; NULL = only the matrices of view and draw */
    void *user_data;          /**< passed to both; borrowed until release */
} shd_material_program;

/** Model and coefficients, scene-linear RGB. */
typedef struct shd_material_desc {
    uint32_t struct_size;     /**< set by shd_material_desc_default() */
    shd_model model;          /**< default SHD_MODEL_LAMBERT */
    shd_material_flags flags; /**< default none */
    shd_blend blend;          /**< default SHD_BLEND_OPAQUE */
    float alpha_cutoff;       /**< fragments with a smaller alpha are dropped, 0..1; default 0 = none */
    float opacity;            /**< opacity of models, 0..1; default 1 */
    float diffuse[3];         /**< k_d or base colour, 0..1e6; default 0.8 */
    /**
     * k_a, 0..1e6. Default -1 in all channels: k_a is ambient_share times the diffuse colour, k_d times its slot.
     * SHD_SLOT_AMBIENT replaces the slot of the diffuse colour in this product.
     */
    float ambient[3];
    /**
     * 0..1; default 1/16; used if ambient is -1. METALLIC_ROUGHNESS multiplies k_a by its base colour in any case, so
     * k_a is ambient_share there.
     */
    float ambient_share;
    float specular[3]; /**< k_s, 0..1e6; default 0.5 */
    float exponent;    /**< p, 0..1e6; default 64 */
    float metallic;    /**< 0..1; default 0 */
    float roughness;   /**< 0..1; default 0.5 */
    /** Index of refraction of GLASS, and of METALLIC_ROUGHNESS for the part that is not metal, 1..10; default 1.5. */
    float ior;
    /**
     * Strength c of a clear coat over METALLIC_ROUGHNESS, 0..1; default 0 = none. As KHR_materials_clearcoat of glTF,
     * with its own roughness and normal n_c and F = 0.04 + 0.96 (1 - |n_c.v|)^5: the model times 1 - c F, plus the sum
     * of E max(0, n_c.l) c F D V. Without SHD_SLOT_CLEARCOAT_NORMAL, n_c is the normal without normal maps and bumps.
     * Ambient light and emission are not darkened. No effect on other models.
     */
    float clearcoat;
    float clearcoat_roughness; /**< 0..1; default 0 */
    float emission[3];         /**< 0..1e12; default 0, so a slot needs a larger value here */
    float occlusion_strength;  /**< effect of SHD_SLOT_OCCLUSION, 0..1; default 1 */
    /**
     * [slot_count], all with the same struct_size, at most one for each target; borrowed for the call; coefficients
     * without a slot are constant.
     */
    const shd_slot *slots;
    size_t slot_count;                   /**< default 0 */
    shd_normal_encoding normal_encoding; /**< default SHD_NORMAL_ENCODING_XYZ */
    float normal_scale;                  /**< factor of x and y of mapped normals, -1e3..1e3; default 1 */
    shd_bump bump;                       /**< default SHD_BUMP_NONE */
    float bump_scale;                    /**< factor of heights, -1e6..1e6; default 1 */
    /**
     * Depth of height 0 below the surface [world units], 0..1e6; height 1 lies on the surface. At Phong frequency, all
     * textures with the uv set of the height are looked up at the point where the line of sight meets the height field
     * (parallax occlusion mapping, Tatarchuk 2006). The triangles do not move. Default 0 = off.
     */
    float parallax_depth;
    uint32_t parallax_steps;      /**< maximum number of lookups of the height per fragment, 2..256; default 24 */
    float warm[3];                /**< warm colour of GOOCH, 0..1e6; default (0.4, 0.4, 0) */
    float cool[3];                /**< cool colour of GOOCH, 0..1e6; default (0, 0, 0.4) */
    float warm_mix;               /**< share of k_d added to `warm`, 0..1; default 0.6 */
    float cool_mix;               /**< share of k_d added to `cool`, 0..1; default 0.2 */
    uint32_t toon_steps;          /**< steps of TOON, 1..256; default 3 */
    shd_debug_view debug_view;    /**< shown instead of the model; default SHD_DEBUG_VIEW_NONE */
    shd_material_program program; /**< default none */
    /** [varying_count]; borrowed for the call; NULL = all SHD_INTERPOLATION_PERSPECTIVE. */
    const shd_interpolation *interpolation;
    /** Varyings that program.vertex writes, 0..SHD_MAX_VARYINGS; 0 without program.vertex. */
    size_t varying_count;
    /* ---- end of 0.1; append below ---- */
} shd_material_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_material_desc shd_material_desc_default(void)
{
    shd_material_desc desc = SHD_ZERO_INIT;
    int c;
    desc.struct_size = (uint32_t)sizeof desc;
    for (c = 0; c < 3; ++c) {
        desc.ambient[c] = -1.0f;
        desc.diffuse[c] = 0.8f;
        desc.specular[c] = 0.5f;
    }
    desc.ambient_share = 0.0625f;
    desc.exponent = 64.0f;
    desc.roughness = 0.5f;
    desc.ior = 1.5f;
    desc.opacity = 1.0f;
    desc.occlusion_strength = 1.0f;
    desc.normal_scale = desc.bump_scale = 1.0f;
    desc.parallax_steps = 24;
    desc.warm[0] = desc.warm[1] = desc.cool[2] = 0.4f;
    desc.warm_mix = 0.6f;
    desc.cool_mix = 0.2f;
    desc.toon_steps = 3;
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
