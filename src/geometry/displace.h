// SPDX-License-Identifier: MIT
#pragma once

#include <shd/tessellate.h>

#include "core/context.h"
#include "geometry/mesh.h"
#include "texture/texture.h"

namespace shd::geometry {

/// Moves the vertices of a mesh along their normals by amplitude * (texel - offset). Vertices at one position move by
/// their mean. Then tilts or computes normals if the desc selects it; vertices that had one position and normal share
/// the new normal. Tangents are projected into the planes of the new normals. Sums run over vertices and faces in
/// order, in double. Throws std::bad_alloc.
void displace(const core::Context& context, const shd_tessellation_desc& desc, const texture::Texture& texture,
              const texture::Sampler& sampler, Mesh* mesh);

}  // namespace shd::geometry
