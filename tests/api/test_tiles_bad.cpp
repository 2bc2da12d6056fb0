// SPDX-License-Identifier: MIT
// Textures in tiles: wrong descs, callbacks that fail, nest or are cancelled, budgets too small, and lost memory.
#include <cstdio>
#include <utility>

#include "support/fault_allocator.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kSide = 200;
constexpr uint32_t kTile = 1024;
constexpr uint64_t kSmallest = 4 * kTile + 65536;

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

shd_sampler *make_sampler(shd_context *context, shd_filter filter = SHD_FILTER_TRILINEAR)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    return sampler;
}

/// Points on a diagonal, with footprints of several texels.
TileLookups diagonal()
{
    TileLookups at(100);
    for (size_t i = 0; i < at.count(); ++i) {
        at.column[0][i] = at.column[1][i] = static_cast<float>(i) / 100.0f;
        at.column[2][i] = at.column[5][i] = 2.0f / kSide;
    }
    return at;
}

void test_cache_desc(void **)
{
    const struct {
        uint32_t tile_bytes;
        uint64_t budget;
        const char *message;
    } cases[] = {
        {512, 1 << 20, "tile_cache.tile_bytes: 512"},
        {3000, 1 << 20, "tile_cache.tile_bytes: 3000 is not a power of two"},
        {1u << 21, 1 << 30, "tile_cache.tile_bytes: 2097152"},
        {1024, kSmallest - 1, "tile_cache.budget_bytes: 69631"},
        {1u << 20, 1 << 22, "tile_cache.budget_bytes: 4194304"},
        {65536, (1ull << 31) + 1, "tile_cache.budget_bytes: 2147483649"},
    };
    for (const auto &c : cases) {
        shd_tile_cache_desc desc = shd_tile_cache_desc_default();
        desc.tile_bytes = c.tile_bytes;
        desc.budget_bytes = c.budget;
        auto *cache = reinterpret_cast<shd_tile_cache *>(1);
        shd_assert_result(c.message, shd_tile_cache_create(g_context, &desc, &cache), SHD_ERROR_INVALID_ARGUMENT,
                          c.message);
        assert_null(cache);
    }
    shd_assert_result("null", shd_tile_cache_create(g_context, nullptr, nullptr), SHD_ERROR_INVALID_ARGUMENT,
                      "out_cache");
    shd_tile_cache_retain(nullptr);
    shd_tile_cache_release(nullptr);
}

void test_texture_desc(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, kSmallest);
    struct Case {
        void (*edit)(shd_texture_desc *desc);
        shd_result result;
        const char *message;
    };
    const Case cases[] = {
        {[](shd_texture_desc *d) { d->tiles.cache = reinterpret_cast<shd_tile_cache *>(g_original); },
         SHD_ERROR_INVALID_ARGUMENT, "texture.tiles.cache: not a live handle"},
        {[](shd_texture_desc *d) { d->tiles.load = nullptr; }, SHD_ERROR_INVALID_ARGUMENT, "texture.tiles.load: NULL"},
        {[](shd_texture_desc *d) { d->texels = g_texels.data(); }, SHD_ERROR_INVALID_ARGUMENT, "texture.texels"},
        {[](shd_texture_desc *d) { d->flags = SHD_TEXTURE_BORROW; }, SHD_ERROR_INVALID_ARGUMENT,
         "texture.flags: 0x1, but"},
        {[](shd_texture_desc *d) { d->format = SHD_FORMAT_RGB8; }, SHD_ERROR_UNSUPPORTED, "three channels"},
        {[](shd_texture_desc *d) { d->kind = SHD_TEXTURE_KIND_3D; }, SHD_ERROR_INVALID_ARGUMENT, "texture.depth: 0"},
        {[](shd_texture_desc *d) { d->width = (1u << 20) + 1; }, SHD_ERROR_INVALID_ARGUMENT, "texture.width: 1048577"},
        {[](shd_texture_desc *d) { d->level_count = 8; }, SHD_ERROR_INVALID_ARGUMENT, "texture.level_count: 8"},
        {[](shd_texture_desc *d) { d->tables = 0; }, SHD_ERROR_INVALID_ARGUMENT, "without SHD_TABLE_MIPMAP"},
        {[](shd_texture_desc *d) { d->width = d->height = 1u << 20, d->layer_count = 2048, d->level_count = 0; },
         SHD_ERROR_INVALID_ARGUMENT, "number of tiles"},
    };
    for (const Case &c : cases) {
        shd_texture_desc desc = source.desc(g_desc, g_original, cache);
        c.edit(&desc);
        shd_texture *texture = nullptr;
        shd_assert_result(c.message, shd_texture_create(g_context, &desc, &texture), c.result, c.message);
        assert_null(texture);
    }
    assert_int_equal(source.released.load(), 0);
    shd_tile_cache_release(cache);
}

/// Calls that textures in tiles refuse.
void test_unsupported(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, kSmallest);
    const shd_texture_desc desc = source.desc(g_desc, g_original, cache);
    shd_texture *tiled = nullptr;
    shd_assert_ok(shd_texture_create(g_context, &desc, &tiled));
    TileLookups at = diagonal();
    shd_sampler *exact = make_sampler(g_context, SHD_FILTER_EXACT);
    shd_assert_ok(at.sample(tiled, exact));
    shd_sampler *sums = make_sampler(g_context, SHD_FILTER_SUMMED_AREA);
    shd_assert_result("sums", at.sample(tiled, sums), SHD_ERROR_INVALID_ARGUMENT,
                      "SUMMED_AREA, but the texture has no SHD_TABLE_SUMMED_AREA");
    shd_sampler *sampler = make_sampler(g_context);
    shd_lookups in = shd_lookups_default();
    in.count = 1;
    in.u.data = in.v.data = at.column[0].data();
    shd_explanation explanation = shd_explanation_default();
    shd_assert_ok(shd_texture_explain(tiled, sampler, &in, 0, &explanation));
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8, image.width = image.height = 1, image.pixels = g_texels.data();
    shd_assert_result("update", shd_texture_update(tiled, 0, 0, 0, &image), SHD_ERROR_UNSUPPORTED, "in tiles");
    shd_tile_region region = shd_tile_region_default();
    region.area.width = region.area.height = 1;
    shd_assert_result("region", shd_texture_load_tiles(g_original, &region), SHD_ERROR_INVALID_ARGUMENT,
                      "texture: not in tiles");
    region.area.x = kSide;
    shd_assert_result("region", shd_texture_load_tiles(tiled, &region), SHD_ERROR_INVALID_ARGUMENT,
                      "region.area.x: 200");
    region.area.x = 1, region.area.width = kSide;
    shd_assert_result("region", shd_texture_pin_tiles(tiled, &region), SHD_ERROR_INVALID_ARGUMENT,
                      "region.area.width: 200");
    for (shd_sampler *each : {exact, sums, sampler}) shd_sampler_release(each);
    shd_texture_release(tiled);
    shd_tile_cache_release(cache);
}

/// Each call of the callback fails once in turn: an error, and the next lookup has the right bits.
void test_failures(void **)
{
    TileSource source(g_original);
    shd_sampler *sampler = make_sampler(g_context);
    TileLookups want = diagonal(), got = want;
    shd_assert_ok(want.sample(g_original, sampler));
    int failed = 0;
    for (int fail_at = 0;; ++fail_at) {
        shd_tile_cache *cache = make_tile_cache(g_context, kTile, kSmallest);
        const shd_texture_desc desc = source.desc(g_desc, g_original, cache);
        shd_texture *tiled = nullptr;
        shd_assert_ok(shd_texture_create(g_context, &desc, &tiled));
        source.calls = 0;
        source.fail_at = fail_at;
        source.failure = fail_at % 3 == 2 ? SHD_ERROR_CANCELLED : SHD_ERROR_IO;
        const shd_result result = got.sample(tiled, sampler);
        if (result != SHD_OK) {
            ++failed;
            shd_assert_result("load", result, fail_at % 3 == 2 ? SHD_ERROR_CANCELLED : SHD_ERROR_CALLBACK,
                              fail_at % 3 == 2 ? "texture.tiles.load returned SHD_ERROR_CANCELLED for"
                                               : "texture.tiles.load returned SHD_ERROR_IO for");
            assert_true(stats_of(cache).failed_tile_count > 0);
        }
        source.fail_at = -1;
        shd_assert_ok(got.sample(tiled, sampler));
        for (int c = 0; c < 4; ++c) assert_memory_equal(want.out[c].data(), got.out[c].data(), 4 * want.count());
        shd_texture_release(tiled);
        shd_tile_cache_release(cache);
        if (result == SHD_OK) break;
    }
    assert_true(failed > 5);
    shd_sampler_release(sampler);
}

/// A callback that looks up a texture of the same cache, and its own tile.
struct Nested {
    TileSource *source;
    shd_texture *other = nullptr, *own = nullptr;
    shd_sampler *sampler;
    shd_result result = SHD_OK;

    static shd_result load(const shd_tile *tiles, size_t count, void *user_data)
    {
        auto &self = *static_cast<Nested *>(user_data);
        TileLookups at = diagonal();
        if (self.other) self.result = at.sample(self.other, self.sampler);
        if (self.own) self.result = at.sample(self.own, self.sampler);
        if (self.result != SHD_OK) return self.result;
        return TileSource::load(tiles, count, self.source);
    }
};

void test_nested(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, 1 << 21);
    shd_texture_desc desc = source.desc(g_desc, g_original, cache);
    Nested nested;
    nested.source = &source;
    nested.sampler = make_sampler(g_context);
    shd_assert_ok(shd_texture_create(g_context, &desc, &nested.other));
    desc.tiles = {cache, Nested::load, nullptr, &nested};
    shd_texture *tiled = nullptr;
    shd_assert_ok(shd_texture_create(g_context, &desc, &tiled));
    TileLookups want = diagonal(), got = want;
    shd_assert_ok(want.sample(g_original, nested.sampler));
    shd_assert_ok(got.sample(tiled, nested.sampler));
    for (int c = 0; c < 4; ++c) assert_memory_equal(want.out[c].data(), got.out[c].data(), 4 * want.count());
    shd_tile_region all = shd_tile_region_default();
    all.area.width = all.area.height = kSide;
    shd_assert_ok(shd_texture_drop_tiles(tiled, &all));
    nested.own = tiled;
    shd_assert_result("own", got.sample(tiled, nested.sampler), SHD_ERROR_CALLBACK, "texture.tiles.load");
    assert_int_equal(nested.result, SHD_ERROR_CALLBACK);
    assert_non_null(strstr(shd_last_error(), "it looks up the tile that it loads"));
    nested.own = nullptr;
    nested.result = SHD_OK;
    shd_assert_ok(got.sample(tiled, nested.sampler));
    shd_texture_release(tiled);
    shd_texture_release(nested.other);
    shd_sampler_release(nested.sampler);
    shd_tile_cache_release(cache);
}

/// A chain of callbacks that is longer than the cache has tiles: each texture reads the next one.
struct Chain {
    TileSource *source;
    shd_sampler *sampler;
    std::vector<shd_texture *> texture;
    std::vector<std::pair<Chain *, size_t>> link;
    shd_result innermost = SHD_OK;
    char reason[80] = {};

    static shd_result load(const shd_tile *tiles, size_t count, void *user_data)
    {
        const auto &link = *static_cast<std::pair<Chain *, size_t> *>(user_data);
        Chain &self = *link.first;
        if (link.second + 1 < self.texture.size()) {
            TileLookups at(1);
            const shd_result result = at.sample(self.texture[link.second + 1], self.sampler);
            if (result != SHD_OK) {
                if (self.innermost == SHD_OK) std::snprintf(self.reason, sizeof self.reason, "%s", shd_last_error());
                if (self.innermost == SHD_OK) self.innermost = result;
                return result;
            }
        }
        return TileSource::load(tiles, count, self.source);
    }
};

void test_long_chain(void **)
{
    TileSource source(g_original);
    shd_tile_cache *cache = make_tile_cache(g_context, kTile, kSmallest);
    const uint32_t slots = stats_of(cache).tile_count;
    Chain chain;
    chain.source = &source;
    chain.sampler = make_sampler(g_context, SHD_FILTER_NEAREST);
    chain.texture.resize(slots + 1);
    for (size_t i = 0; i <= slots; ++i) chain.link.emplace_back(&chain, i);
    for (size_t i = 0; i <= slots; ++i) {
        shd_texture_desc desc = source.desc(g_desc, g_original, cache);
        desc.tiles = {cache, Chain::load, nullptr, &chain.link[i]};
        shd_assert_ok(shd_texture_create(g_context, &desc, &chain.texture[i]));
    }
    TileLookups at(1);
    shd_assert_result("too long", at.sample(chain.texture[0], chain.sampler), SHD_ERROR_CALLBACK, "SHD_ERROR_CALLBACK");
    assert_int_equal(chain.innermost, SHD_ERROR_LIMIT);
    assert_non_null(strstr(chain.reason, "tile_cache.budget_bytes: 69632 is too small: callbacks"));
    shd_assert_ok(at.sample(chain.texture[1], chain.sampler));
    assert_int_equal(stats_of(cache).resident_tile_count, slots);
    for (shd_texture *each : chain.texture) shd_texture_release(each);
    shd_sampler_release(chain.sampler);
    shd_tile_cache_release(cache);
}

/// Every allocation fails once in turn; all memory comes back, and the budget is the peak.
void test_memory(void **)
{
    TileSource source(g_original);
    for (int persistent = 0; persistent < 2; ++persistent) {
        for (size_t n = 1;; ++n) {
            shd_fault_allocator memory = {};
            const shd_context_desc context_desc = shd_fault_context_desc(&memory);
            shd_context *context = nullptr;
            shd_assert_ok(shd_context_create(&context_desc, &context));
            shd_fault_arm(&memory, n, persistent);
            shd_tile_cache_desc cache_desc = shd_tile_cache_desc_default();
            cache_desc.budget_bytes = 1 << 20;
            shd_tile_cache *cache = nullptr;
            shd_texture *tiled = nullptr;
            shd_result result = shd_tile_cache_create(context, &cache_desc, &cache);
            if (result == SHD_OK) {
                const shd_texture_desc desc = source.desc(g_desc, g_original, cache);
                result = shd_texture_create(context, &desc, &tiled);
            }
            const bool done = result == SHD_OK;
            if (!done) assert_int_equal(result, SHD_ERROR_OUT_OF_MEMORY);
            shd_fault_arm(&memory, 0, 0);
            shd_texture_release(tiled);
            shd_tile_cache_release(cache);
            shd_context_release(context);
            shd_assert_all_freed("tiles", &memory);
            if (done) break;
        }
    }
}

/// A lookup that loads tiles allocates nothing.
void test_no_allocation(void **)
{
    TileSource source(g_original);
    shd_fault_allocator memory = {};
    const shd_context_desc context_desc = shd_fault_context_desc(&memory);
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(&context_desc, &context));
    shd_tile_cache *cache = make_tile_cache(context, kTile, 1 << 18);
    const shd_texture_desc desc = source.desc(g_desc, g_original, cache);
    shd_texture *tiled = nullptr;
    shd_assert_ok(shd_texture_create(context, &desc, &tiled));
    shd_sampler *sampler = make_sampler(context, SHD_FILTER_ANISOTROPIC);
    shd_fault_arm(&memory, 1, 1);
    TileLookups at = diagonal();
    shd_assert_ok(at.sample(tiled, sampler));
    assert_int_equal(memory.calls, 0);
    shd_fault_arm(&memory, 0, 0);
    shd_sampler_release(sampler);
    shd_tile_cache_release(cache);
    shd_texture_release(tiled);
    shd_context_release(context);
    shd_assert_all_freed("lookup", &memory);
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cache_desc), cmocka_unit_test(test_texture_desc),  cmocka_unit_test(test_unsupported),
        cmocka_unit_test(test_failures),   cmocka_unit_test(test_nested),        cmocka_unit_test(test_long_chain),
        cmocka_unit_test(test_memory),     cmocka_unit_test(test_no_allocation),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
