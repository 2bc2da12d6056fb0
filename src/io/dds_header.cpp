// SPDX-License-Identifier: MIT
#include "io/dds_header.h"

#include "core/failure.h"
#include "io/byte_reader.h"
#include "io/levels.h"

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

/// Where the pixels begin, and how they are stored.
struct Storage {
  size_t header = kHeader;
  size_t block = 0;   // bytes per 4 x 4 texels; 0 = plain pixels
  uint32_t bits = 0;  // per plain pixel
};

/// Throws Failure for an unknown storage.
Storage storage_of(ByteReader& in) {
  Storage storage;
  const uint32_t flags = in.u32(80);
  if (flags & kFourCcFlag) {
    storage.block = block_size(in, &storage.header);
    if (storage.block == 0) core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: unknown compression");
    return storage;
  }
  storage.bits = in.u32(88);
  const uint32_t bits = storage.bits;
  const bool known = (flags & kPlainFlags) != 0 && (bits == 8 || bits == 16 || bits == 24 || bits == 32);
  if (!known) core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: pixels of %u bits and flags 0x%x", bits, flags);
  return storage;
}

uint64_t byte_size(const Storage& storage, uint64_t width, uint64_t height) {
  if (storage.block) return (width + 3) / 4 * ((height + 3) / 4) * storage.block;
  return width * height * (storage.bits / 8);
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
  const Storage storage = storage_of(in);
  if (!in.has(storage.header, byte_size(storage, width, height))) core::refuse(SHD_ERROR_CORRUPT, "DDS: cut off");
}

uint32_t dds_whole_levels(const unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, false};
  const uint32_t width = in.u32(16), height = in.u32(12);
  const Storage storage = storage_of(in);
  const uint32_t full = full_level_count(width, height);
  uint64_t end = storage.header;
  uint32_t count = 0;
  for (; count < full; ++count) {
    const uint64_t level = byte_size(storage, level_side(width, count), level_side(height, count));
    if (!in.has(end, level)) break;
    end += level;
  }
  return count;
}

}  // namespace shd::io
