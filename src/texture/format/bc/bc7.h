// SPDX-License-Identifier: MIT
/// @file
/// The fields of BC7 blocks, for the scalar decoder and for kernels. The four channels of a colour are the four 16-bit
/// lanes of a 64-bit word.
#pragma once

#include "texture/format/bc/decode.h"
#include "texture/format/bc/partitions.h"

namespace shd::texture::bc7 {

/// Fields of a mode, in bits, in the order of the block (Khronos Data Format Specification 1.3, table 112). A block
/// has first as many zeros as the number of the mode, and a one.
struct Mode {
  uint32_t subsets, partition, rotation, selection, color, alpha, endpoint_p, shared_p, index, second_index;
};
constexpr Mode kModes[8] = {
    {3, 4, 0, 0, 4, 0, 1, 0, 3, 0}, {2, 6, 0, 0, 6, 0, 0, 1, 3, 0}, {3, 6, 0, 0, 5, 0, 0, 0, 2, 0},
    {2, 6, 0, 0, 7, 0, 1, 0, 2, 0}, {1, 0, 2, 1, 5, 6, 0, 0, 2, 3}, {1, 0, 2, 0, 7, 8, 0, 0, 2, 2},
    {1, 0, 0, 0, 7, 7, 1, 0, 4, 0}, {2, 6, 0, 0, 5, 5, 1, 0, 2, 0},
};

constexpr uint64_t kLanes = 0x0001000100010001;

struct Block {
  uint64_t low, high;

  /// Returns `count` bits from a position, at most 63.
  uint64_t field(uint32_t position, uint32_t count) const {
    uint64_t bits = position < 64 ? low >> position : high >> (position - 64);
    if (position > 0 && position < 64) bits |= high << (64 - position);
    return bits & ((uint64_t{1} << count) - 1);
  }
};

/// Extends codes of `bits` bits in all lanes to 8 bits by replication.
constexpr uint64_t expanded(uint64_t lanes, uint32_t bits) {
  return (lanes << (8 - bits) | lanes >> (2 * bits - 8)) & (kLanes * 255);
}

/// Returns the codes of four lanes as bytes.
inline uint32_t packed(uint64_t lanes) {
  lanes = (lanes | lanes >> 8) & 0x0000ffff0000ffff;
  return static_cast<uint32_t>(lanes | lanes >> 16);
}

/// Reads the endpoints of all subsets, two for each. Returns the position after them.
template <uint32_t kMode>
[[gnu::always_inline]] inline uint32_t read_endpoints(const Block& block, uint32_t position, uint64_t (&endpoint)[6]) {
  constexpr Mode m = kModes[kMode];
  constexpr uint32_t kCount = 2 * m.subsets, kP = m.endpoint_p | m.shared_p;
  for (uint64_t& e : endpoint) e = 0;
  for (uint32_t c = 0; c < 3; ++c, position += kCount * m.color) {
    const uint64_t codes = block.field(position, kCount * m.color);
    for (uint32_t k = 0; k < kCount; ++k) {
      endpoint[k] |= (codes >> (k * m.color) & ((1u << m.color) - 1)) << (16 * c);
    }
  }
  uint64_t alpha[6] = {};
  if (m.alpha > 0) {
    const uint64_t codes = block.field(position, kCount * m.alpha);
    for (uint32_t k = 0; k < kCount; ++k) alpha[k] = codes >> (k * m.alpha) & ((1u << m.alpha) - 1);
    position += kCount * m.alpha;
  }
  if (kP) {
    const uint64_t p = block.field(position, m.shared_p ? m.subsets : kCount);
    for (uint32_t k = 0; k < kCount; ++k) {
      const uint64_t bit = p >> (m.shared_p ? k / 2 : k) & 1;
      endpoint[k] = endpoint[k] << 1 | bit * kLanes;
      alpha[k] = alpha[k] << 1 | bit;
    }
    position += m.shared_p ? m.subsets : kCount;
  }
  constexpr uint64_t kColors = 0x0000ffffffffffff;
  for (uint32_t k = 0; k < kCount; ++k) {
    const uint64_t a = m.alpha > 0 ? expanded(alpha[k], m.alpha + kP) & 255 : 255;
    endpoint[k] = (expanded(endpoint[k] & kColors, m.color + kP) & kColors) | a << 48;
  }
  return position;
}

}  // namespace shd::texture::bc7
