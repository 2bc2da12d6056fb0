/* SPDX-License-Identifier: MIT */
/* Lookups of textures of compressed blocks as a number, which is equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_BLOCK_HASH_H
#define SHD_TESTS_SUPPORT_BLOCK_HASH_H

#include "support/check.h"
#include "support/noise.h"
#include "support/scene.h"

#include <shd/shd.h>

/* Levels of 203 x 150 in two layers; 8411 lookups are several tasks, and more blocks than a call keeps. */
enum { SHD_BLOCK_WIDTH = 203, SHD_BLOCK_HEIGHT = 150, SHD_BLOCK_LAYERS = 2, SHD_BLOCK_LEVELS = 8 };
enum { SHD_BLOCK_LOOKUPS = 8411 };

struct shd_block_columns {
    float in[6][SHD_BLOCK_LOOKUPS]; /* u, v, and their derivatives */
    float out[4][SHD_BLOCK_LOOKUPS];
    uint32_t layer[SHD_BLOCK_LOOKUPS];
    unsigned char blocks[SHD_BLOCK_LAYERS * SHD_BLOCK_LEVELS][51 * 38 * 16];
};

static inline void shd_fill_block_columns(struct shd_block_columns *columns)
{
    unsigned char *const bytes = (unsigned char *)columns->blocks;
    uint32_t bits = 11;
    size_t i, c;
    for (i = 0; i < sizeof columns->blocks; ++i) {
        shd_noise(&bits);
        bytes[i] = (unsigned char)(bits >> 24);
    }
    for (i = 0; i < SHD_BLOCK_LOOKUPS; ++i) {
        /* Half of the lookups are neighbours, as pixels of a row. */
        const float size = 0.5f / (float)(1 << (i / 64 % 9));
        for (c = 0; c < 6; ++c) {
            shd_noise(&bits);
            columns->in[c][i] = size * ((float)(bits >> 8) / 8388608.0f - 1.0f) * (c < 4 ? 1.0f : 0.2f);
            if (c < 2) columns->in[c][i] = i / 64 % 2 ? columns->in[c][i] * 9.0f : 0.0041f * (float)i * (float)(c + 1);
        }
        columns->layer[i] = bits >> 30;
    }
}

static inline shd_texture *shd_create_block_texture(shd_context *context, shd_format format,
                                                    const struct shd_block_columns *columns)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_image levels[SHD_BLOCK_LAYERS * (SHD_BLOCK_LEVELS - 1)];
    shd_texture *texture = NULL;
    uint32_t layer, level;
    for (layer = 0; layer < SHD_BLOCK_LAYERS; ++layer) {
        for (level = 1; level < SHD_BLOCK_LEVELS; ++level) {
            shd_image *const image = &levels[layer * (SHD_BLOCK_LEVELS - 1) + level - 1];
            *image = shd_image_default();
            image->format = format;
            image->width = SHD_BLOCK_WIDTH >> level ? SHD_BLOCK_WIDTH >> level : 1;
            image->height = SHD_BLOCK_HEIGHT >> level ? SHD_BLOCK_HEIGHT >> level : 1;
            image->pixels = (void *)columns->blocks[layer * SHD_BLOCK_LEVELS + level];
        }
    }
    desc.format = format;
    desc.width = SHD_BLOCK_WIDTH;
    desc.height = SHD_BLOCK_HEIGHT;
    desc.layer_count = SHD_BLOCK_LAYERS;
    desc.texels = columns->blocks;
    desc.layer_stride = SHD_BLOCK_LEVELS * sizeof columns->blocks[0];
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels;
    desc.level_count = SHD_BLOCK_LEVELS - 1;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

static inline uint64_t shd_hash_block_lookups(shd_context *context, const shd_texture *texture, shd_filter filter,
                                              struct shd_block_columns *columns, uint64_t hash)
{
    static const shd_wrap k_block_wraps[] = {SHD_WRAP_CLAMP, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR, SHD_WRAP_BORDER};
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels out = {0};
    shd_sampler *sampler = NULL;
    shd_f32_in *const in[6] = {&lookups.u, &lookups.v, &lookups.dudx, &lookups.dvdx, &lookups.dudy, &lookups.dvdy};
    size_t c;
    desc.filter = filter;
    desc.wrap_u = k_block_wraps[(unsigned)filter % 4];
    desc.wrap_v = k_block_wraps[((unsigned)filter + 1) % 4];
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    lookups.count = SHD_BLOCK_LOOKUPS;
    for (c = 0; c < 6; ++c) in[c]->data = columns->in[c];
    lookups.layer = shd_u32_column(columns->layer, 0);
    for (c = 0; c < 4; ++c) out.channel[c].data = columns->out[c];
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &out));
    shd_sampler_release(sampler);
    return shd_hash(hash, columns->out, sizeof columns->out);
}

/** Hash of lookups of every format with the filters that read blocks in different ways. */
static inline uint64_t shd_block_hash(const shd_context_desc *desc)
{
    static const shd_filter k_block_filters[] = {SHD_FILTER_NEAREST,   SHD_FILTER_BILINEAR,    SHD_FILTER_BICUBIC,
                                                 SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA};
    struct shd_block_columns *const columns = (struct shd_block_columns *)shd_scene_memory(sizeof *columns);
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    int format;
    size_t i;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_fill_block_columns(columns);
    for (format = 0; format < 64; ++format) {
        shd_texture *texture;
        if (!shd_format_block_size((shd_format)format)) continue;
        texture = shd_create_block_texture(context, (shd_format)format, columns);
        for (i = 0; i < sizeof k_block_filters / sizeof *k_block_filters; ++i) {
            hash = shd_hash_block_lookups(context, texture, k_block_filters[i], columns, hash);
        }
        shd_texture_release(texture);
    }
    free(columns);
    shd_context_release(context);
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_BLOCK_HASH_H */
