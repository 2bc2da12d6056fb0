// SPDX-License-Identifier: MIT
// BC7 (BPTC). The four channels of a colour are the four 16-bit lanes of a 64-bit word, in which no product of a code
// and a weight overflows.
#include <cstring>

#include "texture/block/decode.h"
#include "texture/block/partitions.h"

namespace shd::texture {
namespace {

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

/// A pair of endpoints: 64 a + 32 and b - a in all lanes. Lanes of the difference may be negative, and borrow from the
/// next one; the sum in mixed() gives the loan back.
struct Pair {
  uint64_t base, difference;

  Pair() = default;
  Pair(uint64_t a, uint64_t b) : base(a * 64 + kLanes * 32), difference(b - a) {}

  /// Returns ((64 - w) a + w b) / 64, rounded to codes, in all lanes.
  uint64_t mixed(uint32_t weight) const { return (base + difference * weight) >> 6 & (kLanes * 255); }
};

uint32_t packed(uint64_t lanes) {
  lanes = (lanes | lanes >> 8) & 0x0000ffff0000ffff;
  return static_cast<uint32_t>(lanes | lanes >> 16);
}

/// Reads the endpoints of all subsets, two for each. Returns the position after them.
template <uint32_t kMode>
uint32_t read_endpoints(const Block& block, uint32_t position, uint64_t (&endpoint)[6]) {
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

/// Swaps alpha with the channel `rotation` - 1.
uint64_t rotated(uint64_t lanes, uint32_t rotation) {
  if (rotation == 0) return lanes;
  const uint32_t shift = 16 * (rotation - 1);
  const uint64_t difference = (lanes >> 48 ^ lanes >> shift) & 0xffff;
  return lanes ^ difference << 48 ^ difference << shift;
}

/// Modes 4 and 5: color and alpha have indices of their own.
template <uint32_t kMode>
void decode_separate(const Block& block, uint8_t* texels, size_t pitch) {
  constexpr Mode m = kModes[kMode];
  const auto rotation = static_cast<uint32_t>(block.field(kMode + 1, m.rotation));
  const bool swapped = m.selection && block.field(kMode + 1 + m.rotation, m.selection);
  uint64_t endpoint[6];
  const uint32_t position = read_endpoints<kMode>(block, kMode + 1 + m.rotation + m.selection, endpoint);
  const uint64_t first = whole_indices<m.index, 1>(block.field(position, 16 * m.index - 1), 0);
  const uint64_t second =
      whole_indices<m.second_index, 1>(block.field(position + 16 * m.index - 1, 16 * m.second_index - 1), 0);
  constexpr uint64_t kAlpha = 0xffff000000000000;
  const Pair pair(endpoint[0], endpoint[1]);
  for (uint32_t y = 0; y < 4; ++y) {
    for (uint32_t x = 0; x < 4; ++x) {
      const uint32_t i = 4 * y + x;
      const uint32_t a = kWeights[m.index - 2][first >> (m.index * i) & ((1u << m.index) - 1)];
      const uint32_t b = kWeights[m.second_index - 2][second >> (m.second_index * i) & ((1u << m.second_index) - 1)];
      const uint64_t color = pair.mixed(swapped ? b : a), alpha = pair.mixed(swapped ? a : b);
      const uint32_t texel = packed(rotated((color & ~kAlpha) | (alpha & kAlpha), rotation));
      std::memcpy(texels + y * pitch + 4 * x, &texel, sizeof texel);
    }
  }
}

template <uint32_t kMode>
void decode_mode(const Block& block, uint8_t* texels, size_t pitch) {
  constexpr Mode m = kModes[kMode];
  const auto partition = static_cast<uint32_t>(block.field(kMode + 1, m.partition));
  uint64_t endpoint[6];
  const uint32_t position = read_endpoints<kMode>(block, kMode + 1 + m.partition, endpoint);
  uint64_t indices = whole_indices<m.index, m.subsets>(block.field(position, 16 * m.index - m.subsets), partition);
  uint32_t subsets = m.subsets == 3 ? kThreeSubsets[partition] : m.subsets == 2 ? kTwoSubsets[partition] : 0;
  Pair pairs[m.subsets];
  for (uint32_t s = 0; s < m.subsets; ++s) pairs[s] = Pair(endpoint[2 * s], endpoint[2 * s + 1]);
  for (uint32_t y = 0; y < 4; ++y) {
    for (uint32_t x = 0; x < 4; ++x, indices >>= m.index, subsets >>= 2) {
      const Pair& pair = pairs[m.subsets > 1 ? subsets & 3 : 0];
      const uint32_t texel = packed(pair.mixed(kWeights[m.index - 2][indices & ((1u << m.index) - 1)]));
      std::memcpy(texels + y * pitch + 4 * x, &texel, sizeof texel);
    }
  }
}

}  // namespace

void decode_bc7(const uint8_t* bytes, uint8_t* texels, size_t pitch) {
  const Block block = {bits_at<8>(bytes), bits_at<8>(bytes + 8)};
  const uint32_t marker = bytes[0];
  if (marker == 0) {  // reserved
    for (size_t y = 0; y < 4; ++y) std::memset(texels + y * pitch, 0, 16);
    return;
  }
  switch (__builtin_ctz(marker)) {
    case 0: return decode_mode<0>(block, texels, pitch);
    case 1: return decode_mode<1>(block, texels, pitch);
    case 2: return decode_mode<2>(block, texels, pitch);
    case 3: return decode_mode<3>(block, texels, pitch);
    case 4: return decode_separate<4>(block, texels, pitch);
    case 5: return decode_separate<5>(block, texels, pitch);
    case 6: return decode_mode<6>(block, texels, pitch);
    default: return decode_mode<7>(block, texels, pitch);
  }
}

}  // namespace shd::texture
