// SPDX-License-Identifier: MIT
// BC6H (BPTC): half floats as integers, interpolated linearly. The fourth channel is 0, as in formats of three
// channels.
#include <cstring>

#include "texture/format/bc/decode.h"
#include "texture/format/bc/partitions.h"

namespace shd::texture {
namespace {

/// Bits of a variable that follow each other in a block, from `first` up, or down if `falling`. Variable 3 e + c is
/// channel c of endpoint e.
struct Field {
  uint8_t variable, first, count;
  bool falling;
};

/// Bits of an endpoint, bits of the differences of each channel, and the fields after the marker. A count of 0 ends the
/// fields.
struct Bc6hMode {
  uint8_t marker, precision, delta[3];
  bool transformed, two_subsets;
  Field fields[27];
};

constexpr uint8_t read_number(const char** text) {
  uint8_t number = 0;
  for (; **text >= '0' && **text <= '9'; ++*text) number = static_cast<uint8_t>(10 * number + (**text - '0'));
  return number;
}

/// Returns a mode. Fields are written as in the specification: g2[4] is bit 4 of green of endpoint 2, r0[9:0] are bits
/// 0 to 9 with the lowest one first, and r0[10:11] are bits 10 and 11 with the highest one first.
constexpr Bc6hMode make_mode(uint8_t marker, uint8_t precision, uint8_t red, uint8_t green, uint8_t blue,
                             bool transformed, bool two_subsets, const char* text) {
  Bc6hMode made = {marker, precision, {red, green, blue}, transformed, two_subsets, {}};
  for (Field* field = made.fields; *text; ++field) {
    const int channel = *text == 'r' ? 0 : *text == 'g' ? 1 : 2;
    field->variable = static_cast<uint8_t>(3 * (text[1] - '0') + channel);
    text += 3;
    const uint8_t left = read_number(&text);
    if (*text == ':') ++text;
    const uint8_t right = *text == ']' ? left : read_number(&text);
    field->first = right;
    field->falling = left < right;
    field->count = static_cast<uint8_t>((left < right ? right - left : left - right) + 1);
    while (*text == ']' || *text == ' ') ++text;
  }
  return made;
}

/// Khronos Data Format Specification 1.3, 20.2, table of block formats.
constexpr Bc6hMode kBc6hModes[14] = {
    make_mode(0x00, 10, 5, 5, 5, true, true,
              "g2[4] b2[4] b3[4] r0[9:0] g0[9:0] b0[9:0] r1[4:0] g3[4] g2[3:0] g1[4:0] b3[0] g3[3:0] b1[4:0] b3[1] "
              "b2[3:0] r2[4:0] b3[2] r3[4:0] b3[3]"),
    make_mode(0x01, 7, 6, 6, 6, true, true,
              "g2[5] g3[5:4] r0[6:0] b3[1:0] b2[4] g0[6:0] b2[5] b3[2] g2[4] b0[6:0] b3[3] b3[5] b3[4] r1[5:0] "
              "g2[3:0] g1[5:0] g3[3:0] b1[5:0] b2[3:0] r2[5:0] r3[5:0]"),
    make_mode(0x02, 11, 5, 4, 4, true, true,
              "r0[9:0] g0[9:0] b0[9:0] r1[4:0] r0[10] g2[3:0] g1[3:0] g0[10] b3[0] g3[3:0] b1[3:0] b0[10] b3[1] "
              "b2[3:0] r2[4:0] b3[2] r3[4:0] b3[3]"),
    make_mode(0x06, 11, 4, 5, 4, true, true,
              "r0[9:0] g0[9:0] b0[9:0] r1[3:0] r0[10] g3[4] g2[3:0] g1[4:0] g0[10] g3[3:0] b1[3:0] b0[10] b3[1] "
              "b2[3:0] r2[3:0] b3[0] b3[2] r3[3:0] g2[4] b3[3]"),
    make_mode(0x0a, 11, 4, 4, 5, true, true,
              "r0[9:0] g0[9:0] b0[9:0] r1[3:0] r0[10] b2[4] g2[3:0] g1[3:0] g0[10] b3[0] g3[3:0] b1[4:0] b0[10] "
              "b2[3:0] r2[3:0] b3[2:1] r3[3:0] b3[4] b3[3]"),
    make_mode(0x0e, 9, 5, 5, 5, true, true,
              "r0[8:0] b2[4] g0[8:0] g2[4] b0[8:0] b3[4] r1[4:0] g3[4] g2[3:0] g1[4:0] b3[0] g3[3:0] b1[4:0] b3[1] "
              "b2[3:0] r2[4:0] b3[2] r3[4:0] b3[3]"),
    make_mode(0x12, 8, 6, 5, 5, true, true,
              "r0[7:0] g3[4] b2[4] g0[7:0] b3[2] g2[4] b0[7:0] b3[4:3] r1[5:0] g2[3:0] g1[4:0] b3[0] g3[3:0] "
              "b1[4:0] b3[1] b2[3:0] r2[5:0] r3[5:0]"),
    make_mode(0x16, 8, 5, 6, 5, true, true,
              "r0[7:0] b3[0] b2[4] g0[7:0] g2[5] g2[4] b0[7:0] g3[5] b3[4] r1[4:0] g3[4] g2[3:0] g1[5:0] g3[3:0] "
              "b1[4:0] b3[1] b2[3:0] r2[4:0] b3[2] r3[4:0] b3[3]"),
    make_mode(0x1a, 8, 5, 5, 6, true, true,
              "r0[7:0] b3[1] b2[4] g0[7:0] b2[5] g2[4] b0[7:0] b3[5] b3[4] r1[4:0] g3[4] g2[3:0] g1[4:0] b3[0] "
              "g3[3:0] b1[5:0] b2[3:0] r2[4:0] b3[2] r3[4:0] b3[3]"),
    make_mode(0x1e, 6, 6, 6, 6, false, true,
              "r0[5:0] g3[4] b3[1:0] b2[4] g0[5:0] g2[5] b2[5] b3[2] g2[4] b0[5:0] g3[5] b3[3] b3[5] b3[4] r1[5:0] "
              "g2[3:0] g1[5:0] g3[3:0] b1[5:0] b2[3:0] r2[5:0] r3[5:0]"),
    make_mode(0x03, 10, 10, 10, 10, false, false, "r0[9:0] g0[9:0] b0[9:0] r1[9:0] g1[9:0] b1[9:0]"),
    make_mode(0x07, 11, 9, 9, 9, true, false, "r0[9:0] g0[9:0] b0[9:0] r1[8:0] r0[10] g1[8:0] g0[10] b1[8:0] b0[10]"),
    make_mode(0x0b, 12, 8, 8, 8, true, false,
              "r0[9:0] g0[9:0] b0[9:0] r1[7:0] r0[10:11] g1[7:0] g0[10:11] b1[7:0] b0[10:11]"),
    make_mode(0x0f, 16, 4, 4, 4, true, false,
              "r0[9:0] g0[9:0] b0[9:0] r1[3:0] r0[10:15] g1[3:0] g0[10:15] b1[3:0] b0[10:15]"),
};

/// Returns the mode of a block, or null for a reserved one. Modes 0 and 1 have markers of two bits, others of five.
const Bc6hMode* mode_of(uint64_t low) {
  const uint32_t marker = low & 2 ? low & 31 : low & 3;
  for (const Bc6hMode& mode : kBc6hModes) {
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
void read_endpoints(const Bc6hMode& mode, Bits* bits, int32_t (&endpoint)[4][3]) {
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
  const Bc6hMode* mode = mode_of(bits.low);
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
