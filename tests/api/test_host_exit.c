/* SPDX-License-Identifier: MIT */
/* A process that ends while other threads render and sample, in every usual way: it ends by itself, with its own
 * status, whether or not the context was released. */
#define _GNU_SOURCE
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "support/rows.h"
#include "support/scene.h"

enum { ROUNDS = 6 };

struct busy {
    shd_context *context;
    shd_scene scene;
    volatile int stop, frames;
};
static struct busy g_busy;

static void *render_forever(void *data)
{
    struct busy *busy = (struct busy *)data;
    while (!busy->stop) {
        if (shd_render(busy->context, &busy->scene.desc) != SHD_OK) _exit(99);
        busy->frames = 1;
    }
    return NULL;
}

static void leave_exit(void) { exit(41); }
static void leave_quick_exit(void) { quick_exit(41); }
static void leave_underscore_exit(void) { _exit(41); }
static void leave_after_release(void)
{
    shd_context_release(g_busy.context); /* the scene and the thread's frame still use it */
    exit(41);
}
static void release_at_exit(void)
{
    shd_context_release(g_busy.context);
    shd_texture_release(g_busy.scene.texture[0]);
}
static void leave_with_handler(void)
{
    atexit(release_at_exit);
    exit(41);
}

struct exit_case {
    const char *name;
    void (*leave)(void);
    uint32_t workers;
};
static const struct exit_case k_exits[] = {
    {"exit/one_worker", leave_exit, 1},
    {"exit/four_workers", leave_exit, 4},
    {"exit/released_before", leave_after_release, 4},
    {"exit/released_in_a_handler", leave_with_handler, 4},
    {"quick_exit/four_workers", leave_quick_exit, 4},
    {"_exit/four_workers", leave_underscore_exit, 4},
};

/* The child: starts a thread that renders, and leaves at another moment in each round. */
static void run_child(const struct exit_case *c, int round)
{
    const struct timespec moment = {0, 300000L * round};
    shd_context_desc desc = shd_context_desc_default();
    pthread_t thread;
    alarm(60); /* a hang ends by a signal */
    desc.worker_count = c->workers;
    if (shd_context_create(&desc, &g_busy.context) != SHD_OK) _exit(98);
    shd_scene_open(&g_busy.scene, SHD_SCENE_SMALL, g_busy.context);
    if (pthread_create(&thread, NULL, render_forever, &g_busy) != 0) _exit(97);
    while (!g_busy.frames) nanosleep(&(struct timespec){0, 100000}, NULL);
    nanosleep(&moment, NULL);
    c->leave();
}

static void test_exit(void **state)
{
    const struct exit_case *c = (const struct exit_case *)*state;
    int round;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    print_message("skipped: a sanitizer looks for leaks of the thread that still runs\n");
    skip();
#endif
    for (round = 0; round < ROUNDS; ++round) {
        int status = 0;
        pid_t child;
        fflush(NULL);
        child = fork();
        if (child == 0) run_child(c, round);
        assert_true(child > 0);
        assert_int_equal(waitpid(child, &status, 0), child);
        if (!WIFEXITED(status)) fail_msg("%s: signal %d", c->name, WTERMSIG(status));
        assert_int_equal(WEXITSTATUS(status), 41);
    }
    print_message("%s: %d processes ended\n", c->name, ROUNDS);
}

int main(void)
{
    ADD_ROWS(k_exits, test_exit);
    return _cmocka_run_group_tests("api.host_exit", g_tests, g_count, NULL, NULL);
}
