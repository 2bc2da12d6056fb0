/* SPDX-License-Identifier: MIT */
/* Coordinates that are not finite, huge, at the ends of the texture, or negative: every filter and wrap on every SIMD
 * target. Values stay within the range of the texels, and the lookups beside a bad one keep their bits. */
#include "support/filters.h"
#include "support/rows.h"

enum { LANES = 35 };

static size_t g_lookups; /* number of lookups of all cases */

/* Looks up `count` points with a footprint of `step` along u; the results are [4][LANES]. */
static size_t look_up(int target, const shd_sampler *sampler, const float *u, const float *v, float step, size_t count,
                      float out[4][LANES])
{
    static float steps[LANES];
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    size_t i, c;
    for (i = 0; i < LANES; ++i) steps[i] = step;
    lookups.count = count;
    lookups.u.data = u;
    lookups.v.data = v;
    lookups.dudx.data = lookups.dvdy.data = steps;
    for (c = 0; c < 4; ++c) texels.channel[c].data = out[c];
    shd_assert_ok(shd_texture_sample(g_targets.texture[target], sampler, &lookups, &texels));
    g_lookups += count;
    return texels.nonfinite_count;
}

/* ---- not finite ---- */

struct nonfinite_case {
    const char *name;
    int axis; /* 0 u, 1 v, 2 both */
    float bad;
};
static const struct nonfinite_case k_nonfinite[] = {
    {"u/nan", 0, NAN},       {"u/-nan", 0, -NAN},          {"u/inf", 0, INFINITY}, {"u/-inf", 0, -INFINITY},
    {"v/nan", 1, NAN},       {"v/-nan", 1, -NAN},          {"v/inf", 1, INFINITY}, {"v/-inf", 1, -INFINITY},
    {"u_and_v/nan", 2, NAN}, {"u_and_v/inf", 2, INFINITY},
};

static void set_column(float *column, float first)
{
    size_t i;
    for (i = 0; i < LANES; ++i) column[i] = first + 0.03f * (float)i;
}

/* The bad coordinate in each lane counts as 0; the other lanes do not change. */
static void check_lanes(const struct nonfinite_case *c, const char *what, int target, const shd_sampler *sampler)
{
    float u[LANES], v[LANES], plain[4][LANES], zero[4][LANES], got[4][LANES];
    size_t lane, i, k;
    set_column(u, -0.5f);
    set_column(v, 0.2f);
    assert_int_equal(look_up(target, sampler, u, v, 0.05f, LANES, plain), 0);
    for (i = 0; i < LANES; ++i) {
        if (c->axis != 1) u[i] = 0;
        if (c->axis != 0) v[i] = 0;
    }
    assert_int_equal(look_up(target, sampler, u, v, 0.05f, LANES, zero), 0);
    for (lane = 0; lane < LANES; ++lane) {
        set_column(u, -0.5f);
        set_column(v, 0.2f);
        if (c->axis != 1) u[lane] = c->bad;
        if (c->axis != 0) v[lane] = c->bad;
        assert_int_equal(look_up(target, sampler, u, v, 0.05f, LANES, got), 1);
        for (k = 0; k < 4; ++k) {
            for (i = 0; i < LANES; ++i) {
                if (memcmp(&got[k][i], i == lane ? &zero[k][i] : &plain[k][i], sizeof(float)) == 0) continue;
                fail_msg("%s: lane %zu is bad, lane %zu gives %g", what, lane, i, (double)got[k][i]);
            }
        }
    }
}

static void test_nonfinite(void **state)
{
    const struct nonfinite_case *c = (const struct nonfinite_case *)*state;
    int filter, wrap, target;
    for (filter = 0; filter < SHD_FILTER_ROWS; ++filter) {
        for (wrap = 0; wrap < SHD_TEST_WRAPS; ++wrap) {
            shd_sampler *sampler = shd_make_sampler(&k_filters[filter], wrap);
            for (target = 0; target < g_targets.count; ++target) {
                char what[80];
                snprintf(what, sizeof what, "%s, %s, %s", k_filters[filter].name, k_wraps[wrap],
                         shd_context_get_simd_target(g_targets.context[target]));
                check_lanes(c, what, target, sampler);
            }
            shd_sampler_release(sampler);
        }
    }
}

/* ---- finite ---- */

/* `like` is a coordinate of the same texels for each wrap; NAN = another point, whose values are only in range. Whole
 * numbers are the outer corner of the texture, which repeat and mirror find exactly. */
struct position_case {
    const char *name;
    float at, like[SHD_TEST_WRAPS];
};
static const struct position_case k_positions[] = {
    {"position/0", 0, {0, 0, 0, 0, 0}},
    {"position/-0", -0.0f, {0, 0, 0, 0, 0}},
    {"position/1", 1, {0, NAN, -1, NAN, NAN}},
    {"position/-1", -1, {0, -2, 1, NAN, NAN}},
    {"position/2", 2, {0, 5, 0, 9, 5}},
    {"position/7", 7, {0, 5, 1, 9, 5}},
    {"position/-12", -12, {0, -5, 0, 9, 5}},
    {"position/1_minus_an_ulp", 0.99999994f, {NAN, NAN, NAN, NAN, NAN}},
    {"position/1_plus_an_ulp", 1.0000001f, {NAN, NAN, NAN, NAN, NAN}},
    {"position/-1e-45", -1e-45f, {NAN, 0, NAN, NAN, NAN}},
    {"position/-1e-30", -1e-30f, {NAN, 0, NAN, NAN, NAN}},
    {"position/-1e-8", -1e-8f, {NAN, 0, NAN, NAN, NAN}},
    {"position/-0.25", -0.25f, {0.75f, -2, 0.25f, NAN, NAN}},
    {"position/-6.5", -6.5f, {0.5f, -2, 0.5f, 9, 5}},
    {"position/8388607.5", 8388607.5f, {0.5f, 5, 0.5f, 9, 5}},
    {"position/-8388607.5", -8388607.5f, {0.5f, -5, 0.5f, 9, 5}},
    {"position/2^23", 8388608.0f, {0, 5, 0, 9, 5}},
    {"position/2^24+2", 16777218.0f, {0, 5, 0, 9, 5}},
    {"position/2^31", 2147483648.0f, {0, 5, 0, 9, 5}},
    {"position/-2^31", -2147483648.0f, {0, -5, 0, 9, 5}},
    {"position/2^63", 9223372036854775808.0f, {0, 5, 0, 9, 5}},
    {"position/1e30", 1e30f, {0, 5, 0, 9, 5}},
    {"position/flt_max", 3.40282347e38f, {0, 5, 0, 9, 5}},
    {"position/-flt_max", -3.40282347e38f, {0, -5, 0, 9, 5}},
};

static void check_position(const struct position_case *c, const shd_filter_row *row, int wrap,
                           const shd_sampler *sampler, int axis)
{
    float column[2][LANES], first[4][LANES], out[4][LANES];
    int target, twin;
    size_t i, k;
    for (target = 0; target < g_targets.count; ++target) {
        for (twin = 0; twin < (isnan(c->like[wrap]) ? 1 : 2); ++twin) {
            for (i = 0; i < LANES; ++i) {
                column[axis][i] = twin ? c->like[wrap] : c->at;
                column[!axis][i] = 0.03f * (float)i;
            }
            assert_int_equal(look_up(target, sampler, column[0], column[1], 0.02f, LANES, out), 0);
            if (target == 0 && twin == 0) memcpy(first, out, sizeof first);
            /* A random texel depends on the bits of the coordinates. */
            if (twin == 1 && row->filter == SHD_FILTER_STOCHASTIC) continue;
            for (k = 0; k < 4; ++k) {
                for (i = 0; i < LANES; ++i) {
                    const float got = out[k][i];
                    const int is_twin = twin == 0 || shd_is_close((double)got, (double)first[k][i], 1e-5, 0);
                    if (got >= -row->slack && got <= 1.0f + row->slack && is_twin) continue;
                    fail_msg("%s, %s, axis %d, %s: %g, not %g", row->name, k_wraps[wrap], axis,
                             shd_context_get_simd_target(g_targets.context[target]), (double)got, (double)first[k][i]);
                }
            }
        }
    }
}

static void test_position(void **state)
{
    const struct position_case *c = (const struct position_case *)*state;
    int filter, wrap;
    for (filter = 0; filter < SHD_FILTER_ROWS; ++filter) {
        for (wrap = 0; wrap < SHD_TEST_WRAPS; ++wrap) {
            shd_sampler *sampler = shd_make_sampler(&k_filters[filter], wrap);
            check_position(c, &k_filters[filter], wrap, sampler, 0);
            check_position(c, &k_filters[filter], wrap, sampler, 1);
            shd_sampler_release(sampler);
        }
    }
}

static void test_count(void **state)
{
    (void)state;
    print_message("%zu lookups tried\n", g_lookups);
    assert_true(g_lookups > 100000);
}

int main(void)
{
    ADD_ROWS(k_nonfinite, test_nonfinite);
    ADD_ROWS(k_positions, test_position);
    add("count", test_count, NULL);
    return _cmocka_run_group_tests("api.lookup_bad_coordinates", g_tests, g_count, shd_open_targets, shd_close_targets);
}
