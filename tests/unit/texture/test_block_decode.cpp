// SPDX-License-Identifier: MIT
// The decoders of compressed blocks against the oracle, on random blocks of every mode, and against known blocks.
#include "support/check.h"
#include "support/targets.h"

#include <stdlib.h>
#include <string.h>

#include "image/format.h"
#include "ref/block_ref.h"
#include "texture/format/bc/decode.h"
#include "texture/format/bc/kernels.h"
#include "texture/format/bc/partitions.h"

namespace {

constexpr size_t kBlocks = 1000000;

struct Random {
  uint64_t state;
  uint64_t next() {  // splitmix64: Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (2014)
    uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
};

void oracle(shd_format format, const uint8_t* block, ref::BlockTexels* out) {
  memset(out, 0, sizeof *out);
  switch (format) {
    case SHD_FORMAT_BC1_RGB: return ref::color_block(block, false, true, out);
    case SHD_FORMAT_BC1_RGBA: return ref::color_block(block, false, false, out);
    case SHD_FORMAT_BC2: ref::color_block(block + 8, true, false, out); return ref::bc2_alpha(block, out);
    case SHD_FORMAT_BC3: ref::color_block(block + 8, true, false, out); return ref::bc3_alpha(block, out);
    case SHD_FORMAT_BC4: return ref::code_channel(block, false, 0, out);
    case SHD_FORMAT_BC4_SNORM: return ref::code_channel(block, true, 0, out);
    case SHD_FORMAT_BC5: ref::code_channel(block, false, 0, out); return ref::code_channel(block + 8, false, 1, out);
    case SHD_FORMAT_BC5_SNORM:
      ref::code_channel(block, true, 0, out);
      return ref::code_channel(block + 8, true, 1, out);
    case SHD_FORMAT_BC6H_UFLOAT: return ref::bc6h_block(block, false, out);
    case SHD_FORMAT_BC6H_SFLOAT: return ref::bc6h_block(block, true, out);
    default: return ref::bc7_block(block, out);
  }
}

double stored_number(const uint8_t* texel, size_t channel, shd::image::Component component) {
  uint16_t half;
  float real;
  switch (component) {
    case shd::image::Component::kUnorm16:
    case shd::image::Component::kFloat16: memcpy(&half, texel + 2 * channel, 2); return half;
    case shd::image::Component::kFloat32: memcpy(&real, texel + 4 * channel, 4); return static_cast<double>(real);
    default: return texel[channel];
  }
}

/// Decodes to rows with a gap, which must stay as it is.
void check_block(shd_format format, const uint8_t* block) {
  constexpr size_t kPitch = 4 * 8 + 5;
  uint8_t texels[4 * kPitch], other[4 * kPitch];
  memset(texels, 0xa5, sizeof texels);
  memset(other, 0xa5, sizeof other);
  const shd::texture::DecodeBc decode = shd::texture::decoder_of(format);
  decode(block, texels, kPitch);
  for (const int64_t bit : shd::tests::target_bits()) {
    const auto kernel = shd::texture::kernel_of(decode, shd::core::simd_target_from_bit(bit));
    if (kernel == decode) continue;
    kernel(block, other, kPitch);
    if (memcmp(texels, other, sizeof texels) != 0)
      fail_msg("format %d: target %lld differs", format, static_cast<long long>(bit));
  }
  ref::BlockTexels wanted;
  oracle(format, block, &wanted);
  const shd::image::BlockInfo info = shd::image::block_info(format);
  const size_t size = shd::image::format_info(info.stored, info.component).pixel_size;
  for (size_t y = 0; y < 4; ++y) {
    for (size_t x = 0; x < 4; ++x) {
      for (size_t c = 0; c < info.stored; ++c) {
        const double got = stored_number(texels + y * kPitch + x * size, c, info.component);
        if (got == wanted.value[y][x][c]) continue;
        uint64_t words[2] = {};
        memcpy(words, block, info.block_size);
        fail_msg("format %d block %016llx %016llx texel %zu %zu channel %zu: %g, not %g", format,
                 static_cast<unsigned long long>(words[0]), static_cast<unsigned long long>(words[1]), x, y, c, got,
                 wanted.value[y][x][c]);
      }
    }
    for (size_t i = 4 * size; i < kPitch; ++i) assert_int_equal(texels[y * kPitch + i], 0xa5);
  }
}

void test_random_blocks(void** state) {
  const auto format = *static_cast<const shd_format*>(*state);
  Random random{static_cast<uint64_t>(format)};
  uint8_t block[16];
  for (size_t i = 0; i < kBlocks; ++i) {
    const uint64_t words[2] = {random.next(), random.next()};
    memcpy(block, words, sizeof block);
    if (i % 8 == 1) memset(block, block[2] % 3 - 1, 2);  // equal or extreme endpoints
    check_block(format, block);
  }
}

/// Every mode in equal numbers: random blocks seldom have the high ones.
void test_bc7_modes(void**) {
  Random random{7};
  uint8_t block[16];
  for (size_t i = 0; i < kBlocks; ++i) {
    const uint64_t words[2] = {random.next(), random.next()};
    memcpy(block, words, sizeof block);
    const size_t mode = i % 9;
    block[0] = static_cast<uint8_t>(mode == 8 ? 0 : (block[0] | 1) << mode);
    check_block(SHD_FORMAT_BC7, block);
  }
}

void test_bc6h_modes(void**) {
  Random random{6};
  uint8_t block[16];
  for (size_t i = 0; i < kBlocks; ++i) {
    const uint64_t words[2] = {random.next(), random.next()};
    memcpy(block, words, sizeof block);
    block[0] = static_cast<uint8_t>((block[0] & 0xe0) | i % 32);
    check_block(i % 64 < 32 ? SHD_FORMAT_BC6H_UFLOAT : SHD_FORMAT_BC6H_SFLOAT, block);
  }
}

/// Every pair of endpoints of a block of codes, with every index.
void test_all_codes(void**) {
  uint8_t block[8] = {0, 0, 0x88, 0xc6, 0xfa, 0x88, 0xc6, 0xfa};  // indices 0..7 twice
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      block[0] = static_cast<uint8_t>(a);
      block[1] = static_cast<uint8_t>(b);
      check_block(SHD_FORMAT_BC4, block);
      check_block(SHD_FORMAT_BC4_SNORM, block);
    }
  }
}

/// Values that were computed by hand from the specification.
void test_known_blocks(void**) {
  uint32_t color[16];
  const uint8_t red_blue[8] = {0x00, 0xf8, 0x1f, 0x00, 0xe4, 0xe4, 0xe4, 0xe4};  // red > blue: four colours
  shd::texture::decode_bc1_rgba(red_blue, reinterpret_cast<uint8_t*>(color), 16);
  assert_int_equal(color[0], 0xff0000ff);
  assert_int_equal(color[1], 0xffff0000);
  assert_int_equal(color[2], 0xff5500aa);
  assert_int_equal(color[3], 0xffaa0055);
  const uint8_t blue_red[8] = {0x1f, 0x00, 0x00, 0xf8, 0xe4, 0xe4, 0xe4, 0xe4};  // three colours
  shd::texture::decode_bc1_rgba(blue_red, reinterpret_cast<uint8_t*>(color), 16);
  assert_int_equal(color[2], 0xff800080);
  assert_int_equal(color[3], 0);
  shd::texture::decode_bc1_rgb(blue_red, reinterpret_cast<uint8_t*>(color), 16);
  assert_int_equal(color[3], 0xff000000);

  float height[16];
  const uint8_t extreme[8] = {0x80, 0x7f, 0x88, 0xc6, 0xfa, 0x88, 0xc6, 0xfa};  // -128 < 127: fifths
  shd::texture::decode_bc4_snorm(extreme, reinterpret_cast<uint8_t*>(height), 16);
  assert_true(height[0] == -1.0f && height[1] == 1.0f && height[6] == -1.0f && height[7] == 1.0f);
  assert_true(height[2] == -0.6f);

  uint8_t mode6[16] = {0x40};  // endpoints 0 and 0 with P-bits 0
  shd::texture::decode_bc7(mode6, reinterpret_cast<uint8_t*>(color), 16);
  assert_int_equal(color[5], 0);
  memset(mode6 + 1, 0xff, 15);
  mode6[0] = 0xc0;
  shd::texture::decode_bc7(mode6, reinterpret_cast<uint8_t*>(color), 16);
  assert_int_equal(color[5], 0xffffffff);
}

/// Properties that the specification states: texel 0 is in subset 0, each anchor lies in its subset.
void test_partitions(void**) {
  using namespace shd::texture;
  for (uint32_t p = 0; p < 64; ++p) {
    uint32_t seen[2] = {0, 0};
    for (uint32_t i = 0; i < 16; ++i) {
      seen[0] |= 1u << (kTwoSubsets[p] >> (2 * i) & 3);
      seen[1] |= 1u << (kThreeSubsets[p] >> (2 * i) & 3);
    }
    assert_int_equal(seen[0], 3);
    assert_int_equal(seen[1], 7);
    assert_int_equal(kTwoSubsets[p] & 3, 0);
    assert_int_equal(kThreeSubsets[p] & 3, 0);
    assert_int_equal(kTwoSubsets[p] >> (2 * kAnchorOfTwo[p]) & 3, 1);
    assert_int_equal(kThreeSubsets[p] >> (2 * kAnchorsOfThree[0][p]) & 3, 1);
    assert_int_equal(kThreeSubsets[p] >> (2 * kAnchorsOfThree[1][p]) & 3, 2);
    for (uint32_t q = 0; q < p; ++q) {
      assert_true(kTwoSubsets[p] != kTwoSubsets[q] && kThreeSubsets[p] != kThreeSubsets[q]);
    }
  }
}

shd_format t_formats[] = {SHD_FORMAT_BC1_RGB, SHD_FORMAT_BC1_RGBA,    SHD_FORMAT_BC2,        SHD_FORMAT_BC3,
                          SHD_FORMAT_BC4,     SHD_FORMAT_BC4_SNORM,   SHD_FORMAT_BC5,        SHD_FORMAT_BC5_SNORM,
                          SHD_FORMAT_BC7,     SHD_FORMAT_BC6H_UFLOAT, SHD_FORMAT_BC6H_SFLOAT};

}  // namespace

int main() {
  constexpr size_t kFormatCount = sizeof t_formats / sizeof *t_formats;
  CMUnitTest tests[kFormatCount + 5] = {cmocka_unit_test(test_known_blocks), cmocka_unit_test(test_partitions),
                                        cmocka_unit_test(test_all_codes), cmocka_unit_test(test_bc7_modes),
                                        cmocka_unit_test(test_bc6h_modes)};
  for (size_t i = 0; i < kFormatCount; ++i) tests[5 + i] = cmocka_unit_test_prestate(test_random_blocks, &t_formats[i]);
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
