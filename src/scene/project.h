// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <shd/uv_projection.h>

#include "scene/bounds.h"
#include "scene/model.h"

struct shd_context;

namespace shd::scene {

/// The matrix from world space to the cube from -1 to 1 that takes the centre of a box to 0 and its longest side to the
/// sides of the cube.
Matrix cube_of(const Bounds& box);

/// Gives uv to a geometry after the rules of shd/uv_projection.h. Vertices may be appended, with all columns. Smooth
/// normals that the geometry has not are computed before. Changes nothing if the matrix is not finite as floats. Throws
/// Failure.
/// @param position  [vertex][3] in the space of `to_projection`: the positions of the geometry, or those of a pose
void project_geometry(shd_context* context, shd_uv_projection projection, const Matrix& to_projection,
                      const std::vector<float>& position, Geometry* geometry);

}  // namespace shd::scene
