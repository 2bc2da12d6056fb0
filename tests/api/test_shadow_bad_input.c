/* SPDX-License-Identifier: MIT */
/* Shadows of unusual scenes: empty ones, single points, extreme numbers, lights on surfaces. Every call ends with a
 * documented result, and visibility is a number in 0..1. */
#include <float.h>

#include "support/context.h"
#include "support/shadow_scene.h"

/* A square of the given size and position, with some coordinates replaced by `bad`; position and direction of the
 * light. */
struct scene_case {
    const char *name;
    float size, place[3], bad;
    int bad_count; /* number of replaced coordinates, of 12 */
    float light[3], direction[3], near_plane, far_plane;
    float want; /* behind the square, -1 = any */
};
static const struct scene_case k_scenes[] = {
    {"plain", 1, {0, 0, 0}, 0, 0, {0, 2, 0}, {0, -1, 0}, 0, 0, 0},
    {"far_away", 100, {1e6f, -1e6f, 1e6f}, 0, 0, {1e6f, 100 - 1e6f, 1e6f}, {0, -1, 0}, 0, 0, 0},
    {"tiny", 1e-12f, {0, 0, 0}, 0, 0, {0, 2e-12f, 0}, {0, -1, 0}, 0, 0, 0},
    {"denormal", 1e-42f, {0, 0, 0}, 0, 0, {0, 1e-40f, 0}, {0, -1, 0}, 0, 0, -1},
    {"huge", 1e17f, {0, 0, 0}, 0, 0, {0, 2e17f, 0}, {0, -1, 0}, 0, 0, 0},
    {"a_point", 0, {1, 2, 3}, 0, 0, {0, 9, 0}, {0, -1, 0}, 0, 0, -1},
    {"nan", 1, {0, 0, 0}, NAN, 3, {0, 2, 0}, {0, -1, 0}, 0, 0, -1},
    {"all_nan", 1, {0, 0, 0}, NAN, 12, {0, 2, 0}, {0, -1, 0}, 0, 0, 1},
    {"infinite", 1, {0, 0, 0}, INFINITY, 1, {0, 2, 0}, {0, -1, 0}, 0, 0, -1},
    {"light_on_it", 1, {0, 0, 0}, 0, 0, {0.1f, 0, 0.1f}, {0, -1, 0}, 0, 0, -1},
    {"light_in_its_plane", 1, {0, 0, 0}, 0, 0, {5, 0, 0}, {-1, 0, 0}, 0, 0, -1},
    {"light_looks_away", 1, {0, 0, 0}, 0, 0, {0, 2, 0}, {0, 1, 0}, 0, 0, -1},
    {"light_at_corner", 1, {0, 0, 0}, 0, 0, {1, 0, 1}, {-1, -1, -1}, 0, 0, -1},
    {"grazing", 1, {0, 0, 0}, 0, 0, {3, 1e-6f, 0}, {-1, -1e-6f, 0}, 0, 0, -1},
    {"nearer_than_near", 1, {0, 0, 0}, 0, 0, {0, 2, 0}, {0, -1, 0}, 3, 4, 1},
    {"farther_than_far", 1, {0, 0, 0}, 0, 0, {0, 200, 0}, {0, -1, 0}, 100, 101, 1},
    {"thin_range", 1, {0, 0, 0}, 0, 0, {0, 2, 0}, {0, -1, 0}, 1e-8f, 1e9f, -1},
};

static const float k_wild[] = {0,     -0.0f,   1e-45f,   1e-30f, 1,        -1.5f,     1e6f, 1e17f,
                               1e30f, FLT_MAX, -FLT_MAX, NAN,    INFINITY, -INFINITY, 3,    -2};
enum { k_wild_count = sizeof k_wild / sizeof k_wild[0], k_points = k_wild_count * k_wild_count * k_wild_count };

static void sample_wild(const char *name, int filter, const shd_shadow *shadow)
{
    static float points[6][k_points], out[k_points];
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow_values column = {sizeof column, {out, 0}, 0};
    int i, k;
    for (i = 0; i < k_points; ++i) {
        points[0][i] = k_wild[i % k_wild_count];
        points[1][i] = k_wild[i / k_wild_count % k_wild_count];
        points[2][i] = k_wild[i / k_wild_count / k_wild_count];
        points[3][i] = k_wild[(i * 7 + 3) % k_wild_count];
        points[4][i] = k_wild[(i / 3) % k_wild_count];
        points[5][i] = k_wild[(i / 5 + i) % k_wild_count];
    }
    lookups.count = k_points;
    for (k = 0; k < 3; ++k) {
        lookups.position[k].data = points[k];
        lookups.normal[k].data = points[3 + k];
    }
    shd_assert_ok(shd_shadow_sample(shadow, &lookups, &column));
    for (i = 0; i < k_points; ++i) {
        if (!(out[i] >= 0 && out[i] <= 1)) {
            fail_msg("%s, filter %d, at (%g, %g, %g): %g", name, filter, (double)points[0][i], (double)points[1][i],
                     (double)points[2][i], (double)out[i]);
        }
        for (k = 0; k < 3; ++k) {
            if (!isfinite(points[k][i]) && out[i] != 1.0f) fail_msg("%s: not lit at row %d", name, i);
        }
    }
}

static shd_mesh *make_square(const struct scene_case *c)
{
    static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 3};
    static const float k_corner[12] = {-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1};
    float positions[12];
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    int i, k;
    for (i = 0; i < 12; ++i) positions[i] = i < c->bad_count ? c->bad : c->place[i % 3] + c->size * k_corner[i];
    desc.vertex_count = 4;
    for (k = 0; k < 3; ++k) {
        desc.position[k].data = positions + k;
        desc.position[k].stride = 3 * sizeof(float);
    }
    desc.indices.data = k_indices;
    desc.index_count = 6;
    desc.flags = SHD_MESH_KEEP_NONFINITE;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    return mesh;
}

static void test_scene(void **state)
{
    static const shd_light_kind k_kinds[] = {SHD_LIGHT_KIND_DIRECTIONAL, SHD_LIGHT_KIND_SPOT, SHD_LIGHT_KIND_POINT};
    const struct scene_case *c = (const struct scene_case *)*state;
    shd_mesh *mesh = make_square(c);
    int filter, kind, k;
    for (kind = 0; kind < 3; ++kind) {
        shd_light_desc light_desc = shd_light_desc_default();
        shd_light *light = NULL;
        light_desc.kind = k_kinds[kind];
        memcpy(light_desc.position, c->light, sizeof c->light);
        memcpy(light_desc.direction, c->direction, sizeof c->direction);
        shd_assert_ok(shd_light_create(g_context, &light_desc, &light));
        for (filter = SHD_SHADOW_FILTER_HARD; filter <= SHD_SHADOW_FILTER_PCSS; ++filter) {
            shd_shadow_desc desc = shd_shadow_desc_default();
            shd_shadow_render_desc render = shd_shadow_render_desc_default();
            shd_draw draw = shd_draw_default();
            shd_shadow *shadow = NULL;
            float behind[3];
            desc.size = 64;
            desc.filter = (shd_shadow_filter)filter;
            desc.filter_size = c->size < 1e9f ? 0.1f * c->size : 1e9f;
            desc.light_size = 0.1f * desc.filter_size;
            shd_assert_ok(shd_shadow_create(g_context, &desc, &shadow));
            draw.mesh = mesh;
            render.light = light;
            render.draws = &draw;
            render.draw_count = 1;
            if (k_kinds[kind] != SHD_LIGHT_KIND_DIRECTIONAL || c->far_plane < 1e8f) {
                render.near_plane = c->near_plane;
                render.far_plane = c->far_plane;
            }
            shd_assert_ok(shd_shadow_render(g_context, shadow, &render));
            for (k = 0; k < 3; ++k) behind[k] = c->place[k] + 0.6f * c->size * c->direction[k] + 0.01f * c->size;
            if (c->want >= 0) {
                const float got = shd_shadow_at(shadow, behind, NULL);
                if (!shd_is_close(got, c->want, 1e-3, 0)) {
                    fail_msg("%s, kind %d, filter %d: %g", c->name, kind, filter, (double)got);
                }
            }
            sample_wild(c->name, filter, shadow);
            shd_shadow_release(shadow);
        }
        shd_light_release(light);
    }
    shd_mesh_release(mesh);
}

/* No mesh, no vertices, no instances: every point is lit. */
static void test_nothing(void **state)
{
    static const float k_p[3] = {1, 2, 3};
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    shd_light_desc light_desc = shd_light_desc_default();
    shd_shadow_render_desc render = shd_shadow_render_desc_default();
    shd_draw draw = shd_draw_default();
    shd_mesh *mesh = NULL;
    shd_light *light = NULL;
    int filter, kind;
    (void)state;
    shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &mesh));
    draw.mesh = mesh;
    render.draws = &draw;
    for (kind = 0; kind < 4; ++kind) {
        if (kind == SHD_LIGHT_KIND_AMBIENT) continue;
        light_desc.kind = (shd_light_kind)kind;
        shd_assert_ok(shd_light_create(g_context, &light_desc, &light));
        render.light = light;
        for (filter = SHD_SHADOW_FILTER_HARD; filter <= SHD_SHADOW_FILTER_PCSS; ++filter) {
            shd_shadow_desc desc = shd_shadow_desc_default();
            shd_shadow *shadow = NULL;
            desc.size = 16;
            desc.taps = 15;
            desc.filter = (shd_shadow_filter)filter;
            shd_assert_ok(shd_shadow_create(g_context, &desc, &shadow));
            for (render.draw_count = 0; render.draw_count < 2; ++render.draw_count) {
                shd_assert_ok(shd_shadow_render(g_context, shadow, &render));
                assert_true(shd_shadow_at(shadow, k_p, NULL) == 1.0f);
                sample_wild("nothing", filter, shadow);
            }
            shd_shadow_release(shadow);
        }
        shd_light_release(light);
    }
    shd_mesh_release(mesh);
}

int main(void)
{
    static struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_scenes / sizeof k_scenes[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_scenes[i].name, test_scene, NULL, NULL, (void *)&k_scenes[i]};
    }
    tests[n++] = (struct CMUnitTest){"nothing", test_nothing, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.shadow_bad_input", tests, n, set_up, tear_down);
}
