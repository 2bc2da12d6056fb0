// SPDX-License-Identifier: MIT
#pragma once

#include "texture/oracle/bounds/plane.h"
#include "texture/oracle/bounds/range.h"

namespace shd::texture {

/// Most texels on an axis that a box is searched over, of 2D and of 3D textures. Wider boxes give the range of the
/// format.
constexpr int64_t kMaxCells = 64, kMaxDeepCells = 16;

/// A box of points of a level [texels]; (0, 0, 0) is the outer corner of texel (0, 0, 0). The third axis is that of 3D
/// textures.
struct PointBox {
  Range axis[3];
};

/// Adds the values of all linear lookups whose points lie in a box, with the error of the weights.
void add_linear(const Plane& plane, const PointBox& box, Color* out);

/// Adds the values of all texels that a box touches.
void add_nearest(const Plane& plane, const PointBox& box, Color* out);

/// Adds the values of all texels of a level, or the range of the format if it has too many to be searched.
void add_everywhere(const Plane& plane, Color* out);

}  // namespace shd::texture
