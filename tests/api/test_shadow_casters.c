/* SPDX-License-Identifier: MIT */
/* Draws that cast shadows, and maps that do not change while their bounds move. */
#include "support/context.h"
#include "support/noise.h"
#include "support/shadow_scene.h"

static double unit_random(uint32_t *seed)
{
    shd_noise(seed);
    return (*seed >> 8) / 16777216.0;
}

/* Shadows do not change when bounds move by parts of a texel: the same points have the same visibility. */
static void test_steady(void **state)
{
    static const float k_low[2][3] = {{-4, -1, -4}, {-0.5f, 0.2f, -0.7f}};
    static const float k_high[2][3] = {{4, 0, 4}, {0.6f, 1.5f, 0.4f}};
    enum { k_points = 4000 };
    static float first[k_points];
    struct shd_boxes boxes;
    shd_light_desc light_desc = shd_light_desc_default();
    shd_light *light = NULL;
    int step, i, k, changed = 0, shadowed = 0;
    (void)state;
    shd_boxes_open(&boxes, g_context);
    for (i = 0; i < 2; ++i) shd_boxes_add(&boxes, k_low[i], k_high[i]);
    light_desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    light_desc.direction[0] = -0.7f;
    light_desc.direction[2] = 0.4f;
    shd_assert_ok(shd_light_create(g_context, &light_desc, &light));
    for (step = 0; step < 6; ++step) {
        shd_shadow_render_desc render = shd_shadow_render_desc_default();
        shd_shadow *shadow = NULL;
        uint32_t seed = 9;
        shd_assert_ok(shd_shadow_create(g_context, NULL, &shadow));
        render.light = light;
        render.draws = boxes.draws;
        render.draw_count = boxes.count;
        for (k = 0; k < 3; ++k) {
            const float shift = 0.0137f * (float)(step * (k + 1));
            render.bounds_min[k] = -2.0f + shift;
            render.bounds_max[k] = 2.0f + shift;
        }
        shd_assert_ok(shd_shadow_render(g_context, shadow, &render));
        for (i = 0; i < k_points; ++i) {
            const float p[3] = {(float)(3 * unit_random(&seed) - 1.5), 0, (float)(3 * unit_random(&seed) - 1.5)};
            const float got = shd_shadow_at(shadow, p, NULL);
            if (step == 0) first[i] = got;
            shadowed += got == 0.0f;
            changed += got != first[i];
        }
        shd_shadow_release(shadow);
    }
    if (shadowed < k_points / 2 || changed > 0) fail_msg("%d in shadow, %d changed", shadowed, changed);
    shd_light_release(light);
    shd_boxes_close(&boxes);
}

/* Effect of flags, instances, alpha and culled faces on shadows, at points below, in and beside a box. */
static void test_casters(void **state)
{
    static const float k_low[3] = {-1, 1, -1}, k_high[3] = {1, 2, 1};
    static const float k_under[3] = {0.2f, 0, 0.1f}, k_in[3] = {0.2f, 1.5f, 0.1f}, k_beside[3] = {5.1f, 0, 0.2f};
    static const float k_places[32] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1.5f, 0, 1,
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 1.5f, 0, 1};
    static const struct {
        const char *name;
        shd_cull cull;
        uint32_t flags;
        float opacity, alpha_cutoff; /* opacity 0: no material */
        int has_instances;
        float under, in, beside;
    } k_cases[] = {
        {"plain", SHD_CULL_NONE, 0, 0, 0, 0, 0, 0, 1},
        {"back", SHD_CULL_BACK, 0, 0, 0, 0, 0, 0, 1},
        {"front", SHD_CULL_FRONT, 0, 0, 0, 0, 0, 1, 1},
        {"keep_depth", SHD_CULL_NONE, SHD_DRAW_KEEP_DEPTH, 0, 0, 0, 1, 1, 1},
        {"instances", SHD_CULL_NONE, 0, 0, 0, 1, 0, 0, 0},
        {"opacity", SHD_CULL_NONE, 0, 0.3f, 0, 0, 0, 0, 1},
        {"cut_off", SHD_CULL_NONE, 0, 0.3f, 0.5f, 0, 1, 1, 1},
        {"not_cut_off", SHD_CULL_NONE, 0, 0.8f, 0.5f, 0, 0, 0, 1},
    };
    shd_light_desc light_desc = shd_light_desc_default();
    shd_light *light = NULL;
    size_t i;
    (void)state;
    light_desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    shd_assert_ok(shd_light_create(g_context, &light_desc, &light));
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        shd_shadow_desc desc = shd_shadow_desc_default();
        shd_material_desc material_desc = shd_material_desc_default();
        shd_material *material = NULL;
        struct shd_boxes boxes;
        shd_shadow *shadow;
        shd_boxes_open(&boxes, g_context);
        shd_boxes_add(&boxes, k_low, k_high);
        desc.caster_cull = k_cases[i].cull;
        boxes.draws[0].flags = k_cases[i].flags;
        boxes.draws[0].cull = SHD_CULL_BACK;        /* has no effect */
        boxes.draws[0].compare = SHD_COMPARE_NEVER; /* has no effect, too */
        if (k_cases[i].has_instances) {
            boxes.draws[0].instances = k_places;
            boxes.draws[0].instance_count = 2;
        }
        if (k_cases[i].opacity > 0) {
            material_desc.opacity = k_cases[i].opacity;
            material_desc.alpha_cutoff = k_cases[i].alpha_cutoff;
            material_desc.blend = k_cases[i].alpha_cutoff > 0 ? SHD_BLEND_OPAQUE : SHD_BLEND_STRAIGHT;
            shd_assert_ok(shd_material_create(g_context, &material_desc, &material));
            boxes.draws[0].material = material;
        }
        shadow = shd_boxes_shadow(&boxes, g_context, &desc, light);
        shd_assert_close(k_cases[i].name, 0, shd_shadow_at(shadow, k_under, NULL), k_cases[i].under, 0, 0);
        shd_assert_close(k_cases[i].name, 1, shd_shadow_at(shadow, k_in, NULL), k_cases[i].in, 0, 0);
        shd_assert_close(k_cases[i].name, 2, shd_shadow_at(shadow, k_beside, NULL), k_cases[i].beside, 0, 0);
        shd_shadow_release(shadow);
        shd_material_release(material);
        shd_boxes_close(&boxes);
    }
    shd_light_release(light);
}

int main(void)
{
    static const struct CMUnitTest k_tests[] = {
        {"steady", test_steady, NULL, NULL, NULL},
        {"casters", test_casters, NULL, NULL, NULL},
    };
    return _cmocka_run_group_tests("api.shadow_casters", k_tests, sizeof k_tests / sizeof k_tests[0], set_up,
                                   tear_down);
}
