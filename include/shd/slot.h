/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Slots: textures, solid textures, columns of the mesh or functions that feed the coefficients of a material.
 *
 * Thread safety: a slot's function runs on any worker of the executor, and calls may be concurrent. It must not throw
 *                or longjmp. The only functions of shd that it may call are shd_texture_sample() and
 *                shd_solid_evaluate().
 *
 * @code
 * shd_slot slots[2];
 * slots[0] = shd_slot_texture(SHD_SLOT_DIFFUSE, bricks, sampler);
 * slots[1] = shd_slot_vertex(SHD_SLOT_OCCLUSION, 0); // attribute 0 of the mesh
 * desc.slots = slots, desc.slot_count = 2;
 * @endcode
 */
#ifndef SHD_SLOT_H
#define SHD_SLOT_H

#include <shd/fragments.h>
#include <shd/sampler.h>
#include <shd/solid.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/**
 * Coefficient of a material that a slot feeds.
 *
 * The value of the slot multiplies the constant of the same name in shd_material_desc, if there is one. Colours have
 * three channels, scalars one.
 */
typedef enum shd_slot_target {
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
    SHD_SLOT_HEIGHT = 10,   /**< scalar height, for bumps and parallax; takes 2D textures only */
    SHD_SLOT_MATCAP = 11,   /**< colour by the direction of the normal in view; takes 2D textures only */
    /**
     * Scalar: mixed moment of slopes; read with SHD_NORMAL_ENCODING_MOMENTS and SHD_SLOT_NORMAL only. A constant slot
     * gives slopes without covariance.
     */
    SHD_SLOT_NORMAL_MIXED = 12,
    SHD_SLOT_CLEARCOAT = 13,           /**< scalar: strength of the clear coat, clamped to 0..1 */
    SHD_SLOT_CLEARCOAT_ROUGHNESS = 14, /**< scalar: roughness of the clear coat */
    SHD_SLOT_CLEARCOAT_NORMAL = 15, /**< tangent-space normal of the clear coat, SHD_NORMAL_ENCODING_XYZ with z > 0 */
    SHD_SLOT_TINT =
        /**
         * Colour that multiplies the diffuse slot, and a fourth channel that multiplies opacity: colours of vertices
         * over a texture (glTF 2.0, 3.9.2).
         */
    16,
    SHD_SLOT_TARGET_MAX_ENUM = 0x7fffffff
} shd_slot_target;

/** Source of the values of a slot. */
typedef enum shd_slot_source {
    SHD_SLOT_SOURCE_CONSTANT = 0, /**< 1; for the normal (0, 0, 1) in tangent space */
    /**
     * `texture` through `sampler`: 2D at `coordinates`, 3D at the place of a point. If it is SHD_TEXTURE_PREMULTIPLIED,
     * the slots DIFFUSE and TINT have r / a, g / a, b / a of the lookup, or 0 where a is not positive; other slots read
     * the lookup as it is.
     */
    SHD_SLOT_SOURCE_TEXTURE = 1,
    SHD_SLOT_SOURCE_VERTEX = 2,    /**< interpolated attributes of the mesh from `attribute` on; 1 for absent ones */
    SHD_SLOT_SOURCE_PROCEDURE = 3, /**< `procedure` */
    SHD_SLOT_SOURCE_SOLID = 4,     /**< colours of `solid` at the place of a point */
    SHD_SLOT_SOURCE_MAX_ENUM = 0x7fffffff
} shd_slot_source;

/** Coordinates of a 2D texture. */
typedef enum shd_slot_coordinates {
    SHD_SLOT_COORDINATES_UV = 0, /**< uv of the mesh, through uv_transform */
    /**
     * (x / w, y / w) of (x, y, z, w) = place_transform * position, through uv_transform: the picture of a slide
     * projector or a camera. place_transform is any finite matrix. A view-to-clip matrix times a world-to-view matrix
     * and uv_transform = {0.5, 0, 0.5, 0, -0.5, 0.5} put the texture onto the frustum. Where w is not positive, or u or
     * v is not finite, (u, v) is (-1, -1) without a footprint: the border of SHD_WRAP_BORDER. Derivatives are those of
     * the quotients by pixel steps, times `place_width`.
     */
    SHD_SLOT_COORDINATES_PROJECTED = 1,
    /**
     * Three lookups, along the axes of the space of places, and their weighted mean. The texture fills each side of the
     * cube from 0 to 1 and is upright from outside, as the uv of SHD_SHAPE_BOX; uv_transform follows. Weights are
     * |n.x|^k, |n.y|^k, |n.z|^k divided by their sum, where n is the normal in that space and k is
     * triplanar_sharpness; (0, 0, 1) if n is 0 or not finite. n is the normal that shades the point: slots that shape a
     * lobe are looked up before normal maps and bumps, the others after them. Derivatives are those of the place times
     * `place_width`. A lookup with weight 0 has no effect.
     */
    SHD_SLOT_COORDINATES_TRIPLANAR = 2,
    SHD_SLOT_COORDINATES_MAX_ENUM = 0x7fffffff
} shd_slot_coordinates;

/** Space of the places at which solid textures are evaluated. */
typedef enum shd_place_space {
    /**
     * Object space: the position in world space through the inverse of shd_draw.object_to_world. The pattern moves with
     * the object. If the matrix has no inverse, the place is 0 before place_transform.
     */
    SHD_PLACE_SPACE_OBJECT = 0,
    SHD_PLACE_SPACE_WORLD = 1, /**< world space: objects move through the pattern */
    SHD_PLACE_SPACE_MAX_ENUM = 0x7fffffff
} shd_place_space;

/**
 * A function that gives the values of a slot: writes in->count values to each column.
 * @param out  packed columns, initially 1: three for colours, four for the diffuse slot, the tint and for normals, one
 *             for scalars; the others are NULL
 */
typedef void (*shd_slot_fn)(const shd_fragments *in, float *const out[4], void *user_data);

/**
 * A source for a coefficient. Required: target, and the fields that the source uses.
 *
 * Slots that scale light (diffuse, tint, ambient, specular, opacity, emission, metallic, occlusion, matcap) are looked
 * up for every fragment at every frequency. Slots that shape a lobe (exponent, roughness, normal, normal_mixed, height
 * and those of the clear coat) are looked up where lobes are evaluated: at flat and Gouraud frequency at the centroid
 * or vertex, on level 0.
 *
 * Values are not clamped, even if negative. NaN and infinity propagate to the colours of their fragments, which
 * shd_render_stats.nonfinite_fragment_count counts. There are two exceptions. Exponents are clamped to 0..1e6 (NaN
 * becomes 0) and roughness to 0..1 (NaN becomes 1). The surface keeps its normal where a mapped normal is 0 or not
 * finite, or a slope of heights is not finite.
 */
typedef struct shd_slot {
    uint32_t struct_size; /**< set by shd_slot_default(); the same in every element of an array */
    shd_slot_target
        target; /**< the coefficient, a different one in each slot of a material; default SHD_SLOT_DIFFUSE */
    shd_slot_source source; /**< default SHD_SLOT_SOURCE_CONSTANT */
    /**
     * SHD_SLOT_SOURCE_TEXTURE: a 2D texture, or a 3D texture that is looked up at places; else NULL; retained by the
     * material.
     */
    shd_texture *texture;
    shd_sampler *sampler; /**< SHD_SLOT_SOURCE_TEXTURE: NULL = default sampler; retained by the material */
    uint32_t channel;     /**< channel of the texture or the solid texture for scalars, 0..3; default 0 */
    uint32_t uv_set;      /**< coordinates for the texture: 0 = uv of the mesh, 1 = uv1; default 0 */
    /**
     * (u', v') = (t[0] u + t[1] v + t[2], t[3] u + t[4] v + t[5]), finite; default identity. glTF's
     * KHR_texture_transform is T R S, with the rotation r and v downwards
     * t = {sx cos r, sy sin r, ox, -sx sin r, sy cos r, oy}.
     */
    float uv_transform[6];
    uint32_t attribute;    /**< SHD_SLOT_SOURCE_VERTEX: first column, 0..7; default 0 */
    shd_slot_fn procedure; /**< function of SHD_SLOT_SOURCE_PROCEDURE */
    void *user_data;       /**< passed to `procedure`; borrowed until release of the material */
    /**
     * Solid texture of SHD_SLOT_SOURCE_SOLID, else NULL; copied by the material. Colours take r, g, b and, for the
     * diffuse slot and normals, a; scalars take `channel`. At Phong frequency, and for slots that scale light, the
     * width of a pixel is max(|dp/dx|, |dp/dy|), with the exact derivatives of the place p by pixel steps; where lobes
     * are evaluated at vertices or centroids it is 0. `place_width` multiplies it.
     */
    const shd_solid_desc *solid;
    /**
     * Place = place_transform * position, column-major, affine: the last row is 0, 0, 0, 1, except for
     * SHD_SLOT_COORDINATES_PROJECTED; default identity. A solid texture is evaluated at the place. A 3D texture is
     * looked up at (u, v, w) = place, with the derivatives of the place by pixel steps times `place_width`: it fills
     * the cube from 0 to 1, and its sampler wraps it.
     */
    float place_transform[16];
    shd_place_space place_space; /**< space of the position; default SHD_PLACE_SPACE_OBJECT */
    /** Factor of the width of a pixel, 0..1000; 0 = no band limit, level 0 of 3D textures; default 1. */
    float place_width;
    shd_slot_coordinates coordinates; /**< coordinates of a 2D texture; for other sources UV, the default */
    uint32_t triplanar_sharpness;     /**< exponent k of SHD_SLOT_COORDINATES_TRIPLANAR, 1..64; default 4 */
    /* ---- end of 0.1; append below ---- */
} shd_slot;

/** A constant slot of SHD_SLOT_DIFFUSE. Compiled into the caller so that struct_size is the caller's. */
static inline shd_slot shd_slot_default(void)
{
    shd_slot slot = SHD_ZERO_INIT;
    slot.struct_size = (uint32_t)sizeof slot;
    slot.uv_transform[0] = slot.uv_transform[4] = 1.0f;
    slot.place_width = 1.0f;
    slot.triplanar_sharpness = 4;
    slot.place_transform[0] = slot.place_transform[5] = slot.place_transform[10] = slot.place_transform[15] = 1.0f;
    return slot;
}

/** A slot that reads a texture; `sampler` NULL = the default sampler. */
static inline shd_slot shd_slot_texture(shd_slot_target target, shd_texture *texture, shd_sampler *sampler)
{
    shd_slot slot = shd_slot_default();
    slot.target = target;
    slot.source = SHD_SLOT_SOURCE_TEXTURE;
    slot.texture = texture;
    slot.sampler = sampler;
    return slot;
}

/** A slot that reads the columns of the mesh from `attribute` on. */
static inline shd_slot shd_slot_vertex(shd_slot_target target, uint32_t attribute)
{
    shd_slot slot = shd_slot_default();
    slot.target = target;
    slot.source = SHD_SLOT_SOURCE_VERTEX;
    slot.attribute = attribute;
    return slot;
}

/** A slot that calls a function. */
static inline shd_slot shd_slot_procedure(shd_slot_target target, shd_slot_fn procedure, void *user_data)
{
    shd_slot slot = shd_slot_default();
    slot.target = target;
    slot.source = SHD_SLOT_SOURCE_PROCEDURE;
    slot.procedure = procedure;
    slot.user_data = user_data;
    return slot;
}

/** A slot that evaluates a solid texture in object space; `solid` is copied when the material is made. */
static inline shd_slot shd_slot_solid(shd_slot_target target, const shd_solid_desc *solid)
{
    shd_slot slot = shd_slot_default();
    slot.target = target;
    slot.source = SHD_SLOT_SOURCE_SOLID;
    slot.solid = solid;
    return slot;
}

SHD_END_DECLS

#endif /* SHD_SLOT_H */
