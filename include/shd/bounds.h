/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief The values that a conforming implementation may return for a lookup.
 *
 * Graphics APIs leave room in texture filtering: the bits of a texel coordinate and of a level of detail,
 * approximations of the footprint, the places of anisotropic probes. shd_texture_bounds() computes the smallest and the
 * largest legal value of each lookup. A result outside is a bug. A result inside may be legal.
 *
 * The model. Let x = u n on an axis of n texels of a level.
 *  - Coordinates. An implementation may compute any x' within coordinate_error n max(1, |u|) of x. It may then use
 *    any coordinate between the multiples of 2^-subtexel_bits around x'. This contains truncation, other roundings and
 *    more bits. NEAREST cannot cross a texel's border downwards by rounding, because the border is on the grid.
 *  - Weights of four texels, of eight in 3D, are the products of the coordinates' fractions. Their rounding may move
 *    the average by 2^-weight_bits times the difference of the largest and the smallest of these texels.
 *  - Levels of detail lie between the smallest and the largest one of the rules `level_rules`, with derivatives within
 *    derivative_error (relative). Then level_error is added on both sides, the sampler's bias and clamps are applied,
 *    and the level may be rounded in either direction to level_bits, or to more bits. Bounds of levels have no other
 *    slack: without errors, a level on the grid of level_bits is the only legal one. Derivatives of CUBE are those on
 *    the plane of the face, of any length. Derivatives of other directions have the error of coordinates, relative to
 *    the change of the direction and the stretch of the projection. An infinite derivative has the coarsest level. The
 *    nearest level is ceil(lod + 1/2) - 1 or floor(lod + 1/2).
 *  - Magnification is legal where a legal level of detail is 0 or below, and minification where one is above 0.
 *  - ANISOTROPIC. Let p and q be the longer and the shorter axis of a rule, and a = max_anisotropy. The value is an
 *    average of pairs of trilinear lookups, at c + t d and c - t d, of any number, with weights >= 0 of sum 1. c is
 *    the point of the lookup, d is the vector of p, and 0 <= t <= (1 - 1/N) / 2 with N = ceil(min(|p| / |q|, a)). All
 *    lookups have one level of detail, between log2(max(|q|, |p| / a)) and log2|p|. This contains the rules of Vulkan
 *    and Direct3D 11, and one probe on the isotropic level. For SHD_LEVEL_RULE_OPENGL the lower end is log2(|p| / N).
 *  - Comparison lookups (`compares`) compare before they blend. The reference may be rounded to a texture's format of 8
 *    or 16 bits in either direction by half a step, as Direct3D requires and Vulkan does not. A reference that is NaN
 *    may give either result.
 *  - sRGB texels are decoded before filtering, each within srgb_error codes of its own.
 *  - Results have a relative error of relative_error times the largest magnitude among the texels. Results of
 *    comparisons, and of formats of 8 and 16 bits without floats, may be rounded to result_bits as well: half of
 *    1 / (2^result_bits - 1).
 *
 * Supported: the filters NEAREST, BILINEAR, NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP, TRILINEAR and ANISOTROPIC,
 * with and without comparisons; 2D textures, arrays, 3D textures, and directions except SHD_PROJECTION_LAT_LONG,
 * because no standard defines its lookups along parallels; every format, wrap and store. Missing tiles are loaded, for
 * any missing_tiles. Other filters, bicubic and Hermite magnification, blur, a level_blend other than 1, nearest
 * magnification of ANISOTROPIC, and SHD_PRECISION_FAST of ANISOTROPIC in LEAST_ERROR and EXACT return
 * SHD_ERROR_UNSUPPORTED.
 *
 * Directions within 2^-20 of an edge of the cube, or of a fold of an octahedral map, may be on either side. Filters
 * read beyond the edges of an image, where the directions continue. The missing texel of a corner of the cube is the
 * average of the other three. An octahedral map continues turned by half a circle about the middle of the edge, for at
 * most one image. A point at a distance r > 1 from the centre of MIRROR_BALL or ANGULAR is the point at 2 - r on the
 * other side, and a texel whose centre is such a point is the nearest one to it inside. These two have the range of the
 * format within 2^-20 of -Z, which is every point of the rim.
 *
 * Defined for all inputs, as shd_texture_sample(): NaN and infinite coordinates count as 0, and so on. A channel of
 * which a legal texel is not finite has the bounds -infinity and infinity, and NaN is legal for it. Where an error
 * covers more than 64 texels on an axis of more than 64 (in 3D 16), or a line of probes more than 256 texels, the
 * bounds are the range of the format: [0, 1] with the border, or -infinity to infinity. Bounds are computed in double
 * and rounded outwards.
 *
 * Sources: Vulkan 1.3 specification, "Image Operations" and "Limits"; Direct3D 11.3 functional specification, 7.18;
 * OpenGL 4.6 core profile, 8.14; EXT_texture_filter_anisotropic.
 *
 * Thread safety: concurrent reads. Large batches are split over the executor of the texture's context.
 *
 * @code
 * shd_bounds_desc desc = shd_bounds_desc_default();
 * result = shd_bounds_desc_from_rules(SHD_RULES_D3D11, &desc);
 * shd_texels lower = shd_texels_default(), upper = shd_texels_default();
 * lower.channel[0] = shd_f32_out_column(low, 0), upper.channel[0] = shd_f32_out_column(high, 0);
 * result = shd_texture_bounds(texture, sampler, &lookups, &desc, &lower, &upper);
 * for (i = 0; i < count; ++i) legal[i] = low[i] <= red[i] && red[i] <= high[i];
 * @endcode
 */
#ifndef SHD_BOUNDS_H
#define SHD_BOUNDS_H

#include <shd/lookup.h>

SHD_BEGIN_DECLS

/**
 * Legal definitions of the size p of a footprint, whose level of detail is log2 p; combine with |. Below, x and y are
 * the derivatives in base-level texels. Derivatives of 3D textures have a third component, x_w and y_w, which joins
 * every sum and every maximum.
 */
typedef enum shd_level_rule {
    SHD_LEVEL_RULE_NONE = 0,
    SHD_LEVEL_RULE_LENGTHS = 1, /**< axes x and y: p = max(|x|, |y|). Vulkan's and OpenGL's definition */
    SHD_LEVEL_RULE_ELLIPSE = 2, /**< the axes of the ellipse that x and y span, as Direct3D 11 defines */
    /**
     * Vulkan's approximations, each of its own size: max(|x_u|, |x_v|) <= |x| <= sqrt(2) (|x_u| + |x_v|), and y
     * likewise.
     */
    SHD_LEVEL_RULE_VULKAN = 4,
    /** OpenGL's: with m_u = max(|x_u|, |y_u|) and m_v = max(|x_v|, |y_v|), max(m_u, m_v) <= p <= m_u + m_v. */
    SHD_LEVEL_RULE_OPENGL = 8,
    /** The profile of the sampler (shd_profile); not OIIO, which returns SHD_ERROR_UNSUPPORTED. */
    SHD_LEVEL_RULE_PROFILE = 16,
    SHD_LEVEL_RULE_MAX_ENUM = 0x7fffffff
} shd_level_rule;
typedef uint32_t shd_level_rule_flags; /**< shd_level_rule bits */

/** Rules of a graphics API, for shd_bounds_desc_from_rules(). */
typedef enum shd_rules {
    /** The least precision that Vulkan 1.3 allows: 4 bits of coordinates and of levels; LENGTHS, ELLIPSE, VULKAN. */
    SHD_RULES_VULKAN = 0,
    /** Direct3D 11.3: 8 bits of coordinates and of levels; LENGTHS, ELLIPSE. */
    SHD_RULES_D3D11 = 1,
    /** WebGPU has no rules of its own and runs on other APIs: VULKAN's bits, and the rules of the other three. */
    SHD_RULES_WEBGPU = 2,
    /** OpenGL 4.6 has no least number of bits: VULKAN's bits; LENGTHS, OPENGL. */
    SHD_RULES_OPENGL = 3,
    SHD_RULES_MAX_ENUM = 0x7fffffff
} shd_rules;

/** The precision of implementations. Defaults are the rules of SHD_RULES_VULKAN. */
typedef struct shd_bounds_desc {
    uint32_t struct_size;             /**< set by shd_bounds_desc_default() */
    shd_level_rule_flags level_rules; /**< at least one; default LENGTHS | ELLIPSE | VULKAN */
    uint32_t subtexel_bits;           /**< fraction bits of a texel coordinate, 2..24; default 4 */
    uint32_t level_bits;              /**< fraction bits of a level of detail, 1..24; default 4 */
    uint32_t weight_bits;             /**< bits of the weights of texels, 1..24; 0 = exact; default 9 */
    uint32_t result_bits;             /**< bits of the results of unorm formats, 1..24; 0 = not rounded; default 8 */
    float coordinate_error;           /**< error of a coordinate, relative to max(1, |u|), 0..1/16; default 2^-21 */
    float derivative_error;           /**< relative error of the derivatives, 0..1/2; default 0 */
    float level_error;                /**< error of a level of detail before bias, 0..16; default 2^-10 */
    float relative_error;             /**< error of a result relative to the largest texel, 0..1; default 2^-16 */
    float srgb_error;                 /**< error of a decoded sRGB texel [codes], 0..1; default 1/2 */
    /* ---- end of 0.1; append below ---- */
} shd_bounds_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_bounds_desc shd_bounds_desc_default(void)
{
    shd_bounds_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.level_rules = SHD_LEVEL_RULE_LENGTHS | SHD_LEVEL_RULE_ELLIPSE | SHD_LEVEL_RULE_VULKAN;
    desc.subtexel_bits = desc.level_bits = 4;
    desc.weight_bits = 9;
    desc.result_bits = 8;
    desc.coordinate_error = 1.0f / 2097152.0f;
    desc.level_error = 1.0f / 1024.0f;
    desc.relative_error = 1.0f / 65536.0f;
    desc.srgb_error = 0.5f;
    return desc;
}

/**
 * Get the precision that the rules of a graphics API require at least.
 * @param rules     one of shd_rules
 * @param out_desc  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_bounds_desc_from_rules(shd_rules rules, shd_bounds_desc *out_desc);

/**
 * Compute the legal values of `lookups->count` lookups.
 * @param texture  concurrent reads
 * @param sampler  may come from another context
 * @param lookups  columns, borrowed for the call
 * @param desc     borrowed for the call; NULL = all defaults
 * @param lower    smallest legal values; columns of `channel` only, which must not overlap any input or each other
 *                 (checked)
 * @param upper    largest legal values, as `lower`
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_bounds(const shd_texture *texture, const shd_sampler *sampler,
                                                    const shd_lookups *lookups, const shd_bounds_desc *desc,
                                                    shd_texels *lower, shd_texels *upper);

SHD_END_DECLS

#endif /* SHD_BOUNDS_H */
