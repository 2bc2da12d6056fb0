/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "support/pool.h"

#include <pthread.h>
#include <stdlib.h>

#include "support/noise.h"

/** One running parallel_for. */
typedef struct shd_pool_job {
    pthread_mutex_t mutex;
    uint32_t next, count;
    const uint32_t *order;
    shd_task_fn task;
    void *task_data;
} shd_pool_job;

/** One thread of a job. */
typedef struct shd_pool_worker {
    shd_pool_job *job;
    uint32_t index;
    pthread_t thread;
    int started;
} shd_pool_worker;

static void *shd_pool_run(void *argument)
{
    shd_pool_worker *worker = (shd_pool_worker *)argument;
    shd_pool_job *job = worker->job;
    for (;;) {
        uint32_t position;
        pthread_mutex_lock(&job->mutex);
        position = job->next < job->count ? job->next++ : job->count;
        pthread_mutex_unlock(&job->mutex);
        if (position == job->count) return NULL;
        job->task(job->order[position], worker->index, job->task_data);
    }
}

static void shd_pool_shuffle(const shd_pool *pool, uint32_t count, uint32_t *order)
{
    uint32_t seed = pool->seed + count, i;
    for (i = 0; i < count; ++i) order[i] = pool->order == SHD_POOL_REVERSE ? count - 1 - i : i;
    if (pool->order != SHD_POOL_RANDOM) return;
    for (i = count; i > 1; --i) {
        uint32_t j, swapped;
        shd_noise(&seed);
        j = (uint32_t)(((uint64_t)seed * i) >> 32);
        swapped = order[i - 1];
        order[i - 1] = order[j];
        order[j] = swapped;
    }
}

shd_result shd_pool_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    const shd_pool *pool = (const shd_pool *)user_data;
    uint32_t *order = (uint32_t *)malloc(count * sizeof *order);
    shd_pool_worker *workers = (shd_pool_worker *)calloc(pool->worker_count, sizeof *workers);
    shd_pool_job job;
    uint32_t i;
    if (!order || !workers) {
        free(order);
        free(workers);
        return SHD_ERROR_OUT_OF_MEMORY;
    }
    shd_pool_shuffle(pool, count, order);
    job.next = 0;
    job.count = count;
    job.order = order;
    job.task = task;
    job.task_data = task_data;
    pthread_mutex_init(&job.mutex, NULL);
    for (i = 0; i < pool->worker_count; ++i) {
        workers[i].job = &job;
        workers[i].index = i;
        workers[i].started = pthread_create(&workers[i].thread, NULL, shd_pool_run, &workers[i]) == 0;
    }
    if (!workers[0].started) shd_pool_run(&workers[0]);
    for (i = 0; i < pool->worker_count; ++i) {
        if (workers[i].started) pthread_join(workers[i].thread, NULL);
    }
    pthread_mutex_destroy(&job.mutex);
    free(order);
    free(workers);
    return SHD_OK;
}

shd_context_desc shd_pool_context_desc(shd_pool *pool)
{
    shd_context_desc desc = shd_context_desc_default();
    desc.executor.parallel_for = shd_pool_parallel_for;
    desc.executor.user_data = pool;
    desc.executor.worker_count = pool->worker_count;
    return desc;
}
