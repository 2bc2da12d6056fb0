// SPDX-License-Identifier: MIT
// BC7 (BPTC) in scalar code.
#include <cstring>

#include "texture/format/bc/bc7.h"

namespace shd::texture {
namespace {

using namespace bc7;

/// A pair of endpoints: 64 a + 32 and b - a in all lanes. Lanes of the difference may be negative, and borrow from the
/// next one; the sum in mixed() gives the loan back.
struct Pair {
  uint64_t base, difference;

  Pair() = default;
  Pair(uint64_t a, uint64_t b) : base(a * 64 + kLanes * 32), difference(b - a) {}

  /// Returns ((64 - w) a + w b) / 64, rounded to codes, in all lanes.
  uint64_t mixed(uint32_t weight) const { return (base + difference * weight) >> 6 & (kLanes * 255); }
};

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
