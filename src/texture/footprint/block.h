// SPDX-License-Identifier: MIT
/// @file
/// Blocks: what filters need of each lookup, found for a few hundred lookups before any of them is filtered. The
/// chains of dependent operations of one lookup then overlap with those of others, and each shape is compiled once for
/// all filters. Columns are filled up to a whole vector with copies of the last lookup.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/footprint/lod.h"
#include "texture/texture.h"

namespace shd::texture {

/// Lookups in a block: its columns stay in the first-level cache.
constexpr size_t kBlock = 256;

/// The block of lookups from `first` on.
inline Lookups block_of(const Lookups& in, size_t first) {
  return part_of(in, first, in.count - first < kBlock ? in.count - first : kBlock);
}

/// Most lanes of a vector of lookups.
constexpr size_t kMaxLanes = 16;

/// Where the lookups lie.
struct PointBlock {
  size_t count;                             // 1..kBlock
  alignas(64) float u[kBlock], v[kBlock];   // finite; reduced by ReduceCoordinate() of their wraps
  alignas(64) int32_t first_texel[kBlock];  // of the layer; written if there is more than one layer
};

struct LodBlock : PointBlock {
  alignas(64) float lod[kBlock];  // level of detail, biased and clamped
};

/// `probes` trilinear lookups at the point + (2 k + 1 - probes) (step_u, step_v), k = 0..probes - 1, whose weights are
/// equal or exp(-2 x^2), x = (2 k + 1 - probes) / reach.
struct ProbeBlock : LodBlock {
  alignas(64) float step_u[kBlock], step_v[kBlock];  // half the step from one probe to the next, in u and v
  alignas(64) float probes[kBlock], reach[kBlock];
};

/// An ellipse in texels of its level, as a stack of rows: with (x, y) from the middle, r^2 = y^2 / height2 +
/// (x - shear y)^2 / width2 is below 1 inside. This is the form of Cholesky, in which nothing cancels and which no
/// rounding makes indefinite.
struct EllipseBlock : PointBlock {
  alignas(64) float shear[kBlock], height2[kBlock], width2[kBlock];
  alignas(64) float level[kBlock];     // whole
  alignas(64) float bilinear[kBlock];  // share of bilinear on the same level, 0..1
};

/// What becomes of a level of detail after bias and clamps: nothing, or what the filter of the sampler's profile makes
/// of it (fractions of 8 bits, or a level whose nearest one is the profile's).
enum class LodRounding { kNone, kFilter };

}  // namespace shd::texture
