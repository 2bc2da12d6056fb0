// SPDX-License-Identifier: MIT
#include <shd/tile_file.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "abi/io/common.h"
#include "core/guard.h"
#include "image/channel.h"
#include "io/levels.h"
#include "io/oiio_tiles.h"
#include "io/udim.h"

namespace {

using namespace shd;
using namespace shd::extension;

constexpr uint32_t kMaxSide = 1 << 20;

struct CloseSet {
  void operator()(io::TiledSet* set) const { io::close_tiled_set(set); }
};

/// The tiles of a texture: user_data of its callbacks.
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
    auto* texel =
        static_cast<unsigned char*>(tile.texels) + (row - tile.y) * tile.row_stride + (x.begin - tile.x) * pixel;
    for (uint32_t i = x.begin; i < x.end; ++i, texel += pixel) std::memcpy(texel, provider.fill, pixel);
  }
}

void load_tile(const Provider& provider, const shd_tile& tile) {
  const io::FileGrid& grid = provider.grid;
  const uint32_t width = io::level_side(provider.info.width, tile.level);
  const uint32_t height = io::level_side(provider.info.height, tile.level);
  for (uint32_t row = tile.y / height; row * height < tile.y + tile.height; ++row) {
    for (uint32_t column = tile.x / width; column * width < tile.x + tile.width; ++column) {
      const Overlap x(tile.x, tile.width, column * width, width), y(tile.y, tile.height, row * height, height);
      const int32_t file = grid.file[size_t{grid.rows - 1 - row} * grid.columns + column];
      if (file < 0) {
        fill_tile(provider, tile, x, y);
        continue;
      }
      auto* texels = static_cast<unsigned char*>(tile.texels) + (y.begin - tile.y) * tile.row_stride +
                     (x.begin - tile.x) * shd_format_size(provider.info.format);
      io::read_tiled_set(*provider.set, {static_cast<size_t>(file), tile.level, x.at, y.at, x.end - x.begin,
                                         y.end - y.begin, texels, tile.row_stride});
    }
  }
}

shd_result load_tiles(void* user_data, const shd_tile* tiles, size_t count) {
  return guard([&] {
    for (size_t i = 0; i < count; ++i) load_tile(*static_cast<const Provider*>(user_data), tiles[i]);
    return SHD_OK;
  });
}

void release_provider(void* user_data) {
  delete static_cast<Provider*>(user_data);
}

shd_tile_file_desc read_file_desc(const shd_tile_file_desc* in) {
  shd_tile_file_desc desc = shd_tile_file_desc_default();
  if (!in) refuse(SHD_ERROR_INVALID_ARGUMENT, "texture_file: NULL");
  read_desc("texture_file", in, &desc);
  if (!desc.cache) refuse(SHD_ERROR_INVALID_ARGUMENT, "texture_file.cache: NULL");
  if (static_cast<uint32_t>(desc.color_space) > SHD_COLOR_ENCODING_DATA) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "texture_file.color_space: %d is not a shd_color_encoding",
           static_cast<int>(desc.color_space));
  }
  if (desc.max_readers > 4096) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "tile_file.max_readers: %zu is not in 0..4096", desc.max_readers);
  }
  for (int c = 0; c < 4; ++c) {
    if (!std::isfinite(desc.fill[c])) refuse(SHD_ERROR_INVALID_ARGUMENT, "texture_file.fill[%d]: not finite", c);
  }
  return desc;
}

std::unique_ptr<Provider> open_provider(const char* path, const shd_tile_file_desc& desc) {
  require_path(path);
  auto provider = std::make_unique<Provider>();
  provider->grid = io::find_files(path);
  io::TiledPaths paths;
  paths.paths = provider->grid.paths;
  paths.encoding = desc.color_space;
  if (desc.max_readers) paths.max_readers = desc.max_readers;
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

shd_texture_desc describe(const Provider& provider, const shd_tile_file_desc& desc) {
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
  texture.tiles.cache = desc.cache;
  texture.tiles.load = load_tiles;
  texture.tiles.release = release_provider;
  return texture;
}

void write_info(const Provider& provider, shd_tile_file_info* out) {
  if (!out) return;
  shd_tile_file_info info = shd_tile_file_info_default();
  info.columns = provider.grid.columns;
  info.rows = provider.grid.rows;
  info.files = static_cast<uint32_t>(provider.grid.paths.size());
  info.tile_width = provider.info.tile_width;
  info.tile_height = provider.info.tile_height;
  write_desc(info, out);
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
    std::unique_ptr<Provider> provider = open_provider(path, desc);
    shd_texture_desc texture = describe(*provider, desc);
    texture.tiles.user_data = provider.get();
    const shd_result result = shd_texture_create(context, &texture, out_texture);
    if (result != SHD_OK) return result;
    // The texture owns it now.
    write_info(*provider.release(), out_info);
    return SHD_OK;
  });
}
