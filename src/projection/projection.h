// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: projection, (directions <-> points of images of directions).
///
/// Input:      columns of directions, or of points (u, v) and faces.
/// Output:     columns of points with their derivatives, or of directions with the solid angle per area of (u, v).
/// Units:      directions are in world space, right-handed, +Y up, of any length; (u, v) is normalised, v points down;
///             solid angles in steradians. The formulas stand in shd/projection.h.
/// Invariants: nothing is allocated; every bit pattern gives finite results. Results have the same bits on every
///             target and depend on their own lane only.
///
/// | file                  | contents                                                        |
/// |-----------------------|-----------------------------------------------------------------|
/// | projection-inl.h      | the table of the maps, one class for each projection            |
/// | direction-inl.h       | directions scaled to components up to 1                         |
/// | lat_long-inl.h        | SHD_PROJECTION_LAT_LONG                                         |
/// | disc-inl.h            | SHD_PROJECTION_MIRROR_BALL and ANGULAR: maps onto a disc        |
/// | cube-inl.h            | SHD_PROJECTION_CUBE                                             |
/// | octahedral-inl.h      | SHD_PROJECTION_OCTAHEDRAL                                       |
/// | projection.cpp        | batches of the above                                            |
/// | solid_angle.cpp       | the exact solid angle of a texel, in double                     |
/// | texels.cpp            | rows of directions and solid angles of texels; sizes of texels  |
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/projection.h>

#include "core/simd_target.h"

namespace shd::projection {

/// Packed columns of directions; `steps` is the change of the direction per pixel step in x and in y, null = 0.
struct Directions {
  size_t count;
  const float* direction[3];
  const float* step[2][3];
};

/// Packed columns of points; null = not wanted.
struct Points {
  float *u, *v;
  uint32_t* face;
  float *du[2], *dv[2];  // per pixel step in x and in y
};

/// Returns the number of directions that count as +Z.
size_t project(shd_projection projection, const core::SimdTarget& simd, const Directions& in, const Points& out);

/// Packed columns of points. `face` null = 0.
struct ImagePoints {
  size_t count;
  const float *u, *v;
  const uint32_t* face;
};

/// Packed columns of unit directions, and of solid angles per area of (u, v); null = not wanted.
struct PointDirections {
  float* direction[3];
  float* solid_angle;
};

/// Returns the number of points with a coordinate that is not finite.
size_t unproject(shd_projection projection, const core::SimdTarget& simd, const ImagePoints& in,
                 const PointDirections& out);

/// The last constant of shd_projection before MAX_ENUM.
constexpr shd_projection kLastProjection = SHD_PROJECTION_OCTAHEDRAL;

/// Number of images of a projection: 6 square ones for CUBE, otherwise 1.
constexpr uint32_t face_count(shd_projection projection) {
  switch (projection) {
    case SHD_PROJECTION_CUBE: return 6;
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_LAT_LONG:
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR:
    case SHD_PROJECTION_OCTAHEDRAL:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  return 1;
}

/// Returns the largest number of images of a projection.
constexpr uint32_t most_faces() {
  uint32_t most = 1;
  for (uint32_t p = 0; p <= kLastProjection; ++p) {
    const uint32_t faces = face_count(static_cast<shd_projection>(p));
    most = faces > most ? faces : most;
  }
  return most;
}

/// Returns whether the directions fill a disc in the image. Texels outside the disc have no direction.
constexpr bool is_disc(shd_projection projection) {
  switch (projection) {
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: return true;
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_LAT_LONG:
    case SHD_PROJECTION_CUBE:
    case SHD_PROJECTION_OCTAHEDRAL:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  return false;
}

/// Solid angle of texel (x, y) of an image, or of a face, of width x height texels [sr]. The sum over all texels and
/// faces is 4 pi. Texels outside the disc of MIRROR_BALL and ANGULAR have 0, texels on its rim the part inside.
/// |error| <= 1e-12; ANGULAR: 1e-8 of 4 pi.
double texel_solid_angle(shd_projection projection, uint32_t width, uint32_t height, uint32_t x, uint32_t y);

/// Row y of an image, or of a face, of width x height texels.
struct TexelRow {
  uint32_t width, height, face, y;
};

/// Writes the direction and the solid angle [sr] of each texel of a row. A direction is that of the texel's centre; if
/// the centre lies outside the disc of MIRROR_BALL and ANGULAR, that of a point in the part inside. Texels without such
/// a part have the solid angle 0. Solid angles of images of 32 rows or more are within 1e-5 of the largest one.
void find_texels(shd_projection projection, const core::SimdTarget& simd, const TexelRow& row,
                 const PointDirections& out);

/// Upper bounds of the lengths of lines along u and along v through a texel, on the unit sphere [rad]. At most 1.7
/// times the longest line, except in images of less than 8 rows and near the rim of MIRROR_BALL.
struct TexelExtent {
  double along_u, along_v;
};
TexelExtent texel_extent(shd_projection projection, uint32_t width, uint32_t height, uint32_t x, uint32_t y);

}  // namespace shd::projection
