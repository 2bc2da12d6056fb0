// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: texture, (planes + uv -> values).
///
/// Input:      texels of one image, a sampler, columns of coordinates with their derivatives.
/// Output:     columns of filtered linear values.
/// Units:      coordinates normalised, (0, 0) at the outer corner of texel (0, 0) of row 0, v downwards;
///             levels of detail in log2 base texels.
/// Invariants: a Texture never changes once built; finite texels give finite values for any input bits; a lane
///             depends on its own inputs only.
///
/// | file                    | what                                                                        |
/// |-------------------------|-----------------------------------------------------------------------------|
/// | storage.h               | layout of levels; the copy of the base                                      |
/// | mip.cpp, codes.h        | mip levels: exact area averages in linear light, rounded once               |
/// | sample.h                | the filters and their error bounds                                          |
/// | sample_nearest.cpp      | kernels: nearest x format                                                   |
/// | sample_bilinear.cpp     | kernels: bilinear x format                                                  |
/// | sample_trilinear.cpp    | kernels: trilinear x format                                                 |
/// | batch-inl.h             | the loop over a batch and its tail; inputs that are not finite              |
/// | lod-inl.h               | level of detail from the footprint                                          |
/// | wrap-inl.h              | texel coordinates and wrapping                                              |
/// | filter-inl.h            | levels, the four texels around a point, blends                              |
/// | format-inl.h            | fetching and unpacking texels of each format                                |
/// | gather-inl.h            | loads of neighbouring texels                                                |
/// | kernel_part.h           | inlining of the larger pieces                                               |
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/sampler.h>
#include <shd/texture.h>

#include "core/allocator.h"
#include "core/context.h"

namespace shd::texture {

constexpr uint32_t kMaxLevels = 17;  // 65536 = 2^16 and the base

/// Texels of every level in one block.
struct Texture {
  shd_format format;
  uint32_t width, height;       // of level 0
  uint32_t level_count;         // 1..kMaxLevels
  uint32_t offset[kMaxLevels];  // first texel of a level; its size is max(1, width >> l) x max(1, height >> l)
  core::Array<uint8_t> texels;  // rows packed, levels one after the other, padded at the end for whole gathers
};

/// A checked sampler desc in the form that kernels want.
struct Sampler {
  shd_filter filter;
  shd_wrap wrap_u, wrap_v;
  float border[4];
  float lod_bias, lod_min, lod_max;  // lod_min <= lod_max
};

/// Packed columns of `count` elements; absent optional ones are null.
struct Lookups {
  size_t count;
  const float *u, *v;
  const float *dudx, *dvdx, *dudy, *dvdy;  // null = 0
  const float* lod;                        // replaces the derivatives
};

/// Packed columns of `count` elements; unwanted ones are null. Nothing is written past `count`.
struct Texels {
  float* channel[4];
};

/// Copies the texels of a checked desc and builds its tables on the context's executor.
/// Throws std::bad_alloc; then nothing was kept.
void build(const core::Context& context, const shd_texture_desc& desc, Texture* out);

/// Filters on the calling thread; any count. Returns how many lookups had a coordinate or derivative that is
/// not finite.
size_t sample(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
              const Texels& out);

}  // namespace shd::texture
