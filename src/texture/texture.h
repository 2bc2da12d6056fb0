// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: texture, (planes + uv -> values).
///
/// Input:      texels of one image, a sampler, columns of coordinates with their derivatives.
/// Output:     columns of filtered linear values.
/// Units:      coordinates normalised, (0, 0) at the outer corner of texel (0, 0) of row 0, v downwards;
///             levels of detail in log2 base texels.
/// Invariants: a Texture only changes by update(), while nothing else uses it; finite texels give finite values for any
///             input bits; a lane depends on its own inputs only.
///
/// | file                    | what                                                                        |
/// |-------------------------|-----------------------------------------------------------------------------|
/// | storage.h               | layout of levels; the copy of the base                                      |
/// | update.cpp              | a rectangle of the base written anew, with what depends on it               |
/// | mip.cpp, codes.h        | mip levels: exact area averages in linear light, rounded once               |
/// | mip_sums.h              | their first steps as sums of integers                                       |
/// | rows.h                  | rows of a level on the executor                                             |
/// | ripmap.cpp, span.h      | ripmap levels: likewise, halved along each axis on its own                  |
/// | summed_area.h           | sums over rectangles at the origin                                          |
/// | mip_build.h             | mip levels in the caller's memory: kernels, normals, coverage of alpha      |
/// | normal_moments.h        | slopes of normal maps and their squares                                     |
/// | mip_weights.h           | weights of their kernels along one axis                                     |
/// | image_list.h            | images of the caller's in an array                                          |
/// | sample.h                | the filters and their error bounds                                          |
/// | sample_nearest.cpp      | kernels: nearest x format                                                   |
/// | sample_bilinear.cpp     | kernels: bilinear x format                                                  |
/// | sample_trilinear.cpp    | kernels: trilinear x format                                                 |
/// | sample_ripmap.cpp       | kernels: ripmap x format                                                    |
/// | sample_bicubic.cpp, cubic-inl.h | kernels: bicubic x format                                           |
/// | sample_mip.cpp          | kernels: nearest and bilinear on the nearest level x format                 |
/// | sample_stochastic.cpp, draw-inl.h, draw_ellipse-inl.h, random-inl.h | kernels: one texel at random x format |
/// | magnify.h               | another filter where the footprint is no longer than a texel                |
/// | lod.h, lod_block-inl.h, shape_block-inl.h, block.h | what a block of lookups needs before it is filtered |
/// | sample_lod.cpp          | levels of detail and axes of footprints                                     |
/// | sample_anisotropic.cpp  | kernels: anisotropic probes x format                                        |
/// | sample_ewa.cpp          | kernels: elliptical weighted average x format                               |
/// | ellipse-inl.h           | its ellipse and weights, for a block of lookups                             |
/// | walk-inl.h              | texels along an axis, one after the other                                   |
/// | sample_summed_area.cpp  | kernels: summed-area lookups x type of the table                            |
/// | box-inl.h               | their boxes and the cells of the table at the edges of a box                |
/// | profile.h, profile-inl.h | levels of detail and probes of other texture units                         |
/// | sample_exact.cpp        | the integral over the footprint, in doubles                                 |
/// | exact_footprint.h       | its level and its parallelogram                                             |
/// | parallelogram.h         | pieces of a parallelogram in the cells of a lattice, and their moments      |
/// | wrap.h                  | wrapping of one index                                                       |
/// | batch-inl.h             | the loop over a batch and its tail; inputs that are not finite              |
/// | lod-inl.h               | level of detail from the footprint                                          |
/// | footprint-inl.h         | axes of the footprint; width and blur                                       |
/// | probe-inl.h             | lookups at several points of the same mip levels                            |
/// | probe_line-inl.h        | where those of anisotropic filtering lie, for a block of lookups            |
/// | wrap-inl.h              | texel coordinates and wrapping                                              |
/// | filter-inl.h            | levels, the four texels around a point, blends                              |
/// | format-inl.h            | fetching and unpacking texels of each format                                |
/// | gather-inl.h            | loads of neighbouring texels                                                |
/// | scatter.h, prefetch-inl.h | lookups far apart in memory, whose lines are asked for ahead              |
/// | explain.h               | one lookup as its tree of blends                                            |
/// | kernel-inl.h            | how a filter becomes kernels: values, gradients, records                    |
/// | gradient-inl.h          | kernels that give derivatives                                               |
/// | record.h, record-inl.h  | kernels that write down what they do                                        |
/// | ray_footprint.h         | derivatives from ray differentials and ray cones                            |
/// | kernel_part.h           | inlining of the larger pieces                                               |
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/lookup.h>
#include <shd/sampler.h>
#include <shd/texture.h>

#include "core/allocator.h"
#include "core/context.h"
#include "image/format.h"

namespace shd::texture {

constexpr uint32_t kMaxLevels = 17;  // 65536 = 2^16 and the base

constexpr uint32_t kMaxLayers = 2048;

constexpr uint32_t kFill = 4;  // channel_source of an output that reads `fill`

/// Texels of every level of every layer in one block, but for a base level that is borrowed.
struct Texture {
  shd_format format;                     // as stored: of one, two or four channels
  shd_format given_format;               // of the texels that it was made from
  image::Component component;            // of that format
  uint32_t channels;                     // of that format
  uint32_t channel_source[4];            // stored channel of an output, or kFill
  float fill[4];                         // by output
  uint32_t tables;                       // shd_table bits
  uint32_t width, height;                // of level 0
  uint32_t layers;                       // 1..2048
  uint32_t layer_texels;                 // of all levels of one layer
  uint32_t level_count;                  // 1..kMaxLevels
  uint32_t offset[kMaxLevels];           // first texel of a level; its size is max(1, width >> l) x max(1, height >> l)
  uint32_t ripmap_columns, ripmap_rows;  // ripmap levels along each axis, or 0; the size of level (i, j) is
                                         // max(1, width >> i) x max(1, height >> j)
  uint32_t ripmap_offset[kMaxLevels * kMaxLevels];  // first texel of level (i, j) at [j * kMaxLevels + i]
  bool levels_given;                                // mip levels are the caller's
  core::Array<uint8_t> texels;   // rows packed, levels and then layers in order, padded at the end for whole gathers;
                                 // without the base where that is borrowed
  const uint8_t* borrowed;       // the caller's base level, or null
  const uint8_t* origin;         // where texel 0 lies, or would lie if the base were not borrowed
  uint32_t borrowed_texels;      // how many: texel indices below are there
  core::Array<double> mip_sums;  // [layers] unrounded averages, from the first update on
  uint32_t mip_sums_ready[kMaxLayers / 32];  // which layers have them
  core::Array<uint8_t> sums;                 // summed-area tables (summed_area.h), uint32_t or double, layers in order
  core::Array<uint32_t> nonfinite_sums;      // of texels that are not finite; empty where there are none
  core::Array<double> sum_origins;  // by layer and stored channel, linear: what sums of doubles are counted from
};

/// A checked sampler desc; lod_min <= lod_max.
struct Sampler {
  shd_filter filter;
  shd_magnification magnification;
  shd_wrap wrap_u, wrap_v;
  float border[4];
  float lod_bias, lod_min, lod_max;
  float width_x, width_y, blur_u, blur_v;
  float max_anisotropy;
  shd_probe_weights probe_weights;
  shd_cubic cubic;
  shd_box box;
  shd_filter stochastic_filter;
  uint32_t seed;
  float tolerance;
  shd_profile profile;
  bool rounded_weights;  // those of bilinear lookups, to 8 bits
};

/// The same without width and blur.
inline Sampler unwidened(const Sampler& sampler) {
  Sampler plain = sampler;
  plain.width_x = plain.width_y = 1.0f;
  plain.blur_u = plain.blur_v = 0.0f;
  return plain;
}

/// Whether a filter has derivatives: those that are continuous trees of blends.
bool has_gradient(shd_filter filter);

/// Of a checked desc.
Sampler make_sampler(const shd_sampler_desc& desc);

constexpr size_t kFloatColumns = 7, kIntegerColumns = 2;

/// Packed columns of `count` elements; absent optional ones are null.
struct Lookups {
  size_t count;
  const float *u, *v;
  const float *dudx, *dvdx, *dudy, *dvdy;  // null = 0
  const float* lod;                        // replaces the derivatives
  const uint32_t* layer;                   // null = 0
  const uint32_t* random;                  // null = from the bits of u and v

  /// The columns by number, for what treats all of them alike.
  const float*& real(size_t i) {
    constexpr const float* Lookups::*kColumns[kFloatColumns] = {
        &Lookups::u, &Lookups::v, &Lookups::dudx, &Lookups::dvdx, &Lookups::dudy, &Lookups::dvdy, &Lookups::lod};
    return this->*kColumns[i];
  }
  const float* real(size_t i) const { return const_cast<Lookups*>(this)->real(i); }
  const uint32_t*& integer(size_t i) { return i == 0 ? layer : random; }
  const uint32_t* integer(size_t i) const { return i == 0 ? layer : random; }
};

constexpr size_t kOutputColumns = 12;

/// Packed columns of `count` elements; unwanted ones are null. Nothing is written past `count`.
struct Texels {
  float* channel[4];
  float *du[4], *dv[4];  // derivatives of the channels; only of filters that have_gradient()

  float*& column(size_t i) { return i < 4 ? channel[i] : i < 8 ? du[i - 4] : dv[i - 8]; }
  float* column(size_t i) const { return const_cast<Texels*>(this)->column(i); }
  bool wants_values() const { return channel[0] || channel[1] || channel[2] || channel[3]; }
  bool wants_gradient() const {
    for (size_t c = 0; c < 4; ++c) {
      if (du[c] || dv[c]) return true;
    }
    return false;
  }
};

/// Elements first..first + count - 1.
inline Lookups part_of(const Lookups& in, size_t first, size_t count) {
  Lookups part = in;
  part.count = count;
  for (size_t c = 0; c < kFloatColumns; ++c) part.real(c) = in.real(c) ? in.real(c) + first : nullptr;
  for (size_t c = 0; c < kIntegerColumns; ++c) part.integer(c) = in.integer(c) ? in.integer(c) + first : nullptr;
  return part;
}
inline Texels part_of(const Texels& out, size_t first) {
  Texels part;
  for (size_t c = 0; c < kOutputColumns; ++c) part.column(c) = out.column(c) ? out.column(c) + first : nullptr;
  return part;
}

/// Copies or borrows the texels of a checked desc and builds its tables on the context's executor.
/// Throws std::bad_alloc; then nothing was kept.
void build(const core::Context& context, const shd_texture_desc& desc, Texture* out);

/// Writes texels, of the format that the texture has or was made from, at (x, y) of the base of a layer, unless that is
/// borrowed and they have been written, and rebuilds what depends on them, but for levels that the caller gave: the
/// bits are those of a texture built from the changed base. Throws std::bad_alloc before anything is written.
void update(const core::Context& context, uint32_t layer, uint32_t x, uint32_t y, const shd_image& texels,
            Texture* texture);

/// Filters on the calling thread; any count. The texture has the tables that the filter needs. Returns how many
/// lookups had a coordinate or derivative that is not finite.
size_t sample(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
              const Texels& out);

}  // namespace shd::texture
