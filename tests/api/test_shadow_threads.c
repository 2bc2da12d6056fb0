/* SPDX-License-Identifier: MIT */
/* Many threads in one context: all look up one shadow, and each renders and looks up its own shadow. Results have
 * the bits of one thread. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>

#include "support/shadow_scene.h"

enum { k_threads = 6, k_rounds = 6, k_points = 3000 };

static struct {
    shd_context *context;
    shd_light *light;
    shd_shadow *shared;
    struct shd_boxes boxes;
    uint64_t want;
} g;

static uint64_t hash_of(const shd_shadow *shadow)
{
    float points[3][k_points], out[k_points];
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow_values column = {sizeof column, {out, 0}, 0};
    int i, k;
    lookups.count = k_points;
    for (k = 0; k < 3; ++k) {
        for (i = 0; i < k_points; ++i) points[k][i] = (float)((i * (17 + 6 * k)) % 97) / 24.0f - 2.0f;
        lookups.position[k].data = points[k];
    }
    if (shd_shadow_sample(shadow, &lookups, &column) != SHD_OK) return 0;
    return shd_hash(SHD_HASH_START, out, sizeof out);
}

static shd_shadow_desc shadow_desc(void)
{
    shd_shadow_desc desc = shd_shadow_desc_default();
    desc.size = 100;
    desc.filter = SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE;
    desc.filter_size = 0.1f;
    return desc;
}

/* A failed assertion on another thread would end the process, so threads count mistakes instead. */
static void *act(void *argument)
{
    int *mistakes = (int *)argument, round;
    for (round = 0; round < k_rounds; ++round) {
        const shd_shadow_desc desc = shadow_desc();
        shd_shadow_render_desc render = shd_shadow_render_desc_default();
        shd_shadow *mine = NULL;
        *mistakes += hash_of(g.shared) != g.want;
        render.light = g.light;
        render.draws = g.boxes.draws;
        render.draw_count = g.boxes.count;
        *mistakes += shd_shadow_create(g.context, &desc, &mine) != SHD_OK;
        *mistakes += shd_shadow_render(g.context, mine, &render) != SHD_OK;
        *mistakes += hash_of(mine) != g.want;
        shd_shadow_retain(g.shared);
        shd_shadow_release(mine);
        shd_shadow_release(g.shared);
    }
    return NULL;
}

static void test_threads(void **state)
{
    static const float k_low[3] = {-1, -1, -1}, k_high[3] = {1, 0.5f, 0.7f};
    const shd_shadow_desc desc = shadow_desc();
    shd_context_desc context_desc = shd_context_desc_default();
    shd_light_desc light_desc = shd_light_desc_default();
    pthread_t thread[k_threads];
    int mistakes[k_threads] = {0}, i;
    (void)state;
#if defined(__SANITIZE_THREAD__)
    context_desc.worker_count = 1; /* oneTBB is not instrumented */
#else
    context_desc.worker_count = 3;
#endif
    shd_assert_ok(shd_context_create(&context_desc, &g.context));
    shd_boxes_open(&g.boxes, g.context);
    shd_boxes_add(&g.boxes, k_low, k_high);
    light_desc.position[1] = 3;
    shd_assert_ok(shd_light_create(g.context, &light_desc, &g.light));
    g.shared = shd_boxes_shadow(&g.boxes, g.context, &desc, g.light);
    g.want = hash_of(g.shared);
    for (i = 0; i < k_threads; ++i) assert_int_equal(pthread_create(&thread[i], NULL, act, &mistakes[i]), 0);
    for (i = 0; i < k_threads; ++i) pthread_join(thread[i], NULL);
    for (i = 0; i < k_threads; ++i) assert_int_equal(mistakes[i], 0);
    shd_shadow_release(g.shared);
    shd_light_release(g.light);
    shd_boxes_close(&g.boxes);
    shd_context_release(g.context);
}

int main(void)
{
    static const struct CMUnitTest k_tests[] = {{"threads", test_threads, NULL, NULL, NULL}};
    return _cmocka_run_group_tests("api.shadow_threads", k_tests, 1, NULL, NULL);
}
