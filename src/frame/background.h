// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "film/tile_area.h"
#include "film/tile_planes.h"
#include "frame/frame.h"

namespace shd::frame {

/// The environment behind a frame, as seen at each pixel.
struct Background {
  const environment::Environment* map;  // null = the clear colour
  float intensity, roughness;
  double ray[3][3];  // direction of a raster position (x, y), in the space of the map: ray[0] + x ray[1] + y ray[2]
};

/// A frame's background, or none.
Background make_background(const Frame& frame);

/// Fills a part of a tile. `left` and `top` are the position of `area` in the picture.
void fill_background(const core::SimdTarget& simd, const Background& background, const film::TileArea& area,
                     const film::TileArea& part, int32_t left, int32_t top, const film::TilePlanes& planes);

}  // namespace shd::frame
