/* SPDX-License-Identifier: MIT */
/* One script over every type of handle: references, misuse, order of release, leaks, allocations that fail. */
#include "support/check.h"
#include "support/fault_allocator.h"

#include <shd/shd.h>

/* What a handle needs beside it to be used: of another context, since objects may come from any. */
static struct {
    shd_context *context;
    shd_framebuffer *framebuffer;
    shd_mesh *mesh;
    shd_texture *texture;
    shd_sampler *sampler;
} g_rest;

/* The types behind one signature. `use` hands the handle to a call that must refuse a bad one. */
struct type_row {
    const char *name;
    const char *type;
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
static shd_result use_light(void *handle)
{
    const shd_light *light = (const shd_light *)handle;
    shd_render_desc desc = shd_render_desc_default();
    desc.framebuffer = g_rest.framebuffer;
    desc.lights = &light;
    desc.light_count = 1;
    return shd_render(g_rest.context, &desc);
}

static shd_result create_material(shd_context *context, void **out)
{
    shd_material *material = (shd_material *)out;
    const shd_result result = shd_material_create(context, NULL, &material);
    *out = material;
    return result;
}
static void retain_material(void *handle) { shd_material_retain((shd_material *)handle); }
static void release_material(void *handle) { shd_material_release((shd_material *)handle); }
static shd_result use_material(void *handle)
{
    shd_draw draw = shd_draw_default();
    shd_render_desc desc = shd_render_desc_default();
    draw.mesh = g_rest.mesh;
    draw.material = (const shd_material *)handle;
    desc.framebuffer = g_rest.framebuffer;
    desc.draws = &draw;
    desc.draw_count = 1;
    return shd_render(g_rest.context, &desc);
}

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

static shd_result create_texture(shd_context *context, void **out)
{
    static const unsigned char k_texels[4 * 5 * 3] = {255, 0, 0, 255, 0, 255, 0, 255};
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = (shd_texture *)&desc;
    shd_result result;
    desc.format = SHD_FORMAT_RGBA8_SRGB;
    desc.width = 5;
    desc.height = 3;
    desc.texels = k_texels;
    desc.tables = SHD_TABLE_MIPMAP;
    result = shd_texture_create(context, &desc, &texture);
    *out = texture;
    return result;
}
static void retain_texture(void *handle) { shd_texture_retain((shd_texture *)handle); }
static void release_texture(void *handle) { shd_texture_release((shd_texture *)handle); }
static shd_result use_texture(void *handle)
{
    shd_texture_info info;
    return shd_texture_get_info((const shd_texture *)handle, &info);
}

static shd_result create_sampler(shd_context *context, void **out)
{
    shd_sampler *sampler = (shd_sampler *)out;
    const shd_result result = shd_sampler_create(context, NULL, &sampler);
    *out = sampler;
    return result;
}
static void retain_sampler(void *handle) { shd_sampler_retain((shd_sampler *)handle); }
static void release_sampler(void *handle) { shd_sampler_release((shd_sampler *)handle); }
static shd_result use_sampler(void *handle)
{
    const float half = 0.5f;
    float red;
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels;
    memset(&texels, 0, sizeof texels);
    lookups.count = 1;
    lookups.u.data = lookups.v.data = &half;
    texels.channel[0].data = &red;
    return shd_texture_sample(g_rest.texture, (const shd_sampler *)handle, &lookups, &texels);
}

/* A material that holds the only references to a texture and a sampler. */
static shd_result create_textured_material(shd_context *context, void **out)
{
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    void *texture = NULL, *sampler = NULL;
    shd_result result = create_texture(context, &texture);
    if (result == SHD_OK) result = create_sampler(context, &sampler);
    if (result == SHD_OK) {
        desc.diffuse_texture = (shd_texture *)texture;
        desc.diffuse_sampler = (shd_sampler *)sampler;
        result = shd_material_create(context, &desc, &material);
    } else {
        assert_null(sampler);
    }
    release_sampler(sampler);
    release_texture(texture);
    *out = material;
    return result;
}

static const struct type_row k_types[] = {
    {"mesh", "mesh", create_mesh, retain_mesh, release_mesh, use_mesh, "mesh: not a live handle of its type"},
    {"light", "light", create_light, retain_light, release_light, use_light,
     "render.lights[0]: light: not a live handle of its type"},
    {"material", "material", create_material, retain_material, release_material, use_material,
     "render.draws[0]: draw.material: not a live handle of its type"},
    {"framebuffer", "framebuffer", create_framebuffer, retain_framebuffer, release_framebuffer, use_framebuffer,
     "framebuffer: not a live handle of its type"},
    {"texture", "texture", create_texture, retain_texture, release_texture, use_texture,
     "texture: not a live handle of its type"},
    {"sampler", "sampler", create_sampler, retain_sampler, release_sampler, use_sampler,
     "sampler: not a live handle of its type"},
    {"textured_material", "material", create_textured_material, retain_material, release_material, use_material,
     "render.draws[0]: draw.material: not a live handle of its type"},
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
    shd_assert_result(t->name, t->use(NULL), SHD_ERROR_INVALID_ARGUMENT, ": NULL");
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

/* What a context holds once a handle has come and gone: its slab of handles stays. */
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

/* Every allocation of a create call fails in turn: alone, then with all that follow. */
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
    shd_assert_result("texture", shd_texture_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_texture: NULL");
    shd_assert_result("sampler", shd_sampler_create(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_sampler: NULL");
    close_context("null_out", &f);
}

/* The library forgets nothing that happens to belong to two contexts: a material of one holds a texture of the
   other, and every order of release ends with no memory in either. */
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
        int i;
        open_context(&a);
        open_context(&b);
        shd_assert_ok(create_texture(a.context, &texture));
        desc.diffuse_texture = (shd_texture *)texture;
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

static shd_result open_rest(void)
{
    void *framebuffer = NULL, *mesh = NULL, *texture = NULL, *sampler = NULL;
    shd_result result = shd_context_create(NULL, &g_rest.context);
    if (result == SHD_OK) result = create_framebuffer(g_rest.context, &framebuffer);
    if (result == SHD_OK) result = create_mesh(g_rest.context, &mesh);
    if (result == SHD_OK) result = create_texture(g_rest.context, &texture);
    if (result == SHD_OK) result = create_sampler(g_rest.context, &sampler);
    g_rest.framebuffer = (shd_framebuffer *)framebuffer;
    g_rest.mesh = (shd_mesh *)mesh;
    g_rest.texture = (shd_texture *)texture;
    g_rest.sampler = (shd_sampler *)sampler;
    return result;
}

static void close_rest(void)
{
    shd_framebuffer_release(g_rest.framebuffer);
    shd_mesh_release(g_rest.mesh);
    shd_texture_release(g_rest.texture);
    shd_sampler_release(g_rest.sampler);
    shd_context_release(g_rest.context);
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
