// SPDX-License-Identifier: MIT
#pragma once

#include "texture/stream.h"

namespace shd::texture {

/// Runs SHD_FILTER_EXACT: integrates over the footprint in doubles. Point lookups go to `run_bilinear`, the bilinear
/// filter of the same target. Returns the number of lookups that were not finite.
size_t run_exact(const FilterCall& call, RunFilter run_bilinear);

}  // namespace shd::texture
