// SPDX-License-Identifier: MIT
#include "io/check/bmp_header.h"

#include "core/failure.h"
#include "io/file/byte_reader.h"

namespace shd::io {

namespace {

constexpr uint64_t kFileHeader = 14;
constexpr uint32_t kCoreHeader = 12;
constexpr uint32_t kBitFields = 3;

/// Layout of the pixels, read from the header.
struct BmpLayout {
  uint64_t width, height;
  uint32_t bits;
  uint64_t colors;      // number of palette entries
  uint64_t color_size;  // bytes
  uint64_t palette;     // offset
  uint64_t pixels;      // offset
  uint64_t row;         // bytes, padded to four
};

bool is_depth(uint32_t bits) {
  return bits == 1 || bits == 4 || bits == 8 || bits == 16 || bits == 24 || bits == 32;
}

BmpLayout read_bmp_layout(ByteReader& in) {
  BmpLayout layout = {};
  const uint32_t header = in.u32(14);
  const bool core = header == kCoreHeader;
  const bool known =
      core || header == 40 || header == 52 || header == 56 || header == 64 || header == 108 || header == 124;
  layout.bits = core ? in.u16(24) : in.u16(28);
  const uint32_t compression = core ? 0 : in.u32(30);
  if (!in.ok || !known || !is_depth(layout.bits)) core::refuse(SHD_ERROR_CORRUPT, "BMP: bad header");
  if (compression != 0 && compression != kBitFields)
    core::refuse(SHD_ERROR_UNSUPPORTED, "BMP: compression %u", compression);
  layout.width = core ? in.u16(18) : in.u32(18);
  const auto height = static_cast<int32_t>(core ? in.u16(20) : in.u32(22));
  layout.height = static_cast<uint64_t>(height < 0 ? -int64_t{height} : int64_t{height});
  const uint64_t used = core ? 0 : in.u32(46);
  layout.colors = layout.bits > 8 ? 0 : used != 0 ? used : uint64_t{1} << layout.bits;
  layout.color_size = core ? 3 : 4;
  layout.palette = kFileHeader + header;
  layout.pixels = in.u32(10);
  layout.row = (layout.width * layout.bits + 31) / 32 * 4;
  return layout;
}

/// Checks that every pixel of an indexed image is inside the palette.
void check_indices(const ByteReader& in, const BmpLayout& layout) {
  const uint32_t per_byte = 8 / layout.bits;
  const uint32_t mask = (1u << layout.bits) - 1;
  if (layout.colors > mask) return;
  for (uint64_t y = 0; y < layout.height; ++y) {
    const unsigned char* row = in.bytes + layout.pixels + y * layout.row;
    for (uint64_t x = 0; x < layout.width; ++x) {
      const uint32_t shift = 8 - layout.bits * (1 + static_cast<uint32_t>(x % per_byte));
      if (((uint32_t{row[x / per_byte]} >> shift) & mask) >= layout.colors) {
        core::refuse(SHD_ERROR_CORRUPT, "BMP: a pixel is outside the palette");
      }
    }
  }
}

}  // namespace

void check_bmp_header(const unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, false};
  const BmpLayout layout = read_bmp_layout(in);
  const uint64_t max_colors = layout.bits > 8 ? 0 : uint64_t{1} << layout.bits;
  if (!in.ok || layout.colors > max_colors || !in.has(layout.palette, layout.colors * layout.color_size)) {
    core::refuse(SHD_ERROR_CORRUPT, "BMP: bad palette");
  }
  if (!in.has(layout.pixels, layout.row * layout.height)) core::refuse(SHD_ERROR_CORRUPT, "BMP: cut off");
  if (layout.bits <= 8) check_indices(in, layout);
}

bool bmp_has_unused_byte(const unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, false};
  return in.u32(14) != kCoreHeader && in.u16(28) == 32 && in.u32(30) == 0;
}

}  // namespace shd::io
