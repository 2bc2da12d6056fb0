// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/limits.h"
#include "scene/model.h"

namespace shd::scene {

/// Prepares the normals and tangents of a geometry for meshes of any pose:
/// - Normals of length 0 or not finite become 0, which fill_normals() replaces. A column of them alone is removed.
/// - With Shading::kFlat and normals to compute, triangles get vertices of their own; all columns follow.
/// - Tangents without normals, and tangents that are no unit vectors with a handedness, are removed: a mesh computes
///   its own.
/// Adds a warning for each change that the file does not ask for. Throws Failure (SHD_ERROR_LIMIT) if there are more
/// vertices than limits.vertices.
void prepare_normals(Geometry& geometry, const Limits& limits, std::vector<std::string>* warnings);

/// Replaces normals [vertex][3] of length 0 by the mean of the faces around the vertex, weighted by their area; the
/// right hand gives their side.
void fill_normals(const std::vector<float>& position, const std::vector<uint32_t>& indices, std::vector<float>* normal);

}  // namespace shd::scene
