/* SPDX-License-Identifier: MIT */
/* Working memory of frames: a loop of equal frames allocates nothing, and what the context keeps can be returned. */
#include "support/fault_allocator.h"
#include "support/scene.h"

enum { FRAMES = 4 };

static const char *const k_scenes[] = {"steady/mixed", "steady/floor", "steady/lit",   "steady/glass",
                                       "steady/small", "steady/moved", "steady/lines", "steady/surface"};

static shd_context *open_context(shd_fault_allocator *memory)
{
    shd_context *context = NULL;
    shd_context_desc desc = shd_fault_context_desc(memory);
    memset(memory, 0, sizeof *memory);
    desc.flags = SHD_CONTEXT_NONE;
    shd_assert_ok(shd_context_create(&desc, &context));
    return context;
}

static void test_steady(void **state)
{
    const size_t kind = (size_t)((const char *const *)*state - k_scenes);
    shd_fault_allocator memory;
    shd_context *context = open_context(&memory);
    const uint64_t want = shd_scene_reference((shd_scene_kind)kind);
    shd_scene s;
    size_t before;
    int i;
    shd_scene_open(&s, (shd_scene_kind)kind, context);
    before = memory.live_bytes;
    assert_true(shd_scene_render(&s) == want);
    assert_true(memory.live_bytes > before);
    memory.calls = 0;
    for (i = 0; i < FRAMES; ++i) assert_true(shd_scene_render(&s) == want);
    assert_int_equal(memory.calls, 0);
    shd_context_trim(context);
    assert_int_equal(memory.live_bytes, before);
    assert_true(shd_scene_render(&s) == want);
    shd_scene_close(&s);
    shd_context_release(context);
    shd_assert_all_freed(k_scenes[kind], &memory);
}

static void test_modes(void **state)
{
    static const struct {
        uint32_t supersampling, pass_triangles;
        shd_visibility visibility;
    } modes[] = {
        {0, 1024, SHD_VISIBILITY_DEPTH},
        {3, 0, SHD_VISIBILITY_DEPTH},
        {0, 0, SHD_VISIBILITY_PAINTER},
        {0, 0, SHD_VISIBILITY_NEWELL},
    };
    shd_fault_allocator memory;
    shd_context *context = open_context(&memory);
    shd_scene s;
    size_t i, k;
    (void)state;
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    for (i = 0; i < sizeof modes / sizeof modes[0]; ++i) {
        s.desc.supersampling = modes[i].supersampling ? modes[i].supersampling : 1;
        s.desc.pass_triangles = modes[i].pass_triangles ? modes[i].pass_triangles : 1u << 21;
        s.desc.visibility = modes[i].visibility;
        shd_assert_ok(shd_render(context, &s.desc));
        memory.calls = 0;
        for (k = 0; k < FRAMES; ++k) shd_assert_ok(shd_render(context, &s.desc));
        if (memory.calls) fail_msg("mode %zu: %zu allocations", i, memory.calls);
    }
    shd_scene_close(&s);
    shd_context_release(context);
    shd_assert_all_freed("modes", &memory);
}

/* A frame that the host has no memory for leaves nothing behind, and the next one is whole. */
static void test_no_memory(void **state)
{
    shd_fault_allocator memory;
    shd_context *context = open_context(&memory);
    const uint64_t want = shd_scene_reference(SHD_SCENE_SMALL);
    shd_scene s;
    size_t n, before;
    (void)state;
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    before = memory.live_bytes;
    for (n = 1;; ++n) {
        shd_result result;
        shd_fault_arm(&memory, n, 1);
        result = shd_render(context, &s.desc);
        shd_fault_arm(&memory, 0, 0);
        if (result == SHD_OK) break;
        shd_assert_result("render", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        shd_context_trim(context);
        assert_int_equal(memory.live_bytes, before);
    }
    assert_true(n > 4);
    assert_true(shd_scene_render(&s) == want);
    shd_scene_close(&s);
    shd_context_release(context);
    shd_assert_all_freed("no_memory", &memory);
}

static void test_trim_nothing(void **state)
{
    shd_context *context = NULL;
    (void)state;
    shd_context_trim(NULL);
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_context_trim(context);
    shd_context_trim(context);
    shd_context_release(context);
}

int main(void)
{
    static struct CMUnitTest tests[SHD_SCENE_KINDS + 3];
    size_t n = 0;
    for (; n < SHD_SCENE_KINDS; ++n) {
        tests[n] = (struct CMUnitTest){k_scenes[n], test_steady, NULL, NULL, (void *)(uintptr_t)&k_scenes[n]};
    }
    tests[n++] = (struct CMUnitTest){"modes", test_modes, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"no_memory", test_no_memory, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"trim_nothing", test_trim_nothing, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_memory", tests, n, NULL, NULL);
}
