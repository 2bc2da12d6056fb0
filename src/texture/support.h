// SPDX-License-Identifier: MIT
/// @file
/// Support: one table of filters, domains, stores and uses. The checks of src/abi, their messages,
/// tests/unit/texture/test_support.cpp and docs/support.md read it. A cell works unless a row of the table refuses it,
/// so a new filter, domain or store works with everything, or adds a row with the reason.
#pragma once

#include <cstdint>

#include <shd/sampler.h>

#include "texture/texture.h"

namespace shd::texture {

/// The meaning of coordinates: a point of a plane, a place between slices, or a direction.
enum class Domain : uint32_t { kPlane, kSlices, kDirections };

/// The output of a call: values, derivatives of values, an explanation, bounds, values in fixed point
/// (SHD_PRECISION_FAST), or values of comparisons. A cell without fixed point is not refused: it has the values of
/// SHD_PRECISION_FULL.
enum class Use : uint32_t { kValues, kGradients, kExplanation, kBounds, kFast, kComparison };

constexpr uint32_t kDomains = static_cast<uint32_t>(Domain::kDirections) + 1;
constexpr uint32_t kStores = static_cast<uint32_t>(Store::kTilesOfBc) + 1;
constexpr uint32_t kUses = static_cast<uint32_t>(Use::kComparison) + 1;

struct SupportCell {
  shd_filter filter;
  Domain domain;
  Store store;
  Use use;
};

/// Returns why a cell does not work, as the end of a sentence, or null if it works.
const char* refusal_of(const SupportCell& cell);

Domain domain_of(const Texture& texture);

/// Names of the docs and of messages: "3D", "tiles of blocks", "derivatives".
const char* name_of(Domain domain);
const char* name_of(Store store);
const char* name_of(Use use);

}  // namespace shd::texture
