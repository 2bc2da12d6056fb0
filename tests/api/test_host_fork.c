/* SPDX-License-Identifier: MIT */
/* fork() while other threads are inside calls: the child goes on using the context and its objects, and releases them.
 * A child that hangs is ended by its alarm, and the test fails. */
#define _GNU_SOURCE
#include <pthread.h>
#include <semaphore.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/check.h"

#include <shd/shd.h>

enum { SIDE = 64, POINTS = 3000, THREADS = 4, STORM = 40, MOST_STOPS = 4, HANDLES = 70 };

/* The objects of one thread. */
struct place {
    shd_context *context;
    shd_mesh *mesh;
    shd_texture *texture, *blocks;
    shd_sampler *sampler;
    shd_material *material;
    shd_framebuffer *framebuffer;
    shd_environment *environment;
    uint64_t want[2]; /* hashes of the lookups */
    int mistakes;
};

static unsigned char g_pixels[SIDE * SIDE * 4];
static float g_u[POINTS], g_v[POINTS];

static void make_input(void)
{
    uint32_t state = 12345;
    size_t i;
    for (i = 0; i < sizeof g_pixels; ++i) g_pixels[i] = (unsigned char)((state = state * 1664525u + 1013904223u) >> 24);
    for (i = 0; i < POINTS; ++i) {
        g_u[i] = (float)(i % 61) / 61;
        g_v[i] = (float)(i / 61) / 50;
    }
}

static shd_result make_texture(shd_context *context, shd_format format, shd_texture **out)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = format;
    desc.width = desc.height = SIDE;
    desc.texels = g_pixels;
    desc.tables = format == SHD_FORMAT_BC7 ? SHD_TABLE_NONE : SHD_TABLE_MIPMAP;
    return shd_texture_create(context, &desc, out);
}
static shd_result make_mesh(shd_context *context, shd_mesh **out)
{
    shd_shape_desc desc = shd_shape_desc_default();
    desc.kind = SHD_SHAPE_SPHERE;
    desc.segments[0] = desc.segments[1] = 12;
    return shd_mesh_create_shape(context, &desc, SHD_MESH_TANGENTS, out);
}
static shd_result make_environment(shd_context *context, shd_environment **out)
{
    shd_environment_desc desc = shd_environment_desc_default();
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8;
    image.width = 8;
    image.height = 4;
    image.pixels = g_pixels;
    desc.image = &image;
    desc.tables = SHD_ENVIRONMENT_TABLE_RADIANCE;
    return shd_environment_create(context, &desc, out);
}
static shd_result make_framebuffer(shd_context *context, shd_framebuffer **out)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = desc.height = SIDE + 1;
    return shd_framebuffer_create(context, &desc, out);
}
static shd_result make_sampler(shd_context *context, shd_sampler **out)
{
    const shd_sampler_desc desc = shd_sampler_desc_default();
    return shd_sampler_create(context, &desc, out);
}

static uint64_t look_up(const struct place *p, const shd_texture *texture)
{
    float red[POINTS];
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    lookups.count = POINTS;
    lookups.u = shd_f32_column(g_u, 0);
    lookups.v = shd_f32_column(g_v, 0);
    texels.channel[0] = shd_f32_out_column(red, 0);
    if (shd_texture_sample(texture, p->sampler, &lookups, &texels) != SHD_OK) return 0;
    return shd_hash(SHD_HASH_START, red, sizeof red);
}

/* Kinds of calls. Each returns the number of its mistakes, because assertions belong to the main thread. */
static int use_sampler(struct place *p)
{
    shd_sampler *made = NULL;
    const int bad = make_sampler(p->context, &made) != SHD_OK;
    shd_sampler_release(made);
    return bad;
}
static int use_texture(struct place *p)
{
    shd_texture *made = NULL;
    const int bad = make_texture(p->context, SHD_FORMAT_RGBA8, &made) != SHD_OK;
    shd_texture_release(made);
    return bad;
}
static int use_mesh(struct place *p)
{
    shd_mesh *made = NULL;
    const int bad = make_mesh(p->context, &made) != SHD_OK;
    shd_mesh_release(made);
    return bad;
}
static int use_lookup(struct place *p) { return look_up(p, p->texture) != p->want[0]; }
static int use_blocks(struct place *p) { return look_up(p, p->blocks) != p->want[1]; }
static int use_environment(struct place *p)
{
    shd_environment *made = NULL;
    const int bad = make_environment(p->context, &made) != SHD_OK;
    shd_environment_release(made);
    return bad;
}
static shd_draw draw_of(const struct place *p)
{
    shd_draw draw = shd_draw_default();
    draw.mesh = p->mesh;
    draw.material = p->material;
    return draw;
}
static int use_render(struct place *p)
{
    const shd_draw draw = draw_of(p);
    shd_render_desc desc = shd_render_desc_default();
    desc.framebuffer = p->framebuffer;
    desc.draws = &draw;
    desc.draw_count = 1;
    desc.environment = p->environment;
    desc.background = SHD_BACKGROUND_ENVIRONMENT;
    return shd_render(p->context, &desc) != SHD_OK;
}
static int use_bake(struct place *p)
{
    const shd_draw draw = draw_of(p);
    const shd_bake_desc bake = shd_bake_desc_default();
    shd_render_desc desc = shd_render_desc_default();
    desc.framebuffer = p->framebuffer;
    desc.draws = &draw;
    desc.draw_count = 1;
    return shd_bake(p->context, &desc, &bake) != SHD_OK;
}
static int use_occlusion(struct place *p)
{
    static const float k_zero[1], k_one[1] = {1};
    const shd_draw draw = draw_of(p);
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_points points = shd_occlusion_points_default();
    float open[1] = {-1};
    shd_occlusion_values out = {sizeof out, shd_f32_out_column(open, 0), 0};
    int c;
    desc.ray_count = 4;
    desc.map_size = 32;
    desc.draws = &draw;
    desc.draw_count = 1;
    points.count = 1;
    for (c = 0; c < 3; ++c) points.position[c] = points.normal[c] = shd_f32_column(c ? k_zero : k_one, 0);
    return shd_occlusion_compute(p->context, &desc, &points, &out) != SHD_OK;
}
static int use_context(struct place *p)
{
    struct place own = *p;
    int bad;
    if (shd_context_create(NULL, &own.context) != SHD_OK) return 1;
    bad = use_texture(&own) + use_lookup(&own);
    shd_context_release(own.context);
    return bad;
}
static int use_trim(struct place *p)
{
    shd_context_trim(p->context);
    return 0;
}

typedef int (*use_fn)(struct place *p);
static const struct kind {
    const char *name;
    use_fn use;
} k_kinds[] = {
    {"sampler", use_sampler},         {"texture", use_texture}, {"mesh", use_mesh},
    {"lookup", use_lookup},           {"blocks", use_blocks},   {"render", use_render},
    {"environment", use_environment}, {"bake", use_bake},       {"occlusion", use_occlusion},
    {"context", use_context},         {"trim", use_trim},
};
enum { KINDS = sizeof k_kinds / sizeof k_kinds[0] };

static void open_place(struct place *p, shd_context *context)
{
    shd_material_desc material = shd_material_desc_default();
    memset(p, 0, sizeof *p);
    p->context = context;
    shd_assert_ok(make_mesh(context, &p->mesh));
    shd_assert_ok(make_texture(context, SHD_FORMAT_RGBA8, &p->texture));
    shd_assert_ok(make_texture(context, SHD_FORMAT_BC7, &p->blocks));
    shd_assert_ok(make_sampler(context, &p->sampler));
    shd_assert_ok(make_framebuffer(context, &p->framebuffer));
    shd_assert_ok(make_environment(context, &p->environment));
    material.model = SHD_MODEL_LAMBERT;
    shd_assert_ok(shd_material_create(context, &material, &p->material));
    p->want[0] = look_up(p, p->texture);
    p->want[1] = look_up(p, p->blocks);
    assert_true(p->want[0] != 0 && p->want[1] != 0);
}

static void close_place(struct place *p)
{
    shd_mesh_release(p->mesh);
    shd_texture_release(p->texture);
    shd_texture_release(p->blocks);
    shd_sampler_release(p->sampler);
    shd_framebuffer_release(p->framebuffer);
    shd_environment_release(p->environment);
    shd_material_release(p->material);
}

/* An allocator that stops one call at one of its allocations, until the main thread has forked. */
static struct stop {
    pthread_mutex_t mutex;
    size_t calls, at;      /* the number of the allocation; 0 = none */
    size_t at_size;        /* the first allocation that is as large; 0 = none */
    int is_stopped, forks; /* forks: the allocation itself forks */
    sem_t reached, go_on;
} g_stop = {.mutex = PTHREAD_MUTEX_INITIALIZER};

/* Forks. The child makes calls of every kind, releases its objects, and ends. Returns 0 if the child did. */
static int fork_and_use(struct place *p, const char *during)
{
    int status = 0;
    pid_t child;
    fflush(NULL);
    pthread_mutex_lock(&g_stop.mutex);
    g_stop.at = g_stop.at_size = 0; /* a call that ended before its stop must not leave it to the child */
    child = fork();
    pthread_mutex_unlock(&g_stop.mutex);
    if (child == 0) {
        size_t k;
        alarm(60); /* a hang ends by signal */
        for (k = 0; k < KINDS; ++k) {
            if (k_kinds[k].use(p)) _exit((int)k + 1);
        }
        close_place(p);
        shd_context_release(p->context);
        _exit(0);
    }
    if (child < 0 || waitpid(child, &status, 0) != child) return 1;
    if (status == 0) return 0;
    if (WIFSIGNALED(status)) print_error("fork during %s: the child ended by signal %d\n", during, WTERMSIG(status));
    if (WIFEXITED(status))
        print_error("fork during %s: %s failed in the child\n", during, k_kinds[WEXITSTATUS(status) - 1].name);
    return 1;
}

static void reach(void)
{
    if (g_stop.forks) {
        const pid_t child = fork();
        int status = 1;
        if (child == 0) _exit(0);
        g_stop.is_stopped = child > 0 && waitpid(child, &status, 0) == child && status == 0;
        return;
    }
    sem_post(&g_stop.reached);
    sem_wait(&g_stop.go_on);
}

static void *stop_allocate(size_t size, size_t alignment, void *user_data)
{
    void *memory = NULL;
    int stops;
    (void)user_data;
    pthread_mutex_lock(&g_stop.mutex);
    stops = ++g_stop.calls == g_stop.at || (g_stop.at_size && size >= g_stop.at_size);
    if (stops) g_stop.at = g_stop.at_size = 0;
    g_stop.is_stopped += stops;
    pthread_mutex_unlock(&g_stop.mutex);
    if (stops) reach();
    return posix_memalign(&memory, alignment, size) == 0 ? memory : NULL;
}
static void stop_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    (void)user_data, (void)size, (void)alignment;
    free(memory);
}

static void stop_at(size_t at, size_t at_size, int forks)
{
    g_stop.calls = 0;
    g_stop.at = at;
    g_stop.at_size = at_size;
    g_stop.forks = forks;
    g_stop.is_stopped = 0;
    sem_init(&g_stop.reached, 0, 0);
    sem_init(&g_stop.go_on, 0, 0);
}

static shd_context *stopping_context(void)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    desc.allocator.allocate = stop_allocate;
    desc.allocator.free = stop_free;
    desc.worker_count = 2;
    stop_at(0, 0, 0);
    shd_assert_ok(shd_context_create(&desc, &context));
    return context;
}

struct call {
    struct place *place;
    use_fn use;
};

static void *run_call(void *argument)
{
    struct call *call = (struct call *)argument;
    call->place->mistakes += call->use(call->place);
    sem_post(&g_stop.reached); /* the call may end before it is stopped */
    return NULL;
}

/* Makes a call on another thread, and forks as soon as the call has stopped or ended. Returns whether it stopped. */
static int fork_during(const char *name, use_fn use, struct place *stopped, struct place *own)
{
    struct call call = {stopped, use};
    pthread_t thread;
    int was_stopped;
    assert_int_equal(pthread_create(&thread, NULL, run_call, &call), 0);
    sem_wait(&g_stop.reached);
    was_stopped = g_stop.is_stopped;
    own->mistakes += fork_and_use(own, name);
    sem_post(&g_stop.go_on);
    pthread_join(thread, NULL);
    assert_int_equal(own->mistakes + stopped->mistakes, 0);
    return was_stopped;
}

/* Forks while a call of each kind waits for memory, at several of its allocations. */
static void test_allocations(void **state)
{
    const struct kind *kind = (const struct kind *)*state;
    struct place stopped, own;
    size_t count, step, at;
    open_place(&stopped, stopping_context());
    open_place(&own, stopped.context);
    shd_context_trim(own.context);
    stop_at(0, 0, 0);
    stopped.mistakes += kind->use(&stopped);
    count = g_stop.calls;
    step = count / MOST_STOPS + 1;
    for (at = 1; at <= count; at += step) {
        shd_context_trim(own.context);
        stop_at(at, 0, 0);
        (void)fork_during(kind->name, kind->use, &stopped, &own);
    }
    for (at = 1; at <= count; at += step) { /* the thread that allocates forks */
        shd_context_trim(own.context);
        stop_at(at, 0, 1);
        own.mistakes += kind->use(&own);
    }
    close_place(&stopped);
    close_place(&own);
    assert_int_equal(own.mistakes, 0);
    shd_context_release(own.context);
}

static int use_many_handles(struct place *p)
{
    shd_sampler *made[HANDLES] = {NULL};
    int bad = 0, i;
    for (i = 0; i < HANDLES; ++i) bad += make_sampler(p->context, &made[i]) != SHD_OK;
    for (i = 0; i < HANDLES; ++i) shd_sampler_release(made[i]);
    return bad;
}

/* Forks while a call waits for the memory of more handles. */
static void test_handles(void **state)
{
    struct place stopped, own;
    (void)state;
    open_place(&stopped, stopping_context());
    open_place(&own, stopped.context);
    stop_at(0, 2048, 0); /* a sampler is smaller, a slab of handles larger */
    assert_true(fork_during("handles", use_many_handles, &stopped, &own));
    close_place(&stopped);
    close_place(&own);
    shd_context_release(own.context);
}

/* A program that stops the frame, or forks in it. */
static struct place *g_own;
static int g_programs;
static void program(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const int forks = *(const int *)user_data;
    (void)in, (void)out;
    if (__atomic_fetch_add(&g_programs, 1, __ATOMIC_RELAXED) != 0) return;
    g_stop.is_stopped = 1;
    if (forks) {
        g_own->mistakes += fork_and_use(g_own, "a program");
    } else {
        reach();
    }
}

static void test_program(void **state)
{
    int forks;
    (void)state;
    for (forks = 0; forks < 2; ++forks) {
        shd_material_desc material = shd_material_desc_default();
        struct place stopped, own;
        open_place(&stopped, stopping_context());
        open_place(&own, stopped.context);
        shd_material_release(stopped.material);
        material.model = SHD_MODEL_PROGRAM;
        material.program.fragment = program;
        material.program.user_data = &forks;
        shd_assert_ok(shd_material_create(stopped.context, &material, &stopped.material));
        g_own = &own;
        g_programs = 0;
        stop_at(0, 0, 0);
        if (forks) {
            stopped.mistakes += use_render(&stopped);
        } else {
            assert_true(fork_during("a program", use_render, &stopped, &own));
        }
        assert_true(g_programs > 0);
        close_place(&stopped);
        close_place(&own);
        assert_int_equal(own.mistakes + stopped.mistakes, 0);
        shd_context_release(own.context);
    }
}

static int g_end;
static void *make_all_calls(void *argument)
{
    struct place *p = (struct place *)argument;
    while (!__atomic_load_n(&g_end, __ATOMIC_RELAXED)) {
        size_t k;
        for (k = 0; k < KINDS; ++k) p->mistakes += k_kinds[k].use(p);
    }
    return NULL;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif

/* Forks while four threads make calls of all kinds in one context. Not under sanitizers: a fork leaves locks of their
 * own allocators locked in the child. */
static void test_storm(void **state)
{
    struct place places[THREADS + 1];
    pthread_t threads[THREADS];
    shd_context *context = NULL;
    int i, bad = 0;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (i = 0; i <= THREADS; ++i) open_place(&places[i], context);
    g_end = 0;
    for (i = 0; i < THREADS; ++i) {
        assert_int_equal(pthread_create(&threads[i], NULL, make_all_calls, &places[i]), 0);
    }
    for (i = 0; i < STORM; ++i) bad += fork_and_use(&places[THREADS], "calls of all kinds");
    __atomic_store_n(&g_end, 1, __ATOMIC_RELAXED);
    for (i = 0; i < THREADS; ++i) pthread_join(threads[i], NULL);
    for (i = 0; i <= THREADS; ++i) {
        bad += places[i].mistakes;
        close_place(&places[i]);
    }
    shd_context_release(context);
    assert_int_equal(bad, 0);
}

int main(void)
{
    struct CMUnitTest tests[KINDS + 3];
    char names[KINDS][32];
    size_t n = 0, k;
    make_input();
    for (k = 0; k < KINDS; ++k) {
        snprintf(names[k], sizeof names[k], "during/%s", k_kinds[k].name);
        tests[n++] = (struct CMUnitTest){names[k], test_allocations, NULL, NULL, (void *)&k_kinds[k]};
    }
    tests[n++] = (struct CMUnitTest){"during/handles", test_handles, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"during/program", test_program, NULL, NULL, NULL};
    if (!SANITIZED) tests[n++] = (struct CMUnitTest){"during/storm", test_storm, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.host_fork", tests, n, NULL, NULL);
}
