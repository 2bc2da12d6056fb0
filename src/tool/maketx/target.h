// SPDX-License-Identifier: MIT
#pragma once
#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>

#include "tool/maketx/source.h"

/// The tiled file. Throws Failure (kExitOutput).
class Target {
 public:
  /// Begins a file at `path`, under whose name it is not shown in messages: they name options.output.
  Target(const std::string& path, const Options& options, const Image& image);
  /// Begins level 0, then 1 and so on.
  void begin_level(uint32_t level);
  /// Writes whole rows of tiles, or the last rows of the level.
  void write(uint32_t y, uint32_t count, const uint8_t* rows);
  /// Completes the file, reads its levels back, and flushes it to the disk.
  void finish();

 private:
  [[noreturn]] void refuse(const std::string& action, const std::string& reason) const;
  bool write_tile(uint32_t x, uint32_t y, uint32_t width, uint32_t height, const uint8_t* texels, size_t stride);
  bool write_tiles(uint32_t y, uint32_t count, const uint8_t* rows);
  void check_level(OIIO::ImageInput& input, uint32_t level) const;

  std::string path_, name_;
  std::unique_ptr<OIIO::ImageOutput> output_;
  OIIO::ImageSpec spec_;
  OIIO::TypeDesc type_;
  uint32_t width_, height_, levels_, level_ = 0;
  bool exr_;
  std::vector<uint8_t> tile_;
};
