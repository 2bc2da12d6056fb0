// SPDX-License-Identifier: MIT
// Textures in tiles whose source is a texture in memory: both must give the same bits.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstring>
#include <vector>

#include <shd/shd.h>

#include "support/check.h"

namespace shd::tests
{

/// The levels of a texture, copied out.
struct TileSource {
    struct Level {
        uint32_t width, height;
        std::vector<unsigned char> texels;
    };
    size_t size;  // bytes of a texel
    uint32_t layers, levels;
    std::vector<Level> level;  // [layers][levels]
    std::atomic<int> calls{0}, tiles{0};
    std::atomic<int> fail_at{-1};  // number of the call that fails; -1 = none
    std::atomic<int> released{0};
    shd_result failure = SHD_ERROR_IO;

    explicit TileSource(const shd_texture *texture)
    {
        shd_texture_info info = shd_texture_info_default();
        shd_assert_ok(shd_texture_get_info(texture, &info));
        size = shd_format_size(info.format);
        layers = info.layer_count;
        levels = info.level_count;
        for (uint32_t i = 0; i < layers * levels; ++i) {
            const uint32_t l = i % levels;
            Level next = {std::max(1u, info.width >> l), std::max(1u, info.height >> l), {}};
            next.texels.resize(size * next.width * next.height);
            shd_image image = shd_image_default();
            image.format = info.format;
            image.width = next.width;
            image.height = next.height;
            image.pixels = next.texels.data();
            shd_assert_ok(shd_texture_read_level(texture, i / levels, l, &image));
            level.push_back(std::move(next));
        }
    }

    static shd_result load(const shd_tile *tiles, size_t count, void *user_data)
    {
        auto &self = *static_cast<TileSource *>(user_data);
        if (self.calls.fetch_add(1) == self.fail_at.load()) return self.failure;
        for (size_t i = 0; i < count; ++i) {
            const shd_tile &tile = tiles[i];
            const Level &from = self.level[tile.layer * self.levels + tile.level];
            if (tile.area.x + tile.area.width > from.width || tile.area.y + tile.area.height > from.height)
                return SHD_ERROR_INTERNAL;
            for (uint32_t y = 0; y < tile.area.height; ++y) {
                std::memcpy(static_cast<unsigned char *>(tile.texels) + y * tile.row_stride,
                            &from.texels[((tile.area.y + y) * size_t{from.width} + tile.area.x) * self.size],
                            tile.area.width * self.size);
            }
            ++self.tiles;
        }
        return SHD_OK;
    }
    static void release(void *user_data) { ++static_cast<TileSource *>(user_data)->released; }

    /// The desc of the texture in tiles that equals a texture of `desc`.
    shd_texture_desc desc(shd_texture_desc desc, const shd_texture *texture, shd_tile_cache *cache)
    {
        shd_texture_info info = shd_texture_info_default();
        shd_assert_ok(shd_texture_get_info(texture, &info));
        desc.format = info.format;
        desc.texels = nullptr;
        desc.row_stride = desc.layer_stride = 0;
        desc.level_count = desc.tables ? levels - 1 : 0;
        desc.level_images = nullptr;
        desc.tiles = {cache, load, release, this};
        return desc;
    }
};

inline shd_tile_cache *make_tile_cache(shd_context *context, uint32_t tile_bytes, uint64_t budget)
{
    shd_tile_cache_desc desc = shd_tile_cache_desc_default();
    desc.tile_bytes = tile_bytes;
    desc.budget_bytes = budget;
    shd_tile_cache *cache = nullptr;
    shd_assert_ok(shd_tile_cache_create(context, &desc, &cache));
    return cache;
}

inline shd_tile_cache_stats stats_of(const shd_tile_cache *cache)
{
    shd_tile_cache_stats stats = shd_tile_cache_stats_default();
    shd_assert_ok(shd_tile_cache_get_stats(cache, &stats));
    return stats;
}

/// Lookups, and the results of a texture.
struct TileLookups {
    std::vector<float> column[10];
    std::vector<uint32_t> layer, coarser;
    std::vector<float> out[12];

    explicit TileLookups(size_t count) : layer(count), coarser(count)
    {
        for (auto &values : column) values.resize(count);
        for (auto &values : out) values.resize(count);
    }
    size_t count() const { return layer.size(); }

    shd_result sample(const shd_texture *texture, const shd_sampler *sampler, bool gradient = false)
    {
        shd_lookups in = shd_lookups_default();
        shd_texels to = shd_texels_default();
        in.count = count();
        shd_f32_in *const ins[6] = {&in.u, &in.v, &in.dudx, &in.dvdx, &in.dudy, &in.dvdy};
        for (int c = 0; c < 6; ++c) *ins[c] = shd_f32_column(column[c].data(), 0);
        in.layer.data = layer.data();
        for (auto &values : out) values.assign(count(), -1.0f);
        for (int c = 0; c < 4; ++c) {
            to.channel[c].data = out[c].data();
            if (gradient) to.du[c].data = out[4 + c].data(), to.dv[c].data = out[8 + c].data();
        }
        to.coarser.data = coarser.data();
        return shd_texture_sample(texture, sampler, &in, &to);
    }
};

}  // namespace shd::tests
