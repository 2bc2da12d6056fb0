// SPDX-License-Identifier: MIT
#include "io/check/tga_header.h"

#include <algorithm>

#include "core/failure.h"
#include "io/file/byte_reader.h"

namespace shd::io {

namespace {

constexpr uint64_t kTgaHeader = 18;
constexpr uint32_t kMapped = 1;
constexpr uint32_t kTrueColor = 2;
constexpr uint32_t kRunLengths = 8;  // added to the kind

/// Layout of the pixels, read from the header.
struct TgaLayout {
  uint32_t kind;        // without kRunLengths
  bool packed;          // run-length encoded
  uint64_t colors;      // number of palette entries
  uint64_t color_size;  // bytes
  uint64_t palette;     // offset
  uint64_t pixels;      // offset
  uint64_t count;       // number of pixels
  uint32_t pixel_size;  // bytes
};

bool is_depth(uint32_t kind, uint32_t depth) {
  if (kind == kTrueColor) return depth == 15 || depth == 16 || depth == 24 || depth == 32;
  return depth == 8 || depth == 16;
}

TgaLayout read_tga_layout(ByteReader& in) {
  TgaLayout layout = {};
  const uint32_t kind = in.u8(2);
  const uint32_t depth = in.u8(16);
  layout.kind = kind & ~kRunLengths;
  layout.packed = (kind & kRunLengths) != 0;
  if (!is_depth(layout.kind, depth)) core::refuse(SHD_ERROR_UNSUPPORTED, "TGA: kind %u with %u bits", kind, depth);
  if (in.u8(1) != 0) {
    layout.colors = in.u16(5);
    layout.color_size = (in.u8(7) + 7) / 8;
  }
  layout.palette = kTgaHeader + in.u8(0);
  layout.pixels = layout.palette + layout.colors * layout.color_size;
  layout.count = uint64_t{in.u16(12)} * in.u16(14);
  layout.pixel_size = (depth + 7) / 8;
  return layout;
}

/// Checks `count` stored pixels.
void check_pixels(const ByteReader& in, const TgaLayout& layout, uint64_t at, uint64_t count) {
  if (!in.has(at, count * layout.pixel_size)) core::refuse(SHD_ERROR_CORRUPT, "TGA: cut off");
  if (layout.kind != kMapped) return;
  const unsigned char* pixel = in.bytes + at;
  for (uint64_t i = 0; i < count; ++i, pixel += layout.pixel_size) {
    const uint32_t index = layout.pixel_size == 1 ? pixel[0] : pixel[0] + 256u * pixel[1];
    if (index >= layout.colors) core::refuse(SHD_ERROR_CORRUPT, "TGA: a pixel is outside the palette");
  }
}

/// A packet is a byte with the number of pixels less one and, for a run, the top bit; then one pixel or all of them.
/// The last packet may be longer than the image. Returns the offset behind the last one.
uint64_t check_packets(ByteReader& in, const TgaLayout& layout) {
  uint64_t at = layout.pixels;
  for (uint64_t left = layout.count; left > 0;) {
    const uint32_t packet = in.u8(at);
    const uint64_t pixels = std::min<uint64_t>(left, 1 + (packet & 0x7f));
    const uint64_t stored = (packet & 0x80) ? 1 : pixels;
    check_pixels(in, layout, at + 1, stored);
    at += 1 + stored * layout.pixel_size;
    left -= pixels;
  }
  return at;
}

void check_extension(const ByteReader& in, uint64_t pixels_end) {
  const size_t extension = find_tga_extension(in.bytes, in.size);
  if (extension == in.size) return;
  if (extension < pixels_end || !in.has(extension, kTgaExtension)) {
    core::refuse(SHD_ERROR_CORRUPT, "TGA: bad extension area");
  }
}

}  // namespace

void check_tga_header(const unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, false};
  const TgaLayout layout = read_tga_layout(in);
  if (layout.kind == kMapped && in.u16(3) != 0) {
    // The format subtracts the first index from a pixel; OpenImageIO 2.4 adds it.
    core::refuse(SHD_ERROR_UNSUPPORTED, "TGA: a palette that starts at index %u", in.u16(3));
  }
  if (!in.ok || !in.has(layout.palette, layout.colors * layout.color_size)) {
    core::refuse(SHD_ERROR_CORRUPT, "TGA: bad palette");
  }
  uint64_t end = layout.pixels + layout.count * layout.pixel_size;
  if (layout.packed) {
    end = check_packets(in, layout);
  } else {
    check_pixels(in, layout, layout.pixels, layout.count);
  }
  check_extension(in, end);
}

size_t find_tga_extension(const unsigned char* bytes, size_t size) {
  constexpr size_t kFooter = 26;
  ByteReader in{bytes, size, false};
  if (size < kFooter || !in.is(size - kFooter + 8, "TRUEVISION-XFILE.", 17)) return size;
  const size_t at = in.u32(size - kFooter);
  return in.has(at, 2) && in.u16(at) >= kTgaExtension ? at : size;
}

}  // namespace shd::io
