/* SPDX-License-Identifier: MIT */
/* Derivatives and levels of detail that are degenerate, huge or not finite: every filter and wrap on every SIMD target.
 * Values stay within the range of the texels, all targets give the same bits, and the number of texels that a lookup
 * reads is bounded. */
#include "support/filters.h"
#include "support/rows.h"

#include <float.h>

enum { COUNT = 19 };

static struct {
    size_t lookups, explained;
    uint32_t most_taps[SHD_FILTER_ROWS];
} g_tried;

/* ---- derivatives ---- */

struct footprint_case {
    const char *name;
    float j[4]; /* dudx, dvdx, dudy, dvdy */
};
#define INF INFINITY
static const struct footprint_case k_footprints[] = {
    {"derivatives/zero", {0, 0, 0, 0}},
    {"derivatives/minus_zero", {-0.0f, -0.0f, -0.0f, -0.0f}},
    {"derivatives/denormal", {1e-42f, -1e-45f, 1e-44f, -1e-42f}},
    {"derivatives/smallest_normal", {FLT_MIN, FLT_MIN, -FLT_MIN, FLT_MIN}},
    {"derivatives/one_axis_x", {0.3f, 0, 0, 0}},
    {"derivatives/one_axis_y", {0, 0, 0, -0.3f}},
    {"derivatives/equal", {0.2f, 0.1f, 0.2f, 0.1f}},
    {"derivatives/opposite", {0.2f, 0.1f, -0.2f, -0.1f}},
    {"derivatives/parallel", {0.3f, 0.2f, 0.15f, 0.1f}},
    {"derivatives/parallel_but_an_ulp", {0.3f, 0.2f, 0.30000004f, 0.2f}},
    {"derivatives/parallel_diagonal", {1.0f / 13, 1.0f / 9, 3.0f / 13, 3.0f / 9}},
    {"derivatives/parallel_1e-20", {1e-20f, 1e-20f, 1e-20f, 1e-20f}},
    {"derivatives/parallel_1e19", {1e19f, 1e19f, 1e19f, 1.0000001e19f}},
    {"derivatives/thin_1e3", {0.5f, 0, 0, 5e-4f}},
    {"derivatives/thin_1e10", {1, 1e-10f, 0, 1e-10f}},
    {"derivatives/thin_1e20", {0, 0.7f, 7e-21f, 0}},
    {"derivatives/thin_1e20_slanted", {0.5f, 0.5f, 5e-21f, -5e-21f}},
    {"derivatives/thin_of_48_texels", {48.0f / 13, 0, 0, 1e-9f}},
    {"derivatives/thin_and_huge", {1e20f, 0, 0, 1}},
    {"derivatives/thin_and_tiny", {1e-10f, 0, 0, 1e-30f}},
    {"derivatives/1", {1, 0, 0, 1}},
    {"derivatives/1e3", {1e3f, -1e3f, 1e3f, 1e3f}},
    {"derivatives/1e10", {1e10f, 3e9f, -2e9f, 1e10f}},
    {"derivatives/1e30", {1e30f, 1e30f, -1e30f, 1e30f}},
    {"derivatives/flt_max", {FLT_MAX, FLT_MAX, FLT_MAX, -FLT_MAX}},
    {"derivatives/flt_max_of_one", {0, 0, FLT_MAX, 0}},
    {"derivatives/inf", {INF, 0, 0, 0}},
    {"derivatives/-inf", {0, -INF, 0, 0.1f}},
    {"derivatives/all_inf", {INF, INF, -INF, INF}},
    {"derivatives/nan", {NAN, 0, 0, 0.2f}},
    {"derivatives/nan_of_y", {0.2f, 0.1f, 0, NAN}},
    {"derivatives/all_nan", {NAN, -NAN, NAN, NAN}},
    {"derivatives/inf_and_nan", {INF, NAN, 0, 0}},
};

struct batch {
    shd_lookups lookups;
    float u[COUNT], v[COUNT], j[4][COUNT], lod[COUNT];
};

static void make_batch(struct batch *b, const float j[4])
{
    size_t i, k;
    b->lookups = shd_lookups_default();
    b->lookups.count = COUNT;
    for (i = 0; i < COUNT; ++i) {
        b->u[i] = 0.037f * (float)i - 0.1f;
        b->v[i] = 0.71f - 0.029f * (float)i;
        for (k = 0; k < 4; ++k) b->j[k][i] = j[k];
    }
    b->lookups.u.data = b->u;
    b->lookups.v.data = b->v;
    b->lookups.dudx.data = b->j[0];
    b->lookups.dvdx.data = b->j[1];
    b->lookups.dudy.data = b->j[2];
    b->lookups.dvdy.data = b->j[3];
}

/* Looks the batch up on every target; the bits, which are equal on all, are left in `out`. Returns the number of
 * lookups with input that is not finite. */
static size_t look_up(const char *what, const shd_filter_row *row, const shd_sampler *sampler, const struct batch *b,
                      float out[4][COUNT])
{
    float first[4][COUNT];
    size_t nonfinite = 0, i, c;
    int target;
    for (target = 0; target < g_targets.count; ++target) {
        shd_texels texels = shd_texels_default();
        for (c = 0; c < 4; ++c) texels.channel[c].data = out[c];
        shd_assert_ok(shd_texture_sample(g_targets.texture[target], sampler, &b->lookups, &texels));
        g_tried.lookups += COUNT;
        nonfinite = texels.nonfinite_count;
        if (target == 0) memcpy(first, out, sizeof first);
        if (memcmp(first, out, sizeof first) != 0) {
            fail_msg("%s: other bits on %s", what, shd_context_get_simd_target(g_targets.context[target]));
        }
    }
    for (c = 0; c < 4; ++c) {
        for (i = 0; i < COUNT; ++i) {
            if (out[c][i] >= -row->slack - 1e-5f && out[c][i] <= 1.00001f + row->slack) continue;
            fail_msg("%s: lookup %zu gives %g", what, i, (double)out[c][i]);
        }
    }
    return nonfinite;
}

/* No lookup reads more texels than the filter may. */
static void count_taps(const char *what, int filter, const shd_sampler *sampler, const struct batch *b)
{
    const uint32_t most = k_filters[filter].most_taps;
    size_t i;
    for (i = 0; most && i < COUNT; ++i) {
        shd_explanation explanation = shd_explanation_default();
        shd_assert_ok(shd_texture_explain(g_targets.texture[0], sampler, &b->lookups, i, &explanation));
        ++g_tried.explained;
        if (explanation.tap_count < 1 || explanation.tap_count > most) {
            fail_msg("%s: lookup %zu reads %u texels, not 1..%u", what, i, explanation.tap_count, most);
        }
        if (explanation.tap_count > g_tried.most_taps[filter]) g_tried.most_taps[filter] = explanation.tap_count;
    }
}

static void test_footprint(void **state)
{
    const struct footprint_case *c = (const struct footprint_case *)*state;
    float without_nan[4];
    int has_nan = 0, has_infinity = 0, filter, wrap, k;
    for (k = 0; k < 4; ++k) {
        has_nan |= isnan(c->j[k]);
        has_infinity |= isinf(c->j[k]);
        without_nan[k] = isnan(c->j[k]) ? 0 : c->j[k];
    }
    for (filter = 0; filter < SHD_FILTER_ROWS; ++filter) {
        for (wrap = 0; wrap < SHD_TEST_WRAPS; ++wrap) {
            shd_sampler *sampler = shd_make_sampler(&k_filters[filter], wrap);
            float got[4][COUNT], want[4][COUNT];
            struct batch b;
            char what[80];
            snprintf(what, sizeof what, "%s, %s", k_filters[filter].name, k_wraps[wrap]);
            make_batch(&b, c->j);
            assert_int_equal(look_up(what, &k_filters[filter], sampler, &b, got), has_nan || has_infinity ? COUNT : 0);
            count_taps(what, filter, sampler, &b);
            make_batch(&b, without_nan); /* NaN counts as 0 */
            (void)look_up(what, &k_filters[filter], sampler, &b, want);
            if (memcmp(got, want, sizeof got) != 0) fail_msg("%s: NaN is not 0", what);
            shd_sampler_release(sampler);
        }
    }
}

/* ---- levels of detail ---- */

struct level_case {
    const char *name;
    float lod, like; /* levels of the same lookup */
};
static const struct level_case k_levels[] = {
    {"lod/nan", NAN, 0},
    {"lod/-nan", -NAN, 0},
    {"lod/inf", INF, 32},
    {"lod/-inf", -INF, 0},
    {"lod/1e30", 1e30f, 32},
    {"lod/flt_max", FLT_MAX, 32},
    {"lod/-flt_max", -FLT_MAX, 0},
    {"lod/-1e-45", -1e-45f, 0},
    {"lod/33", 33, 32},
    {"lod/-7", -7, 0},
};

static void test_level(void **state)
{
    static const float k_none[4] = {0, 0, 0, 0};
    const struct level_case *c = (const struct level_case *)*state;
    int filter, wrap;
    size_t i;
    for (filter = 0; filter < SHD_FILTER_ROWS; ++filter) {
        for (wrap = 0; wrap < SHD_TEST_WRAPS; ++wrap) {
            shd_sampler *sampler = shd_make_sampler(&k_filters[filter], wrap);
            float got[4][COUNT], want[4][COUNT];
            struct batch b;
            char what[80];
            snprintf(what, sizeof what, "%s, %s", k_filters[filter].name, k_wraps[wrap]);
            make_batch(&b, k_none);
            b.lookups.lod.data = b.lod;
            for (i = 0; i < COUNT; ++i) b.lod[i] = c->lod;
            assert_int_equal(look_up(what, &k_filters[filter], sampler, &b, got), isfinite(c->lod) ? 0 : COUNT);
            count_taps(what, filter, sampler, &b);
            for (i = 0; i < COUNT; ++i) b.lod[i] = c->like;
            (void)look_up(what, &k_filters[filter], sampler, &b, want);
            /* The square that EXACT averages may be smaller than a texel. */
            if (k_filters[filter].filter == SHD_FILTER_EXACT && c->lod < 0) memcpy(want, got, sizeof want);
            if (memcmp(got, want, sizeof got) != 0) fail_msg("%s: not the level %g", what, (double)c->like);
            shd_sampler_release(sampler);
        }
    }
}

static void test_count(void **state)
{
    int filter;
    (void)state;
    print_message("%zu lookups tried, %zu of them explained; most texels of a lookup at max_anisotropy %d:",
                  g_tried.lookups, g_tried.explained, SHD_TEST_ANISOTROPY);
    for (filter = 0; filter < SHD_FILTER_ROWS; ++filter) {
        if (k_filters[filter].most_taps) print_message(" %s %u", k_filters[filter].name, g_tried.most_taps[filter]);
    }
    print_message("\n");
    assert_true(g_tried.lookups > 100000);
}

int main(void)
{
    ADD_ROWS(k_footprints, test_footprint);
    ADD_ROWS(k_levels, test_level);
    add("count", test_count, NULL);
    return _cmocka_run_group_tests("api.lookup_bad_footprints", g_tests, g_count, shd_open_targets, shd_close_targets);
}
