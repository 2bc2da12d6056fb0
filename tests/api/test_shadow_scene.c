/* SPDX-License-Identifier: MIT */
/* Shadows of boxes against rays: every filter with every kind of light. Points are lit if no box lies between them
 * and the light, else dark. Widths of penumbras; Chebyshev's bound. */
#include "support/context.h"
#include "support/noise.h"
#include "support/shadow_scene.h"

struct box {
    float low[3], high[3];
};

/* A room around the origin: its walls are slabs outside -4..4, with one object on every side. */
static const struct box k_room[] = {{{-4.2f, -4.2f, -4.2f}, {-4, 4.2f, 4.2f}}, {{4, -4.2f, -4.2f}, {4.2f, 4.2f, 4.2f}},
                                    {{-4.2f, -4.2f, -4.2f}, {4.2f, -4, 4.2f}}, {{-4.2f, 4, -4.2f}, {4.2f, 4.2f, 4.2f}},
                                    {{-4.2f, -4.2f, -4.2f}, {4.2f, 4.2f, -4}}, {{-4.2f, -4.2f, 4}, {4.2f, 4.2f, 4.2f}},
                                    {{-2.3f, -0.6f, -0.5f}, {-2, 0.4f, 0.7f}}, {{2, -0.4f, -0.7f}, {2.4f, 0.6f, 0.5f}},
                                    {{-0.5f, -2.2f, -0.6f}, {0.7f, -2, 0.4f}}, {{-0.7f, 2, -0.4f}, {0.5f, 2.3f, 0.6f}},
                                    {{-0.6f, -0.5f, -2.4f}, {0.4f, 0.7f, -2}}, {{-0.4f, -0.7f, 2}, {0.6f, 0.5f, 2.2f}}};
/* A floor, a tower on it and a plate above. */
static const struct box k_yard[] = {
    {{-4, -1, -4}, {4, 0, 4}}, {{-0.5f, -0.5f, -0.7f}, {0.6f, 1.5f, 0.4f}}, {{1.2f, 1.1f, 0.8f}, {2.2f, 1.2f, 2}}};

struct truth_case {
    const char *name;
    shd_light_kind kind;
    float position[3], direction[3], outer_angle;
    const struct box *boxes;
    size_t box_count;
};
#define YARD k_yard, sizeof k_yard / sizeof k_yard[0]
#define ROOM k_room, sizeof k_room / sizeof k_room[0]
static const struct truth_case k_truth[] = {
    {"directional/down", SHD_LIGHT_KIND_DIRECTIONAL, {0, 0, 0}, {0, -1, 0}, 0, YARD},
    {"directional/slanted", SHD_LIGHT_KIND_DIRECTIONAL, {0, 0, 0}, {-0.7f, -1, 0.4f}, 0, YARD},
    {"directional/low", SHD_LIGHT_KIND_DIRECTIONAL, {0, 0, 0}, {1, -0.35f, -0.3f}, 0, YARD},
    {"spot/narrow", SHD_LIGHT_KIND_SPOT, {2, 6, -1}, {-0.25f, -1, 0.2f}, 0.4f, YARD},
    {"spot/wide", SHD_LIGHT_KIND_SPOT, {0.2f, 4, 0.3f}, {0.1f, -1, 0}, 1.05f, YARD},
    {"spot/six_faces", SHD_LIGHT_KIND_SPOT, {0.2f, 3, 0.3f}, {0.1f, -1, 0}, 1.5f, YARD},
    {"point/above", SHD_LIGHT_KIND_POINT, {-1.5f, 3.5f, 1.2f}, {0, -1, 0}, 0, YARD},
    {"point/six_faces", SHD_LIGHT_KIND_POINT, {0, 0, 0}, {0, -1, 0}, 0, ROOM},
    {"point/off_centre", SHD_LIGHT_KIND_POINT, {0.3f, -0.2f, 0.4f}, {0, -1, 0}, 0, ROOM},
};

/* Returns whether a box lies between p and the light; the ray starts slightly off p. */
static int blocks(const struct box *box, const double p[3], const double way[3], double length)
{
    double low = 1e-4, high = length;
    int k;
    for (k = 0; k < 3; ++k) {
        double a = (box->low[k] - p[k]) / way[k], b = (box->high[k] - p[k]) / way[k];
        if (way[k] == 0) {
            if (p[k] <= box->low[k] || p[k] >= box->high[k]) return 0;
            continue;
        }
        if (a > b) {
            const double t = a;
            a = b;
            b = t;
        }
        if (a > low) low = a;
        if (b < high) high = b;
    }
    return low < high;
}

static int is_shadowed(const struct truth_case *c, const double p[3])
{
    double way[3], length = 0;
    size_t i;
    int k;
    for (k = 0; k < 3; ++k) {
        way[k] = c->kind == SHD_LIGHT_KIND_DIRECTIONAL ? -c->direction[k] : c->position[k] - p[k];
        length += way[k] * way[k];
    }
    length = sqrt(length);
    for (k = 0; k < 3; ++k) way[k] /= length;
    for (i = 0; i < c->box_count; ++i) {
        if (blocks(&c->boxes[i], p, way, c->kind == SHD_LIGHT_KIND_DIRECTIONAL ? 100.0 : length)) return 1;
    }
    return 0;
}

/* Returns 0 or 1 if this is the visibility of all points of the surface around p, else -1. */
static int truth_around(const struct truth_case *c, const double p[3], int axis, double margin)
{
    const int shadowed = is_shadowed(c, p);
    int i;
    for (i = 0; i < 16; ++i) {
        double q[3];
        memcpy(q, p, sizeof q);
        q[(axis + 1) % 3] += margin * cos(i * 0.3926990817) * (i % 2 ? 1.0 : 0.5);
        q[(axis + 2) % 3] += margin * sin(i * 0.3926990817) * (i % 2 ? 1.0 : 0.5);
        if (is_shadowed(c, q) != shadowed) return -1;
    }
    return shadowed;
}

static double unit_random(uint32_t *seed)
{
    shd_noise(seed);
    return (*seed >> 8) / 16777216.0;
}

static int is_inside(const struct truth_case *c, const double p[3])
{
    size_t i;
    int k;
    for (i = 0; i < c->box_count; ++i) {
        for (k = 0; k < 3 && p[k] > c->boxes[i].low[k] && p[k] < c->boxes[i].high[k]; ++k) {
        }
        if (k == 3) return 1;
    }
    return 0;
}

struct tally {
    int lit, shadowed;
};

/* Checks random points on the faces towards the light that no other box covers. */
static struct tally check_points(const struct truth_case *c, const shd_shadow_desc *desc, const shd_shadow *shadow,
                                 double margin, double tolerance)
{
    struct tally tally = {0, 0};
    uint32_t seed = 5;
    int i, k;
    for (i = 0; i < 60000; ++i) {
        const struct box *box = &c->boxes[(size_t)i % c->box_count];
        const int axis = i / 7 % 3, side = i / 21 % 2;
        double p[3], way[3], axial = 0, squared = 0, length = 0, distance = 0;
        float q[3], n[3] = {0, 0, 0}, got;
        int want;
        for (k = 0; k < 3; ++k) p[k] = box->low[k] + (box->high[k] - box->low[k]) * unit_random(&seed);
        p[axis] = side ? box->high[axis] : box->low[axis];
        n[axis] = side ? 1.0f : -1.0f;
        for (k = 0; k < 3; ++k) {
            way[k] = c->kind == SHD_LIGHT_KIND_DIRECTIONAL ? -c->direction[k] : c->position[k] - p[k];
            distance += way[k] * way[k];
            axial -= (c->position[k] - p[k]) * c->direction[k];
            squared += (c->position[k] - p[k]) * (c->position[k] - p[k]);
            length += c->direction[k] * c->direction[k];
        }
        if (way[axis] * n[axis] < 0.15 * sqrt(distance)) continue; /* steep: biases are large */
        if (c->kind == SHD_LIGHT_KIND_SPOT && axial < cos(0.95 * c->outer_angle) * sqrt(squared * length)) continue;
        /* Skips points near corners, because another face is close there. */
        for (k = 0; k < 3; ++k) {
            if (k != axis && (p[k] - box->low[k] < margin || box->high[k] - p[k] < margin)) break;
        }
        if (k < 3) continue;
        if (is_inside(c, p)) continue;
        want = truth_around(c, p, axis, margin);
        if (want < 0) continue;
        for (k = 0; k < 3; ++k) q[k] = (float)p[k];
        got = shd_shadow_at(shadow, q, n);
        if (!shd_is_close(got, want ? 0.0 : 1.0, want ? tolerance : 1e-3, 0)) {
            fail_msg("%s, filter %d: %s at (%g, %g, %g), axis %d, is %g", c->name, (int)desc->filter,
                     want ? "shadow" : "light", p[0], p[1], p[2], axis, (double)got);
        }
        *(want ? &tally.shadowed : &tally.lit) += 1;
    }
    return tally;
}

static void test_truth(void **state)
{
    const struct truth_case *c = (const struct truth_case *)*state;
    struct shd_boxes boxes;
    shd_light_desc light_desc = shd_light_desc_default();
    shd_light *light = NULL;
    int filter;
    size_t i;
    shd_boxes_open(&boxes, g_context);
    for (i = 0; i < c->box_count; ++i) shd_boxes_add(&boxes, c->boxes[i].low, c->boxes[i].high);
    light_desc.kind = c->kind;
    memcpy(light_desc.position, c->position, sizeof c->position);
    memcpy(light_desc.direction, c->direction, sizeof c->direction);
    if (c->kind == SHD_LIGHT_KIND_SPOT) light_desc.outer_angle = c->outer_angle;
    shd_assert_ok(shd_light_create(g_context, &light_desc, &light));
    for (filter = SHD_SHADOW_FILTER_HARD; filter <= SHD_SHADOW_FILTER_PCSS; ++filter) {
        const int is_variance =
            filter == SHD_SHADOW_FILTER_VARIANCE || filter == SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE;
        shd_shadow_desc desc = shd_shadow_desc_default();
        shd_shadow *shadow;
        struct tally tally;
        desc.size = 700;
        desc.filter = (shd_shadow_filter)filter;
        desc.filter_size = 0.05f;
        desc.light_size = 0.02f;
        desc.bleed = is_variance ? 0.2f : 0.0f;
        shadow = shd_boxes_shadow(&boxes, g_context, &desc, light);
        tally = check_points(c, &desc, shadow, 0.1, is_variance ? 0.05 : 1e-3);
        if (tally.lit < 100 || tally.shadowed < 25) {
            fail_msg("%s: %d points lit, %d in shadow", c->name, tally.lit, tally.shadowed);
        }
        shd_shadow_release(shadow);
    }
    shd_light_release(light);
    shd_boxes_close(&boxes);
}

/* A plate with an edge at x = 0, `height` above a floor at y = 0, under light from straight above, or a point there. */
struct edge {
    struct shd_boxes boxes;
    shd_light *light;
};

static void open_edge(struct edge *edge, float height, float light_height)
{
    const float floor_low[3] = {-4, -0.5f, -4}, floor_high[3] = {4, 0, 4};
    const float low[3] = {-4, height, -4}, high[3] = {0, height + 0.01f, 4};
    shd_light_desc desc = shd_light_desc_default();
    shd_boxes_open(&edge->boxes, g_context);
    shd_boxes_add(&edge->boxes, floor_low, floor_high);
    shd_boxes_add(&edge->boxes, low, high);
    desc.kind = light_height > 0 ? SHD_LIGHT_KIND_POINT : SHD_LIGHT_KIND_DIRECTIONAL;
    desc.position[1] = light_height;
    shd_assert_ok(shd_light_create(g_context, &desc, &edge->light));
}
static void close_edge(struct edge *edge)
{
    shd_light_release(edge->light);
    shd_boxes_close(&edge->boxes);
}

/* The x at which visibility along the floor reaches a value. */
static double crossing(const shd_shadow *shadow, double value)
{
    static const float k_up[3] = {0, 1, 0};
    double x;
    for (x = -2; x < 2; x += 0.002) {
        const float p[3] = {(float)x, 0, 0.1f};
        if (shd_shadow_at(shadow, p, k_up) >= value) return x;
    }
    fail_msg("visibility stays below %g", value);
    return 0;
}

/* The penumbra of a square light of width L has the width L (z - b) / b; visibility goes from 0.2 to 0.8 in 0.6 of
 * it. */
static void test_penumbra(void **state)
{
    static const struct {
        float height, light_height, light_size;
    } k_cases[] = {{0.25f, 0, 0.4f}, {0.5f, 0, 0.4f}, {1, 0, 0.4f}, {0.5f, 4, 0.8f}, {1, 4, 0.8f}, {1.5f, 4, 0.8f}};
    size_t i;
    double last = 0;
    (void)state;
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        const double h = k_cases[i].height, above = k_cases[i].light_height;
        const double want = k_cases[i].light_size * (above > 0 ? h / (above - h) : h);
        shd_shadow_desc desc = shd_shadow_desc_default();
        struct edge edge;
        shd_shadow *shadow;
        double got;
        open_edge(&edge, k_cases[i].height, k_cases[i].light_height);
        desc.filter = SHD_SHADOW_FILTER_PCSS;
        desc.taps = 15;
        desc.light_size = k_cases[i].light_size;
        shadow = shd_boxes_shadow(&edge.boxes, g_context, &desc, edge.light);
        got = (crossing(shadow, 0.8) - crossing(shadow, 0.2)) / 0.6;
        if (!shd_is_close(got, want, 0.02, 0.12)) fail_msg("case %zu: %g wide, not %g", i, got, want);
        if (i % 3 != 0) assert_true(got > last);
        last = got;
        shd_shadow_release(shadow);
        close_edge(&edge);
    }
}

/* For two depths, of which a fraction f is the receiver's, Chebyshev's bound is f (Donnelly and Lauritzen 2006,
 * 3.1). PCF with the same number of taps gives the same value. */
static void test_chebyshev(void **state)
{
    static const float k_up[3] = {0, 1, 0};
    struct edge edge;
    uint32_t taps;
    (void)state;
    open_edge(&edge, 1.0f, 0);
    for (taps = 1; taps <= 15; taps += 2) {
        shd_shadow_desc desc = shd_shadow_desc_default();
        shd_shadow *pcf, *variance;
        int i, partial = 0;
        desc.size = 256;
        desc.taps = taps;
        desc.bias_slope = 0;
        desc.filter = SHD_SHADOW_FILTER_PCF;
        pcf = shd_boxes_shadow(&edge.boxes, g_context, &desc, edge.light);
        desc.filter = SHD_SHADOW_FILTER_VARIANCE;
        variance = shd_boxes_shadow(&edge.boxes, g_context, &desc, edge.light);
        for (i = 0; i < 400; ++i) {
            const float p[3] = {-0.4f + 0.002f * (float)i, 0, 0.3f};
            const double want = shd_shadow_at(pcf, p, k_up);
            shd_assert_close("variance", (size_t)i, shd_shadow_at(variance, p, k_up), want, 2e-3, 0);
            partial += want > 0 && want < 1;
        }
        assert_true(partial > 5);
        shd_shadow_release(pcf);
        shd_shadow_release(variance);
    }
    close_edge(&edge);
}

int main(void)
{
    static struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_truth / sizeof k_truth[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_truth[i].name, test_truth, NULL, NULL, (void *)&k_truth[i]};
    }
    tests[n++] = (struct CMUnitTest){"penumbra", test_penumbra, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"chebyshev", test_chebyshev, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.shadow_scene", tests, n, set_up, tear_down);
}
