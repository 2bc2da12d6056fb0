/* SPDX-License-Identifier: MIT */
/* A host job system on POSIX threads with unusual task orders, for shd_executor. Every call starts its own threads:
   this is slow, but owns nothing, and any thread may call it. */
#ifndef SHD_TESTS_SUPPORT_POOL_H
#define SHD_TESTS_SUPPORT_POOL_H

#include <shd/context.h>

SHD_BEGIN_DECLS

/** The order in which tasks are started. */
typedef enum shd_pool_order { SHD_POOL_FORWARD = 0, SHD_POOL_REVERSE = 1, SHD_POOL_RANDOM = 2 } shd_pool_order;

/** Settings, constant while a context uses them. */
typedef struct shd_pool {
    uint32_t worker_count;
    shd_pool_order order;
    uint32_t seed;
} shd_pool;

shd_result shd_pool_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data);

/** Options of a context that runs on `pool`. */
shd_context_desc shd_pool_context_desc(shd_pool *pool);

SHD_END_DECLS

#endif /* SHD_TESTS_SUPPORT_POOL_H */
