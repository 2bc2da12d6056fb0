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

/// Fills the texels of `to` with the mean of the radiance over a lobe of precision 2^exponent: 1 / alpha^2 of GGX,
/// p + 1 of Phong. Sums over cells that are small in comparison with the lobe or their distance from it (Barnes and
/// Hut, "A Hierarchical O(N log N) Force-calculation Algorithm", 1986), so that there is no noise. The bits do not
/// depend on workers or SIMD targets. Throws Failure and std::bad_alloc.
void convolve(const core::Context& context, LobeKind kind, uint32_t exponent, const CellTree& cells, const Level& to,
              float* texels);

}  // namespace shd::environment
