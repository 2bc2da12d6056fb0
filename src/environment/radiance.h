// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "environment/map.h"
#include "environment/source.h"

namespace shd::environment {

/// Fills the levels of the radiance: means of bilinear lookups of the image, folded over its edges as lookups of
/// textures are. Texels of the image that are narrower than the distances of these lookups, at the poles of LAT_LONG
/// and at the rim of MIRROR_BALL and ANGULAR, are added to the texels of the map that they cover. The light of a texel
/// of the image is kept within 12 %. The bits do not depend on workers. Throws Failure and std::bad_alloc.
void build_radiance(const core::Context& context, const Source& source, const Chain& chain, float* texels);

}  // namespace shd::environment
