// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <shd/io.h>

namespace shd::io {

/// Properties that all files of a set share.
struct TiledInfo {
  shd_format format = SHD_FORMAT_NONE;  // one, two or four channels
  uint32_t width = 0, height = 0;       // size of one file
  uint32_t level_count = 0;
  uint32_t tile_width = 0, tile_height = 0;
  bool premultiplied = false;  // colours are multiplied by alpha
};

/// A rectangle of a level of one file, and memory for its texels in the format of the set.
struct TiledRead {
  size_t file;
  uint32_t level, x, y, width, height;
  unsigned char* texels;
  size_t row_stride;
};

/// Tiled files of one shape with readers that are kept open.
class TiledSet;

/// The files of a set, as they are opened.
struct TiledPaths {
  std::vector<std::string> paths;
  shd_color_encoding encoding = SHD_COLOR_ENCODING_AUTO;
  size_t max_readers = 16;
};

/// Opens every file, and checks that all levels have the sizes and channels that they must have. Throws Failure.
TiledSet* open_tiled_set(const TiledPaths& paths, TiledInfo* out);

/// Reads texels. Any thread; holds no lock while it reads. Throws Failure that names the file, the level and the place.
void read_tiled_set(TiledSet& set, const TiledRead& read);

void close_tiled_set(TiledSet* set) noexcept;

}  // namespace shd::io
