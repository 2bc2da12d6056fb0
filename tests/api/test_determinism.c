/* SPDX-License-Identifier: MIT */
/* Results have the same bits for any SIMD target, worker count, scheduling order and run, and these bits have the
 * stored hashes. */
#define _POSIX_C_SOURCE 200809L
#include "support/bake_scene.h"
#include "support/block_hash.h"
#include "support/direction_hash.h"
#include "support/environment_hash.h"
#include "support/lookup_hash.h"
#include "support/pixel_hash.h"
#include "support/pool.h"
#include "support/scene.h"
#include "support/shadow_hash.h"
#include "support/simd.h"
#include "support/solid_hash.h"
#include "support/volume_scene.h"

static const char *const k_kind_names[SHD_SCENE_KINDS] = {"mixed", "floor", "lit",   "glass",
                                                          "small", "moved", "lines", "surface"};

/* The thread sanitizer skips most counts, the stored hashes, and SSE4, whose threads are those of AVX2. The address
 * sanitizer looks for wrong reads and writes, so once is enough. */
#if defined(__SANITIZE_THREAD__)
enum { HAS_TSAN = 1, k_runs = 2 };
static const uint32_t k_workers[] = {3, 8};
#elif defined(__SANITIZE_ADDRESS__)
enum { HAS_TSAN = 0, k_runs = 1 };
static const uint32_t k_workers[] = {1, 8};
#else
enum { HAS_TSAN = 0, k_runs = 3 };
static const uint32_t k_workers[] = {1, 2, 3, 8, 16};
#endif
enum { k_worker_counts = sizeof k_workers / sizeof k_workers[0] };

/* Opens a scene in a context made from `desc`, renders it k_runs times, and compares with `want`. */
static void expect_scene(const char *what, const shd_context_desc *desc, shd_scene_kind kind, uint64_t want)
{
    shd_context *context = NULL;
    shd_scene scene;
    int run;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_scene_open(&scene, kind, context);
    for (run = 0; run < k_runs; ++run) {
        const uint64_t got = shd_scene_render(&scene);
        if (got != want) {
            fail_msg("%s, scene %s, run %d on %s: hash %016llx, want %016llx", what, k_kind_names[kind], run,
                     shd_context_get_simd_target(context), (unsigned long long)got, (unsigned long long)want);
        }
    }
    shd_scene_close(&scene);
    shd_context_release(context);
}

/* The threads of one target are those of all; under the sanitizer each target takes a minute. */
static int can_run(int simd)
{
    const int skipped = HAS_TSAN && simd != SHD_SIMD_AVX2 && shd_simd_can_run(SHD_SIMD_AVX2);
    return shd_simd_can_run(simd) && !skipped;
}

static void test_targets_and_workers(void **state)
{
    const uint64_t mixed = shd_scene_reference(SHD_SCENE_MIXED), glass = shd_scene_reference(SHD_SCENE_GLASS);
    const uint64_t moved = shd_scene_reference(SHD_SCENE_MOVED), lines = shd_scene_reference(SHD_SCENE_LINES);
    const uint64_t surface = shd_scene_reference(SHD_SCENE_SURFACE);
    int simd, targets = 0;
    (void)state;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        size_t i;
        if (!can_run(simd)) continue;
        ++targets;
        for (i = 0; i < k_worker_counts; ++i) {
            shd_context_desc desc = shd_context_desc_default();
            desc.simd = (shd_simd)simd;
            desc.worker_count = k_workers[i];
            expect_scene("built-in executor", &desc, SHD_SCENE_MIXED, mixed);
            expect_scene("built-in executor", &desc, SHD_SCENE_GLASS, glass);
            expect_scene("built-in executor", &desc, SHD_SCENE_MOVED, moved);
            expect_scene("built-in executor", &desc, SHD_SCENE_LINES, lines);
            expect_scene("built-in executor", &desc, SHD_SCENE_SURFACE, surface);
        }
    }
    print_message("%d targets x %d worker counts x %d runs\n", targets, k_worker_counts, k_runs);
    assert_true(targets >= 1);
}

static void test_orders(void **state)
{
    const uint64_t mixed = shd_scene_reference(SHD_SCENE_MIXED), glass = shd_scene_reference(SHD_SCENE_GLASS);
    const uint64_t moved = shd_scene_reference(SHD_SCENE_MOVED), lines = shd_scene_reference(SHD_SCENE_LINES);
    const uint64_t surface = shd_scene_reference(SHD_SCENE_SURFACE);
    int order;
    size_t i;
    (void)state;
    for (order = SHD_POOL_FORWARD; order <= SHD_POOL_RANDOM; ++order) {
        for (i = 0; i < k_worker_counts; ++i) {
            shd_pool pool;
            shd_context_desc desc;
            pool.worker_count = k_workers[i];
            pool.order = (shd_pool_order)order;
            pool.seed = (uint32_t)i;
            desc = shd_pool_context_desc(&pool);
            expect_scene("executor of the host", &desc, SHD_SCENE_MIXED, mixed);
            expect_scene("executor of the host", &desc, SHD_SCENE_GLASS, glass);
            expect_scene("executor of the host", &desc, SHD_SCENE_MOVED, moved);
            expect_scene("executor of the host", &desc, SHD_SCENE_LINES, lines);
            expect_scene("executor of the host", &desc, SHD_SCENE_SURFACE, surface);
        }
    }
}

/* Every draw of the mixed scene must be visible; otherwise the hashes above do not cover it. */
static void test_scene_is_whole(void **state)
{
    shd_context *context = NULL;
    shd_scene scene;
    shd_draw others[SHD_SCENE_DRAWS];
    uint64_t whole;
    size_t count, draw;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&scene, SHD_SCENE_MIXED, context);
    (void)shd_scene_render(&scene);
    whole = shd_hash_framebuffer(scene.framebuffer);
    assert_true(scene.stats.triangle_count > 4000);
    assert_true(scene.stats.nonfinite_triangle_count > 10);
    assert_true(scene.stats.clipped_triangle_count >= 2);
    assert_true(scene.stats.culled_triangle_count > 100);
    assert_true(scene.stats.rasterized_triangle_count > 1000);
    assert_int_equal(scene.stats.nonfinite_fragment_count, 0);
    assert_int_equal(scene.stats.triangle_count,
                     scene.stats.nonfinite_triangle_count + scene.stats.outside_triangle_count +
                         scene.stats.culled_triangle_count + scene.stats.empty_triangle_count +
                         scene.stats.rasterized_triangle_count);
    count = scene.desc.draw_count;
    for (draw = 0; draw < count; ++draw) {
        scene.desc.draws = &scene.draw[draw];
        scene.desc.draw_count = 1;
        (void)shd_scene_render(&scene);
        if (scene.stats.fragment_count < 20)
            fail_msg("draw %zu: %llu fragments", draw, (unsigned long long)scene.stats.fragment_count);
        memcpy(others, scene.draw, count * sizeof others[0]);
        others[draw].cull = SHD_CULL_NONE;
        others[draw].instances = NULL;
        others[draw].compare = SHD_COMPARE_NEVER;
        scene.desc.draws = others;
        scene.desc.draw_count = count;
        (void)shd_scene_render(&scene);
        if (shd_hash_framebuffer(scene.framebuffer) == whole) fail_msg("draw %zu changes no pixel of the frame", draw);
    }
    shd_scene_close(&scene);
    shd_context_release(context);
}

/* Compares a hash on every target with up to `counts` of the worker counts. */
static void expect_hash(const char *what, uint64_t (*hash)(const shd_context_desc *), size_t counts)
{
    const uint64_t want = hash(NULL);
    int simd;
    size_t i;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        if (!can_run(simd)) continue;
        for (i = 0; i < counts && i < k_worker_counts; ++i) {
            shd_context_desc desc = shd_context_desc_default();
            uint64_t got;
            desc.simd = (shd_simd)simd;
            desc.worker_count = k_workers[i];
            got = hash(&desc);
            if (got != want) {
                fail_msg("%s, SIMD target %d, %u workers: hash %016llx, want %016llx", what, simd, k_workers[i],
                         (unsigned long long)got, (unsigned long long)want);
            }
        }
    }
}

static void test_lookups(void **state)
{
    (void)state;
    expect_hash("lookups", shd_lookup_hash, k_worker_counts);
}

static void test_blocks(void **state)
{
    (void)state;
    expect_hash("blocks", shd_block_hash, 2);
}

static void test_filters(void **state)
{
    uint64_t want[k_filter_cases], got[k_filter_cases];
    int simd;
    size_t i;
    (void)state;
    shd_filter_hashes(NULL, want);
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        if (!can_run(simd)) continue;
        desc.simd = (shd_simd)simd;
        desc.worker_count = 2;
        shd_filter_hashes(&desc, got);
        for (i = 0; i < k_filter_cases; ++i) {
            if (got[i] != want[i]) {
                fail_msg("filter case %zu, format %d: differ on SIMD target %d", i / k_filter_format_count,
                         (int)k_filter_formats[i % k_filter_format_count], simd);
            }
        }
    }
}

static void test_fast(void **state)
{
    uint64_t want[k_fast_cases], got[k_fast_cases];
    int simd;
    size_t i;
    (void)state;
    shd_fast_hashes(NULL, k_filter_lookups, want);
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        if (!can_run(simd)) continue;
        desc.simd = (shd_simd)simd;
        desc.worker_count = (uint32_t)(1 + simd % 3);
        shd_fast_hashes(&desc, (size_t)(61 + 100 * simd), got);
        for (i = 0; i < k_fast_cases; ++i) {
            if (got[i] != want[i]) fail_msg("case %zu: differs on SIMD target %d", i, simd);
        }
    }
}

static void test_shadows(void **state)
{
    (void)state;
    expect_hash("shadows", shd_shadow_hash, 3);
}

static void test_pixels(void **state)
{
    (void)state;
    expect_hash("interleaved colour", shd_pixel_hash, 3);
}

static void test_environment(void **state)
{
    (void)state;
    expect_hash("frames in an environment", shd_environment_hash, 3);
}

static void test_textured(void **state)
{
    (void)state;
    expect_hash("frames of one texture", shd_textured_hash, 3);
}

static void test_parallel(void **state)
{
    (void)state;
    expect_hash("frames without perspective", shd_parallel_hash, 3);
}

static void test_texture3d(void **state)
{
    (void)state;
    expect_hash("lookups in 3D textures", shd_texture3d_hash, 2);
}

static void test_volumes(void **state)
{
    (void)state;
    expect_hash("frames with volumes", shd_volume_hash, 3);
}

static void test_bakes(void **state)
{
    (void)state;
    expect_hash("bakes", shd_bake_hash, 3);
}

static void test_occlusion(void **state)
{
    (void)state;
    expect_hash("occlusion", shd_occlusion_hash, 2);
}

static void test_solid(void **state)
{
    (void)state;
    expect_hash("solid textures", shd_solid_hash, 3);
}

static void test_directions(void **state)
{
    (void)state;
    expect_hash("directions", shd_direction_hash, 3);
}

/* The stored hashes: lines "<name> <hash>", # starts a comment. */
struct golden_row {
    const char *name;
    uint64_t hash;
};
enum {
    MIXED,
    FLOOR,
    LIT,
    GLASS,
    MOVED,
    LINES,
    SURFACE,
    LOOKUPS,
    FILTERS,
    PROFILES,
    SHADOWS,
    PIXELS,
    FAST,
    EXACT,
    TEXTURED,
    PARALLEL,
    DIRECTIONS,
    ENVIRONMENT,
    SOLID,
    TEXTURE3D,
    VOLUME,
    BAKE,
    OCCLUSION,
    BLOCKS,
    k_golden_count
};
static struct golden_row k_golden[k_golden_count] = {
    {"mixed", 0},   {"floor", 0},     {"lit", 0},      {"glass", 0},    {"moved", 0},      {"lines", 0},
    {"surface", 0}, {"lookups", 0},   {"filters", 0},  {"profiles", 0}, {"shadows", 0},    {"pixels", 0},
    {"fast", 0},    {"exact", 0},     {"textured", 0}, {"parallel", 0}, {"directions", 0}, {"environment", 0},
    {"solid", 0},   {"texture3d", 0}, {"volume", 0},   {"bake", 0},     {"occlusion", 0},  {"blocks", 0}};

static void measure_golden(void)
{
    uint64_t filters[k_filter_cases], fast[k_fast_cases];
    const uint64_t *const profiled = filters + k_plain_cases, *const exact = profiled + k_profiled_cases;
    k_golden[MIXED].hash = shd_scene_reference(SHD_SCENE_MIXED);
    k_golden[FLOOR].hash = shd_scene_reference(SHD_SCENE_FLOOR);
    k_golden[LIT].hash = shd_scene_reference(SHD_SCENE_LIT);
    k_golden[GLASS].hash = shd_scene_reference(SHD_SCENE_GLASS);
    k_golden[MOVED].hash = shd_scene_reference(SHD_SCENE_MOVED);
    k_golden[LINES].hash = shd_scene_reference(SHD_SCENE_LINES);
    k_golden[SURFACE].hash = shd_scene_reference(SHD_SCENE_SURFACE);
    k_golden[LOOKUPS].hash = shd_lookup_hash(NULL);
    shd_filter_hashes(NULL, filters);
    k_golden[FILTERS].hash = shd_hash(SHD_HASH_START, filters, k_plain_cases * sizeof *filters);
    k_golden[PROFILES].hash = shd_hash(SHD_HASH_START, profiled, k_profiled_cases * sizeof *filters);
    k_golden[EXACT].hash = shd_hash(SHD_HASH_START, exact, k_plain_cases * sizeof *filters);
    k_golden[SHADOWS].hash = shd_shadow_hash(NULL);
    k_golden[PIXELS].hash = shd_pixel_hash(NULL);
    shd_fast_hashes(NULL, k_filter_lookups, fast);
    k_golden[FAST].hash = shd_hash(SHD_HASH_START, fast, sizeof fast);
    k_golden[TEXTURED].hash = shd_textured_hash(NULL);
    k_golden[PARALLEL].hash = shd_parallel_hash(NULL);
    k_golden[DIRECTIONS].hash = shd_direction_hash(NULL);
    k_golden[ENVIRONMENT].hash = shd_environment_hash(NULL);
    k_golden[SOLID].hash = shd_solid_hash(NULL);
    k_golden[TEXTURE3D].hash = shd_texture3d_hash(NULL);
    k_golden[VOLUME].hash = shd_volume_hash(NULL);
    k_golden[BAKE].hash = shd_bake_hash(NULL);
    k_golden[OCCLUSION].hash = shd_occlusion_hash(NULL);
    k_golden[BLOCKS].hash = shd_block_hash(NULL);
}

static void test_golden(void **state)
{
    FILE *file;
    char line[256];
    size_t found = 0, i;
    (void)state;
    if (HAS_TSAN) skip();
    file = fopen(SHD_GOLDEN_DIR "/hashes.txt", "r");
    if (!file) fail_msg("cannot open %s", SHD_GOLDEN_DIR "/hashes.txt");
    measure_golden();
    while (fgets(line, sizeof line, file)) {
        char name[32];
        unsigned long long hash;
        if (line[0] == '#' || sscanf(line, "%31s %llx", name, &hash) != 2) continue;
        for (i = 0; i < k_golden_count; ++i) {
            if (strcmp(name, k_golden[i].name)) continue;
            ++found;
            if (k_golden[i].hash != hash) {
                fail_msg("%s: hash %016llx, stored %016llx", name, (unsigned long long)k_golden[i].hash, hash);
            }
        }
    }
    fclose(file);
    assert_int_equal(found, k_golden_count);
}

/* `test_api_determinism --hashes` prints the lines of tests/golden/hashes.txt. */
static int print_golden(void)
{
    size_t i;
    measure_golden();
    for (i = 0; i < k_golden_count; ++i) {
        printf("%-8s %016llx\n", k_golden[i].name, (unsigned long long)k_golden[i].hash);
    }
    return 0;
}

int main(int argc, char **argv)
{
    static const struct CMUnitTest k_tests[] = {
        {"scene_is_whole", test_scene_is_whole, NULL, NULL, NULL},
        {"targets_and_workers", test_targets_and_workers, NULL, NULL, NULL},
        {"orders", test_orders, NULL, NULL, NULL},
        {"lookups", test_lookups, NULL, NULL, NULL},
        {"filters", test_filters, NULL, NULL, NULL},
        {"fast", test_fast, NULL, NULL, NULL},
        {"shadows", test_shadows, NULL, NULL, NULL},
        {"environment", test_environment, NULL, NULL, NULL},
        {"pixels", test_pixels, NULL, NULL, NULL},
        {"textured", test_textured, NULL, NULL, NULL},
        {"parallel", test_parallel, NULL, NULL, NULL},
        {"solid", test_solid, NULL, NULL, NULL},
        {"directions", test_directions, NULL, NULL, NULL},
        {"texture3d", test_texture3d, NULL, NULL, NULL},
        {"volumes", test_volumes, NULL, NULL, NULL},
        {"bakes", test_bakes, NULL, NULL, NULL},
        {"occlusion", test_occlusion, NULL, NULL, NULL},
        {"blocks", test_blocks, NULL, NULL, NULL},
        {"golden", test_golden, NULL, NULL, NULL},
    };
    if (argc > 1 && strcmp(argv[1], "--hashes") == 0) return print_golden();
    return _cmocka_run_group_tests("api.determinism", k_tests, sizeof k_tests / sizeof k_tests[0], NULL, NULL);
}
