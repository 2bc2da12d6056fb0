/* SPDX-License-Identifier: MIT */
/* Every allocation of a whole scene fails in turn, alone and with all later ones; then executors that fail, break
 * their contract or call back. After each fault the next render has the reference hash, and nothing leaks. */
#define _POSIX_C_SOURCE 200809L
#include "support/locked_allocator.h"
#include "support/pool.h"
#include "support/scene.h"

/* Four workers that run one after another on the calling thread, so that every run makes the same allocations in the
 * same order. */
static shd_result turns_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    uint32_t i;
    (void)user_data;
    for (i = 0; i < count; ++i) task(count - 1 - i, i % 4, task_data);
    return SHD_OK;
}

static void use_one_worker(shd_context_desc *desc) { desc->worker_count = 1; }
static void use_built_in(shd_context_desc *desc) { desc->worker_count = 4; }
static void use_turns(shd_context_desc *desc)
{
    desc->executor.parallel_for = turns_parallel_for;
    desc->executor.worker_count = 4;
}
static void use_threads(shd_context_desc *desc)
{
    static shd_pool pool = {4, SHD_POOL_RANDOM, 3};
    desc->executor.parallel_for = shd_pool_parallel_for;
    desc->executor.user_data = &pool;
    desc->executor.worker_count = 4;
}

/* Under a sanitizer one point takes up to a tenth of a second. There faults of one and of all later allocations share
 * the points; threads have a quarter of them, or with the thread sanitizer a ninth. */
#if defined(__SANITIZE_THREAD__)
enum { k_stride = 9, k_thread_stride = 9 };
#else
enum { k_stride = SHD_IS_SANITIZED ? 2 : 1, k_thread_stride = SHD_IS_SANITIZED ? 4 : 1 };
#endif

struct fault_case {
    const char *name;
    void (*use)(shd_context_desc *desc);
    int persistent;
    int steady; /* allocates the same blocks in every run */
};
static const struct fault_case k_faults[] = {
    {"one_worker/transient", use_one_worker, 0, 1},     {"one_worker/persistent", use_one_worker, 1, 1},
    {"four_in_turn/transient", use_turns, 0, 1},        {"four_in_turn/persistent", use_turns, 1, 1},
    {"four_threads/transient", use_threads, 0, 0},      {"four_threads/persistent", use_threads, 1, 0},
    {"built_in_of_four/transient", use_built_in, 0, 0}, {"built_in_of_four/persistent", use_built_in, 1, 0},
};

/* The field of the scene for the handle that a step makes. */
static const void *step_handle(const shd_scene *s, size_t step)
{
    if (step < SHD_SCENE_TEXTURES) return s->texture[step];
    step -= SHD_SCENE_TEXTURES;
    if (step < SHD_SCENE_SAMPLERS) return s->sampler[step];
    step -= SHD_SCENE_SAMPLERS;
    if (step < SHD_SCENE_MESHES) return s->mesh[step];
    step -= SHD_SCENE_MESHES;
    if (step < SHD_SCENE_MATERIALS) return s->material[step];
    step -= SHD_SCENE_MATERIALS;
    return step < SHD_SCENE_LIGHTS ? (const void *)s->light[step] : (const void *)s->framebuffer;
}

/* Counts over a case, printed at its end. */
struct tally {
    size_t points, context, objects, render;
};

/* Checks that `result` is SHD_OK or the armed fault. Returns whether it is the fault, which is then disarmed. */
static int is_fault(const char *what, shd_result result, struct locked_memory *locked)
{
    if (result == SHD_OK) return 0;
    shd_assert_result(what, result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
    assert_true(locked->memory.fail_at != 0);
    shd_fault_arm(&locked->memory, 0, 0);
    return 1;
}

/* Builds and renders the scene while the n-th allocation fails, and repeats each refused step. Returns whether the
 * fault occurred. */
static int run_with_fault(const struct fault_case *c, size_t n, uint64_t want, struct tally *tally)
{
    struct locked_memory locked;
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = (shd_context *)&desc;
    shd_scene s;
    size_t step;
    int met = 0;
    memset(&s, 0, sizeof s);
    memset(&locked.memory, 0, sizeof locked.memory);
    pthread_mutex_init(&locked.mutex, NULL);
    desc.allocator.allocate = locked_allocate;
    desc.allocator.free = locked_free;
    desc.allocator.user_data = &locked;
    desc.flags = SHD_CONTEXT_RETURN_MEMORY; /* so that every allocation can fail, and is freed by its call */
    c->use(&desc);
    shd_fault_arm(&locked.memory, n, c->persistent);

    if (is_fault("context", shd_context_create(&desc, &context), &locked)) {
        met = 1;
        ++tally->context;
        assert_null(context);
        shd_assert_all_freed("context", &locked.memory);
        shd_assert_ok(shd_context_create(&desc, &context));
    }
    s.kind = SHD_SCENE_SMALL;
    s.context = context;
    for (step = 0; step < SHD_SCENE_STEPS; ++step) {
        const size_t before = locked.memory.live_bytes;
        if (!is_fault("object", shd_scene_step(&s, step), &locked)) continue;
        met = 1;
        ++tally->objects;
        assert_null(step_handle(&s, step));
        /* A slab of handles may stay, for the next object to use. */
        assert_true(locked.memory.live_bytes >= before);
        shd_assert_ok(shd_scene_step(&s, step));
    }
    shd_scene_compose(&s);
    {
        const size_t before = locked.memory.live_bytes;
        memset(&s.stats, 0xee, sizeof s.stats);
        s.stats.struct_size = sizeof s.stats;
        if (is_fault("render", shd_render(context, &s.desc), &locked)) {
            met = 1;
            ++tally->render;
            assert_true(s.stats.triangle_count == 0 && s.stats.fragment_count == 0);
            assert_int_equal(locked.memory.live_bytes, before);
        }
        shd_fault_arm(&locked.memory, 0, 0);
        assert_true(shd_scene_render(&s) == want);
        assert_int_equal(locked.memory.live_bytes, before);
    }
    shd_scene_close(&s);
    shd_context_release(context);
    shd_assert_all_freed(c->name, &locked.memory);
    pthread_mutex_destroy(&locked.mutex);
    return met;
}

static void test_faults(void **state)
{
    const struct fault_case *c = (const struct fault_case *)*state;
    const uint64_t want = shd_scene_reference(SHD_SCENE_SMALL);
    struct tally tally;
    const size_t stride = c->steady ? k_stride : k_thread_stride;
    size_t n, missed = 0;
    memset(&tally, 0, sizeof tally);
    /* With threads, runs may use different numbers of workers, so the search ends after three runs without a fault. */
    for (n = c->persistent && k_stride > 1 ? 2 : 1; missed < (c->steady ? 1u : 3u); n += stride) {
        missed = run_with_fault(c, n, want, &tally) ? 0 : missed + 1;
        assert_true(n < 5000);
    }
    tally.points = tally.context + tally.objects + tally.render;
    print_message("%s: %zu points (context %zu, objects %zu, render %zu), 0 lost\n", c->name, tally.points,
                  tally.context, tally.objects, tally.render);
    assert_true(tally.context >= 1 && tally.objects > 40 / stride && tally.render > 20 / stride);
}

/* Executors that break their contract. */
struct liar {
    shd_result answer;
    int lie; /* one of the cases below */
    int armed;
    uint32_t calls;
    shd_context *context;
    shd_result nested;
    const shd_scene *scene;
};
enum {
    k_fail_early,
    k_fail_late,
    k_skip_one,
    k_run_none,
    k_run_twice,
    k_twice_and_skip,
    k_index_out,
    k_worker_out,
    k_reenter
};

static void nested_task(size_t index, size_t worker, void *data)
{
    (void)index;
    (void)worker;
    ++*(uint32_t *)data;
}

/* Calls shd from inside its own parallel_for. */
static shd_result reenter(const struct liar *self)
{
    float u[40], v[40], r[40];
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels;
    shd_sampler *sampler = NULL;
    shd_result result;
    memset(&texels, 0, sizeof texels);
    memset(u, 0, sizeof u);
    memset(v, 0, sizeof v);
    lookups.count = 40;
    lookups.u.data = u;
    lookups.v.data = v;
    texels.channel[0].data = r;
    result = shd_sampler_create(self->context, NULL, &sampler);
    if (result == SHD_OK) result = shd_texture_sample(self->scene->texture[0], sampler, &lookups, &texels);
    shd_sampler_release(sampler);
    return result;
}

static shd_result liar_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    struct liar *self = (struct liar *)user_data;
    const int lie = self->armed ? self->lie : -1;
    uint32_t i;
    ++self->calls;
    if (lie == k_fail_early) return self->answer;
    if (lie == k_run_none) return SHD_OK;
    if (lie == k_index_out) task(count, 0, task_data);
    if (lie == k_worker_out) task(0, 4, task_data);
    if (lie == k_reenter) self->nested = reenter(self);
    for (i = 0; i < count; ++i) {
        if ((lie == k_skip_one || lie == k_twice_and_skip) && i == count - 1) continue;
        task(i, i % 4, task_data);
        if ((lie == k_run_twice || lie == k_twice_and_skip) && i == 0) task(i, i % 4, task_data);
    }
    return lie == k_fail_late ? self->answer : SHD_OK;
}

struct liar_case {
    const char *name;
    int lie;
    shd_result answer, expected;
    const char *message;
};
static const struct liar_case k_liars[] = {
    {"executor/fails_before", k_fail_early, SHD_ERROR_INTERNAL, SHD_ERROR_CALLBACK, "returned SHD_ERROR_INTERNAL"},
    {"executor/fails_after", k_fail_late, SHD_ERROR_IO, SHD_ERROR_CALLBACK, "returned SHD_ERROR_IO"},
    {"executor/fails_with_77", k_fail_late, (shd_result)77, SHD_ERROR_CALLBACK, "returned SHD_RESULT_UNKNOWN"},
    {"executor/skips_one", k_skip_one, SHD_OK, SHD_ERROR_CALLBACK, " tasks"},
    {"executor/runs_none", k_run_none, SHD_OK, SHD_ERROR_CALLBACK, "ran 0 of "},
    {"executor/runs_one_twice", k_run_twice, SHD_OK, SHD_ERROR_CALLBACK, "ran a task twice"},
    {"executor/runs_one_twice_skips_one", k_twice_and_skip, SHD_OK, SHD_ERROR_CALLBACK, "ran a task twice"},
    {"executor/index_out_of_range", k_index_out, SHD_OK, SHD_ERROR_CALLBACK, "index or worker out of range"},
    {"executor/worker_out_of_range", k_worker_out, SHD_OK, SHD_ERROR_CALLBACK, "index or worker out of range"},
    {"executor/calls_shd", k_reenter, SHD_OK, SHD_OK, ""},
};

static void test_liar(void **state)
{
    const struct liar_case *c = (const struct liar_case *)*state;
    const uint64_t want = shd_scene_reference(SHD_SCENE_SMALL);
    shd_fault_allocator memory;
    shd_context_desc desc;
    struct liar liar;
    shd_scene s;
    uint32_t done = 0;
    size_t before;
    int call;
    memset(&liar, 0, sizeof liar);
    memset(&memory, 0, sizeof memory);
    liar.lie = c->lie;
    liar.answer = c->answer;
    liar.scene = &s;
    desc = shd_fault_context_desc(&memory);
    desc.worker_count = 0;
    desc.executor.parallel_for = liar_parallel_for;
    desc.executor.user_data = &liar;
    desc.executor.worker_count = 4;
    shd_assert_ok(shd_context_create(&desc, &liar.context));
    shd_scene_open(&s, SHD_SCENE_SMALL, liar.context);
    assert_true(shd_scene_render(&s) == want);
    before = memory.live_bytes;
    liar.armed = 1;
    for (call = 0; call < 3; ++call) {
        shd_assert_result(c->name, shd_render(liar.context, &s.desc), c->expected, c->message);
        shd_assert_ok(liar.nested);
        assert_int_equal(memory.live_bytes, before);
    }
    shd_assert_result(c->name, shd_context_parallel_for(liar.context, 7, nested_task, &done), c->expected, c->message);
    liar.armed = 0;
    assert_true(shd_scene_render(&s) == want);
    assert_true(liar.calls > 4);
    shd_scene_close(&s);
    shd_context_release(liar.context);
    shd_assert_all_freed(c->name, &memory);
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_faults / sizeof k_faults[0] + sizeof k_liars / sizeof k_liars[0]];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_faults / sizeof k_faults[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_faults[i].name, test_faults, NULL, NULL, (void *)&k_faults[i]};
    }
    for (i = 0; i < sizeof k_liars / sizeof k_liars[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_liars[i].name, test_liar, NULL, NULL, (void *)&k_liars[i]};
    }
    return _cmocka_run_group_tests("api.faults", tests, n, NULL, NULL);
}
