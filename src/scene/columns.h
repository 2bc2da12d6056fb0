// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scene/model.h"

namespace shd::scene {

/// Replaces the vertices of a geometry by these of them, in this order; one may come several times. All columns and
/// morph targets follow; the indices stay as they are.
void take_vertices(Geometry& geometry, const std::vector<uint32_t>& vertices);

}  // namespace shd::scene
