// SPDX-License-Identifier: MIT
// Callbacks of textures in tiles that look up their own cache, on any thread, release objects, block, and fork, while
// other threads look up, pin and drop. A test that hangs is ended by an alarm.
#include <semaphore.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <thread>
#include <utility>

#include "support/fault_allocator.h"
#include "support/random.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kSide = 256, kTile = 1024;  // tiles of 16 x 16 texels
constexpr uint64_t kSmallest = 4 * kTile + 65536;

shd_context *g_context;
shd_texture *g_original;
shd_texture_desc g_desc;
std::vector<unsigned char> g_texels(kSide *kSide * 4);

int setup(void **)
{
    alarm(200);
    for (size_t i = 0; i < g_texels.size(); ++i) g_texels[i] = static_cast<unsigned char>(i * 37 + i / 211);
    shd_context_desc context_desc = shd_context_desc_default();
    context_desc.worker_count = 2;
    if (shd_context_create(&context_desc, &g_context) != SHD_OK) return -1;
    g_desc = shd_texture_desc_default();
    g_desc.format = SHD_FORMAT_RGBA8;
    g_desc.width = g_desc.height = kSide;
    g_desc.texels = g_texels.data();
    g_desc.tables = SHD_TABLE_MIPMAP;
    return shd_texture_create(g_context, &g_desc, &g_original) == SHD_OK ? 0 : -1;
}
int teardown(void **)
{
    shd_texture_release(g_original);
    shd_context_release(g_context);
    return 0;
}

shd_sampler *make_sampler(shd_filter filter, float lod, shd_missing_tiles missing = SHD_MISSING_TILES_WAIT)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    desc.lod_min = lod;
    desc.missing_tiles = missing;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    return sampler;
}

TileLookups random_lookups(size_t count, uint64_t seed, double lod = 4.0)
{
    TileLookups at(count);
    Random random{seed};
    for (size_t i = 0; i < count; ++i) {
        at.column[0][i] = random.real(0.0, 1.0);
        at.column[1][i] = random.real(0.0, 1.0);
        for (int c = 2; c < 6; ++c) at.column[c][i] = random.scaled(-1.0, lod) / kSide;
    }
    return at;
}

/// One texel of a level.
TileLookups one_texel(uint32_t level, uint32_t x, uint32_t y)
{
    TileLookups at(1);
    const float size = static_cast<float>(kSide >> level);
    at.column[0][0] = (static_cast<float>(x) + 0.5f) / size;
    at.column[1][0] = (static_cast<float>(y) + 0.5f) / size;
    return at;
}

bool same(const TileLookups &a, const TileLookups &b)
{
    for (int c = 0; c < 4; ++c) {
        if (std::memcmp(a.out[c].data(), b.out[c].data(), 4 * a.count()) != 0) return false;
    }
    return true;
}

/// Whether lookups of a texture in tiles have the bits of the original.
bool right(const shd_texture *tiled, const shd_sampler *sampler, TileLookups at)
{
    TileLookups want = at;
    return want.sample(g_original, sampler) == SHD_OK && at.sample(tiled, sampler) == SHD_OK && same(want, at);
}

/// A texture in tiles whose callback calls `before` for each tile.
struct Tiled {
    TileSource source{g_original};
    shd_tile_cache *cache;
    shd_texture *texture = nullptr;
    std::function<shd_result(const shd_tile &tile)> before;

    explicit Tiled(shd_tile_cache *shared) : cache(shared)
    {
        shd_texture_desc desc = source.desc(g_desc, g_original, cache);
        desc.tiles = {cache, load, release, this};
        shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    }
    static shd_result load(const shd_tile *tiles, size_t count, void *user_data)
    {
        auto &self = *static_cast<Tiled *>(user_data);
        for (size_t i = 0; self.before && i < count; ++i) {
            if (const shd_result result = self.before(tiles[i])) return result;
        }
        return TileSource::load(tiles, count, &self.source);
    }
    static void release(void *user_data) { ++static_cast<Tiled *>(user_data)->source.released; }
};

void run_threads(uint32_t count, const std::function<void(uint32_t)> &body)
{
    std::vector<std::thread> threads;
    for (uint32_t t = 0; t < count; ++t) threads.emplace_back(body, t);
    for (std::thread &thread : threads) thread.join();
}

/// Callbacks make each level from the next finer one, and every second tile of level 0 from its left neighbour.
void test_dependent_tiles(void **)
{
    std::vector<shd_sampler *> nearest;
    for (int level = 0; level < 9; ++level) {
        nearest.push_back(make_sampler(SHD_FILTER_NEAREST_MIP, static_cast<float>(level)));
    }
    shd_sampler *sampler = make_sampler(SHD_FILTER_TRILINEAR, 0.0f);
    for (uint64_t budget : {kSmallest, uint64_t{1} << 20, uint64_t{1} << 26}) {
        for (uint64_t round = 0; round < 12; ++round) {
            shd_tile_cache *cache = make_tile_cache(g_context, kTile, budget);
            Tiled tiled(cache);
            tiled.before = [&](const shd_tile &tile) {
                const bool finer = tile.level > 0;
                if (!finer && (tile.area.x / 16 % 2 == 0 || round % 2)) return SHD_OK;
                const uint32_t level = finer ? tile.level - 1 : 0;
                const uint32_t x = finer ? 2 * tile.area.x : tile.area.x - 1, y = finer ? 2 * tile.area.y : tile.area.y;
                return right(tiled.texture, nearest[level], one_texel(level, x, y)) ? SHD_OK : SHD_ERROR_INTERNAL;
            };
            std::atomic<int> wrong{0};
            run_threads(4, [&](uint32_t t) {
                wrong += !right(tiled.texture, sampler, random_lookups(40, round + t % 2, 6.0));
            });
            assert_int_equal(wrong.load(), 0);
            shd_texture_release(tiled.texture);
            assert_int_equal(stats_of(cache).resident_tile_count, 0);
            shd_tile_cache_release(cache);
        }
    }
    for (shd_sampler *each : nearest) shd_sampler_release(each);
    shd_sampler_release(sampler);
}

/// A callback looks up more points than one task has, so that they run on several workers, in a cache for one lookup.
void test_nested_batch(void **)
{
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, 81920);
    Tiled inner(cache), outer(cache);
    shd_sampler *sampler = make_sampler(SHD_FILTER_BILINEAR, 0.0f);
    const TileLookups many = random_lookups(20000, 7);
    std::atomic<int> nested{0};
    outer.before = [&](const shd_tile &) {
        if (nested.fetch_add(1) > 5) return SHD_OK;
        return right(inner.texture, sampler, many) ? SHD_OK : SHD_ERROR_INTERNAL;
    };
    std::atomic<int> wrong{0};
    run_threads(3, [&](uint32_t t) { wrong += !right(outer.texture, sampler, random_lookups(30, t)); });
    assert_int_equal(wrong.load(), 0);
    assert_true(nested.load() > 5);
    shd_texture_release(outer.texture);
    shd_texture_release(inner.texture);
    shd_sampler_release(sampler);
    shd_tile_cache_release(cache);
}

/// The callback releases the last references to the texture, the cache and the sampler of the call that runs it.
void test_release(void **)
{
    enum Call { kLookup, kBatch, kPin, kLoad, kRequested, kReadLevel, kCalls };
    for (int call = 0; call < kCalls; ++call) {
        Tiled tiled(make_tile_cache(g_context, kTile, 1 << 20));
        shd_sampler *sampler = make_sampler(SHD_FILTER_BILINEAR, 0.0f);
        shd_sampler *coarser = make_sampler(SHD_FILTER_BILINEAR, 0.0f, SHD_MISSING_TILES_COARSER);
        TileLookups at = random_lookups(call == kBatch ? 40000 : 1, 1);
        shd_assert_ok(at.sample(tiled.texture, coarser));
        shd_sampler_release(coarser);
        shd_tile_cache_retain(tiled.cache);  // the reference of this test
        std::atomic<int> calls{0};
        tiled.before = [&](const shd_tile &) {
            if (calls.fetch_add(1) != 0) return SHD_OK;
            shd_texture_release(tiled.texture);
            shd_sampler_release(sampler);
            shd_tile_cache_release(tiled.cache);
            assert_int_equal(tiled.source.released.load(), 0);
            return SHD_OK;
        };
        shd_tile_region region = shd_tile_region_default();
        region.area.width = region.area.height = 40;
        std::vector<unsigned char> texels(g_texels.size());
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8, image.width = image.height = kSide, image.pixels = texels.data();
        shd_result result = SHD_OK;
        switch (call) {
            case kLookup:
            case kBatch: result = at.sample(tiled.texture, sampler); break;
            case kPin: result = shd_texture_pin_tiles(tiled.texture, &region); break;
            case kLoad: result = shd_texture_load_tiles(tiled.texture, &region); break;
            case kRequested: result = shd_tile_cache_load_requested(tiled.cache, 0, nullptr); break;
            default: result = shd_texture_read_level(tiled.texture, 0, 0, &image); break;
        }
        shd_assert_ok(result);
        assert_true(calls.load() > 0);
        assert_int_equal(tiled.source.released.load(), 1);
        const shd_tile_cache_stats stats = stats_of(tiled.cache);
        assert_int_equal(stats.resident_tile_count, 0);
        assert_int_equal(stats.pinned_tile_count, 0);
        shd_tile_cache_release(tiled.cache);
        if (call == kReadLevel) assert_memory_equal(texels.data(), g_texels.data(), texels.size());
    }
}

/// A texture of 32 x 16 texels in blocks of 16 bytes, whose callback looks up the texture itself.
struct BlockSource {
    shd_texture *texture = nullptr;
    shd_sampler *sampler = nullptr;
    bool endless = false, releases = false;  // looks up in every call; releases the texture
    int depth = 0, released = 0;

    static unsigned char byte(uint32_t x, uint32_t y, size_t i) { return static_cast<unsigned char>(x * 5 + y + i); }
    static shd_result load(const shd_tile *tiles, size_t count, void *user_data)
    {
        auto &self = *static_cast<BlockSource *>(user_data);
        for (size_t t = 0; t < count; ++t) {
            for (uint32_t y = 0; y < tiles[t].area.height; y += 4) {
                auto *to = static_cast<unsigned char *>(tiles[t].texels) + y / 4 * tiles[t].row_stride;
                for (size_t i = 0; i < tiles[t].area.width * 4; ++i)
                    to[i] = byte(tiles[t].area.x, tiles[t].area.y + y, i);
            }
        }
        if (self.depth != 0 && !self.endless) return SHD_OK;
        TileLookups at(1);
        ++self.depth;
        const shd_result result = at.sample(self.texture, self.sampler);
        --self.depth;
        if (std::exchange(self.releases, false)) shd_texture_release(self.texture);
        return result;
    }
    static void release(void *user_data) { ++static_cast<BlockSource *>(user_data)->released; }
};

/// Blocks are copied out beside the cache. The callback may look up the tile that it gives, and release the texture.
void test_read_blocks(void **)
{
    BlockSource source;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_image image = shd_image_default();
    unsigned char blocks[8 * 4 * 16];
    source.sampler = make_sampler(SHD_FILTER_NEAREST, 0.0f);
    desc.format = image.format = SHD_FORMAT_BC7;
    desc.width = image.width = 32, desc.height = image.height = 16;
    desc.tiles = {make_tile_cache(g_context, kTile, kSmallest), BlockSource::load, BlockSource::release, &source};
    image.pixels = blocks;
    shd_assert_ok(shd_texture_create(g_context, &desc, &source.texture));
    source.endless = true;
    shd_assert_result("endless", shd_texture_read_level(source.texture, 0, 0, &image), SHD_ERROR_CALLBACK,
                      "it looks up the tile that it loads");
    source.endless = false;
    source.releases = true;
    shd_assert_ok(shd_texture_read_level(source.texture, 0, 0, &image));
    assert_int_equal(source.released, 1);
    for (uint32_t i = 0; i < sizeof blocks; ++i) {
        const uint32_t y = i / 128 * 4, x = i % 128 / 64 * 16;
        assert_int_equal(blocks[i], BlockSource::byte(x, y, i % 64));
    }
    shd_sampler_release(source.sampler);
    shd_tile_cache_release(desc.tiles.cache);
}

/// Threads pin and unpin their tiles while others drop them: no pin is lost, and none is left.
void test_pins(void **)
{
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, 1 << 18);
    Tiled tiled(cache);
    tiled.before = [](const shd_tile &) {
        std::this_thread::yield();
        return SHD_OK;
    };
    std::atomic<bool> stop{false};
    std::atomic<int> failed{0};
    std::thread dropper([&] {
        shd_tile_region all = shd_tile_region_default();
        all.area.width = all.area.height = kSide;
        while (!stop) failed += shd_texture_drop_tiles(tiled.texture, &all) != SHD_OK;
    });
    run_threads(4, [&](uint32_t t) {
        shd_tile_region region = shd_tile_region_default();
        region.area.x = 16 * (t / 2), region.area.width = region.area.height = 20;
        for (int round = 0; round < 300; ++round) {
            failed += shd_texture_pin_tiles(tiled.texture, &region) != SHD_OK;
            failed += shd_texture_unpin_tiles(tiled.texture, &region) != SHD_OK;
        }
    });
    stop = true;
    dropper.join();
    assert_int_equal(failed.load(), 0);
    assert_int_equal(stats_of(cache).pinned_tile_count, 0);
    shd_texture_release(tiled.texture);
    shd_tile_cache_release(cache);
}

/// A callback that goes on only after another thread's lookups: they read what is resident, or must not wait.
void test_no_wait(void **)
{
    for (uint64_t budget : {kSmallest, uint64_t{1} << 20}) {
        shd_tile_cache *cache = make_tile_cache(g_context, kTile, budget);
        Tiled tiled(cache);
        shd_sampler *wait = make_sampler(SHD_FILTER_NEAREST, 0.0f);
        shd_sampler *coarser = make_sampler(SHD_FILTER_TRILINEAR, 0.0f, SHD_MISSING_TILES_COARSER);
        assert_true(right(tiled.texture, wait, one_texel(0, 3, 3)));
        sem_t inside, go_on;
        sem_init(&inside, 0, 0);
        sem_init(&go_on, 0, 0);
        std::atomic<int> calls{0};
        tiled.before = [&](const shd_tile &) {
            if (calls.fetch_add(1) == 0) {
                sem_post(&inside);
                while (sem_wait(&go_on) != 0) {
                }
            }
            return SHD_OK;
        };
        bool slow_right = false;
        std::thread slow([&] { slow_right = right(tiled.texture, wait, one_texel(0, 100, 100)); });
        while (sem_wait(&inside) != 0) {
        }
        for (int i = 0; i < 20; ++i) {
            TileLookups at = random_lookups(100, static_cast<uint64_t>(i));
            shd_assert_ok(at.sample(tiled.texture, coarser));
            assert_true(right(tiled.texture, wait, one_texel(0, 3, 3)));
        }
        sem_post(&go_on);
        slow.join();
        assert_true(slow_right);
        shd_texture_release(tiled.texture);
        shd_sampler_release(wait);
        shd_sampler_release(coarser);
        shd_tile_cache_release(cache);
    }
}

/// Two callbacks wait for threads of their own, which need the tile that the other callback loads.
void test_own_threads(void **)
{
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, 1 << 20);
    Tiled tiled(cache);
    shd_sampler *sampler = make_sampler(SHD_FILTER_NEAREST, 0.0f);
    std::atomic<int> inside{0}, wrong{0};
    tiled.before = [&](const shd_tile &tile) {
        const int number = inside.fetch_add(1);
        if (number >= 2) return SHD_OK;
        while (inside < 2) std::this_thread::yield();
        std::thread own([&, tile] { wrong += !right(tiled.texture, sampler, one_texel(0, tile.area.x ? 0 : 100, 0)); });
        own.join();
        return SHD_OK;
    };
    run_threads(2, [&](uint32_t t) { wrong += !right(tiled.texture, sampler, one_texel(0, t ? 100 : 0, 0)); });
    assert_int_equal(wrong.load(), 0);
    shd_texture_release(tiled.texture);
    shd_sampler_release(sampler);
    shd_tile_cache_release(cache);
}

/// Ends a child: 0 if everything in the cache works there.
[[noreturn]] void end_child(const Tiled &tiled, const shd_sampler *sampler, bool was_right)
{
    alarm(20);
    bool all = was_right;
    for (uint64_t seed = 100; seed < 104; ++seed) all = all && right(tiled.texture, sampler, random_lookups(60, seed));
    shd_tile_region region = shd_tile_region_default();
    region.area.width = region.area.height = 64;
    all = all && shd_texture_pin_tiles(tiled.texture, &region) == SHD_OK;
    all = all && shd_texture_drop_tiles(tiled.texture, &region) == SHD_OK;
    all = all && shd_texture_unpin_tiles(tiled.texture, &region) == SHD_OK;
    all = all && shd_tile_cache_load_requested(tiled.cache, 0, nullptr) == SHD_OK;
    shd_texture_release(tiled.texture);
    shd_tile_cache_stats stats = shd_tile_cache_stats_default();
    all = all && shd_tile_cache_get_stats(tiled.cache, &stats) == SHD_OK && stats.resident_tile_count == 0;
    all = all && stats.pinned_tile_count == 0 && tiled.source.released == 1;
    _exit(all ? 0 : 1);
}

void assert_child_ok(pid_t child)
{
    assert_true(child > 0);
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
}

/// Children use a cache in which other threads of the parent look up, load, wait, pin and drop.
void test_fork(void **)
{
    shd_sampler *sampler = make_sampler(SHD_FILTER_TRILINEAR, 0.0f);
    for (uint64_t budget : {kSmallest, uint64_t{1} << 20}) {
        shd_tile_cache *cache = make_tile_cache(g_context, kTile, budget);
        Tiled tiled(cache);
        tiled.before = [](const shd_tile &) {
            std::this_thread::yield();
            return SHD_OK;
        };
        std::atomic<bool> stop{false};
        std::thread busy([&] {
            run_threads(4, [&](uint32_t t) {
                shd_tile_region region = shd_tile_region_default();
                region.area.width = region.area.height = kSide;
                for (uint64_t seed = t; !stop; ++seed) {
                    right(tiled.texture, sampler, random_lookups(30, seed % 8));
                    if (t == 3) (void)!shd_texture_drop_tiles(tiled.texture, &region);
                }
            });
        });
        for (int i = 0; i < 25; ++i) {
            const pid_t child = fork();
            if (child == 0) end_child(tiled, sampler, true);
            assert_child_ok(child);
        }
        stop = true;
        busy.join();
        shd_texture_release(tiled.texture);
        shd_tile_cache_release(cache);
    }
    shd_sampler_release(sampler);
}

/// A callback forks: the child ends the callback and its lookup, and goes on.
void test_fork_in_callback(void **)
{
    shd_sampler *sampler = make_sampler(SHD_FILTER_TRILINEAR, 0.0f);
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, kSmallest);
    Tiled tiled(cache);
    const pid_t parent = getpid();
    std::atomic<int> calls{0};
    std::atomic<bool> stop{false};
    pid_t child = -1;
    std::thread::id forker = std::this_thread::get_id();
    tiled.before = [&](const shd_tile &) {
        if (std::this_thread::get_id() == forker && calls.fetch_add(1) == 3) child = fork();
        return SHD_OK;
    };
    std::thread busy([&] {
        run_threads(3, [&](uint32_t t) {
            for (uint64_t seed = t; !stop; ++seed) right(tiled.texture, sampler, random_lookups(30, seed % 8));
        });
    });
    const bool all = right(tiled.texture, sampler, random_lookups(60, 50));
    if (getpid() != parent) end_child(tiled, sampler, all);
    stop = true;
    busy.join();
    assert_true(all);
    assert_child_ok(child);
    shd_texture_release(tiled.texture);
    shd_sampler_release(sampler);
    shd_tile_cache_release(cache);
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dependent_tiles),
        cmocka_unit_test(test_nested_batch),
        cmocka_unit_test(test_release),
        cmocka_unit_test(test_read_blocks),
        cmocka_unit_test(test_pins),
        cmocka_unit_test(test_no_wait),
        cmocka_unit_test(test_own_threads),
        cmocka_unit_test(test_fork),
        cmocka_unit_test(test_fork_in_callback),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
