/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Views: the transforms from world to clip space, and a camera from which a view is computed.
 *
 * Matrices are float[16], column-major, acting on column vectors. World and view space are right-handed with +Y up; the
 * camera looks along -Z of view space. Clip space: NDC y up, depth 0 near .. 1 far.
 *
 * Thread safety: any thread.
 *
 * @code
 * shd_camera camera = shd_camera_default();
 * camera.eye[1] = 1.0f; // from above
 * result = shd_camera_frame_box(&camera, info.bounds_min, info.bounds_max);
 * render.camera = &camera;
 * @endcode
 */
#ifndef SHD_VIEW_H
#define SHD_VIEW_H

#include <shd/result.h>

SHD_BEGIN_DECLS

/**
 * Transforms from world to clip space. Frozen, because it is a member of shd_render_desc. Later options of a picture
 * are appended to shd_render_desc.
 */
typedef struct shd_view {
    float world_to_view[16]; /**< rigid, finite */
    float view_to_clip[16];  /**< projection, finite */
    float eye[3];            /**< world space; viewing directions (wo) point to it */
} shd_view;

/** A perspective camera. */
typedef struct shd_camera {
    uint32_t struct_size; /**< set by shd_camera_default() */
    float eye[3];         /**< world space; default (0, 0, 3) */
    float target[3];      /**< world space, different from the eye; default 0 */
    float up[3];          /**< world space, any length, not along the line of sight; default (0, 1, 0) */
    float fov_y;          /**< vertical field of view [rad], (0, pi); default 0.8 */
    float aspect;         /**< width / height, > 0; 0 = aspect of the picture, or 1 if there is no picture; default 0 */
    float near_plane;     /**< distance, > 0; default 0.1 */
    float far_plane;      /**< distance, > near_plane; default 100 */
    /* ---- end of 0.1; append below ---- */
} shd_camera;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_camera shd_camera_default(void)
{
    shd_camera camera = SHD_ZERO_INIT;
    camera.struct_size = (uint32_t)sizeof camera;
    camera.eye[2] = 3.0f;
    camera.up[1] = 1.0f;
    camera.fov_y = 0.8f;
    camera.near_plane = 0.1f;
    camera.far_plane = 100.0f;
    return camera;
}

/**
 * Compute the view of a camera; the same bits on every machine. An aspect of 0 counts as 1 here, because there is no
 * picture. Frames that take the camera itself (shd_render_desc.camera) use the aspect of their picture.
 * @param out_view  all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_view_from_camera(const shd_camera *camera, shd_view *out_view);

/**
 * Move a camera so that a box fills its picture, such as the bounds of a scene. The camera keeps its direction (from
 * eye to target), up, fov_y and aspect. Its target becomes the centre of the box. Its eye moves as near as the eight
 * corners allow, and 4 % further. Its planes enclose the ball around the box, which may turn about its centre. Set the
 * aspect of the picture before: an aspect of 0 counts as 1 here.
 * @param camera      changed; unchanged on failure
 * @param bounds_min  world space, at most bounds_max
 * @param bounds_max  world space; a box may be flat, but is no point
 * @return SHD_ERROR_INVALID_ARGUMENT also for a box whose size is lost to the rounding of its place
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_camera_frame_box(shd_camera *camera, const float bounds_min[3],
                                                      const float bounds_max[3]);

SHD_END_DECLS

#endif /* SHD_VIEW_H */
