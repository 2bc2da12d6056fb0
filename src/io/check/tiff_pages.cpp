// SPDX-License-Identifier: MIT
#include "io/check/tiff_pages.h"

#include "core/failure.h"
#include "io/file/byte_reader.h"

namespace shd::io {

// Layout of directories: Adobe, "TIFF 6.0", section 2; BigTIFF has wider counts and offsets.
uint32_t count_tiff_pages(const unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, size > 0 && bytes[0] == 'M'};
  const bool big = in.u16(2) == 43;
  const size_t count_size = big ? 8 : 2, entry_size = big ? 20 : 12, offset_size = big ? 8 : 4;
  uint64_t at = big ? in.u64(8) : in.u32(4);
  uint32_t pages = 0;
  for (; at != 0; ++pages) {
    if (pages == kMaxPages) {
      core::refuse(SHD_ERROR_LIMIT, "TIFF: more than %u pages, or a circle of directories", kMaxPages);
    }
    const uint64_t entries = in.number(at, count_size);
    if (!in.ok || entries > size / entry_size) core::refuse(SHD_ERROR_CORRUPT, "TIFF: page %u is cut off", pages);
    at = in.number(at + count_size + entries * entry_size, offset_size);
    if (!in.ok) core::refuse(SHD_ERROR_CORRUPT, "TIFF: page %u is cut off", pages);
  }
  return pages;
}

}  // namespace shd::io
