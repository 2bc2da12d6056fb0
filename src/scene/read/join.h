// SPDX-License-Identifier: MIT
#pragma once

#include "scene/model.h"

namespace shd::scene {

/// Makes one vertex of those whose numbers are all equal, and removes vertices without triangles. No vertices are
/// moved: a tolerance in the units of the file would change small models. Without skins and morph targets.
void join_identical(Geometry& geometry);

}  // namespace shd::scene
