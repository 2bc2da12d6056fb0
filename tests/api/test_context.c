/* SPDX-License-Identifier: MIT */
/* Context: options, callbacks, version, results. */
#include "support/check.h"

#include <shd/shd.h>

struct create_case {
    const char *name;
    void (*edit)(shd_context_desc *desc);
    shd_result expected;
    const char *message;
};

static void *null_allocate(size_t size, size_t alignment, void *user_data)
{
    (void)user_data;
    (void)size;
    (void)alignment;
    return NULL;
}
static void null_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    (void)user_data;
    (void)memory;
    (void)size;
    (void)alignment;
}
static shd_result no_tasks(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    (void)user_data;
    (void)count;
    (void)task;
    (void)task_data;
    return SHD_OK;
}

static void edit_nothing(shd_context_desc *d) { (void)d; }
static void edit_size_zero(shd_context_desc *d) { d->struct_size = 0; }
static void edit_size_small(shd_context_desc *d) { d->struct_size = 8; }
static void edit_size_huge(shd_context_desc *d) { d->struct_size = 0xffffffffu; }
static void edit_workers(shd_context_desc *d) { d->worker_count = 1025; }
static void edit_one_worker(shd_context_desc *d) { d->worker_count = 1; }
static void edit_simd_unknown(shd_context_desc *d) { d->simd = (shd_simd)77; }
static void edit_simd_elsewhere(shd_context_desc *d)
{
#if defined(__x86_64__) || defined(__i386__)
    d->simd = SHD_SIMD_NEON;
#else
    d->simd = SHD_SIMD_AVX2;
#endif
}
static void edit_half_allocator(shd_context_desc *d) { d->allocator.allocate = null_allocate; }
static void edit_half_allocator_free(shd_context_desc *d) { d->allocator.free = null_free; }
static void edit_null_memory(shd_context_desc *d)
{
    d->allocator.allocate = null_allocate;
    d->allocator.free = null_free;
}
static void edit_executor_no_workers(shd_context_desc *d) { d->executor.parallel_for = no_tasks; }
static void edit_executor_many_workers(shd_context_desc *d)
{
    d->executor.parallel_for = no_tasks;
    d->executor.worker_count = 2000;
}
static void edit_executor_workers_alone(shd_context_desc *d) { d->executor.worker_count = 2; }

static const struct create_case k_create[] = {
    {"create/defaults", edit_nothing, SHD_OK, ""},
    {"create/one_worker", edit_one_worker, SHD_OK, ""},
    {"create/struct_size_zero", edit_size_zero, SHD_ERROR_INVALID_ARGUMENT, "context.struct_size: 0"},
    {"create/struct_size_small", edit_size_small, SHD_ERROR_INVALID_ARGUMENT, "context.struct_size: 8"},
    {"create/struct_size_huge", edit_size_huge, SHD_ERROR_INVALID_ARGUMENT, "context.struct_size: 4294967295"},
    {"create/workers_1025", edit_workers, SHD_ERROR_INVALID_ARGUMENT, "context.worker_count: 1025 is not in 0..1024"},
    {"create/simd_unknown", edit_simd_unknown, SHD_ERROR_INVALID_ARGUMENT, "context.simd: 77"},
    {"create/simd_of_another_machine", edit_simd_elsewhere, SHD_ERROR_UNSUPPORTED, "context.simd"},
    {"create/allocate_without_free", edit_half_allocator, SHD_ERROR_INVALID_ARGUMENT, "context.allocator.free: NULL"},
    {"create/free_without_allocate", edit_half_allocator_free, SHD_ERROR_INVALID_ARGUMENT,
     "context.allocator.allocate: NULL"},
    {"create/allocator_without_memory", edit_null_memory, SHD_ERROR_OUT_OF_MEMORY, "out of memory"},
    {"create/executor_without_workers", edit_executor_no_workers, SHD_ERROR_INVALID_ARGUMENT,
     "context.executor.worker_count: 0 is not in 1..1024"},
    {"create/executor_2000_workers", edit_executor_many_workers, SHD_ERROR_INVALID_ARGUMENT,
     "context.executor.worker_count: 2000"},
    {"create/executor_workers_alone", edit_executor_workers_alone, SHD_ERROR_INVALID_ARGUMENT,
     "context.executor.worker_count without parallel_for: 2"},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = (shd_context *)&desc;
    c->edit(&desc);
    shd_assert_result(c->name, shd_context_create(&desc, &context), c->expected, c->message);
    if (c->expected == SHD_OK) {
        assert_non_null(context);
    } else {
        assert_null(context);
    }
    shd_context_release(context);
}

static void test_null_desc(void **state)
{
    shd_context *context = NULL;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    assert_string_not_equal(shd_context_get_simd_target(context), "");
    assert_true(shd_context_get_worker_count(context) >= 1);
    shd_context_release(context);
}

static void test_null_arguments(void **state)
{
    (void)state;
    shd_assert_result("create", shd_context_create(NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_context: NULL");
    assert_string_equal(shd_context_get_simd_target(NULL), "");
    assert_int_equal(shd_context_get_worker_count(NULL), 0);
    shd_context_retain(NULL);
    shd_context_release(NULL);
}

static void test_newer_desc(void **state)
{
    struct {
        shd_context_desc desc;
        uint64_t later;
    } newer = {shd_context_desc_default(), 0};
    shd_context *context = NULL;
    (void)state;
    newer.desc.struct_size = (uint32_t)sizeof newer;
    shd_assert_ok(shd_context_create(&newer.desc, &context));
    shd_context_release(context);
    newer.later = 1;
    shd_assert_result("set tail", shd_context_create(&newer.desc, &context), SHD_ERROR_UNSUPPORTED, "is set");
    assert_null(context);
}

static void test_retain(void **state)
{
    shd_context *context = NULL;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_context_retain(context);
    shd_context_release(context);
    assert_string_not_equal(shd_context_get_simd_target(context), "");
    shd_context_release(context);
}

/** A target and its name from shd_context_get_simd_target(). */
static const struct {
    shd_simd simd;
    const char *name, *other_name;
} k_targets[] = {
    {SHD_SIMD_SCALAR, "SCALAR", "EMU128"}, {SHD_SIMD_SSE2, "SSE2", "SSE2"}, {SHD_SIMD_SSSE3, "SSSE3", "SSSE3"},
    {SHD_SIMD_SSE4, "SSE4", "SSE4"},       {SHD_SIMD_AVX2, "AVX2", "AVX2"}, {SHD_SIMD_AVX512, "AVX512", "AVX512"},
    {SHD_SIMD_NEON, "NEON", "NEON"},       {SHD_SIMD_WASM, "WASM", "WASM"},
};

/** Creates a context on a target. Returns the name of the target, or "" if it cannot run here. */
static const char *target_name(shd_simd simd)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    const char *name = "";
    shd_result result;
    desc.simd = simd;
    result = shd_context_create(&desc, &context);
    if (result == SHD_OK) {
        name = shd_context_get_simd_target(context);
    } else {
        shd_assert_result("forced", result, SHD_ERROR_UNSUPPORTED, "available:");
    }
    shd_context_release(context);
    return name;
}

static void test_forced_targets(void **state)
{
    const char *baseline = target_name(SHD_SIMD_BASELINE), *best = target_name(SHD_SIMD_BEST);
    int has_baseline = 0, has_best = 0;
    size_t i;
    (void)state;
    for (i = 0; i < sizeof k_targets / sizeof k_targets[0]; ++i) {
        const char *name = target_name(k_targets[i].simd);
        if (!name[0]) continue;
        assert_true(strcmp(name, k_targets[i].name) == 0 || strcmp(name, k_targets[i].other_name) == 0);
        has_baseline |= strcmp(name, baseline) == 0;
        has_best |= strcmp(name, best) == 0;
    }
    assert_true(has_baseline && has_best);
}

static void test_names(void **state)
{
    int i;
    (void)state;
    assert_int_equal(shd_version(), SHD_VERSION_MAJOR << 16 | SHD_VERSION_MINOR << 8 | SHD_VERSION_PATCH);
    assert_string_equal(shd_result_name(SHD_OK), "SHD_OK");
    assert_string_equal(shd_result_name(SHD_ERROR_OUT_OF_MEMORY), "SHD_ERROR_OUT_OF_MEMORY");
    for (i = 0; i <= SHD_ERROR_INTERNAL; ++i) {
        assert_string_not_equal(shd_result_name((shd_result)i), "SHD_RESULT_UNKNOWN");
    }
    assert_string_equal(shd_result_name((shd_result)12345), "SHD_RESULT_UNKNOWN");
    assert_non_null(shd_last_error());
}

int main(void)
{
    struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_create / sizeof k_create[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    tests[n++] = (struct CMUnitTest){"create/null_desc", test_null_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"newer_desc", test_newer_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"retain", test_retain, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"forced_targets", test_forced_targets, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"names", test_names, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.context", tests, n, NULL, NULL);
}
