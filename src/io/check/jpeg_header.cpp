// SPDX-License-Identifier: MIT
#include "io/check/jpeg_header.h"

#include "core/failure.h"
#include "io/file/byte_reader.h"

namespace shd::io {

namespace {

constexpr uint32_t kScan = 0xda;
constexpr uint32_t kEnd = 0xd9;
constexpr size_t kMaxScans = 256;

/// SOF0 to SOF15 without DHT, JPG and DAC.
bool is_frame(uint32_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

/// Markers without a segment: TEM, RST0 to RST7 and SOI.
bool is_alone(uint32_t marker) {
  return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}

/// Finds the next marker as decoders do, which skip any other bytes before it. Advances *at behind it; returns 0 at the
/// end.
uint32_t next_marker(const ByteReader& in, uint64_t* at) {
  for (; in.has(*at, 2); ++*at) {
    const uint32_t marker = in.bytes[*at + 1];
    if (in.bytes[*at] != 0xff || marker == 0 || marker == 0xff) continue;
    *at += 2;
    return marker;
  }
  return 0;
}

/// Offset of the frame header behind its marker. Throws Failure if a scan comes first or there is none.
uint64_t find_frame(ByteReader& in) {
  uint64_t at = 2;
  for (uint32_t marker = next_marker(in, &at); marker != 0; marker = next_marker(in, &at)) {
    if (is_frame(marker)) return at;
    if (marker == kScan || marker == kEnd) break;
    if (!is_alone(marker)) at += in.u16(at);
  }
  core::refuse(SHD_ERROR_CORRUPT, "JPEG: no frame header");
}

/// Number of scans up to the end marker. In the data of a scan, a zero follows every 0xff that is no marker.
size_t count_scans(ByteReader& in, uint64_t at) {
  size_t count = 0;
  for (uint32_t marker = next_marker(in, &at); marker != 0 && marker != kEnd; marker = next_marker(in, &at)) {
    count += marker == kScan;
    if (!is_alone(marker)) at += in.u16(at);
  }
  return count;
}

}  // namespace

void check_jpeg_header(const unsigned char* bytes, size_t size, size_t file_size, const Limits& limits) {
  ByteReader in{bytes, size, true};
  const uint64_t frame = find_frame(in);
  const uint64_t height = in.u16(frame + 3);
  const uint64_t width = in.u16(frame + 5);
  if (!in.ok) core::refuse(SHD_ERROR_CORRUPT, "JPEG header is cut off");
  check_extent(limits, "image", width, height);
  check_bytes(limits, width * height, 4, file_size);
}

void check_jpeg_scans(const unsigned char* bytes, size_t size) {
  ByteReader in{bytes, size, true};
  const size_t scans = count_scans(in, 2);
  if (scans > kMaxScans) core::refuse(SHD_ERROR_LIMIT, "JPEG: %zu scans are above %zu", scans, kMaxScans);
}

}  // namespace shd::io
