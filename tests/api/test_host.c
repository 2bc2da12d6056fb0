/* SPDX-License-Identifier: MIT */
/* The host's process is not disturbed: floating-point control, errno, locale, signals, directory and output stay
 * unchanged. shd works after fork, on small stacks, and where no thread can be started. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/control.h"

#include <shd/extension.h>
#include <shd/shd.h>

/* State of the host while it calls shd, checked after every call. */
static struct host {
    unsigned mxcsr;
    sigset_t signals;
    char directory[4096], locale[256];
    size_t calls;
} g_host;

static __attribute__((noinline)) void host_enter(void)
{
    errno = 1234;
    shd_write_control(g_host.mxcsr);
}

static __attribute__((noinline)) void host_left(void)
{
    const int found_errno = errno;
    const unsigned mxcsr = shd_read_control();
    sigset_t signals;
    char directory[4096];
    int s;
    shd_write_control(0x1f80);
    if (mxcsr != g_host.mxcsr && SHD_HAS_MXCSR) fail_msg("MXCSR 0x%x became 0x%x", g_host.mxcsr, mxcsr);
    assert_int_equal(found_errno, 1234);
    sigemptyset(&signals);
    pthread_sigmask(SIG_SETMASK, NULL, &signals);
    for (s = 1; s < 32; ++s) assert_int_equal(sigismember(&signals, s), sigismember(&g_host.signals, s));
    assert_string_equal(getcwd(directory, sizeof directory), g_host.directory);
    assert_string_equal(setlocale(LC_ALL, NULL), g_host.locale);
    ++g_host.calls;
}

static shd_result host_leave(shd_result result)
{
    host_left();
    return result;
}

/* All calls of shd below come from this host. */
#define CHECKED(call) (host_enter(), host_leave(call))
#define CHECKED_VOID(call) (host_enter(), call, host_left())
#define shd_context_create(d, o) CHECKED(shd_context_create(d, o))
#define shd_texture_create(c, d, o) CHECKED(shd_texture_create(c, d, o))
#define shd_sampler_create(c, d, o) CHECKED(shd_sampler_create(c, d, o))
#define shd_mesh_create(c, d, o) CHECKED(shd_mesh_create(c, d, o))
#define shd_material_create(c, d, o) CHECKED(shd_material_create(c, d, o))
#define shd_light_create(c, d, o) CHECKED(shd_light_create(c, d, o))
#define shd_framebuffer_create(c, d, o) CHECKED(shd_framebuffer_create(c, d, o))
#define shd_view_from_camera(c, o) CHECKED(shd_view_from_camera(c, o))
#define shd_render(c, d) CHECKED(shd_render(c, d))
#define shd_texture_sample(t, s, q, o) CHECKED(shd_texture_sample(t, s, q, o))
#define shd_texture_get_info(t, o) CHECKED(shd_texture_get_info(t, o))
#define shd_mesh_get_info(m, o) CHECKED(shd_mesh_get_info(m, o))
#define shd_framebuffer_get_info(f, o) CHECKED(shd_framebuffer_get_info(f, o))
#define shd_framebuffer_view_plane(f, p, o) CHECKED(shd_framebuffer_view_plane(f, p, o))
#define shd_framebuffer_read_color(f, o) CHECKED(shd_framebuffer_read_color(f, o))
#define shd_context_parallel_for(c, n, t, d) CHECKED(shd_context_parallel_for(c, n, t, d))
#define shd_desc_init(k, p, n) CHECKED(shd_desc_init(k, p, n))
#define shd_context_release(x) CHECKED_VOID(shd_context_release(x))
#define shd_texture_release(x) CHECKED_VOID(shd_texture_release(x))
#define shd_sampler_release(x) CHECKED_VOID(shd_sampler_release(x))
#define shd_mesh_release(x) CHECKED_VOID(shd_mesh_release(x))
#define shd_material_release(x) CHECKED_VOID(shd_material_release(x))
#define shd_light_release(x) CHECKED_VOID(shd_light_release(x))
#define shd_framebuffer_release(x) CHECKED_VOID(shd_framebuffer_release(x))
#include "support/scene.h"

static void set_host(unsigned mxcsr)
{
    g_host.mxcsr = mxcsr;
    sigemptyset(&g_host.signals);
    pthread_sigmask(SIG_SETMASK, NULL, &g_host.signals);
    assert_non_null(getcwd(g_host.directory, sizeof g_host.directory));
    snprintf(g_host.locale, sizeof g_host.locale, "%s", setlocale(LC_ALL, NULL));
}

/* Tasks and programs run with the IEEE defaults, even if the host changed floating-point control. */
static void check_control(size_t index, size_t worker, void *data)
{
    (void)index;
    (void)worker;
    if (SHD_HAS_MXCSR && (shd_read_control() & ~0x3fu) != 0x1f80) __atomic_fetch_add((int *)data, 1, __ATOMIC_RELAXED);
}

/* Builds, renders, looks up, reads back and provokes errors with `workers` threads. */
static uint64_t visit(uint32_t workers)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_image image = shd_image_default();
    shd_context *context = NULL;
    static float columns[3][40000];
    static unsigned char pixels[4 * 203 * 151];
    shd_texels texels;
    shd_scene s;
    uint64_t hash;
    int wrong = 0;
    size_t i;
    desc.worker_count = workers;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&s, SHD_SCENE_MIXED, context);
    hash = shd_scene_render(&s);
    for (i = 0; i < 40000; ++i) {
        columns[0][i] = 0.0001f * (float)i;
        columns[1][i] = i % 100 ? 1e-41f * (float)i : NAN;
    }
    memset(&texels, 0, sizeof texels);
    lookups.count = 40000;
    lookups.u.data = columns[0];
    lookups.v.data = columns[1];
    lookups.dudx.data = columns[1];
    texels.channel[0].data = columns[2];
    shd_assert_ok(shd_texture_sample(s.texture[0], s.sampler[0], &lookups, &texels));
    hash = shd_hash(hash, columns[2], sizeof columns[2]);
    image.width = 203;
    image.height = 151;
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.pixels = pixels;
    shd_assert_ok(shd_framebuffer_read_color(s.framebuffer, &image));
    hash = shd_hash(hash, pixels, sizeof pixels);
    shd_assert_ok(shd_context_parallel_for(context, 64, check_control, &wrong));
    assert_int_equal(wrong, 0);
    s.desc.clear_depth = 1.5f;
    shd_assert_result("render", shd_render(context, &s.desc), SHD_ERROR_INVALID_ARGUMENT, "1.5");
    image.width = 1;
    shd_assert_result("read", shd_framebuffer_read_color(s.framebuffer, &image), SHD_ERROR_INVALID_ARGUMENT, "width");
    shd_assert_result("init", shd_desc_init(SHD_DESC_KIND_NONE, &desc, 8), SHD_ERROR_INVALID_ARGUMENT, "kind");
    shd_scene_close(&s);
    shd_context_release(context);
    return hash;
}

/* Result of a child process. */
static int wait_for(pid_t child)
{
    int status = 0;
    assert_true(child > 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    if (!WIFEXITED(status)) fail_msg("child ended by signal %d", WTERMSIG(status));
    return WEXITSTATUS(status);
}

/* Starts this program again with one argument; its output goes to `output` unless that is negative. */
static int run_self(const char *argument, int output)
{
    pid_t child;
    fflush(NULL);
    child = fork();
    if (child == 0) {
        if (output >= 0) {
            dup2(output, 1);
            dup2(output, 2);
        }
        execl("/proc/self/exe", "test_api_host", argument, (char *)NULL);
        _exit(78);
    }
    return wait_for(child);
}

/* A library below may print only once per process, so this test has its own process. */
static int run_visits(void)
{
    static const uint32_t k_counts[] = {0, 1, 2, 64};
    size_t i;
    set_host(0x1f80);
    for (i = 0; i < sizeof k_counts / sizeof k_counts[0]; ++i) (void)visit(k_counts[i]);
    return 0;
}

static void test_silent(void **state)
{
    char path[] = "/tmp/shd_test_host_XXXXXX", text[1000] = "";
    const int file = mkstemp(path);
    int answer;
    (void)state;
    assert_true(file >= 0);
    unlink(path);
    answer = run_self("--visits", file);
    (void)!pread(file, text, sizeof text - 1, 0);
    close(file);
    assert_string_equal(text, "");
    assert_int_equal(answer, 0);
}

static void test_control(void **state)
{
    const struct control_case *c = (const struct control_case *)*state;
    uint64_t want;
    set_host(0x1f80);
    want = visit(1);
    set_host(c->mxcsr);
    g_host.calls = 0;
    assert_true(visit(1) == want);
    assert_true(visit(2) == want);
    print_message("%s: %zu calls, 0 changes\n", c->name, g_host.calls);
    set_host(0x1f80);
}

static void test_out_of_memory_errno(void **state)
{
    /* A texture of 4 GiB under a limit of address space: malloc fails and sets errno. */
    struct rlimit old, tight;
    shd_context *context = NULL;
    shd_framebuffer *framebuffer = NULL;
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_result result;
    (void)state;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    print_message("skipped: a sanitizer needs the address space\n");
    skip();
#endif
    set_host(0x1f80);
    shd_assert_ok(shd_context_create(NULL, &context));
    assert_int_equal(getrlimit(RLIMIT_AS, &old), 0);
    tight = old;
    tight.rlim_cur = (rlim_t)1 << 30;
    desc.width = desc.height = 16384;
    assert_int_equal(setrlimit(RLIMIT_AS, &tight), 0);
    result = shd_framebuffer_create(context, &desc, &framebuffer);
    setrlimit(RLIMIT_AS, &old);
    shd_assert_result("framebuffer", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
    assert_null(framebuffer);
    shd_context_release(context);
}

static void test_fork(void **state)
{
    shd_context *context = NULL;
    shd_context_desc desc = shd_context_desc_default();
    shd_scene s;
    uint64_t want;
    int round;
    (void)state;
    set_host(0x1f80);
    desc.worker_count = 2;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    want = shd_scene_render(&s);
    for (round = 0; round < 10; ++round) {
        pid_t child;
        fflush(NULL);
        child = fork();
        if (child == 0) {
            alarm(20); /* a hang ends by signal */
            if (shd_scene_render(&s) != want) _exit(1);
            if (shd_scene_reference(SHD_SCENE_SMALL) != want) _exit(2);
            shd_scene_close(&s);
            shd_context_release(context);
            _exit(0);
        }
        assert_int_equal(wait_for(child), 0);
        assert_true(shd_scene_render(&s) == want);
    }
    shd_scene_close(&s);
    shd_context_release(context);
}

static void *idle(void *argument) { return argument; }

/* Starts this program again, where no thread can be started. */
static int run_without_threads(void)
{
    const struct rlimit none = {0, 0};
    pthread_t thread;
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    shd_scene s;
    uint64_t want, got[2];
    alarm(60);
    if (getuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) return 77;
    if (setrlimit(RLIMIT_NPROC, &none) != 0) return 77;
    if (pthread_create(&thread, NULL, idle, NULL) == 0) return 77;
    set_host(0x1f80);
    want = shd_scene_reference(SHD_SCENE_SMALL);
    desc.worker_count = 2;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    got[0] = shd_scene_render(&s);
    got[1] = shd_scene_render(&s);
    shd_scene_close(&s);
    shd_context_release(context);
    return got[0] == want && got[1] == want ? 0 : 1;
}

static void test_no_threads(void **state)
{
    const int answer = run_self("--no-threads", -1);
    (void)state;
    if (answer == 77) {
        print_message("skipped: this process cannot limit its number of threads\n");
        skip();
    }
    assert_int_equal(answer, 0);
}

/* Measures the used depth of the stack, which is filled with a pattern first. */
struct deep {
    void (*run)(struct deep *self);
    shd_context *context;
    shd_scene *scene;
    const shd_sampler *sampler;
    const shd_lookups *lookups;
    shd_texels *texels;
    shd_result result;
};
static void *run_deep(void *argument)
{
    struct deep *self = (struct deep *)argument;
    self->run(self);
    return NULL;
}
#undef shd_render
#undef shd_texture_sample
static void deep_nothing(struct deep *self) { self->result = SHD_OK; }
static void deep_render(struct deep *self) { self->result = shd_render(self->context, &self->scene->desc); }
static void deep_sample(struct deep *self)
{
    self->result = shd_texture_sample(self->scene->texture[0], self->sampler, self->lookups, self->texels);
}

static size_t stack_used(struct deep *self, size_t size)
{
    unsigned char *stack =
        (unsigned char *)mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    pthread_attr_t attributes;
    pthread_t thread;
    size_t untouched = 0;
    assert_true(stack != MAP_FAILED);
    memset(stack, 0xa5, size);
    pthread_attr_init(&attributes);
    assert_int_equal(pthread_attr_setstack(&attributes, stack, size), 0);
    self->result = SHD_ERROR_INTERNAL;
    assert_int_equal(pthread_create(&thread, &attributes, run_deep, self), 0);
    pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
    shd_assert_ok(self->result);
    while (untouched < size && stack[untouched] == 0xa5) ++untouched;
    munmap(stack, size);
    return size - untouched;
}

static void test_small_stack(void **state)
{
    static float columns[2][10000];
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
    const size_t size = 512 * 1024; /* unoptimised frames and red zones */
#else
    const size_t size = 64 * 1024;
#endif
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels;
    shd_context_desc desc = shd_context_desc_default();
    shd_sampler_desc drawn = shd_sampler_desc_default();
    struct deep deep;
    shd_scene s;
    size_t base, render, sample, draw, i;
    int simd;
    (void)state;
#if defined(__SANITIZE_THREAD__)
    print_message("skipped: the sanitizer uses its own stacks\n");
    skip();
#endif
    set_host(0x1f80);
    memset(&texels, 0, sizeof texels);
    lookups.count = 5000;
    lookups.u.data = lookups.v.data = lookups.dudx.data = columns[0];
    lookups.u.stride = lookups.v.stride = lookups.dudx.stride = 8; /* copied through the stack */
    texels.channel[0].data = columns[1];
    for (i = 0; i < 5000; ++i) columns[0][2 * i] = (float)(i % 3) / 50.0f; /* some are magnified */
    lookups.dvdy = lookups.dudx;
    drawn.filter = SHD_FILTER_STOCHASTIC;
    drawn.stochastic_filter = SHD_FILTER_EWA;
    drawn.magnification = SHD_MAGNIFICATION_BICUBIC;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_AVX512; ++simd) {
        shd_context *context = NULL;
        shd_sampler *sampler = NULL;
        desc.worker_count = 1;
        desc.simd = (shd_simd)simd;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        shd_scene_open(&s, SHD_SCENE_MIXED, context);
        deep.context = context;
        deep.scene = &s;
        deep.sampler = s.sampler[0];
        deep.lookups = &lookups;
        deep.texels = &texels;
        deep.run = deep_nothing;
        base = stack_used(&deep, size);
        deep.run = deep_render;
        render = stack_used(&deep, size);
        deep.run = deep_sample;
        sample = stack_used(&deep, size);
        shd_assert_ok(shd_sampler_create(context, &drawn, &sampler));
        deep.sampler = sampler;
        draw = stack_used(&deep, size);
        print_message("%s: shd_render %zu, shd_texture_sample %zu and %zu, of a thread %zu bytes of stack\n",
                      shd_context_get_simd_target(context), render - base, sample - base, draw - base, base);
        shd_sampler_release(sampler);
        shd_scene_close(&s);
        shd_context_release(context);
    }
}

int main(int argc, char **argv)
{
    static struct CMUnitTest tests[8 + sizeof k_controls / sizeof k_controls[0]];
    size_t n = 0, i;
    if (argc > 1 && strcmp(argv[1], "--visits") == 0) return run_visits();
    /* _exit, because a leak checker would start a thread at exit. */
    if (argc > 1 && strcmp(argv[1], "--no-threads") == 0) _exit(run_without_threads());
    tests[n++] = (struct CMUnitTest){"silent", test_silent, NULL, NULL, NULL};
    for (i = 0; i < sizeof k_controls / sizeof k_controls[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_controls[i].name, test_control, NULL, NULL, (void *)&k_controls[i]};
    }
    tests[n++] = (struct CMUnitTest){"out_of_memory", test_out_of_memory_errno, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"fork", test_fork, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"no_threads", test_no_threads, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"small_stack", test_small_stack, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.host", tests, n, NULL, NULL);
}
