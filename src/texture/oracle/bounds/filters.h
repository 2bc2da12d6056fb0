// SPDX-License-Identifier: MIT
#pragma once

#include "texture/oracle/bounds/footprint.h"
#include "texture/oracle/bounds/place.h"
#include "texture/oracle/bounds/range.h"

namespace shd::texture {

/// Adds the legal values of the sampler's filter at a place.
void add_filtered(const BoundsCall& call, const Place& place, const BoundsFootprint& footprint, Color* out);

/// Adds the averages of all pairs of probes at c + t d and c - t d on a level, 0 <= t <= reach.
void add_probes(const BoundsCall& call, uint32_t level, const Place& place, const BoundsFootprint& footprint,
                Color* out);

}  // namespace shd::texture
