// SPDX-License-Identifier: MIT
#include <shd/tiles.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "texture/store/storage.h"
#include "texture/store/tiles/regions.h"

namespace {

using namespace shd;
using namespace shd::abi;

/// A texture in tiles, and a region of it.
shd_result read_region(const shd_texture* handle, const shd_tile_region* region, const texture::Texture** texture,
                       shd_tile_region* out) {
  SHD_TRY(read_handle("texture", handle, core::ObjectType::kTexture, texture));
  const texture::Texture& body = **texture;
  if (!body.tiles) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture: not in tiles");
  *out = shd_tile_region_default();
  SHD_TRY(read_desc("region", region, false, out));
  SHD_TRY(check_count("region.level", out->level, 0, body.level_count - 1));
  const uint32_t images = body.depth != 0 ? texture::level_size(body.depth, out->level) : body.layers;
  SHD_TRY(check_count("region.layer", out->layer, 0, images - 1));
  const uint32_t width = texture::level_size(body.width, out->level);
  const uint32_t height = texture::level_size(body.height, out->level);
  SHD_TRY(check_count("region.area.x", out->area.x, 0, width - 1));
  SHD_TRY(check_count("region.area.y", out->area.y, 0, height - 1));
  SHD_TRY(check_count("region.area.width", out->area.width, 1, width - out->area.x));
  return check_count("region.area.height", out->area.height, 1, height - out->area.y);
}

}  // namespace

extern "C" {

shd_result shd_texture_load_tiles(const shd_texture* texture, const shd_tile_region* region) {
  return guard([&]() -> shd_result {
    const texture::Texture* body;
    shd_tile_region read;
    SHD_TRY(read_region(texture, region, &body, &read));
    texture::load_region(*body, read);
    return SHD_OK;
  });
}

shd_result shd_texture_pin_tiles(const shd_texture* texture, const shd_tile_region* region) {
  return guard([&]() -> shd_result {
    const texture::Texture* body;
    shd_tile_region read;
    SHD_TRY(read_region(texture, region, &body, &read));
    if (texture::pin_region(*body, read)) return SHD_OK;
    return core::fail(SHD_ERROR_LIMIT, "region: %u x %u texels of level %u, but half of the cache is pinned then",
                      read.area.width, read.area.height, read.level);
  });
}

shd_result shd_texture_unpin_tiles(const shd_texture* texture, const shd_tile_region* region) {
  return guard([&]() -> shd_result {
    const texture::Texture* body;
    shd_tile_region read;
    SHD_TRY(read_region(texture, region, &body, &read));
    if (texture::unpin_region(*body, read)) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "region: a tile of it is not pinned");
  });
}

shd_result shd_texture_drop_tiles(const shd_texture* texture, const shd_tile_region* region) {
  return guard([&]() -> shd_result {
    const texture::Texture* body;
    shd_tile_region read;
    SHD_TRY(read_region(texture, region, &body, &read));
    texture::drop_region(*body, read);
    return SHD_OK;
  });
}

}  // extern "C"
