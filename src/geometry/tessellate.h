// SPDX-License-Identifier: MIT
#pragma once

#include <shd/tessellate.h>

#include "core/context.h"
#include "geometry/mesh.h"
#include "texture/texture.h"

namespace shd::geometry {

/// Subdivides and displaces a mesh by a checked desc. A null texture means no displacement. Throws Failure for more
/// than max_triangles, before anything is allocated; and std::bad_alloc.
void tessellate(const core::Context& context, const Mesh& mesh, const shd_tessellation_desc& desc,
                const texture::Texture* displacement, const texture::Sampler* sampler, Mesh* out);

}  // namespace shd::geometry
