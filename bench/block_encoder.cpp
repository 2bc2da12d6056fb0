// SPDX-License-Identifier: MIT
#include "block_encoder.h"

#include <algorithm>

namespace shd::bench {
namespace {

struct Block {
  int texel[16][4];
  int low[4], high[4];  // corners of the bounding box
};

Block block_at(const std::vector<uint8_t>& rgba, uint32_t edge, uint32_t column, uint32_t row) {
  Block block;
  std::fill_n(block.low, 4, 255);
  std::fill_n(block.high, 4, 0);
  for (uint32_t i = 0; i < 16; ++i) {
    const size_t x = std::min(4 * column + i % 4, edge - 1), y = std::min(4 * row + i / 4, edge - 1);
    for (size_t c = 0; c < 4; ++c) {
      const int value = rgba[(y * edge + x) * 4 + c];
      block.texel[i][c] = value;
      block.low[c] = std::min(block.low[c], value);
      block.high[c] = std::max(block.high[c], value);
    }
  }
  return block;
}

/// Returns the step of 0..last of a texel between the corners: its projection to their diagonal.
uint32_t step_of(const Block& block, uint32_t texel, int channels, int last) {
  int along = 0, length = 0;
  for (int c = 0; c < channels; ++c) {
    const int side = block.high[c] - block.low[c];
    along += (block.texel[texel][c] - block.low[c]) * side;
    length += side * side;
  }
  return length == 0 ? 0 : static_cast<uint32_t>((2 * along * last + length) / (2 * length));
}

/// Appends fields to a block, from the lowest bit on.
class Bits {
 public:
  explicit Bits(uint8_t* bytes) : bytes_(bytes) {}
  void put(uint32_t value, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i, ++at_) {
      bytes_[at_ / 8] = static_cast<uint8_t>(bytes_[at_ / 8] | (value >> i & 1) << at_ % 8);
    }
  }

 private:
  uint8_t* bytes_;
  uint32_t at_ = 0;
};

void put_bc1(const Block& block, uint8_t* bytes) {
  const auto packed = [](const int(&c)[4]) {
    return static_cast<uint32_t>(c[0] >> 3 << 11 | c[1] >> 2 << 5 | c[2] >> 3);
  };
  const uint32_t first = packed(block.high), second = packed(block.low);
  Bits bits(bytes);
  bits.put(first, 16);
  bits.put(second, 16);
  constexpr uint32_t kIndexOfStep[4] = {1, 3, 2, 0};  // from the second endpoint to the first one
  for (uint32_t i = 0; i < 16; ++i) bits.put(first == second ? 0 : kIndexOfStep[step_of(block, i, 3, 3)], 2);
}

void put_bc7(const Block& block, uint8_t* bytes) {
  const bool swapped = step_of(block, 0, 4, 15) > 7;  // the highest bit of the first index is not stored
  const int(&first)[4] = swapped ? block.high : block.low;
  const int(&second)[4] = swapped ? block.low : block.high;
  Bits bits(bytes);
  bits.put(1u << 6, 7);
  for (int c = 0; c < 4; ++c) {
    bits.put(static_cast<uint32_t>(first[c] >> 1), 7);
    bits.put(static_cast<uint32_t>(second[c] >> 1), 7);
  }
  bits.put(swapped, 1);  // lowest bits of the endpoints: 1 for the upper corner
  bits.put(!swapped, 1);
  for (uint32_t i = 0; i < 16; ++i) {
    const uint32_t step = step_of(block, i, 4, 15);
    bits.put(swapped ? 15 - step : step, i == 0 ? 3 : 4);
  }
}

template <class Put>
std::vector<uint8_t> encode(const std::vector<uint8_t>& rgba, uint32_t edge, size_t size, const Put& put) {
  const uint32_t across = (edge + 3) / 4;
  std::vector<uint8_t> out(size * across * across);
  for (uint32_t i = 0; i < across * across; ++i) put(block_at(rgba, edge, i % across, i / across), &out[i * size]);
  return out;
}

}  // namespace

std::vector<uint8_t> encode_bc1(const std::vector<uint8_t>& rgba, uint32_t edge) {
  return encode(rgba, edge, 8, put_bc1);
}

std::vector<uint8_t> encode_bc7(const std::vector<uint8_t>& rgba, uint32_t edge) {
  return encode(rgba, edge, 16, put_bc7);
}

std::vector<uint8_t> halved(const std::vector<uint8_t>& rgba, uint32_t edge) {
  const size_t half = edge / 2;
  std::vector<uint8_t> out(half * half * 4);
  for (size_t i = 0; i < out.size(); ++i) {
    const size_t x = i / 4 % half, y = i / 4 / half, c = i % 4, at = (2 * y * edge + 2 * x) * 4 + c;
    out[i] = static_cast<uint8_t>((rgba[at] + rgba[at + 4] + rgba[at + edge * 4] + rgba[at + edge * 4 + 4] + 2) / 4);
  }
  return out;
}

}  // namespace shd::bench
