// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: volume, (density + rays -> premultiplied colours).
///
/// Input:      a Volume: a 3D texture of density with its transfer function; rays in batches.
/// Output:     colour and opacity of each ray, premultiplied.
/// Units:      lengths in world units; positions in the texture are normalised, 0..1 in the box.
/// Invariants: a ray depends on its own inputs only. Steps that are skipped would add exactly 0, so that no bit depends
///             on the blocks.
///
/// A ray passes the box of the volume in equal steps (Rays). march() takes a few steps of each ray per round: it finds
/// the next steps whose blocks are visible, looks their densities up in one batch, turns densities into opacity and
/// colour (transfer.h), shades points if the volume has a material, and accumulates from front to back (Levoy,
/// "Efficient Ray Tracing of Volume Data", ACM Transactions on Graphics 9(3), 1990).
///
/// | file                     | contents                                                            |
/// |--------------------------|---------------------------------------------------------------------|
/// | volume.h, volume.cpp     | a volume and its construction                                       |
/// | blocks.h, blocks.cpp     | blocks of texels without extinction, and their distance to others   |
/// | transfer.h, transfer.cpp | kernel: densities to opacity and colour                             |
/// | rays.h, rays.cpp         | rays of pixels, cut by a box                                        |
/// | march.h, march.cpp       | rays in batches, from front to back                                 |
/// | gradient.h, gradient.cpp | normals of density at points, and their shading                     |
#pragma once

#include <cstdint>

#include <shd/volume.h>

#include "core/allocator.h"
#include "core/context.h"
#include "core/object.h"
#include "material/material.h"
#include "texture/texture.h"
#include "volume/transfer.h"

namespace shd::volume {

/// Texels of a block along each axis.
constexpr uint32_t kBlockEdge = 8;

/// A checked shd_volume_desc.
struct Volume {
  const texture::Texture* texture;
  const material::Material* material;  // null = colour is radiance
  texture::Sampler sampler;            // linear on level 0, clamped
  Transfer transfer;
  double box_min[3], box_max[3];  // object space
  float step;                     // [world units]
  float jitter;
  uint32_t seed;
  uint32_t blocks[3];             // blocks along each axis
  core::Array<uint8_t> distance;  // [blocks z][y][x] blocks to the nearest visible one, largest component; 0 = visible
  core::Object* texture_object = nullptr;   // retained, or null
  core::Object* material_object = nullptr;  // retained, or null

  Volume() = default;
  Volume(const Volume&) = delete;
  Volume& operator=(const Volume&) = delete;
  ~Volume();  // releases the objects
};

/// Builds a volume from a checked desc. The caller sets texture, material and the references of `out`. Throws
/// std::bad_alloc and Failure.
void build(const core::Context& context, const shd_volume_desc& desc, Volume* out);

}  // namespace shd::volume
