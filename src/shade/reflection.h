// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/vertex.h"
#include "raster/fragments.h"

namespace shd::shade {

/// Writes the variance of slopes that blurs a mirror reflection over the pixel of each fragment: w / (16 pi), with the
/// solid angle w of the reflected pixel. Normals and positions count as linear on the screen within a triangle. 0 for
/// triangles that reach behind the eye.
void find_reflected_variance(const geometry::Vertices& vertices, const float eye[3], const raster::Fragments& fragments,
                             float* variance);

}  // namespace shd::shade
