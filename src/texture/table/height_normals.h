// SPDX-License-Identifier: MIT
#pragma once

#include <shd/mip.h>

#include "core/context.h"

namespace shd::texture {

/// Writes the normals of heights, as shd_mip_build_normals does. The images have the same size and their row strides
/// set, and `out` has three or four channels. Throws std::bad_alloc.
void write_normals(const core::Context& context, const shd_image& heights, const shd_normals_desc& desc,
                   const shd_image& out);

}  // namespace shd::texture
