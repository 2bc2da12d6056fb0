// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/vertex.h"
#include "raster/fragments.h"
#include "raster/varyings.h"

namespace shd::shade {

/// Corners of one triangle as rows `row`, row + 1 and row + 2 of a table: what Gouraud shading evaluates.
void set_corners(const geometry::Vertices& vertices, const float eye[3], uint32_t triangle, size_t row,
                 raster::Fragments* rows);

/// Centroid of one triangle, with its face normal, as row `row`: what flat shading evaluates.
/// @param orientation  -1 where the draw's matrix mirrors, else 1
void set_centroid(const geometry::Vertices& vertices, const float eye[3], float orientation, uint32_t triangle,
                  size_t row, raster::Fragments* rows);

/// Varyings of rows that set_corners made: those of each vertex, of FLAT ones the triangle's first.
/// @param modes  [vertices.varying_count]
void set_corner_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                         const raster::Fragments& rows, raster::Varyings* out);

/// Varyings of rows that set_centroid made: the mean of the three vertices, of FLAT ones the first.
void set_centroid_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                           const raster::Fragments& rows, raster::Varyings* out);

}  // namespace shd::shade
