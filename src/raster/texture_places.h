// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/simd_target.h"
#include "geometry/vertex.h"
#include "raster/fragments.h"

namespace shd::raster {

/// Runs of pixels of one triangle, which are the rows of a table in their order.
struct TrianglePixels {
  uint32_t row[3];      // the triangle's rows of geometry::Vertices
  float left, top;      // position of the tile in the picture [pixels]
  const PixelRun* run;  // [run_count]
  size_t run_count;
};

/// Rows of interpolate_texture(): the vector that ends past the last one still lies in the table.
constexpr size_t kMaxTextureRows = kBatch - kTile;

/// Terms of the barycentric coordinates that depend on the column of a tile alone (barycentric-inl.h).
struct TextureColumns {
  static constexpr size_t kColumns = kTile + 16;  // a vector may end past the tile

  bool known = false;                // false: the columns are not set
  alignas(64) float x[3][kColumns];  // corners, translated so that the pixel is the origin
  alignas(64) float e1_dy[kColumns], e2_dy[kColumns], sum_dy[kColumns];  // derivatives of weights and of their sum
};

/// Sets the columns of a triangle in a tile. They stay unknown if a result might not be finite at some pixel of the
/// tile, and if the corners have one w: then pixels need other operations.
void find_columns(const core::SimdTarget& simd, const geometry::Vertices& vertices, const TrianglePixels& pixels,
                  TextureColumns* out);

/// Fills texture coordinates and their derivatives at the pixels' centres, with the bits of interpolate(). At most
/// kMaxTextureRows rows; the rows of the last vector are overwritten. `columns` are those of the triangle in the tile,
/// or unknown. Returns whether each derivative has one value at all pixels, which is finite.
bool interpolate_texture(const core::SimdTarget& simd, const geometry::Vertices& vertices, const TrianglePixels& pixels,
                         const TextureColumns& columns, Fragments* out);

}  // namespace shd::raster
