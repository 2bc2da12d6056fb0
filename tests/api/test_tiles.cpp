// SPDX-License-Identifier: MIT
// Textures in tiles: the bits of the same texture in memory, for every format, filter, wrap, target and budget.
#include <algorithm>
#include <cstdio>

#include "support/random.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr shd_format kFormats[] = {SHD_FORMAT_R8,  SHD_FORMAT_RG8,     SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB,
                                   SHD_FORMAT_R16, SHD_FORMAT_RGBA16F, SHD_FORMAT_R32F,  SHD_FORMAT_RGBA32F};
constexpr shd_filter kFilters[] = {
    SHD_FILTER_NEAREST,    SHD_FILTER_BILINEAR,           SHD_FILTER_BICUBIC,      SHD_FILTER_NEAREST_MIP,
    SHD_FILTER_TRILINEAR,  SHD_FILTER_ANISOTROPIC,        SHD_FILTER_BILINEAR_MIP, SHD_FILTER_EWA,
    SHD_FILTER_STOCHASTIC, SHD_FILTER_NEAREST_MIP_LINEAR, SHD_FILTER_HERMITE};
constexpr shd_wrap kWraps[] = {SHD_WRAP_REPEAT, SHD_WRAP_MIRROR, SHD_WRAP_CLAMP, SHD_WRAP_BORDER, SHD_WRAP_MIRROR_ONCE};
struct Size {
    uint32_t width, height, layers;
};
constexpr Size kSizes[] = {{1, 1, 1}, {5, 7, 2}, {300, 70, 1}, {257, 128, 3}};
constexpr size_t kCount = 293;

shd_context *g_context;

int setup(void **) { return shd_context_create(nullptr, &g_context) == SHD_OK ? 0 : -1; }
int teardown(void **)
{
    shd_context_release(g_context);
    return 0;
}

/// A texture in memory, with random finite texels.
struct Original {
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = nullptr;

    Original(shd_format format, const Size &size, shd_table_flags tables = SHD_TABLE_MIPMAP)
    {
        const size_t bytes = shd_format_size(format) * size.width * size.height * size.layers;
        std::vector<unsigned char> texels(bytes + 3);
        Random random{format * 977u + size.width};
        for (unsigned char &byte : texels) byte = static_cast<unsigned char>(random.bits());
        if (format == SHD_FORMAT_R32F || format == SHD_FORMAT_RGBA32F) {
            for (size_t i = 0; i + 4 <= bytes; i += 4) {
                const float value = random.real(-2.0, 3.0);
                std::memcpy(&texels[i], &value, 4);
            }
        } else if (format == SHD_FORMAT_RGBA16F) {
            for (size_t i = 1; i < bytes; i += 2) texels[i] &= 0xbf;
        }
        desc.format = format;
        desc.width = size.width, desc.height = size.height, desc.layer_count = size.layers;
        desc.texels = texels.data();
        desc.tables = tables;
        shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    }
    ~Original() { shd_texture_release(texture); }
    Original(const Original &) = delete;
    Original &operator=(const Original &) = delete;
};

shd_texture *create(const shd_texture_desc &desc, shd_context *context = g_context)
{
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

shd_sampler *make_sampler(shd_filter filter, shd_wrap wrap_u, shd_wrap wrap_v,
                          shd_missing_tiles missing = SHD_MISSING_TILES_WAIT)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    desc.wrap_u = wrap_u, desc.wrap_v = wrap_v;
    desc.border[0] = 0.25f, desc.border[3] = 0.75f;
    desc.missing_tiles = missing;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    return sampler;
}

/// Runs of near points, points anywhere, footprints of every size, and coordinates that are not finite.
TileLookups lookups_for(const Size &size, uint64_t seed)
{
    TileLookups at(kCount);
    Random random{seed};
    float u = 0.0f, v = 0.0f;
    for (size_t i = 0; i < kCount; ++i) {
        if (i % 40 == 0) u = random.real(-1.5, 2.5), v = random.real(-1.5, 2.5);
        u += 1.0f / static_cast<float>(size.width);
        const bool anywhere = i >= 120 && i < 200;
        at.column[0][i] = anywhere ? random.real(-3.0, 4.0) : u;
        at.column[1][i] = anywhere ? random.real(-3.0, 4.0) : v;
        const float length = 1.0f / static_cast<float>(size.width);
        for (int c = 2; c < 6; ++c) at.column[c][i] = length * random.scaled(-2.0, i < 240 ? 3.0 : 9.0);
        at.layer[i] = i / 30 % (size.layers + 1);
    }
    at.column[0][11] = NAN, at.column[1][12] = INFINITY, at.column[2][13] = INFINITY, at.column[0][14] = 1e38f;
    return at;
}

void compare(const TileLookups &want, const TileLookups &got, const char *what, size_t columns)
{
    for (size_t c = 0; c < columns; ++c) {
        for (size_t i = 0; i < want.count(); ++i) {
            if (std::memcmp(&want.out[c][i], &got.out[c][i], 4) != 0) {
                fail_msg("%s: column %zu of lookup %zu is %g, not %g", what, c, i, double{got.out[c][i]},
                         double{want.out[c][i]});
            }
        }
    }
    for (size_t i = 0; i < got.count(); ++i) assert_int_equal(got.coarser[i], 0);
}

bool has_gradient(shd_filter filter)
{
    return filter != SHD_FILTER_NEAREST && filter != SHD_FILTER_NEAREST_MIP && filter != SHD_FILTER_STOCHASTIC &&
           filter != SHD_FILTER_NEAREST_MIP_LINEAR;
}

/// Compares every filter with two wraps that depend on its number.
void compare_filters(const Original &original, const Size &size, shd_texture *tiled)
{
    for (size_t f = 0; f < std::size(kFilters); ++f) {
        for (size_t w = f % 2; w < 5; w += 2) {
            shd_sampler *sampler = make_sampler(kFilters[f], kWraps[w], kWraps[(w + f) % 5]);
            TileLookups want = lookups_for(size, f), got = want;
            const bool gradient = has_gradient(kFilters[f]);
            shd_assert_ok(want.sample(original.texture, sampler, gradient));
            shd_assert_ok(got.sample(tiled, sampler, gradient));
            char what[80];
            std::snprintf(what, sizeof what, "format %d, %u x %u, filter %d, wraps %d %d", original.desc.format,
                          size.width, size.height, kFilters[f], kWraps[w], kWraps[(w + f) % 5]);
            compare(want, got, what, gradient ? 12 : 4);
            shd_sampler_release(sampler);
        }
    }
}

/// A budget of four tiles of 1 KiB, one of many, and the default.
void test_bits(void **)
{
    const struct {
        uint32_t tile_bytes;
        uint64_t budget;
    } budgets[] = {{1024, 4 * 1024 + 65536}, {4096, 1 << 20}, {65536, 1 << 25}};
    for (shd_format format : kFormats) {
        for (const Size &size : kSizes) {
            const Original original(format, size);
            TileSource source(original.texture);
            for (const auto &budget : budgets) {
                shd_tile_cache *cache = make_tile_cache(g_context, budget.tile_bytes, budget.budget);
                shd_texture *tiled = create(source.desc(original.desc, original.texture, cache));
                compare_filters(original, size, tiled);
                const shd_tile_cache_stats stats = stats_of(cache);
                assert_true(stats.allocated_bytes <= stats.budget_bytes);
                assert_true(stats.loaded_tile_count > 0);
                shd_texture_release(tiled);
                assert_int_equal(stats_of(cache).resident_tile_count, 0);
                shd_tile_cache_release(cache);
            }
            assert_int_equal(source.released.load(), std::size(budgets));
        }
    }
}

/// Every SIMD target, one format of each size of texel.
void test_targets(void **)
{
    const Size size = {257, 128, 3};
    for (shd_simd simd : {SHD_SIMD_SCALAR, SHD_SIMD_SSE4, SHD_SIMD_AVX2, SHD_SIMD_AVX512, SHD_SIMD_NEON}) {
        shd_context_desc desc = shd_context_desc_default();
        desc.simd = simd;
        shd_context *context = nullptr;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        for (shd_format format : {SHD_FORMAT_R8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA32F}) {
            const Original original(format, size);
            TileSource source(original.texture);
            for (uint64_t budget : {uint64_t{65536 + 4096}, uint64_t{1} << 22}) {
                shd_tile_cache *cache = make_tile_cache(context, 1024, budget);
                shd_texture *tiled = create(source.desc(original.desc, original.texture, cache), context);
                compare_filters(original, size, tiled);
                shd_texture_release(tiled);
                shd_tile_cache_release(cache);
            }
        }
        shd_context_release(context);
    }
}

/// Levels can be copied out, and a few levels are enough.
void test_levels(void **)
{
    const Size size = {300, 70, 2};
    Original original(SHD_FORMAT_RGBA8, size);
    TileSource source(original.texture);
    shd_tile_cache *cache = make_tile_cache(g_context, 1024, 65536 + 4096);
    shd_texture_desc desc = source.desc(original.desc, original.texture, cache);
    shd_texture *tiled = create(desc);
    const TileSource copy(tiled);
    for (size_t i = 0; i < source.level.size(); ++i) {
        assert_memory_equal(copy.level[i].texels.data(), source.level[i].texels.data(), copy.level[i].texels.size());
    }
    shd_texture_release(tiled);
    desc.tables = SHD_TABLE_NONE, desc.level_count = 0;
    tiled = create(desc);
    shd_texture_info info = shd_texture_info_default();
    shd_assert_ok(shd_texture_get_info(tiled, &info));
    assert_int_equal(info.level_count, 1);
    assert_int_equal(info.byte_size, 0);
    shd_texture_release(tiled);
    shd_tile_cache_release(cache);
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bits),
        cmocka_unit_test(test_targets),
        cmocka_unit_test(test_levels),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
