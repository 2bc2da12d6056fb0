// SPDX-License-Identifier: MIT
#pragma once

#include "shade/parameters.h"

namespace shd::shade {

/// Finds the places of points for a slot: its place_transform times their positions in its space. With a footprint also
/// the width of a pixel, the longer one of the derivatives of the place by pixel steps.
/// @param out  [4] columns: x, y, z, width
void find_places(const material::Slot& slot, const SlotContext& context, float* const out[4]);

}  // namespace shd::shade
