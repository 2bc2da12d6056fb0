// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"

namespace shd::volume {

struct Volume;

/// Finds the blocks whose densities have no extinction, and the distance of each block to the nearest block with
/// extinction. A block covers its texels and two more on each side, so that lookups near its faces read no others.
/// Throws std::bad_alloc and Failure.
void find_distances(const core::Context& context, Volume* volume);

}  // namespace shd::volume
