// SPDX-License-Identifier: MIT
// The layout of an uncompressed tiled OpenEXR file of four half channels. Without compression the place of each tile
// follows from its number, so tiles can be written in any order, by any process, and the file always has the same
// bytes.
// The format: "OpenEXR File Layout" (openexr.com, version 2, single part, tiled, one level).
#ifndef SHD_FARM_EXR_LAYOUT_H
#define SHD_FARM_EXR_LAYOUT_H

#include <cstdint>
#include <string>
#include <vector>

#include "stage.h"

namespace farm {

struct Layout {
  uint32_t width, height, edge;  // pixels of the picture; edge length of a tile
  uint32_t columns, rows;        // numbers of tiles
  std::vector<char> header;      // up to the table of offsets
};

/// `identity` becomes an attribute of the file, so that a finished file is recognised.
Layout make_layout(uint32_t width, uint32_t height, uint32_t edge, const std::string& identity);

uint32_t window_count(const Layout& layout);
Window window_at(const Layout& layout, uint32_t index);

/// Place and size of a tile with its head of 20 bytes.
uint64_t chunk_offset(const Layout& layout, uint32_t index);
uint64_t chunk_size(const Layout& layout, uint32_t index);
uint64_t file_size(const Layout& layout);

/// Header and table of offsets: the beginning of the file.
std::vector<char> file_head(const Layout& layout);

/// The bytes of a tile. `chunk` is resized.
void encode_chunk(const Layout& layout, uint32_t index, const Pixels& pixels, std::vector<char>* chunk);

/// A checksum against damage of files.
uint64_t checksum(const void* data, size_t size, uint64_t seed = 0);

}  // namespace farm

#endif  // SHD_FARM_EXR_LAYOUT_H
