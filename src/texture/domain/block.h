// SPDX-License-Identifier: MIT
/// @file
/// Contract of domain/: coordinates to shapes. project.cpp turns directions into points of faces; shapes, lods,
/// profile, probes and ellipses find the shapes of footprints. wrap-inl.h finds the texel beyond an edge of a plane;
/// fold-inl.h and the files of folds/ find the texel beyond an edge of an image of directions.
///
/// A block holds the shapes of a few hundred lookups, computed before any of these lookups is filtered. The dependent
/// operations of one lookup then overlap with those of other lookups, and all filters share one kernel for each shape.
/// Copies of the last lookup fill the last vector of a block.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/domain/lod.h"
#include "texture/stream.h"
#include "texture/texture.h"

namespace shd::texture {

/// Lookups in a block, few enough that its columns stay in the first-level cache.
constexpr size_t kBlock = 256;

/// Returns the block of lookups that begins at `first`.
inline Lookups block_of(const Lookups& in, size_t first) {
  return part_of(in, first, in.count - first < kBlock ? in.count - first : kBlock);
}

/// Zeros in place of the columns that the lookups of a block do not have.
alignas(64) inline constexpr float kNoColumn[kBlock + kMaxLanes] = {};

/// Coordinates and layers of lookups.
struct PointBlock {
  size_t count;                             // 1..kBlock
  alignas(64) float u[kBlock], v[kBlock];   // finite, after ReduceCoordinate() with the wrap of the axis
  alignas(64) int32_t first_texel[kBlock];  // first texel of the layer; written if the texture has several layers
};

struct LodBlock : PointBlock {
  alignas(64) float lod[kBlock];  // level of detail, biased and clamped
};

/// Lines of probes: trilinear lookup k = 0..probes - 1 lies at the point + (2 k + 1 - probes) (step_u, step_v). The
/// weights are equal or exp(-2 x^2), x = (2 k + 1 - probes) / reach.
struct ProbeBlock : LodBlock {
  alignas(64) float step_u[kBlock], step_v[kBlock];  // half the step from one probe to the next, in u and v
  alignas(64) float probes[kBlock], reach[kBlock];
};

/// Lookups in 3D textures: the same shapes with a third coordinate.
struct PlaceBlock : PointBlock {
  alignas(64) float w[kBlock];
};
struct PlaceLodBlock : LodBlock {
  alignas(64) float w[kBlock];
};
struct PlaceProbeBlock : ProbeBlock {
  alignas(64) float w[kBlock], step_w[kBlock];
};

/// Ellipses in texels of their level. A point (x, y) relative to the centre is inside if r^2 = y^2 / height2 +
/// (x - shear y)^2 / width2 is below 1. This is the Cholesky form: it has no cancellation, and rounding cannot make it
/// indefinite.
struct EllipseBlock : PointBlock {
  alignas(64) float shear[kBlock], height2[kBlock], width2[kBlock];
  alignas(64) float level[kBlock];     // a whole number
  alignas(64) float bilinear[kBlock];  // share of bilinear on the same level, 0..1
};

/// Rounding of a level of detail after bias and clamps. kFilter rounds as the sampler's profile does for its filter:
/// to fractions of 8 bits, or to a value whose nearest level is the level that the profile reads.
enum class LodRounding { kNone, kFilter };

}  // namespace shd::texture
