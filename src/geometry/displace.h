// SPDX-License-Identifier: MIT
#pragma once

#include <shd/tessellate.h>

#include "core/context.h"
#include "geometry/mesh.h"
#include "texture/texture.h"

namespace shd::geometry {

/// Moves the vertices of a mesh along their normals by amplitude * (texel - offset), those at one position by their
/// mean; then tilts or computes normals if the desc says so, over the vertices that had one position and normal, and
/// lays tangents into their planes. Sums run over vertices and faces in order, in double. Throws std::bad_alloc.
void displace(const core::Context& context, const shd_tessellation_desc& desc, const texture::Texture& texture,
              const texture::Sampler& sampler, Mesh* mesh);

}  // namespace shd::geometry
