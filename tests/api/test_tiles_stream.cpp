// SPDX-License-Identifier: MIT
// Textures in tiles: lookups that do not wait, requests, pins, changed sources, many threads, and a texture of 1 TiB.
#include <map>
#include <mutex>
#include <thread>

#include "support/fault_allocator.h"
#include "support/random.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kSide = 512;
shd_context *g_context;
shd_texture *g_original;
shd_texture_desc g_desc;
std::vector<unsigned char> g_texels(kSide *kSide * 4);

int setup(void **)
{
    for (size_t i = 0; i < g_texels.size(); ++i) g_texels[i] = static_cast<unsigned char>(i * 37 + i / 211);
    if (shd_context_create(nullptr, &g_context) != SHD_OK) return -1;
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

shd_texture *create(const shd_texture_desc &desc, shd_context *context = g_context)
{
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

shd_sampler *make_sampler(shd_filter filter, shd_missing_tiles missing, float lod_min = 0.0f)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    desc.lod_min = lod_min;
    desc.missing_tiles = missing;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    return sampler;
}

TileLookups random_lookups(size_t count, uint64_t seed)
{
    TileLookups at(count);
    Random random{seed};
    for (size_t i = 0; i < count; ++i) {
        at.column[0][i] = random.real(0.0, 1.0);
        at.column[1][i] = random.real(0.0, 1.0);
        for (int c = 2; c < 6; ++c) at.column[c][i] = random.scaled(-1.0, 4.0) / kSide;
    }
    return at;
}

shd_tile_region level_region(uint32_t level)
{
    shd_tile_region region = shd_tile_region_default();
    region.level = level;
    region.area.width = region.area.height = std::max(1u, kSide >> level);
    return region;
}

/// The texture in memory, filtered from the level that each lookup reports.
void compare_coarser(const TileLookups &got, shd_filter filter, uint32_t levels)
{
    for (uint32_t level = 0; level <= levels; ++level) {
        const bool plain = filter == SHD_FILTER_BILINEAR && level > 0;
        shd_sampler *sampler =
            make_sampler(plain ? SHD_FILTER_BILINEAR_MIP : filter, SHD_MISSING_TILES_WAIT, static_cast<float>(level));
        TileLookups want = got;
        shd_assert_ok(want.sample(g_original, sampler));
        for (size_t i = 0; i < got.count(); ++i) {
            if (got.coarser[i] != level) continue;
            for (int c = 0; c < 4; ++c) {
                const float value = level == levels ? 0.0f : want.out[c][i];
                if (std::memcmp(&value, &got.out[c][i], 4) != 0) {
                    fail_msg("filter %d, lookup %zu from level %u: %g, not %g", filter, i, level, double{got.out[c][i]},
                             double{value});
                }
            }
        }
        shd_sampler_release(sampler);
    }
}

size_t count_coarser(const TileLookups &at)
{
    size_t count = 0;
    for (uint32_t level : at.coarser) count += level != 0;
    return count;
}

void test_coarser(void **)
{
    for (shd_filter filter : {SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA}) {
        TileSource source(g_original);
        shd_tile_cache *cache = make_tile_cache(g_context, 4096, 1 << 23);
        shd_texture *tiled = create(source.desc(g_desc, g_original, cache));
        shd_sampler *sampler = make_sampler(filter, SHD_MISSING_TILES_COARSER);
        TileLookups at = random_lookups(700, filter);
        shd_assert_ok(at.sample(tiled, sampler));
        for (uint32_t level : at.coarser) assert_int_equal(level, source.levels);
        compare_coarser(at, filter, source.levels);
        assert_int_equal(source.calls.load(), 0);

        for (uint32_t level : {5u, 6u, 7u, 8u, 9u}) {
            const shd_tile_region region = level_region(level);
            shd_assert_ok(shd_texture_load_tiles(tiled, &region));
        }
        const int calls = source.calls;
        shd_assert_ok(at.sample(tiled, sampler));
        assert_int_equal(source.calls.load(), calls);
        compare_coarser(at, filter, source.levels);
        for (uint32_t level : at.coarser) assert_true(level <= 5);
        assert_true(count_coarser(at) > 0);
        assert_true(stats_of(cache).requested_tile_count > 0);

        size_t loaded = 0;
        shd_assert_ok(shd_tile_cache_load_requested(cache, 3, &loaded));
        assert_true(loaded > 0 && loaded <= 3);
        const size_t before = count_coarser(at);
        shd_assert_ok(at.sample(tiled, sampler));
        compare_coarser(at, filter, source.levels);
        assert_true(count_coarser(at) <= before);
        for (int round = 0; count_coarser(at) > 0 && round < 200; ++round) {
            shd_assert_ok(shd_tile_cache_load_requested(cache, 0, &loaded));
            shd_assert_ok(at.sample(tiled, sampler));
        }
        assert_int_equal(count_coarser(at), 0);
        compare_coarser(at, filter, source.levels);
        shd_sampler_release(sampler);
        shd_texture_release(tiled);
        shd_tile_cache_release(cache);
    }
}

/// EXACT waits for its texels, also of lookups whose footprint is a point, which are bilinear.
void test_exact_waits(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, 4096, 1 << 23);
    shd_texture *tiled = create(source.desc(g_desc, g_original, cache));
    shd_sampler *sampler = make_sampler(SHD_FILTER_EXACT, SHD_MISSING_TILES_COARSER);
    TileLookups want = random_lookups(90, 5);
    for (size_t i = 0; i < want.count(); i += 2) {
        for (size_t c = 2; c < 6; ++c) want.column[c][i] = 0.0f;
    }
    TileLookups got = want;
    shd_assert_ok(want.sample(g_original, sampler));
    shd_assert_ok(got.sample(tiled, sampler));
    assert_int_equal(count_coarser(got), 0);
    for (size_t c = 0; c < 4; ++c) assert_true(got.out[c] == want.out[c]);
    shd_sampler_release(sampler);
    shd_texture_release(tiled);
    shd_tile_cache_release(cache);
}

void test_pins(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, 4096, 1 << 18);
    shd_texture *tiled = create(source.desc(g_desc, g_original, cache));
    shd_sampler *sampler = make_sampler(SHD_FILTER_TRILINEAR, SHD_MISSING_TILES_WAIT);
    const shd_tile_region region = level_region(4), all = level_region(0);
    shd_assert_ok(shd_texture_pin_tiles(tiled, &region));
    shd_assert_ok(shd_texture_pin_tiles(tiled, &region));
    const uint32_t pinned = stats_of(cache).pinned_tile_count;
    assert_int_equal(pinned, 1);
    TileLookups at = random_lookups(500, 3);
    shd_assert_ok(at.sample(tiled, sampler));
    assert_true(stats_of(cache).evicted_tile_count > 0);
    int tiles = source.tiles;
    shd_assert_ok(shd_texture_load_tiles(tiled, &region));  // still there
    assert_int_equal(source.tiles.load(), tiles);
    shd_assert_result("too many", shd_texture_pin_tiles(tiled, &all), SHD_ERROR_LIMIT, "half of the cache");
    assert_int_equal(stats_of(cache).pinned_tile_count, pinned);
    shd_assert_result("not pinned", shd_texture_unpin_tiles(tiled, &all), SHD_ERROR_INVALID_ARGUMENT, "not pinned");

    // A pinned tile whose source changes is loaded again, and stays pinned.
    tiles = source.tiles;
    shd_assert_ok(shd_texture_drop_tiles(tiled, &all));
    assert_int_equal(source.tiles.load(), tiles + 1);
    assert_int_equal(stats_of(cache).pinned_tile_count, pinned);
    shd_assert_ok(shd_texture_unpin_tiles(tiled, &region));
    shd_assert_ok(shd_texture_unpin_tiles(tiled, &region));
    shd_assert_result("unpinned", shd_texture_unpin_tiles(tiled, &region), SHD_ERROR_INVALID_ARGUMENT, "not pinned");
    assert_int_equal(stats_of(cache).pinned_tile_count, 0);

    // If it cannot be loaded again, it stays pinned, and the next lookup loads it.
    shd_assert_ok(shd_texture_pin_tiles(tiled, &region));
    source.calls = 0;
    source.fail_at = 0;
    shd_assert_result("drop", shd_texture_drop_tiles(tiled, &all), SHD_ERROR_CALLBACK, "texture.tiles.load");
    source.fail_at = -1;
    assert_int_equal(stats_of(cache).pinned_tile_count, pinned);
    assert_int_equal(stats_of(cache).resident_tile_count, 0);
    shd_assert_ok(shd_texture_load_tiles(tiled, &region));
    assert_int_equal(stats_of(cache).resident_tile_count, 1);
    shd_assert_ok(shd_texture_drop_tiles(tiled, &all));
    shd_assert_ok(shd_texture_unpin_tiles(tiled, &region));
    assert_int_equal(stats_of(cache).pinned_tile_count, 0);

    // A pin that fails leaves nothing.
    shd_assert_ok(shd_texture_drop_tiles(tiled, &all));
    source.calls = 0;
    source.fail_at = 0;
    shd_assert_result("pin", shd_texture_pin_tiles(tiled, &region), SHD_ERROR_CALLBACK, "texture.tiles.load");
    source.fail_at = -1;
    assert_int_equal(stats_of(cache).pinned_tile_count, 0);
    shd_sampler_release(sampler);
    shd_texture_release(tiled);
    shd_tile_cache_release(cache);
}

/// A rectangle of the source changes: lookups see it on every level, and other tiles stay.
void test_drop(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, 4096, 1 << 23);
    shd_texture *tiled = create(source.desc(g_desc, g_original, cache));
    shd_sampler *sampler = make_sampler(SHD_FILTER_TRILINEAR, SHD_MISSING_TILES_WAIT);
    TileLookups at = random_lookups(2000, 5);
    shd_assert_ok(at.sample(tiled, sampler));

    shd_texture *changed = create(g_desc);
    std::vector<unsigned char> white(50 * 20 * 4, 255);
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8, image.width = 50, image.height = 20, image.pixels = white.data();
    shd_assert_ok(shd_texture_update(changed, 0, 100, 30, &image));
    const TileSource after(changed);
    source.level = after.level;
    shd_tile_region region = shd_tile_region_default();
    region.area.x = 100, region.area.y = 30, region.area.width = 50, region.area.height = 20;
    const uint32_t resident = stats_of(cache).resident_tile_count;
    shd_assert_ok(shd_texture_drop_tiles(tiled, &region));
    const uint32_t kept = stats_of(cache).resident_tile_count;
    assert_true(kept < resident && kept > resident / 2);

    TileLookups want = at;
    shd_assert_ok(want.sample(changed, sampler));
    shd_assert_ok(at.sample(tiled, sampler));
    for (int c = 0; c < 4; ++c) assert_memory_equal(want.out[c].data(), at.out[c].data(), 4 * at.count());
    shd_texture_release(changed);
    shd_sampler_release(sampler);
    shd_texture_release(tiled);
    shd_tile_cache_release(cache);
}

/// Counts the loads of each tile.
struct CountingSource {
    TileSource *source;
    std::mutex mutex;
    std::map<uint64_t, int> loads;

    static shd_result load(const shd_tile *tiles, size_t count, void *user_data)
    {
        auto &self = *static_cast<CountingSource *>(user_data);
        for (size_t i = 0; i < count; ++i) {
            const std::lock_guard<std::mutex> lock(self.mutex);
            ++self.loads[uint64_t{tiles[i].level} << 40 | uint64_t{tiles[i].area.y} << 20 | tiles[i].area.x];
        }
        return TileSource::load(tiles, count, self.source);
    }
};

void sample_from_threads(shd_texture *tiled, uint32_t threads)
{
    std::vector<std::thread> running;
    std::atomic<int> wrong{0};
    for (uint32_t t = 0; t < threads; ++t) {
        running.emplace_back([&, t] {
            const shd_filter filter = t % 2 ? SHD_FILTER_TRILINEAR : SHD_FILTER_BICUBIC;
            shd_sampler *sampler = make_sampler(filter, SHD_MISSING_TILES_WAIT);
            for (int round = 0; round < 3; ++round) {
                TileLookups want = random_lookups(150, t / 4), got = want;
                if (want.sample(g_original, sampler) != SHD_OK || got.sample(tiled, sampler) != SHD_OK) ++wrong;
                for (int c = 0; c < 4; ++c) wrong += want.out[c] != got.out[c];
            }
            shd_sampler_release(sampler);
        });
    }
    for (std::thread &thread : running) thread.join();
    assert_int_equal(wrong.load(), 0);
}

void test_threads(void **)
{
    TileSource source(g_original);
    for (uint64_t budget : {uint64_t{1} << 23, uint64_t{1} << 18, uint64_t{4 * 4096 + 65536}}) {
        CountingSource counting;
        counting.source = &source;
        shd_tile_cache *cache = make_tile_cache(g_context, 4096, budget);
        shd_texture_desc desc = source.desc(g_desc, g_original, cache);
        desc.tiles = {cache, CountingSource::load, nullptr, &counting};
        shd_texture *tiled = create(desc);
        sample_from_threads(tiled, 64);
        const shd_tile_cache_stats stats = stats_of(cache);
        if (budget == 1 << 23) {
            assert_int_equal(stats.evicted_tile_count, 0);
            for (const auto &tile : counting.loads) assert_int_equal(tile.second, 1);
            assert_true(counting.loads.size() > 100);
        } else {
            assert_true(stats.evicted_tile_count > 0);
        }
        shd_texture_release(tiled);
        assert_int_equal(stats_of(cache).resident_tile_count, 0);
        shd_tile_cache_release(cache);
    }
}

/// Drops and lookups at once: each result is of the one content or the other, here equal.
void test_drop_threads(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, 4096, 1 << 20);
    shd_texture *tiled = create(source.desc(g_desc, g_original, cache));
    std::atomic<bool> stop{false};
    std::thread dropper([&] {
        const shd_tile_region all = level_region(0);
        while (!stop) {
            if (shd_texture_drop_tiles(tiled, &all) != SHD_OK) break;
            std::this_thread::yield();
        }
    });
    sample_from_threads(tiled, 8);
    stop = true;
    dropper.join();
    shd_texture_release(tiled);
    shd_tile_cache_release(cache);
}

constexpr uint32_t kHuge = 1u << 19;  // texels of a side: 2^40 bytes of RGBA8

unsigned char huge_texel(uint32_t level, uint32_t x, uint32_t y, uint32_t channel)
{
    uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ (level * 4 + channel) * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    return static_cast<unsigned char>(h >> 24);
}

shd_result load_huge(const shd_tile *tiles, size_t count, void *)
{
    for (size_t i = 0; i < count; ++i) {
        for (uint32_t y = 0; y < tiles[i].area.height; ++y) {
            auto *row = static_cast<unsigned char *>(tiles[i].texels) + y * tiles[i].row_stride;
            for (uint32_t x = 0; x < 4 * tiles[i].area.width; ++x) {
                row[x] = huge_texel(tiles[i].level, tiles[i].area.x + x / 4, tiles[i].area.y + y, x % 4);
            }
        }
    }
    return SHD_OK;
}

/// Bilinear on a level: the size is a power of two and coordinates are floats, so x and y below are exact.
double huge_bilinear(uint32_t level, float u, float v, uint32_t channel)
{
    const double size = kHuge >> level, x = double{u} * size - 0.5, y = double{v} * size - 0.5;
    const auto side = static_cast<uint32_t>(size);
    const double fx = std::floor(x), fy = std::floor(y);
    const auto at = [&](int dx, int dy) {
        const auto column = static_cast<uint32_t>(static_cast<int64_t>(fx) + dx + side) % side;
        const auto row = static_cast<uint32_t>(static_cast<int64_t>(fy) + dy + side) % side;
        return huge_texel(level, column, row, channel) / 255.0;
    };
    const double top = at(0, 0) + (x - fx) * (at(1, 0) - at(0, 0)), low = at(0, 1) + (x - fx) * (at(1, 1) - at(0, 1));
    return top + (y - fy) * (low - top);
}

void test_tebibyte(void **)
{
    shd_fault_allocator memory = {};
    const shd_context_desc context_desc = shd_fault_context_desc(&memory);
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(&context_desc, &context));
    shd_tile_cache *cache = make_tile_cache(context, 65536, uint64_t{1} << 28);
    shd_texture_desc desc = g_desc;
    desc.texels = nullptr;
    desc.width = desc.height = kHuge;
    desc.tiles = {cache, load_huge, nullptr, nullptr};
    shd_texture *tiled = create(desc, context);
    shd_sampler *sampler = make_sampler(SHD_FILTER_TRILINEAR, SHD_MISSING_TILES_WAIT);
    const size_t before = memory.live_bytes;
    memory.peak_bytes = before;
    TileLookups at(9000);
    Random random{9};
    for (size_t i = 0; i < at.count(); ++i) {
        at.column[0][i] = random.real(0.0, 1.0);
        at.column[1][i] = random.real(0.0, 1.0);
        const double lod = random.in(-0.5, 19.0);
        at.column[2][i] = at.column[5][i] = static_cast<float>(std::exp2(lod + 0.375) / kHuge);
    }
    shd_assert_ok(at.sample(tiled, sampler));
    for (size_t i = 0; i < at.count(); ++i) {
        const double lambda = std::log2(double{at.column[2][i]} * kHuge) - 0.375;
        const double lod = std::min(std::max(lambda, 0.0), 19.0);
        const auto level = static_cast<uint32_t>(lod);
        const double share = lod - level;
        for (uint32_t c = 0; c < 4; ++c) {
            double want = huge_bilinear(level, at.column[0][i], at.column[1][i], c);
            if (share > 0.0) {
                want += share * (huge_bilinear(level + 1, at.column[0][i], at.column[1][i], c) - want);
            }
            shd_assert_close("huge", i, double{at.out[c][i]}, want, 2e-5, 0.0);
        }
    }
    const shd_tile_cache_stats stats = stats_of(cache);
    assert_true(stats.evicted_tile_count > 0);
    assert_true(stats.allocated_bytes <= uint64_t{1} << 28);
    assert_int_equal(memory.peak_bytes, before);
    shd_sampler_release(sampler);
    shd_texture_release(tiled);
    shd_tile_cache_release(cache);
    shd_context_release(context);
    shd_assert_all_freed("huge", &memory);
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_coarser),  cmocka_unit_test(test_exact_waits), cmocka_unit_test(test_pins),
        cmocka_unit_test(test_drop),     cmocka_unit_test(test_threads),     cmocka_unit_test(test_drop_threads),
        cmocka_unit_test(test_tebibyte),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
