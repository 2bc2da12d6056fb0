/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Tiles of a texture in a tile cache: load them ahead, pin them, or drop tiles whose source has changed.
 *
 * Lookups load tiles themselves (shd/tile_cache.h). These functions are for hosts that can tell more: which part comes
 * into view next, or which part of the source has changed. Textures without `tiles` give SHD_ERROR_INVALID_ARGUMENT.
 *
 * Thread safety: every function from any thread, concurrently with lookups.
 *
 * @code
 * shd_tile_region region = shd_tile_region_default();
 * region.level = 3, region.area.width = region.area.height = 4096; // texels of level 3
 * result = shd_texture_load_tiles(texture, &region);
 * @endcode
 */
#ifndef SHD_TILES_H
#define SHD_TILES_H

#include <shd/texture.h>

SHD_BEGIN_DECLS

/** A rectangle of a level. Required: area. */
typedef struct shd_tile_region {
    uint32_t struct_size; /**< set by shd_tile_region_default() */
    uint32_t layer;       /**< layer, face, or slice of the level of a 3D texture; default 0 */
    uint32_t level;       /**< 0..level_count - 1; default 0 */
    shd_region area;      /**< texels of the level; not empty, and inside the level */
    /* ---- end of 0.1; append below ---- */
} shd_tile_region;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_tile_region shd_tile_region_default(void)
{
    shd_tile_region region = SHD_ZERO_INIT;
    region.struct_size = (uint32_t)sizeof region;
    return region;
}

/**
 * Load the tiles of a region that are not resident. They may be evicted again, also by later tiles of the region if it
 * is larger than the cache.
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_load_tiles(const shd_texture *texture, const shd_tile_region *region);

/**
 * Load the tiles of a region, and keep them until shd_texture_unpin_tiles(). Each call counts. Half of the tiles of a
 * cache can be pinned; more give SHD_ERROR_LIMIT. If the call fails, it pins no tile.
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_pin_tiles(const shd_texture *texture, const shd_tile_region *region);

/**
 * Undo one shd_texture_pin_tiles() of the same region. A region with a tile that is not pinned gives
 * SHD_ERROR_INVALID_ARGUMENT, and nothing changes.
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_unpin_tiles(const shd_texture *texture, const shd_tile_region *region);

/**
 * Drop the tiles of a region, and the tiles of all coarser levels that cover it, because their source has changed.
 * Lookups that begin later load them again; lookups that run meanwhile may use either content. Pinned tiles stay
 * pinned. This call loads them again. If a load fails, it returns the error, and the next call that needs a tile loads
 * it.
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_drop_tiles(const shd_texture *texture, const shd_tile_region *region);

SHD_END_DECLS

#endif /* SHD_TILES_H */
