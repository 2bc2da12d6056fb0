// SPDX-License-Identifier: MIT
#include "io/check/sniff.h"

#include "core/failure.h"
#include "io/check/bmp_header.h"
#include "io/check/exr_header.h"
#include "io/check/jpeg_header.h"
#include "io/check/tga_header.h"
#include "io/file/byte_reader.h"

namespace shd::io {

namespace {

struct Signature {
  shd_file_format format;
  const char* name;
  size_t offset;
  size_t size;
  const char* bytes;
};

// Signatures at a fixed offset; several rows may have the same format.
constexpr Signature kSignatures[] = {
    {SHD_FILE_FORMAT_PNG, "PNG", 0, 8, "\x89PNG\r\n\x1a\n"},
    {SHD_FILE_FORMAT_JPEG, "JPEG", 0, 3, "\xff\xd8\xff"},
    {SHD_FILE_FORMAT_EXR, "OpenEXR", 0, 4, "\x76\x2f\x31\x01"},
    {SHD_FILE_FORMAT_TIFF, "TIFF", 0, 4, "II\x2a\0"},
    {SHD_FILE_FORMAT_TIFF, "TIFF", 0, 4, "MM\0\x2a"},
    {SHD_FILE_FORMAT_TIFF, "TIFF", 0, 4, "II\x2b\0"},
    {SHD_FILE_FORMAT_TIFF, "TIFF", 0, 4, "MM\0\x2b"},
    {SHD_FILE_FORMAT_HDR, "Radiance HDR", 0, 10, "#?RADIANCE"},
    {SHD_FILE_FORMAT_HDR, "Radiance HDR", 0, 6, "#?RGBE"},
    {SHD_FILE_FORMAT_BMP, "BMP", 0, 2, "BM"},
    {SHD_FILE_FORMAT_WEBP, "WebP", 8, 4, "WEBP"},
    {SHD_FILE_FORMAT_PSD, "PSD", 0, 4, "8BPS"},
    {SHD_FILE_FORMAT_DPX, "DPX", 0, 4, "SDPX"},
    {SHD_FILE_FORMAT_DPX, "DPX", 0, 4, "XPDS"},
    {SHD_FILE_FORMAT_GIF, "GIF", 0, 6, "GIF87a"},
    {SHD_FILE_FORMAT_GIF, "GIF", 0, 6, "GIF89a"},
};

bool is_pnm(const ByteReader& in) {
  if (!in.has(0, 3) || in.bytes[0] != 'P') return false;
  const unsigned char kind = in.bytes[1];
  const unsigned char space = in.bytes[2];
  const bool white = space == ' ' || space == '\t' || space == '\r' || space == '\n' || space == '#';
  return white && ((kind >= '1' && kind <= '6') || kind == 'F' || kind == 'f');
}

/// Whether a header is valid by Truevision TGA 2.0. Such files have no signature at their start.
bool is_tga(ByteReader in) {
  if (!in.has(0, 18)) return false;
  const uint32_t map_kind = in.u8(1);
  const uint32_t kind = in.u8(2);
  const uint32_t depth = in.u8(16);
  const bool mapped = kind == 1 || kind == 9;
  const bool known = mapped || kind == 2 || kind == 3 || kind == 10 || kind == 11;
  const bool depth_known = depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32;
  return known && depth_known && map_kind <= 1 && (!mapped || map_kind == 1) && in.u16(12) > 0 && in.u16(14) > 0 &&
         (in.u8(17) & 0xc0) == 0;
}

struct Extent {
  uint64_t width = 0;
  uint64_t height = 0;
};

/// The first chunk decides. Any other first chunk is refused, because the decoder might find its size elsewhere.
Extent webp_extent(ByteReader in) {
  if (in.is(12, "VP8X", 4)) return {1 + in.number(24, 3), 1 + in.number(27, 3)};
  if (in.is(12, "VP8L", 4)) {
    const uint32_t packed = in.u32(21);
    return {1 + (packed & 0x3fff), 1 + ((packed >> 14) & 0x3fff)};
  }
  if (in.has(12, 4) && !in.is(12, "VP8 ", 4)) core::refuse(SHD_ERROR_CORRUPT, "WebP: unknown first chunk");
  return {in.u16(26) & 0x3fffu, in.u16(28) & 0x3fffu};
}

/// BITMAPCOREHEADER has 16-bit sizes. Later headers have signed 32-bit sizes; a negative height means rows from the
/// top.
Extent bmp_extent(ByteReader in) {
  if (in.u32(14) == 12) return {in.u16(18), in.u16(20)};
  const auto height = static_cast<int32_t>(in.u32(22));
  const int64_t rows = height;
  return {in.u32(18), static_cast<uint64_t>(rows < 0 ? -rows : rows)};
}

/// Size stored at a fixed offset in the format; 0 x 0 for formats without one.
Extent declared_extent(shd_file_format format, const unsigned char* bytes, size_t size, bool* truncated) {
  ByteReader in{bytes, size, true};
  ByteReader little{bytes, size, false};
  Extent extent;
  switch (format) {
    case SHD_FILE_FORMAT_PNG: extent = {in.u32(16), in.u32(20)}; break;
    case SHD_FILE_FORMAT_PSD: extent = {in.u32(18), in.u32(14)}; break;
    case SHD_FILE_FORMAT_BMP:
      extent = bmp_extent(little);
      little.u8(25);
      break;
    case SHD_FILE_FORMAT_TGA: extent = {little.u16(12), little.u16(14)}; break;
    case SHD_FILE_FORMAT_GIF: extent = {little.u16(6), little.u16(8)}; break;
    case SHD_FILE_FORMAT_WEBP:
      extent = webp_extent(little);
      little.u8(29);
      break;
    case SHD_FILE_FORMAT_DPX: {
      ByteReader dpx{bytes, size, in.is(0, "SDPX", 4)};
      extent = {dpx.u32(772), dpx.u32(776)};
      in.ok = dpx.ok;
      break;
    }
    default: break;
  }
  *truncated = !in.ok || !little.ok;
  return extent;
}

/// Offset of the marker that ends a JPEG header (SOS), or the size of the file.
size_t jpeg_scan_start(const ByteReader& in) {
  size_t at = 2;
  while (in.has(at, 4)) {
    if (in.bytes[at] != 0xff) return at;
    const unsigned char marker = in.bytes[at + 1];
    if (marker == 0xff) {
      ++at;
      continue;
    }
    if (marker == 0xda) return at;
    const bool alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    at += alone ? 2 : 2 + (size_t{in.bytes[at + 2]} << 8) + in.bytes[at + 3];
  }
  return in.size;
}

}  // namespace

shd_file_format sniff(const unsigned char* bytes, size_t size) {
  const ByteReader in{bytes, size, false};
  for (const Signature& row : kSignatures) {
    if (!in.is(row.offset, row.bytes, row.size)) continue;
    if (row.format == SHD_FILE_FORMAT_WEBP && !in.is(0, "RIFF", 4)) continue;
    return row.format;
  }
  if (is_pnm(in)) return SHD_FILE_FORMAT_PNM;
  if (is_tga(in)) return SHD_FILE_FORMAT_TGA;
  return SHD_FILE_FORMAT_NONE;
}

const char* format_name(shd_file_format format) {
  for (const Signature& row : kSignatures) {
    if (row.format == format) return row.name;
  }
  return format == SHD_FILE_FORMAT_PNM ? "PNM" : format == SHD_FILE_FORMAT_TGA ? "TGA" : "unknown";
}

void check_header(shd_file_format format, const unsigned char* bytes, size_t size, const Limits& limits) {
  if (format == SHD_FILE_FORMAT_EXR) {
    check_exr_header(bytes, size, limits);
    return;
  }
  if (format == SHD_FILE_FORMAT_JPEG) {
    check_jpeg_header(bytes, size, size, limits);
    return;
  }
  bool truncated = false;
  const Extent extent = declared_extent(format, bytes, size, &truncated);
  if (truncated) core::refuse(SHD_ERROR_CORRUPT, "%s header is cut off", format_name(format));
  const bool fixed = extent.width != 0 || extent.height != 0;
  if (fixed || (format != SHD_FILE_FORMAT_TIFF && format != SHD_FILE_FORMAT_HDR && format != SHD_FILE_FORMAT_PNM &&
                format != SHD_FILE_FORMAT_NONE)) {
    check_extent(limits, "image", extent.width, extent.height);
    check_bytes(limits, extent.width * extent.height, 4, size);
  }
  if (format == SHD_FILE_FORMAT_BMP) check_bmp_header(bytes, size);
  if (format == SHD_FILE_FORMAT_TGA) check_tga_header(bytes, size);
}

bool jpeg_is_complete(const unsigned char* bytes, size_t size) {
  const ByteReader in{bytes, size, true};
  for (size_t at = jpeg_scan_start(in); at + 1 < size; ++at) {
    if (bytes[at] == 0xff && bytes[at + 1] == 0xd9) return true;
  }
  return false;
}

}  // namespace shd::io
