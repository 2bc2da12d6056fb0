// SPDX-License-Identifier: MIT
#include "io/container/texture_tiles.h"

#include <algorithm>
#include <cstring>

#include "core/failure.h"
#include "image/format.h"
#include "io/bitmap/levels.h"
#include "io/bitmap/raw_voxels.h"
#include "io/container/texture_load.h"
#include "io/file/printable.h"
#include "io/file/read_file.h"

namespace shd::io {

namespace {

/// The parts before the levels must be in the first bytes of a file.
constexpr uint64_t kHead = uint64_t{1} << 20;

/// The levels stay in the file, so they are bounded by the sides alone.
constexpr Limits kLimits = {UINT64_MAX, UINT64_MAX, UINT64_MAX, 1e300, 1e300, uint64_t{1} << 20, UINT64_MAX};

void require_stored(const TextureFile& parsed) {
  const bool supercompressed = parsed.info.supercompression != SHD_SUPERCOMPRESSION_NONE;
  if (!supercompressed && parsed.storage.unpack == Unpack::kNone) return;
  core::refuse(SHD_ERROR_UNSUPPORTED, "%s, and tiles are read as they are stored: shd_texture_load() loads the file",
               supercompressed                          ? "the levels are supercompressed"
               : parsed.storage.unpack == Unpack::kAstc ? "the blocks are ASTC"
                                                        : "the channels are in another order, or bit fields");
}

[[noreturn]] void refuse_read(const StoredTiles& tiles, const shd_tile& tile, int error) {
  if (error) refuse_errno("cannot read", tiles.path.c_str(), error);
  core::refuse(SHD_ERROR_CORRUPT,
               "\"%s\": mip level %u, layer %u, columns %u to %u, rows %u to %u: the file ends there",
               printable(tiles.path).c_str(), tile.level, tile.layer, tile.area.x, tile.area.x + tile.area.width - 1,
               tile.area.y, tile.area.y + tile.area.height - 1);
}

/// Moves pixels of three numbers apart, from the end of a row to its whole length.
void expand_row(size_t width, size_t number, unsigned char* row) {
  const unsigned char* from = row + width * number;
  for (unsigned char* to = row; width > 0; --width, from += 3 * number, to += 4 * number) {
    std::memmove(to, from, 3 * number);
    std::memset(to + 3 * number, 0, number);
  }
}

}  // namespace

std::unique_ptr<StoredTiles> open_stored_tiles(const std::string& path, shd_color_encoding encoding,
                                               const Memory& memory) {
  core::RegularFile opened = open_file(path.c_str());
  unsigned char first[kContainerBytes] = {};
  int error = 0;
  const size_t got = core::read_at(opened.file.fd, 0, sizeof first, first, &error);
  if (container_of(first, got) != Container::kTexture) return nullptr;
  try {
    const auto size = static_cast<size_t>(std::min(opened.size, kHead));
    const Buffer bytes = read_bytes(opened.file.fd, size, memory);
    TextureFile parsed = parse_texture_file(bytes.data(), size, encoding, false, kLimits, opened.size - size);
    require_stored(parsed);
    return std::unique_ptr<StoredTiles>(new StoredTiles{path, std::move(opened.file), parsed});
  } catch (const core::Failure& failure) {
    core::refuse(failure.code, "\"%s\": %s", printable(path).c_str(), failure.what());
  }
}

void load_tile(const StoredTiles& tiles, const shd_tile& tile) {
  const TextureFile& parsed = tiles.parsed;
  const Storage& storage = parsed.storage;
  const image::FormatInfo pixels = image::format_info(storage.format);
  const auto columns = [&](uint32_t texels) {
    return uint64_t{texels + storage.block_width - 1} / storage.block_width;
  };
  const auto rows = [&](uint32_t texels) { return uint64_t{texels + storage.block_height - 1} / storage.block_height; };
  const uint64_t pitch = columns(level_side(parsed.info.width, tile.level)) * storage.unit_size;
  const uint64_t slice = rows(level_side(parsed.info.height, tile.level)) * pitch;
  uint64_t at = parsed.levels[tile.level].offset + columns(tile.area.x) * storage.unit_size +
                rows(tile.area.y) * pitch + tile.layer * (parsed.info.depth ? slice : parsed.image_stride[tile.level]);
  const size_t row = static_cast<size_t>(columns(tile.area.width) * storage.unit_size);
  const bool three = image::has_three_numbers(pixels);
  auto* texels = static_cast<unsigned char*>(tile.texels);
  for (uint64_t y = 0; y < rows(tile.area.height); ++y, at += pitch, texels += tile.row_stride) {
    unsigned char* const to = three ? texels + tile.area.width * pixels.channel_size : texels;
    int error = 0;
    if (core::read_at(tiles.file.fd, at, row, to, &error) < row) refuse_read(tiles, tile, error);
    if (pixels.channel_size > 1) {
      order_bytes(SHD_BYTE_ORDER_LITTLE, pixels.channel_size == 2 ? SHD_RAW_SAMPLE_U16 : SHD_RAW_SAMPLE_F32,
                  row / pixels.channel_size, to);
    }
    if (three) expand_row(tile.area.width, pixels.channel_size, texels);
  }
}

}  // namespace shd::io
