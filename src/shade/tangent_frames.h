// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/vertex.h"
#include "raster/fragments.h"
#include "shade/columns.h"

namespace shd::shade {

/// Writes dp/du and dp/dv of each point's triangle, in world space, to columns->tangent_frame. They are 0 where the
/// texture coordinates span no area, or beyond the range of float. Points must be sorted by triangle; points past count
/// up to the next whole vector are filled too.
/// @param orientation    -1 if the draw's matrix mirrors, otherwise 1
/// @param uv_set         0 or 1
/// @param sets_tangents  also sets the points' tangents: unit dp/du, with the side opposite to dp/dv as handedness
void make_tangent_frames(const geometry::Vertices& vertices, float orientation, uint32_t uv_set, bool sets_tangents,
                         raster::Fragments* points, Columns* columns);

/// Flips the normals of points whose triangle is seen from behind.
void face_normals(const geometry::Vertices& vertices, float orientation, raster::Fragments* points);

}  // namespace shd::shade
