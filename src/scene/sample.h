// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/model.h"

namespace shd::scene {

/// Number of values of a channel at one time; 0 if they do not fit the times.
size_t component_count(const Channel& channel);

/// The values of a channel at `seconds`, by its interpolation (glTF 2.0, appendix C). Before the first and after the
/// last key the values are those of the key. Rotations are unit quaternions, and the shorter way between two keys
/// counts. The channel has a component_count().
std::vector<double> sample(const Channel& channel, double seconds);

}  // namespace shd::scene
