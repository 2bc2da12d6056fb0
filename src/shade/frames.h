// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/vertex.h"
#include "raster/fragments.h"
#include "shade/columns.h"

namespace shd::shade {

/// dp/du and dp/dv of each row's triangle, in world space, to columns->frame, after the uv set of a slot (0 or 1); 0
/// where uv do not tell or leave the range of float. Rows are sorted by triangle; those past count up to the next whole
/// vector are filled too.
/// @param orientation    -1 where the draw's matrix mirrors, else 1
/// @param sets_tangents  also the rows' tangents: unit dp/du, and as handedness the side that dp/dv is not on
void make_frames(const geometry::Vertices& vertices, float orientation, uint32_t uv_set, bool sets_tangents,
                 raster::Fragments* rows, Columns* columns);

/// Turns the normals of rows around whose triangle is seen from behind.
void face_normals(const geometry::Vertices& vertices, float orientation, raster::Fragments* rows);

}  // namespace shd::shade
