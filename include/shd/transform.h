/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Matrices for views and draws.
 *
 * All matrices have the convention of shd_view and shd_draw: float[16], column-major, element (row, column) at
 * [4 * column + row], acting on column vectors from the left. World and view space are right-handed with +Y up; the
 * camera looks along -Z of view space. In clip space NDC y is up and depth is 0..1.
 *
 * Every function computes in double and rounds once, with the same bits on every machine. Inputs must be finite unless
 * the function allows otherwise. An output may be the memory of an input. A call that fails does not change the output.
 * Nothing is allocated.
 *
 * First calls: shd_matrix_from_trs() for draws; shd_matrix_look_at() and shd_matrix_perspective() for views.
 *
 * Thread safety: any thread.
 *
 * @code
 * const float translation[3] = {0, 1, 0}, quaternion[4] = {0, 0, 0, 1}, scale[3] = {2, 2, 2};
 * result = shd_matrix_from_trs(translation, quaternion, scale, draw.object_to_world);
 * @endcode
 */
#ifndef SHD_TRANSFORM_H
#define SHD_TRANSFORM_H

#include <shd/result.h>

SHD_BEGIN_DECLS

/** Depths of the near and far plane. */
typedef enum shd_depth_order {
    SHD_DEPTH_ORDER_FORWARD = 0, /**< 0 near .. 1 far */
    /** 1 near .. 0 far, for draws that compare with SHD_COMPARE_GREATER and a clear_depth of 0. */
    SHD_DEPTH_ORDER_REVERSED = 1,
    SHD_DEPTH_ORDER_MAX_ENUM = 0x7fffffff
} shd_depth_order;

/**
 * Perspective projection, view to clip space. With SHD_DEPTH_ORDER_FORWARD and a finite far plane it has the bits of
 * shd_view_from_camera().
 * @param fov_y       vertical field of view [rad], (0, pi)
 * @param aspect      width / height, > 0
 * @param near_plane  distance, > 0
 * @param far_plane   distance, > near_plane; INFINITY = no far plane
 * @param order       depths of the two planes
 * @param out_matrix  [16]
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_perspective(float fov_y, float aspect, float near_plane, float far_plane,
                                                        shd_depth_order order, float *out_matrix);

/**
 * Parallel projection, view to clip space.
 * @param rectangle   left, right, bottom, top of the volume in view space; left is not right, bottom is not top
 * @param near_plane  distance along -Z, may be negative
 * @param far_plane   distance, > near_plane
 * @param order       depths of the two planes
 * @param out_matrix  [16]
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_orthographic(const float rectangle[4], float near_plane, float far_plane,
                                                         shd_depth_order order, float *out_matrix);

/**
 * Rigid transform from world to view space: the eye is at the origin, the target on -Z. It has the bits of
 * shd_view_from_camera().
 * @param eye         world space
 * @param target      world space, not the eye
 * @param up          world space, any length, not along the line of sight
 * @param out_matrix  [16]
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_look_at(const float eye[3], const float target[3], const float up[3],
                                                    float *out_matrix);

/**
 * translation * rotation * scale, as glTF 2.0 places nodes.
 * @param translation  NULL = none
 * @param rotation     quaternion x, y, z, w of any length except 0; NULL = none
 * @param scale        factors along x, y, z; NULL = none
 * @param out_matrix   [16]
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_from_trs(const float translation[3], const float rotation[4],
                                                     const float scale[3], float *out_matrix);

/**
 * The product a b. Applied to a vector, b acts first.
 * @param a,b         [16]
 * @param out_matrix  [16]
 * @return SHD_ERROR_INVALID_ARGUMENT also for a product beyond the range of float
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_multiply(const float *a, const float *b, float *out_matrix);

/**
 * The inverse. An affine matrix, with (0, 0, 0, 1) as its last row, has an affine inverse.
 * @param matrix      [16]
 * @param out_matrix  [16]
 * @return SHD_ERROR_INVALID_ARGUMENT for a matrix that is singular, or indistinguishable from a singular one in double
 *         precision, and for an inverse beyond the range of float
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_invert(const float *matrix, float *out_matrix);

/**
 * The matrix for normals that belongs to `matrix`: the inverse transpose of its upper left 3 x 3. Transformed normals
 * are not unit vectors and need normalising. shd_render() transforms normals by itself.
 * @param matrix  [16]
 * @param out_3x3  [9], column-major
 * @return SHD_ERROR_INVALID_ARGUMENT as shd_matrix_invert, of the 3 x 3
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_normal(const float *matrix, float *out_3x3);

/**
 * A point, (x, y, z, 1), transformed and divided by its w.
 * @param matrix     [16]
 * @param point      x, y, z
 * @param out_point  [3]
 * @return SHD_ERROR_INVALID_ARGUMENT also where w is 0, and for a result beyond the range of float
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_transform_point(const float *matrix, const float point[3],
                                                            float *out_point);

/**
 * A direction, (x, y, z, 0), transformed; the translation and the last row of the matrix have no effect.
 * @param matrix         [16]
 * @param direction      x, y, z
 * @param out_direction  [3]
 * @return SHD_ERROR_INVALID_ARGUMENT also for a result beyond the range of float
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_matrix_transform_direction(const float *matrix, const float direction[3],
                                                                float *out_direction);

SHD_END_DECLS

#endif /* SHD_TRANSFORM_H */
