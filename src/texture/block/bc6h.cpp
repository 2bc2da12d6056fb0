// SPDX-License-Identifier: MIT
// BC6H (BPTC): half floats as integers, interpolated linearly. The fourth channel is 0, as in formats of three
// channels.
#include <cstring>

#include "texture/block/decode.h"
#include "texture/block/partitions.h"

namespace shd::texture {
namespace {

/// Endpoint variables: channel 3 e + c is channel c of endpoint e: w, x, y, z.
enum Variable : uint8_t { kRw, kGw, kBw, kRx, kGx, kBx, kRy, kGy, kBy, kRz, kGz, kBz };

/// Bits of a variable that follow each other in a block, from `first` up, or down if `falling`.
struct Field {
  uint8_t variable, first, count;
  bool falling;
};

/// Bits of an endpoint, bits of the differences of each channel, and the fields after the mode (Khronos Data Format
/// Specification 1.3, 20.2, table of block formats). A count of 0 ends the fields.
struct Mode {
  uint8_t marker, precision, delta[3];
  bool transformed, two_subsets;
  Field fields[27];
};

constexpr Mode kModes[14] = {
    {0x00,
     10,
     {5, 5, 5},
     true,
     true,
     {{kGy, 4, 1, false},
      {kBy, 4, 1, false},
      {kBz, 4, 1, false},
      {kRw, 0, 10, false},
      {kGw, 0, 10, false},
      {kBw, 0, 10, false},
      {kRx, 0, 5, false},
      {kGz, 4, 1, false},
      {kGy, 0, 4, false},
      {kGx, 0, 5, false},
      {kBz, 0, 1, false},
      {kGz, 0, 4, false},
      {kBx, 0, 5, false},
      {kBz, 1, 1, false},
      {kBy, 0, 4, false},
      {kRy, 0, 5, false},
      {kBz, 2, 1, false},
      {kRz, 0, 5, false},
      {kBz, 3, 1, false}}},
    {0x01, 7, {6, 6, 6}, true, true, {{kGy, 5, 1, false}, {kGz, 4, 2, false}, {kRw, 0, 7, false}, {kBz, 0, 2, false},
                                      {kBy, 4, 1, false}, {kGw, 0, 7, false}, {kBy, 5, 1, false}, {kBz, 2, 1, false},
                                      {kGy, 4, 1, false}, {kBw, 0, 7, false}, {kBz, 3, 1, false}, {kBz, 5, 1, false},
                                      {kBz, 4, 1, false}, {kRx, 0, 6, false}, {kGy, 0, 4, false}, {kGx, 0, 6, false},
                                      {kGz, 0, 4, false}, {kBx, 0, 6, false}, {kBy, 0, 4, false}, {kRy, 0, 6, false},
                                      {kRz, 0, 6, false}}},
    {0x02,
     11,
     {5, 4, 4},
     true,
     true,
     {{kRw, 0, 10, false},
      {kGw, 0, 10, false},
      {kBw, 0, 10, false},
      {kRx, 0, 5, false},
      {kRw, 10, 1, false},
      {kGy, 0, 4, false},
      {kGx, 0, 4, false},
      {kGw, 10, 1, false},
      {kBz, 0, 1, false},
      {kGz, 0, 4, false},
      {kBx, 0, 4, false},
      {kBw, 10, 1, false},
      {kBz, 1, 1, false},
      {kBy, 0, 4, false},
      {kRy, 0, 5, false},
      {kBz, 2, 1, false},
      {kRz, 0, 5, false},
      {kBz, 3, 1, false}}},
    {0x06, 11, {4, 5, 4}, true, true, {{kRw, 0, 10, false}, {kGw, 0, 10, false}, {kBw, 0, 10, false},
                                       {kRx, 0, 4, false},  {kRw, 10, 1, false}, {kGz, 4, 1, false},
                                       {kGy, 0, 4, false},  {kGx, 0, 5, false},  {kGw, 10, 1, false},
                                       {kGz, 0, 4, false},  {kBx, 0, 4, false},  {kBw, 10, 1, false},
                                       {kBz, 1, 1, false},  {kBy, 0, 4, false},  {kRy, 0, 4, false},
                                       {kBz, 0, 1, false},  {kBz, 2, 1, false},  {kRz, 0, 4, false},
                                       {kGy, 4, 1, false},  {kBz, 3, 1, false}}},
    {0x0a,
     11,
     {4, 4, 5},
     true,
     true,
     {{kRw, 0, 10, false},
      {kGw, 0, 10, false},
      {kBw, 0, 10, false},
      {kRx, 0, 4, false},
      {kRw, 10, 1, false},
      {kBy, 4, 1, false},
      {kGy, 0, 4, false},
      {kGx, 0, 4, false},
      {kGw, 10, 1, false},
      {kBz, 0, 1, false},
      {kGz, 0, 4, false},
      {kBx, 0, 5, false},
      {kBw, 10, 1, false},
      {kBy, 0, 4, false},
      {kRy, 0, 4, false},
      {kBz, 1, 2, false},
      {kRz, 0, 4, false},
      {kBz, 4, 1, false},
      {kBz, 3, 1, false}}},
    {0x0e,
     9,
     {5, 5, 5},
     true,
     true,
     {{kRw, 0, 9, false},
      {kBy, 4, 1, false},
      {kGw, 0, 9, false},
      {kGy, 4, 1, false},
      {kBw, 0, 9, false},
      {kBz, 4, 1, false},
      {kRx, 0, 5, false},
      {kGz, 4, 1, false},
      {kGy, 0, 4, false},
      {kGx, 0, 5, false},
      {kBz, 0, 1, false},
      {kGz, 0, 4, false},
      {kBx, 0, 5, false},
      {kBz, 1, 1, false},
      {kBy, 0, 4, false},
      {kRy, 0, 5, false},
      {kBz, 2, 1, false},
      {kRz, 0, 5, false},
      {kBz, 3, 1, false}}},
    {0x12,
     8,
     {6, 5, 5},
     true,
     true,
     {{kRw, 0, 8, false},
      {kGz, 4, 1, false},
      {kBy, 4, 1, false},
      {kGw, 0, 8, false},
      {kBz, 2, 1, false},
      {kGy, 4, 1, false},
      {kBw, 0, 8, false},
      {kBz, 3, 2, false},
      {kRx, 0, 6, false},
      {kGy, 0, 4, false},
      {kGx, 0, 5, false},
      {kBz, 0, 1, false},
      {kGz, 0, 4, false},
      {kBx, 0, 5, false},
      {kBz, 1, 1, false},
      {kBy, 0, 4, false},
      {kRy, 0, 6, false},
      {kRz, 0, 6, false}}},
    {0x16, 8, {5, 6, 5}, true, true, {{kRw, 0, 8, false}, {kBz, 0, 1, false}, {kBy, 4, 1, false}, {kGw, 0, 8, false},
                                      {kGy, 5, 1, false}, {kGy, 4, 1, false}, {kBw, 0, 8, false}, {kGz, 5, 1, false},
                                      {kBz, 4, 1, false}, {kRx, 0, 5, false}, {kGz, 4, 1, false}, {kGy, 0, 4, false},
                                      {kGx, 0, 6, false}, {kGz, 0, 4, false}, {kBx, 0, 5, false}, {kBz, 1, 1, false},
                                      {kBy, 0, 4, false}, {kRy, 0, 5, false}, {kBz, 2, 1, false}, {kRz, 0, 5, false},
                                      {kBz, 3, 1, false}}},
    {0x1a, 8, {5, 5, 6}, true, true, {{kRw, 0, 8, false}, {kBz, 1, 1, false}, {kBy, 4, 1, false}, {kGw, 0, 8, false},
                                      {kBy, 5, 1, false}, {kGy, 4, 1, false}, {kBw, 0, 8, false}, {kBz, 5, 1, false},
                                      {kBz, 4, 1, false}, {kRx, 0, 5, false}, {kGz, 4, 1, false}, {kGy, 0, 4, false},
                                      {kGx, 0, 5, false}, {kBz, 0, 1, false}, {kGz, 0, 4, false}, {kBx, 0, 6, false},
                                      {kBy, 0, 4, false}, {kRy, 0, 5, false}, {kBz, 2, 1, false}, {kRz, 0, 5, false},
                                      {kBz, 3, 1, false}}},
    {0x1e, 6, {6, 6, 6}, false, true, {{kRw, 0, 6, false}, {kGz, 4, 1, false}, {kBz, 0, 2, false}, {kBy, 4, 1, false},
                                       {kGw, 0, 6, false}, {kGy, 5, 1, false}, {kBy, 5, 1, false}, {kBz, 2, 1, false},
                                       {kGy, 4, 1, false}, {kBw, 0, 6, false}, {kGz, 5, 1, false}, {kBz, 3, 1, false},
                                       {kBz, 5, 1, false}, {kBz, 4, 1, false}, {kRx, 0, 6, false}, {kGy, 0, 4, false},
                                       {kGx, 0, 6, false}, {kGz, 0, 4, false}, {kBx, 0, 6, false}, {kBy, 0, 4, false},
                                       {kRy, 0, 6, false}, {kRz, 0, 6, false}}},
    {0x03,
     10,
     {10, 10, 10},
     false,
     false,
     {{kRw, 0, 10, false},
      {kGw, 0, 10, false},
      {kBw, 0, 10, false},
      {kRx, 0, 10, false},
      {kGx, 0, 10, false},
      {kBx, 0, 10, false}}},
    {0x07,
     11,
     {9, 9, 9},
     true,
     false,
     {{kRw, 0, 10, false},
      {kGw, 0, 10, false},
      {kBw, 0, 10, false},
      {kRx, 0, 9, false},
      {kRw, 10, 1, false},
      {kGx, 0, 9, false},
      {kGw, 10, 1, false},
      {kBx, 0, 9, false},
      {kBw, 10, 1, false}}},
    {0x0b,
     12,
     {8, 8, 8},
     true,
     false,
     {{kRw, 0, 10, false},
      {kGw, 0, 10, false},
      {kBw, 0, 10, false},
      {kRx, 0, 8, false},
      {kRw, 11, 2, true},
      {kGx, 0, 8, false},
      {kGw, 11, 2, true},
      {kBx, 0, 8, false},
      {kBw, 11, 2, true}}},
    {0x0f,
     16,
     {4, 4, 4},
     true,
     false,
     {{kRw, 0, 10, false},
      {kGw, 0, 10, false},
      {kBw, 0, 10, false},
      {kRx, 0, 4, false},
      {kRw, 15, 6, true},
      {kGx, 0, 4, false},
      {kGw, 15, 6, true},
      {kBx, 0, 4, false},
      {kBw, 15, 6, true}}},
};

/// Returns the mode of a block, or null for a reserved one. Modes 0 and 1 have markers of two bits, others of five.
const Mode* mode_of(uint64_t low) {
  const uint32_t marker = low & 2 ? low & 31 : low & 3;
  for (const Mode& mode : kModes) {
    if (mode.marker == marker) return &mode;
  }
  return nullptr;
}

/// The bits of a block from the lowest one on.
struct Bits {
  uint64_t low, high;

  uint32_t take(uint32_t count) {
    const uint32_t taken = static_cast<uint32_t>(low) & ((1u << count) - 1);
    low = low >> count | high << (64 - count);
    high >>= count;
    return taken;
  }
};

int32_t sign_extended(uint32_t bits, uint32_t count) {
  const uint32_t sign = 1u << (count - 1);
  return static_cast<int32_t>(bits ^ sign) - static_cast<int32_t>(sign);
}

/// Reads the endpoints of up to two subsets: [endpoint][channel].
template <bool kSigned>
void read_endpoints(const Mode& mode, Bits* bits, int32_t (&endpoint)[4][3]) {
  uint32_t value[12] = {};
  for (const Field* field = mode.fields; field->count > 0; ++field) {
    const uint32_t taken = bits->take(field->count);
    for (uint32_t k = 0; k < field->count; ++k) {
      const uint32_t bit = field->falling ? field->first - k : field->first + k;
      value[field->variable] |= (taken >> k & 1) << bit;
    }
  }
  const uint32_t mask = (1u << mode.precision) - 1;
  for (uint32_t i = 0; i < 12; ++i) {
    const uint32_t c = i % 3;
    uint32_t code = value[i];
    if (i >= 3 && mode.transformed) {
      code = (value[c] + static_cast<uint32_t>(sign_extended(code, mode.delta[c]))) & mask;
    }
    endpoint[i / 3][c] = kSigned ? sign_extended(code, mode.precision) : static_cast<int32_t>(code);
  }
}

/// Widens an endpoint to 16 bits, or to 15 bits and a sign.
template <bool kSigned>
int32_t unquantized(int32_t code, uint32_t precision) {
  if (!kSigned) {
    if (precision >= 15 || code == 0) return code;
    if (code == (1 << precision) - 1) return 0xffff;
    return ((code << 15) + 0x4000) >> (precision - 1);
  }
  if (precision >= 16) return code;
  const int32_t size = code < 0 ? -code : code;
  int32_t wide = ((size << 15) + 0x4000) >> (precision - 1);
  if (size == 0) wide = 0;
  if (size >= (1 << (precision - 1)) - 1) wide = 0x7fff;
  return code < 0 ? -wide : wide;
}

/// Scales an interpolated endpoint to the bits of a half.
template <bool kSigned>
uint16_t half_bits(int32_t value) {
  if (!kSigned) return static_cast<uint16_t>((value * 31) >> 6);
  const int32_t size = ((value < 0 ? -value : value) * 31) >> 5;
  return static_cast<uint16_t>(value < 0 && size != 0 ? 0x8000 | size : size);  // there is no negative zero
}

void write_black(uint8_t* texels, size_t pitch) {
  for (size_t y = 0; y < 4; ++y) std::memset(texels + y * pitch, 0, 32);
}

template <bool kSigned>
void decode(const uint8_t* block, uint8_t* texels, size_t pitch) {
  Bits bits = {bits_at<8>(block), bits_at<8>(block + 8)};
  const Mode* mode = mode_of(bits.low);
  if (!mode) return write_black(texels, pitch);
  bits.take(bits.low & 2 ? 5 : 2);
  int32_t endpoint[4][3];
  read_endpoints<kSigned>(*mode, &bits, endpoint);
  for (auto& point : endpoint) {
    for (int32_t& channel : point) channel = unquantized<kSigned>(channel, mode->precision);
  }
  const uint32_t partition = mode->two_subsets ? bits.take(5) : 0;
  const uint32_t width = mode->two_subsets ? 3 : 4;
  const uint64_t indices =
      mode->two_subsets ? whole_indices<3, 2>(bits.low, partition) : whole_indices<4, 1>(bits.low, 0);
  for (uint32_t i = 0; i < 16; ++i) {
    const uint32_t subset = mode->two_subsets ? kTwoSubsets[partition] >> (2 * i) & 3 : 0;
    const int32_t weight = kWeights[width - 2][indices >> (width * i) & ((1u << width) - 1)];
    uint16_t texel[4] = {};
    for (uint32_t c = 0; c < 3; ++c) {
      const int32_t a = endpoint[2 * subset][c], b = endpoint[2 * subset + 1][c];
      texel[c] = half_bits<kSigned>((a * (64 - weight) + b * weight + 32) >> 6);
    }
    std::memcpy(texels + i / 4 * pitch + i % 4 * sizeof texel, texel, sizeof texel);
  }
}

}  // namespace

void decode_bc6h_ufloat(const uint8_t* block, uint8_t* texels, size_t pitch) {
  decode<false>(block, texels, pitch);
}

void decode_bc6h_sfloat(const uint8_t* block, uint8_t* texels, size_t pitch) {
  decode<true>(block, texels, pitch);
}

}  // namespace shd::texture
