// SPDX-License-Identifier: MIT
/// @file
/// Lookups of textures of directions. The direction of a lookup and its derivatives become a point of an image and the
/// derivatives of the point; footprints and filters then are those of 2D textures. Only their sink differs: it folds
/// quads over the seams of the projection, so that the image continues as the directions do.
///
/// Derivatives of the point are not limited: levels, axes and numbers of probes are those of the whole footprint. Only
/// the places of probes are limited: a line of LAT_LONG is at most one circle, and FoldPoint() cuts distances of more
/// than one image. The plane of a face of CUBE needs no limit, because it has all directions in front of it. The cost
/// of a lookup does not grow with its footprint, because max_anisotropy limits probes and ellipses.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/domain/block.h"
#include "texture/texture.h"

namespace shd::texture {

/// Parts of a round footprint near a pole of SHD_PROJECTION_LAT_LONG: lookups along its parallel, at most.
constexpr float kMaxParallel = 16.0f;

/// Largest number of lookups along parallels for all probes of an anisotropic lookup together.
constexpr float kMaxQuads = 32.0f;

/// Distance of neighbouring lookups along a parallel, at most [texels of the equator]. A bilinear lookup averages about
/// one texel; with a distance of 1 the error is the same, and lookups in random directions take 1.2 times as long.
constexpr float kParallelStep = 1.5f;

/// Points of directions. Real is float or double, and Index an unsigned integer of its size.
template <class Real, class Index, size_t kCount>
struct ProjectedPoints {
  alignas(64) Real u[kCount], v[kCount];
  /// du/dx, dv/dx, du/dy, dv/dy; du of LAT_LONG as on the equator. Infinite for directions with an infinite change.
  alignas(64) Real step[4][kCount];
  alignas(64) Index face[kCount];
  /// Width of a parallel of LAT_LONG in (u, v), relative to the equator's: 1 or more; otherwise 1.
  alignas(64) Real stretch[kCount];
};

/// Points of a block of directions.
struct ProjectedBlock : ProjectedPoints<float, uint32_t, kBlock> {
  Lookups points;  // at the columns above; layers are faces
  bool stretches;  // the projection has a stretch
};

/// The point of one direction.
struct DirectionPoint : ProjectedPoints<double, uint64_t, 1> {
  bool finite;  // all inputs are finite, and there is a direction
};

/// Derivatives of the points of a block of directions in the three components of the directions, du/dn and dv/dn. All
/// are finite. Lookups without a direction have derivatives of 0.
struct DirectionRates {
  alignas(64) float u[3][kBlock], v[3][kBlock];
};

/// Properties of the fold of a projection (fold-inl.h).
struct FoldTraits {
  bool is_disc;         // the directions fill a disc
  bool repeats_across;  // u has a period of 1
  bool turns_at_poles;  // beyond the first and the last row lies this row at u + 1/2
  bool lacks_corners;   // the texels beyond some corners do not exist
  bool is_periodic;     // texels far beyond edges have a period of two images
  bool has_planes;      // points outside lie on the plane of a face of the cube
};

}  // namespace shd::texture
