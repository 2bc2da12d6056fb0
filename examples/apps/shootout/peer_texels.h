// SPDX-License-Identifier: MIT
#pragma once

#include "settings.h"
#include "workloads/workload.h"

namespace shootout {

/// An estimate of the number of texels that the anisotropic filter of llvmpipe and lavapipe reads for lookup i of a
/// texture of edge x edge texels. `most` is the largest ratio of the axes.
double mesa_texels(const Setting& setting, const Lookups& q, size_t i, double edge, double most);

}  // namespace shootout
