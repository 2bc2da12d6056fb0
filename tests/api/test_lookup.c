/* SPDX-License-Identifier: MIT */
/* shd_texture_sample: arguments, strides, batch splits, workers and SIMD targets. */
#include "support/check.h"
#include "support/noise.h"

#include <stdlib.h>

#include <shd/shd.h>

enum { POINTS = 50000, SIZE = 61 };

static float g_in[7][POINTS + 8];
static float g_out[4][POINTS + 8];
static unsigned char g_texels[SIZE * SIZE * 4];

/** Reproducible test points: coordinates in [-2, 2), footprints of all sizes, a few values that are not finite. */
static void fill_inputs(void)
{
    uint32_t state = 1;
    size_t c, i;
    for (i = 0; i < sizeof g_texels; ++i) {
        shd_noise(&state);
        g_texels[i] = (unsigned char)(state >> 24);
    }
    for (c = 0; c < 7; ++c) {
        for (i = 0; i < POINTS; ++i) {
            float value;
            shd_noise(&state);
            value = (float)(state >> 8) * (4.0f / 16777216.0f) - 2.0f;
            if (c >= 2) value = ldexpf(value, -(int)(i % 12));
            g_in[c][i] = value;
        }
    }
    g_in[0][77] = NAN;
    g_in[1][16384] = INFINITY;
    g_in[3][49999] = -INFINITY;
}

static shd_context *make_context(uint32_t workers, shd_simd simd)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    desc.worker_count = workers;
    desc.simd = simd;
    if (shd_context_create(&desc, &context) != SHD_OK) return NULL;
    return context;
}

static shd_texture *make_texture(shd_context *context, shd_format format)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    desc.format = format;
    desc.width = SIZE;
    desc.height = SIZE;
    desc.texels = g_texels;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

static shd_lookups make_lookups(size_t first, size_t count)
{
    shd_lookups lookups = shd_lookups_default();
    lookups.count = count;
    lookups.u.data = g_in[0] + first;
    lookups.v.data = g_in[1] + first;
    lookups.dudx.data = g_in[2] + first;
    lookups.dvdx.data = g_in[3] + first;
    lookups.dudy.data = g_in[4] + first;
    lookups.dvdy.data = g_in[5] + first;
    return lookups;
}

static shd_texels make_texels(size_t first)
{
    shd_texels texels = {0};
    int c;
    for (c = 0; c < 4; ++c) texels.channel[c].data = g_out[c] + first;
    return texels;
}

static uint64_t hash_out(void)
{
    uint64_t hash = SHD_HASH_START;
    int c;
    for (c = 0; c < 4; ++c) hash = shd_hash(hash, g_out[c], POINTS * sizeof(float));
    return hash;
}

/* One context, texture and sampler, for tests without special needs. */
static shd_context *g_context;
static shd_texture *g_texture;
static shd_sampler *g_sampler;

static int group_setup(void **state)
{
    (void)state;
    fill_inputs();
    g_context = make_context(0, SHD_SIMD_BEST);
    g_texture = make_texture(g_context, SHD_FORMAT_RGBA8_SRGB);
    return shd_sampler_create(g_context, NULL, &g_sampler) == SHD_OK ? 0 : -1;
}
static int group_teardown(void **state)
{
    (void)state;
    shd_sampler_release(g_sampler);
    shd_texture_release(g_texture);
    shd_context_release(g_context);
    return 0;
}

static uint64_t sample_all(const shd_texture *texture)
{
    shd_lookups lookups = make_lookups(0, POINTS);
    shd_texels texels = make_texels(0);
    memset(g_out, 0, sizeof g_out);
    shd_assert_ok(shd_texture_sample(texture, g_sampler, &lookups, &texels));
    assert_int_equal(texels.nonfinite_count, 3);
    return hash_out();
}

struct argument_case {
    const char *name;
    void (*edit)(shd_lookups *lookups, shd_texels *texels);
    shd_result expected;
    const char *message;
};

static void edit_nothing(shd_lookups *l, shd_texels *t)
{
    (void)l;
    (void)t;
}
static void edit_count_zero(shd_lookups *l, shd_texels *t)
{
    *l = shd_lookups_default();
    memset(t->channel, 0, sizeof t->channel);
}
static void edit_count_one(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->count = 1;
}
static void edit_one_channel(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[0].data = t->channel[1].data = t->channel[3].data = NULL;
}
static void edit_no_derivatives(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->dudx.data = l->dvdx.data = l->dudy.data = l->dvdy.data = NULL;
}
static void edit_sized_texels(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->struct_size = (uint32_t)sizeof *t;
}
static float g_w[4]; /* 2D textures ignore it */
static void edit_w(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->count = 4;
    l->w.data = l->dwdx.data = l->dwdy.data = g_w;
}
static void edit_w_misaligned(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->w.data = (const float *)(const void *)((const char *)g_w + 2);
}
static void edit_dw(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->struct_size = (uint32_t)sizeof *t;
    t->dw[3].data = g_out[0];
}
static void edit_dw_without_size(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->struct_size = 0;
    t->dw[3].data = g_out[0];
}
static void edit_lookups_size(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->struct_size = 0;
}
static void edit_texels_size(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->struct_size = 12;
}
static void edit_no_u(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->u.data = NULL;
}
static void edit_no_v(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->v.data = NULL;
}
static void edit_no_channels(shd_lookups *l, shd_texels *t)
{
    (void)l;
    memset(t->channel, 0, sizeof t->channel);
}
static void edit_u_stride_odd(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->u.stride = 6;
}
static void edit_lod_misaligned(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->lod.data = (const float *)(const void *)((const char *)g_in[6] + 2);
}
static void edit_channel_misaligned(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[2].data = (float *)(void *)((char *)g_out[2] + 1);
}
static void edit_count_overflow(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->count = SIZE_MAX;
}
static void edit_count_2_31(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->count = (size_t)1 << 31;
    l->u.stride = (size_t)1 << 33; /* 2^64 bytes */
}
static void edit_stride_overflow(shd_lookups *l, shd_texels *t)
{
    (void)t;
    l->dvdy.stride = SIZE_MAX - 3;
}
static void edit_out_stride_overflow(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[1].stride = ((size_t)-1) / 64 * 4;
}
static void edit_out_is_u(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[0].data = g_in[0];
}
static void edit_out_touches_v(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[3].data = g_in[1] + 99;
}
static void edit_out_before_v(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[3].data = g_in[1] + 100;
}
static void edit_same_channels(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[2].data = g_out[1];
}
static void edit_shifted_channels(shd_lookups *l, shd_texels *t)
{
    (void)l;
    t->channel[2].data = g_out[1] + 5;
}
static void edit_interleaved(shd_lookups *l, shd_texels *t)
{
    size_t c;
    (void)l;
    for (c = 0; c < 4; ++c) {
        t->channel[c].data = g_out[0] + c;
        t->channel[c].stride = 16;
    }
}
static void edit_interleaved_same(shd_lookups *l, shd_texels *t)
{
    edit_interleaved(l, t);
    t->channel[3].data = g_out[0] + 4; /* the next record's channel 0 */
}
static void edit_packed_in_record(shd_lookups *l, shd_texels *t)
{
    edit_interleaved(l, t);
    t->channel[3].data = g_out[0] + 30;
    t->channel[3].stride = 4;
}

static const struct argument_case k_arguments[] = {
    {"sample/plain", edit_nothing, SHD_OK, ""},
    {"sample/count_zero", edit_count_zero, SHD_OK, ""},
    {"sample/count_one", edit_count_one, SHD_OK, ""},
    {"sample/one_channel", edit_one_channel, SHD_OK, ""},
    {"sample/no_derivatives", edit_no_derivatives, SHD_OK, ""},
    {"sample/sized_texels", edit_sized_texels, SHD_OK, ""},
    {"sample/w", edit_w, SHD_OK, ""},
    {"sample/w_misaligned", edit_w_misaligned, SHD_OK, ""},
    {"sample/dw_of_2d", edit_dw, SHD_ERROR_UNSUPPORTED, "texels.dw: set, but the texture is 2D"},
    {"sample/dw_without_size", edit_dw_without_size, SHD_ERROR_UNSUPPORTED, "texels.dw: set, but the texture is 2D"},
    {"sample/interleaved_out", edit_interleaved, SHD_OK, ""},
    {"sample/out_after_v", edit_out_before_v, SHD_OK, ""},
    {"sample/lookups_size_zero", edit_lookups_size, SHD_ERROR_INVALID_ARGUMENT, "lookups.struct_size: 0"},
    {"sample/texels_size_small", edit_texels_size, SHD_ERROR_INVALID_ARGUMENT, "texels.struct_size: 12"},
    {"sample/no_u", edit_no_u, SHD_ERROR_INVALID_ARGUMENT, "lookups.u.data: NULL"},
    {"sample/no_v", edit_no_v, SHD_ERROR_INVALID_ARGUMENT, "lookups.v.data: NULL"},
    {"sample/no_channels", edit_no_channels, SHD_ERROR_INVALID_ARGUMENT,
     "texels.channel: NULL for all, and no derivative"},
    {"sample/stride_6", edit_u_stride_odd, SHD_ERROR_INVALID_ARGUMENT, "lookups.u.stride: 6 is not a multiple of 4"},
    {"sample/lod_misaligned", edit_lod_misaligned, SHD_ERROR_INVALID_ARGUMENT, "lookups.lod.data: not aligned"},
    {"sample/channel_misaligned", edit_channel_misaligned, SHD_ERROR_INVALID_ARGUMENT,
     "texels.channel[2].data: not aligned"},
    {"sample/count_overflow", edit_count_overflow, SHD_ERROR_INVALID_ARGUMENT, "exceed the address space"},
    {"sample/count_2^31_stride_2^33", edit_count_2_31, SHD_ERROR_INVALID_ARGUMENT, "exceed the address space"},
    {"sample/stride_overflow", edit_stride_overflow, SHD_ERROR_INVALID_ARGUMENT, "lookups.dvdy: 100 elements"},
    {"sample/out_stride_overflow", edit_out_stride_overflow, SHD_ERROR_INVALID_ARGUMENT,
     "texels.channel[1]: 100 elements"},
    {"sample/out_is_u", edit_out_is_u, SHD_ERROR_INVALID_ARGUMENT, "texels.channel[0]: overlaps lookups.u"},
    {"sample/out_touches_v", edit_out_touches_v, SHD_ERROR_INVALID_ARGUMENT, "texels.channel[3]: overlaps lookups.v"},
    {"sample/same_channels", edit_same_channels, SHD_ERROR_INVALID_ARGUMENT,
     "texels.channel[2]: overlaps texels.channel[1]"},
    {"sample/shifted_channels", edit_shifted_channels, SHD_ERROR_INVALID_ARGUMENT,
     "texels.channel[2]: overlaps texels.channel[1]"},
    {"sample/interleaved_twice", edit_interleaved_same, SHD_ERROR_INVALID_ARGUMENT,
     "texels.channel[3]: overlaps texels.channel[0]"},
    {"sample/packed_inside_records", edit_packed_in_record, SHD_ERROR_INVALID_ARGUMENT,
     "texels.channel[3]: overlaps texels.channel[0]"},
};

static void test_arguments(void **state)
{
    const struct argument_case *c = (const struct argument_case *)*state;
    shd_lookups lookups = make_lookups(0, 100);
    shd_texels texels = make_texels(0);
    uint64_t before;
    texels.nonfinite_count = 12345;
    c->edit(&lookups, &texels);
    before = hash_out();
    shd_assert_result(c->name, shd_texture_sample(g_texture, g_sampler, &lookups, &texels), c->expected, c->message);
    if (c->expected != SHD_OK) {
        assert_true(hash_out() == before);
        assert_int_equal(texels.nonfinite_count, 12345);
    } else {
        assert_int_equal(texels.nonfinite_count, lookups.count > 77 ? 1 : 0);
    }
}

static void test_null_arguments(void **state)
{
    shd_lookups lookups = make_lookups(0, 4);
    shd_texels texels = make_texels(0);
    (void)state;
    shd_assert_result("texture", shd_texture_sample(NULL, g_sampler, &lookups, &texels), SHD_ERROR_INVALID_ARGUMENT,
                      "texture: NULL");
    shd_assert_result("sampler", shd_texture_sample(g_texture, NULL, &lookups, &texels), SHD_ERROR_INVALID_ARGUMENT,
                      "sampler: NULL");
    shd_assert_result("lookups", shd_texture_sample(g_texture, g_sampler, NULL, &texels), SHD_ERROR_INVALID_ARGUMENT,
                      "lookups: NULL");
    shd_assert_result("texels", shd_texture_sample(g_texture, g_sampler, &lookups, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "texels: NULL");
    shd_assert_result("types", shd_texture_sample((const shd_texture *)g_sampler, g_sampler, &lookups, &texels),
                      SHD_ERROR_INVALID_ARGUMENT, "texture: not a live handle of its type");
}

/* A sampler of another context works. */
static void test_other_context(void **state)
{
    shd_context *other = make_context(1, SHD_SIMD_BEST);
    shd_sampler *sampler = NULL;
    shd_lookups lookups = make_lookups(0, 20);
    shd_texels texels = make_texels(0);
    (void)state;
    shd_assert_ok(shd_sampler_create(other, NULL, &sampler));
    shd_assert_ok(shd_texture_sample(g_texture, sampler, &lookups, &texels));
    shd_sampler_release(sampler);
    shd_context_release(other);
}

/* Summed-area lookups require their table, and support neither derivatives nor explanations. */
static void test_summed_area(void **state)
{
    shd_context *context = make_context(1, SHD_SIMD_BEST);
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_texture_desc td = shd_texture_desc_default();
    shd_explanation explanation = shd_explanation_default();
    shd_sampler *sampler = NULL;
    shd_texture *texture = NULL;
    shd_lookups lookups = make_lookups(0, 20);
    shd_texels texels = make_texels(0);
    (void)state;
    sd.filter = SHD_FILTER_SUMMED_AREA;
    td.format = SHD_FORMAT_RGBA8;
    td.width = td.height = SIZE;
    td.texels = g_texels;
    td.tables = SHD_TABLE_SUMMED_AREA;
    shd_assert_ok(shd_sampler_create(context, &sd, &sampler));
    shd_assert_ok(shd_texture_create(context, &td, &texture));
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    shd_assert_result("no table", shd_texture_sample(g_texture, sampler, &lookups, &texels), SHD_ERROR_INVALID_ARGUMENT,
                      "no SHD_TABLE_SUMMED_AREA");
    shd_assert_result("explain", shd_texture_explain(texture, sampler, &lookups, 0, &explanation),
                      SHD_ERROR_UNSUPPORTED, "not a tree of blends");
    texels.struct_size = sizeof texels;
    texels.du[0].data = g_out[0];
    texels.channel[0].data = NULL;
    shd_assert_result("derivatives", shd_texture_sample(texture, sampler, &lookups, &texels), SHD_ERROR_UNSUPPORTED,
                      "has no derivatives");
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_context_release(context);
}

static void test_batch_splits(void **state)
{
    static const size_t k_steps[] = {1, 3, 17, 511, 512, 16383, 16384, 16385};
    const uint64_t whole = sample_all(g_texture);
    size_t k, first;
    (void)state;
    for (k = 0; k < sizeof k_steps / sizeof k_steps[0]; ++k) {
        size_t nonfinite = 0;
        memset(g_out, 0, sizeof g_out);
        for (first = 0; first < POINTS; first += k_steps[k]) {
            const size_t rest = POINTS - first;
            shd_lookups lookups = make_lookups(first, rest < k_steps[k] ? rest : k_steps[k]);
            shd_texels texels = make_texels(first);
            shd_assert_ok(shd_texture_sample(g_texture, g_sampler, &lookups, &texels));
            nonfinite += texels.nonfinite_count;
        }
        assert_true(hash_out() == whole);
        assert_int_equal(nonfinite, 3);
    }
}

/* Input in records of 12 floats and output in records of 5 floats give the bits of packed columns; other floats of
 * the records do not change. */
static void test_strides(void **state)
{
    float *in = (float *)calloc(POINTS * 12, sizeof(float));
    float *out = (float *)calloc(POINTS * 5 + 1, sizeof(float));
    const uint64_t packed = sample_all(g_texture);
    shd_lookups lookups = make_lookups(0, POINTS);
    shd_texels texels = {0};
    shd_f32_in *columns[6];
    size_t c, i;
    (void)state;
    columns[0] = &lookups.u;
    columns[1] = &lookups.v;
    columns[2] = &lookups.dudx;
    columns[3] = &lookups.dvdx;
    columns[4] = &lookups.dudy;
    columns[5] = &lookups.dvdy;
    for (c = 0; c < 6; ++c) {
        for (i = 0; i < POINTS; ++i) in[i * 12 + c] = g_in[c][i];
        columns[c]->data = in + c;
        columns[c]->stride = 48;
    }
    for (c = 0; c < 4; ++c) {
        texels.channel[c].data = out + c;
        texels.channel[c].stride = 20;
    }
    shd_assert_ok(shd_texture_sample(g_texture, g_sampler, &lookups, &texels));
    assert_int_equal(texels.nonfinite_count, 3);
    for (i = 0; i < POINTS; ++i) {
        for (c = 0; c < 4; ++c) g_out[c][i] = out[i * 5 + c];
        assert_true(out[i * 5 + 4] == 0);
    }
    assert_true(hash_out() == packed);
    free(in);
    free(out);
}

static void test_workers(void **state)
{
    const uint64_t want = sample_all(g_texture);
    uint32_t workers;
    (void)state;
    for (workers = 1; workers <= 16; ++workers) {
        shd_context *context = make_context(workers, SHD_SIMD_BEST);
        shd_texture *texture = make_texture(context, SHD_FORMAT_RGBA8_SRGB);
        assert_true(sample_all(texture) == want);
        shd_texture_release(texture);
        shd_context_release(context);
    }
}

static void test_simd_targets(void **state)
{
    static const shd_format k_formats[] = {SHD_FORMAT_R8, SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB};
    size_t f;
    int simd;
    (void)state;
    for (f = 0; f < sizeof k_formats / sizeof k_formats[0]; ++f) {
        shd_texture *best = make_texture(g_context, k_formats[f]);
        const uint64_t want = sample_all(best);
        shd_texture_release(best);
        for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
            shd_context *context = make_context(2, (shd_simd)simd);
            shd_texture *texture;
            if (!context) continue; /* not this machine's */
            texture = make_texture(context, k_formats[f]);
            if (sample_all(texture) != want) fail_msg("%s differs", shd_context_get_simd_target(context));
            shd_texture_release(texture);
            shd_context_release(context);
        }
    }
}

static shd_result broken_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    (void)user_data;
    (void)count;
    (void)task;
    (void)task_data;
    return SHD_ERROR_LIMIT;
}

static void test_failing_executor(void **state)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    shd_texture *texture;
    shd_lookups lookups = make_lookups(0, POINTS);
    shd_texels texels = make_texels(0);
    (void)state;
    desc.executor.parallel_for = broken_parallel_for;
    desc.executor.worker_count = 1;
    shd_assert_ok(shd_context_create(&desc, &context));
    {
        shd_texture_desc td = shd_texture_desc_default();
        td.format = SHD_FORMAT_R8;
        td.width = td.height = SIZE; /* one task, so it runs without the executor */
        td.texels = g_texels;
        shd_assert_ok(shd_texture_create(context, &td, &texture));
    }
    texels.nonfinite_count = 9;
    shd_assert_result("sample", shd_texture_sample(texture, g_sampler, &lookups, &texels), SHD_ERROR_CALLBACK,
                      "executor.parallel_for returned SHD_ERROR_LIMIT");
    assert_int_equal(texels.nonfinite_count, 9);
    shd_texture_release(texture);
    shd_context_release(context);
}

int main(void)
{
    struct CMUnitTest tests[48];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_arguments / sizeof k_arguments[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_arguments[i].name, test_arguments, NULL, NULL, (void *)&k_arguments[i]};
    }
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"summed_area", test_summed_area, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"other_context", test_other_context, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"batch_splits", test_batch_splits, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"strides", test_strides, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"workers_1_to_16", test_workers, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"simd_targets", test_simd_targets, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"failing_executor", test_failing_executor, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.lookup", tests, n, group_setup, group_teardown);
}
