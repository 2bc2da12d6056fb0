/* SPDX-License-Identifier: MIT */
/* Many threads on one context: sampling, rendering, creating, releasing. Results have the bits of one thread,
 * nothing leaks, and a thread sanitizer reports nothing. oneTBB is not instrumented, so under a sanitizer only the
 * host's executor runs. */
#define _POSIX_C_SOURCE 200809L
#include "support/locked_allocator.h"
#include "support/pool.h"
#include "support/scene.h"

#if defined(__SANITIZE_THREAD__)
#define HAS_TSAN 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define HAS_TSAN 1
#endif
#endif
#ifndef HAS_TSAN
#define HAS_TSAN 0
#endif

enum { k_threads = 8, k_most_threads = 64, k_lookups = 3001, k_variants = 3 };

/* Data that the threads of a test share. */
struct stage {
    struct locked_memory locked;
    shd_pool pool;
    shd_context *context;
    shd_scene scene;
    uint64_t want_frame, want_lookups, want_variant[k_variants];
    uint32_t threads;
    int rounds; /* rounds of each thread; more threads have fewer */
    pthread_barrier_t start;
};

/* One thread. A failed assertion there would end the process, so the thread counts mistakes. */
struct actor {
    struct stage *stage;
    void (*act)(struct actor *self);
    uint32_t index;
    int mistakes;
    pthread_t thread;
};

static uint64_t sample(const shd_texture *texture, const shd_sampler *sampler)
{
    float *columns = (float *)shd_scene_memory(5 * k_lookups * sizeof(float));
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels;
    uint64_t hash = 0;
    size_t i, c;
    memset(&texels, 0, sizeof texels);
    for (i = 0; i < k_lookups; ++i) {
        columns[i] = 0.003f * (float)i - 3.0f;
        columns[k_lookups + i] = 0.00001f * (float)i;
    }
    lookups.count = k_lookups;
    lookups.u.data = lookups.v.data = columns;
    lookups.dudx.data = lookups.dvdy.data = columns + k_lookups;
    for (c = 0; c < 3; ++c) texels.channel[c].data = columns + (2 + c) * k_lookups;
    if (shd_texture_sample(texture, sampler, &lookups, &texels) == SHD_OK) {
        hash = shd_hash(SHD_HASH_START, columns + 2 * k_lookups, 3 * k_lookups * sizeof(float));
    }
    free(columns);
    return hash;
}

/* Renders the shared scene with the settings of `frame` into the thread's own framebuffer. */
static uint64_t render_as(const shd_scene *scene, shd_render_desc frame, shd_context *context)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_render_stats stats = shd_render_stats_default();
    shd_framebuffer_info info = shd_framebuffer_info_default();
    shd_framebuffer *framebuffer = NULL;
    uint64_t hash = 0;
    if (shd_framebuffer_get_info(scene->framebuffer, &info) != SHD_OK) return 0;
    desc.sample_count = info.sample_count;
    desc.width = 100;
    desc.height = 70;
    desc.aovs = info.aovs;
    if (shd_framebuffer_create(context, &desc, &framebuffer) != SHD_OK) return 0;
    frame.framebuffer = framebuffer;
    frame.stats = &stats;
    if (shd_render(context, &frame) == SHD_OK) {
        hash = shd_hash_stats(shd_hash_framebuffer(framebuffer), &stats);
    }
    shd_framebuffer_release(framebuffer);
    return hash;
}

static uint64_t render(const shd_scene *scene, shd_context *context) { return render_as(scene, scene->desc, context); }

/* Renders in another way: in two passes, with many instances of one draw, supersampled, or with Newell's method. */
static uint64_t render_variant(const shd_scene *scene, shd_context *context, uint32_t variant)
{
    enum { k_copies = 70 }; /* each counts as 16 triangles or more */
    shd_render_desc frame = scene->desc;
    shd_draw draws[SHD_SCENE_DRAWS];
    float copies[k_copies][16];
    size_t i;
    memcpy(draws, frame.draws, frame.draw_count * sizeof draws[0]);
    for (i = 0; i < k_copies; ++i) memcpy(copies[i], draws[0].object_to_world, sizeof copies[i]);
    if (variant == 0) {
        draws[0].instances = copies[0];
        draws[0].instance_count = k_copies;
        frame.draws = draws;
        frame.pass_triangles = 1024;
    }
    if (variant == 1) frame.supersampling = 3;
    if (variant == 2) frame.visibility = SHD_VISIBILITY_NEWELL;
    return render_as(scene, frame, context);
}

static void open_stage(struct stage *stage, uint32_t threads, int use_pool, uint32_t workers)
{
    shd_context_desc desc = shd_context_desc_default();
    uint32_t i;
    memset(stage, 0, sizeof *stage);
    stage->threads = threads;
    stage->rounds = (HAS_TSAN ? 48 : 200) / (int)threads;
    if (stage->rounds == 0) stage->rounds = 1;
    stage->pool.worker_count = workers;
    stage->pool.order = SHD_POOL_RANDOM;
    if (use_pool) {
        desc = shd_pool_context_desc(&stage->pool);
    } else {
        desc.worker_count = workers;
    }
    pthread_mutex_init(&stage->locked.mutex, NULL);
    desc.allocator.allocate = locked_allocate;
    desc.allocator.free = locked_free;
    desc.allocator.user_data = &stage->locked;
    shd_assert_ok(shd_context_create(&desc, &stage->context));
    shd_scene_open(&stage->scene, SHD_SCENE_SMALL, stage->context);
    stage->want_frame = shd_scene_render(&stage->scene);
    assert_true(stage->want_frame == shd_scene_reference(SHD_SCENE_SMALL));
    stage->scene.desc.flags |= SHD_RENDER_COUNT_HIDDEN; /* one more count to compare */
    stage->want_frame = shd_scene_render(&stage->scene);
    assert_true(stage->scene.stats.hidden_sample_count > 0);
    stage->want_lookups = sample(stage->scene.texture[0], stage->scene.sampler[0]);
    assert_true(stage->want_lookups != 0); /* 0 = a call failed */
    for (i = 0; i < k_variants; ++i) {
        stage->want_variant[i] = render_variant(&stage->scene, stage->context, i);
        assert_true(stage->want_variant[i] != 0);
    }
}

static void close_stage(struct stage *stage)
{
    shd_scene_close(&stage->scene);
    shd_context_release(stage->context);
    shd_assert_all_freed("stage", &stage->locked.memory);
    pthread_mutex_destroy(&stage->locked.mutex);
}

static void *run_actor(void *argument)
{
    struct actor *self = (struct actor *)argument;
    pthread_barrier_wait(&self->stage->start);
    self->act(self);
    return NULL;
}

/* Runs acts[i % count] on thread i, and `between` on this thread; no thread may count a mistake. */
static void play(struct stage *stage, void (*const *acts)(struct actor *self), size_t count,
                 void (*between)(struct stage *stage))
{
    struct actor actors[k_most_threads];
    uint32_t i;
    assert_int_equal(pthread_barrier_init(&stage->start, NULL, stage->threads + 1), 0);
    for (i = 0; i < stage->threads; ++i) {
        actors[i].stage = stage;
        actors[i].act = acts[i % count];
        actors[i].index = i;
        actors[i].mistakes = 0;
        assert_int_equal(pthread_create(&actors[i].thread, NULL, run_actor, &actors[i]), 0);
    }
    pthread_barrier_wait(&stage->start);
    if (between) between(stage);
    for (i = 0; i < stage->threads; ++i) pthread_join(actors[i].thread, NULL);
    pthread_barrier_destroy(&stage->start);
    for (i = 0; i < stage->threads; ++i) {
        if (actors[i].mistakes) fail_msg("thread %u: %d mistakes", i, actors[i].mistakes);
    }
}

static void act_sample(struct actor *self)
{
    int round;
    for (round = 0; round < 4 * self->stage->rounds; ++round) {
        const shd_scene *scene = &self->stage->scene;
        self->mistakes += sample(scene->texture[0], scene->sampler[0]) != self->stage->want_lookups;
    }
}

static void act_render(struct actor *self)
{
    int round;
    for (round = 0; round < self->stage->rounds; ++round) {
        self->mistakes += render(&self->stage->scene, self->stage->context) != self->stage->want_frame;
    }
}

/* Makes and drops one object of every type. */
static void act_create(struct actor *self)
{
    int round;
    for (round = 0; round < self->stage->rounds; ++round) {
        shd_scene own;
        size_t step;
        memset(&own, 0, sizeof own);
        own.kind = SHD_SCENE_SMALL;
        own.context = self->stage->context;
        for (step = 0; step < SHD_SCENE_STEPS; ++step) self->mistakes += shd_scene_step(&own, step) != SHD_OK;
        shd_scene_close(&own);
    }
}

/* Updates texels of a texture of its own, and looks it up after each update. */
static void act_edit(struct actor *self)
{
    static const unsigned char k_texels[2][4] = {{1, 2, 3, 255}, {250, 130, 7, 8}};
    const shd_scene *s = &self->stage->scene;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_image image = shd_image_default();
    shd_texture *texture = NULL;
    unsigned char texels[32 * 32 * 4];
    uint64_t want[2] = {0, 0};
    int round;
    memset(texels, 77, sizeof texels);
    desc.format = image.format = SHD_FORMAT_RGBA8;
    desc.width = desc.height = 32;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    image.width = image.height = 1;
    self->mistakes += shd_texture_create(self->stage->context, &desc, &texture) != SHD_OK;
    for (round = 0; round < 4 * self->stage->rounds + 4; ++round) {
        uint64_t got;
        image.pixels = (void *)(uintptr_t)k_texels[round % 2];
        self->mistakes += shd_texture_update(texture, 0, 9, 9, &image) != SHD_OK;
        got = sample(texture, s->sampler[0]);
        if (round < 2) want[round] = got;
        self->mistakes += got == 0 || got != want[round % 2];
    }
    self->mistakes += want[0] == want[1];
    shd_texture_release(texture);
}

static void act_references(struct actor *self)
{
    const shd_scene *s = &self->stage->scene;
    int round;
    for (round = 0; round < 200 * self->stage->rounds; ++round) {
        shd_texture_retain(s->texture[0]);
        shd_mesh_retain(s->mesh[1]);
        shd_material_retain(s->material[0]);
        shd_context_retain(self->stage->context);
        shd_material_release(s->material[0]);
        shd_mesh_release(s->mesh[1]);
        shd_context_release(self->stage->context);
        shd_texture_release(s->texture[0]);
    }
}

/* The error text belongs to the thread. */
static void act_fail(struct actor *self)
{
    int round;
    for (round = 0; round < 50 * self->stage->rounds; ++round) {
        shd_framebuffer_desc desc = shd_framebuffer_desc_default();
        shd_framebuffer *framebuffer = NULL;
        char want[64];
        desc.width = 20000 + self->index;
        snprintf(want, sizeof want, "framebuffer.width: %u", desc.width);
        self->mistakes += shd_framebuffer_create(self->stage->context, &desc, &framebuffer) == SHD_OK;
        self->mistakes += !strstr(shd_last_error(), want);
    }
}

/* A context of the thread's own, from creation to the last release. */
static void act_own_context(struct actor *self)
{
    int round;
    for (round = 0; round < self->stage->rounds; ++round) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        desc.worker_count = 1;
        self->mistakes += shd_context_create(&desc, &context) != SHD_OK;
        self->mistakes += render(&self->stage->scene, context) != self->stage->want_frame;
        shd_context_release(context);
    }
}

static void act_render_variants(struct actor *self)
{
    int round;
    for (round = 0; round < self->stage->rounds; ++round) {
        const uint32_t variant = ((uint32_t)round + self->index) % k_variants;
        const uint64_t got = render_variant(&self->stage->scene, self->stage->context, variant);
        self->mistakes += got != self->stage->want_variant[variant];
    }
}

typedef void (*act_fn)(struct actor *self);
struct cast_case {
    const char *name;
    act_fn acts[5];
    size_t count;
    int use_pool;
    uint32_t workers, threads;
};
static const struct cast_case k_casts[] = {
    {"sample", {act_sample}, 1, 0, 1, k_threads},
    {"render/calling_thread", {act_render}, 1, 0, 1, k_threads},
    {"render/executor_of_the_host", {act_render}, 1, 1, 3, k_threads},
    {"variants/calling_thread", {act_render_variants}, 1, 0, 1, k_threads},
    {"variants/executor_of_the_host", {act_render_variants}, 1, 1, 3, k_threads},
    {"create", {act_create}, 1, 0, 1, k_threads},
    {"references", {act_references}, 1, 0, 1, k_threads},
    {"errors", {act_fail}, 1, 0, 1, k_threads},
    {"own_contexts", {act_own_context}, 1, 0, 1, k_threads},
    {"everything/calling_thread", {act_sample, act_render, act_create, act_references, act_fail}, 5, 0, 1, k_threads},
    {"everything/executor_of_the_host",
     {act_render, act_sample, act_own_context, act_create, act_references},
     5,
     1,
     2,
     k_threads},
    {"built_in/render", {act_render, act_render_variants}, 2, 0, 2, k_threads},
    {"built_in/everything", {act_render, act_sample, act_create, act_references, act_own_context}, 5, 0, 2, k_threads},
    {"64_threads/sample", {act_sample}, 1, 0, 1, 64},
    {"64_threads/sample_while_others_edit", {act_sample, act_edit}, 2, 0, 1, 64},
    {"64_threads/everything", {act_sample, act_edit, act_create, act_references, act_render}, 5, 0, 1, 64},
};

static void test_cast(void **state)
{
    const struct cast_case *c = (const struct cast_case *)*state;
    static struct stage stage;
    if (HAS_TSAN && strncmp(c->name, "built_in", 8) == 0) skip();
    open_stage(&stage, c->threads, c->use_pool, c->workers);
    play(&stage, c->acts, c->count, NULL);
    close_stage(&stage);
}

/* Each thread holds references of its own while the main thread drops everything. */
static void act_last_user(struct actor *self)
{
    const shd_scene *s = &self->stage->scene;
    self->mistakes += render(s, self->stage->context) != self->stage->want_frame;
    self->mistakes += sample(s->texture[0], s->sampler[0]) != self->stage->want_lookups;
}

static shd_scene g_dropped; /* objects that the main thread releases */

static void retain_scene(const shd_scene *s)
{
    size_t i;
    for (i = 0; i < SHD_SCENE_TEXTURES; ++i) shd_texture_retain(s->texture[i]);
    for (i = 0; i < SHD_SCENE_SAMPLERS; ++i) shd_sampler_retain(s->sampler[i]);
    for (i = 0; i < SHD_SCENE_MESHES; ++i) shd_mesh_retain(s->mesh[i]);
    for (i = 0; i < SHD_SCENE_MATERIALS; ++i) shd_material_retain(s->material[i]);
    for (i = 0; i < SHD_SCENE_LIGHTS; ++i) shd_light_retain(s->light[i]);
    shd_framebuffer_retain(s->framebuffer);
}

static void drop_everything(struct stage *stage)
{
    shd_scene_close(&g_dropped);
    shd_context_release(stage->context);
}

static void act_use_and_drop(struct actor *self)
{
    shd_scene mine = self->stage->scene;
    act_last_user(self);
    shd_scene_close(&mine); /* references of this thread */
}

static void test_context_dropped(void **state)
{
    static const act_fn k_acts[] = {act_use_and_drop};
    static struct stage stage;
    int round, i;
    (void)state;
    for (round = 0; round < (HAS_TSAN ? 6 : 25); ++round) {
        open_stage(&stage, k_threads, 0, 1);
        g_dropped = stage.scene;
        for (i = 0; i < k_threads; ++i) retain_scene(&stage.scene);
        play(&stage, k_acts, 1, drop_everything);
        shd_assert_all_freed("dropped", &stage.locked.memory);
        pthread_mutex_destroy(&stage.locked.mutex);
    }
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_casts / sizeof k_casts[0] + 1];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_casts / sizeof k_casts[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_casts[i].name, test_cast, NULL, NULL, (void *)&k_casts[i]};
    }
    tests[n++] = (struct CMUnitTest){"context_dropped", test_context_dropped, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.threads", tests, n, NULL, NULL);
}
