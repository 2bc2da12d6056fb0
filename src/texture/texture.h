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
/// A lookup passes four choices, and each is written once. The domain turns coordinates and derivatives into shapes:
/// level of detail, probes or ellipse. The filter turns shapes into a stream of quads, rows and single texels. The
/// store places the texels of the stream in memory. The format fetches, decodes and blends them. Domains, filters,
/// stores and formats do not depend on each other, so they add up and do not multiply.
///
/// Rooms, each of which may include itself, the files beside this one and the rooms before it (style.includes):
/// format store table domain filter lookup convert oracle
///
/// | room     | contents                                                                            | contract        |
/// |----------|-------------------------------------------------------------------------------------|-----------------|
/// | format/  | component types and compressed blocks: fetch, decode, blend; consumers of streams   | formats.h       |
/// | store/   | where texels lie: memory, compressed blocks (bc/), tiles (tiles/)                   | stores.h        |
/// | table/   | builders of levels, sums of areas, normals of heights; creation and updates         | tables.h        |
/// | domain/  | coordinates to shapes: planes, slices, directions; wraps and folds beyond edges     | block.h         |
/// | filter/  | filters, one in each file; emitters, sinks and the loop over a batch                | filters-inl.h   |
/// | lookup/  | one call: swizzle, magnification, choice of kernels                                 | sample.h        |
/// | convert/ | images of directions in other projections                                           | convert.h       |
/// | oracle/  | explanations, and bounds of what conforming implementations may return              | explain.h       |
///
/// | file         | contents                                                                                       |
/// |--------------|------------------------------------------------------------------------------------------------|
/// | texture.h    | textures, samplers, lookups and texels                                                         |
/// | support.h    | the table of filters, domains, stores and uses that work together                              |
/// | stream.h     | the stream between filters, stores and formats                                                 |
/// | rows.h       | rows of quads, in place of streams, for linear lookups that share their levels                 |
/// | lanes-inl.h  | vectors of lookups of one target                                                               |
///
/// Words for lookups, from many to few. A batch belongs to one call of the interface. A piece belongs to one task of
/// the executor (src/abi/batch.h). A block has the shapes that are found together (kBlock). A vector has one lookup for
/// each lane of the target. A part is a range of any of these (part_of()). Only format/bc/ and store/bc/ use the word
/// block for 4 x 4 texels of a compressed format; elsewhere these are `bc`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <shd/lookup.h>
#include <shd/sampler.h>
#include <shd/texture.h>

#include "core/allocator.h"
#include "core/context.h"
#include "image/format.h"

namespace shd::texture {

constexpr uint32_t kMaxLevels = 21;  // the base of 2^20 texels of a texture in tiles, and 20 halvings

constexpr uint32_t kMaxLayers = 2048;

constexpr uint32_t kFill = 4;  // channel_source of an output that takes its constant of `fill`

/// Decodes a compressed block into four rows of four texels, whose first texels lie `pitch` bytes apart.
using DecodeBc = void (*)(const uint8_t* block, uint8_t* texels, size_t pitch);

/// log2 of the width and the height of the units of a store [texels]. A unit is a texel of memory, bc or a tile.
struct UnitShape {
  uint32_t shift_x, shift_y;
};

/// Numbers of units: layer by layer, level by level, slice by slice, row by row. Level l of a layer has
/// max(1, width >> l) x max(1, height >> l) texels.
struct Layout {
  UnitShape unit;
  uint32_t layer_units;         // units of all levels of one layer
  uint32_t offset[kMaxLevels];  // first unit of each level
};

/// Blocks of a compressed texture in memory.
struct BcStore {
  DecodeBc decode;          // null: the texture has texels, and nothing else here is set
  uint32_t size;            // bytes of a block
  uint64_t owner;           // number of the texture among the owners of `caches`
  core::CachePool* caches;  // caches of the context; may be null
};

struct TileSet;         // store/tiles/tile.h
struct DecodedTexture;  // table/decoded.h

void destroy_part(TileSet* tiles) noexcept;
void destroy_part(DecodedTexture* decoded) noexcept;

/// Owns a part of a texture.
template <class Part>
class Owned {
 public:
  Owned() = default;
  explicit Owned(Part* part) : part_(part) {}
  Owned(Owned&& other) noexcept : part_(std::exchange(other.part_, nullptr)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(part_, other.part_);
    return *this;
  }
  ~Owned() {
    if (part_) destroy_part(part_);
  }

  Part* operator->() const { return part_; }
  Part& operator*() const { return *part_; }
  explicit operator bool() const { return part_ != nullptr; }

 private:
  Part* part_ = nullptr;
};

/// Where texels lie. store/stores.h has what each store does.
enum class Store : uint32_t { kMemory, kBorrowed, kBc, kTiles, kTilesOfBc };

/// Texels of every level of every layer, side by side in memory. A borrowed base level stays in the caller's memory.
struct Texture {
  Store store;                           // chosen when the texture is made
  shd_format format;                     // stored format: one, two or four channels, or bc
  shd_format given_format;               // format of the texels that the texture was made from
  image::Component component;            // component type of `format`, or of texels decoded from it
  uint32_t channels;                     // channels of `format`, or of texels decoded from it
  uint32_t channel_source[4];            // stored channel of each output, or kFill
  float fill[4];                         // constant of each output whose source is kFill
  bool premultiplied;                    // outputs r, g and b are multiplied by a
  uint32_t tables;                       // shd_table bits
  uint32_t width, height;                // size of level 0 [texels]
  uint32_t layers;                       // 1..kMaxLayers
  uint32_t depth;                        // slices of level 0 of a 3D texture; 0 = 2D
  shd_projection projection;             // directions that coordinates are
  uint32_t level_count;                  // 1..kMaxLevels
  Layout layout;                         // numbers of texels, compressed blocks or tiles
  uint32_t ripmap_columns, ripmap_rows;  // ripmap levels along each axis, or 0; the size of level (i, j) is
                                         // max(1, width >> i) x max(1, height >> j)
  core::Array<uint32_t> ripmap_offset;   // first texel of level (i, j) at [j * kMaxLevels + i]; may be empty
  bool levels_given;                     // the caller gave the mip levels
  core::Array<uint8_t> texels;  // [layers][levels][rows], rows packed; padded at the end for whole gathers; has no base
                                // level if the base is borrowed
  const uint8_t* borrowed;      // the caller's base level, or null
  const uint8_t* origin;        // address of unit 0, computed as if the base were not borrowed
  uint32_t borrowed_units;      // size of the borrowed base: units 0..borrowed_units - 1; 0 if not borrowed
  BcStore bc;                   // set if `texels` are compressed blocks
  Owned<TileSet> tiles;         // tiles of a texture without texels and borrowed base
  Owned<DecodedTexture> decoded;         // ripmap and sums of a texture of bc or tiles
  core::Array<double> mip_sums;          // [layers] unrounded averages; empty before the first update
  core::Array<uint32_t> mip_sums_ready;  // [layers] whether the averages are valid; as long as mip_sums has any
  core::Array<uint8_t> sums;             // [layers] summed-area tables (summed_area.h) of uint32_t or double
  core::Array<uint32_t> nonfinite_sums;  // counts of texels that are not finite; empty if the texture has none
  core::Array<double> sum_origins;       // [layers][channels] linear value subtracted from texels before summation
};

/// Returns whether levels are rows of texels in memory, so that filters address texels themselves.
inline bool is_in_memory(const Texture& texture) {
  return texture.store == Store::kMemory || texture.store == Store::kBorrowed;
}

/// Returns whether lookups of a texture read w.
inline bool needs_w(const Texture& texture) {
  return texture.depth != 0 || texture.projection != SHD_PROJECTION_NONE;
}

/// Weight of the second of the two texels that a bilinear lookup blends on an axis: the fraction s of the way between
/// them, s rounded to 8 bits, or 3 s^2 - 2 s^3.
enum class Weights : uint32_t { kLinear, kRounded, kHermite };

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
  Weights weights;
  shd_precision precision;
  float probe_slack;
  float level_steepness;  // 1 / level_blend, or 0 for the nearer level alone
  float fast_anisotropy;  // max_anisotropy of fast_lines()
  shd_stochastic stochastic;
  shd_missing_tiles missing_tiles;
  bool compares;
  shd_compare compare;  // set if `compares`
};

/// Returns whether lookups outside the image read the border colour on some axis.
inline bool has_border(const Sampler& sampler) {
  return sampler.wrap_u == SHD_WRAP_BORDER || sampler.wrap_v == SHD_WRAP_BORDER;
}
/// Returns whether lookups of a texture read it. Directions are never outside.
inline bool has_border(const Texture& texture, const Sampler& sampler) {
  if (texture.projection != SHD_PROJECTION_NONE) return false;
  return has_border(sampler) || (texture.depth != 0 && sampler.wrap_w == SHD_WRAP_BORDER);
}

/// Copies a sampler with another filter.
inline Sampler with_filter(const Sampler& sampler, shd_filter filter) {
  Sampler other = sampler;
  other.filter = filter;
  if (filter == SHD_FILTER_HERMITE || sampler.weights == Weights::kHermite) {
    other.weights = filter == SHD_FILTER_HERMITE ? Weights::kHermite : Weights::kLinear;
  }
  return other;
}

/// Copies a sampler and removes width and blur from the copy.
inline Sampler unwidened(const Sampler& sampler) {
  Sampler plain = sampler;
  plain.width_x = plain.width_y = 1.0f;
  plain.blur_u = plain.blur_v = 0.0f;
  return plain;
}

/// Part of the way between two levels in which ANISOTROPIC with SHD_PRECISION_FAST blends them, at most.
constexpr float kFastLevelBlend = 0.28125f;

/// Copies a sampler with the lines of ANISOTROPIC with SHD_PRECISION_FAST.
inline Sampler fast_lines(const Sampler& sampler) {
  Sampler lines = sampler;
  lines.max_anisotropy = sampler.fast_anisotropy;
  const bool longer = sampler.level_steepness != 0.0f && sampler.level_steepness < 1.0f / kFastLevelBlend;
  if (longer) lines.level_steepness = 1.0f / kFastLevelBlend;
  return lines;
}

/// Returns the largest value of shd_filter that is a filter.
shd_filter last_filter();

/// Returns whether a filter has derivatives. A filter has them if it is a continuous tree of blends.
bool has_gradient(shd_filter filter);

/// Makes the sampler of a checked desc.
Sampler make_sampler(const shd_sampler_desc& desc);

constexpr size_t kFloatColumns = 11, kIntegerColumns = 2;
constexpr size_t kPlaneColumns = 7;   // float columns before w: those that textures without needs_w() read
constexpr size_t kPlaceColumns = 10;  // float columns of places and footprints: all but the reference

/// Packed columns of `count` elements. Optional columns that are absent are null.
struct Lookups {
  size_t count;
  const float *u, *v;
  const float *dudx, *dvdx, *dudy, *dvdy;  // null = 0
  const float* lod;                        // level of detail, in place of the derivatives; null = from the derivatives
  const uint32_t* layer;                   // null = 0
  const uint32_t* random;                  // random bits; null = a hash of the bits of u and v
  const float *w = nullptr, *dwdx = nullptr, *dwdy = nullptr;  // read by textures with needs_w(); null = 0
  bool one_footprint = false;        // each column of derivatives holds one finite value; false = not known
  bool finite = false;               // all columns of floats hold finite values; false = not known
  const float* reference = nullptr;  // read by samplers with `compares`; null = 0

  /// Returns a column by its number, for code that treats all columns equally.
  const float*& real(size_t i) {
    static constexpr const float* Lookups::*kColumns[kFloatColumns] = {
        &Lookups::u,   &Lookups::v, &Lookups::dudx, &Lookups::dvdx, &Lookups::dudy,     &Lookups::dvdy,
        &Lookups::lod, &Lookups::w, &Lookups::dwdx, &Lookups::dwdy, &Lookups::reference};
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
  uint32_t* rgba8 = nullptr;    // opaque pixels, for textures with writes_rgba8(); channels 0..2 are then scratch

  float*& column(size_t i) { return i < 4 ? channel[i] : i < 8 ? du[i - 4] : i < 12 ? dv[i - 8] : dw[i - 12]; }
  float* column(size_t i) const { return const_cast<Texels*>(this)->column(i); }
  bool wants_values() const { return channel[0] || channel[1] || channel[2] || channel[3]; }
  bool wants_gradient() const {
    const auto bits = [](const float* column) { return reinterpret_cast<uintptr_t>(column); };
    uintptr_t any = 0;
    for (size_t c = 0; c < 4; ++c) any |= bits(du[c]) | bits(dv[c]) | bits(dw[c]);
    return any != 0;
  }
  bool wants_deep_gradient() const { return dw[0] || dw[1] || dw[2] || dw[3]; }
};

/// Returns the columns of elements first..first + count - 1.
inline Lookups part_of(const Lookups& in, size_t first, size_t count) {
  Lookups part = in;
  part.count = count;
  for (size_t c = 0; c < kPlaneColumns; ++c) part.real(c) = in.real(c) ? in.real(c) + first : nullptr;
  for (size_t c = kPlaneColumns; in.w && c < kPlaceColumns; ++c) {
    part.real(c) = in.real(c) ? in.real(c) + first : nullptr;
  }
  part.reference = in.reference ? in.reference + first : nullptr;
  for (size_t c = 0; c < kIntegerColumns; ++c) part.integer(c) = in.integer(c) ? in.integer(c) + first : nullptr;
  return part;
}
inline Texels part_of(const Texels& out, size_t first) {
  Texels part;
  for (size_t c = 0; c < kOutputColumns; ++c) part.column(c) = out.column(c) ? out.column(c) + first : nullptr;
  part.coarser = out.coarser ? out.coarser + first : nullptr;
  return part;
}

/// Copies or borrows the texels of a checked desc and builds its tables on the context's executor. `out` is a new
/// Texture. Throws std::bad_alloc; the caller then destroys `out`.
void build(const core::Context& context, const shd_texture_desc& desc, Texture* out);

/// Writes texels at (x, y) of the base of a layer and rebuilds the tables that depend on them. The texels have the
/// stored format or the format that the texture was made from. A borrowed base is not written: the caller has changed
/// it already. Levels that the caller gave stay. The tables have the bits of a texture built from the changed base.
/// Throws std::bad_alloc before anything is written.
void update(const core::Context& context, uint32_t layer, uint32_t x, uint32_t y, const shd_image& texels,
            Texture* texture);

}  // namespace shd::texture
