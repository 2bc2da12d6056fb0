/* SPDX-License-Identifier: MIT */
/* Bring your own threads: shd's work runs on a pool of pthreads, and the bits equal the bits of one thread. */
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include <shd/shd.h>

enum { WORKERS = 4, SIZE = 256, COUNT = 300000 };

struct pool {
    pthread_mutex_t lock; /* guards the following fields */
    pthread_cond_t work, done;
    shd_task_fn task;
    void *task_data;
    uint32_t count, next, finished, total, stop;
};

struct thread {
    pthread_t id;
    struct pool *pool;
    uint32_t worker;
};

/* Runs tasks until none is left; must be called with the lock held, and returns with it held. */
static void run_tasks(struct pool *pool, uint32_t worker)
{
    while (pool->next < pool->count) {
        uint32_t index = pool->next++;
        pthread_mutex_unlock(&pool->lock);
        pool->task(index, worker, pool->task_data);
        pthread_mutex_lock(&pool->lock);
        pool->total += 1;
        if (++pool->finished == pool->count) pthread_cond_signal(&pool->done);
    }
}

static void *thread_main(void *argument)
{
    struct thread *self = (struct thread *)argument;
    struct pool *pool = self->pool;
    pthread_mutex_lock(&pool->lock);
    while (!pool->stop) {
        run_tasks(pool, self->worker);
        if (!pool->stop) pthread_cond_wait(&pool->work, &pool->lock);
    }
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

/* The pool runs one job after the other, because only the main thread calls shd. */
static shd_result pool_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    struct pool *pool = (struct pool *)user_data;
    pthread_mutex_lock(&pool->lock);
    pool->task = task, pool->task_data = task_data;
    pool->count = count, pool->next = pool->finished = 0;
    pthread_cond_broadcast(&pool->work);
    run_tasks(pool, 0); /* the calling thread is worker 0 */
    while (pool->finished < count) pthread_cond_wait(&pool->done, &pool->lock);
    pthread_mutex_unlock(&pool->lock);
    return SHD_OK;
}

static shd_result look_up(const shd_context_desc *desc, float *out_red)
{
    static uint8_t pixels[SIZE * SIZE];
    static float u[COUNT], v[COUNT];
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    shd_texture_desc td = shd_texture_desc_default();
    shd_lookups q = shd_lookups_default();
    shd_texels out = {0};
    shd_result result;
    size_t i;

    for (i = 0; i < sizeof pixels; ++i) pixels[i] = (uint8_t)(i * 2654435761u >> 13);
    for (i = 0; i < COUNT; ++i) u[i] = (float)i * 0.37f, v[i] = (float)i * 0.0173f;
    td.width = td.height = SIZE;
    td.format = SHD_FORMAT_R8;
    td.texels = pixels;
    q.count = COUNT;
    q.u.data = u, q.v.data = v;
    out.channel[0].data = out_red;
    result = shd_context_create(desc, &context);
    if (result == SHD_OK) result = shd_texture_create(context, &td, &texture);
    if (result == SHD_OK) result = shd_sampler_create(context, NULL, &sampler);
    if (result == SHD_OK) result = shd_texture_sample(texture, sampler, &q, &out);
    if (result != SHD_OK) fprintf(stderr, "own_threads: %s\n", shd_last_error());
    shd_sampler_release(sampler), shd_texture_release(texture), shd_context_release(context);
    return result;
}

int main(void)
{
    static float alone[COUNT], pooled[COUNT];
    static struct pool pool = {
        .lock = PTHREAD_MUTEX_INITIALIZER, .work = PTHREAD_COND_INITIALIZER, .done = PTHREAD_COND_INITIALIZER};
    struct thread threads[WORKERS];
    shd_context_desc serial = shd_context_desc_default(), host = shd_context_desc_default();
    int good;
    uint32_t i;

    for (i = 1; i < WORKERS; ++i) {
        threads[i].pool = &pool, threads[i].worker = i;
        if (pthread_create(&threads[i].id, NULL, thread_main, &threads[i])) return 1;
    }
    serial.worker_count = 1;
    host.executor.parallel_for = pool_parallel_for;
    host.executor.user_data = &pool;
    host.executor.worker_count = WORKERS;
    good = look_up(&serial, alone) == SHD_OK && look_up(&host, pooled) == SHD_OK &&
           memcmp(alone, pooled, sizeof alone) == 0 && pool.total > 0;

    pthread_mutex_lock(&pool.lock);
    pool.stop = 1;
    pthread_cond_broadcast(&pool.work);
    pthread_mutex_unlock(&pool.lock);
    for (i = 1; i < WORKERS; ++i) pthread_join(threads[i].id, NULL);
    printf("%u tasks on %d threads: %s\n", (unsigned)pool.total, WORKERS, good ? "same bits as one thread" : "WRONG");
    return good ? 0 : 1;
}
