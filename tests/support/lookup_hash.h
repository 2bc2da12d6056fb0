/* SPDX-License-Identifier: MIT */
/* Lookups of every filter as numbers, which are equal for every SIMD target, worker count and split into calls. */
#ifndef SHD_TESTS_SUPPORT_LOOKUP_HASH_H
#define SHD_TESTS_SUPPORT_LOOKUP_HASH_H

#include "support/scene.h"

/* Lookups with every filter, in textures of every format of the mixed scene. The inputs contain every special value. */
enum { k_lookups = 40003 }; /* not a whole number of vectors */

static inline void fill_lookups(float *columns)
{
    static const float k_special[] = {0.0f,   -0.0f, 1.0f,   -1.0f, 0.5f,     1e-45f,    -1e-45f,     1e30f,
                                      -1e30f, 3e38f, 1e-30f, NAN,   INFINITY, -INFINITY, 16777216.5f, 1.0e9f};
    uint32_t seed = 2024;
    size_t i, c;
    for (c = 0; c < 6; ++c) {
        for (i = 0; i < k_lookups; ++i) {
            const float x = shd_scene_random(&seed), pick = shd_scene_random(&seed);
            const float scale = c < 2 ? 4.0f : pick < 0.3f ? 0.001f : pick < 0.6f ? 0.03f : 0.5f;
            const int special = shd_scene_random(&seed) < 0.02f;
            columns[c * k_lookups + i] = special ? k_special[(int)(x * 16.0f)] : scale * (2.0f * x - 1.0f);
        }
    }
}

static inline uint64_t hash_lookups(shd_scene *s)
{
    float *in = (float *)shd_scene_memory(6 * k_lookups * sizeof(float));
    float *out = (float *)shd_scene_memory(4 * k_lookups * sizeof(float));
    uint64_t hash = SHD_HASH_START;
    size_t t, f, c, i;
    fill_lookups(in);
    for (t = 0; t < SHD_SCENE_TEXTURES; ++t) {
        for (f = 0; f < SHD_SCENE_SAMPLERS; ++f) {
            shd_lookups lookups = shd_lookups_default();
            shd_texels texels;
            uint64_t nonfinite;
            shd_f32_in *const column[6] = {&lookups.u,    &lookups.v,    &lookups.dudx,
                                           &lookups.dvdx, &lookups.dudy, &lookups.dvdy};
            memset(&texels, 0, sizeof texels);
            lookups.count = k_lookups;
            for (c = 0; c < 6; ++c) column[c]->data = in + c * k_lookups;
            for (c = 0; c < 4; ++c) texels.channel[c].data = out + c * k_lookups;
            shd_assert_ok(shd_texture_sample(s->texture[t], s->sampler[f], &lookups, &texels));
            for (i = 0; i < 4 * k_lookups; ++i) {
                if (!isfinite(out[i])) fail_msg("texture %zu, sampler %zu: out[%zu] = %g", t, f, i, (double)out[i]);
            }
            hash = shd_hash(hash, out, 4 * k_lookups * sizeof(float));
            nonfinite = texels.nonfinite_count; /* size_t has four bytes on some machines */
            hash = shd_hash(hash, &nonfinite, sizeof nonfinite);
        }
    }
    free(in);
    free(out);
    return hash;
}

static inline uint64_t shd_lookup_hash(const shd_context_desc *desc)
{
    shd_context *context = NULL;
    shd_scene scene;
    uint64_t hash;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_scene_open(&scene, SHD_SCENE_SMALL, context);
    hash = hash_lookups(&scene);
    shd_scene_close(&scene);
    shd_context_release(context);
    return hash;
}

/* Every filter, on formats of every kind, with derivatives if the filter supports them. */
enum { k_filter_lookups = 3001, k_filter_width = 37, k_filter_height = 24, k_filter_layers = 2 };

static const struct {
    shd_filter filter, stochastic_filter;
    shd_magnification magnification;
    shd_box box;
    int derivatives;
} k_filters[] = {
    {SHD_FILTER_NEAREST, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 0},
    {SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 1},
    {SHD_FILTER_BICUBIC, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 1},
    {SHD_FILTER_NEAREST_MIP, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_BILINEAR, SHD_BOX_BOUNDING, 0},
    {SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 1},
    {SHD_FILTER_TRILINEAR, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_BICUBIC, SHD_BOX_BOUNDING, 1},
    {SHD_FILTER_RIPMAP, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 1},
    {SHD_FILTER_SUMMED_AREA, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 0},
    {SHD_FILTER_SUMMED_AREA, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_ORIENTED, 0},
    {SHD_FILTER_ANISOTROPIC, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 1},
    {SHD_FILTER_STOCHASTIC, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 0},
    {SHD_FILTER_STOCHASTIC, SHD_FILTER_ANISOTROPIC, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 0},
    {SHD_FILTER_STOCHASTIC, SHD_FILTER_EWA, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 0},
    {SHD_FILTER_EXACT, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 0},
    {SHD_FILTER_EWA, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_DEFAULT, SHD_BOX_BOUNDING, 1},
};
/* The filters whose results depend on the profile; their cases follow those of k_filters. */
static const struct {
    shd_filter filter;
    shd_profile profile;
    shd_magnification magnification;
} k_profiled[] = {
    {SHD_FILTER_NEAREST_MIP, SHD_PROFILE_VULKAN, SHD_MAGNIFICATION_DEFAULT},
    {SHD_FILTER_BILINEAR_MIP, SHD_PROFILE_VULKAN, SHD_MAGNIFICATION_DEFAULT},
    {SHD_FILTER_TRILINEAR, SHD_PROFILE_VULKAN, SHD_MAGNIFICATION_DEFAULT},
    {SHD_FILTER_ANISOTROPIC, SHD_PROFILE_VULKAN, SHD_MAGNIFICATION_BILINEAR},
    {SHD_FILTER_TRILINEAR, SHD_PROFILE_D3D11, SHD_MAGNIFICATION_BILINEAR},
    {SHD_FILTER_ANISOTROPIC, SHD_PROFILE_D3D11, SHD_MAGNIFICATION_DEFAULT},
    {SHD_FILTER_NEAREST_MIP, SHD_PROFILE_OIIO, SHD_MAGNIFICATION_DEFAULT},
    {SHD_FILTER_BILINEAR_MIP, SHD_PROFILE_OIIO, SHD_MAGNIFICATION_BICUBIC},
    {SHD_FILTER_TRILINEAR, SHD_PROFILE_OIIO, SHD_MAGNIFICATION_DEFAULT},
    {SHD_FILTER_ANISOTROPIC, SHD_PROFILE_OIIO, SHD_MAGNIFICATION_DEFAULT},
};
enum {
    k_plain_count = sizeof k_filters / sizeof k_filters[0],
    k_profiled_count = sizeof k_profiled / sizeof k_profiled[0],
    k_default_count = k_plain_count + k_profiled_count /* cases from here on: k_filters with SHD_PROFILE_EXACT */
};

/** Sets the lookups of case `filter`; returns whether it has derivatives. */
static inline int describe_filter(size_t filter, shd_sampler_desc *sd)
{
    if (filter >= k_default_count) {
        sd->profile = SHD_PROFILE_EXACT;
        filter -= k_default_count;
    }
    if (filter < k_plain_count) {
        sd->filter = k_filters[filter].filter;
        sd->stochastic_filter = k_filters[filter].stochastic_filter;
        sd->magnification = k_filters[filter].magnification;
        sd->box = k_filters[filter].box;
        return k_filters[filter].derivatives;
    }
    sd->filter = k_profiled[filter - k_plain_count].filter;
    sd->profile = k_profiled[filter - k_plain_count].profile;
    sd->magnification = k_profiled[filter - k_plain_count].magnification;
    return sd->filter != SHD_FILTER_NEAREST_MIP;
}

static const shd_format k_filter_formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RGB16, SHD_FORMAT_R16F,
                                              SHD_FORMAT_RGBA32F};

static inline shd_texture *make_filter_texture(shd_context *context, shd_format format)
{
    const size_t size = (size_t)k_filter_width * k_filter_height * k_filter_layers * shd_format_size(format);
    unsigned char *texels = (unsigned char *)shd_scene_memory(size);
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint32_t seed = 31;
    size_t i;
    for (i = 0; i + 4 <= size; i += 4) {
        const float value = 8.0f * shd_scene_random(&seed) - 4.0f;
        const uint16_t halves[2] = {(uint16_t)(0x3000 + 512 * value), (uint16_t)(0xb000 + 512 * value)};
        memcpy(texels + i, format == SHD_FORMAT_RGBA32F ? (const void *)&value : halves, 4);
    }
    desc.format = format;
    desc.width = k_filter_width;
    desc.height = k_filter_height;
    desc.layer_count = k_filter_layers;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    free(texels);
    return texture;
}

static inline uint64_t hash_filter(const shd_context_desc *desc, uint64_t hash, const float *in, size_t filter,
                                   size_t format)
{
    static float out[12 * k_filter_lookups];
    shd_context *context = NULL;
    shd_sampler *sampler = NULL;
    shd_texture *texture;
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_f32_in *const column[6] = {&lookups.u, &lookups.v, &lookups.dudx, &lookups.dvdx, &lookups.dudy, &lookups.dvdy};
    shd_texels texels;
    size_t c;
    const int derivatives = describe_filter(filter, &sd);
    const size_t row = filter < k_plain_count     ? filter
                       : filter < k_default_count ? filter - k_plain_count
                                                  : filter - k_default_count;
    shd_assert_ok(shd_context_create(desc, &context));
    texture = make_filter_texture(context, k_filter_formats[format]);
    sd.wrap_u = (shd_wrap)((row + format) % 5);
    sd.wrap_v = (shd_wrap)((row + 2 * format) % 5);
    sd.blur_u = row % 2 ? 0.01f : 0.0f;
    sd.seed = 5;
    sd.tolerance = 0.125f; /* bounds the exact filter to 1024 cells a lookup */
    shd_assert_ok(shd_sampler_create(context, &sd, &sampler));
    memset(&texels, 0, sizeof texels);
    memset(out, 0, sizeof out);
    lookups.count = k_filter_lookups;
    lookups.layer.data = (const uint32_t *)(const void *)in; /* the bits of u: most lie beyond the last layer */
    for (c = 0; c < 6; ++c) column[c]->data = in + c * k_lookups;
    for (c = 0; c < 4; ++c) {
        texels.channel[c].data = out + c * k_filter_lookups;
        if (!derivatives) continue;
        texels.du[c].data = out + (4 + c) * k_filter_lookups;
        texels.dv[c].data = out + (8 + c) * k_filter_lookups;
    }
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    for (c = 0; c < 12 * (size_t)k_filter_lookups; ++c) assert_true(isfinite(out[c]));
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_context_release(context);
    return shd_hash(hash, out, sizeof out);
}

enum {
    k_filter_count = k_default_count + k_plain_count,
    k_filter_format_count = sizeof k_filter_formats / sizeof k_filter_formats[0],
    k_plain_cases = k_plain_count * k_filter_format_count,
    k_profiled_cases = k_profiled_count * k_filter_format_count,
    k_filter_cases = k_filter_count * k_filter_format_count
};

/** Hashes of every filter on every format. */
static inline void shd_filter_hashes(const shd_context_desc *desc, uint64_t hashes[k_filter_cases])
{
    float *in = (float *)shd_scene_memory(6 * k_lookups * sizeof(float));
    size_t i;
    fill_lookups(in);
    for (i = 0; i < k_filter_cases; ++i) {
        hashes[i] = hash_filter(desc, SHD_HASH_START, in, i / k_filter_format_count, i % k_filter_format_count);
    }
    free(in);
}

/* Fixed point: every filter and format that has it, in calls of `piece` lookups. */
static const shd_filter k_fast_filters[] = {SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR,
                                            SHD_FILTER_ANISOTROPIC};
static const shd_format k_fast_formats[] = {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8};
enum { k_fast_cases = 16 };

static inline uint64_t hash_fast(shd_context *context, const float *in, size_t filter, size_t format, size_t piece)
{
    static float out[4 * k_filter_lookups];
    shd_texture *texture = make_filter_texture(context, k_fast_formats[format]);
    shd_sampler *sampler = NULL;
    shd_sampler_desc sd = shd_sampler_desc_default();
    size_t first, c;
    sd.filter = k_fast_filters[filter];
    sd.precision = SHD_PRECISION_FAST;
    sd.max_anisotropy = 64.0f;
    sd.wrap_u = filter % 2 ? SHD_WRAP_MIRROR : SHD_WRAP_REPEAT;
    sd.wrap_v = format % 2 ? SHD_WRAP_CLAMP : SHD_WRAP_MIRROR_ONCE;
    shd_assert_ok(shd_sampler_create(context, &sd, &sampler));
    for (first = 0; first < k_filter_lookups; first += piece) {
        shd_lookups lookups = shd_lookups_default();
        shd_f32_in *const column[6] = {&lookups.u,    &lookups.v,    &lookups.dudx,
                                       &lookups.dvdx, &lookups.dudy, &lookups.dvdy};
        shd_texels texels;
        memset(&texels, 0, sizeof texels);
        lookups.count = k_filter_lookups - first < piece ? k_filter_lookups - first : piece;
        for (c = 0; c < 6; ++c) column[c]->data = in + c * k_lookups + first;
        for (c = 0; c < 4; ++c) texels.channel[c].data = out + c * k_filter_lookups + first;
        shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    }
    for (c = 0; c < 4 * (size_t)k_filter_lookups; ++c) assert_true(isfinite(out[c]));
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    return shd_hash(SHD_HASH_START, out, sizeof out);
}

static inline void shd_fast_hashes(const shd_context_desc *desc, size_t piece, uint64_t hashes[k_fast_cases])
{
    float *in = (float *)shd_scene_memory(6 * k_lookups * sizeof(float));
    shd_context *context = NULL;
    size_t i;
    fill_lookups(in);
    shd_assert_ok(shd_context_create(desc, &context));
    for (i = 0; i < k_fast_cases; ++i) hashes[i] = hash_fast(context, in, i / 4, i % 4, piece);
    shd_context_release(context);
    free(in);
}

#endif /* SHD_TESTS_SUPPORT_LOOKUP_HASH_H */
