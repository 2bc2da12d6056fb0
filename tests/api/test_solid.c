/* SPDX-License-Identifier: MIT */
/* Solid textures through the public function: checks, columns of any stride, contexts, colours, and large batches. */
#include "support/context.h"
#include "support/rows.h"
#include "support/simd.h"

#include <shd/shd.h>

enum { k_points = 1003, k_many = 40009 };

/** Points and all columns of values. */
struct table {
    float position[3][k_points], width[k_points];
    float value[k_points], gradient[3][k_points], color[4][k_points];
};
static struct table g;

static void fill_places(void)
{
    int i;
    for (i = 0; i < k_points; ++i) {
        g.position[0][i] = 0.0371f * (float)i - 17.0f;
        g.position[1][i] = 0.25f * (float)(i % 37) - 3.1f;
        g.position[2][i] = 3.7f - 0.0173f * (float)i;
        g.width[i] = 0.01f * (float)(i % 50);
    }
}

static shd_solid_points places(size_t count)
{
    shd_solid_points points = shd_solid_points_default();
    int c;
    points.count = count;
    for (c = 0; c < 3; ++c) points.position[c].data = g.position[c];
    points.width.data = g.width;
    return points;
}

static shd_solid_values values(void)
{
    shd_solid_values out = shd_solid_values_default();
    int c;
    memset(g.value, 0, sizeof g.value);
    memset(g.gradient, 0, sizeof g.gradient);
    memset(g.color, 0, sizeof g.color);
    out.value.data = g.value;
    for (c = 0; c < 3; ++c) out.gradient[c].data = g.gradient[c];
    for (c = 0; c < 4; ++c) out.channel[c].data = g.color[c];
    return out;
}

/** A marble of three colours. */
static shd_solid_desc marble(void)
{
    static const float k_colors[3][4] = {{0.1f, 0.1f, 0.2f, 1}, {0.6f, 0.55f, 0.5f, 0.5f}, {1, 1, 0.9f, 0.25f}};
    shd_solid_desc desc = shd_solid_desc_default();
    desc.kind = SHD_SOLID_MARBLE;
    desc.octaves = 6;
    desc.size = 0.7f;
    desc.distortion = 4;
    desc.color_count = 3;
    memcpy(desc.colors, k_colors, sizeof k_colors);
    return desc;
}

struct bad_desc {
    const char *name;
    size_t offset; /* place of the field */
    int is_float;
    double value;
    const char *message;
};
#define FIELD(field) offsetof(shd_solid_desc, field)
static const struct bad_desc k_bad[] = {
    {"kind", FIELD(kind), 0, 8, "solid.kind: 8 is not in 0..7"},
    {"kind_max", FIELD(kind), 0, 4294967295.0, "solid.kind: 4294967295 is not in 0..7"},
    {"size_0", FIELD(size), 1, 0, "solid.size: 0 is not in 1e-30..1e+30"},
    {"size_negative", FIELD(size), 1, -1, "solid.size: -1 is not in"},
    {"size_nan", FIELD(size), 1, NAN, "solid.size: "},
    {"size_infinite", FIELD(size), 1, INFINITY, "solid.size: inf is not in"},
    {"size_tiny", FIELD(size), 1, 1e-31, "solid.size: 1e-31 is not in"},
    {"octaves_0", FIELD(octaves), 0, 0, "solid.octaves: 0 is not in 1..32"},
    {"octaves_1000", FIELD(octaves), 0, 1000, "solid.octaves: 1000 is not in 1..32"},
    {"lacunarity_0", FIELD(lacunarity), 1, 0, "solid.lacunarity: 0 is not in 1..16"},
    {"lacunarity_nan", FIELD(lacunarity), 1, NAN, "solid.lacunarity: "},
    {"gain_negative", FIELD(gain), 1, -0.5, "solid.gain: -0.5 is not in 0..1"},
    {"gain_2", FIELD(gain), 1, 2, "solid.gain: 2 is not in 0..1"},
    {"sum", FIELD(sum), 0, 2, "solid.sum: 2 is not in 0..1"},
    {"gradients", FIELD(gradients), 0, 2, "solid.gradients: 2 is not in 0..1"},
    {"fade", FIELD(fade), 0, 7, "solid.fade: 7 is not in 0..2"},
    {"distance", FIELD(distance), 0, 3, "solid.distance: 3 is not in 0..2"},
    {"distortion", FIELD(distortion), 1, 1001, "solid.distortion: 1001 is not in 0..1000"},
    {"distortion_nan", FIELD(distortion), 1, NAN, "solid.distortion: "},
    {"range", FIELD(range), 1, 2e6, "solid.range[0]: 2e+06 is not in"},
    {"range_nan", FIELD(range) + sizeof(float), 1, NAN, "solid.range[1]: "},
    {"color_count_1", FIELD(color_count), 0, 1, "solid.color_count: 1 is not in 2..8"},
    {"color_count_9", FIELD(color_count), 0, 9, "solid.color_count: 9 is not in 2..8"},
    {"color_nan", FIELD(colors) + 7 * sizeof(float), 1, NAN, "solid.colors[1][3]: "},
    {"struct_size", FIELD(struct_size), 0, 4, "solid.struct_size: 4"},
};

static void test_bad_desc(void **state)
{
    const struct bad_desc *c = (const struct bad_desc *)*state;
    shd_solid_desc desc = shd_solid_desc_default();
    const shd_solid_points points = places(1);
    shd_solid_values out = values();
    const float real = (float)c->value;
    const uint32_t whole = c->is_float ? 0 : (uint32_t)c->value;
    memcpy((char *)&desc + c->offset, c->is_float ? (const void *)&real : (const void *)&whole, 4);
    g.value[0] = 7;
    shd_assert_result(c->name, shd_solid_evaluate(g_context, &desc, &points, &out), SHD_ERROR_INVALID_ARGUMENT,
                      c->message);
    assert_true(g.value[0] == 7.0f);
}

/** Columns and structs that are missing, misaligned or shared. */
static void test_bad_columns(void **state)
{
    const shd_solid_desc desc = shd_solid_desc_default();
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
    shd_solid_points points = places(8);
    shd_solid_values out = values();
    (void)state;
    shd_assert_result("desc", shd_solid_evaluate(g_context, NULL, &points, &out), bad, "solid: NULL");
    shd_assert_result("points", shd_solid_evaluate(g_context, &desc, NULL, &out), bad, "points: NULL");
    shd_assert_result("values", shd_solid_evaluate(g_context, &desc, &points, NULL), bad, "values: NULL");
    points.position[1].data = NULL;
    shd_assert_result("y", shd_solid_evaluate(g_context, &desc, &points, &out), bad, "points.position[1].data: NULL");
    points = places(8);
    points.position[2].stride = 6;
    shd_assert_result("stride", shd_solid_evaluate(g_context, &desc, &points, &out), bad,
                      "points.position[2].stride: 6");
    points = places(8);
    out.channel[3].data = g.width;
    shd_assert_result("overlap", shd_solid_evaluate(g_context, &desc, &points, &out), bad,
                      "values.channel[3]: overlaps points.width");
    out = shd_solid_values_default();
    shd_assert_result("none", shd_solid_evaluate(g_context, &desc, &points, &out), bad, "values.value: NULL");
    points.count = 0;
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
}

static void test_bad_context(void **state)
{
    static const uint64_t k_zeros[64];
    const shd_solid_desc desc = shd_solid_desc_default();
    const shd_solid_points points = places(1);
    shd_solid_values out = values();
    (void)state;
    shd_assert_result("context", shd_solid_evaluate((shd_context *)(uintptr_t)k_zeros, &desc, &points, &out),
                      SHD_ERROR_INVALID_ARGUMENT, "context: not a live handle");
}

/** Each wanted column is the same whether the others are wanted or not, packed or interleaved. */
static void test_columns(void **state)
{
    static float records[k_points][12], want[8][k_points];
    const shd_solid_desc desc = marble();
    shd_solid_points points = places(k_points);
    shd_solid_values out = values();
    int c, i;
    (void)state;
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    memcpy(want[0], g.value, sizeof g.value);
    memcpy(want[1], g.gradient, sizeof g.gradient);
    memcpy(want[4], g.color, sizeof g.color);
    for (c = 0; c < 8; ++c) {
        const shd_f32_out nothing = {NULL, 0};
        shd_f32_out column;
        out = values();
        column = c == 0 ? out.value : c < 4 ? out.gradient[c - 1] : out.channel[c - 4];
        out = shd_solid_values_default();
        out.value = c == 0 ? column : nothing;
        if (c > 0 && c < 4) out.gradient[c - 1] = column;
        if (c >= 4) out.channel[c - 4] = column;
        shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
        assert_memory_equal(column.data, want[c], sizeof want[c]);
    }
    for (i = 0; i < k_points; ++i) {
        for (c = 0; c < 3; ++c) records[i][c] = g.position[c][i];
        records[i][3] = g.width[i];
    }
    for (c = 0; c < 3; ++c) points.position[c] = shd_f32_column(&records[0][c], sizeof records[0]);
    points.width = shd_f32_column(&records[0][3], sizeof records[0]);
    out = shd_solid_values_default();
    out.value = shd_f32_out_column(&records[0][4], sizeof records[0]);
    for (c = 0; c < 3; ++c) out.gradient[c] = shd_f32_out_column(&records[0][5 + c], sizeof records[0]);
    for (c = 0; c < 4; ++c) out.channel[c] = shd_f32_out_column(&records[0][8 + c], sizeof records[0]);
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    for (i = 0; i < k_points; ++i) {
        for (c = 0; c < 8; ++c) assert_true(records[i][4 + c] == want[c][i]);
    }
}

/** Colours at the ends of the default range and of a range of the caller, which may fall. */
static void test_ramp(void **state)
{
    shd_solid_desc desc = shd_solid_desc_default();
    const shd_solid_points points = places(k_points);
    shd_solid_values out = values();
    int i;
    (void)state;
    desc.kind = SHD_SOLID_SIMPLEX;
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    for (i = 0; i < k_points; ++i) {
        shd_assert_close("default", (size_t)i, (double)g.color[1][i], 0.5 + 0.5 * (double)g.value[i], 1e-6, 0);
        assert_true(g.color[3][i] == 1.0f);
    }
    desc.range[0] = 0.25f;
    desc.range[1] = -0.25f;
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    for (i = 0; i < k_points; ++i) {
        const double want = fmin(fmax(0.5 - 2 * (double)g.value[i], 0), 1);
        shd_assert_close("falling", (size_t)i, (double)g.color[0][i], want, 1e-6, 0);
    }
    desc.kind = SHD_SOLID_STRIPES;
    desc.range[0] = 0.0f;
    desc.range[1] = 2e-39f; /* colours change all but at once */
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    for (i = 0; i < k_points; ++i) {
        if (g.value[i] == 0.0f) assert_true(g.color[0][i] == desc.colors[0][0]);
        if (g.value[i] == 1.0f) assert_true(g.color[0][i] == desc.colors[1][0]);
    }
}

/** Points that are not finite are counted, over all parts of a batch, and by older callers too. */
static void test_nonfinite(void **state)
{
    const shd_solid_desc desc = marble();
    shd_solid_points points = places(k_points);
    shd_solid_values out = values();
    (void)state;
    g.position[0][3] = NAN;
    g.position[1][700] = INFINITY;
    g.position[2][700] = NAN;
    g.width[1002] = -INFINITY;
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    assert_int_equal(out.nonfinite_count, 3);
    fill_places();
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    assert_int_equal(out.nonfinite_count, 0);
}

/** A batch over several tasks, on every target and worker count, has the bits of a call without a context. */
static void test_contexts(void **state)
{
    static float x[k_many], y[k_many], want[k_many], got[k_many];
    const shd_solid_desc desc = marble();
    shd_solid_points points = shd_solid_points_default();
    shd_solid_values out = shd_solid_values_default();
    int simd, i;
    (void)state;
    for (i = 0; i < k_many; ++i) {
        x[i] = 0.001f * (float)i;
        y[i] = 0.37f * (float)(i % 1000);
    }
    points.count = k_many;
    points.position[0].data = x;
    points.position[1].data = points.position[2].data = y;
    out.value.data = want;
    shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
    out.value.data = got;
    for (simd = SHD_SIMD_BEST; simd <= SHD_SIMD_WASM; ++simd) {
        uint32_t workers;
        if (!shd_simd_can_run(simd)) continue;
        for (workers = 1; workers <= 3; ++workers) {
            shd_context_desc cd = shd_context_desc_default();
            shd_context *context = NULL;
            cd.simd = (shd_simd)simd;
            cd.worker_count = workers;
            shd_assert_ok(shd_context_create(&cd, &context));
            memset(got, 0, sizeof got);
            shd_assert_ok(shd_solid_evaluate(context, &desc, &points, &out));
            assert_memory_equal(got, want, sizeof got);
            shd_context_release(context);
        }
    }
}

/** An executor that fails makes the call fail. */
static shd_result refuse(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    (void)user_data, (void)count, (void)task, (void)task_data;
    return SHD_ERROR_INTERNAL;
}

static void test_executor_fails(void **state)
{
    static float x[k_many], got[k_many];
    const shd_solid_desc desc = shd_solid_desc_default();
    shd_context_desc cd = shd_context_desc_default();
    shd_solid_points points = shd_solid_points_default();
    shd_solid_values out = shd_solid_values_default();
    shd_context *context = NULL;
    (void)state;
    cd.executor.parallel_for = refuse;
    cd.executor.worker_count = 2;
    shd_assert_ok(shd_context_create(&cd, &context));
    points.count = k_many;
    points.position[0].data = points.position[1].data = points.position[2].data = x;
    out.value.data = got;
    shd_assert_result("refused", shd_solid_evaluate(context, &desc, &points, &out), SHD_ERROR_CALLBACK,
                      "executor.parallel_for returned");
    points.count = 16;
    shd_assert_ok(shd_solid_evaluate(context, &desc, &points, &out));
    shd_context_release(context);
}

/** Seeds change every kind of noise, and the two waves not at all. */
static void test_seeds(void **state)
{
    static float first[k_points];
    const shd_solid_points points = places(k_points);
    int kind;
    (void)state;
    for (kind = SHD_SOLID_STRIPES; kind <= SHD_SOLID_WOOD; ++kind) {
        shd_solid_desc desc = shd_solid_desc_default();
        shd_solid_values out = values();
        desc.kind = (shd_solid)kind;
        shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
        memcpy(first, g.value, sizeof first);
        desc.seed = 1;
        shd_assert_ok(shd_solid_evaluate(g_context, &desc, &points, &out));
        assert_int_equal(memcmp(first, g.value, sizeof first) == 0, kind <= SHD_SOLID_CHECKER);
    }
}

int main(void)
{
    fill_places();
    ADD_ROWS(k_bad, test_bad_desc);
    add("bad_columns", test_bad_columns, NULL);
    add("bad_context", test_bad_context, NULL);
    add("columns", test_columns, NULL);
    add("ramp", test_ramp, NULL);
    add("nonfinite", test_nonfinite, NULL);
    add("contexts", test_contexts, NULL);
    add("executor_fails", test_executor_fails, NULL);
    add("seeds", test_seeds, NULL);
    return _cmocka_run_group_tests("api.solid", g_tests, g_count, set_up, tear_down);
}
