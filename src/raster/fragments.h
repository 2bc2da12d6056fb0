// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/mesh.h>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "raster/tile.h"

namespace shd::raster {

/// Rows of a batch. Whole vectors may run past count, and the columns of a batch stay in L2.
constexpr size_t kBatch = 512;
/// Elements between the columns of a batch. Rows of all columns would share a few sets of the cache if they were
/// kBatch apart.
constexpr size_t kColumnStride = kBatch + 16;

/// Points to be shaded, one row each: fragments, or the corners or centroids of triangles. The columns have
/// kColumnStride elements each, in one block.
struct Fragments {
  size_t count = 0;  // rows in use
  core::Array<float> block;

  uint32_t* pixel;      // row-major position in the tile
  uint32_t* mask;       // samples of the pixel, as bits
  uint32_t* triangle;   // index in its mesh
  uint32_t* vertex[3];  // rows of geometry::Vertices
  float *x, *y;         // raster position [pixels]
  float* depth;         // 0..1
  float* bary[3];       // perspective-correct barycentric coordinates, >= 0, sum 1
  float *px, *py, *pz;  // position, world space
  float* dpdx[3];       // change of the position per pixel to the right
  float* dpdy[3];       // per pixel down
  float *nx, *ny, *nz;  // shading normal, world space, unit
  float *ox, *oy, *oz;  // wo: towards the eye, world space, unit
  float *u, *v;         // texture coordinates
  float *dudx, *dvdx;   // per pixel to the right
  float *dudy, *dvdy;   // per pixel down
  float *u1, *v1;       // second uv set, and its derivatives
  float *du1dx, *dv1dx;
  float *du1dy, *dv1dy;
  float *tx, *ty, *tz, *tw;              // tangent of the mesh, world space, any length; handedness
  float* attribute[SHD_MAX_ATTRIBUTES];  // columns of the mesh
};

/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, Fragments* out);

/// Consecutive pixels of a tile, numbered row-major, in which one triangle is visible at the same samples.
struct PixelRun {
  uint16_t begin, end;
  uint32_t mask;  // samples, as bits
};

/// The fragments of a batch as runs of pixels of one triangle, in the order of their rows.
struct FragmentRuns {
  float left, top;   // centre of the tile's first pixel [pixels]
  bool sets_places;  // x, y and triangle of the rows follow from the runs, and are not set yet
  size_t count = 0;
  PixelRun run[kBatch];
  uint32_t triangle[kBatch];  // of a run: index in its mesh
};

/// Sets x, y and triangle of the rows of runs. Up to three rows behind them are overwritten.
void set_places(const FragmentRuns& runs, Fragments* out);

/// Returns the first pixel of the next row of the tile.
constexpr uint32_t next_row(uint32_t pixel) {
  return pixel - pixel % kTile + kTile;
}

/// A run of the triangle in a slot.
struct SlotRun {
  uint32_t slot;
  PixelRun run;
};

/// The visible pixels of a tile in the order of their triangles; a pixel with several triangles is in a run of each.
struct TileOrder {
  core::Array<uint64_t> changes;  // scratch
  core::Buffer<SlotRun> found;    // scratch: the runs by position
  core::Buffer<uint32_t> start;   // [slots + 1] first run of each slot
  core::Buffer<PixelRun> run;     // sorted by slot, then by position
  size_t covered_samples;         // samples with a triangle
};

/// Allocates for tiles with `samples` samples per pixel. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, uint32_t samples, TileOrder* out);

/// Counting sort of the runs of covered pixels of a tile by slot. Throws std::bad_alloc.
void sort_pixels(const core::SimdTarget& simd, const Tile& tile, size_t slot_count, TileOrder* out);

}  // namespace shd::raster
