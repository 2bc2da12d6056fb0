// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "io/container/texture_file.h"
#include "io/file/file_descriptor.h"

namespace shd::io {

/// A KTX2 or DDS file that stays open. Its texels are used as they are stored.
struct StoredTiles {
  std::string path;
  FileDescriptor file;
  TextureFile parsed;
};

/// Opens such a file, or returns null for content of another kind. Throws Failure.
std::unique_ptr<StoredTiles> open_stored_tiles(const std::string& path, shd_color_encoding encoding,
                                               const Memory& memory);

/// Reads the texels of a tile, or its rows of blocks. Three channels become four, and the fourth is 0. Any thread.
/// Throws Failure that names the file, the level and the place.
void load_tile(const StoredTiles& tiles, const shd_tile& tile);

}  // namespace shd::io
