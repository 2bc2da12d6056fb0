// SPDX-License-Identifier: MIT
// The code of tile caches with two or three threads in every order: no dead-lock, no lost wake, no lost pin, and each
// lookup reads its tile. The sources are compiled once more, with locks and atomics of support/ordered_sync.h.
#include <cstring>
#include <new>
#include <stdexcept>

#define SHD_TEXTURE_TILE_SYNC "support/ordered_sync.h"
#define shd shd_ordered  // libshd has the same names

#include "core/allocator.cpp"
#include "core/status.cpp"

#include "core/call.cpp"
#include "texture/store/storage.cpp"
#include "texture/store/tiles/budget.cpp"
#include "texture/store/tiles/cache.cpp"
#include "texture/store/tiles/fork.cpp"
#include "texture/store/tiles/lease.cpp"
#include "texture/store/tiles/load.cpp"
#include "texture/store/tiles/requests.cpp"
#include "texture/store/tiles/resolve.cpp"
#include "texture/store/tiles/slots.cpp"
#include "texture/store/tiles/table.cpp"
#include "texture/store/tiles/tile.cpp"

#include "support/check.h"

namespace shd::core {

bool retain(Object* object, uint32_t) noexcept {
  if (object) ++object->references;
  return object != nullptr;
}
bool release(Object* object, uint32_t) noexcept {
  if (object) --object->references;
  return object != nullptr;
}
bool drop_reference(Object*) noexcept {
  return true;
}

}  // namespace shd::core

namespace shd::texture {

// Parts that these textures do not have.
DecodeBc decoder_of(shd_format) {
  return nullptr;
}
void destroy_part(DecodedTexture*) noexcept {}

uint32_t full_level_count(uint32_t, uint32_t, uint32_t) {
  throw std::logic_error("textures of this test have given levels");
}

namespace {

constexpr uint32_t kTileBytes = 1 << 20, kTilesAcross = 8, kLevels = 4;
/// Tiles of level 0 are 0 to 7, of level 1 8 to 11, of level 2 12 and 13, of level 3 14.
constexpr uint32_t kFirst[kLevels] = {0, 8, 12, 14};

alignas(64) unsigned char g_memory[18 << 20];

void* allocate(size_t size, size_t alignment, void*) {
  return size > kTileBytes ? g_memory : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
void release_memory(void* memory, size_t, size_t, void*) {
  if (memory != g_memory) std::free(memory);
}

/// The tiles that a callback makes tiles from.
enum class Source { kPlain, kFinerLevel, kNeighbour };

struct World;
shd_result load_tiles(const shd_tile* tiles, size_t count, void* user_data);

/// One run: a cache, and a texture whose tile i has the texel i + 1.
struct World {
  core::Allocator allocator = {{allocate, release_memory, nullptr}};
  core::Object handle{};
  Texture texture{};
  TileCache* cache = nullptr;
  Source source;
  std::atomic<int> gate{0};  // callbacks wait while it is above 0

  World(uint32_t slots, Source from) : source(from) {
    shd_tile_cache_desc desc = shd_tile_cache_desc_default();
    desc.tile_bytes = kTileBytes;
    desc.budget_bytes = uint64_t{slots} * kTileBytes + 65536;
    cache = TileCache::create(allocator, desc);
    texture.store = Store::kTiles;
    texture.format = SHD_FORMAT_R8;
    texture.component = image::Component::kUnorm8;
    texture.channels = texture.layers = 1;
    texture.width = kTilesAcross << 10;
    texture.height = 1 << 10;
    texture.level_count = kLevels;
    TileSet* const set = core::create<TileSet>(allocator);
    set->cache = cache;
    set->cache_handle = nullptr;
    set->source = {nullptr, load_tiles, nullptr, this};
    set->allocator = &allocator;
    set->texture = &texture;
    set->handle = &handle;
    lay_out(tile_shape(kTileBytes, 1), &texture);
    cache->add(set);
    texture.tiles = Owned<TileSet>(set);
  }
  ~World() {
    shd_tile_cache_stats stats = shd_tile_cache_stats_default();
    cache->get_stats(&stats);
    if (stats.pinned_tile_count != 0) broken("a pin was left");
    texture.tiles = Owned<TileSet>();
    cache->get_stats(&stats);
    if (stats.resident_tile_count != 0) broken("a tile was left");
    TileCache::destroy(allocator, cache);
  }
  const TileSet& set() const { return *texture.tiles; }

  [[noreturn]] static void broken(const char* what) { orders::Explorer::current()->report(what); }

  /// Looks up the first texel of a tile, as kernels do with texels that their lease does not keep.
  uint32_t read(uint32_t tile, bool coarser = false) {
    Stream stream;
    TileCall call(texture);
    uint8_t needed[1] = {};
    if (coarser) call.needed = needed, call.lookup_end = 1;
    call.lease->begin_stream();
    stream.op[0] = kStart | kLast;
    stream.index[0][0] = 0;
    call.wanted[0][0] = static_cast<int32_t>(tile);
    WaitingElements waiting;
    waiting.add(0);
    resolve(&call, waiting, 1, 1, &stream);
    orders::point();
    return call.origin[stream.index[0][0]];
  }
  void look_up(uint32_t tile) {
    try {
      if (read(tile) != tile + 1) broken("a lookup read another tile");
    } catch (const std::exception& error) {
      broken(error.what());
    }
  }
  bool pin(uint32_t tile) {
    try {
      return cache->pin(set(), tile);
    } catch (const std::exception& error) {
      broken(error.what());
    }
  }
};

shd_result load_tiles(const shd_tile* tiles, size_t count, void* user_data) {
  World& world = *static_cast<World*>(user_data);
  try {
    for (size_t i = 0; i < count; ++i) {
      const uint32_t in_level = tiles[i].area.x >> 10, tile = kFirst[tiles[i].level] + in_level;
      if (world.source == Source::kFinerLevel && tiles[i].level > 0) {
        const uint32_t finer = kFirst[tiles[i].level - 1] + 2 * in_level;
        if (world.read(finer) != finer + 1) World::broken("a callback read another tile");
      }
      if (world.source == Source::kNeighbour && in_level > 0 && world.read(tile - 1) != tile) {
        World::broken("a callback read another tile");
      }
      orders::point();
      *static_cast<unsigned char*>(tiles[i].texels) = 0;
      while (world.gate.load() > 0) yield_tile_thread();
      orders::point();
      *static_cast<unsigned char*>(tiles[i].texels) = static_cast<unsigned char>(tile + 1);
    }
  } catch (const core::Failure& failure) {
    return failure.code;
  }
  return SHD_OK;
}

using Bodies = std::vector<std::function<void()>>;

/// Runs bodies(world) in every order.
template <class Make>
void explore(const char* name, int threads, int preemptions, bool atomics, uint32_t slots, Source source, Make make) {
  orders::Explorer explorer(threads, preemptions, atomics);
  bool more = true;
  while (more) {
    World world(slots, source);
    more = explorer.run(make(world));
  }
  print_message("%s: %llu orders\n", name, static_cast<unsigned long long>(explorer.runs));
}

/// Threads that need each other's tiles, when callbacks make levels from finer levels, or tiles from their neighbours.
void test_dependent_tiles(void**) {
  explore("levels", 3, 2, false, 4, Source::kFinerLevel, [](World& w) {
    return Bodies{[&] { w.look_up(8); }, [&] { w.look_up(8); }, [&] { w.look_up(0), w.look_up(9); }};
  });
  // Calls of several levels, and batches of more than a tile.
  explore("mixed", 2, 3, false, 16, Source::kFinerLevel, [](World& w) {
    const auto fetch = [&w](std::initializer_list<uint32_t> tiles) {
      w.cache->load(w.set(), tiles.begin(), tiles.size());
    };
    return Bodies{[=] { fetch({0, 1, 9}); }, [=] { fetch({2, 3, 8}); }};
  });
  explore("neighbours", 2, 3, false, 16, Source::kNeighbour, [](World& w) {
    const auto fetch = [&w](std::initializer_list<uint32_t> tiles) {
      w.cache->load(w.set(), tiles.begin(), tiles.size());
    };
    return Bodies{[=] { fetch({1, 2}); }, [=] { fetch({2, 3}); }};
  });
}

/// More callbacks inside callbacks than the cache has slots for, together.
void test_few_slots(void**) {
  explore("few slots", 3, 2, false, 4, Source::kFinerLevel, [](World& w) {
    return Bodies{[&] { w.look_up(14); }, [&] { w.look_up(14); }, [&] { w.look_up(13); }};
  });
}

/// Pins belong to the key: a drop by another thread neither loses nor adds any.
void test_pins(void**) {
  explore("pins", 3, 3, false, 4, Source::kPlain, [](World& w) {
    const auto pin = [&w] {
      if (!w.pin(3)) World::broken("not pinned");
      orders::point();
      if (!w.cache->is_pinned(w.set(), 3)) World::broken("a pin was lost");
      w.cache->unpin(w.set(), 3);
    };
    const auto drop = [&w] { w.cache->drop(w.set(), [](uint32_t) { return true; }); };
    return Bodies{pin, drop, [&w, pin] { pin(), w.look_up(3); }};
  });
}

/// Slots are evicted and filled while others read without the lock.
void test_eviction(void**) {
  explore("eviction", 2, 2, true, 4, Source::kPlain, [](World& w) {
    for (const uint32_t tile : {0, 1, 2}) w.look_up(tile);
    return Bodies{[&] { w.look_up(0), w.look_up(1); }, [&] { w.look_up(4), w.look_up(5), w.look_up(6), w.look_up(0); }};
  });
  explore("drop", 2, 2, true, 4, Source::kPlain, [](World& w) {
    return Bodies{[&] { w.look_up(0), w.look_up(0); },
                  [&] { w.cache->drop(w.set(), [](uint32_t) { return true; }), w.look_up(1); }};
  });
}

/// Lookups that find their tile, and lookups that must not wait, end while a callback does not.
void test_no_wait(void**) {
  explore("no wait", 3, 2, false, 4, Source::kPlain, [](World& w) {
    w.gate = 0;
    w.look_up(1);
    w.gate = 2;
    return Bodies{[&] { w.look_up(0); },
                  [&] {
                    w.look_up(1);
                    --w.gate;
                  },
                  [&] {
                    w.read(5, true);
                    --w.gate;
                  }};
  });
}

}  // namespace
}  // namespace shd::texture

int main() {
  using namespace shd::texture;
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_dependent_tiles), cmocka_unit_test(test_few_slots), cmocka_unit_test(test_pins),
      cmocka_unit_test(test_eviction),        cmocka_unit_test(test_no_wait),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
