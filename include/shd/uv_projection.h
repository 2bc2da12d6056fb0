/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Texture coordinates from positions, for meshes without coordinates.
 *
 * shd_mesh_desc.uv_projection computes uv from the places of the vertices in the projection's space, which
 * shd_mesh_desc.object_to_projection leads to. shd_scene_desc.uv_projection does so for the meshes of a file. The space
 * has the conventions of object space: right-handed, +Y up. The cube from -1 to 1 is covered by one copy of the
 * texture; v runs down.
 *
 * | projection  | uv of the place (x, y, z)                                                                      |
 * |-------------|------------------------------------------------------------------------------------------------|
 * | planar      | ((1 + x) / 2, (1 - y) / 2): the texture upright, seen from +Z                                  |
 * | spherical   | u = the turn around +Y, v = the angle from +Y / pi: the uv of SHD_SHAPE_SPHERE                  |
 * | cylindrical | u = the turn around +Y, v = (1 - y) / 2                                                        |
 * | box         | planar from the side of the cube that a triangle faces: the uv of SHD_SHAPE_BOX                |
 *
 * The turn is 0 on -Z, 1/4 on -X, 1/2 on +Z and 3/4 on +X.
 *
 * uv of one vertex may differ between its triangles. The vertex is then split: it keeps the uv of its first triangle,
 * and one copy for each further uv follows the caller's vertices, in the order of their originals and of their u and v.
 * Normals are computed before, so that a split shows no crease.
 * - Seam of the turn: in each triangle, u continues past 1 where this makes its range smaller. The range is at most 1/2
 *   unless the axis passes through the triangle.
 * - Axis: a vertex on the axis takes, in each triangle, the mean of the u of its corners off the axis; 0 if there is
 *   none. A vertex counts as on the axis if its distance from it is at most 2^-20 of the sum of the magnitudes of all
 *   products and offsets that give its place. The centre of a sphere has v = 1/2.
 * - Box: a triangle has the side of the largest component of its normal. Equal components have the order x, y, z.
 *   Triangles without area and vertices without triangles have the side +X.
 *
 * Places are computed in double. Coordinates that are not finite as floats, and those of vertices that are not finite,
 * are 0. In a triangle with a vertex that is not finite, u neither continues past 1 nor is a mean. The bits are equal
 * on every machine.
 */
#ifndef SHD_UV_PROJECTION_H
#define SHD_UV_PROJECTION_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Rules that give texture coordinates to positions. */
typedef enum shd_uv_projection {
    SHD_UV_PROJECTION_NONE = 0,        /**< no coordinates from positions */
    SHD_UV_PROJECTION_PLANAR = 1,      /**< along -Z onto a plane */
    SHD_UV_PROJECTION_SPHERICAL = 2,   /**< from the centre onto a sphere with the axis Y */
    SHD_UV_PROJECTION_CYLINDRICAL = 3, /**< from the axis Y onto a cylinder */
    SHD_UV_PROJECTION_BOX = 4,         /**< onto the six sides of a cube */
    SHD_UV_PROJECTION_MAX_ENUM = 0x7fffffff
} shd_uv_projection;

SHD_END_DECLS

#endif /* SHD_UV_PROJECTION_H */
