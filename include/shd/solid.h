/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Solid textures: patterns and noise as functions of a place in space.
 *
 * A solid texture needs no texture coordinates: an object looks as if it were carved from the pattern. Positions are
 * divided by `size` first, so that a lattice cell, a stripe and a square of the checker have the side 1. In the table,
 * p = (x, y, z) is the divided position, n the noise of one octave, and N the sum of the octaves (see
 * shd_solid_desc.octaves).
 *
 * | kind    | value                                                                | range                         |
 * |---------|----------------------------------------------------------------------|-------------------------------|
 * | STRIPES | 0 if sin(pi x) > 0, otherwise 1                                      | 0, 1                          |
 * | CHECKER | (floor(x) + floor(y) + floor(z)) modulo 2                            | 0, 1                          |
 * | PERLIN  | gradient noise on the integer lattice                                | -1..1, with turbulence 0..1   |
 * | VALUE   | random values at the lattice points, interpolated                    | -1..1, with turbulence 0..1   |
 * | SIMPLEX | gradient noise on a lattice of tetrahedra                            | -1..1, with turbulence 0..1   |
 * | WORLEY  | distance to feature points, one per cell, divided by sqrt(3)         | 0..1                          |
 * | MARBLE  | (1 + sin(pi (x + distortion N))) / 2 with turbulence N of Perlin     | 0..1                          |
 * | WOOD    | rings: smooth(0, 0.8, f) - smooth(0.83, 1, f) with f the fraction of | 0..1                          |
 * |         | sqrt(x^2 + z^2) + distortion N, and N of Perlin                      |                               |
 *
 * PERLIN with SHD_SOLID_GRADIENTS_TABLE and SHD_SOLID_FADE_CUBIC is the classic form: n = sum over the eight lattice
 * points (i, j, k) around p of w(x - i) w(y - j) w(z - k) (G . (x - i, y - j, z - k)), with w(t) = 2 |t|^3 - 3 |t|^2 +
 * 1 and G a unit vector of a table of 256, at phi(i + phi(j + phi(k))) (Perlin, "An Image Synthesizer", 1985; Shirley
 * and Marschner, "Fundamentals of Computer Graphics", solid noise). |n| <= sqrt(3) / 2. The pattern repeats every 256
 * cells. SHD_SOLID_FADE_QUINTIC weighs by 6 t^5 - 15 t^4 + 10 t^3 instead, and SHD_SOLID_GRADIENTS_HASHED chooses one
 * of the twelve gradients (1, 1, 0) .. (0, -1, -1) by a hash of the lattice point (Perlin, "Improving Noise", 2002).
 * SHD_SOLID_FADE_LINEAR weighs by 1 - |t|; its gradients are those of the cell that contains the place. The hashed sum
 * is multiplied by 0.9649 (quintic), 0.957 (cubic) or 0.9391 (linear), so that |n| <= 1. SIMPLEX has these gradients
 * with weights 76.88 max(0, 1/2 - r^2)^4, so that |n| <= 1 too (Perlin, "Noise Hardware", 2001). WORLEY is exact: F1
 * and F2 are the distances to the nearest and the second nearest of all feature points (Worley, "A Cellular Texture
 * Basis Function", 1996). The rings of WOOD run around the y axis; smooth() is the cubic step (Peachey in Ebert et al.,
 * "Texturing and Modeling", 2002).
 *
 * Band limit: with a `width` w, in cells, an octave of frequency f keeps its full amplitude up to w f = 1/2, where the
 * pixels are half a wavelength wide, and is replaced by its mean from w f = 1 on; in between it fades linearly (Norton
 * et al., "Clamping", 1982). STRIPES and CHECKER are averaged over a cube of side w instead, within 2^-22 / w; widths
 * below 2^-12 cells count as 0. The waves of MARBLE have f = 1/2, the rings of WOOD f = 1.
 *
 * Defined for all inputs: NaN and infinite coordinates count as 0, NaN and negative widths as 0. Noise clamps
 * coordinates to 2^23 cells of each octave (SIMPLEX to 2^22), beyond which it is constant, and so do the waves of
 * MARBLE and the rings of WOOD; gradients there are those at the clamped place. All floats beyond 2^24 are even
 * integers, where stripes are 1 and the checker no longer changes.
 *
 * Every value depends on its own inputs only: results have the same bits for any batch size, order, worker count and
 * SIMD target.
 *
 * Thread safety: any thread. With a context, batches of more than 16384 points are split over its executor. Fragment
 *                programs, vertex programs and procedures of slots may call shd_solid_evaluate().
 *
 * @code
 * shd_solid_desc desc = shd_solid_desc_default();
 * shd_solid_points points = shd_solid_points_default(); // fill count and position
 * shd_solid_values values = shd_solid_values_default();
 * desc.kind = SHD_SOLID_PERLIN;
 * desc.octaves = 6;
 * values.value = shd_f32_out_column(noise, 0);
 * result = shd_solid_evaluate(context, &desc, &points, &values);
 * @endcode
 */
#ifndef SHD_SOLID_H
#define SHD_SOLID_H

#include <shd/column.h>
#include <shd/context.h>
#include <shd/result.h>

SHD_BEGIN_DECLS

/** Pattern of a solid texture; the file's comment has the formulas. */
typedef enum shd_solid {
    SHD_SOLID_STRIPES = 0, /**< two colours, across x */
    SHD_SOLID_CHECKER = 1, /**< cubes of two colours */
    SHD_SOLID_PERLIN = 2,  /**< gradient noise on the integer lattice */
    SHD_SOLID_VALUE = 3,   /**< interpolated random values */
    SHD_SOLID_SIMPLEX = 4, /**< gradient noise on a lattice of tetrahedra */
    SHD_SOLID_WORLEY = 5,  /**< distances to random points */
    SHD_SOLID_MARBLE = 6,  /**< waves across x, distorted by turbulence */
    SHD_SOLID_WOOD = 7,    /**< rings around y, distorted by noise */
    SHD_SOLID_MAX_ENUM = 0x7fffffff
} shd_solid;

/** Sum of octaves. */
typedef enum shd_solid_sum {
    SHD_SOLID_SUM_FBM = 0,        /**< fractional Brownian motion: the sum of n */
    SHD_SOLID_SUM_TURBULENCE = 1, /**< the sum of |n| */
    SHD_SOLID_SUM_MAX_ENUM = 0x7fffffff
} shd_solid_sum;

/** Gradients of SHD_SOLID_PERLIN. */
typedef enum shd_solid_gradients {
    SHD_SOLID_GRADIENTS_HASHED = 0, /**< twelve gradients, chosen by an integer hash; fastest */
    SHD_SOLID_GRADIENTS_TABLE = 1,  /**< 256 random unit vectors, through a permutation table */
    SHD_SOLID_GRADIENTS_MAX_ENUM = 0x7fffffff
} shd_solid_gradients;

/** Weight of a lattice point at distance t along an axis. */
typedef enum shd_solid_fade {
    SHD_SOLID_FADE_QUINTIC = 0, /**< second derivatives are continuous */
    SHD_SOLID_FADE_CUBIC = 1,   /**< Hermite interpolation: first derivatives are continuous */
    SHD_SOLID_FADE_LINEAR = 2,  /**< trilinear interpolation: the borders of the cells show as creases, Mach bands */
    SHD_SOLID_FADE_MAX_ENUM = 0x7fffffff
} shd_solid_fade;

/** Distance of SHD_SOLID_WORLEY. */
typedef enum shd_solid_distance {
    SHD_SOLID_DISTANCE_F1 = 0,    /**< to the nearest feature point */
    SHD_SOLID_DISTANCE_F2 = 1,    /**< to the second nearest feature point */
    SHD_SOLID_DISTANCE_F2_F1 = 2, /**< F2 - F1: 0 on the borders between the cells of the points */
    SHD_SOLID_DISTANCE_MAX_ENUM = 0x7fffffff
} shd_solid_distance;

/** Largest number of colours of a solid texture. */
#define SHD_MAX_SOLID_COLORS 8

/** A solid texture: a pattern, its octaves and its colours. It has no pointers, so a copy is independent. */
typedef struct shd_solid_desc {
    uint32_t struct_size; /**< set by shd_solid_desc_default() */
    shd_solid kind;       /**< default SHD_SOLID_STRIPES */
    uint32_t seed;        /**< another seed gives another pattern of the same kind; no effect on STRIPES, CHECKER */
    float size;           /**< side of a cell or width of a stripe [units of the positions], 1e-30..1e30; default 1 */
    /**
     * Number of octaves of PERLIN, VALUE, SIMPLEX, WORLEY, and of the noise in MARBLE and WOOD, 1..32; default 1. The
     * sum is N = sum of gain^i n(lacunarity^i p) / sum of gain^i, for i from 0 on. Each octave has a pattern of its
     * own, except with SHD_SOLID_GRADIENTS_TABLE, as in the classic form.
     */
    uint32_t octaves;
    float lacunarity;              /**< ratio of the frequencies of successive octaves, 1..16; default 2 */
    float gain;                    /**< ratio of the amplitudes of successive octaves, 0..1; default 1/2 */
    shd_solid_sum sum;             /**< PERLIN, VALUE and SIMPLEX: default SHD_SOLID_SUM_FBM */
    shd_solid_gradients gradients; /**< PERLIN: default SHD_SOLID_GRADIENTS_HASHED */
    shd_solid_fade fade;           /**< PERLIN, VALUE, MARBLE and WOOD: default SHD_SOLID_FADE_QUINTIC */
    shd_solid_distance distance;   /**< WORLEY: default SHD_SOLID_DISTANCE_F1 */
    float distortion;              /**< MARBLE and WOOD: factor of the noise [cells], 0..1000; default 1 */
    /** Values of the first and the last colour, -1e6..1e6; equal = the limits of the kind's range; default 0, 0. */
    float range[2];
    size_t color_count; /**< 2..SHD_MAX_SOLID_COLORS; default 2 */
    /**
     * r, g, b, a at equal distances over `range`, linear, -1e6..1e6; values in between are interpolated, values beyond
     * `range` have the nearest colour. Default black and white, both opaque.
     */
    float colors[SHD_MAX_SOLID_COLORS][4];
    /* ---- end of 0.1; append below ---- */
} shd_solid_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_solid_desc shd_solid_desc_default(void)
{
    shd_solid_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.size = 1.0f;
    desc.octaves = 1;
    desc.lacunarity = 2.0f;
    desc.gain = 0.5f;
    desc.distortion = 1.0f;
    desc.color_count = 2;
    desc.colors[1][0] = desc.colors[1][1] = desc.colors[1][2] = 1.0f;
    desc.colors[0][3] = desc.colors[1][3] = 1.0f;
    return desc;
}

/** Points at which a solid texture is evaluated, as columns of `count` elements. Required: position. */
typedef struct shd_solid_points {
    uint32_t struct_size;   /**< set by shd_solid_points_default() */
    size_t count;           /**< number of points; 0 is allowed */
    shd_f32_in position[3]; /**< x, y, z; required */
    shd_f32_in width;       /**< diameter of a pixel at the point [units of the positions]; absent = 0: no band limit */
    /* ---- end of 0.1; append below ---- */
} shd_solid_points;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_solid_points shd_solid_points_default(void)
{
    shd_solid_points points = SHD_ZERO_INIT;
    points.struct_size = (uint32_t)sizeof points;
    return points;
}

/** Columns for the values of a solid texture; NULL = not wanted. At least one is required. */
typedef struct shd_solid_values {
    uint32_t struct_size; /**< set by shd_solid_values_default() */
    shd_f32_out value;    /**< the pattern, in the range of its kind */
    /**
     * d value / dx, dy and dz, with the width held constant, limited to -1e30..1e30. Where the pattern jumps or has no
     * derivative the result is that of one side, or 0.
     */
    shd_f32_out gradient[3];
    shd_f32_out channel[4]; /**< r, g, b, a of shd_solid_desc.colors at the value, linear */
    size_t nonfinite_count; /**< written: points whose position or width is not finite */
    /* ---- end of 0.1; append below ---- */
} shd_solid_values;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_solid_values shd_solid_values_default(void)
{
    shd_solid_values values = SHD_ZERO_INIT;
    values.struct_size = (uint32_t)sizeof values;
    return values;
}

/**
 * Evaluate a solid texture at `points->count` points.
 * @param context  its executor and SIMD target are used; concurrent reads
 * @param desc     borrowed for the call
 * @param points   columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_solid_evaluate(shd_context *context, const shd_solid_desc *desc,
                                                    const shd_solid_points *points, shd_solid_values *out);

SHD_END_DECLS

#endif /* SHD_SOLID_H */
