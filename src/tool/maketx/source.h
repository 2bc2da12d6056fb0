// SPDX-License-Identifier: MIT
#pragma once
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <string>
#include <vector>

#include "image/format.h"
#include "tool/maketx/options.h"

/// Description of the image that the output consists of.
struct Image {
  uint32_t width = 0, height = 0, channels = 0;
  shd::image::Component component = shd::image::Component::kUnorm8;
  OIIO::TypeDesc type;    // type of rows in memory and of the output
  int alpha = -1;         // channel, -1 = none
  bool straight = false;  // alpha is not multiplied into the colour
  std::vector<std::string> names;
  uint64_t file_bytes = 0;
  int64_t changed = 0;  // time of the last change [ns]

  size_t pixel_size() const { return shd::image::format_info(channels, component).pixel_size; }
  size_t row_size() const { return width * pixel_size(); }
};

/// The input. Throws Failure (kExitInput) for what cannot be read or converted.
class Source {
 public:
  explicit Source(const Options& options);
  const Image& image() const { return image_; }
  /// Rows that are read together: the height of a tile of the file, or 1.
  uint32_t step() const { return tile_rows_ ? tile_rows_ : 1; }
  /// Reads the next `count` rows from row y on. Calls are in order.
  void read(uint32_t y, uint32_t count, uint8_t* out);

 private:
  void describe(const Options& options);
  void choose_encoding(const Options& options, const char* type);
  [[noreturn]] void refuse(const std::string& what) const;
  void check_read(bool read, uint32_t begin, uint32_t end);
  void read_tiles(uint32_t y);

  std::string path_;
  std::unique_ptr<OIIO::ImageInput> input_;
  OIIO::ImageSpec spec_;
  Image image_;
  uint32_t tile_rows_ = 0;           // 0 = the file consists of rows
  std::vector<uint8_t> buffer_;      // a row of tiles
  uint32_t buffered_ = 0, end_ = 0;  // its rows
};
