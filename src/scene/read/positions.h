// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "scene/model.h"

namespace shd::scene {

using Point = std::array<double, 3>;

/// The place around which the positions of a model keep their detail as floats: 0, or a place near their middle if this
/// middle is more than 16 times as far away as they extend. The place is a multiple of a power of two near the extent,
/// so that it has few digits. positions: [vertex][3], finite.
Point choose_origin(const std::vector<double>& positions);

/// Sets origin and position of a geometry. The geometries of one model share `base`, so that the common border of two
/// of them has the same floats in both. A geometry of which floats around `base` keep less than half of their digits
/// gets an origin of its own.
void set_positions(Geometry& geometry, const std::vector<double>& positions, const Point& base);

/// As above for the only geometry of a model.
void set_positions(Geometry& geometry, const std::vector<double>& positions);

}  // namespace shd::scene
