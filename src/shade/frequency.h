// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/vertex.h"
#include "raster/fragments.h"
#include "raster/varyings.h"

namespace shd::shade {

/// Writes the corners of a triangle to points `point`, point + 1 and point + 2, for Gouraud shading.
void set_corners(const geometry::Vertices& vertices, const float eye[3], uint32_t triangle, size_t point,
                 raster::Fragments* points);

/// Writes the centroid of a triangle with its face normal to point `point`, for flat shading.
/// @param orientation  -1 if the draw's matrix mirrors, otherwise 1
void set_centroid(const geometry::Vertices& vertices, const float eye[3], float orientation, uint32_t triangle,
                  size_t point, raster::Fragments* points);

/// Sets the varyings of points from set_corners(): a corner takes the values of its vertex, FLAT varyings the values of
/// the first vertex.
/// @param modes  [vertices.varying_count]
void set_corner_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                         const raster::Fragments& points, raster::Varyings* out);

/// Sets the varyings of points from set_centroid(): the mean of the three vertices; FLAT varyings take the values of
/// the first vertex.
void set_centroid_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                           const raster::Fragments& points, raster::Varyings* out);

}  // namespace shd::shade
