// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: texture, (planes + uv -> values).
///
/// Input:      texels of one image; a sampler; columns of coordinates with their derivatives or levels of detail.
/// Output:     columns of filtered linear values, or of their derivatives in u and v.
/// Units:      coordinates are normalised: (0, 0) is the outer corner of the first texel of row 0, v points down.
///             Levels of detail are log2 of a length in texels of the base level.
/// Invariants: only update() changes a Texture, and nothing else may use the texture meanwhile. Finite texels give
///             finite values for any bits of the input. A result depends on the inputs of its own lane only.
///
/// A lookup is filtered in three steps. A footprint kernel finds the shape of each lookup: level of detail, probes or
/// ellipse. The filter turns shapes into a stream of quads and texels. The consumer of the texture's format fetches,
/// decodes and blends the stream. Filters and formats do not depend on each other, so N filters and M formats take
/// N + M kernels.
///
/// sample.cpp -> filter -> footprint -> stream.h -> format -> store
///
/// | folder     | contents                                                                                     |
/// |------------|----------------------------------------------------------------------------------------------|
/// | block/     | compressed blocks: decoders, caches of decoded blocks, places of texels in a cache (decode.h) |
/// | tile/      | tiles of textures larger than memory: cache, leases, places of texels (tile.h)               |
/// | store/     | texels and tables in memory: mip levels, ripmaps, summed areas; their builders, their layout |
/// | footprint/ | shapes of lookups, block by block: levels of detail, probes, ellipses; profiles              |
/// | filter/    | filters, one in each file; their shared parts: levels, quads, stream sinks, prefetching      |
/// | format/    | component types, one in each file: fetch and decode; consumers of values and derivatives     |
/// | direction/ | lookups of textures of directions; conversions between projections                            |
/// | explain/   | one lookup as its tree of blends, from a consumer that records                               |
/// | bounds/    | intervals of the values that conforming implementations may return, in doubles              |
///
/// | file                                         | contents                                                   |
/// |----------------------------------------------|------------------------------------------------------------|
/// | sample.h, sample.cpp                         | error bounds; swizzle, magnification, choice of kernels    |
/// | sampler.cpp                                  | the sampler of a checked desc                              |
/// | stream.h                                     | the elements of a stream; the interface of consumers       |
/// | fused.cpp, fused-inl.h                       | hot pairs of a filter and a format, compiled together      |
/// | fixed.cpp, fixed-inl.h                       | filters in fixed point (SHD_PRECISION_FAST)                |
/// | kernel_part.h                                | macros that control inlining                               |
/// | store/storage.h                              | layout of levels; copy of the base level                   |
/// | store/update.cpp                             | a rectangle of the base rewritten, and its tables rebuilt  |
/// | store/mip.cpp, mip_slices.cpp, mip_sums.h, halve.h | mip levels: exact averages, in 2D and 3D              |
/// | store/ripmap.cpp, span.h                     | ripmap levels: averages with a level for each axis         |
/// | store/summed_area.h                          | sums over rectangles at the origin                         |
/// | store/mip_build.h, mip_weights.h             | mip levels in the caller's memory; normals, alpha coverage |
/// | store/normal_moments.h                       | slopes of normal maps, and the squares of the slopes       |
/// | store/image_list.h                           | the caller's array of images                               |
/// | store/rows.h                                 | loop over rows on the executor                             |
/// | store/wrap.h, wrap-inl.h                     | texel coordinates and wrapping: one index, vectors         |
/// | footprint/block.h                            | blocks: points, levels of detail, probes, ellipses         |
/// | footprint/shapes-inl.h, places-inl.h         | kernels that fill blocks, in 2D and 3D                     |
/// | footprint/ellipses.cpp                       | the kernel that fills ellipses                             |
/// | footprint/lods.cpp, probes.cpp               | the same kernels, called outside of filters                |
/// | footprint/lod.h, lod-inl.h                   | level of detail                                            |
/// | footprint/footprint-inl.h                    | axes of the footprint; width and blur                      |
/// | footprint/profile.h, profile-inl.h           | levels of detail and probes of other texture units         |
/// | footprint/exact_footprint.h, parallelogram.h | the domain of the integral of SHD_FILTER_EXACT             |
/// | footprint/ray_footprint.h                    | derivatives from ray differentials and ray cones           |
/// | filter/filters-inl.h                         | table of filters                                           |
/// | filter/runner-inl.h                          | loop of a filter over a batch; sinks of its elements       |
/// | filter/emitter-inl.h                         | elements of streams, as filters emit them to sinks         |
/// | filter/gathered.h                            | packed copies of some lookups of a block                   |
/// | filter/prefetch.h                            | prefetches for scattered lookups                           |
/// | filter/bases-inl.h                           | bases of filters on level 0 and on mip levels              |
/// | filter/level-inl.h                           | levels of a texture; addresses of texels                   |
/// | filter/nearest, bilinear, bicubic, mip       | one filter each (.cpp, most with -inl.h)                   |
/// | filter/trilinear, ripmap, anisotropic, ewa; slices, slices_anisotropic: filters of 3D textures            |
/// | filter/cubic-inl.h                           | weights of bicubic                                         |
/// | filter/ellipse-inl.h, walk-inl.h             | ellipses of EWA; walks over wrapped texels                 |
/// | filter/stochastic.cpp, random-inl.h          | random texels or quads; random numbers                     |
/// | filter/pick-inl.h, pick_ellipse-inl.h        | random choice of a texel, or of a level, by its weight     |
/// | filter/summed_area.cpp, box-inl.h            | boxes of a summed-area table                               |
/// | filter/exact.cpp                             | the integral over the footprint, in doubles                |
/// | filter/fixed_sink-inl.h                      | the sink of filters in fixed point                         |
/// | filter/magnify.h                             | another filter where a texel is magnified                  |
/// | format/formats.h, formats-inl.h              | table of formats; their consumers                          |
/// | format/consume-inl.h, gradient-inl.h         | the consumer of a stream; blends of values, of derivatives |
/// | format/values.cpp, bordered.cpp              | consumers of values, without and with border colour        |
/// | format/gradient.cpp, deep_gradient.cpp       | consumers of derivatives in u and v, and in w              |
/// | format/unorm8, srgb8, unorm16, float16, float32 | one format each (-inl.h)                                |
/// | format/fixed.h, fixed.cpp, fixed_sums-inl.h  | sums of quads of 8-bit texels in fixed point               |
/// | format/codec.h                               | texels from and to doubles                                 |
/// | format/words-inl.h, gather-inl.h             | texels of one or two words; loads of neighbouring texels   |
/// | direction/direction.h, project.cpp           | points and derivatives of blocks of directions             |
/// | direction/project-inl.h, filters-inl.h       | kernels of directions, declared                            |
/// | direction/fold-inl.h, sink-inl.h             | texels beyond edges; the sink that folds quads             |
/// | direction/filters.cpp, ewa.cpp               | the filters of directions                                  |
/// | direction/convert, layout, floats (.cpp)     | conversions of images; faces in images; images as floats   |
/// | explain/explain.h, record.h, record-inl.h    | one lookup as its tree of blends                           |
/// | bounds/bounds.h, filters.h, probes.cpp       | bounds of lookups; their filters; lines of probes          |
/// | bounds/model.h, range.h                      | precision of implementations; intervals                    |
/// | bounds/footprint.h                           | legal levels of detail, axes and numbers of probes         |
/// | bounds/place.h, cube.h                       | points on levels and on faces of a cube                    |
/// | bounds/cells.h, plane.h                      | extremes over rectangles of texels; texels of a level      |
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/lookup.h>
#include <shd/sampler.h>
#include <shd/texture.h>

#include "core/allocator.h"
#include "core/context.h"
#include "image/format.h"
#include "texture/block/decode.h"
#include "texture/tile/tile.h"

namespace shd::texture {

constexpr uint32_t kMaxLevels = 21;  // the base of 2^20 texels of a texture in tiles, and 20 halvings

constexpr uint32_t kMaxLayers = 2048;

constexpr uint32_t kFill = 4;  // channel_source of an output that takes its constant of `fill`

/// Blocks of a compressed texture in memory. Indices of texels are those of a texture without blocks.
struct BlockLayout {
  DecodeBlock decode;           // null: the texture has texels, and nothing else here is set
  uint32_t size;                // bytes of a block
  uint32_t offset[kMaxLevels];  // first block of level l, whose rows have ceil(width / 4) blocks
  uint32_t layer_blocks;        // blocks of all levels of one layer
  uint32_t borrowed;            // blocks of the borrowed base; 0 if not borrowed
  uint64_t owner;               // number of the texture among the owners of `caches`
  core::CachePool* caches;      // caches of the context; may be null
};

/// Texels of every level of every layer in one block. A borrowed base level stays in the caller's memory.
struct Texture {
  shd_format format;            // stored format: one, two or four channels, or blocks
  shd_format given_format;      // format of the texels that the texture was made from
  image::Component component;   // component type of `format`, or of its decoded blocks
  uint32_t channels;            // channels of `format`, or of its decoded blocks
  uint32_t channel_source[4];   // stored channel of each output, or kFill
  float fill[4];                // constant of each output whose source is kFill
  bool premultiplied;           // outputs r, g and b are multiplied by a
  uint32_t tables;              // shd_table bits
  uint32_t width, height;       // size of level 0 [texels]
  uint32_t layers;              // 1..kMaxLayers
  uint32_t depth;               // slices of level 0 of a 3D texture; 0 = 2D
  shd_projection projection;    // directions that coordinates are
  uint32_t layer_texels;        // texels of all levels of one layer; tiles, if the texture is in tiles
  uint32_t level_count;         // 1..kMaxLevels
  uint32_t offset[kMaxLevels];  // first texel of level l, whose size is max(1, width >> l) x max(1, height >> l); or
                                // the first tile
  uint32_t ripmap_columns, ripmap_rows;             // ripmap levels along each axis, or 0; the size of level (i, j) is
                                                    // max(1, width >> i) x max(1, height >> j)
  uint32_t ripmap_offset[kMaxLevels * kMaxLevels];  // first texel of level (i, j) at [j * kMaxLevels + i]
  bool levels_given;                                // the caller gave the mip levels
  core::Array<uint8_t> texels;  // [layers][levels][rows], rows packed; padded at the end for whole gathers; has no base
                                // level if the base is borrowed
  const uint8_t* borrowed;      // the caller's base level, or null
  const uint8_t* origin;        // address of texel 0 or block 0, computed as if the base were not borrowed
  uint32_t borrowed_texels;  // size of the borrowed base: texels 0..borrowed_texels - 1; 0 if not borrowed, or blocks
  BlockLayout blocks;        // layout, if `texels` are compressed blocks
  TileSetOwner tiles;        // tiles of a texture in tiles, which has neither texels nor a borrowed base
  core::Array<double> mip_sums;              // [layers] unrounded averages; empty before the first update
  uint32_t mip_sums_ready[kMaxLayers / 32];  // bit of each layer whose averages are valid
  core::Array<uint8_t> sums;                 // [layers] summed-area tables (summed_area.h) of uint32_t or double
  core::Array<uint32_t> nonfinite_sums;      // counts of texels that are not finite; empty if the texture has none
  core::Array<double> sum_origins;           // [layers][channels] linear value subtracted from texels before summation
};

/// Returns whether the memory of a texture holds compressed blocks.
inline bool has_blocks(const Texture& texture) {
  return texture.blocks.decode != nullptr;
}

/// Returns whether the texels of a texture come from a cache of tiles.
inline bool has_tiles(const Texture& texture) {
  return static_cast<bool>(texture.tiles);
}

/// Returns whether lookups of a texture read w.
inline bool needs_w(const Texture& texture) {
  return texture.depth != 0 || texture.projection != SHD_PROJECTION_NONE;
}

/// A checked sampler desc; lod_min <= lod_max.
struct Sampler {
  shd_filter filter;
  shd_magnification magnification;
  shd_wrap wrap_u, wrap_v, wrap_w;
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
  bool rounded_weights;  // weights of bilinear lookups are rounded to 8 bits
  shd_precision precision;
  float probe_slack;
  float level_steepness;  // 1 / level_blend, or 0 for the nearer level alone
  shd_stochastic stochastic;
  shd_missing_tiles missing_tiles;
};

/// Copies a sampler and removes width and blur from the copy.
inline Sampler unwidened(const Sampler& sampler) {
  Sampler plain = sampler;
  plain.width_x = plain.width_y = 1.0f;
  plain.blur_u = plain.blur_v = 0.0f;
  return plain;
}

/// Returns the largest value of shd_filter that is a filter.
shd_filter last_filter();

/// Returns whether a filter has derivatives. A filter has them if it is a continuous tree of blends.
bool has_gradient(shd_filter filter);

/// Makes the sampler of a checked desc.
Sampler make_sampler(const shd_sampler_desc& desc);

constexpr size_t kFloatColumns = 10, kIntegerColumns = 2;
constexpr size_t kPlaneColumns = 7;  // float columns before w: those that textures without needs_w() read

/// Packed columns of `count` elements. Optional columns that are absent are null.
struct Lookups {
  size_t count;
  const float *u, *v;
  const float *dudx, *dvdx, *dudy, *dvdy;  // null = 0
  const float* lod;                        // level of detail, in place of the derivatives; null = from the derivatives
  const uint32_t* layer;                   // null = 0
  const uint32_t* random;                  // random bits; null = a hash of the bits of u and v
  const float *w = nullptr, *dwdx = nullptr, *dwdy = nullptr;  // read by textures with needs_w(); null = 0
  bool one_footprint = false;  // each column of derivatives holds one finite value; false = not known

  /// Returns a column by its number, for code that treats all columns equally.
  const float*& real(size_t i) {
    constexpr const float* Lookups::*kColumns[kFloatColumns] = {
        &Lookups::u,    &Lookups::v,   &Lookups::dudx, &Lookups::dvdx, &Lookups::dudy,
        &Lookups::dvdy, &Lookups::lod, &Lookups::w,    &Lookups::dwdx, &Lookups::dwdy};
    return this->*kColumns[i];
  }
  const float* real(size_t i) const { return const_cast<Lookups*>(this)->real(i); }
  const uint32_t*& integer(size_t i) { return i == 0 ? layer : random; }
  const uint32_t* integer(size_t i) const { return i == 0 ? layer : random; }
};

constexpr size_t kOutputColumns = 16;

/// Packed columns of Lookups::count elements. Unwanted columns are null. Nothing is written past the last element.
struct Texels {
  float* channel[4];
  float *du[4], *dv[4];         // derivatives of the channels in u and v, for filters with has_gradient()
  float* dw[4] = {};            // derivatives in w, for 3D textures
  uint32_t* coarser = nullptr;  // finest levels that lookups of a texture in tiles could use (shd_texels)

  float*& column(size_t i) { return i < 4 ? channel[i] : i < 8 ? du[i - 4] : i < 12 ? dv[i - 8] : dw[i - 12]; }
  float* column(size_t i) const { return const_cast<Texels*>(this)->column(i); }
  bool wants_values() const { return channel[0] || channel[1] || channel[2] || channel[3]; }
  bool wants_gradient() const {
    for (size_t c = 0; c < 4; ++c) {
      if (du[c] || dv[c] || dw[c]) return true;
    }
    return false;
  }
  bool wants_deep_gradient() const { return dw[0] || dw[1] || dw[2] || dw[3]; }
};

/// Returns the columns of elements first..first + count - 1.
inline Lookups part_of(const Lookups& in, size_t first, size_t count) {
  Lookups part = in;
  part.count = count;
  for (size_t c = 0; c < kPlaneColumns; ++c) part.real(c) = in.real(c) ? in.real(c) + first : nullptr;
  for (size_t c = kPlaneColumns; in.w && c < kFloatColumns; ++c) {
    part.real(c) = in.real(c) ? in.real(c) + first : nullptr;
  }
  for (size_t c = 0; c < kIntegerColumns; ++c) part.integer(c) = in.integer(c) ? in.integer(c) + first : nullptr;
  return part;
}
inline Texels part_of(const Texels& out, size_t first) {
  Texels part;
  for (size_t c = 0; c < kOutputColumns; ++c) part.column(c) = out.column(c) ? out.column(c) + first : nullptr;
  part.coarser = out.coarser ? out.coarser + first : nullptr;
  return part;
}

/// Copies or borrows the texels of a checked desc and builds its tables on the context's executor.
/// Throws std::bad_alloc and then keeps nothing.
void build(const core::Context& context, const shd_texture_desc& desc, Texture* out);

/// Writes texels at (x, y) of the base of a layer and rebuilds the tables that depend on them. The texels have the
/// stored format or the format that the texture was made from. A borrowed base is not written: the caller has changed
/// it already. Levels that the caller gave stay. The tables have the bits of a texture built from the changed base.
/// Throws std::bad_alloc before anything is written.
void update(const core::Context& context, uint32_t layer, uint32_t x, uint32_t y, const shd_image& texels,
            Texture* texture);

}  // namespace shd::texture
