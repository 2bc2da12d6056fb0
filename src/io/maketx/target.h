// SPDX-License-Identifier: MIT
#pragma once
#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>

#include "io/file/file_descriptor.h"
#include "io/maketx/source.h"

/// Properties of an output that are known after its pixels.
struct Marks {
  std::string hash, average, constant;  // as Stats has them
  std::string key;                      // checksum of input and options, for -u
};

/// The tiled file. Throws Failure (kExitOutput).
class Target {
 public:
  Target(const Options& options, const Image& image);
  /// Adds these properties to the header, before open().
  void mark(const Marks& marks);
  /// Takes the file to write, which is empty.
  void open(shd::io::FileDescriptor file);
  /// Begins level 0, then 1 and so on.
  void begin_level(uint32_t level);
  /// Writes whole rows of tiles, or the last rows of the level.
  void write(uint32_t y, uint32_t count, const uint8_t* rows);
  /// Completes the file, reads its levels back, and flushes it to the disk.
  void finish();

 private:
  void check_attributes(const Options& options) const;
  [[noreturn]] void refuse(const std::string& action, const std::string& reason) const;
  bool write_tile(uint32_t x, uint32_t y, uint32_t width, uint32_t height, const uint8_t* texels, size_t stride);
  bool write_tiles(uint32_t y, uint32_t count, const uint8_t* rows);
  void check_level(OIIO::ImageInput& input, uint32_t level) const;

  shd::io::FileDescriptor file_;
  std::string path_, name_;  // path by the descriptor, which no link can replace; output, for messages
  std::unique_ptr<OIIO::ImageOutput> output_;
  OIIO::ImageSpec spec_;
  OIIO::TypeDesc type_;
  uint32_t width_, height_, levels_, level_ = 0;
  bool exr_;
  std::vector<uint8_t> tile_;
};
