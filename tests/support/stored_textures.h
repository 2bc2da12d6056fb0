// SPDX-License-Identifier: MIT
// One picture in every store: random compressed blocks, and their texels as the oracle decodes them.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include <shd/shd.h>

#include "ref/block_ref.h"
#include "support/check.h"
#include "support/random.h"

namespace shd::tests
{

/// The sizes of a texture of a shape.
struct TextureShape {
    const char *name;
    uint32_t width, height, layers, depth;
    shd_projection projection;
};
/// A level of a layer, face or slice: its blocks, and the same texels.
struct StoredLevel {
    uint32_t width, height;
    std::vector<unsigned char> blocks, texels;
};

/// All levels of random blocks of BC1_RGBA: layer by layer, or slice by slice of each level. The base is padded.
struct StoredLevels {
    const TextureShape &shape;
    uint32_t count;
    std::vector<StoredLevel> level;
    std::vector<unsigned char> base_blocks, base_texels;
    bool gives_blocks = false;  // tiles

    explicit StoredLevels(const TextureShape &of) : shape(of), count(1)
    {
        const uint32_t largest = std::max(std::max(of.width, of.height), of.depth);
        while (largest >> count) ++count;
        Random random{of.width * 131u + of.height};
        for (uint32_t l = 0; l < count; ++l) {
            for (uint32_t i = 0; i < images(l); ++i) add(l, &random);
        }
        base_blocks.resize(base_blocks.size() + SHD_TEXTURE_PADDING);
        base_texels.resize(base_texels.size() + SHD_TEXTURE_PADDING);
    }

    uint32_t images(uint32_t l) const { return shape.depth ? std::max(1u, shape.depth >> l) : shape.layers; }
    const StoredLevel &at(uint32_t image, uint32_t l) const
    {
        size_t first = 0;
        for (uint32_t k = 0; k < l; ++k) first += images(k);
        return level[first + image];
    }
    void add(uint32_t l, Random *random)
    {
        StoredLevel next = {std::max(1u, shape.width >> l), std::max(1u, shape.height >> l), {}, {}};
        const size_t across = (next.width + 3) / 4, down = (next.height + 3) / 4;
        next.blocks.resize(across * down * 8);
        for (unsigned char &byte : next.blocks) byte = static_cast<unsigned char>(random->bits());
        next.texels.resize(size_t{4} * next.width * next.height);
        for (size_t y = 0; y < next.height; ++y) {
            for (size_t x = 0; x < next.width; ++x) {
                ::ref::BlockTexels block;
                ::ref::color_block(&next.blocks[(y / 4 * across + x / 4) * 8], false, false, &block);
                for (size_t c = 0; c < 4; ++c) {
                    next.texels[(y * next.width + x) * 4 + c] =
                        static_cast<unsigned char>(block.value[y % 4][x % 4][c]);
                }
            }
        }
        if (l == 0) {
            base_blocks.insert(base_blocks.end(), next.blocks.begin(), next.blocks.end());
            base_texels.insert(base_texels.end(), next.texels.begin(), next.texels.end());
        }
        level.push_back(next);
    }

    static shd_result load(const shd_tile *tiles, size_t tile_count, void *user_data)
    {
        const auto &self = *static_cast<StoredLevels *>(user_data);
        for (size_t i = 0; i < tile_count; ++i) {
            const shd_tile &tile = tiles[i];
            if (tile.level >= self.count || tile.layer >= self.images(tile.level)) return SHD_ERROR_INTERNAL;
            const StoredLevel &from = self.at(tile.layer, tile.level);
            const uint32_t side = self.gives_blocks ? 4 : 1;
            const size_t size = self.gives_blocks ? 8 : 4, across = (from.width + side - 1) / side;
            const std::vector<unsigned char> &bytes = self.gives_blocks ? from.blocks : from.texels;
            for (size_t y = 0; y < (tile.area.height + side - 1) / side; ++y) {
                std::memcpy(static_cast<unsigned char *>(tile.texels) + y * tile.row_stride,
                            &bytes[((tile.area.y / side + y) * across + tile.area.x / side) * size],
                            (tile.area.width + side - 1) / side * size);
            }
        }
        return SHD_OK;
    }
};

/// The store of a texture. Only textures of one layer are borrowed.
struct StoredForm {
    const char *name;
    bool blocks, borrowed, tiles;
};

/// Images of the levels behind the base, in the order of a desc.
inline std::vector<shd_image> images_of(const StoredLevels &levels, bool blocks)
{
    std::vector<shd_image> images;
    const auto add = [&](uint32_t image, uint32_t l) {
        const StoredLevel &level = levels.at(image, l);
        shd_image given = shd_image_default();
        given.format = blocks ? SHD_FORMAT_BC1_RGBA : SHD_FORMAT_RGBA8;
        given.width = level.width, given.height = level.height;
        given.pixels = const_cast<unsigned char *>((blocks ? level.blocks : level.texels).data());
        images.push_back(given);
    };
    if (levels.shape.depth) {
        for (uint32_t l = 1; l < levels.count; ++l) {
            for (uint32_t i = 0; i < levels.images(l); ++i) add(i, l);
        }
    } else {
        for (uint32_t i = 0; i < levels.shape.layers; ++i) {
            for (uint32_t l = 1; l < levels.count; ++l) add(i, l);
        }
    }
    return images;
}

/// Makes a texture of the given levels. `levels` outlives it.
inline shd_texture *create(shd_context *context, StoredLevels *levels, const StoredForm &form, shd_table_flags tables,
                           shd_tile_cache *cache)
{
    const TextureShape &shape = levels->shape;
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = form.blocks ? SHD_FORMAT_BC1_RGBA : SHD_FORMAT_RGBA8;
    desc.width = shape.width, desc.height = shape.height, desc.layer_count = shape.layers, desc.depth = shape.depth;
    desc.projection = shape.projection;
    if (shape.depth) desc.kind = SHD_TEXTURE_KIND_3D;
    if (shape.projection) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
    desc.tables = tables;
    desc.level_count = levels->count - 1;
    std::vector<shd_image> images;
    if (form.tiles) {
        levels->gives_blocks = form.blocks;
        desc.tiles = {cache, StoredLevels::load, nullptr, levels};
    } else {
        images = images_of(*levels, form.blocks);
        desc.texels = form.blocks ? levels->base_blocks.data() : levels->base_texels.data();
        desc.level_images = images.data();
        if (form.borrowed && shape.layers == 1) desc.flags = SHD_TEXTURE_BORROW;
    }
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

}  // namespace shd::tests
