/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Tile caches: memory of a fixed size for textures that are larger than memory.
 *
 * A texture whose desc has `tiles` keeps no texels. Its levels consist of tiles, and a callback of the host writes the
 * texels of a tile when a lookup first needs them. The cache keeps the tiles that lookups used lately, within its
 * budget. It is shared by any number of textures of any contexts.
 *
 * A tile has `tile_bytes` bytes. It is as wide as high, or twice as wide: with 64 KiB a tile has 256 x 256 texels of 1
 * byte, 256 x 128 of 2, 128 x 128 of 4, 128 x 64 of 8 and 64 x 64 of 16 bytes. Sparse images have blocks of the same
 * shapes (Vulkan 1.3 specification, "Standard Sparse Image Block Shapes").
 *
 * Lookups have the same bits as those of a texture that keeps the same levels in memory, for any budget, with
 * SHD_MISSING_TILES_WAIT (shd/sampler.h). A lookup finds the tiles of many texels first, and loads those that are
 * missing together, the tiles of one level in a call. A tile that several threads need is loaded once, except as below.
 *
 * Rules for callbacks, and for calls while they run:
 *
 * 1. **Calls.** A callback may call every function of shd: look up textures of its own cache, other levels of its own
 *    texture, and other tiles of its own call; load, pin, drop, load requested tiles, and render.
 * 2. **Parts of the callback.** Lookups inside a callback belong to it, also those that the executor of a context runs
 *    on other threads.
 * 3. **No waiting for others.** Inside a callback, a tile that another thread loads at that moment is loaded a second
 *    time. So callbacks that need each other's tiles do not wait for each other. The first load that ends gives the
 *    tile of the cache.
 * 4. **Cycles.** A tile that needs itself gives SHD_ERROR_CALLBACK, "it looks up the tile that it loads", if no copy of
 *    it is resident. The other tiles of a call may be looked up: such a tile is then loaded alone.
 * 5. **Memory.** Each callback inside another one needs tiles of its own. If all tiles that can be evicted are in use
 *    by callbacks, lookups outside of callbacks wait until one ends. A lookup inside a callback waits as long as some
 *    callback can end, and otherwise gives SHD_ERROR_LIMIT. The outermost callback is then called once more, while no
 *    other outermost callback of the cache runs. So the error means: the cache is too small for this chain of
 *    callbacks. A cache has at least four tiles. Pins, and the tiles of running lookups, take up to two of them.
 * 6. **Blocking.** A callback that takes long delays nobody but lookups that need its tiles. Lookups of resident tiles,
 *    and lookups with SHD_MISSING_TILES_COARSER, wait for no callback. A lookup may wait while others filter: a cache
 *    of N MiB has working memory for N lookups at once, at most 64. No callback runs with it.
 * 7. **Threads of the host.** Lookups that a callback makes on threads of its own count as lookups of others. They wait
 *    at most one second for a tile that another thread loads, and then load it themselves.
 * 8. **Limit.** A call that finds no place for a tile gives SHD_ERROR_LIMIT if no callback of the cache ends for 60
 *    seconds.
 * 9. **Release.** A callback may release objects of the calls that run it, also the last reference to its texture or
 *    its cache. A reference to an object that is older than the callback is dropped when the outermost function of shd
 *    on this thread returns. References to objects that the callback made are dropped at once.
 * 10. **Pins.** Pins belong to a tile, not to its texels: dropping, failing loads and other threads leave them. A
 *    pinned tile that could not be loaded is loaded by the next call that needs it.
 * 11. **fork().** A child can use the cache, also if threads of the parent load, look up or wait at the fork. The tiles
 *    that they were loading are loaded again. A callback may fork: the child ends it.
 *
 * Lifetime:      reference counted; create returns an owned reference; a texture retains its cache.
 * Thread safety: every function from any thread.
 *
 * @code
 * static shd_result load(const shd_tile *tiles, size_t count, void *user_data); // writes tiles[i].texels
 *
 * shd_tile_cache_desc cache_desc = shd_tile_cache_desc_default();
 * cache_desc.budget_bytes = 512u << 20;
 * result = shd_tile_cache_create(context, &cache_desc, &cache);
 * shd_texture_desc desc = shd_texture_desc_default();
 * desc.format = SHD_FORMAT_RGBA8_SRGB, desc.width = desc.height = 524288;
 * desc.tables = SHD_TABLE_MIPMAP; // `load` also writes the mip levels
 * desc.tiles.cache = cache, desc.tiles.load = load, desc.tiles.user_data = file;
 * result = shd_texture_create(context, &desc, &texture);
 * @endcode
 */
#ifndef SHD_TILE_CACHE_H
#define SHD_TILE_CACHE_H

#include <shd/context.h>
#include <shd/image.h>

SHD_BEGIN_DECLS

/** Memory for the tiles of textures. */
typedef struct shd_tile_cache shd_tile_cache;

/** Size of a tile cache. */
typedef struct shd_tile_cache_desc {
    uint32_t struct_size; /**< set by shd_tile_cache_desc_default() */
    uint32_t tile_bytes;  /**< bytes of a tile, a power of two from 1024 to 2^20; default 65536 */
    /**
     * All memory of the cache: tiles, their table, and places for copies of texels; from 4 tiles plus 64 KiB to 2^31
     * bytes; default 2^28. It is allocated once. A small budget makes lookups slower, because tiles are loaded again.
     * Half of the tiles can be pinned.
     */
    uint64_t budget_bytes;
    /* ---- end of 0.1; append below ---- */
} shd_tile_cache_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_tile_cache_desc shd_tile_cache_desc_default(void)
{
    shd_tile_cache_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.tile_bytes = 65536;
    desc.budget_bytes = (uint64_t)1 << 28;
    return desc;
}

/** A tile that a callback fills. Frozen. */
typedef struct shd_tile {
    uint32_t layer; /**< layer, face, or slice of the level of a 3D texture */
    uint32_t level; /**< 0 = the base level */
    /** Texels of the level to write: a whole tile, less at the right and the lower edge of the level. */
    shd_region area;
    void *texels;      /**< rows of texels or of blocks, `row_stride` apart; aligned to 64 bytes; content undefined */
    size_t row_stride; /**< bytes between rows of texels or of blocks */
} shd_tile;

/**
 * Writes the texels of tiles of one level of a layer, face or slice, in the format of the texture. Tiles of a
 * compressed texture are written as rows of blocks; the last blocks of a row or column may reach beyond the level. The
 * cache keeps them decoded. It is called without a lock, from any thread that looks texels up, and by several threads
 * at once, sometimes for the same tile, whose memory is then another. It may call shd: see the rules above.
 * @return  SHD_OK, or the reason of a failure. Then no tile of the call is kept, the lookup returns SHD_ERROR_CALLBACK,
 *          or SHD_ERROR_CANCELLED for SHD_ERROR_CANCELLED, and the next lookup calls again
 */
typedef shd_result (*shd_load_tiles_fn)(const shd_tile *tiles, size_t count, void *user_data);

/** Source of the tiles of a texture. Frozen. */
typedef struct shd_tile_source {
    shd_tile_cache *cache;  /**< retained; NULL = the texture has its texels in memory */
    shd_load_tiles_fn load; /**< required with `cache` */
    /**
     * Called once, after the last `load`, when the texture is destroyed; may be NULL. It is not called if
     * shd_texture_create() fails.
     */
    void (*release)(void *user_data);
    void *user_data; /**< passed to both; borrowed until release of the texture */
} shd_tile_source;

/**
 * Make a tile cache.
 * @param context    retained; its allocator gives the memory
 * @param desc       borrowed for the call; NULL = all defaults
 * @param out_cache  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_tile_cache_create(shd_context *context, const shd_tile_cache_desc *desc,
                                                       shd_tile_cache **out_cache);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_tile_cache_retain(shd_tile_cache *cache);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_tile_cache_release(shd_tile_cache *cache);

/** Counters of a tile cache since its creation. */
typedef struct shd_tile_cache_stats {
    uint32_t struct_size;        /**< set by shd_tile_cache_stats_default() */
    uint32_t tile_bytes;         /**< bytes of a tile */
    uint64_t budget_bytes;       /**< as in its desc */
    uint64_t allocated_bytes;    /**< memory of the cache, at most the budget; it does not change */
    size_t tile_count;           /**< tiles that fit */
    size_t resident_tile_count;  /**< tiles in memory now */
    size_t pinned_tile_count;    /**< tiles that are pinned now */
    size_t requested_tile_count; /**< tiles that shd_tile_cache_load_requested() would load now */
    uint64_t load_count;         /**< calls of load callbacks */
    uint64_t loaded_tile_count;  /**< tiles that callbacks wrote */
    uint64_t failed_tile_count;  /**< tiles of calls that failed */
    uint64_t evicted_tile_count; /**< tiles that gave their place to others */
    uint64_t wait_count;         /**< waits of lookups for tiles that other threads loaded */
    /* ---- end of 0.1; append below ---- */
} shd_tile_cache_stats;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_tile_cache_stats shd_tile_cache_stats_default(void)
{
    shd_tile_cache_stats stats = SHD_ZERO_INIT;
    stats.struct_size = (uint32_t)sizeof stats;
    return stats;
}

/**
 * Get the counters of a cache.
 * @param out_stats  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_tile_cache_get_stats(const shd_tile_cache *cache, shd_tile_cache_stats *out_stats);

/**
 * Load tiles that lookups with SHD_MISSING_TILES_COARSER did not find, the latest request first. A cache keeps the
 * latest requests: up to 4096, or fewer if it has fewer tiles. An engine calls this on the threads that stream.
 * @param max_tiles         most tiles to load; 0 = all that are requested
 * @param out_loaded_count  number of tiles that were loaded; may be NULL; 0 on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_tile_cache_load_requested(shd_tile_cache *cache, size_t max_tiles,
                                                               size_t *out_loaded_count);

SHD_END_DECLS

#endif /* SHD_TILE_CACHE_H */
