// SPDX-License-Identifier: MIT
/// @file
/// Texels beyond the edges of images of directions: where the directions continue.
///
///   CUBE          the adjacent face; the missing texel of a corner is the average of the other three
///   OCTAHEDRAL    an edge is folded in its middle (Cigolle et al., "A Survey of Efficient Representations for
///                 Independent Unit Vectors", 2014): the image continues, turned by half a circle about the middle
///   MIRROR_BALL,  a point at a distance r > 1 from the centre is the point at 2 - r on the other side: the nearest
///   ANGULAR       texel to it whose centre lies in the disc
#pragma once

#include "texture/oracle/bounds/plane.h"
#include "texture/oracle/bounds/range.h"

namespace shd::texture {

/// Returns the values of texel (i, j) of an image of directions. i and j are -1..size, or -size - 1..2 size if
/// folds_far(). The projection has bounds (bounds_refusal_of()).
Color folded_range(const Plane& plane, int64_t i, int64_t j);

/// Returns whether folded_range() takes texels as far as one image beyond an edge.
bool folds_far(shd_projection projection);

/// Returns why lookups of a projection have no bounds, as a sentence; null if they have.
const char* bounds_refusal_of(shd_projection projection);

}  // namespace shd::texture
