/* SPDX-License-Identifier: MIT */
/* One sequence of calls for every type of handle: references, misuse, order of release, leaks, allocations that
 * fail. */
#include "support/check.h"
#include "support/fault_allocator.h"
#include "support/handle_types.h"

#include <shd/shd.h>

/* A context on a counting allocator, which outlives it. */
struct fixture {
    shd_fault_allocator memory;
    shd_context *context;
};

static void open_context(struct fixture *f)
{
    shd_context_desc desc;
    memset(f, 0, sizeof *f);
    desc = shd_fault_context_desc(&f->memory);
    shd_assert_ok(shd_context_create(&desc, &f->context));
}

static void close_context(const char *what, struct fixture *f)
{
    shd_context_release(f->context);
    shd_assert_all_freed(what, &f->memory);
}

static void expect_use(const struct type_row *t, void *handle, shd_result want)
{
    shd_assert_result(t->name, t->use(handle), want, t->refusal);
}

static void test_references(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
    struct fixture f;
    void *handle = NULL, *other = NULL;
    open_context(&f);
    shd_assert_ok(t->create(f.context, &handle));
    assert_non_null(handle);
    expect_use(t, handle, SHD_OK);
    t->retain(handle);
    t->release(handle);
    expect_use(t, handle, SHD_OK);
    t->release(handle);
    expect_use(t, handle, SHD_ERROR_INVALID_ARGUMENT);
    t->release(handle); /* ignored */
    t->retain(handle);  /* does not revive the handle */
    expect_use(t, handle, SHD_ERROR_INVALID_ARGUMENT);
    t->release(handle);
    shd_assert_ok(t->create(f.context, &other)); /* the old handle does not refer to the new object */
    assert_ptr_not_equal(other, handle);
    t->release(handle);
    expect_use(t, other, SHD_OK);
    t->release(other);
    t->retain(NULL);
    t->release(NULL);
    if (strcmp(t->type, "material") == 0) {
        shd_assert_ok(t->use(NULL)); /* depth only */
    } else {
        shd_assert_result(t->name, t->use(NULL), SHD_ERROR_INVALID_ARGUMENT, ": NULL");
    }
    close_context(t->name, &f);
}

static void test_wrong_type(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
    struct fixture f;
    size_t i;
    open_context(&f);
    for (i = 0; i < k_type_count; ++i) {
        const struct type_row *o = &k_types[i];
        void *handle = NULL;
        if (strcmp(o->type, t->type) == 0) continue;
        shd_assert_ok(o->create(f.context, &handle));
        expect_use(t, handle, SHD_ERROR_INVALID_ARGUMENT);
        t->retain(handle);
        t->release(handle);
        t->release(handle);
        expect_use(o, handle, SHD_OK);
        o->release(handle);
        expect_use(o, handle, SHD_ERROR_INVALID_ARGUMENT);
    }
    close_context(t->name, &f);
}

static void test_bad_context(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
    struct fixture f;
    void *handle = &f, *mesh = NULL;
    shd_assert_result(t->name, t->create(NULL, &handle), SHD_ERROR_INVALID_ARGUMENT, "context: NULL");
    assert_null(handle);
    open_context(&f);
    shd_assert_ok(create_mesh(f.context, &mesh));
    handle = &f;
    shd_assert_result(t->name, t->create((shd_context *)mesh, &handle), SHD_ERROR_INVALID_ARGUMENT,
                      "context: not a live handle");
    assert_null(handle);
    shd_mesh_release((shd_mesh *)mesh);
    close_context(t->name, &f);
}

static void test_context_first(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
    struct fixture f;
    void *first = NULL, *second = NULL;
    open_context(&f);
    shd_assert_ok(t->create(f.context, &first));
    shd_assert_ok(t->create(f.context, &second));
    shd_context_release(f.context);
    assert_true(f.memory.live_bytes > 0);
    expect_use(t, first, SHD_OK);
    t->release(first);
    expect_use(t, first, SHD_ERROR_INVALID_ARGUMENT);
    expect_use(t, second, SHD_OK);
    t->release(second);
    shd_assert_all_freed(t->name, &f.memory);
}

static void test_cycles(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
    struct fixture f;
    size_t after_first = 0;
    int i;
    open_context(&f);
    for (i = 0; i < 10000; ++i) {
        void *handle = NULL;
        shd_assert_ok(t->create(f.context, &handle));
        t->retain(handle);
        t->release(handle);
        t->release(handle);
        if (i == 0) after_first = f.memory.live_bytes;
        if (f.memory.live_bytes > after_first) {
            fail_msg("%s: %zu bytes after cycle %d, %zu after the first", t->name, f.memory.live_bytes, i, after_first);
        }
    }
    close_context(t->name, &f);
}

static void test_many_alive(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
    static void *handles[1000];
    struct fixture f;
    size_t i;
    open_context(&f);
    for (i = 0; i < 1000; ++i) shd_assert_ok(t->create(f.context, &handles[i]));
    for (i = 0; i < 1000; i += 2) t->release(handles[i]);
    for (i = 0; i < 1000; ++i) expect_use(t, handles[i], i % 2 ? SHD_OK : SHD_ERROR_INVALID_ARGUMENT);
    for (i = 1; i < 1000; i += 2) t->release(handles[i]);
    close_context(t->name, &f);
}

/* Bytes that a context holds after a handle was created and released: its slab of handles stays. */
static size_t idle_bytes(const struct type_row *t)
{
    struct fixture f;
    void *handle = NULL;
    size_t bytes;
    open_context(&f);
    shd_assert_ok(t->create(f.context, &handle));
    t->release(handle);
    bytes = f.memory.live_bytes;
    close_context(t->name, &f);
    return bytes;
}

/* Every allocation of a create call fails in turn: alone, then with all later ones. */
static void test_allocation_faults(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
    const size_t idle = idle_bytes(t);
    int persistent;
    for (persistent = 0; persistent < 2; ++persistent) {
        size_t n, failures = 0;
        shd_result result = SHD_ERROR_OUT_OF_MEMORY;
        for (n = 1; result != SHD_OK; ++n) {
            struct fixture f;
            size_t before;
            void *handle = &f;
            open_context(&f);
            before = f.memory.live_bytes;
            shd_fault_arm(&f.memory, n, persistent);
            result = t->create(f.context, &handle);
            shd_fault_arm(&f.memory, 0, 0);
            if (result == SHD_OK) {
                t->release(handle);
            } else {
                void *again = NULL;
                ++failures;
                shd_assert_result(t->name, result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
                assert_null(handle);
                if (strcmp(t->name, t->type) == 0) assert_int_equal(f.memory.live_bytes, before);
                shd_assert_ok(t->create(f.context, &again));
                t->release(again);
                assert_int_equal(f.memory.live_bytes, idle);
            }
            close_context(t->name, &f);
            assert_true(n < 1000);
        }
        assert_true(failures >= 2); /* the body and the slab of handles at least */
    }
}

/* Every allocation of shd_context_create() fails in turn. */
static void test_context_faults(void **state)
{
    size_t n;
    shd_result result = SHD_ERROR_OUT_OF_MEMORY;
    (void)state;
    for (n = 1; result != SHD_OK; ++n) {
        shd_fault_allocator memory;
        shd_context_desc desc;
        shd_context *context = (shd_context *)&memory;
        memset(&memory, 0, sizeof memory);
        desc = shd_fault_context_desc(&memory);
        desc.worker_count = 2; /* with the built-in executor, if the build has one */
        shd_fault_arm(&memory, n, 1);
        result = shd_context_create(&desc, &context);
        if (result != SHD_OK) {
            shd_assert_result("context", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
            assert_null(context);
        }
        shd_context_release(context);
        shd_assert_all_freed("context", &memory);
        assert_true(n < 1000);
    }
    assert_true(n > 2);
}

static void test_null_out(void **state)
{
    struct fixture f;
    (void)state;
    open_context(&f);
    shd_assert_result("mesh", shd_mesh_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_mesh: NULL");
    shd_assert_result("light", shd_light_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_light: NULL");
    shd_assert_result("material", shd_material_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_material: NULL");
    shd_assert_result("framebuffer", shd_framebuffer_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_framebuffer: NULL");
    shd_assert_result("texture", shd_texture_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_texture: NULL");
    shd_assert_result("sampler", shd_sampler_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_sampler: NULL");
    close_context("null_out", &f);
}

/* Objects of two contexts that refer to each other are freed: a material of one context holds a texture of the
 * other, and every order of release frees all memory of both. */
static void test_two_contexts(void **state)
{
    int order;
    (void)state;
    for (order = 0; order < 6; ++order) {
        static const int k_orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        struct fixture a, b;
        shd_material_desc desc = shd_material_desc_default();
        shd_material *material = NULL;
        void *texture = NULL;
        shd_slot slot;
        int i;
        open_context(&a);
        open_context(&b);
        shd_assert_ok(create_texture(a.context, &texture));
        slot = shd_slot_texture(SHD_SLOT_DIFFUSE, (shd_texture *)texture, NULL);
        desc.slots = &slot;
        desc.slot_count = 1;
        shd_assert_ok(shd_material_create(b.context, &desc, &material));
        release_texture(texture);
        for (i = 0; i < 3; ++i) {
            switch (k_orders[order][i]) {
                case 0: shd_context_release(a.context); break;
                case 1: shd_context_release(b.context); break;
                default:
                    shd_assert_ok(use_material(material));
                    shd_assert_ok(use_texture(texture));
                    shd_material_release(material);
                    break;
            }
        }
        shd_assert_all_freed("first context", &a.memory);
        shd_assert_all_freed("second context", &b.memory);
    }
}

struct script_row {
    const char *name;
    CMUnitTestFunction run;
};
static const struct script_row k_script[] = {
    {"references", test_references},
    {"wrong_type", test_wrong_type},
    {"bad_context", test_bad_context},
    {"context_first", test_context_first},
    {"cycles_10000", test_cycles},
    {"alive_1000", test_many_alive},
    {"allocation_faults", test_allocation_faults},
};
enum { k_script_count = sizeof k_script / sizeof k_script[0] };

int main(void)
{
    static char names[k_type_count * k_script_count][64];
    static struct CMUnitTest tests[k_type_count * k_script_count + 3];
    size_t n = 0, i, j;
    int failed;
    if (open_rest() != SHD_OK) return 1;
    for (i = 0; i < k_type_count; ++i) {
        for (j = 0; j < k_script_count; ++j, ++n) {
            snprintf(names[n], sizeof names[n], "%s/%s", k_types[i].name, k_script[j].name);
            tests[n] = (struct CMUnitTest){names[n], k_script[j].run, NULL, NULL, (void *)&k_types[i]};
        }
    }
    tests[n++] = (struct CMUnitTest){"context/allocation_faults", test_context_faults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null_out", test_null_out, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"two_contexts", test_two_contexts, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.lifecycle", tests, n, NULL, NULL);
    close_rest();
    return failed;
}
