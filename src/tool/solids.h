// SPDX-License-Identifier: MIT
#pragma once

#include <shd/solid.h>

/// A built-in solid texture: colours, octaves and distortion that suit its kind.
/// @param size  side of a cell [world units]
shd_solid_desc make_solid(shd_solid kind, float size);
