// SPDX-License-Identifier: MIT
#pragma once

#include <shd/tessellate.h>

#include "core/context.h"
#include "geometry/mesh.h"
#include "texture/texture.h"

namespace shd::geometry {

/// Cuts and moves a mesh by a checked desc. The texture may be null: then nothing moves. Throws Failure, before
/// anything is allocated, for more than max_triangles; and std::bad_alloc.
void tessellate(const core::Context& context, const Mesh& mesh, const shd_tessellation_desc& desc,
                const texture::Texture* displacement, const texture::Sampler* sampler, Mesh* out);

}  // namespace shd::geometry
