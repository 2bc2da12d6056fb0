// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/bitmap/bitmap.h"

namespace shd::io {

/// A file whose header has been checked.
struct DecodeInput {
  shd_file_format format;
  const unsigned char* bytes;
  size_t size;
  size_t file_size;  // before scrubbing
  bool complete;     // false if the file is known to be cut off
};

/// Decodes a file. Refuses damaged files, unless SHD_LOAD_PARTIAL allows missing rows.
/// @param sink  or null
Bitmap decode(const DecodeInput& input, const LoadOptions& options, const Memory& memory, const Deadline& deadline,
              const Sink* sink);

/// Storage of one channel of a file.
enum class Sample : uint32_t { kU8, kU16, kHalf, kFloat, kU32 };

/// One channel of a file to be written.
struct EncodeChannel {
  std::string name;
  Sample sample;
};

/// A text, or a matrix of 16 floats, in the header of a file.
struct EncodeAttribute {
  std::string name;
  std::string text;
  std::vector<float> matrix;  // empty = text
};

/// A file to be written. `row` fills one row: [width] pixels, each with its channels in order, packed, native endian.
struct EncodeJob {
  const char* writer = "";  // name of the format in OpenImageIO
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<EncodeChannel> channels;
  int alpha = -1;                // index of the alpha channel, -1 = none
  bool straight = false;         // alpha is not multiplied into the colour
  const char* color_space = "";  // tag: "sRGB", "Linear" or "" for none
  std::string compression;       // as OpenImageIO has it, such as "jpeg:95"; "" = that of the format
  std::vector<EncodeAttribute> attributes;
  void (*row)(const void* user_data, uint32_t y, unsigned char* out) = nullptr;
  const void* user_data = nullptr;
};

/// Returns the bytes of the file.
std::vector<unsigned char> encode(const EncodeJob& job);

/// Prepares the process that children are forked from; only for the worker. Disables the threads of OpenImageIO and
/// OpenEXR, and makes OpenImageIO set up its readers.
void prepare_process();

/// Sets OpenImageIO's own limits in this process, as a second line of defence; only for the worker.
void limit_process(uint64_t max_bytes);

}  // namespace shd::io
