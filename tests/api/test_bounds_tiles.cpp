// SPDX-License-Identifier: MIT
// Bounds of textures in tiles: the bits of the same texture in memory, and the errors of loads that fail.
#include "support/bounds_scene.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kTileBytes = 1024;
constexpr uint64_t kBudget = 1 << 20;

/// A texture in tiles with the texels of a scene.
struct Tiled {
    TileSource source;
    shd_tile_cache *cache;
    shd_texture *texture = nullptr;

    explicit Tiled(const Scene &scene) : source(scene.pixels->texture)
    {
        cache = make_tile_cache(g_context, kTileBytes, kBudget);
        shd_texture_desc desc = shd_texture_desc_default();
        desc.width = scene.kind.width, desc.height = scene.kind.height, desc.layer_count = scene.kind.layers;
        desc.tables = SHD_TABLE_MIPMAP;
        desc = source.desc(desc, scene.pixels->texture, cache);
        shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    }
    ~Tiled()
    {
        shd_texture_release(texture);
        shd_tile_cache_release(cache);
    }
};

bool is_flat(const Scene &scene) { return !scene.kind.depth && !scene.kind.has_directions(); }

void test_same_bits(void **)
{
    const Scenes scenes(g_context, SHD_IS_SANITIZED ? 40 : 200, 31);
    int loaded = 0;
    for (const Scene &scene : scenes.list) {
        if (!is_flat(scene)) continue;
        const Tiled tiled(scene);
        for (const shd_rules rules : {SHD_RULES_VULKAN, SHD_RULES_D3D11}) {
            const SceneBounds want(g_context, scene, preset(rules)),
                got(g_context, scene, preset(rules), tiled.texture);
            for (size_t c = 0; c < 4; ++c) {
                const size_t bytes = scene.lookups.count() * sizeof(float);
                assert_memory_equal(got.lower.channel[c].data(), want.lower.channel[c].data(), bytes);
                assert_memory_equal(got.upper.channel[c].data(), want.upper.channel[c].data(), bytes);
            }
        }
        loaded += tiled.source.tiles;
    }
    assert_true(loaded > 0);
}

/// A load that fails gives its error, and the next call loads again.
void test_failing_load(void **)
{
    const Scenes scenes(g_context, 10, 32);
    for (const Scene &scene : scenes.list) {
        if (!is_flat(scene)) continue;
        Tiled tiled(scene);
        tiled.source.fail_at = 0;
        shd_sampler *sampler = scene.sampler(g_context);
        const shd_lookups in = scene.lookups.columns();
        SceneValues low, high;
        shd_texels lower = low.columns(in.count), upper = high.columns(in.count);
        shd_assert_result("load", shd_texture_bounds(tiled.texture, sampler, &in, nullptr, &lower, &upper),
                          SHD_ERROR_CALLBACK, "texture.tiles.load returned SHD_ERROR_IO for");
        shd_assert_ok(shd_texture_bounds(tiled.texture, sampler, &in, nullptr, &lower, &upper));
        shd_sampler_release(sampler);
    }
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_same_bits), cmocka_unit_test(test_failing_load)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
