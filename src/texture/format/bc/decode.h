// SPDX-License-Identifier: MIT
/// @file
/// Contract of format/bc/: decoders of compressed blocks of 4 x 4 texels.
///
/// A decoder turns a block into texels of another format, whose consumers run unchanged. A format of blocks therefore
/// adds a decoder and no kernels. store/bc/ and store/tiles/ keep decoded texels for lookups.
///
/// | format            | decoded texel               | values                                                |
/// |-------------------|-----------------------------|-------------------------------------------------------|
/// | BC1, BC2, BC3     | RGBA8 or RGBA8_SRGB         | endpoints by replication of bits; thirds, fifths and  |
/// |                   |                             | sevenths rounded to the nearest code                  |
/// | BC4, BC5          | R16, RG16                   | fifths and sevenths rounded to the nearest code       |
/// | BC4, BC5 _SNORM   | R32F, RG32F                 | fifths and sevenths rounded to the nearest float;     |
/// |                   |                             | the code -128 is -127                                 |
/// | BC6H              | RGBA16F, alpha 0            | exact; reserved modes are black                       |
/// | BC7               | RGBA8 or RGBA8_SRGB         | exact; reserved modes are transparent black           |
///
/// The definitions are those of the Khronos Data Format Specification 1.3 (2020), chapters 18 (S3TC), 19 (RGTC) and
/// 20 (BPTC), and of the Direct3D 11.3 functional specification, 19.5. They leave the rounding of BC1 to BC5 open.
/// Decoders use integers, or one correctly rounded division, so their bits are the same everywhere. Every bit pattern
/// of a block is valid.
///
/// | file               | contents                                                             |
/// |--------------------|----------------------------------------------------------------------|
/// | decode.h, .cpp     | the decoders, by format                                              |
/// | s3tc.cpp, rgtc.cpp | BC1, BC2, BC3; BC4, BC5                                              |
/// | bc6h.cpp, bc7.h, .cpp | BC6H; BC7                                                          |
/// | partitions.h       | subsets, anchors and weights of BC6H and BC7                         |
/// | codes.h            | palettes of eight codes, of BC3, BC4 and BC5                         |
/// | kernels.h, .cpp    | BC1 and BC7 with the vectors of each target                          |
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "texture/texture.h"

namespace shd::texture {

/// Returns the decoder of a format of blocks.
DecodeBc decoder_of(shd_format format);

void decode_bc1_rgb(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc1_rgba(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc2(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc3(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc4(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc4_snorm(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc5(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc5_snorm(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc6h_ufloat(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc6h_sfloat(const uint8_t* block, uint8_t* texels, size_t pitch);
void decode_bc7(const uint8_t* block, uint8_t* texels, size_t pitch);

/// Returns kSize bytes of a block, the first one in the lowest bits. gcc 12 makes slow vectors of a loop over bytes.
template <size_t kSize>
uint64_t bits_at(const uint8_t* bytes) {
  static_assert(kSize == 4 || kSize == 8, "a word");
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "as blocks are");
  if constexpr (kSize == 4) {
    uint32_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
  } else {
    uint64_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
  }
}

}  // namespace shd::texture
