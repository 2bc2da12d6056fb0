/* SPDX-License-Identifier: MIT */
#ifndef SHD_TESTS_SUPPORT_LOCKED_ALLOCATOR_H
#define SHD_TESTS_SUPPORT_LOCKED_ALLOCATOR_H

#include <pthread.h>

#include "support/fault_allocator.h"

/* The counting allocator behind a lock, for any number of threads. */
struct locked_memory {
    shd_fault_allocator memory;
    pthread_mutex_t mutex;
};
static inline void *locked_allocate(size_t size, size_t alignment, void *user_data)
{
    struct locked_memory *self = (struct locked_memory *)user_data;
    void *memory;
    pthread_mutex_lock(&self->mutex);
    memory = shd_fault_allocate(size, alignment, &self->memory);
    pthread_mutex_unlock(&self->mutex);
    return memory;
}
static inline void locked_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    struct locked_memory *self = (struct locked_memory *)user_data;
    pthread_mutex_lock(&self->mutex);
    shd_fault_free(memory, size, alignment, &self->memory);
    pthread_mutex_unlock(&self->mutex);
}

#endif /* SHD_TESTS_SUPPORT_LOCKED_ALLOCATOR_H */
