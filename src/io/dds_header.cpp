// SPDX-License-Identifier: MIT
#include "io/dds_header.h"

#include "core/failure.h"
#include "io/byte_reader.h"

namespace shd::io {

namespace {

constexpr size_t kHeader = 128;
constexpr size_t kHeaderDx10 = 148;
constexpr uint32_t kDepthFlag = 0x800000;
constexpr uint32_t kFourCcFlag = 0x4;
constexpr uint32_t kPlainFlags = 0x1 | 0x2 | 0x40 | 0x200 | 0x20000;  // alpha, rgb, yuv, luminance
constexpr uint32_t kCubeOrVolume = 0x200 | 0x200000;

struct BlockFormat {
  const char* four_cc;
  size_t block_size;  // bytes per 4 x 4 texels
};
constexpr BlockFormat kBlockFormats[] = {
    {"DXT1", 8}, {"DXT2", 16}, {"DXT3", 16}, {"DXT4", 16}, {"DXT5", 16}, {"ATI1", 8},
    {"BC4U", 8}, {"BC4S", 8},  {"ATI2", 16}, {"BC5U", 16}, {"BC5S", 16}, {"RXGB", 16},
};

/// Bytes of a 4 x 4 block of a DXGI format; 0 if the format is not block-compressed.
size_t dxgi_block_size(uint32_t dxgi) {
  if ((dxgi >= 70 && dxgi <= 72) || (dxgi >= 79 && dxgi <= 81)) return 8;                                 // BC1, BC4
  if ((dxgi >= 73 && dxgi <= 78) || (dxgi >= 82 && dxgi <= 84) || (dxgi >= 94 && dxgi <= 99)) return 16;  // others
  return 0;
}

size_t block_size(ByteReader& in, size_t* header) {
  if (in.is(84, "DX10", 4)) {
    *header = kHeaderDx10;
    return dxgi_block_size(in.u32(kHeader));
  }
  for (const BlockFormat& row : kBlockFormats) {
    if (in.is(84, row.four_cc, 4)) return row.block_size;
  }
  return 0;
}

}  // namespace

void check_dds_header(const unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, false};
  if (in.u32(4) != 124 || in.u32(76) != 32 || !in.has(0, kHeader)) core::refuse(SHD_ERROR_CORRUPT, "DDS: bad header");
  const uint64_t height = in.u32(12);
  const uint64_t width = in.u32(16);
  if ((in.u32(112) & kCubeOrVolume) || ((in.u32(8) & kDepthFlag) && in.u32(24) > 1)) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: cube maps and volumes are not supported");
  }
  if (in.u32(28) > 32) core::refuse(SHD_ERROR_CORRUPT, "DDS: %u levels", in.u32(28));
  size_t header = kHeader;
  uint64_t needed = 0;
  const uint32_t flags = in.u32(80);
  if (flags & kFourCcFlag) {
    const size_t block = block_size(in, &header);
    if (block == 0) core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: unknown compression");
    needed = (width + 3) / 4 * ((height + 3) / 4) * block;
  } else {
    const uint32_t bits = in.u32(88);
    const bool known = (flags & kPlainFlags) != 0 && (bits == 8 || bits == 16 || bits == 24 || bits == 32);
    if (!known) core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: pixels of %u bits and flags 0x%x", bits, flags);
    needed = width * height * (bits / 8);
  }
  if (!in.has(header, needed)) core::refuse(SHD_ERROR_CORRUPT, "DDS: cut off");
}

}  // namespace shd::io
