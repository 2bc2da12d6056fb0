// SPDX-License-Identifier: MIT
/// @file
/// What filters emit and formats consume: a stream of elements, one vector of lookups each. Filters do not depend on
/// formats, nor formats on filters.
///
/// The elements of one vector of lookups follow each other; each is a quad (2 x 2 neighbouring texels of one level,
/// with the fractions of their bilinear blend), a row (four texels side by side, with the shares of their running
/// average), a single texel, or a merge. Two running averages take them in:
///
///   kStart     average = value
///   kBlend     average = average + share (value - average)
///   kReplace   as kBlend, but a lane whose share is kWhole starts with the value
///   kMerge     first average = first + share (second - first); has no texels
///
/// The first average is the result. So every filter is a tree of blends of at most two levels, and texels that are
/// equal give exactly their value:
///
///   bilinear     quad                                    trilinear   quad, quad
///   ripmap       2 quads, 2 quads into the second, merge anisotropic a quad of each level for each probe, merge
///   bicubic      4 rows                                  EWA         texels, a quad where it meets bilinear
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/explain/record.h"
#include "texture/texture.h"

namespace shd::texture {

/// How an element counts; one of the first three, then flags.
enum StreamOp : uint16_t {
  kStart = 0,
  kBlend = 1,
  kReplace = 2,
  kHow = 3,          // mask of the above
  kSecond = 4,       // into the second average
  kQuad = 8,         // 2 x 2 texels: columns 0 and 1 of row 0, then of row 1
  kRow = 512,        // 4 texels, the two in the middle first: columns 1, 2, 0, 3
  kNeighbours = 16,  // texels side by side are so in memory, and none is the border
  kMerge = 32,       // the second average into the first
  kRated = 64,       // the share depends on the point: its rates are there, if the stream has rates
  kNewLine = 128,    // a texel that begins a row, for prefetching
  kLast = 256,       // the last element of its lookups
};

/// Share of a lane that starts with the value.
constexpr float kWhole = 2.0f;

/// Columns of elements: element e of a target with L lanes lies at e * L.
template <size_t kCapacity>
struct Elements {
  static constexpr size_t kColumn = kCapacity + 16;  // columns a power of two apart would alias in the cache

  alignas(64) int32_t index[4][kColumn];  // texels; ~index on the border
  alignas(64) float s[kColumn];           // quad: fraction along u; row: share of the second texel
  alignas(64) float t[kColumn];           // quad: fraction along v; row: share of the third texel
  alignas(64) float r[kColumn];           // row: share of the fourth texel
  alignas(64) float share[kColumn];       // unless kStart
  // Their change in the coordinate, if derivatives are wanted: s and r along u, t of a quad along v, share along both.
  alignas(64) float rate_s[kColumn], rate_t[kColumn], rate_r[kColumn];
  alignas(64) float share_rate_u[kColumn], share_rate_v[kColumn];
};

/// A buffer of elements: 8 KB, 13 KB with rates, which stay in the first-level cache.
struct Stream : Elements<256> {
  static constexpr size_t kCapacity = 256;

  size_t elements;  // whole vectors in use
  uint16_t op[kCapacity];
};

/// Where the texels of a texture lie.
struct TexelSource {
  const uint8_t* origin;     // texel 0, or where it would lie if the base were not borrowed
  const uint8_t* borrowed;   // the caller's base level, or null
  uint32_t borrowed_texels;  // how many: lower indices are there
  uint32_t channels;         // stored: 1, 2 or 4
  uint32_t texel_size;       // bytes

  explicit TexelSource(const Texture& texture);
};

/// What a consumer makes of the lookups of one batch, and how far it has come.
struct Consumption {
  TexelSource texels;
  const Sampler& sampler;
  Recording* recording;  // of the consumer that records, else null
  Texels out;            // unwanted columns are null; nothing is written past `count`
  size_t count;
  size_t done;  // lookups that are written
  bool open;    // the last lookups are not finished: `state` holds their averages
  alignas(64) uint8_t state[2 * 4 * 3 * 64];
};

/// Consumes elements first..end - 1.
using Consume = void (*)(const Stream& stream, size_t first, size_t end, Consumption* consumption);

/// The consumers of one format on one target.
struct FormatKernels {
  Consume values;    // where no lookup reads the border
  Consume bordered;  // values where some may
  Consume gradient;  // derivatives in u and v
};

/// One batch on its way through a filter.
struct FilterCall {
  const Texture& texture;
  const Sampler& sampler;
  const Lookups& in;
  const Texels& out;
  FormatKernels format;
  Consume record;        // null, or the consumer that all lookups go to
  Recording* recording;  // its
};

/// Filters on the calling thread. Returns how many lookups had something that is not finite.
using RunFilter = size_t (*)(const FilterCall& call);

/// What one target has for a filter and a format.
struct Kernels {
  RunFilter run;
  RunFilter fused;  // values without border, or null (fused.cpp)
  FormatKernels format;
  Consume record;
};

}  // namespace shd::texture
