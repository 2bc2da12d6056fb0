/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Sources of coefficients that vary over a surface: textures, columns of the mesh, functions.
 *
 * Thread safety: a slot's function runs on any worker of the executor, and calls may be concurrent. It must not throw
 *                or longjmp. The only function of shd that it may call is shd_texture_sample().
 */
#ifndef SHD_SLOT_H
#define SHD_SLOT_H

#include <shd/fragments.h>
#include <shd/sampler.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/**
 * Coefficients of a material. The value of a slot multiplies the constant of the same name in shd_material_desc, if
 * that exists. Colours have three channels, scalars one.
 */
enum {
    SHD_SLOT_DIFFUSE = 0,   /**< colour k_d or base colour; the fourth channel multiplies opacity */
    SHD_SLOT_AMBIENT = 1,   /**< colour k_a */
    SHD_SLOT_SPECULAR = 2,  /**< colour k_s */
    SHD_SLOT_EXPONENT = 3,  /**< scalar p */
    SHD_SLOT_OPACITY = 4,   /**< scalar */
    SHD_SLOT_EMISSION = 5,  /**< colour */
    SHD_SLOT_METALLIC = 6,  /**< scalar */
    SHD_SLOT_ROUGHNESS = 7, /**< scalar */
    SHD_SLOT_OCCLUSION = 8, /**< scalar o: ambient light times 1 + occlusion_strength (o - 1) */
    SHD_SLOT_NORMAL = 9,    /**< tangent-space normal in shd_material_desc.normal_encoding */
    SHD_SLOT_HEIGHT = 10,   /**< scalar height, for bumps and parallax; a texture or nothing */
    SHD_SLOT_MATCAP = 11,   /**< colour by the direction of the normal in view space: a texture or nothing */
    SHD_SLOT_COUNT = 12
};

/** What a slot reads. */
typedef enum shd_slot_source {
    SHD_SOURCE_CONSTANT = 0,  /**< 1; for the normal (0, 0, 1) in tangent space */
    SHD_SOURCE_TEXTURE = 1,   /**< `texture` through `sampler` */
    SHD_SOURCE_VERTEX = 2,    /**< interpolated attributes of the mesh from `attribute` on; 1 if the mesh lacks one */
    SHD_SOURCE_PROCEDURE = 3, /**< `procedure` */
    SHD_SOURCE_MAX_ENUM = 0x7fffffff
} shd_slot_source;

/**
 * A slot as code: writes in->count values per column.
 * @param out  packed columns, initially 1: three for colours, four for the diffuse slot and for normals, one for
 *             scalars; the others are NULL
 */
typedef void (*shd_slot_fn)(const shd_fragments *in, float *const out[4], void *user_data);

/**
 * A source for a coefficient.
 *
 * Slots that scale light (diffuse, ambient, specular, opacity, emission, metallic, occlusion, matcap) are looked up for
 * every fragment at every frequency. Slots that shape a lobe (exponent, roughness, normal, height) are looked up where
 * lobes are evaluated: at flat and Gouraud frequency at the centroid or vertex, on level 0.
 *
 * Values are not clamped, even if negative. NaN and infinity propagate to the colours of their fragments, which
 * shd_render_stats.nonfinite_fragments counts. Exceptions: exponents are clamped to 0..1e6 (NaN: 0) and roughness to
 * 0..1 (NaN: 1). The surface keeps its normal where a mapped normal is 0 or not finite, or a slope of heights is not
 * finite.
 */
typedef struct shd_slot {
    shd_slot_source source; /**< default SHD_SOURCE_CONSTANT */
    uint32_t uv_set;        /**< 0 = uv of the mesh, 1 = uv1; default 0 */
    shd_texture *texture;   /**< of SHD_SOURCE_TEXTURE, else NULL; retained */
    shd_sampler *sampler;   /**< of SHD_SOURCE_TEXTURE: NULL = default sampler; retained */
    /**
     * (u', v') = (t[0] u + t[1] v + t[2], t[3] u + t[4] v + t[5]), finite; default identity. glTF's
     * KHR_texture_transform is T R S, with the rotation r and v downwards
     * t = {sx cos r, sy sin r, ox, -sx sin r, sy cos r, oy}.
     */
    float uv_transform[6];
    uint32_t channel;      /**< of the texture, 0..3, for scalars; default 0 */
    uint32_t attribute;    /**< of SHD_SOURCE_VERTEX: first column, 0..7 */
    shd_slot_fn procedure; /**< of SHD_SOURCE_PROCEDURE */
    void *user_data;       /**< passed to `procedure`; borrowed until release */
} shd_slot;

SHD_END_DECLS

#endif /* SHD_SLOT_H */
