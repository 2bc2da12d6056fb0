/* SPDX-License-Identifier: MIT */
/* The processes of a worker, found in /proc by the path of their program: a copy in the folder of the test, so that the
 * workers of other tests are not counted. */
#ifndef SHD_TESTS_SUPPORT_IO_WORKER_H
#define SHD_TESTS_SUPPORT_IO_WORKER_H

#include "support/io_files.h"

#include <signal.h>
#include <time.h>

enum { IO_MAX_PROCESSES = 64 };

/** The worker process and its children. */
typedef struct io_worker {
    pid_t server; /**< 0 if there is none */
    pid_t children[IO_MAX_PROCESSES];
    int count;   /**< number of children, including zombies */
    int zombies; /**< among the children */
    int running; /**< processes of the program */
} io_worker;

static inline void io_sleep(double seconds)
{
    struct timespec pause = {(time_t)seconds, (long)((seconds - (double)(time_t)seconds) * 1e9)};
    nanosleep(&pause, NULL);
}

static inline double io_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** Copies the worker program to a name in the folder. */
static inline const char *io_copy_worker(const char *from, const char *name)
{
    const io_bytes bytes = io_read(from);
    const char *path = io_path(name);
    assert_non_null(bytes.data);
    io_write(path, bytes.data, bytes.size);
    free(bytes.data);
    assert_int_equal(chmod(path, 0700), 0);
    return path;
}

/** Parent and state of a process; 0 if it has ended. */
static inline pid_t io_parent(pid_t pid, char *state)
{
    char path[64], text[512];
    const char *after;
    int parent = 0;
    FILE *file;
    size_t size;
    snprintf(path, sizeof path, "/proc/%d/stat", (int)pid);
    file = fopen(path, "r");
    if (!file) return 0;
    size = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    text[size] = 0;
    after = strrchr(text, ')');
    if (!after || sscanf(after + 1, " %c %d", state, &parent) != 2) return 0;
    return parent;
}

static inline int io_runs(pid_t pid, const char *program)
{
    char path[64], target[1024];
    ssize_t size;
    snprintf(path, sizeof path, "/proc/%d/exe", (int)pid);
    size = readlink(path, target, sizeof target - 1);
    if (size < 0) return 0;
    target[size] = 0;
    return strcmp(target, program) == 0;
}

/** The worker that runs `program`. */
static inline io_worker io_find_worker(const char *program)
{
    io_worker worker = {0, {0}, 0, 0, 0};
    pid_t found[IO_MAX_PROCESSES];
    int count = 0, i, k;
    struct dirent *entry;
    char state = 0;
    DIR *folder = opendir("/proc");
    assert_non_null(folder);
    while ((entry = readdir(folder)) != NULL && count < IO_MAX_PROCESSES) {
        const pid_t pid = (pid_t)atoi(entry->d_name);
        if (pid > 0 && io_runs(pid, program)) found[count++] = pid;
    }
    worker.running = count;
    for (i = 0; i < count; ++i) {
        int is_child = 0;
        for (k = 0; k < count; ++k) is_child = is_child || io_parent(found[i], &state) == found[k];
        if (!is_child) worker.server = found[i];
    }
    rewinddir(folder);
    while (worker.server && (entry = readdir(folder)) != NULL && worker.count < IO_MAX_PROCESSES) {
        const pid_t pid = (pid_t)atoi(entry->d_name);
        if (pid <= 0 || io_parent(pid, &state) != worker.server) continue;
        worker.children[worker.count++] = pid;
        worker.zombies += state == 'Z';
    }
    closedir(folder);
    return worker;
}

/** Waits up to ten seconds until the worker has `count` children, none of them a zombie; -1: until all have ended. */
static inline io_worker io_await_worker(const char *program, int count)
{
    const double end = io_seconds() + 10;
    io_worker worker;
    do {
        worker = io_find_worker(program);
        if (count < 0 ? worker.running == 0 : worker.server && worker.count == count && worker.zombies == 0)
            return worker;
        io_sleep(0.01);
    } while (io_seconds() < end);
    fail_msg("worker %d has %d children, %d zombies; %d wanted", (int)worker.server, worker.count, worker.zombies,
             count);
    return worker;
}

/** Number of open descriptors of a process. */
static inline int io_count_descriptors(pid_t pid)
{
    char path[64];
    struct dirent *entry;
    int count = 0;
    DIR *folder;
    snprintf(path, sizeof path, "/proc/%d/fd", (int)pid);
    folder = opendir(path);
    if (!folder) return -1;
    while ((entry = readdir(folder)) != NULL) count += entry->d_name[0] != '.';
    closedir(folder);
    return count;
}

#endif /* SHD_TESTS_SUPPORT_IO_WORKER_H */
