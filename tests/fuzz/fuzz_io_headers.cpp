// SPDX-License-Identifier: MIT
// The checks of libshd_io that run on the bytes of a file before OpenImageIO reads them: format, declared size,
// headers, removal of metadata. They throw nothing but a Failure with a text, and read and write nothing outside the
// bytes. The mutator writes numbers of either byte order, and mends the checksums of PNG chunks.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "core/failure.h"
#include "io/check/jpeg_header.h"
#include "io/check/scrub.h"
#include "io/check/sniff.h"
#include "io/check/tga_header.h"
#include "io/check/tiff_pages.h"
#include "io/file/printable.h"
#include "io/vdb/header.h"

#define SHD_FUZZ_CHECK(condition)                                          \
  do {                                                                     \
    if (!(condition)) {                                                    \
      std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                        \
    }                                                                      \
  } while (0)

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace shd::io {
namespace {

using Bytes = std::vector<unsigned char>;

/// Runs a check. Returns the result of its refusal, SHD_OK if there is none.
template <class Check>
shd_result refusal(const Check& check) {
  try {
    check();
  } catch (const core::Failure& failure) {
    SHD_FUZZ_CHECK(failure.what()[0] != '\0');
    SHD_FUZZ_CHECK(failure.code == SHD_ERROR_CORRUPT || failure.code == SHD_ERROR_UNSUPPORTED ||
                   failure.code == SHD_ERROR_LIMIT);
    return failure.code;
  }
  return SHD_OK;
}

/// Every check, also those of other formats: the decoder is chosen by other code.
void check_headers(const Bytes& bytes, const Limits& limits, std::vector<shd_result>& results) {
  constexpr shd_file_format kFormats[] = {SHD_FILE_FORMAT_PNG, SHD_FILE_FORMAT_JPEG, SHD_FILE_FORMAT_TIFF,
                                          SHD_FILE_FORMAT_EXR, SHD_FILE_FORMAT_HDR,  SHD_FILE_FORMAT_WEBP,
                                          SHD_FILE_FORMAT_BMP, SHD_FILE_FORMAT_TGA,  SHD_FILE_FORMAT_PSD,
                                          SHD_FILE_FORMAT_DPX, SHD_FILE_FORMAT_GIF,  SHD_FILE_FORMAT_PNM};
  const unsigned char* const data = bytes.data();
  const size_t size = bytes.size();
  for (const shd_file_format format : kFormats) {
    SHD_FUZZ_CHECK(format_name(format)[0] != '\0');
    results.push_back(refusal([&] { check_header(format, data, size, limits); }));
  }
  results.push_back(refusal([&] { check_jpeg_scans(data, size); }));
  results.push_back(refusal([&] { SHD_FUZZ_CHECK(count_tiff_pages(data, size) <= kMaxPages); }));
  results.push_back(refusal([&] {
    for (const VdbGrid& grid : list_vdb_grids(data, size)) SHD_FUZZ_CHECK(grid.unique_name.size() < size);
  }));
  results.push_back(jpeg_is_complete(data, size) ? SHD_OK : SHD_ERROR_CORRUPT);
  SHD_FUZZ_CHECK(find_tga_extension(data, size) <= size);
}

/// Scrubs a copy. Returns what is left of it.
Bytes scrubbed(const Bytes& bytes, shd_file_format format, bool strict, shd_result& result) {
  Bytes copy = bytes;
  size_t size = copy.size();
  result = refusal([&] { size = scrub(format, copy.data(), copy.size(), strict); });
  SHD_FUZZ_CHECK(size <= copy.size());
  copy.resize(size);
  return copy;
}

void check_scrub(const Bytes& bytes, const Limits& limits, std::vector<shd_result>& results) {
  const shd_file_format sniffed = sniff(bytes.data(), bytes.size());
  if (refusal([&] { check_header(sniffed, bytes.data(), bytes.size(), limits); }) != SHD_OK) return;
  for (const bool strict : {false, true}) {
    shd_result result, again;
    const Bytes clean = scrubbed(bytes, sniffed, strict, result);
    results.push_back(result);
    if (result != SHD_OK) continue;
    // JPEG decoders skip bytes between segments, so that the third byte of the signature need not stay.
    SHD_FUZZ_CHECK(sniff(clean.data(), clean.size()) == sniffed ||
                   (sniffed == SHD_FILE_FORMAT_JPEG && clean.size() > 1 && clean[0] == 0xff && clean[1] == 0xd8));
    const Bytes twice = scrubbed(clean, sniffed, strict, again);
    SHD_FUZZ_CHECK(twice.size() <= clean.size());
    check_headers(clean, limits, results);
  }
}

Limits choose_limits(uint8_t choice) {
  Limits limits;
  if (choice & 1) limits.pixels = 4096;
  if (choice & 2) limits.bytes = 65536;
  if (choice & 4) limits.ratio = 4;
  return limits;
}

std::vector<shd_result> run(const Bytes& bytes, uint8_t choice) {
  std::vector<shd_result> results;
  const Limits limits = choose_limits(choice);
  check_headers(bytes, limits, results);
  check_scrub(bytes, limits, results);
  return results;
}

/// CRC-32 of ISO/IEC 15948, Annex D.
uint32_t crc32(const uint8_t* bytes, size_t size) {
  uint32_t crc = 0xffffffffu;
  for (size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  return ~crc;
}

uint32_t big(const uint8_t* p) {
  return uint32_t{p[0]} << 24 | uint32_t{p[1]} << 16 | uint32_t{p[2]} << 8 | p[3];
}

/// Gives every PNG chunk its checksum.
void mend_png(uint8_t* data, size_t size) {
  for (size_t at = 8; at + 12 <= size;) {
    const uint64_t length = big(data + at);
    if (length > size - at - 12) return;
    const uint32_t crc = crc32(data + at + 4, length + 4);
    for (int i = 0; i < 4; ++i)
      data[at + 8 + length + static_cast<size_t>(i)] = static_cast<uint8_t>(crc >> (24 - 8 * i));
    at += length + 12;
  }
}

/// Overwrites a number of 1, 2, 4 or 8 bytes by one at the end of a range, or near the size of the file.
void write_number(uint8_t* data, size_t size, uint32_t random) {
  const uint64_t kNumbers[] = {0,
                               1,
                               2,
                               8,
                               0x7f,
                               0xff,
                               0x100,
                               0x7fff,
                               0xffff,
                               0x10000,
                               0x7fffffff,
                               0x80000000u,
                               0xffffffffu,
                               size,
                               size - 18,
                               size + 1,
                               uint64_t{1} << 63,
                               ~uint64_t{0}};
  const uint64_t value = kNumbers[random % (sizeof kNumbers / sizeof kNumbers[0])];
  const size_t count = size_t{1} << (random >> 8 & 3);
  if (size < count) return;
  const size_t at = (random >> 10 & 1023) % std::min<size_t>(size - count + 1, random >> 20 & 1 ? 64 : size);
  const bool big_endian = random >> 21 & 1;
  for (size_t i = 0; i < count; ++i) {
    data[at + i] = static_cast<uint8_t>(value >> 8 * (big_endian ? count - 1 - i : i));
  }
}

}  // namespace
}  // namespace shd::io

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size, unsigned seed) {
  using namespace shd::io;
  const uint32_t random = seed * 2654435761u ^ seed >> 15;
  if (random % 4 == 0 && size > 0) {
    write_number(data, size, random >> 2 ^ random << 13);
  } else {
    size = LLVMFuzzerMutate(data, size, max_size);
  }
  const bool png = size > 20 && std::memcmp(data + 1, "\x89PNG", 4) == 0;
  if (png && (random >> 4 & 7) != 0) mend_png(data + 1, size - 1);
  return size;
}

/// The first byte chooses limits; the others are the file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::io;
  if (size == 0) return 0;
  const Bytes bytes(data + 1, data + size);
  if (bytes.empty()) return 0;
  const std::vector<shd_result> results = run(bytes, data[0]);
  if (data[0] >= 0xe0) SHD_FUZZ_CHECK(run(bytes, data[0]) == results);
  const std::string text = printable(std::string(bytes.begin(), bytes.end()));
  for (const char c : text) SHD_FUZZ_CHECK(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
  return 0;
}
