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
/// A filter turns lookups into a stream of quads and texels; a format fetches, decodes and blends a stream. Neither
/// depends on the other, so code grows as filters plus formats.
///
/// sample.cpp -> filter -> footprint -> stream.h -> format -> store
///
/// | room        | what                                                                                         |
/// |-------------|----------------------------------------------------------------------------------------------|
/// | store/      | texels and tables in memory: levels, ripmaps, summed areas; how they are built and addressed   |
/// | footprint/  | what filters need of each lookup, block by block: levels of detail, probes, ellipses; profiles |
/// | filter/     | one file a filter, and what they share: levels and quads, the sink of a stream, prefetching    |
/// | format/     | one file a component type: fetch, decode; the consumers that blend values and derivatives      |
/// | explain/    | one lookup as its tree of blends, by a consumer that records                                   |
///
/// | file                                   | what                                                              |
/// |----------------------------------------|-------------------------------------------------------------------|
/// | sample.h, sample.cpp                   | error bounds; channels, magnification, which filter runs          |
/// | sampler.cpp                            | the sampler of a checked desc                                     |
/// | stream.h                               | elements of a stream, and what a consumer is                      |
/// | fused.cpp, fused-inl.h                 | hot pairs of a filter and a format, compiled together             |
/// | store/storage.h                        | layout of levels; the copy of the base                            |
/// | store/update.cpp                       | a rectangle of the base written anew, with what depends on it     |
/// | store/mip.cpp, mip_sums.h              | mip levels: exact area averages in linear light, rounded once     |
/// | store/ripmap.cpp, span.h               | ripmap levels: the same, halved along each axis on its own        |
/// | store/summed_area.h                    | sums over rectangles at the origin                                |
/// | store/mip_build.h, mip_weights.h       | mip levels in the caller's memory: kernels, normals, coverage     |
/// | store/normal_moments.h                 | slopes of normal maps and their squares                           |
/// | store/image_list.h, rows.h             | images of the caller's in an array; rows of a level on the executor |
/// | store/wrap.h, wrap-inl.h               | texel coordinates and wrapping, of one index and of vectors       |
/// | footprint/block.h                      | blocks: points, levels of detail, probes, ellipses                |
/// | footprint/points-inl.h                 | fills a block with points; inputs that are not finite             |
/// | footprint/shapes-inl.h                 | the functions that fill blocks: lods.cpp, probes.cpp, ellipses.cpp |
/// | footprint/lod.h, lod-inl.h, footprint-inl.h | level of detail and axes of a footprint; width and blur      |
/// | footprint/profile.h, profile-inl.h     | levels of detail and probes of other texture units                |
/// | footprint/exact_footprint.h, parallelogram.h | what SHD_FILTER_EXACT integrates over                       |
/// | footprint/ray_footprint.h              | derivatives from ray differentials and ray cones                  |
/// | filter/filters-inl.h                   | the list of filters: a row each                                   |
/// | filter/runner-inl.h                    | how a filter runs over a batch, and where it emits to             |
/// | filter/prefetch.h                      | lines of memory asked for ahead, for lookups that are scattered   |
/// | filter/bases-inl.h, level-inl.h        | what filters on level 0 or on mip levels share; quads of a level  |
/// | filter/nearest, bilinear, bicubic, mip, trilinear, ripmap, anisotropic, ewa | a filter each (.cpp, some -inl.h) |
/// | filter/cubic-inl.h, probe_line-inl.h, ellipse-inl.h, walk-inl.h | parts of those                          |
/// | filter/stochastic.cpp, pick-inl.h, pick_ellipse-inl.h, random-inl.h | one texel, picked by a filter's weights |
/// | filter/summed_area.cpp, box-inl.h      | boxes of a summed-area table                                      |
/// | filter/exact.cpp                       | the integral over the footprint, in doubles                       |
/// | filter/magnify.h                       | another filter where the footprint is no longer than a texel      |
/// | format/formats.h, formats-inl.h        | the list of formats: a row each                                   |
/// | format/consume-inl.h, gradient-inl.h   | the consumer of a stream: of values, of derivatives               |
/// | format/values.cpp, bordered.cpp, gradient.cpp | the same for every format                                  |
/// | format/unorm8, srgb8, unorm16, float16, float32 | a format each (-inl.h)                                   |
/// | format/codec.h                         | texels from and to doubles                                        |
/// | format/words-inl.h, gather-inl.h       | texels of one or two words; loads of neighbouring texels          |
/// | explain/explain.h, record.h, record-inl.h | one lookup as its tree of blends                               |
/// | kernel_part.h                          | inlining of the larger pieces                                     |
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

/// Texels of every level of every layer in one block, except a base level that is borrowed.
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

/// A copy of the sampler without width and blur.
inline Sampler unwidened(const Sampler& sampler) {
  Sampler plain = sampler;
  plain.width_x = plain.width_y = 1.0f;
  plain.blur_u = plain.blur_v = 0.0f;
  return plain;
}

/// The largest value of shd_filter that names a filter.
shd_filter last_filter();

/// Whether a filter has derivatives: those that are continuous trees of blends.
bool has_gradient(shd_filter filter);

/// The sampler of a checked desc.
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
/// borrowed and they have been written, and rebuilds what depends on them, except levels that the caller gave: the
/// bits are those of a texture built from the changed base. Throws std::bad_alloc before anything is written.
void update(const core::Context& context, uint32_t layer, uint32_t x, uint32_t y, const shd_image& texels,
            Texture* texture);

/// Filters on the calling thread; any count. The texture has the tables that the filter needs. Returns how many
/// lookups had a coordinate or derivative that is not finite.
size_t sample(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
              const Texels& out);

}  // namespace shd::texture
