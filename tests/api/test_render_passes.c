/* SPDX-License-Identifier: MIT */
/* Frames drawn in passes of a bounded number of triangles: the same bits for any bound, with the memory of one pass. */
#define _POSIX_C_SOURCE 200809L
#include "support/fault_allocator.h"
#include "support/pool.h"
#include "support/scene.h"
#include "support/watcher.h"

enum { ALL_AOVS = 2 * SHD_AOV_TARGET3 - 1, INSTANCES = 40 };

/* Order of the triangles of a sheet. */
typedef enum sheet_order {
    ROWS = 0,    /* neighbours follow each other */
    SHUFFLED = 1 /* random order */
} sheet_order;

/* Hills of n x n cells over [-1, 1]^2, with `unused` vertices that no triangle uses before and after their own. */
static shd_mesh *make_sheet(shd_context *context, uint32_t n, sheet_order order, uint32_t unused)
{
    const uint32_t vertices = (n + 1) * (n + 1) + 2 * unused;
    const size_t triangles = 2 * (size_t)n * n;
    shd_scene_geometry g = {NULL, NULL, 0, 0};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    uint32_t seed = 11;
    size_t i, k;
    int c;
    g.vertices = (float *)shd_scene_memory(vertices * 5 * sizeof(float));
    g.indices = (uint32_t *)shd_scene_memory(3 * triangles * sizeof(uint32_t));
    for (i = 0; i < unused; ++i) shd_scene_vertex(&g, 9, 9, 9, 9, 9);
    shd_scene_hills(&g, n);
    for (i = 0; i < unused; ++i) shd_scene_vertex(&g, 9, 9, 9, 9, 9);
    for (i = triangles; order == SHUFFLED && i > 1; --i) {
        uint32_t *a = g.indices + 3 * (i - 1), *b;
        b = g.indices + 3 * (size_t)(shd_scene_random(&seed) * (float)i);
        for (k = 0; k < 3; ++k) {
            const uint32_t swapped = a[k];
            a[k] = b[k];
            b[k] = swapped;
        }
    }
    desc.vertex_count = g.vertex_count;
    for (c = 0; c < 5; ++c) {
        shd_f32_in *column = c < 3 ? &desc.position[c] : &desc.uv[c - 3];
        column->data = g.vertices + c;
        column->stride = 5 * sizeof(float);
    }
    desc.indices.data = g.indices;
    desc.index_count = g.index_count;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    free(g.vertices);
    free(g.indices);
    return mesh;
}

/* The scene of every blend and depth state, with larger meshes in some draws, one of which has many instances. */
struct stage {
    shd_scene scene;
    shd_mesh *rows, *shuffled, *sparse;
    float instances[INSTANCES][16];
};

/* The displacement and a varying depend on the vertex number, so the program must get the correct number in every
 * pass. */
static void move_vertices(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        const uint32_t number = in->first + (uint32_t)i;
        out->y[i] += 0.01f * (float)(number % 5) * out->w[i];
        out->varying[0][i] = in->u[i];
        out->varying[1][i] = (float)(number % 17) / 17.0f;
        out->varying[2][i] = (float)(number % 3);
    }
}
static void paint_varyings(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        out->r[i] = in->varying[0][i] + in->x[i];
        out->g[i] = in->varying[1][i] + in->depth[i];
        out->b[i] = in->varying[2][i] + (float)in->triangle[i];
        out->a[i] = 0.5f;
        if (!out->target[0][0]) continue;
        out->target[0][0][i] = in->varying[1][i];
        out->target[2][1][i] = in->x[i];
        out->target[2][3][i] = 0.25f;
    }
}

static void use_programs(shd_scene *s)
{
    static const shd_interpolation k_interpolation[3] = {SHD_INTERPOLATION_PERSPECTIVE, SHD_INTERPOLATION_AFFINE,
                                                         SHD_INTERPOLATION_FLAT};
    shd_material_desc desc = shd_material_desc_default();
    desc.model = SHD_MODEL_PROGRAM;
    desc.program.fragment = paint_varyings;
    desc.program.vertex = move_vertices;
    desc.varying_count = 3;
    desc.interpolation = k_interpolation;
    shd_material_release(s->material[6]);
    shd_assert_ok(shd_material_create(s->context, &desc, &s->material[6]));
    s->draw[5].material = s->draw[6].material = s->draw[7].material = s->draw[9].material = s->material[6];
}

static void open_stage(struct stage *t, shd_context *context, uint32_t samples, uint32_t n)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    uint32_t seed = 3;
    size_t i;
    memset(t, 0, sizeof *t);
    shd_scene_open(&t->scene, SHD_SCENE_GLASS, context);
    use_programs(&t->scene);
    shd_framebuffer_release(t->scene.framebuffer);
    desc.width = 203;
    desc.height = 151;
    desc.sample_count = samples;
    desc.aovs = ALL_AOVS;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &t->scene.framebuffer));
    t->scene.desc.framebuffer = t->scene.framebuffer;
    t->rows = make_sheet(context, n, ROWS, 0);
    t->shuffled = make_sheet(context, n, SHUFFLED, 0);
    t->sparse = make_sheet(context, n / 8, SHUFFLED, 40 * n);
    t->scene.draw[2].mesh = t->shuffled;
    t->scene.draw[4].mesh = t->rows;
    t->scene.draw[6].mesh = t->shuffled;
    t->scene.draw[7].mesh = t->rows;
    t->scene.draw[9].mesh = t->sparse;
    for (i = 0; i < INSTANCES; ++i) {
        float *m = t->instances[i];
        memcpy(m, t->scene.draw[5].object_to_world, sizeof t->instances[i]);
        m[12] = 3.0f * shd_scene_random(&seed) - 1.5f;
        m[13] = 2.0f * shd_scene_random(&seed) - 1.0f;
        m[14] = 2.0f * shd_scene_random(&seed) - 1.0f;
    }
    t->scene.draw[5].instances = t->instances[0];
    t->scene.draw[5].instance_count = INSTANCES;
    t->scene.desc.flags = SHD_RENDER_COUNT_HIDDEN;
}

static void close_stage(struct stage *t)
{
    shd_mesh_release(t->rows);
    shd_mesh_release(t->shuffled);
    shd_mesh_release(t->sparse);
    shd_scene_close(&t->scene);
}

/* Hash of planes and statistics, without the statistics that may depend on passes. */
static uint64_t render(struct stage *t, uint32_t pass_triangles)
{
    shd_render_stats *stats = &t->scene.stats;
    t->scene.desc.pass_triangles = pass_triangles;
    memset(stats, 0xee, sizeof *stats);
    stats->struct_size = sizeof *stats;
    shd_assert_ok(shd_render(t->scene.context, &t->scene.desc));
    return shd_hash(shd_hash_framebuffer(t->scene.framebuffer), &stats->triangle_count,
                    offsetof(shd_render_stats, fragment_count) - offsetof(shd_render_stats, triangle_count));
}

enum { DEFAULT_PASS = 1 << 21 };

/* Passes of fewer sizes are enough for a sanitizer. */
static const uint32_t k_sizes[] = {1024, 1025, 30000, 2000, 4096, 9999, 65536, 0x7fffffff};
enum { SIZES = SHD_ORACLE_STRIDE > 1 ? 3 : sizeof k_sizes / sizeof k_sizes[0] };

struct bits_case {
    const char *name;
    uint32_t samples, n;
    uint32_t load;
    size_t sizes;
};
static const struct bits_case k_bits[] = {{"bits/samples_1", 1, 120, 0, SIZES}, {"bits/samples_4", 4, 120, 0, SIZES},
                                          {"bits/samples_2", 2, 60, 0, SIZES},  {"bits/samples_8", 8, 40, 0, 3},
                                          {"bits/samples_16", 16, 40, 0, 3},    {"bits/load/samples_1", 1, 60, 1, 3},
                                          {"bits/load/samples_4", 4, 60, 1, 3}, {"bits/large/samples_4", 4, 300, 0, 1}};
enum { BITS = sizeof k_bits / sizeof k_bits[0] };

static void test_bits(void **state)
{
    const struct bits_case *c = (const struct bits_case *)*state;
    shd_context *context = NULL;
    struct stage t;
    uint64_t want;
    size_t i;
    shd_assert_ok(shd_context_create(NULL, &context));
    open_stage(&t, context, c->samples, c->n);
    t.scene.desc.flags = c->load ? SHD_RENDER_LOAD : SHD_RENDER_NONE;
    t.scene.desc.clear_color[0] = 0.1f;
    want = render(&t, DEFAULT_PASS);
    assert_true(t.scene.stats.triangle_count > 4 * 2 * c->n * c->n);
    for (i = 0; i < c->sizes; ++i) {
        const uint32_t samples = c->samples;
        struct stage other;
        uint64_t got;
        open_stage(&other, context, samples, c->n);
        other.scene.desc.flags = c->load ? SHD_RENDER_LOAD : SHD_RENDER_NONE;
        other.scene.desc.clear_color[0] = 0.1f;
        got = render(&other, k_sizes[i]);
        close_stage(&other);
        if (got != want) fail_msg("passes of %u triangles differ", k_sizes[i]);
    }
    close_stage(&t);
    shd_context_release(context);
}

/* Two draws with order-independent blends between ordered draws; both are moved to the last pass. */
static void test_unordered(void **state)
{
    shd_context *context = NULL;
    struct stage t;
    uint64_t want;
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    open_stage(&t, context, 2, 48);
    for (i = 0; i < 8; ++i) {
        shd_material_desc desc = shd_material_desc_default();
        desc.model = SHD_MODEL_LAMBERT;
        desc.opacity = 0.3f + 0.05f * (float)i;
        desc.blend = i % 3 == 0 ? SHD_BLEND_OPAQUE : i % 3 == 1 ? SHD_BLEND_WEIGHTED : SHD_BLEND_SORTED;
        shd_material_release(t.scene.material[i]);
        shd_assert_ok(shd_material_create(context, &desc, &t.scene.material[i]));
    }
    for (i = 0; i < SHD_SCENE_DRAWS; ++i) t.scene.draw[i].material = t.scene.material[i % 8];
    want = render(&t, DEFAULT_PASS);
    for (i = 0; i < SIZES; ++i) assert_true(render(&t, k_sizes[i]) == want);
    for (i = 0; i < SHD_SCENE_DRAWS; ++i) t.scene.draw[i].material = t.scene.material[1 + i % 2]; /* no others */
    want = render(&t, DEFAULT_PASS);
    for (i = 0; i < SIZES; ++i) assert_true(render(&t, k_sizes[i]) == want);
    close_stage(&t);
    shd_context_release(context);
}

/* Hidden samples are counted by comparing depths; draws of the visibility buffer compare with the depth of the
 * previous triangle. */
static void test_hidden(void **state)
{
    shd_context *context = NULL;
    struct stage t;
    uint64_t want, hidden;
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    open_stage(&t, context, 4, 60);
    for (i = 0; i < SHD_SCENE_DRAWS; ++i) t.scene.draw[i].material = i % 3 ? t.scene.material[7] : NULL;
    want = render(&t, DEFAULT_PASS);
    hidden = t.scene.stats.hidden_sample_count;
    assert_true(hidden > 0);
    for (i = 0; i < SIZES; ++i) {
        assert_true(render(&t, k_sizes[i]) == want);
        assert_true(t.scene.stats.hidden_sample_count == hidden);
    }
    close_stage(&t);
    shd_context_release(context);
}

/* The painter's algorithm has one pass; supersampled frames have several passes for each block. */
static void test_modes(void **state)
{
    shd_context *context = NULL;
    struct stage t;
    uint64_t want;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    open_stage(&t, context, 2, 40);
    t.scene.desc.visibility = SHD_VISIBILITY_PAINTER;
    want = render(&t, DEFAULT_PASS);
    assert_true(render(&t, 1024) == want);
    t.scene.desc.visibility = SHD_VISIBILITY_DEPTH;
    assert_true(render(&t, 1024) != want);
    t.scene.desc.supersampling = 6;
    want = render(&t, DEFAULT_PASS);
    assert_true(render(&t, 5000) == want);
    close_stage(&t);
    shd_context_release(context);
}

static uint64_t hash_on(const shd_context_desc *desc, uint32_t pass_triangles)
{
    shd_context *context = NULL;
    struct stage t;
    uint64_t hash;
    shd_assert_ok(shd_context_create(desc, &context));
    open_stage(&t, context, 4, 48);
    hash = render(&t, pass_triangles);
    close_stage(&t);
    shd_context_release(context);
    return hash;
}

static void test_workers_and_targets(void **state)
{
    const uint64_t want = hash_on(NULL, DEFAULT_PASS);
    shd_context_desc desc;
    uint32_t workers;
    int simd;
    (void)state;
    for (workers = 1; workers <= 16; workers *= 4) {
        shd_pool pool = {1, SHD_POOL_RANDOM, 5};
        pool.worker_count = workers;
        desc = shd_pool_context_desc(&pool);
        assert_true(hash_on(&desc, 4096) == want);
    }
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context *context = NULL;
        desc = shd_context_desc_default();
        desc.simd = (shd_simd)simd;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        shd_context_release(context);
        assert_true(hash_on(&desc, 3000) == want);
    }
}

static void test_progress(void **state)
{
    shd_watcher w = {0, 0, 0, 0.0f};
    shd_context *context = NULL;
    struct stage t;
    int total, at;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    open_stage(&t, context, 4, 48);
    t.scene.desc.progress.report = shd_watch;
    t.scene.desc.progress.user_data = &w;
    (void)render(&t, 1024);
    assert_int_equal(w.mistakes, 0);
    assert_true(w.latest == 1.0f);
    total = w.reports;
    assert_true(total > 10 * 12); /* tiles of 203 x 151 */
    for (at = 1; at <= total; at += SHD_IS_SANITIZED ? 151 : 51) {
        memset(&w, 0, sizeof w);
        w.cancel_at = at;
        shd_assert_result("cancel", shd_render(context, &t.scene.desc), SHD_ERROR_CANCELLED, "render.progress");
        assert_int_equal(w.reports, at);
        assert_true(t.scene.stats.triangle_count == 0);
    }
    close_stage(&t);
    shd_context_release(context);
}

static void test_faults(void **state)
{
    shd_fault_allocator memory;
    shd_context_desc desc = shd_fault_context_desc(&memory);
    shd_context *context = NULL;
    struct stage t;
    const size_t step = SHD_IS_SANITIZED ? 3 : 1;
    uint64_t want;
    size_t n, before;
    (void)state;
    memset(&memory, 0, sizeof memory);
    shd_assert_ok(shd_context_create(&desc, &context));
    open_stage(&t, context, 2, 24);
    want = render(&t, 1024);
    before = memory.live_bytes;
    for (n = 1;; n += n < 200 ? step : 41) {
        shd_result result;
        shd_fault_arm(&memory, n, n % 2 == 0);
        result = shd_render(context, &t.scene.desc);
        shd_fault_arm(&memory, 0, 0);
        assert_int_equal(memory.live_bytes, before);
        if (result == SHD_OK) break;
        shd_assert_result("render", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
    }
    assert_true(n > 300);
    assert_true(render(&t, 1024) == want);
    close_stage(&t);
    shd_context_release(context);
    shd_assert_all_freed("faults", &memory);
}

/* Memory bound of render.h, for one worker. */
static uint64_t promised_bytes(uint64_t pass_triangles, uint64_t samples, uint64_t pixels, uint64_t draws)
{
    return 512 * pass_triangles + 24 * samples * pixels + 256 * draws + (8u << 20);
}

struct memory_case {
    const char *name;
    sheet_order order;
    uint32_t samples, pass_triangles;
};
static const struct memory_case k_memory[] = {
    {"memory/rows", ROWS, 1, 65536},
    {"memory/shuffled", SHUFFLED, 1, 65536},
    {"memory/rows/samples_4", ROWS, 4, 65536},
    {"memory/shuffled/small", SHUFFLED, 1, 16384},
};
enum { MEMORY = sizeof k_memory / sizeof k_memory[0] };

static void test_memory(void **state)
{
    const struct memory_case *c = (const struct memory_case *)*state;
    shd_fault_allocator memory;
    shd_context_desc desc = shd_fault_context_desc(&memory);
    shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
    shd_camera camera = shd_camera_default();
    shd_context *context = NULL;
    shd_framebuffer *target = NULL;
    shd_material_desc material_desc = shd_material_desc_default();
    shd_material *material = NULL;
    shd_render_desc frame = shd_render_desc_default();
    shd_render_stats stats = shd_render_stats_default();
    shd_draw draw = shd_draw_default();
    shd_mesh *mesh;
    uint64_t whole, hash;
    size_t before;
    memset(&memory, 0, sizeof memory);
    shd_assert_ok(shd_context_create(&desc, &context));
    mesh = make_sheet(context, 708, c->order, 0);
    framebuffer.width = framebuffer.height = 512;
    framebuffer.sample_count = c->samples;
    shd_assert_ok(shd_framebuffer_create(context, &framebuffer, &target));
    shd_assert_ok(shd_material_create(context, &material_desc, &material));
    shd_assert_ok(shd_view_from_camera(&camera, &frame.view));
    draw.mesh = mesh;
    draw.material = material;
    frame.framebuffer = target;
    frame.draws = &draw;
    frame.draw_count = 1;
    frame.stats = &stats;
    shd_assert_ok(shd_render(context, &frame));
    hash = shd_hash_framebuffer(target);
    whole = stats.scratch_bytes;
    if (c->pass_triangles) frame.pass_triangles = c->pass_triangles;
    memory.peak_bytes = before = memory.live_bytes;
    shd_assert_ok(shd_render(context, &frame));
    assert_true(shd_hash_framebuffer(target) == hash);
    print_message("%llu bytes in one pass, %llu in passes\n", (unsigned long long)whole,
                  (unsigned long long)stats.scratch_bytes);
    assert_true(stats.triangle_count == 2 * 708 * 708);
    assert_true(memory.peak_bytes - before == stats.scratch_bytes);
    assert_true(stats.scratch_bytes < promised_bytes(c->pass_triangles, c->samples, 512 * 512, 1));
    assert_true(stats.scratch_bytes < whole / 2);
    shd_mesh_release(mesh);
    shd_material_release(material);
    shd_framebuffer_release(target);
    shd_context_release(context);
    shd_assert_all_freed(c->name, &memory);
}

int main(void)
{
    static struct CMUnitTest tests[BITS + MEMORY + 8];
    size_t n = 0, i;
    for (i = 0; i < BITS; ++i) {
        tests[n++] = (struct CMUnitTest){k_bits[i].name, test_bits, NULL, NULL, (void *)(uintptr_t)&k_bits[i]};
    }
    for (i = 0; i < MEMORY; ++i) {
        tests[n++] = (struct CMUnitTest){k_memory[i].name, test_memory, NULL, NULL, (void *)(uintptr_t)&k_memory[i]};
    }
    tests[n++] = (struct CMUnitTest){"unordered", test_unordered, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"hidden", test_hidden, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"modes", test_modes, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"workers_and_targets", test_workers_and_targets, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"progress", test_progress, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"faults", test_faults, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_passes", tests, n, NULL, NULL);
}
