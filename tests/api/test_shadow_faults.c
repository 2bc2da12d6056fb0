/* SPDX-License-Identifier: MIT */
/* Every allocation of rendering and looking up a shadow fails in turn, alone and with all later ones: the previous
 * map keeps its bits, the next call works, and nothing leaks. */
#include "support/fault_allocator.h"
#include "support/shadow_scene.h"

enum { k_points = 200 };

struct fault_case {
    const char *name;
    shd_shadow_filter filter;
    shd_light_kind kind;
    int persistent;
};
static const struct fault_case k_faults[] = {
    {"hard/directional/transient", SHD_SHADOW_FILTER_HARD, SHD_LIGHT_KIND_DIRECTIONAL, 0},
    {"pcf/point/persistent", SHD_SHADOW_FILTER_PCF, SHD_LIGHT_KIND_POINT, 1},
    {"variance/spot/transient", SHD_SHADOW_FILTER_VARIANCE, SHD_LIGHT_KIND_SPOT, 0},
    {"variance/spot/persistent", SHD_SHADOW_FILTER_VARIANCE, SHD_LIGHT_KIND_SPOT, 1},
    {"summed_area/point/transient", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, SHD_LIGHT_KIND_POINT, 0},
    {"summed_area/directional/persistent", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, SHD_LIGHT_KIND_DIRECTIONAL, 1},
};

static void sample(const shd_shadow *shadow, float out[k_points])
{
    static float points[3][k_points];
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow_values column = {sizeof column, {out, 0}, 0};
    int i, k;
    lookups.count = k_points;
    for (k = 0; k < 3; ++k) {
        for (i = 0; i < k_points; ++i) points[k][i] = (float)((i * (7 + 4 * k)) % 53) / 13.0f - 2.0f;
        lookups.position[k].data = points[k];
    }
    shd_assert_ok(shd_shadow_sample(shadow, &lookups, &column));
}

static void test_faults(void **state)
{
    static const float k_low[3] = {-1, -1, -1}, k_high[3] = {1, 0, 1}, k_low2[3] = {0, 1, -2},
                       k_high2[3] = {2, 1.3f, 2};
    const struct fault_case *c = (const struct fault_case *)*state;
    shd_fault_allocator memory;
    shd_context_desc context_desc = shd_fault_context_desc(&memory);
    shd_light_desc light_desc = shd_light_desc_default();
    shd_shadow_desc desc = shd_shadow_desc_default();
    shd_shadow_render_desc render = shd_shadow_render_desc_default();
    shd_context *context = NULL;
    shd_light *light = NULL;
    shd_shadow *shadow = NULL;
    struct shd_boxes boxes;
    float want[k_points], other[k_points], got[k_points];
    size_t n;
    memset(&memory, 0, sizeof memory);
    shd_assert_ok(shd_context_create(&context_desc, &context));
    shd_boxes_open(&boxes, context);
    shd_boxes_add(&boxes, k_low, k_high);
    shd_boxes_add(&boxes, k_low2, k_high2);
    light_desc.kind = c->kind;
    light_desc.position[1] = 3;
    shd_assert_ok(shd_light_create(context, &light_desc, &light));
    desc.size = 64;
    desc.filter = c->filter;
    desc.filter_size = 0.2f;
    render.light = light;
    render.draws = boxes.draws;
    shd_assert_ok(shd_shadow_create(context, &desc, &shadow));
    render.draw_count = 2;
    shd_assert_ok(shd_shadow_render(context, shadow, &render));
    sample(shadow, other);
    render.draw_count = 1;
    shd_assert_ok(shd_shadow_render(context, shadow, &render));
    sample(shadow, want);
    assert_true(memcmp(want, other, sizeof want) != 0);
    render.draw_count = 2;
    for (n = 1;; ++n) {
        shd_result result;
        shd_fault_arm(&memory, n, c->persistent);
        result = shd_shadow_render(context, shadow, &render);
        if (result == SHD_OK) break;
        shd_assert_result(c->name, result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        shd_fault_arm(&memory, 0, 0);
        sample(shadow, got);
        if (memcmp(got, want, sizeof want)) fail_msg("%s: allocation %zu changed the map", c->name, n);
    }
    shd_fault_arm(&memory, 0, 0);
    assert_true(n > 10);
    sample(shadow, got);
    assert_memory_equal(got, other, sizeof other);
    shd_shadow_release(shadow);
    shd_light_release(light);
    shd_boxes_close(&boxes);
    shd_context_release(context);
    shd_assert_all_freed(c->name, &memory);
}

int main(void)
{
    static struct CMUnitTest tests[8];
    size_t n;
    for (n = 0; n < sizeof k_faults / sizeof k_faults[0]; ++n) {
        tests[n] = (struct CMUnitTest){k_faults[n].name, test_faults, NULL, NULL, (void *)&k_faults[n]};
    }
    return _cmocka_run_group_tests("api.shadow_faults", tests, n, NULL, NULL);
}
