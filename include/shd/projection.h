/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Projections: images of all directions, such as environment maps.
 *
 * A projection maps directions (x, y, z) to points (u, v) of an image. The world is right-handed with +Y up; (u, v) =
 * (0, 0) is the outer corner of the first texel of row 0, v points down. a is the angle between the direction and +Z.
 *
 * | projection  | (u, v)                                                             | centre, right, up           |
 * |-------------|--------------------------------------------------------------------|-----------------------------|
 * | LAT_LONG    | u = atan2(-x, z) / 2pi + 1/2, v = 1/2 - atan2(y, hypot(x, z)) / pi | +Z, -X, +Y                  |
 * | MIRROR_BALL | (1/2, 1/2) + sin(a / 2) (x, -y) / (2 hypot(x, y))                  | +Z, +X, +Y; -Z on the rim   |
 * | ANGULAR     | (1/2, 1/2) + a (x, -y) / (2 pi hypot(x, y))                        | +Z, +X, +Y; -Z on the rim   |
 * | CUBE        | face and point of the table below                                  | see below                   |
 * | OCTAHEDRAL  | (1/2, 1/2) + (p, -q) / 2, see below                                | +Z, +X, +Y; -Z in 4 corners |
 *
 * LAT_LONG shows the view from the middle. MIRROR_BALL is the photograph of a mirror ball
 * by a distant camera on +Z, and ANGULAR has the same orientation (Debevec, "Rendering Synthetic Objects into Real
 * Scenes", 1998; "Light Probe Image Gallery"). Both show the directions in a disc; texels outside have no direction.
 *
 * CUBE has six square faces. The face is the axis of the component of largest magnitude; in a tie Z wins over Y and Y
 * over X. With that component r and the components s and t of the table, u = (s / |r| + 1) / 2 and v = (t / |r| + 1) /
 * 2. The faces show the directions mirrored, as in OpenGL, Vulkan and Direct3D (Vulkan 1.3, "Cube Map Face Selection").
 *
 * | face | axis | s  | t  |
 * |------|------|----|----|
 * | 0    | +X   | -z | -y |
 * | 1    | -X   | +z | -y |
 * | 2    | +Y   | +x | +z |
 * | 3    | -Y   | +x | -z |
 * | 4    | +Z   | +x | -y |
 * | 5    | -Z   | -x | -y |
 *
 * OCTAHEDRAL divides by |x| + |y| + |z| and takes (p, q) = (x, y) where z >= 0. Elsewhere the four triangles of the
 * octahedron fold outwards: p = (1 - |y|) sign(x), q = (1 - |x|) sign(y), with sign(0) = 1 (Cigolle et al., "A Survey
 * of Efficient Representations for Independent Unit Vectors", 2014, section 3.3). A program that stores q downwards
 * mirrors its images top to bottom.
 *
 * Defined for all inputs: a direction of length 0, or with a component that is NaN or infinite, counts as +Z and is
 * counted. All other directions may have any length, which has no effect. A component below 2^-100 of the largest
 * one may count as 0. -Z, with all directions within 2^-50 rad, has the point (1, 1/2) of MIRROR_BALL and ANGULAR.
 *
 * Thread safety: any thread. Batches of more than 16384 elements are split over the executor of the context.
 *
 * @code
 * shd_directions directions = shd_directions_default(); // fill projection, count and columns
 * shd_projected_points points = shd_projected_points_default();
 * points.u = shd_f32_out_column(u, 0), points.v = shd_f32_out_column(v, 0);
 * result = shd_projection_project(context, &directions, &points);
 * @endcode
 */
#ifndef SHD_PROJECTION_H
#define SHD_PROJECTION_H

#include <shd/column.h>
#include <shd/context.h>
#include <shd/image.h>
#include <shd/result.h>

SHD_BEGIN_DECLS

/** Maps from directions to points of images. */
typedef enum shd_projection {
    SHD_PROJECTION_NONE = 0,        /**< an image that shows no directions */
    SHD_PROJECTION_LAT_LONG = 1,    /**< longitude across, latitude down; any size, customary: width = 2 height */
    SHD_PROJECTION_MIRROR_BALL = 2, /**< photograph of a mirror ball; square */
    SHD_PROJECTION_ANGULAR = 3,     /**< the distance from the centre is the angle from +Z; square */
    SHD_PROJECTION_CUBE = 4,        /**< six square faces: +X, -X, +Y, -Y, +Z, -Z */
    SHD_PROJECTION_OCTAHEDRAL = 5,  /**< an octahedron unfolded into a square */
    SHD_PROJECTION_MAX_ENUM = 0x7fffffff
} shd_projection;

/** Directions to project, as columns of `count` elements. */
typedef struct shd_directions {
    uint32_t struct_size;       /**< set by shd_directions_default() */
    shd_projection projection;  /**< any but SHD_PROJECTION_NONE; required */
    size_t count;               /**< number of directions; 0 is allowed */
    shd_f32_in direction[3];    /**< x, y, z, any length; required */
    shd_f32_in direction_dx[3]; /**< change of `direction` per pixel step in x; absent = 0 */
    shd_f32_in direction_dy[3]; /**< change of `direction` per pixel step in y; absent = 0 */
    /* ---- end of 0.1; append below ---- */
} shd_directions;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_directions shd_directions_default(void)
{
    shd_directions directions = SHD_ZERO_INIT;
    directions.struct_size = (uint32_t)sizeof directions;
    return directions;
}

/** Columns for points of images; NULL = not wanted. */
typedef struct shd_projected_points {
    uint32_t struct_size;   /**< set by shd_projected_points_default() */
    shd_f32_out u;          /**< across, 0..1 */
    shd_f32_out v;          /**< down, 0..1 */
    shd_u32_out face;       /**< face of CUBE, 0..5; 0 for other projections */
    shd_f32_out dudx;       /**< du/dx, within +-1e30; for CUBE on the plane of the face */
    shd_f32_out dvdx;       /**< dv/dx */
    shd_f32_out dudy;       /**< du/dy */
    shd_f32_out dvdy;       /**< dv/dy */
    size_t nonfinite_count; /**< written: directions that count as +Z */
    /* ---- end of 0.1; append below ---- */
} shd_projected_points;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_projected_points shd_projected_points_default(void)
{
    shd_projected_points points = SHD_ZERO_INIT;
    points.struct_size = (uint32_t)sizeof points;
    return points;
}

/**
 * Project directions to points of an image, with derivatives.
 *
 * u and v are within 3e-7 of the exact values. Derivatives are those of the formulas above. Angles below 2^-50 rad
 * from the poles of LAT_LONG and from the rim of MIRROR_BALL and ANGULAR, where a derivative goes to infinity, count as
 * 2^-50 rad. NaN derivatives of directions count as 0, and so do finite components beside infinite ones. A component
 * below 2^-100 of the largest one of its derivative may count as 0.
 * @param context     its executor and SIMD target are used; concurrent reads
 * @param directions  columns, borrowed for the call
 * @param out         columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_projection_project(shd_context *context, const shd_directions *directions,
                                                        shd_projected_points *out);

/** Points of images, as columns of `count` elements. */
typedef struct shd_image_points {
    uint32_t struct_size;      /**< set by shd_image_points_default() */
    shd_projection projection; /**< any but SHD_PROJECTION_NONE; required */
    size_t count;              /**< number of points; 0 is allowed */
    shd_f32_in u;              /**< across, clamped to 0..1; LAT_LONG repeats; required */
    shd_f32_in v;              /**< down, clamped to 0..1; required */
    shd_u32_in face;           /**< face of CUBE; absent = 0; numbers above 5 mean 5; other projections ignore it */
    /* ---- end of 0.1; append below ---- */
} shd_image_points;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_image_points shd_image_points_default(void)
{
    shd_image_points points = SHD_ZERO_INIT;
    points.struct_size = (uint32_t)sizeof points;
    return points;
}

/** Columns for the directions of points; NULL = not wanted. */
typedef struct shd_point_directions {
    uint32_t struct_size;     /**< set by shd_point_directions_default() */
    shd_f32_out direction[3]; /**< x, y, z, unit; -Z outside the disc of MIRROR_BALL and ANGULAR */
    /**
     * Solid angle per area of (u, v) at the point [sr]; 0 outside the disc. A texel of a small image of n texels has
     * about the n-th part of it; the integral over the image (six faces) is 4 pi.
     */
    shd_f32_out solid_angle;
    size_t nonfinite_count; /**< written: points with a coordinate that is not finite; it counts as 0 */
    /* ---- end of 0.1; append below ---- */
} shd_point_directions;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_point_directions shd_point_directions_default(void)
{
    shd_point_directions directions = SHD_ZERO_INIT;
    directions.struct_size = (uint32_t)sizeof directions;
    return directions;
}

/**
 * Compute the directions of points of an image.
 *
 * The components of directions are within 4e-7 of the exact values; at a distance e from the rim of MIRROR_BALL, within
 * 4e-7 + 1e-7 / sqrt(2 e). Solid angles are within 1e-5 of their largest value.
 * @param context  its executor and SIMD target are used; concurrent reads
 * @param points   columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input or each other (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_projection_unproject(shd_context *context, const shd_image_points *points,
                                                          shd_point_directions *out);

/** Arrangement of the faces of a cube map in images. n is the size of a face. */
typedef enum shd_cube_layout {
    SHD_CUBE_LAYOUT_FACES = 0,            /**< six images of n x n: +X, -X, +Y, -Y, +Z, -Z */
    SHD_CUBE_LAYOUT_ROW = 1,              /**< one image of 6n x n: the faces from left to right */
    SHD_CUBE_LAYOUT_COLUMN = 2,           /**< one image of n x 6n: the faces from top to bottom */
    SHD_CUBE_LAYOUT_HORIZONTAL_CROSS = 3, /**< 4n x 3n: +Y above +Z; -X, +Z, +X, -Z; -Y below +Z */
    SHD_CUBE_LAYOUT_VERTICAL_CROSS = 4,   /**< 3n x 4n: +Y; -X, +Z, +X; -Y; -Z turned by half a turn */
    SHD_CUBE_LAYOUT_MAX_ENUM = 0x7fffffff
} shd_cube_layout;

/** All directions, in one image or six. Required: projection, images. */
typedef struct shd_direction_images {
    uint32_t struct_size;      /**< set by shd_direction_images_default() */
    shd_projection projection; /**< any but SHD_PROJECTION_NONE */
    shd_cube_layout layout;    /**< arrangement of CUBE; default six images; others ignore it */
    /**
     * One image, or the six of SHD_CUBE_LAYOUT_FACES, of one struct_size, format and size. Square for MIRROR_BALL,
     * ANGULAR and OCTAHEDRAL, and the size of the layout for CUBE. Borrowed for the call.
     */
    const shd_image *images;
    /* ---- end of 0.1; append below ---- */
} shd_direction_images;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_direction_images shd_direction_images_default(void)
{
    shd_direction_images images = SHD_ZERO_INIT;
    images.struct_size = (uint32_t)sizeof images;
    return images;
}

/**
 * Convert images of directions to another projection, layout, size or format.
 *
 * Faces of the same projection and size are copied. Otherwise each texel becomes the average over its solid angle of
 * the bilinear lookups of the source, in linear light. Samples along u and along v are at most half as far apart as the
 * texels of the source (measured at the narrowest ones; on the equator of LAT_LONG; from LAT_LONG to LAT_LONG in
 * columns), with at least 2 x 2 in each texel, weighted by their solid angle. Near the rim of a MIRROR_BALL target they
 * are this far apart on average. LAT_LONG sources with far more texels along one axis than a target texel can resolve
 * along both are averaged along it first, so that the work is at most about 64 samples for each pixel of the target and
 * 16 for each pixel of the source. Equal texels give exactly their value. The integral over the sphere is kept to the
 * rounding of the format and the error of the samples: docs/environments.md has measurements. Texels of MIRROR_BALL and
 * ANGULAR outside the disc continue the image across the rim, so that bilinear lookups and mip levels there have no
 * border. Unused parts of crosses become 0. Channels that the source lacks are 0, alpha 1; channels that the target
 * lacks are dropped.
 * @param context  its executor and SIMD target are used; its allocator provides 16 bytes for each pixel of the source
 * @param from     source; at most 2^26 pixels
 * @param to       target; at most 2^26 pixels; its pixels are written; they must not overlap other images (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_projection_convert(shd_context *context, const shd_direction_images *from,
                                                        const shd_direction_images *to);

SHD_END_DECLS

#endif /* SHD_PROJECTION_H */
