/* SPDX-License-Identifier: MIT */
/* Progress increases to 1, and calls are never concurrent; the end of a frame at any point by any result but SHD_OK,
 * and the render after it. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>

#include "support/pool.h"
#include "support/scene.h"

struct watcher {
    pthread_mutex_t inside;
    int reports, mistakes, cancel_at; /* 0 = never */
    shd_result result;                /* result of call number cancel_at */
    float latest;
};

static shd_result report(float fraction, void *user_data)
{
    struct watcher *w = (struct watcher *)user_data;
    const int alone = pthread_mutex_trylock(&w->inside) == 0;
    w->mistakes += !alone || !(fraction > w->latest) || !(fraction <= 1.0f);
    w->latest = fraction;
    ++w->reports;
    if (alone) pthread_mutex_unlock(&w->inside);
    return w->reports == w->cancel_at ? w->result : SHD_OK;
}

struct worker_case {
    const char *name;
    uint32_t workers;
    int use_pool;
};
static const struct worker_case k_cases[] = {
    {"one_worker", 1, 0}, {"built_in", 0, 0}, {"host_of_4", 4, 1}, {"host_of_1", 1, 1}};

static void start(struct watcher *w, int cancel_at)
{
    static const shd_result k_results[] = {SHD_ERROR_CANCELLED, SHD_ERROR_INVALID_ARGUMENT, SHD_ERROR_INTERNAL,
                                           SHD_RESULT_MAX_ENUM, (shd_result)11};
    w->result = k_results[cancel_at % 5];
    w->reports = w->mistakes = 0;
    w->latest = 0.0f;
    w->cancel_at = cancel_at;
}

static void test_progress(void **state)
{
    const struct worker_case *c = (const struct worker_case *)*state;
    const uint64_t want = shd_scene_reference(SHD_SCENE_MIXED);
    shd_pool pool;
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    struct watcher watcher;
    shd_scene s;
    int total, at;
    pool.worker_count = c->workers;
    pool.order = SHD_POOL_RANDOM;
    pool.seed = 8;
    if (c->use_pool) {
        desc = shd_pool_context_desc(&pool);
    } else {
        desc.worker_count = c->workers;
    }
    pthread_mutex_init(&watcher.inside, NULL);
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&s, SHD_SCENE_MIXED, context);
    s.desc.progress.report = report;
    s.desc.progress.user_data = &watcher;
    start(&watcher, 0);
    assert_true(shd_scene_render(&s) == want);
    assert_int_equal(watcher.mistakes, 0);
    assert_true(watcher.latest == 1.0f);
    total = watcher.reports;
    assert_true(total >= 12); /* tiles of 203 x 151 */
    for (at = 1; at <= total; ++at) {
        start(&watcher, at);
        memset(&s.stats, 0xee, sizeof s.stats);
        s.stats.struct_size = sizeof s.stats;
        shd_assert_result("cancel", shd_render(context, &s.desc),
                          watcher.result > SHD_ERROR_INTERNAL ? SHD_ERROR_CALLBACK : watcher.result,
                          "render.progress.report returned");
        assert_int_equal(watcher.mistakes, 0);
        assert_int_equal(watcher.reports, at); /* no call after the cancel */
        assert_true(s.stats.triangle_count == 0 && s.stats.fragment_count == 0);
        start(&watcher, 0);
        assert_true(shd_scene_render(&s) == want);
    }
    shd_scene_close(&s);
    shd_context_release(context);
    pthread_mutex_destroy(&watcher.inside);
}

/* A frame without triangles is reported too. */
static void test_progress_of_nothing(void **state)
{
    struct watcher watcher;
    shd_context *context = NULL;
    shd_scene s;
    (void)state;
    pthread_mutex_init(&watcher.inside, NULL);
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    s.desc.draw_count = 0;
    s.desc.progress.report = report;
    s.desc.progress.user_data = &watcher;
    start(&watcher, 0);
    (void)shd_scene_render(&s);
    assert_int_equal(watcher.mistakes, 0);
    assert_true(watcher.latest == 1.0f);
    shd_scene_close(&s);
    shd_context_release(context);
    pthread_mutex_destroy(&watcher.inside);
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_cases / sizeof k_cases[0] + 1];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_cases[i].name, test_progress, NULL, NULL, (void *)&k_cases[i]};
    }
    tests[n++] = (struct CMUnitTest){"nothing", test_progress_of_nothing, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_progress", tests, n, NULL, NULL);
}
