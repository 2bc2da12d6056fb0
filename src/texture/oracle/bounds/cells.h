// SPDX-License-Identifier: MIT
#pragma once

#include "texture/oracle/bounds/plane.h"
#include "texture/oracle/bounds/range.h"

namespace shd::texture {

/// Most texels on an axis that a rectangle is searched over. Wider rectangles give the range of the format.
constexpr int64_t kMaxCells = 64;

/// A rectangle of points of a level [texels]; (0, 0) is the outer corner of texel (0, 0).
struct Rect {
  Range x, y;
};

/// Adds the values of all bilinear lookups whose points lie in a rectangle, with the error of the weights.
void add_bilinear(const Plane& plane, const Rect& rect, Color* out);

/// Adds the values of all texels that a rectangle touches.
void add_nearest(const Plane& plane, const Rect& rect, Color* out);

/// Adds the values of all texels of a level, or the range of the format if it has more than kMaxCells on an axis.
void add_everywhere(const Plane& plane, Color* out);

}  // namespace shd::texture
