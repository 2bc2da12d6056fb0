// SPDX-License-Identifier: MIT
// Textures of directions that show levels of detail.
#pragma once

#include <algorithm>
#include <vector>

#include <shd/shd.h>

#include "ref/texture_ref.h"
#include "support/check.h"

namespace shd::tests
{

/// A texture of directions whose texels have the number of their level.
struct LevelTexture {
    shd_texture *texture = nullptr;
    std::vector<ref::Level> levels;

    LevelTexture(shd_context *context, shd_projection projection, uint32_t size)
    {
        const uint32_t width = projection == SHD_PROJECTION_LAT_LONG ? 2 * size : size;
        const uint32_t layers = projection == SHD_PROJECTION_CUBE ? 6 : 1;
        for (uint32_t l = 0; width >> l > 0; ++l) levels.push_back({nullptr, width >> l, std::max(size >> l, 1u)});
        const std::vector<float> base(size_t{width} * size * layers, 0.0f);
        std::vector<std::vector<float>> pixels;
        std::vector<shd_image> images;
        for (size_t l = 1; l < levels.size(); ++l) {
            pixels.emplace_back(static_cast<size_t>(levels[l].width * levels[l].height), static_cast<float>(l));
        }
        for (size_t i = 0; i < layers * pixels.size(); ++i) {
            shd_image image = shd_image_default();
            image.format = SHD_FORMAT_R32F;
            image.width = static_cast<uint32_t>(levels[1 + i % pixels.size()].width);
            image.height = static_cast<uint32_t>(levels[1 + i % pixels.size()].height);
            image.pixels = pixels[i % pixels.size()].data();
            images.push_back(image);
        }
        shd_texture_desc desc = shd_texture_desc_default();
        desc.format = SHD_FORMAT_R32F;
        desc.width = width, desc.height = size, desc.layer_count = layers;
        desc.projection = projection;
        if (projection) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
        desc.texels = base.data();
        desc.tables = SHD_TABLE_MIPMAP;
        desc.level_images = images.data(), desc.level_count = static_cast<uint32_t>(pixels.size());
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
    }
    ~LevelTexture() { shd_texture_release(texture); }
    LevelTexture(const LevelTexture &) = delete;
    LevelTexture &operator=(const LevelTexture &) = delete;
};

}  // namespace shd::tests
