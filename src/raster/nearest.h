// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/assemble.h"
#include "geometry/pixel_box.h"
#include "raster/tile.h"

namespace shd::raster {

/// Bounds of the positions in a texel that a triangle must pass between to touch it: its inside, without the border.
constexpr geometry::SampleExtent kTouchExtent = {1, geometry::kSubpixels - 1, 1, geometry::kSubpixels - 1};

/// Coverage of a texel by triangles.
enum class TexelCover : uint8_t {
  kEmpty = 0,    // no triangle shares area with the texel
  kCentre = 1,   // a triangle covers the centre, by the fill rule of raster.h
  kTouched = 2,  // triangles share area with the texel, but none covers its centre
};

/// The triangle that shades each texel of a tile in conservative coverage (Hasselgren, Akenine-Moeller and Ohlsson,
/// "Conservative Rasterization", GPU Gems 2, 2005, 42), and the point of this triangle that is nearest to the centre of
/// the texel. A triangle that covers the centre comes first, then the nearest one, then the lowest slot.
struct NearestTriangles {
  uint32_t slot[kTilePixels];  // the triangle, or kNoSlot
  TexelCover cover[kTilePixels];
  bool is_shared[kTilePixels];   // several triangles cover the centre
  double distance[kTilePixels];  // squared distance from the centre to the point [1/256 pixel]
  float x[kTilePixels];          // the point, raster position [pixels]
  float y[kTilePixels];
};

/// Marks all texels as empty.
void clear(NearestTriangles* out);

/// Adds a triangle to a tile. Slots must rise from call to call.
/// @param left, top  position of the tile in the picture [pixels]
/// @param box        pixels of the picture inside the tile that may change
void add_triangle(const geometry::ScreenTriangle& triangle, uint32_t slot, int32_t left, int32_t top,
                  const geometry::PixelBox& box, NearestTriangles* out);

}  // namespace shd::raster
