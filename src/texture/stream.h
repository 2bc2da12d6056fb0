// SPDX-License-Identifier: MIT
/// @file
/// The stream between filters and formats. Filters emit elements, formats consume them. Filters and formats do not
/// depend on each other.
///
/// An element serves one vector of lookups; the elements of a vector are consecutive. An element is a quad (2 x 2
/// neighbouring texels of one level, with the fractions of their bilinear blend), a row (four texels side by side, with
/// the shares of their running average), a single texel, or a merge. The consumer keeps two running averages:
///
///   kStart     average = value
///   kBlend     average = average + share (value - average)
///   kReplace   kBlend, except that a lane with the share kWhole starts with the value
///   kMerge     first average = first + share (second - first); has no texels
///
/// The first average is the result. Every filter is therefore a tree of blends of at most two levels, and equal texels
/// give exactly their value:
///
///   bilinear     quad                                    trilinear   quad, quad
///   ripmap       2 quads, 2 quads into the second, merge anisotropic a quad of each level for each probe, merge
///   bicubic      4 rows                                  EWA         texels, a quad where it meets bilinear
///   3D linear    a quad of each of two slices            3D trilinear 2 quads, 2 quads into the second, merge
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/texture.h"

namespace shd::texture {

/// Maximum number of lanes of a vector of lookups.
constexpr size_t kMaxLanes = 16;

/// Operation of an element: one of the first three, and flags.
enum StreamOp : uint16_t {
  kStart = 0,
  kBlend = 1,
  kReplace = 2,
  kHow = 3,          // mask of the first three
  kSecond = 4,       // the element goes into the second average
  kQuad = 8,         // 2 x 2 texels: columns 0 and 1 of row 0, then of row 1
  kRow = 512,        // 4 texels of a row, the inner two first: columns 1, 2, 0, 3
  kNeighbours = 16,  // columns are adjacent in memory, and no texel is the border
  kMerge = 32,       // blends the second average into the first
  kRated = 64,       // the share depends on the point; its rates are stored if the stream has rates
  kNewLine = 128,    // the texel begins a row (hint for prefetching)
  kLast = 256,       // last element of its vector of lookups
  kDeep = 1024,      // as kRated, but the share depends on w alone; its rate in w is in share_rate_u
  kApart = 2048,     // places only: each texel has a row and an image of its own
};

/// Share that makes a lane of a kReplace element start with the value.
constexpr float kWhole = 2.0f;

/// Columns of elements: element e of a target with L lanes lies at e * L.
template <size_t kCapacity>
struct Elements {
  static constexpr size_t kColumn = kCapacity + 16;  // avoids columns a power of two apart, which alias in the cache

  alignas(64) int32_t index[4][kColumn];  // texels; ~index on the border
  alignas(64) float s[kColumn];           // quad: fraction along u; row: share of the second texel
  alignas(64) float t[kColumn];           // quad: fraction along v; row: share of the third texel
  alignas(64) float r[kColumn];           // row: share of the fourth texel
  alignas(64) float share[kColumn];       // share in the running average; unused for kStart
  // Derivatives of these, if wanted: of s, r and the t of a row in u; of the t of a quad in v; of the share in both.
  alignas(64) float rate_s[kColumn], rate_t[kColumn], rate_r[kColumn];
  alignas(64) float share_rate_u[kColumn], share_rate_v[kColumn];
};

/// Places of the texels of elements, for stores that place streams. Columns are in Elements::index; those of neighbours
/// follow column 0 of a quad, or column 2 of a row. A column or a row of -1 is the border. Texel k of a quad has the
/// row k / 2, a row of texels has one row, and all texels are in one image; an element with kApart has a row and an
/// image for each texel.
struct StreamPlaces {
  static constexpr size_t kColumn = Elements<256>::kColumn;

  alignas(64) int32_t y[4][kColumn];
  alignas(64) int32_t first[4][kColumn];  // first unit of the level of the image (Layout), which no other level has
  alignas(64) int32_t width[kColumn];     // width of the level [texels]
};

/// A buffer of elements: 8 KB, 13 KB with rates. It stays in the first-level cache. Prefetched texels have the time of
/// a buffer to arrive.
struct Stream : Elements<256> {
  static constexpr size_t kCapacity = 256, kMaxElements = 32;

  size_t elements;  // elements in use, one vector each
  uint16_t op[kMaxElements];
  StreamPlaces* places;  // written if a store places the stream; else null

  /// Returns the row and the image of texel k of element e.
  size_t row_of(size_t e, size_t k) const { return op[e] & kApart ? k : op[e] & kQuad ? k / 2 : 0; }
  size_t image_of(size_t e, size_t k) const { return op[e] & kApart ? k : 0; }
  /// Returns the number of texels of element e.
  size_t texels_of(size_t e) const { return op[e] & kMerge ? 0 : op[e] & (kQuad | kRow) ? 4 : 1; }
};

/// Replaces the columns of elements 0..end - 1, which have `lanes` lanes, by indices of texels in the memory of a
/// store. Clears kNeighbours where columns are not adjacent there.
using PlaceStream = void (*)(void* state, size_t end, size_t lanes, Stream* stream);

/// The placement of streams by a store. Without `place`, filters write indices themselves.
struct Placement {
  PlaceStream place = nullptr;
  void* state = nullptr;
  const uint8_t* origin = nullptr;  // texel 0
  StreamPlaces* places = nullptr;   // memory for the places of the stream
};

struct FilterCall;
struct Recording;

/// Addresses of the texels of a texture, or of the texels in its cache.
struct TexelSource {
  const uint8_t* origin;     // address of texel 0, computed as if the base were not borrowed
  const uint8_t* borrowed;   // the caller's base level, or null
  uint32_t borrowed_texels;  // size of the borrowed base: texels 0..borrowed_texels - 1
  uint32_t channels;         // stored channels: 1, 2 or 4
  uint32_t texel_size;       // [bytes]

  explicit TexelSource(const Texture& texture);
  explicit TexelSource(const FilterCall& call);

  /// Returns the first byte of a texel.
  const uint8_t* texel(uint32_t index) const {
    return (index < borrowed_texels ? borrowed : origin) + size_t{index} * texel_size;
  }
};

/// State of a consumer over the lookups of one batch: inputs, outputs and progress.
struct Consumption {
  Consumption(const FilterCall& call, const TexelSource& source, Recording* record);

  const TexelSource texels;
  const Sampler& sampler;
  Recording* recording;  // tree of blends, for the consumer that records; else null
  const Texels& out;     // unwanted columns are null; nothing is written past `count`
  size_t count;
  const float* reference;  // references of all lookups, for ComparedOf(); null = 0
  bool unorm;              // texels are unorm, and so references are clamped
  size_t done = 0;         // lookups written so far
  bool open = false;       // the stream ended within a vector of lookups, whose averages are in `state`
  alignas(64) uint8_t state[2 * 4 * 3 * 64];
};

/// Consumes elements 0..end - 1.
using Consume = void (*)(const Stream& stream, size_t end, Consumption* consumption);

struct RowStream;

/// Blends the quads of a block of lookups with the bits of a Consume, and writes the results (rows.h).
using ConsumeRows = void (*)(const RowStream& rows, Consumption* consumption);

/// Derivatives that a call computes in addition to values, or instead: none, in u and v, or in w.
enum class Gradient { kNone, kPlane, kDeep };

/// The consumers of one format on one target, for one sampler.
struct FormatKernels {
  Consume values;    // values, with the border colour if the sampler's lookups may read it
  Consume gradient;  // derivatives in u and v, or in w; null if none are wanted
  ConsumeRows rows;  // values of rows of quads; null if derivatives are wanted, or filters emit none
  bool rows_only;    // every block becomes rows, because `rows` has other bits than `values`
};

/// Arguments of a filter: one batch of lookups and the consumers of the format.
struct FilterCall {
  const Texture& texture;
  const Sampler& sampler;
  const Lookups& in;
  const Texels& out;
  const FormatKernels& format;
  Consume record;        // null, or the consumer that replaces those of the format
  Recording* recording;  // output of `record`, or null
  Placement placement;   // placement of the store
};

inline Consumption::Consumption(const FilterCall& call, const TexelSource& source, Recording* record)
    : texels(source),
      sampler(call.sampler),
      recording(record),
      out(call.out),
      count(call.in.count),
      reference(call.in.reference),
      unorm(image::is_unorm(call.texture.component)) {}

/// Filters on the calling thread. Returns the number of lookups with an input that is not finite.
using RunFilter = size_t (*)(const FilterCall& call);

/// Kernels of one target for a sampler and a format.
struct Kernels {
  RunFilter run;
  RunFilter fused;  // null, or filter and format compiled together for values without border (fused.cpp)
  RunFilter fast;   // null, or the filter of values with SHD_PRECISION_FAST, whose consumers are in fast_format
  FormatKernels format, fast_format;
  Consume record;
  PlaceStream place;  // placement of the texture's store; null if filters write indices
};

}  // namespace shd::texture
