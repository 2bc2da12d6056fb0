// SPDX-License-Identifier: MIT
// Lookups along lines, which share their levels, have the bits of memory in every store and on every target. A texture
// of two layers holds the same texels twice: its lookups are never filtered by rows.
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "support/random.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kTileBytes = 1024;
constexpr float kFar = 100.0f;  // step of lines of lookups anywhere

struct Line {
    float step_u, step_v, lod, bend;  // steps in texels of the base; change of the level along the line
};
const Line kLines[] = {{0.2f, 0.0f, 0.0f, 0.0f},   {-0.3f, 0.0f, 0.4f, 0.0f},  {1.0f, 0.0f, 0.0f, 0.0f},
                       {0.7f, 0.0f, 1.5f, 0.0f},   {0.25f, 0.1f, 0.0f, 0.0f},  {0.0f, 0.15f, 0.6f, 0.0f},
                       {-0.4f, -0.2f, 1.3f, 0.0f}, {9.0f, 5.0f, 0.2f, 0.0f},   {kFar, kFar, 0.3f, 0.0f},
                       {0.3f, 0.0f, 0.2f, 4.0f},   {-0.2f, 0.02f, 8.0f, 0.0f}, {0.5f, 0.0f, 3.4f, 0.0f}};
constexpr size_t kCounts[] = {600, 256, 257, 1, 2, 3, 5, 8, 13, 16, 17, 19, 31, 33, 64, 300};

const shd_filter kFilters[] = {SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR};
const shd_wrap kWraps[] = {SHD_WRAP_REPEAT, SHD_WRAP_MIRROR, SHD_WRAP_CLAMP, SHD_WRAP_BORDER, SHD_WRAP_MIRROR_ONCE};

struct Shape {
    const char *name;
    shd_format format;
    uint32_t width, height;
};
const Shape kShapes[] = {
    {"RGBA8", SHD_FORMAT_RGBA8, 150, 70},   {"R8", SHD_FORMAT_R8, 67, 45},
    {"RG8", SHD_FORMAT_RG8, 90, 33},        {"SRGB", SHD_FORMAT_RGBA8_SRGB, 64, 64},
    {"R16", SHD_FORMAT_R16, 50, 61},        {"RGBA16", SHD_FORMAT_RGBA16, 41, 27},
    {"RGBA16F", SHD_FORMAT_RGBA16F, 40, 9}, {"RGBA32F", SHD_FORMAT_RGBA32F, 19, 20},
    {"2x2", SHD_FORMAT_RGBA8, 2, 2},        {"1x40", SHD_FORMAT_RGBA8, 1, 40},
    {"BC1", SHD_FORMAT_BC1_RGBA, 150, 70},  {"BC3/sRGB", SHD_FORMAT_BC3_SRGB, 33, 130},
    {"BC4", SHD_FORMAT_BC4, 77, 18},        {"BC5", SHD_FORMAT_BC5, 61, 60},
    {"BC7", SHD_FORMAT_BC7, 260, 12},       {"BC7/3x3", SHD_FORMAT_BC7, 3, 3},
};

bool is_compressed(shd_format format) { return format >= SHD_FORMAT_BC1_RGB; }

/// The lookups of a line, and their values.
TileLookups look_up_line(const Shape &shape, const Line &line, size_t row, size_t count)
{
    TileLookups at(count);
    Random random{row + 1};
    const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
    for (size_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        at.column[0][i] = line.step_u == kFar ? random.real(-1.0, 2.0) : 0.1f + x * line.step_u / width;
        at.column[1][i] = line.step_u == kFar ? random.real(-1.0, 2.0)
                                              : (static_cast<float>(row) * 3.7f + 0.7f + x * line.step_v) / height;
        const float footprint = std::exp2(line.lod + line.bend * x / 600.0f);
        at.column[2][i] = footprint / width;
        at.column[5][i] = footprint / height;
    }
    if (row == 1 && count > 200) {
        at.column[0][7] = NAN, at.column[1][100] = INFINITY, at.column[0][count - 1] = 1e30f;
        at.column[2][20] = NAN, at.column[5][40] = INFINITY;
    }
    return at;
}

/// Fails unless both textures give the same values.
void compare(const TileLookups &lookups, const shd_texture *expected, const shd_texture *texture,
             const shd_sampler *sampler, const char *what)
{
    TileLookups want = lookups, got = lookups;
    shd_assert_ok(want.sample(expected, sampler));
    shd_assert_ok(got.sample(texture, sampler));
    if (want.coarser != got.coarser) fail_msg("%s: other levels", what);
    for (size_t c = 0; c < 4; ++c) {
        for (size_t i = 0; i < want.count(); ++i) {
            if (std::memcmp(&want.out[c][i], &got.out[c][i], 4) == 0) continue;
            fail_msg("%s, %zu lookups: channel %zu of lookup %zu is %.9g, not %.9g", what, want.count(), c, i,
                     double{got.out[c][i]}, double{want.out[c][i]});
        }
    }
}

/// Textures of the same random texels or blocks: one layer or two, in memory or in tiles.
struct Textures {
    std::vector<unsigned char> base;
    std::vector<std::vector<unsigned char>> blocks;
    shd_texture *one = nullptr, *two = nullptr;
    shd_texture_desc desc = shd_texture_desc_default();

    Textures(shd_context *context, const Shape &shape)
    {
        desc.format = shape.format;
        desc.width = shape.width, desc.height = shape.height;
        desc.tables = SHD_TABLE_MIPMAP;
        Random random{shape.width * 131u + shape.height};
        std::vector<shd_image> levels;
        if (is_compressed(shape.format)) {
            add_levels(&random, &levels);
        } else {
            base = texels_of(&random, size_t{shape.width} * shape.height * shd_format_size(shape.format));
        }
        const size_t layer = base.size();
        base.insert(base.end(), base.begin(), base.begin() + static_cast<std::ptrdiff_t>(layer));
        desc.texels = base.data();
        desc.level_images = levels.data();
        shd_assert_ok(shd_texture_create(context, &desc, &one));
        desc.layer_count = 2;
        const std::vector<shd_image> second = levels;
        levels.insert(levels.end(), second.begin(), second.end());
        desc.level_images = levels.data();
        shd_assert_ok(shd_texture_create(context, &desc, &two));
        desc.level_images = nullptr;
    }
    Textures(const Textures &) = delete;
    ~Textures()
    {
        shd_texture_release(one);
        shd_texture_release(two);
    }

    /// Random bytes; floats of them would be infinite at times, so floats are numbers in 0..1.
    std::vector<unsigned char> texels_of(Random *random, size_t size) const
    {
        std::vector<unsigned char> bytes(size);
        for (unsigned char &byte : bytes) byte = static_cast<unsigned char>(random->bits());
        for (size_t i = 0; desc.format == SHD_FORMAT_RGBA16F && i < size; i += 2) bytes[i + 1] &= 0x3b;
        for (size_t i = 0; desc.format == SHD_FORMAT_RGBA32F && i < size; i += 4) {
            const float value = random->real(0.0, 1.0);
            std::memcpy(&bytes[i], &value, sizeof value);
        }
        return bytes;
    }

    void add_levels(Random *random, std::vector<shd_image> *levels)
    {
        const size_t size = desc.format == SHD_FORMAT_BC4 || desc.format <= SHD_FORMAT_BC1_RGBA_SRGB ? 8 : 16;
        for (uint32_t l = 0; l == 0 || std::max(desc.width, desc.height) >> l != 0; ++l) {
            shd_image level = shd_image_default();
            level.format = desc.format;
            level.width = std::max(1u, desc.width >> l), level.height = std::max(1u, desc.height >> l);
            blocks.push_back(texels_of(random, size_t{(level.width + 3) / 4} * ((level.height + 3) / 4) * size));
            level.pixels = blocks.back().data();
            if (l != 0) levels->push_back(level);
        }
        base = blocks[0];
        desc.level_count = static_cast<uint32_t>(levels->size());
    }
};

/// Calls body(context) for every target.
template <class Body>
void for_each_target(const Body &body)
{
    for (int simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        desc.simd = static_cast<shd_simd>(simd);
        shd_context *context = nullptr;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        body(context);
        shd_context_release(context);
    }
}

/// Calls body(sampler) for every filter and wrap.
template <class Body>
void for_each_sampler(shd_context *context, shd_missing_tiles missing, const Body &body)
{
    for (shd_filter filter : kFilters) {
        for (shd_wrap wrap : kWraps) {
            shd_sampler_desc desc = shd_sampler_desc_default();
            desc.filter = filter;
            desc.wrap_u = desc.wrap_v = wrap;
            desc.border[0] = 0.25f, desc.border[3] = 0.75f;
            desc.missing_tiles = missing;
            shd_sampler *sampler = nullptr;
            shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
            body(sampler, filter, wrap);
            shd_sampler_release(sampler);
        }
    }
}

/// Calls body(lookups, number) for every line.
template <class Body>
void for_each_line(const Shape &shape, const Body &body)
{
    size_t number = 0;
    for (const Line &line : kLines) {
        for (size_t row = 0; row < 3; ++row, ++number) {
            const size_t count = row == 1 ? 600 : kCounts[number % (sizeof kCounts / sizeof *kCounts)];
            body(look_up_line(shape, line, row, count), number);
        }
    }
}

/// Compares a texture in a store with textures in memory that take streams.
void check_store(shd_context *context, const Shape &shape, const shd_texture *expected, const shd_texture *texture)
{
    for_each_sampler(context, SHD_MISSING_TILES_WAIT, [&](const shd_sampler *sampler, int filter, int wrap) {
        for_each_line(shape, [&](const TileLookups &lookups, size_t number) {
            char what[128];
            std::snprintf(what, sizeof what, "%s, %s, filter %d, wrap %d, line %zu", shape.name,
                          shd_context_get_simd_target(context), filter, wrap, number);
            compare(lookups, expected, texture, sampler, what);
        });
    });
}

void test_shape(void **state)
{
    const auto &shape = *static_cast<const Shape *>(*state);
    for_each_target([&](shd_context *context) {
        const Textures textures(context, shape);
        if (is_compressed(shape.format)) return check_store(context, shape, textures.two, textures.one);
        TileSource source(textures.one);
        shd_texture *tiled = nullptr;
        shd_tile_cache *const cache = make_tile_cache(context, kTileBytes, 1 << 20);
        shd_texture_desc desc = textures.desc;
        desc.layer_count = 1;
        desc = source.desc(desc, textures.one, cache);
        shd_assert_ok(shd_texture_create(context, &desc, &tiled));
        check_store(context, shape, textures.two, tiled);
        shd_texture_release(tiled);
        shd_tile_cache_release(cache);
    });
}

/// Some tiles are not at hand, and the call must not wait: values, levels and requests are those of streams.
void test_missing(void **)
{
    const Shape shape = {"missing", SHD_FORMAT_RGBA8, 150, 70};
    for_each_target([&](shd_context *context) {
        const Textures textures(context, shape);
        TileSource source(textures.one), source_of_two(textures.two);
        TileSource *const sources[2] = {&source, &source_of_two};
        for_each_sampler(context, SHD_MISSING_TILES_COARSER, [&](const shd_sampler *sampler, int filter, int wrap) {
            for_each_line(shape, [&](const TileLookups &lookups, size_t number) {
                shd_tile_cache *caches[2];
                shd_texture *tiled[2] = {};
                for (size_t k = 0; k < 2; ++k) {
                    caches[k] = make_tile_cache(context, kTileBytes, 1 << 20);
                    shd_texture_desc desc = textures.desc;
                    desc.layer_count = k == 0 ? 1 : 2;
                    desc = sources[k]->desc(desc, k == 0 ? textures.one : textures.two, caches[k]);
                    shd_assert_ok(shd_texture_create(context, &desc, &tiled[k]));
                    for (uint32_t level = 0; level < 4; ++level) {
                        shd_tile_region region = shd_tile_region_default();
                        region.level = level;
                        region.area.x = level == 0 ? 30 : 0;
                        region.area.width = std::max(1u, level == 0 ? 70 : 100u >> level);
                        region.area.height = 60u >> level;
                        if (number % 4 != 3 || level != 1) shd_assert_ok(shd_texture_load_tiles(tiled[k], &region));
                    }
                }
                char what[128];
                std::snprintf(what, sizeof what, "%s, filter %d, wrap %d, line %zu",
                              shd_context_get_simd_target(context), filter, wrap, number);
                compare(lookups, tiled[1], tiled[0], sampler, what);
                assert_int_equal(stats_of(caches[0]).requested_tile_count, stats_of(caches[1]).requested_tile_count);
                for (size_t k = 0; k < 2; ++k) {
                    shd_texture_release(tiled[k]);
                    shd_tile_cache_release(caches[k]);
                }
            });
        });
    });
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    constexpr size_t kCount = sizeof kShapes / sizeof *kShapes;
    CMUnitTest tests[kCount + 1];
    for (size_t i = 0; i < kCount; ++i)
        tests[i] = {kShapes[i].name, test_shape, nullptr, nullptr, const_cast<Shape *>(&kShapes[i])};
    tests[kCount] = {"missing", test_missing, nullptr, nullptr, nullptr};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
