// SPDX-License-Identifier: MIT
#include <shd/tile_cache.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "texture/store/tiles/budget.h"
#include "texture/store/tiles/cache.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_result check_cache_desc(const shd_tile_cache_desc& desc) {
  SHD_TRY(check_count("tile_cache.tile_bytes", desc.tile_bytes, 1024, 1u << 20));
  if (desc.tile_bytes & (desc.tile_bytes - 1)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "tile_cache.tile_bytes: %u is not a power of two", desc.tile_bytes);
  }
  return check_count("tile_cache.budget_bytes", desc.budget_bytes, texture::smallest_tile_budget(desc.tile_bytes),
                     uint64_t{1} << 31);
}

void destroy_cache(core::Context& context, void* body) {
  texture::TileCache::destroy(context.allocator, static_cast<texture::TileCache*>(body));
}

}  // namespace

extern "C" {

shd_result shd_tile_cache_create(shd_context* context, const shd_tile_cache_desc* desc, shd_tile_cache** out_cache) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_cache", out_cache));
    *out_cache = nullptr;
    SHD_TRY(check_context(context));
    shd_tile_cache_desc read = shd_tile_cache_desc_default();
    SHD_TRY(read_desc("tile_cache", desc, true, &read));
    SHD_TRY(check_cache_desc(read));
    core::Context& owner = context_of(context);
    texture::TileCache* const body = texture::TileCache::create(owner.allocator, read);
    try {
      core::Object* const object =
          core::make_object(owner, static_cast<uint32_t>(core::ObjectType::kTileCache), body, destroy_cache);
      *out_cache = reinterpret_cast<shd_tile_cache*>(object);
    } catch (...) {
      texture::TileCache::destroy(owner.allocator, body);
      throw;
    }
    return SHD_OK;
  });
}

void shd_tile_cache_retain(shd_tile_cache* cache) {
  retain_handle(cache, core::ObjectType::kTileCache);
}

void shd_tile_cache_release(shd_tile_cache* cache) {
  release_handle(cache, core::ObjectType::kTileCache);
}

shd_result shd_tile_cache_get_stats(const shd_tile_cache* cache, shd_tile_cache_stats* out_stats) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_stats", out_stats));
    texture::TileCache* body;
    SHD_TRY(read_handle("cache", cache, core::ObjectType::kTileCache, &body));
    shd_tile_cache_stats stats = shd_tile_cache_stats_default();
    body->get_stats(&stats);
    write_desc(stats, out_stats);
    return SHD_OK;
  });
}

shd_result shd_tile_cache_load_requested(shd_tile_cache* cache, size_t max_tiles, size_t* out_loaded_count) {
  return guard([&]() -> shd_result {
    if (out_loaded_count) *out_loaded_count = 0;
    texture::TileCache* body;
    SHD_TRY(read_handle("cache", cache, core::ObjectType::kTileCache, &body));
    const size_t loaded = body->load_requested(static_cast<uint32_t>(std::min<size_t>(max_tiles, UINT32_MAX)));
    if (out_loaded_count) *out_loaded_count = loaded;
    return SHD_OK;
  });
}

}  // extern "C"
