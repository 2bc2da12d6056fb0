// SPDX-License-Identifier: MIT
#pragma once

#include "texture/stream.h"

namespace shd::texture {

/// SHD_FILTER_EXACT: the integral over the footprint, in doubles; `run_bilinear` of the same target for points. Returns
/// how many lookups were not finite.
size_t run_exact(const FilterCall& call, RunFilter run_bilinear);

}  // namespace shd::texture
