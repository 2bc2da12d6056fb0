/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Directions on textures: the projections of environment images.
 *
 * Thread safety: this header has no functions.
 *
 * @code
 * shd_texture_desc desc = shd_texture_desc_default();
 * desc.projection = SHD_PROJECTION_LAT_LONG;
 * @endcode
 */
#ifndef SHD_PROJECTION_H
#define SHD_PROJECTION_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Place of a direction in an image. */
typedef enum shd_projection {
    SHD_PROJECTION_NONE = 0,        /**< coordinates are not directions */
    SHD_PROJECTION_LAT_LONG = 1,    /**< latitude and longitude */
    SHD_PROJECTION_MIRROR_BALL = 2, /**< photograph of a mirror ball */
    SHD_PROJECTION_ANGULAR = 3,     /**< angular map */
    SHD_PROJECTION_CUBE = 4,        /**< six faces of a cube */
    SHD_PROJECTION_OCTAHEDRAL = 5,  /**< octahedron unfolded to a square */
    SHD_PROJECTION_MAX_ENUM = 0x7fffffff
} shd_projection;

SHD_END_DECLS

#endif /* SHD_PROJECTION_H */
