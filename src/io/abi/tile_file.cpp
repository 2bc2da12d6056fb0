// SPDX-License-Identifier: MIT
#include <shd/tile_file.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "core/guard.h"
#include "image/channel.h"
#include "io/abi/common.h"
#include "io/abi/loads.h"
#include "io/bitmap/levels.h"
#include "io/codec/tiles.h"
#include "io/container/texture_tiles.h"
#include "io/file/printable.h"
#include "io/file/udim.h"

namespace {

using namespace shd;
using namespace shd::extension;

constexpr uint32_t kMaxSide = 1 << 20;

struct CloseSet {
  void operator()(io::TiledSet* set) const { io::close_tiled_set(set); }
};

/// The tiles of a texture, by OpenImageIO.
struct Provider {
  io::FileGrid grid;
  io::TiledInfo info;
  std::unique_ptr<io::TiledSet, CloseSet> set;
  unsigned char fill[16] = {};  // a texel of absent files
};

void store_fill(const image::FormatInfo& format, const float* fill, unsigned char* out) {
  for (size_t c = 0; c < format.channels; ++c, out += format.channel_size) {
    image::store_channel(image::channel_component(format, c), static_cast<double>(fill[c]), out);
  }
}

/// Texels that two ranges share, in texels of the second one.
struct Overlap {
  uint32_t begin, end;  // in the tile
  uint32_t at;          // place of `begin` in the file

  Overlap(uint32_t first, uint32_t count, uint32_t file_first, uint32_t file_size)
      : begin(std::max(first, file_first)),
        end(std::min(first + count, file_first + file_size)),
        at(begin - file_first) {}
};

void fill_tile(const Provider& provider, const shd_tile& tile, const Overlap& x, const Overlap& y) {
  const size_t pixel = shd_format_size(provider.info.format);
  for (uint32_t row = y.begin; row < y.end; ++row) {
    auto* texel = static_cast<unsigned char*>(tile.texels) + (row - tile.area.y) * tile.row_stride +
                  (x.begin - tile.area.x) * pixel;
    for (uint32_t i = x.begin; i < x.end; ++i, texel += pixel) std::memcpy(texel, provider.fill, pixel);
  }
}

void load_tile(const Provider& provider, const shd_tile& tile) {
  const io::FileGrid& grid = provider.grid;
  const uint32_t width = io::level_side(provider.info.width, tile.level);
  const uint32_t height = io::level_side(provider.info.height, tile.level);
  for (uint32_t row = tile.area.y / height; row * height < tile.area.y + tile.area.height; ++row) {
    for (uint32_t column = tile.area.x / width; column * width < tile.area.x + tile.area.width; ++column) {
      const Overlap x(tile.area.x, tile.area.width, column * width, width),
          y(tile.area.y, tile.area.height, row * height, height);
      const int32_t file = grid.file[size_t{grid.rows - 1 - row} * grid.columns + column];
      if (file < 0) {
        fill_tile(provider, tile, x, y);
        continue;
      }
      auto* texels = static_cast<unsigned char*>(tile.texels) + (y.begin - tile.area.y) * tile.row_stride +
                     (x.begin - tile.area.x) * shd_format_size(provider.info.format);
      io::read_tiled_set(*provider.set, {static_cast<size_t>(file), tile.level, x.at, y.at, x.end - x.begin,
                                         y.end - y.begin, texels, tile.row_stride});
    }
  }
}

template <class Source>
shd_result load_tiles(const shd_tile* tiles, size_t count, void* user_data) {
  return guard([&] {
    for (size_t i = 0; i < count; ++i) load_tile(*static_cast<const Source*>(user_data), tiles[i]);
    return SHD_OK;
  });
}

template <class Source>
void release_source(void* user_data) {
  delete static_cast<Source*>(user_data);
}

shd_tile_file_desc read_file_desc(const shd_tile_file_desc* in) {
  shd_tile_file_desc desc = shd_tile_file_desc_default();
  if (!in) refuse(SHD_ERROR_INVALID_ARGUMENT, "tile_file: NULL");
  read_desc("tile_file", in, &desc);
  if (!desc.cache) refuse(SHD_ERROR_INVALID_ARGUMENT, "tile_file.cache: NULL");
  if (static_cast<uint32_t>(desc.encoding) > SHD_COLOR_ENCODING_DATA) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "tile_file.encoding: %d is not a shd_color_encoding",
           static_cast<int>(desc.encoding));
  }
  if (desc.max_readers < 1 || desc.max_readers > 4096) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "tile_file.max_readers: %zu is not in 1..4096", desc.max_readers);
  }
  for (int c = 0; c < 4; ++c) {
    if (!std::isfinite(desc.fill[c])) refuse(SHD_ERROR_INVALID_ARGUMENT, "tile_file.fill[%d]: not finite", c);
  }
  return desc;
}

std::unique_ptr<Provider> open_provider(const io::FileGrid& grid, const shd_tile_file_desc& desc) {
  auto provider = std::make_unique<Provider>();
  provider->grid = grid;
  io::TiledPaths paths;
  paths.paths = provider->grid.paths;
  paths.encoding = desc.encoding;
  paths.max_readers = desc.max_readers;
  provider->set.reset(io::open_tiled_set(paths, &provider->info));
  store_fill(image::format_info(provider->info.format), desc.fill, provider->fill);
  return provider;
}

/// Levels of the whole grid: all of one file, else those whose sizes halve evenly in every file.
uint32_t grid_levels(const Provider& provider) {
  const io::TiledInfo& info = provider.info;
  if (provider.grid.file.size() == 1) return info.level_count;
  uint32_t count = 1;
  while (count < info.level_count && (info.width | info.height) % (1u << count) == 0) ++count;
  return count;
}

shd_texture_desc describe(const Provider& provider) {
  const io::FileGrid& grid = provider.grid;
  const uint64_t width = uint64_t{provider.info.width} * grid.columns;
  const uint64_t height = uint64_t{provider.info.height} * grid.rows;
  if (width > kMaxSide || height > kMaxSide) {
    refuse(SHD_ERROR_LIMIT, "%u x %u files of %u x %u texels: a side is above %u texels", grid.columns, grid.rows,
           provider.info.width, provider.info.height, kMaxSide);
  }
  shd_texture_desc texture = shd_texture_desc_default();
  texture.format = provider.info.format;
  texture.width = static_cast<uint32_t>(width);
  texture.height = static_cast<uint32_t>(height);
  texture.tables = SHD_TABLE_MIPMAP;
  if (provider.info.premultiplied) texture.flags = SHD_TEXTURE_PREMULTIPLIED;
  const uint32_t levels = grid_levels(provider);
  const uint32_t full = io::full_level_count(texture.width, texture.height);
  texture.level_count = levels == full ? 0 : levels - 1;
  if (levels == 1 && full > 1) texture.tables = SHD_TABLE_NONE;
  return texture;
}

/// The first cube map of an array, as shd_texture_load() has it.
shd_texture_desc describe(const io::StoredTiles& file) {
  const io::TextureFile& parsed = file.parsed;
  const shd_texture_file_info& info = parsed.info;
  shd_texture_desc texture =
      describe_stored(info, info.face_count == 6 ? 6 : info.layer_count, parsed.swizzle, parsed.fill);
  if (image::has_three_numbers(image::format_info(info.format))) {
    texture.format = expanded_format(info.format);
    if (texture.swizzle[3] == SHD_CHANNEL_DEFAULT) texture.swizzle[3] = SHD_CHANNEL_FILL;
  }
  texture.level_count = info.level_count - 1;
  if (info.level_count > 1 || io::whole_level_count(info) == 1) texture.tables = SHD_TABLE_MIPMAP;
  return texture;
}

shd_tile_file_info info_of(const Provider& provider) {
  shd_tile_file_info info = shd_tile_file_info_default();
  info.column_count = provider.grid.columns;
  info.row_count = provider.grid.rows;
  info.file_count = static_cast<uint32_t>(provider.grid.paths.size());
  info.tile_width = provider.info.tile_width;
  info.tile_height = provider.info.tile_height;
  return info;
}

shd_tile_file_info info_of(const io::StoredTiles& file) {
  shd_tile_file_info info = shd_tile_file_info_default();
  info.column_count = info.row_count = info.file_count = 1;
  info.tile_width = file.parsed.storage.block_width;
  info.tile_height = file.parsed.storage.block_height;
  return info;
}

}  // namespace

extern "C" shd_result shd_texture_open(shd_context* context, const char* path, const shd_tile_file_desc* in,
                                       shd_texture** out_texture, shd_tile_file_info* out_info) {
  return guard([&]() -> shd_result {
    if (!out_texture) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_texture: NULL");
    *out_texture = nullptr;
    if (out_info) require(begin_output("out_info", out_info));
    require_context(context);
    const shd_tile_file_desc desc = read_file_desc(in);
    require_path(path);
    const io::FileGrid grid = io::find_files(path);
    const auto open = [&](auto source) {
      using Source = typename decltype(source)::element_type;
      shd_texture_desc texture = describe(*source);
      texture.tiles = {desc.cache, load_tiles<Source>, release_source<Source>, source.get()};
      const shd_result result = shd_texture_create(context, &texture, out_texture);
      if (result != SHD_OK) return result;
      // The texture owns it now.
      const Source& owned = *source.release();
      if (out_info) write_desc(info_of(owned), out_info);
      return result;
    };
    auto stored = io::open_stored_tiles(grid.paths[0], desc.encoding, memory_of(context));
    if (!stored) return open(open_provider(grid, desc));
    if (grid.file.size() == 1) return open(std::move(stored));
    refuse(SHD_ERROR_UNSUPPORTED, "\"%s\": sets of KTX2 or DDS files", io::printable(path).c_str());
  });
}
