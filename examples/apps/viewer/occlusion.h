// SPDX-License-Identifier: MIT
#pragma once
#include "assets.h"

namespace viewer {

/// Replaces the mesh of each part by a copy with ambient occlusion at its vertices, and adds the slot that reads it.
void add_occlusion(shd_context* context, Assets& assets);

}  // namespace viewer
