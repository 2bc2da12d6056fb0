// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/io.h"

namespace shd::io {

/// Decodes a file whose header has been checked. Refuses damaged files unless SHD_LOAD_PARTIAL allows missing rows.
/// `complete` false = the file is known to be cut off. file_size: of the file before scrubbing.
Bitmap decode(shd_file_format format, const unsigned char* bytes, size_t size, size_t file_size, bool complete,
              const LoadOptions& options, const Memory& memory, const Deadline& deadline);

/// How one channel of a file is stored.
enum class Sample : uint32_t { kU8, kU16, kHalf, kFloat, kU32 };

/// One channel of a file to be written.
struct EncodeChannel {
  std::string name;
  Sample sample;
};

/// A file to be written. `row` fills one row: [width] pixels, each its channels in order, packed, native endian.
struct EncodeJob {
  const char* writer = "";  // name of OpenImageIO's format
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<EncodeChannel> channels;
  int alpha = -1;                // its channel
  bool straight = false;         // alpha is not multiplied in
  const char* color_space = "";  // tag: "sRGB", "Linear" or "" for none
  void (*row)(const void* user_data, uint32_t y, unsigned char* out) = nullptr;
  const void* user_data = nullptr;
};

/// The bytes of the file.
std::vector<unsigned char> encode(const EncodeJob& job);

/// Sets attributes of the whole process, for the worker: no threads of OpenImageIO or OpenEXR, and OpenImageIO's own
/// limits as a second line of defence.
void limit_process(uint64_t max_bytes);

}  // namespace shd::io
