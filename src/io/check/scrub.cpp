// SPDX-License-Identifier: MIT
#include "io/check/scrub.h"

#include <cstring>
#include <initializer_list>

#include "core/failure.h"
#include "io/check/tga_header.h"
#include "io/check/tiff_pages.h"
#include "io/file/byte_reader.h"

namespace shd::io {

namespace {

/// Moves the pieces of a file that are kept to its front.
struct Compactor {
  unsigned char* bytes;
  size_t size;
  size_t kept = 0;
  void keep(size_t at, size_t count) {
    std::memmove(bytes + kept, bytes + at, count);
    kept += count;
  }
};

/// CRC-32 of PNG chunks (ISO/IEC 15948, Annex D), four bits per step.
uint32_t crc32(const unsigned char* bytes, size_t size) {
  uint32_t table[16];
  for (uint32_t i = 0; i < 16; ++i) {
    uint32_t value = i;
    for (int bit = 0; bit < 4; ++bit) value = (value >> 1) ^ ((value & 1) ? 0xedb88320u : 0);
    table[i] = value;
  }
  uint32_t crc = 0xffffffffu;
  for (size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    crc = (crc >> 4) ^ table[crc & 15];
    crc = (crc >> 4) ^ table[crc & 15];
  }
  return ~crc;
}

/// Whether a PNG chunk defines pixels: the critical chunks, and three that change the meaning of pixels.
bool is_wanted_chunk(const ByteReader& in, size_t type) {
  for (const char* wanted : {"IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "sRGB"}) {
    if (in.is(type, wanted, 4)) return true;
  }
  return false;
}

/// The chunks are checked here first, because libpng prints complaints about them to stderr.
size_t scrub_png(unsigned char* bytes, size_t size, bool strict) {
  ByteReader in{bytes, size, true};
  Compactor out{bytes, size};
  out.keep(0, 8);
  size_t at = 8;
  bool data = false;
  bool end = false;
  while (!end && in.has(at, 12)) {
    const size_t length = size_t{in.u32(at)} + 12;
    if (!in.has(at, length)) break;
    const bool wanted = is_wanted_chunk(in, at + 4);
    const bool damaged = wanted && crc32(bytes + at + 4, length - 8) != in.u32(at + length - 4);
    const bool misplaced = in.is(at + 4, "IHDR", 4) != (at == 8);
    if (strict && (damaged || misplaced)) core::refuse(SHD_ERROR_CORRUPT, "PNG: the chunk at byte %zu is damaged", at);
    data = data || in.is(at + 4, "IDAT", 4);
    end = in.is(at + 4, "IEND", 4);
    if (wanted) out.keep(at, length);
    at += length;
  }
  if (strict && !(data && end)) core::refuse(SHD_ERROR_CORRUPT, "PNG: cut off at byte %zu", size);
  if (!end) out.keep(at, size - at);
  return out.kept;
}

/// JPEG (ITU-T T.81, B.1): APP0 (JFIF) and APP14 (Adobe) affect decoding and are kept; other APPn and COM are dropped.
size_t scrub_jpeg(unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, true};
  Compactor out{bytes, size};
  out.keep(0, 2);
  size_t at = 2;
  while (in.has(at, 4) && bytes[at] == 0xff) {
    const unsigned char marker = bytes[at + 1];
    if (marker == 0xff) {
      ++at;
      continue;
    }
    const bool alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    const size_t length = alone ? 2 : 2 + size_t{in.u16(at + 2)};
    const bool metadata = marker == 0xfe || (marker >= 0xe1 && marker <= 0xef && marker != 0xee);
    if (marker == 0xda || !in.has(at, length)) {
      if (metadata) return out.kept;
      break;
    }
    if (!metadata) out.keep(at, length);
    at += length;
  }
  out.keep(at, size - at);
  return out.kept;
}

/// Layout of an image file directory: classic TIFF (TIFF 6.0, section 2) or BigTIFF.
struct IfdLayout {
  size_t count_size, entry_size, offset_size;
};

bool is_tiff_metadata(uint32_t tag) {
  switch (tag) {
    case 700:    // XMP
    case 33723:  // IPTC
    case 34377:  // Photoshop
    case 34665:  // EXIF
    case 34675:  // ICC
    case 34853:  // GPS
    case 37724:  // Photoshop layers
    case 40965:  // interoperability
      return true;
    default: return false;
  }
}

void put_number(unsigned char* to, uint64_t value, size_t count, bool big_endian) {
  for (size_t i = 0; i < count; ++i) to[big_endian ? count - 1 - i : i] = static_cast<unsigned char>(value >> (8 * i));
}

/// Size of an element of a field in bytes; 0 for the types that strips and tiles cannot have (TIFF 6.0, section 8).
size_t element_size(ByteReader& in, uint64_t entry) {
  const uint32_t type = in.u16(entry + 2);
  return type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
}

/// Element `index` of a field of 16-, 32- or 64-bit numbers. A field that fits is stored in the entry itself.
uint64_t field_value(ByteReader& in, uint64_t entry, const IfdLayout& layout, size_t size, uint64_t index) {
  const uint64_t count = in.number(entry + 4, layout.offset_size);
  const uint64_t value = entry + 4 + layout.offset_size;
  const bool inside = count <= layout.offset_size / size;
  return in.number((inside ? value : in.number(value, layout.offset_size)) + index * size, size);
}

/// Refuses strips and tiles beyond the end of the file, because libtiff would invent the missing pixels. `left` is the
/// number of strips that the rest of the file can have: directories may be chained in a circle.
void check_strips(ByteReader& in, uint64_t entries, uint64_t count, const IfdLayout& layout, uint64_t* left) {
  uint64_t offsets = 0, sizes = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const uint64_t entry = entries + i * layout.entry_size;
    const uint32_t tag = in.u16(entry);
    if (tag == 273 || tag == 324) offsets = entry;
    if (tag == 279 || tag == 325) sizes = entry;
  }
  if (offsets == 0 || sizes == 0) return;
  const size_t offset_size = element_size(in, offsets), size_size = element_size(in, sizes);
  if (offset_size == 0 || size_size == 0) {
    core::refuse(SHD_ERROR_CORRUPT, "TIFF: offsets or sizes of strips are no SHORT, LONG or LONG8");
  }
  const uint64_t strips = in.number(offsets + 4, layout.offset_size);
  in.ok = in.ok && strips <= *left;
  for (uint64_t i = 0; i < strips && in.ok; ++i) {
    const uint64_t at = field_value(in, offsets, layout, offset_size, i);
    if (!in.has(at, field_value(in, sizes, layout, size_size, i))) in.ok = false;
  }
  if (!in.ok) core::refuse(SHD_ERROR_CORRUPT, "TIFF: strips or tiles beyond the end of the file");
  *left -= strips;
}

/// Refuses the pages that OpenImageIO reads wrongly: those without BitsPerSample, which have 1 bit and not 8, wide
/// samples in which 0 is white, which it does not invert (TIFF 6.0, section 8), and CIE L*a*b*, which it takes for RGB
/// (section 23).
void check_samples(ByteReader& in, uint64_t entries, uint64_t count, const IfdLayout& layout) {
  uint64_t bits = 0, photometric = 1;
  for (uint64_t i = 0; i < count; ++i) {
    const uint64_t entry = entries + i * layout.entry_size;
    const uint32_t tag = in.u16(entry);
    if (tag != 258 && tag != 262) continue;
    const size_t size = element_size(in, entry);
    const uint64_t value = size ? field_value(in, entry, layout, size, 0) : 0;
    (tag == 258 ? bits : photometric) = value;
  }
  if (bits == 0) core::refuse(SHD_ERROR_UNSUPPORTED, "TIFF: no BitsPerSample, which means 1 bit");
  if (photometric >= 8 && photometric <= 10) core::refuse(SHD_ERROR_UNSUPPORTED, "TIFF: colours of CIE L*a*b*");
  if (photometric == 0 && bits > 8) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "TIFF: samples of %u bits in which 0 is white", static_cast<unsigned>(bits));
  }
}

/// Removes the metadata entries of the directory at `at`. Returns the offset of the next directory, 0 at the end.
uint64_t scrub_ifd(ByteReader& in, unsigned char* bytes, uint64_t at, const IfdLayout& layout, bool strict,
                   uint64_t* strips_left) {
  const uint64_t count = in.number(at, layout.count_size);
  const uint64_t entries = at + layout.count_size;
  if (!in.ok || count > 65535 || !in.has(entries, count * layout.entry_size + layout.offset_size)) return 0;
  check_samples(in, entries, count, layout);
  if (strict) check_strips(in, entries, count, layout, strips_left);
  uint64_t kept = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const uint64_t entry = entries + i * layout.entry_size;
    if (is_tiff_metadata(in.u16(entry))) continue;
    std::memmove(bytes + entries + kept * layout.entry_size, bytes + entry, layout.entry_size);
    ++kept;
  }
  const uint64_t next = in.number(entries + count * layout.entry_size, layout.offset_size);
  put_number(bytes + at, kept, layout.count_size, in.big_endian);
  put_number(bytes + entries + kept * layout.entry_size, next, layout.offset_size, in.big_endian);
  return next;
}

void scrub_tiff(unsigned char* bytes, size_t size, bool strict) {
  ByteReader in{bytes, size, bytes[0] == 'M'};
  const bool big = in.u16(2) == 43;
  const IfdLayout layout = big ? IfdLayout{8, 20, 8} : IfdLayout{2, 12, 4};
  const unsigned header_size = big ? 16 : 8;
  uint64_t at = big ? in.u64(8) : in.u32(4);
  uint64_t strips_left = size;  // a strip takes more than one byte of a file
  for (uint32_t page = 0; in.ok && at != 0 && page < kMaxPages; ++page) {
    if (at < header_size)
      core::refuse(SHD_ERROR_CORRUPT, "TIFF: a directory at byte %u, in the header", static_cast<unsigned>(at));
    at = scrub_ifd(in, bytes, at, layout, strict, &strips_left);
  }
}

/// WebP (RFC 9649): metadata chunks are renamed to an unknown kind, which readers skip.
void scrub_webp(unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, false};
  uint64_t at = 12;
  while (in.has(at, 8)) {
    if (in.is(at, "EXIF", 4) || in.is(at, "XMP ", 4) || in.is(at, "ICCP", 4)) std::memcpy(bytes + at, "JUNK", 4);
    if (in.is(at, "VP8X", 4) && in.has(at, 9)) bytes[at + 8] &= static_cast<unsigned char>(~0x2c);
    const uint64_t length = in.u32(at + 4);
    at += 8 + length + (length & 1);
  }
}

/// TGA 2.0: everything in the extension area except gamma and kind of alpha becomes zero, because the decoder reads
/// texts without an end.
void scrub_tga(unsigned char* bytes, size_t size) {
  const size_t at = find_tga_extension(bytes, size);
  if (at == size) return;
  constexpr size_t kTexts = 2, kGamma = 478, kOffsets = 482, kAlphaOffset = 494;
  std::memset(bytes + at + kTexts, 0, kGamma - kTexts);
  std::memset(bytes + at + kOffsets, 0, kAlphaOffset - kOffsets);
}

}  // namespace

size_t scrub(shd_file_format format, unsigned char* bytes, size_t size, bool strict) {
  switch (format) {
    case SHD_FILE_FORMAT_PNG: return scrub_png(bytes, size, strict);
    case SHD_FILE_FORMAT_JPEG: return scrub_jpeg(bytes, size);
    case SHD_FILE_FORMAT_TIFF: scrub_tiff(bytes, size, strict); return size;
    case SHD_FILE_FORMAT_WEBP: scrub_webp(bytes, size); return size;
    case SHD_FILE_FORMAT_TGA: scrub_tga(bytes, size); return size;
    default: return size;
  }
}

}  // namespace shd::io
