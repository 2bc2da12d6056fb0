/* SPDX-License-Identifier: MIT */
/* Generalised barycentric coordinates through the public function: checks, strides, contexts, points that are not
   finite or outside. */
#include "support/context.h"
#include "support/fault_allocator.h"
#include "support/rows.h"

#include <math.h>

#include <shd/polygon.h>
#include <shd/shd.h>

enum { k_vertices = 5, k_points = 37, k_many = 33013 };

static const float k_x[k_vertices] = {0, 2, 2.5f, 1, -0.5f}, k_y[k_vertices] = {0, 0, 1.5f, 2.5f, 1};
static float g_x[k_many], g_y[k_many], g_weight[k_vertices][k_many];
static shd_f32_out g_columns[SHD_MAX_POLYGON_VERTICES];

static shd_polygon_desc pentagon(shd_barycentric kind)
{
    shd_polygon_desc desc = shd_polygon_desc_default();
    desc.kind = kind;
    desc.vertex[0].data = k_x;
    desc.vertex[1].data = k_y;
    desc.vertex_count = k_vertices;
    desc.segments = 8;
    return desc;
}

static shd_polygon_points places(size_t count)
{
    shd_polygon_points points = shd_polygon_points_default();
    size_t i;
    for (i = 0; i < count; ++i) {
        g_x[i] = -1.0f + 0.0031f * (float)(i % 1290);
        g_y[i] = -1.0f + 0.0171f * (float)(i % 233);
    }
    points.count = count;
    points.position[0].data = g_x;
    points.position[1].data = g_y;
    return points;
}

static shd_polygon_weights weights(void)
{
    shd_polygon_weights out = shd_polygon_weights_default();
    int i;
    for (i = 0; i < k_vertices; ++i) g_columns[i] = shd_f32_out_column(g_weight[i], 0);
    out.weight = g_columns;
    out.weight_count = k_vertices;
    return out;
}

static int is_unsupported(shd_barycentric kind)
{
    const shd_polygon_desc desc = pentagon(kind);
    const shd_polygon_points points = places(1);
    shd_polygon_weights out = weights();
    return shd_polygon_evaluate(g_context, &desc, &points, &out) == SHD_ERROR_UNSUPPORTED;
}

struct bad_case {
    const char *name;
    float x[6], y[6];
    uint32_t count, kind, segments;
    const char *message;
};
static const struct bad_case k_bad[] = {
    {"two_vertices", {0, 1}, {0, 1}, 2, 0, 32, "polygon.vertex_count: 2 is not in 3..256"},
    {"no_vertices", {0}, {0}, 0, 1, 32, "polygon.vertex_count: 0 is not in 3..256"},
    {"many_vertices", {0}, {0}, 257, 1, 32, "polygon.vertex_count: 257 is not in 3..256"},
    {"kind", {0, 1, 0}, {0, 0, 1}, 3, 4, 32, "polygon.kind: 4 is not in 0..3"},
    {"segments_0", {0, 1, 0}, {0, 0, 1}, 3, 0, 0, "polygon.segments: 0 is not in 1..256"},
    {"nan", {0, 1, 0}, {0, (float)NAN, 1}, 3, 1, 32, "polygon.vertex[1]"},
    {"infinite", {0, (float)INFINITY, 0}, {0, 0, 1}, 3, 1, 32, "polygon.vertex[0]"},
    {"collinear", {0, 1, 2}, {0, 1, 2}, 3, 1, 32, "polygon.vertex: the polygon turns back on itself at 0"},
    {"point", {3, 3, 3}, {4, 4, 4}, 3, 1, 32, "polygon.vertex: 0 and 1 are the same point"},
    {"bow_tie", {0, 1, 1, 0}, {0, 1, 0, 1}, 4, 1, 32, "polygon.vertex: the edges from 0 and from 2 meet"},
    {"reflex", {0, 4, 1, 0}, {0, 0, 1, 4}, 4, 0, 32, "polygon.vertex: reflex at 2, but kind 0 needs a convex polygon"},
    {"reflex_cotangent", {0, 4, 1, 0}, {0, 0, 1, 4}, 4, 2, 32, "polygon.vertex: reflex at 2, but kind 2"},
    {"straight", {0, 1, 2, 1}, {0, 0, 0, 1}, 4, 0, 32, "polygon.vertex: no turn at 1, but kind 0"},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    shd_polygon_desc desc = pentagon(SHD_BARYCENTRIC_WACHSPRESS);
    const shd_polygon_points points = places(1);
    shd_polygon_weights out = weights();
    desc.kind = (shd_barycentric)c->kind;
    desc.vertex[0].data = c->x;
    desc.vertex[1].data = c->y;
    desc.vertex_count = c->count;
    desc.segments = c->segments;
    out.weight_count = c->count;
    g_weight[0][0] = 7;
    shd_assert_result(c->name, shd_polygon_evaluate(g_context, &desc, &points, &out), SHD_ERROR_INVALID_ARGUMENT,
                      c->message);
    assert_true(g_weight[0][0] == 7.0f);
}

static void test_bad_columns(void **state)
{
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
    shd_polygon_desc desc = pentagon(SHD_BARYCENTRIC_MEAN_VALUE);
    shd_polygon_points points = places(k_points);
    shd_polygon_weights out = weights();
    (void)state;
    shd_assert_result("desc", shd_polygon_evaluate(g_context, NULL, &points, &out), bad, "polygon: NULL");
    shd_assert_result("points", shd_polygon_evaluate(g_context, &desc, NULL, &out), bad, "points: NULL");
    shd_assert_result("weights", shd_polygon_evaluate(g_context, &desc, &points, NULL), bad, "weights: NULL");
    desc.vertex[1].data = NULL;
    shd_assert_result("vertex", shd_polygon_evaluate(g_context, &desc, &points, &out), bad, "polygon.vertex[1]: NULL");
    desc = pentagon(SHD_BARYCENTRIC_MEAN_VALUE);
    points.position[0].data = NULL;
    shd_assert_result("x", shd_polygon_evaluate(g_context, &desc, &points, &out), bad, "points.position[0].data: NULL");
    points = places(k_points);
    out.weight_count = 4;
    shd_assert_result("count", shd_polygon_evaluate(g_context, &desc, &points, &out), bad,
                      "weights.weight_count: 4 is not in 5..5");
    out = weights();
    out.weight = NULL;
    shd_assert_result("array", shd_polygon_evaluate(g_context, &desc, &points, &out), bad, "weights.weight: NULL");
    out = weights();
    g_columns[3].data = g_y;
    shd_assert_result("overlap", shd_polygon_evaluate(g_context, &desc, &points, &out), bad,
                      "weights.weight[3]: overlaps points.position[1]");
    memset(g_columns, 0, sizeof g_columns);
    shd_assert_result("none", shd_polygon_evaluate(g_context, &desc, &points, &out), bad,
                      "weights.weight: NULL for all");
}

/** Sums of weights are 1 and positions are reproduced inside; outside points and bad ones are counted. */
static void test_kinds(void **state)
{
    int kind;
    (void)state;
    for (kind = 0; kind <= SHD_BARYCENTRIC_HARMONIC; ++kind) {
        const shd_polygon_desc desc = pentagon((shd_barycentric)kind);
        shd_polygon_points points = places(k_points * 30);
        shd_polygon_weights out = weights();
        size_t i, outside = 0;
        int v;
        if (is_unsupported((shd_barycentric)kind)) continue;
        points.count = k_points * 30;
        g_x[5] = NAN;
        g_y[6] = -INFINITY;
        shd_assert_ok(shd_polygon_evaluate(g_context, &desc, &points, &out));
        assert_int_equal(out.nonfinite_count, 2);
        for (i = 0; i < points.count; ++i) {
            double sum = 0, x = 0, y = 0;
            for (v = 0; v < k_vertices; ++v) {
                assert_true(isfinite(g_weight[v][i]));
                sum += (double)g_weight[v][i];
                x += (double)g_weight[v][i] * (double)k_x[v];
                y += (double)g_weight[v][i] * (double)k_y[v];
            }
            shd_assert_close("sum", i, sum, 1, 2e-6, 0);
            if (i == 5 || i == 6) continue;
            if (fabs(x - (double)g_x[i]) > 1e-5 || fabs(y - (double)g_y[i]) > 1e-5) ++outside;
        }
        assert_true(out.outside_count > 100 && out.outside_count < points.count);
        if (kind == SHD_BARYCENTRIC_MEAN_VALUE) {
            assert_int_equal(outside, 0); /* the formula holds in the whole plane */
        } else {
            assert_true(outside + 2 >= out.outside_count && outside <= out.outside_count);
        }
    }
}

/** Interleaved columns and contexts with any number of workers give the bits of one packed call. */
static void test_contexts(void **state)
{
    static float want[k_vertices][k_many], records[k_many][k_vertices + 2];
    const shd_polygon_desc desc = pentagon(SHD_BARYCENTRIC_MEAN_VALUE);
    shd_polygon_points points = places(k_many);
    shd_polygon_weights out = weights();
    uint32_t workers;
    size_t i, v;
    (void)state;
    shd_assert_ok(shd_polygon_evaluate(g_context, &desc, &points, &out));
    memcpy(want, g_weight, sizeof want);
    for (workers = 1; workers <= 3; ++workers) {
        shd_context_desc cd = shd_context_desc_default();
        shd_context *context = NULL;
        cd.worker_count = workers;
        shd_assert_ok(shd_context_create(&cd, &context));
        memset(g_weight, 0, sizeof g_weight);
        shd_assert_ok(shd_polygon_evaluate(context, &desc, &points, &out));
        assert_memory_equal(g_weight, want, sizeof want);
        shd_context_release(context);
    }
    for (i = 0; i < k_many; ++i) {
        records[i][0] = g_x[i];
        records[i][1] = g_y[i];
    }
    points.position[0] = shd_f32_column(&records[0][0], sizeof records[0]);
    points.position[1] = shd_f32_column(&records[0][1], sizeof records[0]);
    for (v = 0; v < k_vertices; ++v) g_columns[v] = shd_f32_out_column(&records[0][2 + v], sizeof records[0]);
    shd_assert_ok(shd_polygon_evaluate(g_context, &desc, &points, &out));
    for (i = 0; i < k_many; ++i) {
        for (v = 0; v < k_vertices; ++v) assert_true(records[i][2 + v] == want[v][i]);
    }
}

/** Each allocation of the harmonic solution fails in turn. */
static void test_faults(void **state)
{
    const shd_polygon_desc desc = pentagon(SHD_BARYCENTRIC_HARMONIC);
    shd_fault_allocator memory;
    shd_context_desc cd;
    shd_context *context = NULL;
    size_t n, failed = 0;
    (void)state;
    if (is_unsupported(SHD_BARYCENTRIC_HARMONIC)) skip();
    memset(&memory, 0, sizeof memory);
    cd = shd_fault_context_desc(&memory);
    shd_assert_ok(shd_context_create(&cd, &context));
    for (n = 1; n < 100; ++n) {
        const shd_polygon_points points = places(k_points);
        shd_polygon_weights out = weights();
        const size_t before = memory.live_bytes;
        shd_result result;
        shd_fault_arm(&memory, n, 0);
        result = shd_polygon_evaluate(context, &desc, &points, &out);
        shd_fault_arm(&memory, 0, 0);
        assert_int_equal(memory.live_bytes, before);
        if (result == SHD_OK) break;
        shd_assert_result("fault", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        ++failed;
    }
    assert_true(failed >= 4 && n < 100);
    shd_context_release(context);
    shd_assert_all_freed("polygon", &memory);
}

/** HARMONIC next to a reflex vertex: the differences from many segments that shd/polygon.h names. */
static void test_reflex(void **state)
{
    enum { VERTICES = 6, POINTS = 4000, SOLUTIONS = 4 };
    static const float x[VERTICES] = {0, 2, 2, 1, 1, 0}, y[VERTICES] = {0, 0, 1, 1, 2, 2};
    static const struct {
        uint32_t segments;
        double largest;
    } k_bounds[SOLUTIONS] = {{SHD_IS_SANITIZED ? 128 : 256, 0}, {32, 0.05}, {64, 0.03}, {128, 0.015}};
    static float weight[SOLUTIONS][VERTICES][POINTS];
    (void)state;
    if (is_unsupported(SHD_BARYCENTRIC_HARMONIC)) skip();
    for (int i = 0; i < POINTS; ++i) { /* on spirals around the reflex vertex, inside the polygon */
        const double r = i % 2 ? 0.1 * i / POINTS : 0.98 * i / POINTS,
                     turn = 1.5 * 3.14159265 * (i * 0.618034 - floor(i * 0.618034));
        g_x[i] = (float)(1.0 + r * cos(1.5707963 + turn)), g_y[i] = (float)(1.0 + r * sin(1.5707963 + turn));
    }
    for (int k = 0; k < SOLUTIONS; ++k) {
        shd_polygon_desc desc = shd_polygon_desc_default();
        shd_polygon_points points = shd_polygon_points_default();
        shd_polygon_weights out = shd_polygon_weights_default();
        double worst = 0.0;
        desc.kind = SHD_BARYCENTRIC_HARMONIC;
        desc.vertex[0].data = x, desc.vertex[1].data = y;
        desc.vertex_count = VERTICES;
        desc.segments = k_bounds[k].segments;
        points.count = POINTS;
        points.position[0].data = g_x, points.position[1].data = g_y;
        for (int i = 0; i < VERTICES; ++i) g_columns[i] = shd_f32_out_column(weight[k][i], 0);
        out.weight = g_columns;
        out.weight_count = VERTICES;
        shd_assert_ok(shd_polygon_evaluate(g_context, &desc, &points, &out));
        for (size_t i = 0; i < (size_t)VERTICES * POINTS; ++i) {
            const double e =
                fabs((double)weight[k][i / POINTS][i % POINTS] - (double)weight[0][i / POINTS][i % POINTS]);
            worst = fmax(worst, e);
        }
        if (getenv("SHD_TEST_VERBOSE")) printf("%u segments: %.4f\n", desc.segments, worst);
        assert_true(worst <= k_bounds[k].largest);
        assert_true(k == 0 || SHD_IS_SANITIZED || worst > 0.3 * k_bounds[k].largest); /* the figure is not idle */
    }
}

int main(void)
{
    ADD_ROWS(k_bad, test_bad);
    add("bad_columns", test_bad_columns, NULL);
    add("kinds", test_kinds, NULL);
    add("contexts", test_contexts, NULL);
    add("reflex", test_reflex, NULL);
    add("faults", test_faults, NULL);
    return _cmocka_run_group_tests("api.polygon", g_tests, g_count, set_up, tear_down);
}
