/* SPDX-License-Identifier: MIT */
/* A call with each of its allocations failing in turn, alone and with all later ones, with one worker and with four. A
 * failed call gives no object and keeps no memory; the same call without the fault gives the bits of the first one. */
#ifndef SHD_TESTS_CALL_STAGE_H
#define SHD_TESTS_CALL_STAGE_H

#include "support/fault_allocator.h"
#include "support/rows.h"
#include "support/scene.h"

/* Memory and objects of a case; every call is made in `context`. */
struct stage {
    shd_fault_allocator memory;
    shd_context *context;
    shd_scene scene;
    shd_texture *heights;
    shd_sampler *sampler[SHD_FILTER_EXACT + 1]; /* one for each filter */
    shd_light *light;
    shd_mesh *mesh; /* with adjacency and tangents */
    unsigned char texels[4 * 64 * 64 * 4];
    float columns[4][20000];
    uint64_t hash; /* hash of the result of the last call that succeeded */
};

struct call_case {
    const char *name;
    shd_result (*call)(struct stage *s);
};
/* Four workers that run one after another on the calling thread. */
static shd_result turns_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    uint32_t i;
    (void)user_data;
    for (i = 0; i < count; ++i) task(count - 1 - i, i % 4, task_data);
    return SHD_OK;
}

static void open_stage(struct stage *s, int workers)
{
    shd_context_desc desc = shd_fault_context_desc(&s->memory);
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_sampler_desc sampler = shd_sampler_desc_default();
    shd_shape_desc shape = shd_shape_desc_default();
    uint32_t bits = 9;
    size_t i;
    memset(s, 0, sizeof *s);
    if (workers > 1) {
        desc.worker_count = 0;
        desc.executor.parallel_for = turns_parallel_for;
        desc.executor.worker_count = (uint32_t)workers;
    }
    for (i = 0; i < sizeof s->texels; ++i)
        s->texels[i] = (unsigned char)(shd_noise(&bits) >> 26); /* finite as floats */
    for (i = 0; i < 20000; ++i) s->columns[3][i] = (float)(shd_noise(&bits) >> 8) / 16777216.0f;
    shd_assert_ok(shd_context_create(&desc, &s->context));
    shd_scene_open(&s->scene, SHD_SCENE_SMALL, s->context);
    texture_desc.format = SHD_FORMAT_R8;
    texture_desc.width = texture_desc.height = 16;
    texture_desc.texels = s->texels;
    texture_desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(s->context, &texture_desc, &s->heights));
    sampler.cubic = SHD_CUBIC_B_SPLINE;
    for (i = 0; i <= SHD_FILTER_EXACT; ++i) {
        sampler.filter = (shd_filter)i;
        shd_assert_ok(shd_sampler_create(s->context, &sampler, &s->sampler[i]));
    }
    shd_assert_ok(shd_light_create(s->context, NULL, &s->light));
    shape.kind = SHD_SHAPE_BOX;
    shd_assert_ok(shd_mesh_create_shape(s->context, &shape, SHD_MESH_ADJACENCY | SHD_MESH_TANGENTS, &s->mesh));
}

static void close_stage(struct stage *s)
{
    int i;
    shd_mesh_release(s->mesh);
    shd_light_release(s->light);
    for (i = 0; i <= SHD_FILTER_EXACT; ++i) shd_sampler_release(s->sampler[i]);
    shd_texture_release(s->heights);
    shd_scene_close(&s->scene);
    shd_context_release(s->context);
    shd_assert_all_freed("stage", &s->memory);
}

static void test_call(void **state)
{
    const struct call_case *c = (const struct call_case *)*state;
    static struct stage s;
    uint64_t want = 0;
    size_t points = 0;
    int workers, persistent;
    for (workers = 1; workers <= 4; workers += 3) {
        for (persistent = 0; persistent < 2; ++persistent) {
            size_t n, idle;
            const size_t step = SHD_IS_SANITIZED ? 2 : 1; /* one worker has the odd points, four have the even ones */
            if (SHD_IS_SANITIZED && persistent != (workers > 1)) continue;
            open_stage(&s, workers);
            shd_assert_ok(c->call(&s));
            if (!want) want = s.hash;
            idle = s.memory.live_bytes;
            for (n = SHD_IS_SANITIZED ? 1 + (size_t)persistent : 1; n < 5000; n += step) {
                shd_result result;
                s.hash = want;
                shd_fault_arm(&s.memory, n, persistent);
                result = c->call(&s);
                if (s.memory.calls < n) {
                    shd_assert_result(c->name, result, SHD_OK, "");
                    break;
                }
                shd_fault_arm(&s.memory, 0, 0);
                shd_assert_result(c->name, result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
                assert_int_equal(s.memory.live_bytes, idle);
                shd_assert_ok(c->call(&s));
                assert_true(s.hash == want);
                assert_int_equal(s.memory.live_bytes, idle);
                ++points;
            }
            assert_true(n < 5000);
            shd_fault_arm(&s.memory, 0, 0);
            close_stage(&s);
        }
    }
    print_message("%s: %zu allocations failed\n", c->name, points);
}

#endif
