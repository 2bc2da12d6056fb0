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

/// Elements of a column: the last vector of a triangle's rows may end past the batch.
constexpr size_t kColumn = kBatch + 16;

/// Columns of Fragments that are interpolated from vertices, as bits.
enum Interpolated : uint32_t {
  kPosition = 1,
  kNormal = 2,
  kToEye = 4,
  kTexture = 8,  // uv and its derivatives
  kBarycentrics = 16,
  kTexture1 = 32,  // second uv set and its derivatives
  kTangent = 64,
  kAttributes = 128,
  kInterpolateAll = 255,  // columns that programs read
  kPositionSteps = 256    // derivatives of the position
};

/// Places in memory of some columns of Fragments, in columns after x. allocate() puts them there.
enum ColumnPlace : size_t {
  kXPlace,
  kYPlace,
  kPositionPlace = 6,                 // px, py, pz
  kNormalPlace = kPositionPlace + 3,  // nx, ny, nz
  kToEyePlace = kNormalPlace + 3,     // ox, oy, oz
  kTexturePlace = kToEyePlace + 3     // u, v, dudx, dvdx, dudy, dvdy
};

/// Points to be shaded, one row each: fragments, or the corners or centroids of triangles. The columns have kBatch
/// elements that are read, in one block.
struct Fragments {
  size_t count = 0;           // rows in use
  int32_t left = 0, top = 0;  // first pixel of the tile in the picture
  core::Array<float> block;

  uint32_t* pixel;      // row-major position in the tile
  uint32_t* mask;       // samples of the pixel, as bits
  uint32_t* triangle;   // index in its mesh
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

/// Number of pixels.
constexpr size_t length_of(const PixelRun& run) {
  return size_t{run.end} - run.begin;
}

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
  core::Buffer<PixelRun> bare;    // pixels with samples without a triangle
  size_t covered_samples;         // samples with a triangle
};

/// Allocates for tiles with `samples` samples per pixel. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, uint32_t samples, TileOrder* out);

/// Counting sort of the runs of covered pixels of a tile by slot. Throws std::bad_alloc.
void sort_pixels(const core::SimdTarget& simd, const Tile& tile, size_t slot_count, TileOrder* out);

}  // namespace shd::raster
