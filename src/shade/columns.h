// SPDX-License-Identifier: MIT
#pragma once

#include "core/allocator.h"
#include "raster/fragments.h"

namespace shd::shade {

/// What each row reflects of the lights, before the coefficients: columns of raster::kBatch.
struct Lobes {
  float* diffuse[3];   // sum of E max(0, n.l)
  float* specular[3];  // sum of E max(0, n.h)^p
};

/// Colour and the targets of SHD_AOV_TARGET1 to 3.
constexpr uint32_t kMaxTargets = 4;

/// Result of a batch: scene-linear, premultiplied; columns of raster::kBatch.
struct Radiance {
  float* channel[4 * kMaxTargets];  // r, g, b, a of colour, then of each target; null where there is none
};

/// Columns of one worker besides its Fragments.
struct Columns {
  core::Array<float> block;
  Lobes lobes;            // of the fragments
  Radiance radiance;      // of the fragments
  float* texture[4];      // diffuse texture at the fragments
  Lobes row_lobes;        // of corners or centroids
  Radiance row_radiance;  // of corners or centroids
  uint32_t* row;          // for each fragment, the first of its triangle's rows
  uint32_t* discard;      // of the fragments: not 0 where a program dropped them
  uint32_t* row_discard;  // of corners or centroids
};

/// @param targets  bit t: there is target t; bit 0 is set
/// Throws std::bad_alloc.
inline void allocate(const core::Allocator& allocator, uint32_t targets, Columns* out) {
  constexpr size_t kColumns = 6 + 4 + 6 + 1 + 2;
  const size_t radiance_columns = 2 * 4 * static_cast<size_t>(__builtin_popcount(targets));
  out->block = core::Array<float>(allocator, (kColumns + radiance_columns) * raster::kBatch);
  out->block.fill_zero();
  float* next = out->block.data();
  const auto take = [&] {
    float* column = next;
    next += raster::kBatch;
    return column;
  };
  for (Lobes* lobes : {&out->lobes, &out->row_lobes}) {
    for (float*& column : lobes->diffuse) column = take();
    for (float*& column : lobes->specular) column = take();
  }
  for (Radiance* radiance : {&out->radiance, &out->row_radiance}) {
    for (uint32_t c = 0; c < 4 * kMaxTargets; ++c) radiance->channel[c] = targets >> c / 4 & 1 ? take() : nullptr;
  }
  for (float*& column : out->texture) column = take();
  out->row = reinterpret_cast<uint32_t*>(take());
  out->discard = reinterpret_cast<uint32_t*>(take());
  out->row_discard = reinterpret_cast<uint32_t*>(take());
}

}  // namespace shd::shade
