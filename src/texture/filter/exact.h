// SPDX-License-Identifier: MIT
#pragma once

#include "texture/stream.h"

namespace shd::texture {

/// Runs SHD_FILTER_EXACT: integrates over the footprint in doubles. Point lookups go to `run_linear`, the filter
/// BILINEAR of the same target and domain. Returns the number of lookups that were not finite.
size_t run_exact(const FilterCall& call, RunFilter run_linear);

}  // namespace shd::texture
