// SPDX-License-Identifier: MIT
#pragma once

#include "scene/objects.h"

namespace shd::scene {

/// Makes the lights of a pose. One whose numbers are out of range then is left out with a warning.
void add_lights(const Parts& parts, const Pose& pose, Objects* out);

/// Makes the cameras of a pose, as add_lights(). Chooses near and far planes that enclose the bounds, if the file has
/// no such planes.
void add_cameras(const Parts& parts, const Pose& pose, Objects* out);

}  // namespace shd::scene
