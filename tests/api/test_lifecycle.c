/* SPDX-License-Identifier: MIT */
/* One script over every type of handle: references, misuse, order of release, leaks, allocations that fail. */
#include "support/check.h"
#include "support/fault_allocator.h"

#include <shd/shd.h>

/* The types behind one signature. `use` reads the handle through any call that can refuse it; NULL where only
   rendering does. */
struct type_row {
    const char *name;
    shd_result (*create)(shd_context *context, void **out);
    void (*retain)(void *handle);
    void (*release)(void *handle);
    shd_result (*use)(void *handle);
    const char *refusal;
};

static shd_result create_mesh(shd_context *context, void **out)
{
    static const float k_position[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 3};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = (shd_mesh *)&desc;
    shd_result result;
    int c;
    desc.vertex_count = 4;
    for (c = 0; c < 3; ++c) {
        desc.position[c].data = k_position + c;
        desc.position[c].stride = 3 * sizeof(float);
    }
    for (c = 0; c < 4; ++c) desc.tangent[c].data = k_position;
    desc.indices.data = k_indices;
    desc.index_count = 6;
    desc.normal_weight = SHD_NORMAL_WEIGHT_ANGLE;
    result = shd_mesh_create(context, &desc, &mesh);
    *out = mesh;
    return result;
}
static void retain_mesh(void *handle) { shd_mesh_retain((shd_mesh *)handle); }
static void release_mesh(void *handle) { shd_mesh_release((shd_mesh *)handle); }
static shd_result use_mesh(void *handle)
{
    shd_mesh_info info;
    return shd_mesh_get_info((const shd_mesh *)handle, &info);
}

static shd_result create_light(shd_context *context, void **out)
{
    shd_light *light = (shd_light *)out;
    const shd_result result = shd_light_create(context, NULL, &light);
    *out = light;
    return result;
}
static void retain_light(void *handle) { shd_light_retain((shd_light *)handle); }
static void release_light(void *handle) { shd_light_release((shd_light *)handle); }

static shd_result create_material(shd_context *context, void **out)
{
    shd_material *material = (shd_material *)out;
    const shd_result result = shd_material_create(context, NULL, &material);
    *out = material;
    return result;
}
static void retain_material(void *handle) { shd_material_retain((shd_material *)handle); }
static void release_material(void *handle) { shd_material_release((shd_material *)handle); }

static shd_result create_framebuffer(shd_context *context, void **out)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = (shd_framebuffer *)&desc;
    shd_result result;
    desc.width = 5;
    desc.height = 3;
    desc.aovs = SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE;
    result = shd_framebuffer_create(context, &desc, &framebuffer);
    *out = framebuffer;
    return result;
}
static void retain_framebuffer(void *handle) { shd_framebuffer_retain((shd_framebuffer *)handle); }
static void release_framebuffer(void *handle) { shd_framebuffer_release((shd_framebuffer *)handle); }
static shd_result use_framebuffer(void *handle)
{
    shd_framebuffer_info info;
    return shd_framebuffer_get_info((const shd_framebuffer *)handle, &info);
}

static const struct type_row k_types[] = {
    {"mesh", create_mesh, retain_mesh, release_mesh, use_mesh, "mesh: not a live handle of its type"},
    {"light", create_light, retain_light, release_light, NULL, ""},
    {"material", create_material, retain_material, release_material, NULL, ""},
    {"framebuffer", create_framebuffer, retain_framebuffer, release_framebuffer, use_framebuffer,
     "framebuffer: not a live handle of its type"},
};
enum { k_type_count = sizeof k_types / sizeof k_types[0] };

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
    if (t->use) shd_assert_result(t->name, t->use(handle), want, t->refusal);
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
    t->retain(handle);  /* brings nothing back */
    expect_use(t, handle, SHD_ERROR_INVALID_ARGUMENT);
    t->release(handle);
    shd_assert_ok(t->create(f.context, &other)); /* not mistaken for the dead one */
    assert_ptr_not_equal(other, handle);
    t->release(handle);
    expect_use(t, other, SHD_OK);
    t->release(other);
    t->retain(NULL);
    t->release(NULL);
    if (t->use) shd_assert_result(t->name, t->use(NULL), SHD_ERROR_INVALID_ARGUMENT, ": NULL");
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
        if (o == t) continue;
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
            fail_msg("%s: %zu bytes after cycle %d, %zu after the first", t->name, f.memory.live_bytes, i,
                     after_first);
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

/* Every allocation of a create call fails in turn: alone, then with all that follow. */
static void test_allocation_faults(void **state)
{
    const struct type_row *t = (const struct type_row *)*state;
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
                assert_int_equal(f.memory.live_bytes, before);
                shd_assert_ok(t->create(f.context, &again));
                t->release(again);
            }
            close_context(t->name, &f);
            assert_true(n < 1000);
        }
        assert_true(failures >= 2); /* the body and the slab of handles at least */
    }
}

/* The same for the context itself. */
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
        desc.worker_count = 2; /* with an executor of its own, where one is built in */
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
    shd_assert_result("light", shd_light_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_light: NULL");
    shd_assert_result("material", shd_material_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_material: NULL");
    shd_assert_result("framebuffer", shd_framebuffer_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_framebuffer: NULL");
    close_context("null_out", &f);
}

struct script_row {
    const char *name;
    CMUnitTestFunction run;
};
static const struct script_row k_script[] = {
    {"references", test_references},     {"wrong_type", test_wrong_type}, {"bad_context", test_bad_context},
    {"context_first", test_context_first}, {"cycles_10000", test_cycles},   {"alive_1000", test_many_alive},
    {"allocation_faults", test_allocation_faults},
};
enum { k_script_count = sizeof k_script / sizeof k_script[0] };

int main(void)
{
    static char names[k_type_count * k_script_count][64];
    static struct CMUnitTest tests[k_type_count * k_script_count + 2];
    size_t n = 0, i, j;
    for (i = 0; i < k_type_count; ++i) {
        for (j = 0; j < k_script_count; ++j, ++n) {
            snprintf(names[n], sizeof names[n], "%s/%s", k_types[i].name, k_script[j].name);
            tests[n] = (struct CMUnitTest){names[n], k_script[j].run, NULL, NULL, (void *)&k_types[i]};
        }
    }
    tests[n++] = (struct CMUnitTest){"context/allocation_faults", test_context_faults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null_out", test_null_out, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.lifecycle", tests, n, NULL, NULL);
}
