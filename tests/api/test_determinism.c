/* SPDX-License-Identifier: MIT */
/* Results have the same bits for any SIMD target, worker count, scheduling order and run, and these bits have the
 * stored hashes. */
#define _POSIX_C_SOURCE 200809L
#include "support/pool.h"
#include "support/scene.h"
#include "support/shadow_hash.h"

static const char *const k_kind_names[SHD_SCENE_KINDS] = {"mixed", "floor", "lit",   "glass",
                                                          "small", "moved", "lines", "surface"};
static const uint32_t k_workers[] = {1, 2, 3, 8, 16};
enum { k_worker_counts = sizeof k_workers / sizeof k_workers[0], k_runs = 3 };

/* Opens a scene in a context made from `desc`, renders it k_runs times, and compares with `want`. */
static void expect_scene(const char *what, const shd_context_desc *desc, shd_scene_kind kind, uint64_t want)
{
    shd_context *context = NULL;
    shd_scene scene;
    int run;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_scene_open(&scene, kind, context);
    for (run = 0; run < k_runs; ++run) {
        const uint64_t got = shd_scene_render(&scene);
        if (got != want) {
            fail_msg("%s, scene %s, run %d on %s: hash %016llx, want %016llx", what, k_kind_names[kind], run,
                     shd_context_simd_target(context), (unsigned long long)got, (unsigned long long)want);
        }
    }
    shd_scene_close(&scene);
    shd_context_release(context);
}

/* Threads are the same on every target, so the thread sanitizer skips SSE4 and AVX2. */
static int can_run(int simd)
{
#ifdef __SANITIZE_THREAD__
    const int skipped = simd == SHD_SIMD_SSE4 || simd == SHD_SIMD_AVX2;
#else
    const int skipped = 0;
#endif
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    shd_result result;
    desc.simd = (shd_simd)simd;
    result = shd_context_create(&desc, &context);
    shd_context_release(context);
    return result == SHD_OK && !skipped;
}

static void test_targets_and_workers(void **state)
{
    const uint64_t mixed = shd_scene_reference(SHD_SCENE_MIXED), glass = shd_scene_reference(SHD_SCENE_GLASS);
    const uint64_t moved = shd_scene_reference(SHD_SCENE_MOVED), lines = shd_scene_reference(SHD_SCENE_LINES);
    const uint64_t surface = shd_scene_reference(SHD_SCENE_SURFACE);
    int simd, targets = 0;
    (void)state;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        size_t i;
        if (!can_run(simd)) continue;
        ++targets;
        for (i = 0; i < k_worker_counts; ++i) {
            shd_context_desc desc = shd_context_desc_default();
            desc.simd = (shd_simd)simd;
            desc.worker_count = k_workers[i];
            expect_scene("built-in executor", &desc, SHD_SCENE_MIXED, mixed);
            expect_scene("built-in executor", &desc, SHD_SCENE_GLASS, glass);
            expect_scene("built-in executor", &desc, SHD_SCENE_MOVED, moved);
            expect_scene("built-in executor", &desc, SHD_SCENE_LINES, lines);
            expect_scene("built-in executor", &desc, SHD_SCENE_SURFACE, surface);
        }
    }
    print_message("%d targets x %d worker counts x %d runs\n", targets, k_worker_counts, k_runs);
    assert_true(targets >= 1);
}

static void test_orders(void **state)
{
    const uint64_t mixed = shd_scene_reference(SHD_SCENE_MIXED), glass = shd_scene_reference(SHD_SCENE_GLASS);
    const uint64_t moved = shd_scene_reference(SHD_SCENE_MOVED), lines = shd_scene_reference(SHD_SCENE_LINES);
    const uint64_t surface = shd_scene_reference(SHD_SCENE_SURFACE);
    int order;
    size_t i;
    (void)state;
    for (order = SHD_POOL_FORWARD; order <= SHD_POOL_RANDOM; ++order) {
        for (i = 0; i < k_worker_counts; ++i) {
            shd_pool pool;
            shd_context_desc desc;
            pool.worker_count = k_workers[i];
            pool.order = (shd_pool_order)order;
            pool.seed = (uint32_t)i;
            desc = shd_pool_context_desc(&pool);
            expect_scene("executor of the host", &desc, SHD_SCENE_MIXED, mixed);
            expect_scene("executor of the host", &desc, SHD_SCENE_GLASS, glass);
            expect_scene("executor of the host", &desc, SHD_SCENE_MOVED, moved);
            expect_scene("executor of the host", &desc, SHD_SCENE_LINES, lines);
            expect_scene("executor of the host", &desc, SHD_SCENE_SURFACE, surface);
        }
    }
}

/* Every draw of the mixed scene must be visible; otherwise the hashes above do not cover it. */
static void test_scene_is_whole(void **state)
{
    shd_context *context = NULL;
    shd_scene scene;
    shd_draw others[SHD_SCENE_DRAWS];
    uint64_t whole;
    size_t count, draw;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&scene, SHD_SCENE_MIXED, context);
    (void)shd_scene_render(&scene);
    whole = shd_hash_framebuffer(scene.framebuffer);
    assert_true(scene.stats.triangles > 4000);
    assert_true(scene.stats.nonfinite > 10);
    assert_true(scene.stats.clipped >= 2);
    assert_true(scene.stats.culled > 100);
    assert_true(scene.stats.rasterised > 1000);
    assert_int_equal(scene.stats.nonfinite_fragments, 0);
    assert_int_equal(scene.stats.triangles, scene.stats.nonfinite + scene.stats.outside + scene.stats.culled +
                                                scene.stats.empty + scene.stats.rasterised);
    count = scene.desc.draw_count;
    for (draw = 0; draw < count; ++draw) {
        scene.desc.draws = &scene.draw[draw];
        scene.desc.draw_count = 1;
        (void)shd_scene_render(&scene);
        if (scene.stats.fragments < 20)
            fail_msg("draw %zu: %llu fragments", draw, (unsigned long long)scene.stats.fragments);
        memcpy(others, scene.draw, count * sizeof others[0]);
        others[draw].cull = SHD_CULL_NONE;
        others[draw].instances = NULL;
        others[draw].compare = SHD_COMPARE_NEVER;
        scene.desc.draws = others;
        scene.desc.draw_count = count;
        (void)shd_scene_render(&scene);
        if (shd_hash_framebuffer(scene.framebuffer) == whole) fail_msg("draw %zu changes no pixel of the frame", draw);
    }
    shd_scene_close(&scene);
    shd_context_release(context);
}

/* Lookups with every filter, in textures of every format of the mixed scene. The inputs contain every special value. */
enum { k_lookups = 40003 }; /* not a whole number of vectors */

static void fill_lookups(float *columns)
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

static uint64_t hash_lookups(shd_scene *s)
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
            hash = shd_hash(hash, &texels.nonfinite_count, sizeof texels.nonfinite_count);
        }
    }
    free(in);
    free(out);
    return hash;
}

static uint64_t lookups_on(const shd_context_desc *desc)
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

static void test_lookups(void **state)
{
    const uint64_t want = lookups_on(NULL);
    int simd;
    size_t i;
    (void)state;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        if (!can_run(simd)) continue;
        for (i = 0; i < k_worker_counts; ++i) {
            shd_context_desc desc = shd_context_desc_default();
            desc.simd = (shd_simd)simd;
            desc.worker_count = k_workers[i];
            assert_true(lookups_on(&desc) == want);
        }
    }
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
static int describe_filter(size_t filter, shd_sampler_desc *sd)
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

static shd_texture *make_filter_texture(shd_context *context, shd_format format)
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
    desc.layers = k_filter_layers;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    free(texels);
    return texture;
}

static uint64_t hash_filter(const shd_context_desc *desc, uint64_t hash, const float *in, size_t filter, size_t format)
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
static void filters_on(const shd_context_desc *desc, uint64_t hashes[k_filter_cases])
{
    float *in = (float *)shd_scene_memory(6 * k_lookups * sizeof(float));
    size_t i;
    fill_lookups(in);
    for (i = 0; i < k_filter_cases; ++i) {
        hashes[i] = hash_filter(desc, SHD_HASH_START, in, i / k_filter_format_count, i % k_filter_format_count);
    }
    free(in);
}

static void test_filters(void **state)
{
    uint64_t want[k_filter_cases], got[k_filter_cases];
    int simd;
    size_t i;
    (void)state;
    filters_on(NULL, want);
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        if (!can_run(simd)) continue;
        desc.simd = (shd_simd)simd;
        desc.worker_count = 2;
        filters_on(&desc, got);
        for (i = 0; i < k_filter_cases; ++i) {
            if (got[i] != want[i]) {
                fail_msg("filter case %zu, format %d: differ on SIMD target %d", i / k_filter_format_count,
                         (int)k_filter_formats[i % k_filter_format_count], simd);
            }
        }
    }
}

/* Fixed point: every filter and format that has it, in calls of `piece` lookups. */
static const shd_filter k_fast_filters[] = {SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR,
                                            SHD_FILTER_ANISOTROPIC};
static const shd_format k_fast_formats[] = {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8};
enum { k_fast_cases = 16 };

static uint64_t hash_fast(shd_context *context, const float *in, size_t filter, size_t format, size_t piece)
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

static void fast_on(const shd_context_desc *desc, size_t piece, uint64_t hashes[k_fast_cases])
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

static void test_fast(void **state)
{
    uint64_t want[k_fast_cases], got[k_fast_cases];
    int simd;
    size_t i;
    (void)state;
    fast_on(NULL, k_filter_lookups, want);
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        if (!can_run(simd)) continue;
        desc.simd = (shd_simd)simd;
        desc.worker_count = (uint32_t)(1 + simd % 3);
        fast_on(&desc, (size_t)(61 + 100 * simd), got);
        for (i = 0; i < k_fast_cases; ++i) {
            if (got[i] != want[i]) fail_msg("case %zu: differs on SIMD target %d", i, simd);
        }
    }
}

static void test_shadows(void **state)
{
    const uint64_t want = shd_shadow_hash(NULL);
    int simd, workers;
    (void)state;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        if (!can_run(simd)) continue;
        for (workers = 1; workers <= 3; workers += 2) {
            shd_context_desc desc = shd_context_desc_default();
            uint64_t got;
            desc.simd = (shd_simd)simd;
            desc.worker_count = (uint32_t)workers;
            got = shd_shadow_hash(&desc);
            if (got != want) {
                fail_msg("SIMD target %d, %d workers: hash %016llx, want %016llx", simd, workers,
                         (unsigned long long)got, (unsigned long long)want);
            }
        }
    }
}

/* Hash of interleaved colour of every format: a scene with blends and four samples a pixel. */
static uint64_t pixels_on(const shd_context_desc *context_desc)
{
    static const shd_format k_colors[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F};
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    shd_scene scene;
    size_t f, y;
    shd_assert_ok(shd_context_create(context_desc, &context));
    shd_scene_open(&scene, SHD_SCENE_GLASS, context);
    for (f = 0; f < sizeof k_colors / sizeof k_colors[0]; ++f) {
        shd_framebuffer_desc desc = shd_framebuffer_desc_default();
        shd_framebuffer *framebuffer = NULL;
        shd_image view = shd_image_default();
        desc.width = 203;
        desc.height = 151;
        desc.samples = 4;
        desc.color_format = k_colors[f];
        shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
        scene.desc.framebuffer = framebuffer;
        shd_assert_ok(shd_render(context, &scene.desc));
        shd_assert_ok(shd_framebuffer_view_color(framebuffer, &view));
        for (y = 0; y < view.height; ++y) {
            hash = shd_hash(hash, (const char *)view.pixels + y * view.row_stride,
                            view.width * shd_format_size(view.format));
        }
        shd_framebuffer_release(framebuffer);
    }
    shd_scene_close(&scene);
    shd_context_release(context);
    return hash;
}

static void test_pixels(void **state)
{
    const uint64_t want = pixels_on(NULL);
    int simd, workers;
    (void)state;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        if (!can_run(simd)) continue;
        for (workers = 1; workers <= 3; workers += 2) {
            shd_context_desc desc = shd_context_desc_default();
            desc.simd = (shd_simd)simd;
            desc.worker_count = (uint32_t)workers;
            if (pixels_on(&desc) != want) fail_msg("SIMD target %d, %d workers: other pixels", simd, workers);
        }
    }
}

/* The stored hashes: lines "<name> <hash>", # starts a comment. */
struct golden_row {
    const char *name;
    uint64_t hash;
};
static struct golden_row k_golden[] = {{"mixed", 0},   {"floor", 0},   {"lit", 0},     {"glass", 0},   {"moved", 0},
                                       {"lines", 0},   {"surface", 0}, {"lookups", 0}, {"filters", 0}, {"profiles", 0},
                                       {"shadows", 0}, {"pixels", 0},  {"fast", 0},    {"exact", 0}};
enum { k_golden_count = sizeof k_golden / sizeof k_golden[0] };

static void measure_golden(void)
{
    uint64_t filters[k_filter_cases], fast[k_fast_cases];
    int kind;
    for (kind = SHD_SCENE_MIXED; kind <= SHD_SCENE_GLASS; ++kind) {
        k_golden[kind].hash = shd_scene_reference((shd_scene_kind)kind);
    }
    k_golden[k_golden_count - 10].hash = shd_scene_reference(SHD_SCENE_MOVED);
    k_golden[k_golden_count - 9].hash = shd_scene_reference(SHD_SCENE_LINES);
    k_golden[k_golden_count - 8].hash = shd_scene_reference(SHD_SCENE_SURFACE);
    k_golden[k_golden_count - 7].hash = lookups_on(NULL);
    filters_on(NULL, filters);
    k_golden[k_golden_count - 6].hash = shd_hash(SHD_HASH_START, filters, k_plain_cases * sizeof *filters);
    k_golden[k_golden_count - 5].hash =
        shd_hash(SHD_HASH_START, filters + k_plain_cases, k_profiled_cases * sizeof *filters);
    k_golden[k_golden_count - 1].hash =
        shd_hash(SHD_HASH_START, filters + k_plain_cases + k_profiled_cases, k_plain_cases * sizeof *filters);
    k_golden[k_golden_count - 4].hash = shd_shadow_hash(NULL);
    k_golden[k_golden_count - 3].hash = pixels_on(NULL);
    fast_on(NULL, k_filter_lookups, fast);
    k_golden[k_golden_count - 2].hash = shd_hash(SHD_HASH_START, fast, sizeof fast);
}

static void test_golden(void **state)
{
    FILE *file = fopen(SHD_GOLDEN_DIR "/hashes.txt", "r");
    char line[256];
    size_t found = 0, i;
    (void)state;
    if (!file) fail_msg("cannot open %s", SHD_GOLDEN_DIR "/hashes.txt");
    measure_golden();
    while (fgets(line, sizeof line, file)) {
        char name[32];
        unsigned long long hash;
        if (line[0] == '#' || sscanf(line, "%31s %llx", name, &hash) != 2) continue;
        for (i = 0; i < k_golden_count; ++i) {
            if (strcmp(name, k_golden[i].name)) continue;
            ++found;
            if (k_golden[i].hash != hash) {
                fail_msg("%s: hash %016llx, stored %016llx", name, (unsigned long long)k_golden[i].hash, hash);
            }
        }
    }
    fclose(file);
    assert_int_equal(found, k_golden_count);
}

/* `test_api_determinism --hashes` prints the lines of tests/golden/hashes.txt. */
static int print_golden(void)
{
    size_t i;
    measure_golden();
    for (i = 0; i < k_golden_count; ++i) {
        printf("%-8s %016llx\n", k_golden[i].name, (unsigned long long)k_golden[i].hash);
    }
    return 0;
}

int main(int argc, char **argv)
{
    static const struct CMUnitTest k_tests[] = {
        {"scene_is_whole", test_scene_is_whole, NULL, NULL, NULL},
        {"targets_and_workers", test_targets_and_workers, NULL, NULL, NULL},
        {"orders", test_orders, NULL, NULL, NULL},
        {"lookups", test_lookups, NULL, NULL, NULL},
        {"filters", test_filters, NULL, NULL, NULL},
        {"fast", test_fast, NULL, NULL, NULL},
        {"shadows", test_shadows, NULL, NULL, NULL},
        {"pixels", test_pixels, NULL, NULL, NULL},
        {"golden", test_golden, NULL, NULL, NULL},
    };
    if (argc > 1 && strcmp(argv[1], "--hashes") == 0) return print_golden();
    return _cmocka_run_group_tests("api.determinism", k_tests, sizeof k_tests / sizeof k_tests[0], NULL, NULL);
}
