// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/context.h"
#include "environment/cells.h"
#include "environment/map.h"

namespace shd::environment {

/// A lobe of directions l around the direction r of mirror reflection.
enum class LobeKind : uint32_t {
  kGgx,    // D(h) n.l of GGX for n = v = r (Karis, "Real Shading in Unreal Engine 4", 2013)
  kPhong,  // max(0, r.l)^p
};

/// The part of a cell that a lobe sums.
struct CellLight {
  float x, y, z;  // unit direction
  float flux[3];  // sum of radiance times solid angle
  float solid_angle;
};

/// Means of the radiance over lobes. Sums over cells that are small in comparison with the lobe or their distance from
/// it (Barnes and Hut, "A Hierarchical O(N log N) Force-calculation Algorithm", 1986), so that there is no noise. The
/// bits do not depend on workers or SIMD targets.
class Convolver {
 public:
  /// Throws std::bad_alloc.
  Convolver(const core::Context& context, const CellTree& cells);

  /// Fills the texels of `to` with the means over a lobe of precision 2^exponent: 1 / alpha^2 of GGX, p + 1 of Phong.
  /// Throws Failure and std::bad_alloc.
  void fill(LobeKind kind, uint32_t exponent, const Level& to, float* texels);

 private:
  const core::Context& context_;
  const CellTree& cells_;
  core::Objects<core::Buffer<CellLight>> lists_;  // [worker] cells whose light reaches a tile
};

}  // namespace shd::environment
