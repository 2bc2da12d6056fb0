/* SPDX-License-Identifier: MIT */
/* Functions for libraries on top of libshd: errors, memory, log, tasks and handles. */
#include "support/fault_allocator.h"

#include <shd/extension.h>
#include <shd/shd.h>

enum { k_type = 0x54455354, k_other_type = 0x4f544852 }; /* 'TEST', 'OTHR' */

struct log_line {
    shd_log_level level;
    char text[64];
    int count;
};
static void write_log(shd_log_level level, const char *message, void *user_data)
{
    struct log_line *line = (struct log_line *)user_data;
    line->level = level;
    snprintf(line->text, sizeof line->text, "%s", message);
    ++line->count;
}

struct fixture {
    shd_fault_allocator memory;
    struct log_line log;
    shd_context *context;
};
static void open_context(struct fixture *f)
{
    shd_context_desc desc;
    memset(f, 0, sizeof *f);
    desc = shd_fault_context_desc(&f->memory);
    desc.log.write = write_log;
    desc.log.user_data = &f->log;
    shd_assert_ok(shd_context_create(&desc, &f->context));
}
static void close_context(struct fixture *f)
{
    shd_context_release(f->context);
    shd_assert_all_freed("extension", &f->memory);
}

static void test_report_error(void **state)
{
    static char longer[3000];
    (void)state;
    assert_int_equal(shd_report_error(SHD_ERROR_IO, "100 %s of %n"), SHD_ERROR_IO);
    assert_string_equal(shd_last_error(), "100 %s of %n");
    assert_int_equal(shd_report_error(SHD_ERROR_CORRUPT, NULL), SHD_ERROR_CORRUPT);
    assert_string_equal(shd_last_error(), "");
    memset(longer, 'x', sizeof longer - 1);
    assert_int_equal(shd_report_error(SHD_ERROR_LIMIT, longer), SHD_ERROR_LIMIT);
    assert_int_equal(strlen(shd_last_error()), 1023);
}

struct memory_case {
    const char *name;
    size_t size, alignment;
    int given;
};
static const struct memory_case k_memory[] = {
    {"memory/1_byte", 1, 8, 1},          {"memory/alignment_1", 100, 1, 1},
    {"memory/alignment_0", 100, 0, 1},   {"memory/alignment_4096", 100, 4096, 1},
    {"memory/size_0", 0, 8, 0},          {"memory/alignment_3", 100, 3, 0},
    {"memory/alignment_24", 100, 24, 0}, {"memory/size_max", (size_t)-1, 8, 0},
};
static void test_memory(void **state)
{
    const struct memory_case *c = (const struct memory_case *)*state;
    struct fixture f;
    void *memory;
    size_t before;
    open_context(&f);
    before = f.memory.live_bytes;
    memory = shd_context_allocate(f.context, c->size, c->alignment);
    assert_int_equal(memory != NULL, c->given);
    if (memory) {
        const size_t alignment = c->alignment ? c->alignment : 1;
        assert_int_equal((uintptr_t)memory % alignment, 0);
        memset(memory, 0x5a, c->size);
        assert_int_equal(f.memory.live_bytes, before + c->size);
        shd_context_free(f.context, memory, c->size, c->alignment);
    }
    shd_context_free(f.context, NULL, c->size, c->alignment);
    assert_int_equal(f.memory.live_bytes, before);
    shd_fault_arm(&f.memory, 1, 1);
    assert_null(shd_context_allocate(f.context, c->size, c->alignment));
    shd_fault_arm(&f.memory, 0, 0);
    assert_null(shd_context_allocate(NULL, 8, 8));
    close_context(&f);
}

static void test_log(void **state)
{
    struct fixture f;
    shd_context *silent = NULL;
    (void)state;
    open_context(&f);
    shd_context_log(f.context, SHD_LOG_LEVEL_WARNING, "%d %s");
    assert_int_equal(f.log.level, SHD_LOG_LEVEL_WARNING);
    assert_string_equal(f.log.text, "%d %s");
    shd_context_log(f.context, SHD_LOG_LEVEL_ERROR, NULL);
    shd_context_log(NULL, SHD_LOG_LEVEL_ERROR, "nowhere");
    assert_int_equal(f.log.count, 1);
    close_context(&f);
    shd_assert_ok(shd_context_create(NULL, &silent));
    shd_context_log(silent, SHD_LOG_LEVEL_ERROR, "to nobody");
    shd_context_release(silent);
}

struct count_tasks {
    unsigned char runs[70000];
    uint32_t worker_count, mistakes;
    shd_context *context;
    shd_result nested;
};
static void count_task(size_t index, size_t worker, void *data)
{
    struct count_tasks *tasks = (struct count_tasks *)data;
    if (worker >= tasks->worker_count) __atomic_fetch_add(&tasks->mistakes, 1, __ATOMIC_RELAXED);
    ++tasks->runs[index];
}
static void nesting_task(size_t index, size_t worker, void *data)
{
    static struct count_tasks inner[4];
    struct count_tasks *tasks = (struct count_tasks *)data;
    (void)worker;
    if (index >= 4) return;
    inner[index].worker_count = 1024;
    if (shd_context_parallel_for(tasks->context, 100, count_task, &inner[index]) != SHD_OK ||
        inner[index].runs[99] == 0) {
        __atomic_fetch_add(&tasks->mistakes, 1, __ATOMIC_RELAXED);
    }
}

static void test_parallel_for(void **state)
{
    static const uint32_t k_counts[] = {0, 1, 2, 3, 31, 32, 33, 1023, 1024, 1025, 70000};
    static const uint32_t k_workers[] = {1, 2, 0, 16};
    static struct count_tasks tasks;
    size_t w, c, i;
    (void)state;
    for (w = 0; w < sizeof k_workers / sizeof k_workers[0]; ++w) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        desc.worker_count = k_workers[w];
        shd_assert_ok(shd_context_create(&desc, &context));
        for (c = 0; c < sizeof k_counts / sizeof k_counts[0]; ++c) {
            memset(&tasks, 0, sizeof tasks);
            tasks.worker_count = shd_context_get_worker_count(context);
            shd_assert_ok(shd_context_parallel_for(context, k_counts[c], count_task, &tasks));
            for (i = 0; i < sizeof tasks.runs; ++i) assert_int_equal(tasks.runs[i], i < k_counts[c]);
            assert_int_equal(tasks.mistakes, 0);
        }
        tasks.context = context;
        shd_assert_ok(shd_context_parallel_for(context, 8, nesting_task, &tasks));
        assert_int_equal(tasks.mistakes, 0);
        shd_assert_result("task", shd_context_parallel_for(context, 2, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                          "parallel_for.task: NULL");
        shd_context_release(context);
    }
    shd_assert_result("context", shd_context_parallel_for(NULL, 2, count_task, &tasks), SHD_ERROR_INVALID_ARGUMENT,
                      "context: NULL");
}

/* More than 1024 tasks need memory to keep track of each task. */
static void test_parallel_for_faults(void **state)
{
    static struct count_tasks tasks;
    struct fixture f;
    (void)state;
    open_context(&f);
    tasks.worker_count = 1;
    shd_fault_arm(&f.memory, 1, 1);
    shd_assert_ok(shd_context_parallel_for(f.context, 1024, count_task, &tasks));
    shd_assert_result("1025", shd_context_parallel_for(f.context, 1025, count_task, &tasks), SHD_ERROR_OUT_OF_MEMORY,
                      "out of memory");
    assert_int_equal(tasks.runs[0], 1);
    close_context(&f);
}

static void count_end(void *body) { ++*(int *)body; }

static void test_object(void **state)
{
    struct fixture f;
    shd_object *object = NULL;
    int ends = 0;
    (void)state;
    open_context(&f);
    shd_assert_ok(shd_object_create(f.context, k_type, &ends, count_end, &object));
    assert_ptr_equal(shd_object_get_body(object, k_type), &ends);
    assert_null(shd_object_get_body(object, k_other_type));
    assert_string_equal(shd_last_error(), "object: not a live handle of its type");
    assert_null(shd_object_get_body(object, 1));
    assert_null(shd_object_get_body(NULL, k_type));
    assert_string_equal(shd_last_error(), "object: NULL");
    assert_ptr_equal(shd_object_get_context(object), f.context);
    shd_object_retain(object, k_type);
    shd_object_retain(object, k_other_type);
    shd_object_release(object, k_other_type);
    shd_object_release(object, k_type);
    assert_int_equal(ends, 0);
    shd_mesh_release((shd_mesh *)object); /* the release of another type does nothing */
    assert_int_equal(ends, 0);
    shd_object_release(object, k_type);
    assert_int_equal(ends, 1);
    shd_object_release(object, k_type);
    shd_object_retain(object, k_type);
    assert_int_equal(ends, 1);
    assert_null(shd_object_get_body(object, k_type));
    assert_null(shd_object_get_context(object));
    shd_object_retain(NULL, k_type);
    shd_object_release(NULL, k_type);
    assert_null(shd_object_get_context(NULL));
    close_context(&f);
}

static void test_object_refusals(void **state)
{
    struct fixture f;
    shd_object *object = (shd_object *)&f;
    int ends = 0;
    (void)state;
    open_context(&f);
    shd_assert_result("type", shd_object_create(f.context, 0xffff, &ends, count_end, &object),
                      SHD_ERROR_INVALID_ARGUMENT, "object.type: 0xffff is not above 0xffff");
    assert_null(object);
    shd_assert_result("body", shd_object_create(f.context, k_type, NULL, count_end, &object),
                      SHD_ERROR_INVALID_ARGUMENT, "object.body: NULL");
    shd_assert_result("destroy", shd_object_create(f.context, k_type, &ends, NULL, &object), SHD_ERROR_INVALID_ARGUMENT,
                      "object.destroy: NULL");
    shd_assert_result("context", shd_object_create(NULL, k_type, &ends, count_end, &object), SHD_ERROR_INVALID_ARGUMENT,
                      "context: NULL");
    shd_assert_result("out", shd_object_create(f.context, k_type, &ends, count_end, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_object: NULL");
    assert_int_equal(ends, 0);
    close_context(&f);
}

/* A failed creation leaves the body to the caller; success keeps the context alive. */
static void test_object_faults(void **state)
{
    int persistent;
    (void)state;
    for (persistent = 0; persistent < 2; ++persistent) {
        shd_result result = SHD_ERROR_OUT_OF_MEMORY;
        size_t n;
        for (n = 1; result != SHD_OK; ++n) {
            struct fixture f;
            shd_object *object = (shd_object *)&f;
            int ends = 0;
            open_context(&f);
            shd_fault_arm(&f.memory, n, persistent);
            result = shd_object_create(f.context, k_type, &ends, count_end, &object);
            shd_fault_arm(&f.memory, 0, 0);
            shd_context_release(f.context);
            if (result == SHD_OK) {
                assert_true(f.memory.live_bytes > 0);
                shd_object_release(object, k_type);
                assert_int_equal(ends, 1);
            } else {
                assert_int_equal(result, SHD_ERROR_OUT_OF_MEMORY);
                assert_null(object);
                assert_int_equal(ends, 0);
            }
            shd_assert_all_freed("object", &f.memory);
            assert_true(n < 100);
        }
        assert_true(n >= 3);
    }
}

static void test_framebuffer_context(void **state)
{
    struct fixture f;
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_object *object = NULL;
    int ends = 0;
    (void)state;
    open_context(&f);
    desc.width = desc.height = 2;
    shd_assert_ok(shd_framebuffer_create(f.context, &desc, &framebuffer));
    shd_assert_ok(shd_object_create(f.context, k_type, &ends, count_end, &object));
    assert_ptr_equal(shd_framebuffer_get_context(framebuffer), f.context);
    assert_null(shd_framebuffer_get_context((const shd_framebuffer *)object));
    assert_null(shd_framebuffer_get_context(NULL));
    shd_framebuffer_release(framebuffer);
    assert_null(shd_framebuffer_get_context(framebuffer));
    shd_object_release(object, k_type);
    close_context(&f);
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_memory / sizeof k_memory[0] + 8];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_memory / sizeof k_memory[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_memory[i].name, test_memory, NULL, NULL, (void *)&k_memory[i]};
    }
    tests[n++] = (struct CMUnitTest){"report_error", test_report_error, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"log", test_log, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parallel_for", test_parallel_for, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parallel_for/faults", test_parallel_for_faults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"object", test_object, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"object/refusals", test_object_refusals, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"object/faults", test_object_faults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"framebuffer_context", test_framebuffer_context, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.extension", tests, n, NULL, NULL);
}
