// SPDX-License-Identifier: MIT
// Compressed blocks in scalar code that reads bit by bit: the oracle of the decoders. Written from the Khronos Data
// Format Specification 1.3 (2020), chapters 18 to 20, and the Direct3D 11.3 functional specification, 19.5.
#pragma once

#include <math.h>
#include <stdint.h>
#include <string.h>

namespace ref {

/// Texels of a block: [row][column][channel]. Codes of 8 or 16 bits, bits of halves, or values, as the format has them.
struct BlockTexels {
  double value[4][4][4];
};

/// The bits of a block, from the lowest one of the first byte on.
struct BlockBits {
  const uint8_t* block;
  int at;

  int bit() {
    const int value = block[at / 8] >> at % 8 & 1;
    ++at;
    return value;
  }
  int bits(int count) {
    int value = 0;
    for (int i = 0; i < count; ++i) value |= bit() << i;
    return value;
  }
};

/// Rounds a quotient of whole numbers that are not negative to the nearest one; halves are rounded up.
inline int nearest(int sum, int divisor) {
  return static_cast<int>(floor(static_cast<double>(sum) / divisor + 0.5));
}

inline void rgb_565(int bits, int* rgb) {
  const int r = bits / 2048, g = bits / 32 % 64, b = bits % 32;
  rgb[0] = r * 8 + r / 4;
  rgb[1] = g * 4 + g / 16;
  rgb[2] = b * 8 + b / 4;
}

/// The colours of BC1 (`four_only` false), BC2 and BC3. `opaque`: the fourth of three colours is not transparent.
inline void color_block(const uint8_t* block, bool four_only, bool opaque, BlockTexels* out) {
  BlockBits in = {block, 0};
  const int first = in.bits(16), second = in.bits(16);
  int a[3], b[3];
  rgb_565(first, a);
  rgb_565(second, b);
  for (int i = 0; i < 16; ++i) {
    double* texel = out->value[i / 4][i % 4];
    const int index = in.bits(2);
    texel[3] = 255;
    for (int c = 0; c < 3; ++c) {
      if (index == 0) texel[c] = a[c];
      if (index == 1) texel[c] = b[c];
      if (four_only || first > second) {
        if (index == 2) texel[c] = nearest(2 * a[c] + b[c], 3);
        if (index == 3) texel[c] = nearest(a[c] + 2 * b[c], 3);
      } else {
        if (index == 2) texel[c] = nearest(a[c] + b[c], 2);
        if (index == 3) texel[c] = 0;
      }
    }
    if (!four_only && first <= second && index == 3 && !opaque) texel[3] = 0;
  }
}

/// The numerators of the values of a block of one channel, and their denominator: 5 or 7.
struct CodeSums {
  int sum[16], divisor;
};
inline CodeSums code_block(const uint8_t* block, bool is_signed, int low, int high) {
  BlockBits in = {block, 0};
  int a = in.bits(8), b = in.bits(8);
  if (is_signed) {
    a = a > 127 ? a - 256 : a;
    b = b > 127 ? b - 256 : b;
  }
  CodeSums out;
  out.divisor = a > b ? 7 : 5;
  if (a < -127) a = -127;
  if (b < -127) b = -127;
  for (int i = 0; i < 16; ++i) {
    const int index = in.bits(3);
    int sum;
    if (index == 0) {
      sum = out.divisor * a;
    } else if (index == 1) {
      sum = out.divisor * b;
    } else if (index > out.divisor) {
      sum = out.divisor * (index == 6 ? low : high);
    } else {
      sum = (out.divisor + 1 - index) * a + (index - 1) * b;
    }
    out.sum[i] = sum;
  }
  return out;
}

inline void bc3_alpha(const uint8_t* block, BlockTexels* out) {
  const CodeSums codes = code_block(block, false, 0, 255);
  for (int i = 0; i < 16; ++i) out->value[i / 4][i % 4][3] = nearest(codes.sum[i], codes.divisor);
}

inline void bc2_alpha(const uint8_t* block, BlockTexels* out) {
  BlockBits in = {block, 0};
  for (int i = 0; i < 16; ++i) out->value[i / 4][i % 4][3] = nearest(in.bits(4) * 255, 15);
}

/// A channel of BC4 or BC5: 16-bit codes, or floats if signed.
inline void code_channel(const uint8_t* block, bool is_signed, int channel, BlockTexels* out) {
  const CodeSums codes = is_signed ? code_block(block, true, -127, 127) : code_block(block, false, 0, 255);
  for (int i = 0; i < 16; ++i) {
    double* value = &out->value[i / 4][i % 4][channel];
    if (is_signed) {
      *value = static_cast<double>(static_cast<float>(codes.sum[i] / (codes.divisor * 127.0)));
    } else {
      *value = nearest(codes.sum[i] * 257, codes.divisor);
    }
  }
}

/// Subset of every texel, row by row, in partitions of two and of three subsets.
static const char* const kTwo[64] = {
    "0011001100110011", "0001000100010001", "0111011101110111", "0001001100110111", "0000000100010011",
    "0011011101111111", "0001001101111111", "0000000100110111", "0000000000010011", "0011011111111111",
    "0000000101111111", "0000000000010111", "0001011111111111", "0000000011111111", "0000111111111111",
    "0000000000001111", "0000100011101111", "0111000100000000", "0000000010001110", "0111001100010000",
    "0011000100000000", "0000100011001110", "0000000010001100", "0111001100110001", "0011000100010000",
    "0000100010001100", "0110011001100110", "0011011001101100", "0001011111101000", "0000111111110000",
    "0111000110001110", "0011100110011100", "0101010101010101", "0000111100001111", "0101101001011010",
    "0011001111001100", "0011110000111100", "0101010110101010", "0110100101101001", "0101101010100101",
    "0111001111001110", "0001001111001000", "0011001001001100", "0011101111011100", "0110100110010110",
    "0011110011000011", "0110011010011001", "0000011001100000", "0100111001000000", "0010011100100000",
    "0000001001110010", "0000010011100100", "0110110010010011", "0011011011001001", "0110001110011100",
    "0011100111000110", "0110110011001001", "0110001100111001", "0111111010000001", "0001100011100111",
    "0000111100110011", "0011001111110000", "0010001011101110", "0100010001110111",
};
static const char* const kThree[64] = {
    "0011001102212222", "0001001122112221", "0000200122112211", "0222002200110111", "0000000011221122",
    "0011001100220022", "0022002211111111", "0011001122112211", "0000000011112222", "0000111111112222",
    "0000111122222222", "0012001200120012", "0112011201120112", "0122012201220122", "0011011211221222",
    "0011200122002220", "0001001101121122", "0111001120012200", "0000112211221122", "0022002200221111",
    "0111011102220222", "0001000122212221", "0000001101220122", "0000110022102210", "0122012200110000",
    "0012001211222222", "0110122112210110", "0000011012211221", "0022110211020022", "0110011020022222",
    "0011012201220011", "0000200022112221", "0000000211221222", "0222002200120011", "0011001200220222",
    "0120012001200120", "0000111122220000", "0120120120120120", "0120201212010120", "0011220011220011",
    "0011112222000011", "0101010122222222", "0000000021212121", "0022112200221122", "0022001100220011",
    "0220122102201221", "0101222222220101", "0000212121212121", "0101010101012222", "0222011102220111",
    "0002111200021112", "0000211221122112", "0222011101110222", "0002111211120002", "0110011001102222",
    "0000000021122112", "0110011022222222", "0022001100110022", "0022112211220022", "0000000000002112",
    "0002000100020001", "0222122202221222", "0101222222222222", "0111201122012220",
};

/// The texel of a subset whose index lacks its highest bit: KDFS 1.3, tables of anchor indices.
inline int anchor_of(int subsets, int partition, int subset) {
  static const int two[64] = {15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 2,  8, 2, 2, 8,
                              8,  15, 2,  8,  2,  2,  8,  8,  2,  2,  15, 15, 6,  8,  2,  8,  15, 15, 2, 8, 2, 2,
                              2,  15, 15, 6,  6,  2,  6,  8,  15, 15, 2,  2,  15, 15, 15, 15, 15, 2,  2, 15};
  static const int three[2][64] = {
      {3,  3,  15, 15, 8, 3,  15, 15, 8,  8,  6, 6,  6, 5,  3, 3,  3,  3,  8,  15, 3,  3,
       6,  10, 5,  8,  8, 6,  8,  5,  15, 15, 8, 15, 3, 5,  6, 10, 8,  15, 15, 3,  15, 5,
       15, 15, 15, 15, 3, 15, 5,  5,  5,  8,  5, 10, 5, 10, 8, 13, 15, 12, 3,  3},
      {15, 8, 8, 3,  15, 15, 3,  8,  15, 15, 15, 15, 15, 15, 15, 8,  15, 8,  15, 3,  15, 8,
       15, 8, 3, 15, 6,  10, 15, 15, 10, 8,  15, 3,  15, 10, 10, 8,  9,  10, 6,  15, 8,  15,
       3,  6, 6, 8,  15, 3,  15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 3,  15, 15, 8}};
  if (subset == 0) return 0;
  return subsets == 2 ? two[partition] : three[subset - 1][partition];
}

inline int bptc_weight(int bits, int index) {
  static const int two[] = {0, 21, 43, 64}, three[] = {0, 9, 18, 27, 37, 46, 55, 64},
                   four[] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};
  return bits == 2 ? two[index] : bits == 3 ? three[index] : four[index];
}

inline int subset_of(int subsets, int partition, int texel) {
  if (subsets == 1) return 0;
  return (subsets == 2 ? kTwo : kThree)[partition][texel] - '0';
}

/// Reads the index of every texel.
inline void read_indices(BlockBits* in, int bits, int subsets, int partition, int* index) {
  for (int i = 0; i < 16; ++i) {
    const bool anchor = anchor_of(subsets, partition, subset_of(subsets, partition, i)) == i;
    index[i] = in->bits(anchor ? bits - 1 : bits);
  }
}

inline int replicated(int code, int bits) {
  double exact = 0;  // the bits of the code repeat without end; the first eight count
  for (int k = 0; k < 8; ++k) exact = exact * 2 + (code >> (bits - 1 - k % bits) & 1);
  return static_cast<int>(exact);
}

inline void bc7_block(const uint8_t* block, BlockTexels* out) {
  static const int fields[8][10] = {// subsets, partition, rotation, selection, colour, alpha, P-bits, shared, indices
                                    {3, 4, 0, 0, 4, 0, 1, 0, 3, 0}, {2, 6, 0, 0, 6, 0, 0, 1, 3, 0},
                                    {3, 6, 0, 0, 5, 0, 0, 0, 2, 0}, {2, 6, 0, 0, 7, 0, 1, 0, 2, 0},
                                    {1, 0, 2, 1, 5, 6, 0, 0, 2, 3}, {1, 0, 2, 0, 7, 8, 0, 0, 2, 2},
                                    {1, 0, 0, 0, 7, 7, 1, 0, 4, 0}, {2, 6, 0, 0, 5, 5, 1, 0, 2, 0}};
  memset(out, 0, sizeof *out);
  BlockBits in = {block, 0};
  int mode = 0;
  while (mode < 8 && !in.bit()) ++mode;
  if (mode == 8) return;
  const int* f = fields[mode];
  const int subsets = f[0], partition = in.bits(f[1]), rotation = in.bits(f[2]), selection = in.bits(f[3]);
  int end[3][2][4];
  for (int c = 0; c < 4; ++c) {
    for (int s = 0; s < subsets; ++s) {
      for (int e = 0; e < 2; ++e) end[s][e][c] = in.bits(c < 3 ? f[4] : f[5]);
    }
  }
  int p[3][2] = {};
  for (int s = 0; s < subsets; ++s) {
    if (f[7]) p[s][0] = p[s][1] = in.bit();
    for (int e = 0; e < 2 && f[6]; ++e) p[s][e] = in.bit();
  }
  for (int s = 0; s < subsets; ++s) {
    for (int e = 0; e < 2; ++e) {
      for (int c = 0; c < 4; ++c) {
        int bits = c < 3 ? f[4] : f[5];
        int* code = &end[s][e][c];
        if (bits == 0) {
          *code = 255;
          continue;
        }
        if (f[6] || f[7]) {
          *code = 2 * *code + p[s][e];
          ++bits;
        }
        *code = replicated(*code, bits);
      }
    }
  }
  int first[16], second[16];
  read_indices(&in, f[8], subsets, partition, first);
  if (f[9]) read_indices(&in, f[9], 1, 0, second);
  for (int i = 0; i < 16; ++i) {
    const auto& pair = end[subset_of(subsets, partition, i)];
    const int a = bptc_weight(f[8], first[i]), b = f[9] ? bptc_weight(f[9], second[i]) : a;
    double* texel = out->value[i / 4][i % 4];
    for (int c = 0; c < 4; ++c) {
      const int weight = (c < 3) != (selection == 1) ? a : b;
      texel[c] = ((64 - weight) * pair[0][c] + weight * pair[1][c] + 32) / 64;
    }
    if (rotation > 0) {
      const double alpha = texel[3];
      texel[3] = texel[rotation - 1];
      texel[rotation - 1] = alpha;
    }
  }
}

/// A mode of BC6H: its marker, bits of an endpoint and of the differences of r, g and b, whether endpoints are
/// differences, subsets, and the order of the bits after the marker, from the lowest on. "gy4" is bit 4 of the green of
/// the third endpoint (w, x, y, z), "rw0-9" are ten bits, "rw15-10" six in falling order.
struct HalfMode {
  int marker, precision, delta[3];
  bool differences;
  int subsets;
  const char* bits;
};
static const HalfMode kHalfModes[14] = {
    {0,
     10,
     {5, 5, 5},
     true,
     2,
     "gy4 by4 bz4 rw0-9 gw0-9 bw0-9 rx0-4 gz4 gy0-3 gx0-4 bz0 gz0-3 bx0-4 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {1,
     7,
     {6, 6, 6},
     true,
     2,
     "gy5 gz4 gz5 rw0-6 bz0 bz1 by4 gw0-6 by5 bz2 gy4 bw0-6 bz3 bz5 bz4 rx0-5 gy0-3 gx0-5 gz0-3 bx0-5 by0-3 ry0-5 "
     "rz0-5"},
    {2,
     11,
     {5, 4, 4},
     true,
     2,
     "rw0-9 gw0-9 bw0-9 rx0-4 rw10 gy0-3 gx0-3 gw10 bz0 gz0-3 bx0-3 bw10 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {6,
     11,
     {4, 5, 4},
     true,
     2,
     "rw0-9 gw0-9 bw0-9 rx0-3 rw10 gz4 gy0-3 gx0-4 gw10 gz0-3 bx0-3 bw10 bz1 by0-3 ry0-3 bz0 bz2 rz0-3 gy4 bz3"},
    {10,
     11,
     {4, 4, 5},
     true,
     2,
     "rw0-9 gw0-9 bw0-9 rx0-3 rw10 by4 gy0-3 gx0-3 gw10 bz0 gz0-3 bx0-4 bw10 by0-3 ry0-3 bz1 bz2 rz0-3 bz4 bz3"},
    {14,
     9,
     {5, 5, 5},
     true,
     2,
     "rw0-8 by4 gw0-8 gy4 bw0-8 bz4 rx0-4 gz4 gy0-3 gx0-4 bz0 gz0-3 bx0-4 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {18,
     8,
     {6, 5, 5},
     true,
     2,
     "rw0-7 gz4 by4 gw0-7 bz2 gy4 bw0-7 bz3 bz4 rx0-5 gy0-3 gx0-4 bz0 gz0-3 bx0-4 bz1 by0-3 ry0-5 rz0-5"},
    {22,
     8,
     {5, 6, 5},
     true,
     2,
     "rw0-7 bz0 by4 gw0-7 gy5 gy4 bw0-7 gz5 bz4 rx0-4 gz4 gy0-3 gx0-5 gz0-3 bx0-4 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {26,
     8,
     {5, 5, 6},
     true,
     2,
     "rw0-7 bz1 by4 gw0-7 by5 gy4 bw0-7 bz5 bz4 rx0-4 gz4 gy0-3 gx0-4 bz0 gz0-3 bx0-5 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {30,
     6,
     {6, 6, 6},
     false,
     2,
     "rw0-5 gz4 bz0 bz1 by4 gw0-5 gy5 by5 bz2 gy4 bw0-5 gz5 bz3 bz5 bz4 rx0-5 gy0-3 gx0-5 gz0-3 bx0-5 by0-3 ry0-5 "
     "rz0-5"},
    {3, 10, {10, 10, 10}, false, 1, "rw0-9 gw0-9 bw0-9 rx0-9 gx0-9 bx0-9"},
    {7, 11, {9, 9, 9}, true, 1, "rw0-9 gw0-9 bw0-9 rx0-8 rw10 gx0-8 gw10 bx0-8 bw10"},
    {11, 12, {8, 8, 8}, true, 1, "rw0-9 gw0-9 bw0-9 rx0-7 rw11-10 gx0-7 gw11-10 bx0-7 bw11-10"},
    {15, 16, {4, 4, 4}, true, 1, "rw0-9 gw0-9 bw0-9 rx0-3 rw15-10 gx0-3 gw15-10 bx0-3 bw15-10"},
};

inline int signed_code(int code, int bits) {
  return code >= 1 << (bits - 1) ? code - (1 << bits) : code;
}

/// Reads the fields of HalfMode::bits into endpoint[e][c].
inline void read_half_fields(const char* fields, BlockBits* in, int (*endpoint)[3]) {
  for (const char* at = fields; *at;) {
    const int c = *at == 'r' ? 0 : *at == 'g' ? 1 : 2, e = at[1] == 'w' ? 0 : at[1] - 'x' + 1;
    int first = 0, last;
    for (at += 2; *at >= '0' && *at <= '9'; ++at) first = 10 * first + *at - '0';
    last = first;
    if (*at == '-') {
      last = 0;
      for (++at; *at >= '0' && *at <= '9'; ++at) last = 10 * last + *at - '0';
    }
    for (int bit = first;; bit += first < last ? 1 : -1) {
      endpoint[e][c] |= in->bit() << bit;
      if (bit == last) break;
    }
    if (*at == ' ') ++at;
  }
}

inline int widened(int code, int bits, bool is_signed) {
  if (!is_signed) {
    if (bits >= 15 || code == 0) return code;
    return code == (1 << bits) - 1 ? 0xffff : (code * 65536 + 0x8000) >> bits;
  }
  if (bits >= 16 || code == 0) return code;
  const int size = code < 0 ? -code : code;
  const int wide = size >= (1 << (bits - 1)) - 1 ? 0x7fff : (size * 32768 + 0x4000) >> (bits - 1);
  return code < 0 ? -wide : wide;
}

inline void bc6h_block(const uint8_t* block, bool is_signed, BlockTexels* out) {
  memset(out, 0, sizeof *out);
  BlockBits in = {block, 0};
  int marker = in.bits(2);
  if (marker >= 2) marker += in.bits(3) * 4;
  const HalfMode* mode = nullptr;
  for (const HalfMode& m : kHalfModes) {
    if (m.marker == marker) mode = &m;
  }
  if (!mode) return;
  int end[4][3] = {};
  read_half_fields(mode->bits, &in, end);
  for (int c = 0; c < 3; ++c) {
    const int base = end[0][c];
    for (int e = 0; e < 2 * mode->subsets; ++e) {
      int code = end[e][c];
      if (e > 0 && mode->differences) code = (base + signed_code(code, mode->delta[c])) & ((1 << mode->precision) - 1);
      if (is_signed) code = signed_code(code, mode->precision);
      end[e][c] = widened(code, mode->precision, is_signed);
    }
  }
  const int partition = mode->subsets == 2 ? in.bits(5) : 0, bits = mode->subsets == 2 ? 3 : 4;
  int index[16];
  read_indices(&in, bits, mode->subsets, partition, index);
  for (int i = 0; i < 16; ++i) {
    const int s = subset_of(mode->subsets, partition, i), w = bptc_weight(bits, index[i]);
    for (int c = 0; c < 3; ++c) {
      const int sum = end[2 * s][c] * (64 - w) + end[2 * s + 1][c] * w + 32;
      const auto value = static_cast<int>(floor(sum / 64.0));
      const int size = is_signed ? (value < 0 ? -value : value) * 31 / 32 : value * 31 / 64;
      out->value[i / 4][i % 4][c] = value < 0 && size > 0 ? 0x8000 + size : size;
    }
  }
}

}  // namespace ref
