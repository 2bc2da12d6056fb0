// SPDX-License-Identifier: MIT
#pragma once

#include "texture/oracle/bounds/footprint.h"
#include "texture/oracle/bounds/place.h"
#include "texture/oracle/bounds/range.h"

namespace shd::texture {

/// Texture, sampler and precision of a call, and the reference of a lookup.
struct BoundsCall {
  const Texture& texture;
  const Sampler& sampler;
  const BoundsModel& model;
  Range reference;  // reference_range() of the lookup
};

/// Adds the legal values of the sampler's filter at a place.
void add_filtered(const BoundsCall& call, const Place& place, const BoundsFootprint& footprint, Color* out);

/// Adds the averages of all pairs of probes at c + t d and c - t d on a level, 0 <= t <= reach.
void add_probes(const BoundsCall& call, uint32_t level, const Place& place, const BoundsFootprint& footprint,
                Color* out);

}  // namespace shd::texture
